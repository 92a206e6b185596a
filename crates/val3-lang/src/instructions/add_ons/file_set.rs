//! `$fileSet`: writes lines or bytes to an open file.

use super::file_get::at_most;
use crate::call::{Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;
use crate::values::Text;

instruction! {
    /// Writes lines or bytes to an open file.
    ///
    /// - `nFile`: the number that `$fileOpen` returned.
    /// - `sLines`, `nBytes`: the lines or the bytes, each 0 to 255; read only.
    /// - `nCount`: the number of lines or bytes to write.
    /// - Result: the number of lines or bytes written.
    ///
    /// ## Example
    /// ```val3
    /// num nFile
    /// string sLine[1]
    ///   nFile=$fileOpen("Disk://data/log.txt","w")
    ///   sLine[0]=getDate("%Y-%m-%d %H:%M")
    ///   $fileSet(nFile,sLine,1)
    ///   $fileClose(nFile)
    /// ```
    "$fileSet": AddOns, with_add_on "Expansion";
    modifier (num nFile, string& sLines[], num nCount) -> num = lines;
    modifier (num nFile, num& nBytes[], num nCount) -> num = bytes;
}

fn lines(call: &mut Call<'_>, file: f64, lines: Arr<Text>, count: f64) -> Result<f64> {
    let count = at_most(count, lines.len(call)?);
    let lines = (0..count).map(|index| lines.get(call, index)).collect::<Result<Vec<_>>>()?;
    Ok(call.ports.write_lines(file, &lines) as f64)
}

fn bytes(call: &mut Call<'_>, file: f64, bytes: Arr<f64>, count: f64) -> Result<f64> {
    let count = at_most(count, bytes.len(call)?);
    let bytes = (0..count).map(|index| bytes.get(call, index)).collect::<Result<Vec<_>>>()?;
    Ok(call.ports.write_bytes(file, &bytes) as f64)
}
