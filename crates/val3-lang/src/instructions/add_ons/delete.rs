//! `$delete`: deletes a file or a folder.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Deletes a file or a folder.
    ///
    /// - `sPath`: the path.
    /// - Result: `true` if it was deleted.
    ///
    /// ## Example
    /// ```val3
    ///   $delete("Disk://data/log.txt")
    /// ```
    "$delete": AddOns, with_add_on "Expansion";
    modifier (string sPath) -> bool = delete;
}

fn delete(call: &mut Call<'_>, path: Text) -> bool {
    let from = call.tasks.path(None);
    call.ports.delete_file(&from, &path)
}
