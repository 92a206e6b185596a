use crate::declare::instruction;

instruction! {
    /// Copies the value of a variable that is known by its name only.
    ///
    /// - `sDataName`: `"name"`, `"library:name"`, or either with an index such as `"name[3]"`.
    /// - `variable`: where the value goes; of the same type. If both are one-dimensional arrays, as many values
    ///   are copied as both hold, from the index of the destination on.
    /// - Result: the number of values copied; -1 no such variable, -2 no such library identifier, -3 index out of
    ///   range, -4 another type.
    ///
    /// ## Example
    /// ```val3
    /// library part "Disk://part/part.pjx"
    /// point pPath[20]
    /// num nPoints
    ///   nPoints=getData("part:pTrack",pPath)
    ///   if nPoints<0
    ///     logMsg("no track in the library")
    ///   endIf
    /// --- part
    /// public point pTrack[5]
    /// ```
    "getData": Variables "2.5.4";
    modifier (string sDataName, any& variable) -> num;
}
