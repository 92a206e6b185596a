use proptest::prelude::*;

use super::*;
use crate::ModbusFile;

/// Bits 0 to 7 of the client, 8 to 15 of the robot; words 0 to 3 of the client, 6 and 7 of the robot.
pub(crate) fn image() -> ModbusImage {
    let file = ModbusFile::read(
        r#"<TOPICSLIST><TOPIC Name="Modbus" Actif="1">
        <MODULE IDModule="BOOLEAN"><ITEM Name="bIn" Syntaxe="%Q0:8"/><ITEM Name="bOut" Syntaxe="%I8:8"/></MODULE>
        <MODULE IDModule="WORD"><ITEM Name="nIn" Syntaxe="%QW0:4"/><ITEM Name="nOut" Syntaxe="%IW6:2"/></MODULE>
        </TOPIC><GENERAL_PARAMETERS TopicName="Modbus" ConnectionNumber="2"/></TOPICSLIST>"#,
    );
    ModbusImage::new(&ModbusMap::of(&file).unwrap())
}

#[test]
fn the_run_receives_what_clients_write() {
    let mut image = image();
    image.write(TableKind::Words, 1, &[7, 8]).unwrap();
    image.write(TableKind::Words, 2, &[9]).unwrap();
    image.publish(TableKind::Words, 1, 0);
    assert_eq!(image.read(TableKind::Words, 0, 4), Ok(vec![0, 7, 9, 0]), "a client reads its own writes");
    let write = |address, value| Write { table: TableKind::Words, address, value };
    assert_eq!(image.take_writes(), [write(1, 7), write(2, 9)]);
    assert_eq!(image.take_writes(), []);
    image.publish(TableKind::Words, 1, 5);
    assert_eq!(image.read(TableKind::Words, 1, 1), Ok(vec![5]), "the run has another value afterwards");
}

#[test]
fn values_of_the_robot_stay() {
    let mut image = image();
    image.publish(TableKind::Bits, 9, 1);
    image.write(TableKind::Bits, 6, &[1, 1, 0, 1, 1]).unwrap();
    assert_eq!(image.read(TableKind::Bits, 6, 5), Ok(vec![1, 1, 0, 1, 0]));
    assert_eq!(image.discarded(), Some((TableKind::Bits, 10)));
    assert_eq!(image.take_writes().len(), 2);
    // No item has the words 4 and 5.
    image.write(TableKind::Words, 4, &[1, 1]).unwrap();
    assert_eq!(image.read(TableKind::Words, 4, 2), Ok(vec![0, 0]));
}

#[test]
fn addresses_beyond_the_table_write_nothing() {
    let mut image = image();
    assert_eq!(image.write(TableKind::Words, 7, &[1, 1]), Err(BeyondTable));
    assert_eq!(image.write(TableKind::Bits, u16::MAX, &[1]), Err(BeyondTable));
    assert_eq!(image.read(TableKind::Bits, 0, 17), Err(BeyondTable));
    assert_eq!((image.take_writes(), image.discarded()), (Vec::new(), None));
}

proptest! {
    #[test]
    fn written_values_are_read(first in 0..8_u16, values in prop::collection::vec(0..2_u16, 0..8)) {
        let mut image = image();
        let is_inside = usize::from(first) + values.len() <= 8;
        image.write(TableKind::Bits, first, &values).unwrap();
        let count = u16::try_from(values.len()).unwrap();
        let read = image.read(TableKind::Bits, first, count).unwrap();
        prop_assert!(!is_inside || read == values);
        prop_assert_eq!(image.take_writes().len(), values.len().min(usize::from(8 - first)));
    }
}
