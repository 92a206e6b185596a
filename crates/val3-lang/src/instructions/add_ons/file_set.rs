use crate::declare::instruction;

instruction! {
    /// Writes lines or bytes to an open file.
    ///
    /// - `nFile`: the number that `$fileOpen` gave.
    /// - `sLines`, `nBytes`: the lines, or the bytes, each 0 to 255; read only.
    /// - `nCount`: how many to write.
    /// - Result: how many were written.
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
    modifier (num nFile, string& sLines[], num nCount) -> num;
    modifier (num nFile, num& nBytes[], num nCount) -> num;
}
