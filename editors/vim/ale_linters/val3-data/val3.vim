call val3#DefineLinter('val3-data')
