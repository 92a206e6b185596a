//! `$fileOpen`: opens a file.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Opens a file.
    ///
    /// - `sPath`: the path, for example `"Disk://data/log.txt"`.
    /// - `sMode`: `"r"` to read, `"w"` to write, `"a"` to append.
    /// - Result: the file number for the other file instructions; negative if the file cannot be opened.
    ///
    /// Up to ten files are open at a time, and none is closed automatically: end with `$fileClose`.
    ///
    /// ## Example
    /// ```val3
    /// num nFile
    /// string sLine[1]
    ///   nFile=$fileOpen("Disk://data/order.txt","r")
    ///   if nFile>=0
    ///     $fileGet(nFile,sLine,1)
    ///     $fileClose(nFile)
    ///   endIf
    /// ```
    "$fileOpen": AddOns, with_add_on "Expansion";
    function (string sPath, string sMode) -> num = open;
}

/// Returns -1 if the file cannot be opened; open files have numbers from 0.
fn open(call: &mut Call<'_>, path: Text, mode: Text) -> f64 {
    let from = call.tasks.path(None);
    call.ports.open_file(&from, &path, &mode).map_or(-1.0, f64::from)
}
