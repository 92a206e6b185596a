//! `libList` (6.7): lists the content of a folder.

use crate::call::{Arr, Call, Flow};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::Text;

instruction! {
    /// Lists the content of a folder.
    ///
    /// - `sPath`: the folder (`libLoad` describes paths).
    /// - `sContents`: receives the names. All values are cleared first, so the first `""` marks the end. A global array
    ///   grows as needed.
    /// - Result: `false` if the array is too small for the whole list.
    ///
    /// ## Example
    /// ```val3
    /// string sNames[1]
    /// num nIndex
    ///   libList("Disk://parts",sNames)
    ///   for nIndex=0 to size(sNames)-1
    ///     putln(sNames[nIndex])
    ///   endFor
    /// ```
    "libList": Libraries "6.7", blocking;
    modifier (string sPath, string& sContents[]) -> bool = list;
}

/// Returns `false` with an empty list if the folder cannot be read: library instructions raise no errors (6.6).
fn list(call: &mut Call<'_>, path: Text, contents: Arr<Text>) -> Result<Flow<bool>> {
    if call.is_first() {
        return Ok(call.sleep(0));
    }
    for index in 0..contents.len(call)? {
        contents.set(call, index, Text::new())?;
    }
    let from = call.tasks.path(None);
    let Some(names) = call.ports.list(&from, &path) else { return Ok(Flow::Done(false)) };
    grow(call, &contents, names.len());
    let room = contents.len(call)?;
    for (index, name) in names.iter().enumerate().take(room) {
        contents.set(call, index, Text::from(name.as_str()))?;
    }
    Ok(Flow::Done(names.len() <= room))
}

/// Enlarges the array if possible. Otherwise, the result of the instruction reports it.
fn grow(call: &mut Call<'_>, contents: &Arr<Text>, wanted: usize) {
    let limit = call.version.container_limit();
    while contents.len(call).is_ok_and(|len| len < wanted) {
        if call.memory.append(contents.view.store, limit).is_err() {
            return;
        }
    }
}
