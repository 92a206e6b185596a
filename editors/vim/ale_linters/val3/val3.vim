call val3#DefineLinter('val3')
