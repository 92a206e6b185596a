autocmd BufRead,BufNewFile *.pgx,*.PGX setlocal filetype=val3
autocmd BufRead,BufNewFile *.dtx,*.DTX setlocal filetype=val3-data
autocmd BufRead,BufNewFile *.pjx,*.PJX setlocal filetype=val3-project
