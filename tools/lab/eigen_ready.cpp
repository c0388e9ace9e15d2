// Nothing: the target timestep_eigen_ready is there for the headers that it compiles beforehand.
