//! `$copy`: copies a file or a folder.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Copies a file or a folder.
    ///
    /// - `sFrom`, `sTo`: the source and the destination.
    /// - Result: `true` if it was copied.
    ///
    /// ## Example
    /// ```val3
    ///   if $copy("Disk://data/log.txt","USB0://log.txt")==false
    ///     logMsg("log not copied")
    ///   endIf
    /// ```
    "$copy": AddOns, with_add_on "Expansion";
    modifier (string sFrom, string sTo) -> bool = copy;
}

fn copy(call: &mut Call<'_>, source: Text, target: Text) -> bool {
    let from = call.tasks.path(None);
    call.ports.copy_file(&from, &source, &target)
}
