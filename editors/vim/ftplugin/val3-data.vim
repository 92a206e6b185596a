setlocal shiftwidth=2 expandtab nofixendofline
let b:undo_ftplugin = 'setlocal shiftwidth< expandtab< fixendofline<'
