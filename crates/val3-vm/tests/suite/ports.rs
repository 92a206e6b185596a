//! Ports of a host without devices: `?` is recorded, every other call fails the test.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Dh};
use val3_lang::fault::Result;
use val3_lang::memory::Place;
use val3_lang::ports::{
    InputKind, InputResult, IoDescription, IoPort, LineValue, MediaPort, MotionPort, MoveRequest, Outgoing, Reply,
    Robot, Screen, Serial, Time,
};
use val3_lang::types::BaseType;
use val3_lang::values::date::DateTime;
use val3_lang::values::{MdescValue, Text};
use val3_moves::AlterReference;

use crate::host::Host;

/// Methods that no test calls.
macro_rules! absent {
    ($(fn $name:ident(&mut self $(, _: $type:ty)*) $(-> $result:ty)?;)+) => {
        $(fn $name(&mut self $(, _: $type)*) $(-> $result)? {
            unreachable!("{}", stringify!($name))
        })+
    };
}

impl IoPort for Host {
    absent! {
        fn read_digital(&mut self, _: Option<u32>) -> Result<bool>;
        fn write_digital(&mut self, _: Option<u32>, _: bool) -> Result<()>;
        fn read_bits(&mut self, _: &[Option<u32>]) -> Result<f64>;
        fn write_bits(&mut self, _: &[Option<u32>], _: f64) -> Result<f64>;
        fn read_analog(&mut self, _: Option<u32>) -> Result<f64>;
        fn write_analog(&mut self, _: Option<u32>, _: f64) -> Result<f64>;
        fn io_status(&mut self, _: BaseType, _: Option<u32>) -> i8;
        fn io_texts(&mut self, _: Option<u32>) -> IoDescription;
        fn failed_devices(&mut self) -> Vec<Text>;
    }
}

impl MediaPort for Host {
    absent! {
        fn delete_library(&mut self, _: &str, _: &str) -> u16;
        fn list(&mut self, _: &str, _: &str) -> Option<Vec<String>>;
        fn open_file(&mut self, _: &str, _: &str, _: &str) -> Option<u8>;
        fn read_lines(&mut self, _: f64, _: usize) -> Vec<String>;
        fn read_bytes(&mut self, _: f64, _: usize) -> Vec<u8>;
        fn write_lines(&mut self, _: f64, _: &[Text]) -> usize;
        fn write_bytes(&mut self, _: f64, _: &[f64]) -> usize;
        fn close_file(&mut self, _: f64) -> bool;
        fn file_exists(&mut self, _: &str, _: &str) -> bool;
        fn delete_file(&mut self, _: &str, _: &str) -> bool;
        fn copy_file(&mut self, _: &str, _: &str, _: &str) -> bool;
        fn rename_file(&mut self, _: &str, _: &str, _: &str) -> bool;
    }
}

impl MotionPort for Host {
    absent! {
        fn arm(&mut self) -> &Arm;
        fn set_dh(&mut self, _: &Dh) -> Result<bool>;
        fn commanded_joint(&mut self) -> [f64; 6];
        fn measured_joint(&mut self) -> [f64; 6];
        fn joint_force(&mut self) -> [f64; 6];
        fn arm_latch(&mut self, _: Option<u32>) -> Result<()>;
        fn latched_joint(&mut self) -> Option<[f64; 6]>;
        fn speed(&mut self, _: &IsometryMatrix3<f64>) -> f64;
        fn record_move(&mut self, _: &MoveRequest) -> Result<Option<f64>>;
        fn is_empty(&mut self) -> bool;
        fn is_settled(&mut self) -> bool;
        fn is_at_rest(&mut self) -> bool;
        fn is_compliant(&mut self) -> bool;
        fn arrive(&mut self) -> Result<bool>;
        fn stop_move(&mut self);
        fn restart_move(&mut self);
        fn reset_motion(&mut self, _: Option<[f64; 6]>);
        fn reset_turn(&mut self, _: [f64; 6]) -> Result<[f64; 6]>;
        fn move_id(&mut self) -> f64;
        fn set_move_id(&mut self, _: f64);
        fn connects_by_itself(&mut self) -> bool;
        fn connect_by_itself(&mut self, _: bool);
        fn begin_alter(&mut self, _: AlterReference, _: &MdescValue) -> i8;
        fn alter(&mut self, _: &IsometryMatrix3<f64>) -> i8;
        fn end_alter(&mut self) -> i8;
        fn alter_stop_time(&mut self) -> f64;
    }
}

impl Robot for Host {
    absent! {
        fn enable_power(&mut self);
        fn disable_power(&mut self);
        fn is_power_off(&mut self) -> bool;
        fn is_powered(&mut self) -> bool;
        fn is_calibrated(&mut self) -> bool;
        fn working_mode(&mut self) -> (u8, u8);
        fn es_status(&mut self) -> u8;
        fn safety_fault(&mut self) -> Option<Text>;
        fn monitor_speed(&mut self) -> f64;
        fn set_monitor_speed(&mut self, _: f64) -> i8;
        fn version(&mut self, _: &str) -> Text;
        fn oem_licence(&mut self, _: &str, _: &str) -> Text;
        fn date(&mut self, _: Time) -> DateTime;
        fn log(&mut self, _: &str, _: f64) -> bool;
        fn profile(&mut self) -> Text;
        fn set_profile(&mut self, _: &str, _: &str) -> u8;
        fn language(&mut self) -> Text;
        fn set_language(&mut self, _: &str) -> bool;
        fn safe_reference(&mut self) -> f64;
        fn has_external_supply(&mut self) -> bool;
        fn restart_safety(&mut self) -> bool;
        fn wake_up(&mut self) -> f64;
        fn reference_position(&mut self, _: &str) -> [f64; 6];
    }
}

impl Screen for Host {
    fn print(&mut self, text: &str) {
        self.record.push_str(&format!("{text}\n"));
    }

    absent! {
        fn create_page(&mut self, _: Place) -> u32;
        fn show_page(&mut self, _: u32);
        fn fix_page(&mut self, _: bool);
        fn go_to(&mut self, _: u32, _: f64, _: f64);
        fn clear(&mut self, _: u32);
        fn set_text_mode(&mut self, _: u32, _: f64) -> Result<()>;
        fn put(&mut self, _: u32, _: &str, _: bool);
        fn set_title(&mut self, _: u32, _: &str);
        fn pop_up(&mut self, _: &str, _: f64);
        fn begin_reading(&mut self, _: u32, _: InputKind);
        fn begin_question(&mut self, _: &str, _: InputKind);
        fn take_answer(&mut self) -> Option<InputResult>;
        fn take_key(&mut self, _: u32) -> Option<u16>;
        fn is_key_pressed(&mut self, _: u32, _: f64) -> bool;
        fn display_columns(&mut self, _: &str) -> usize;
        fn show_html(&mut self, _: &str) -> i8;
        fn set_html(&mut self, _: &str, _: &str, _: &str, _: &str);
    }
}

impl Serial for Host {
    absent! {
        fn receive_text(&mut self, _: Option<u32>, _: Time) -> Result<Reply<Text>>;
        fn receive_byte(&mut self, _: Option<u32>, _: Time) -> Result<Reply<u8>>;
        fn receive(&mut self, _: Option<u32>, _: usize, _: Time) -> Result<Reply<Option<Vec<u8>>>>;
        fn send(&mut self, _: Option<u32>, _: Outgoing<'_>, _: bool, _: Time) -> Result<Reply<Option<usize>>>;
        fn clear_line(&mut self, _: Option<u32>) -> Result<Option<usize>>;
        fn control_line(&mut self, _: Option<u32>, _: &str, _: LineValue) -> Result<i8>;
    }
}
