autocmd BufRead,BufNewFile *.pgx,*.PGX setfiletype val3
autocmd BufRead,BufNewFile *.dtx,*.DTX setlocal filetype=val3-data
autocmd BufRead,BufNewFile *.pjx,*.PJX setfiletype val3-project
