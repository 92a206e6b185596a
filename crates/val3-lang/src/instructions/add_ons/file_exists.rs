//! `$fileExists`: returns whether a file exists.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Returns whether a file exists.
    ///
    /// - `sPath`: the path.
    /// - Result: `true` if the file exists.
    ///
    /// ## Example
    /// ```val3
    ///   if $fileExists("Disk://data/order.txt")==false
    ///     popUpMsg("No order")
    ///   endIf
    /// ```
    "$fileExists": AddOns, with_add_on "Expansion";
    function (string sPath) -> bool = exists;
}

fn exists(call: &mut Call<'_>, path: Text) -> bool {
    let from = call.tasks.path(None);
    call.ports.file_exists(&from, &path)
}
