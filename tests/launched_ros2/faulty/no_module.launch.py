import lost_module

lost_module.use()
