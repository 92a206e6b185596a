//! `val3 test`: bytes over lines, as devices with binary protocols send them.

use crate::support::{CommandOutput, Folder};

/// An application that reads a message of two numbers, and responds with twice the first number and a magic number.
const SERVER: &str = r#"
program start()
  num l_nCount
begin
  l_nCount=sioGet(siHost,nIn)
  l_nCount=fromBinary(nIn,8,"4.0l",nValue)
  nFirst=nValue[0]
  nValue[0]=nFirst*2
  l_nCount=toBinary(nValue,2,"4.0b",nOut)
  nOut[8]=205
  nOut[9]=171
  l_nCount=sioSet(siHost,nOut)
  delay(0.1)
end
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="siHost" access="private" xsi:type="array" type="sio" size="1"><Value key="0" link="Socket\host" /></Data>
    <Data name="nFirst" access="private" xsi:type="array" type="num" size="1" />
    <Data name="nIn" access="private" xsi:type="array" type="num" size="8" />
    <Data name="nOut" access="private" xsi:type="array" type="num" size="10" />
    <Data name="nValue" access="private" xsi:type="array" type="num" size="2" />
  </Datas>
</Database>"#;

fn tested(scenario: &str) -> CommandOutput {
    let folder = Folder::with(SERVER);
    folder.write("tests/cell.toml", &format!("application = \"../usrapp/main\"\nuntil = 5\n{scenario}"));
    folder.val3(&["test", "."])
}

const REQUEST: &str = "[[at]]\nt = 1\nreceive = { 'Socket\\host' = [{ values = [0.1], format = \"4.0l\" }, { hex = \"00 00 80 BF\" }] }\n";

#[test]
fn a_binary_protocol_is_tested_with_exact_bytes() {
    let expected = r#"
        [expect]
        data = { nFirst = { is = 0.1, within = 1e-8 } }
        sent = { 'Socket\host' = [{ values = [0.2, -1], format = "4.0b" }, { bytes = [205, 171] }] }
        [[expect.within]]
        event = { sent = { 'Socket\host' = { hex = "CD AB" } } }
        seconds = 1.1
    "#;
    let run = tested(&format!("{REQUEST}{expected}"));
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    let run = tested(&format!("{REQUEST}[expect]\nsent = {{ 'Socket\\host' = {{ hex = \"CE\" }} }}\n"));
    let message =
        r"it did not happen that CE is sent over `Socket\host`: the output ends with 3E 4C CC CD BF 80 00 00 CD AB";
    assert!(run.code == 1 && run.stdout.contains(message), "{run:?}");
}

#[test]
fn a_device_answers_bytes() {
    let device = r#"
        [[when]]
        sent = { 'Socket\host' = { hex = "CD AB" } }
        then = [{ set = { nFirst = 7 } }]
        [expect]
        data = { nFirst = 7 }
    "#;
    let run = tested(&format!("{REQUEST}{device}"));
    assert_eq!(run.code, 0, "{run:?}");
}

#[test]
fn a_silent_line_has_a_peer() {
    // Without a peer, the task gets an error.
    let run = tested("silent = ['Socket\\host']\n[expect]\ndata = { nFirst = 0 }\n");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{run:?}");
    let run = tested("silent = ['Socket\\hots']\n");
    assert!(run.stdout.contains(r"silent: there is no serial line or socket `Socket\hots`; did you mean"), "{run:?}");
    let run = tested("[[at]]\nt = 1\nreceive = { 'Socket\\host' = { hex = \"0\" } }\n");
    assert!(run.stdout.contains("two hexadecimal digits") && run.code == 2, "{run:?}");
}
