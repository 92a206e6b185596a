use crate::declare::instruction;

instruction! {
    /// Reads lines or bytes from an open file.
    ///
    /// - `nFile`: the number that `$fileOpen` gave.
    /// - `sLines`, `nBytes`: get the lines, or the bytes, each 0 to 255. A line longer than a string goes on in the
    ///   next value.
    /// - `nCount`: how many to read.
    /// - Result: how many were read; fewer at the end of the file.
    ///
    /// ## Example
    /// ```val3
    /// num nFile
    /// string sLine[1]
    ///   nFile=$fileOpen("Disk://data/order.txt","r")
    ///   while $fileGet(nFile,sLine,1)==1
    ///     putln(sLine[0])
    ///   endWhile
    ///   $fileClose(nFile)
    /// ```
    "$fileGet": AddOns, with_add_on "Expansion";
    modifier (num nFile, string& sLines[], num nCount) -> num;
    modifier (num nFile, num& nBytes[], num nCount) -> num;
}
