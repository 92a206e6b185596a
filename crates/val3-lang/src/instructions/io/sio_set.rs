use crate::declare::instruction;

instruction! {
    /// Writes bytes to a serial channel.
    ///
    /// - `siOutput`: the serial line or socket; a socket that is not connected is opened first.
    /// - `nData`: the bytes; each number is rounded and taken modulo 256. Of an array, an index may say where to
    ///   start.
    /// - `nLength`: (s8) how many bytes; else the whole array.
    /// - Result: the number of bytes written, fewer than asked for after a fault; -1 after the timeout.
    /// - Errors: 123 not linked, 125 the channel has failed.
    ///
    /// ## Example
    /// ```val3
    /// sio siHost
    /// num nBytes[3]
    ///   if sioSet(siHost,nBytes)!=3
    ///     logMsg("host is not connected")
    ///   endIf
    /// ```
    "sioSet": Io "3.7.3", blocking, errors [123, 125];
    modifier (sio siOutput, num& nData[]) -> num;
    modifier (sio siOutput, num& nData[], num nLength) -> num since 8;
}
