"""The parameter by which a node offers to describe its types, a service that is only named here."""

__all__ = ["START_TYPE_DESCRIPTION_SERVICE_PARAM"]

START_TYPE_DESCRIPTION_SERVICE_PARAM = "start_type_description_service"
