// velocity_now does_not_compile: The file has no function
