from distributed import Client


def workers():
    return Client().get_executor()
