load style

# FILL IN: more figures, drawn from what the study writes. about.json lists them all.
