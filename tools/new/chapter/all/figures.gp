load style

# FILL IN: figures drawn from what the study writes. about.json then lists all "figures".
