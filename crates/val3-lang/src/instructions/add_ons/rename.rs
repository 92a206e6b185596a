//! `$rename`: moves or renames a file or a folder.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Moves or renames a file or a folder.
    ///
    /// - `sFrom`, `sTo`: its old and its new path.
    /// - Result: `true` if it was moved.
    ///
    /// ## Example
    /// ```val3
    ///   if $rename("Disk://data/log.txt","Disk://data/old.txt")==false
    ///     logMsg("log not renamed")
    ///   endIf
    /// ```
    "$rename": AddOns, with_add_on "Expansion";
    modifier (string sFrom, string sTo) -> bool = rename;
}

fn rename(call: &mut Call<'_>, old: Text, new: Text) -> bool {
    let from = call.tasks.path(None);
    call.ports.rename_file(&from, &old, &new)
}
