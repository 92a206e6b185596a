//! V0526: a link to an input or output of another kind.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// Data is linked to an input or output of another kind: a `dio` to a socket, for example.
    ///
    /// ## Why
    /// A `dio` is linked to a digital input or output (3.5), an `aio` to a numerical one (3.6), an `sio` to a serial
    /// line or a socket (3.7). With a link to another kind, the controller reports linked data of the wrong type.
    ///
    /// ## Bad
    /// ```val3
    /// dStart=true
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="dStart" access="private" xsi:type="array" type="dio" size="1">
    ///       <Value key="0" link="Socket\Camera" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === /configs/sio.cfx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <sio>
    ///   <socketClt>
    ///     <String name="name" value="Camera" />
    ///     <Inet name="serverIp" value="192.168.0.10" />
    ///     <Uint name="portNumber" value="4000" />
    ///   </socketClt>
    /// </sio>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// siCamera="go"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="siCamera" access="private" xsi:type="array" type="sio" size="1">
    ///       <Value key="0" link="Socket\Camera" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// === /configs/sio.cfx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <sio>
    ///   <socketClt>
    ///     <String name="name" value="Camera" />
    ///     <Inet name="serverIp" value="192.168.0.10" />
    ///     <Uint name="portNumber" value="4000" />
    ///   </socketClt>
    /// </sio>
    /// ```
    V0526 "io-link-kind" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(link: &str, expected: &str, found: &str) -> Wording {
    Wording::new(
        format!("the data is `{expected}`, but its link `{link}` names `{found}`"),
        format!("this is `{found}`"),
        format!("declare the data as `{found}`, or link it to another input or output"),
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn both_kinds_are_shown() {
        expect![[r#"
            the data is `dio`, but its link `Socket\Camera` names `sio`
            | this is `sio`
            ? declare the data as `sio`, or link it to another input or output
        "#]]
        .assert_eq(&word(r"Socket\Camera", "dio", "sio").to_string());
    }
}
