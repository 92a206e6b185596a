//! Ports for tests without a controller.

use val3_geometry::IsometryMatrix3;
use val3_kinematics::{Arm, Dh};
use val3_moves::AlterReference;

use super::outside::NoController;
use crate::fault::Result;
use crate::memory::Place;
use crate::ports::{
    InputKind, InputResult, IoDescription, IoPort, LineValue, MediaPort, MotionPort, MoveRequest, Outgoing, Reply,
    Robot, Screen, Serial, Time,
};
use crate::types::BaseType;
use crate::values::date::DateTime;
use crate::values::{MdescValue, Text};

impl IoPort for NoController {
    fn read_digital(&mut self, _: Option<u32>) -> Result<bool> {
        unreachable!()
    }

    fn write_digital(&mut self, _: Option<u32>, _: bool) -> Result<()> {
        unreachable!()
    }

    fn read_bits(&mut self, _: &[Option<u32>]) -> Result<f64> {
        unreachable!()
    }

    fn write_bits(&mut self, _: &[Option<u32>], _: f64) -> Result<f64> {
        unreachable!()
    }

    fn read_analog(&mut self, _: Option<u32>) -> Result<f64> {
        unreachable!()
    }

    fn write_analog(&mut self, _: Option<u32>, _: f64) -> Result<f64> {
        unreachable!()
    }

    fn io_status(&mut self, _: BaseType, _: Option<u32>) -> i8 {
        unreachable!()
    }

    fn io_texts(&mut self, _: Option<u32>) -> IoDescription {
        unreachable!()
    }

    fn failed_devices(&mut self) -> Vec<Text> {
        unreachable!()
    }
}

impl Screen for NoController {
    fn print(&mut self, _: &str) {
        unreachable!()
    }

    fn create_page(&mut self, _: Place) -> u32 {
        unreachable!()
    }

    fn show_page(&mut self, _: u32) {
        unreachable!()
    }

    fn fix_page(&mut self, _: bool) {
        unreachable!()
    }

    fn go_to(&mut self, _: u32, _: f64, _: f64) {
        unreachable!()
    }

    fn clear(&mut self, _: u32) {
        unreachable!()
    }

    fn set_text_mode(&mut self, _: u32, _: f64) -> Result<()> {
        unreachable!()
    }

    fn put(&mut self, _: u32, _: &str, _: bool) {
        unreachable!()
    }

    fn set_title(&mut self, _: u32, _: &str) {
        unreachable!()
    }

    fn pop_up(&mut self, _: &str, _: f64) {
        unreachable!()
    }

    fn begin_reading(&mut self, _: u32, _: InputKind) {
        unreachable!()
    }

    fn begin_question(&mut self, _: &str, _: InputKind) {
        unreachable!()
    }

    fn take_answer(&mut self) -> Option<InputResult> {
        unreachable!()
    }

    fn take_key(&mut self, _: u32) -> Option<u16> {
        unreachable!()
    }

    fn is_key_pressed(&mut self, _: u32, _: f64) -> bool {
        unreachable!()
    }

    fn display_columns(&mut self, _: &str) -> usize {
        unreachable!()
    }

    fn show_html(&mut self, _: &str) -> i8 {
        unreachable!()
    }

    fn set_html(&mut self, _: &str, _: &str, _: &str, _: &str) {
        unreachable!()
    }
}

impl Robot for NoController {
    fn enable_power(&mut self) {
        unreachable!()
    }

    fn disable_power(&mut self) {
        unreachable!()
    }

    fn is_power_off(&mut self) -> bool {
        unreachable!()
    }

    fn is_powered(&mut self) -> bool {
        unreachable!()
    }

    fn is_calibrated(&mut self) -> bool {
        unreachable!()
    }

    fn working_mode(&mut self) -> (u8, u8) {
        unreachable!()
    }

    fn es_status(&mut self) -> u8 {
        unreachable!()
    }

    fn safety_fault(&mut self) -> Option<Text> {
        unreachable!()
    }

    fn monitor_speed(&mut self) -> f64 {
        unreachable!()
    }

    fn set_monitor_speed(&mut self, _: f64) -> i8 {
        unreachable!()
    }

    fn version(&mut self, _: &str) -> Text {
        unreachable!()
    }

    fn oem_licence(&mut self, _: &str, _: &str) -> Text {
        unreachable!()
    }

    fn date(&mut self, _: Time) -> DateTime {
        unreachable!()
    }

    fn log(&mut self, _: &str, _: f64) -> bool {
        true
    }

    fn profile(&mut self) -> Text {
        unreachable!()
    }

    fn set_profile(&mut self, _: &str, _: &str) -> u8 {
        unreachable!()
    }

    fn language(&mut self) -> Text {
        unreachable!()
    }

    fn set_language(&mut self, _: &str) -> bool {
        unreachable!()
    }

    fn safe_reference(&mut self) -> f64 {
        unreachable!()
    }

    fn has_external_supply(&mut self) -> bool {
        unreachable!()
    }

    fn restart_safety(&mut self) -> bool {
        unreachable!()
    }

    fn wake_up(&mut self) -> f64 {
        unreachable!()
    }

    fn reference_position(&mut self, _: &str) -> [f64; 6] {
        [0.0, 0.0, 30.0, 0.0, 90.0, 0.0]
    }
}

/// A TX2-90 at rest.
impl MotionPort for NoController {
    fn arm(&mut self) -> &Arm {
        &self.arm
    }

    fn set_dh(&mut self, dh: &Dh) -> Result<bool> {
        Ok(self.arm.set_dh(dh).is_ok())
    }

    fn commanded_joint(&mut self) -> [f64; 6] {
        [0.0, 0.0, 90.0, 0.0, 90.0, 0.0]
    }

    fn measured_joint(&mut self) -> [f64; 6] {
        [0.0, 0.0, 91.0, 0.0, 90.0, 0.0]
    }

    fn joint_force(&mut self) -> [f64; 6] {
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    }

    fn arm_latch(&mut self, _: Option<u32>) -> Result<()> {
        unreachable!()
    }

    fn latched_joint(&mut self) -> Option<[f64; 6]> {
        Some([0.0, 0.0, 40.0, 0.0, 90.0, 0.0])
    }

    /// Returns an inch per second, and more for a longer tool.
    fn speed(&mut self, tool: &IsometryMatrix3<f64>) -> f64 {
        tool.translation.x + 25.4
    }

    fn record_move(&mut self, request: &MoveRequest) -> Result<Option<f64>> {
        self.moves.push(request.clone());
        Ok(Some(17.0))
    }

    fn is_empty(&mut self) -> bool {
        true
    }

    fn is_settled(&mut self) -> bool {
        unreachable!()
    }

    fn is_at_rest(&mut self) -> bool {
        true
    }

    fn is_compliant(&mut self) -> bool {
        unreachable!()
    }

    fn arrive(&mut self) -> Result<bool> {
        unreachable!()
    }

    fn stop_move(&mut self) {
        unreachable!()
    }

    fn restart_move(&mut self) {
        unreachable!()
    }

    fn reset_motion(&mut self, start: Option<[f64; 6]>) {
        self.start = start;
    }

    fn reset_turn(&mut self, reference: [f64; 6]) -> Result<[f64; 6]> {
        Ok(reference)
    }

    fn move_id(&mut self) -> f64 {
        unreachable!()
    }

    fn set_move_id(&mut self, _: f64) {
        unreachable!()
    }

    fn connects_by_itself(&mut self) -> bool {
        unreachable!()
    }

    fn connect_by_itself(&mut self, _: bool) {
        unreachable!()
    }

    fn begin_alter(&mut self, _: AlterReference, _: &MdescValue) -> i8 {
        unreachable!()
    }

    fn alter(&mut self, _: &IsometryMatrix3<f64>) -> i8 {
        unreachable!()
    }

    fn end_alter(&mut self) -> i8 {
        unreachable!()
    }

    fn alter_stop_time(&mut self) -> f64 {
        unreachable!()
    }
}

impl MediaPort for NoController {
    fn delete_library(&mut self, _: &str, _: &str) -> u16 {
        unreachable!()
    }

    fn list(&mut self, _: &str, _: &str) -> Option<Vec<String>> {
        unreachable!()
    }

    fn open_file(&mut self, _: &str, _: &str, _: &str) -> Option<u8> {
        unreachable!()
    }

    fn read_lines(&mut self, _: f64, _: usize) -> Vec<String> {
        unreachable!()
    }

    fn read_bytes(&mut self, _: f64, _: usize) -> Vec<u8> {
        unreachable!()
    }

    fn write_lines(&mut self, _: f64, _: &[Text]) -> usize {
        unreachable!()
    }

    fn write_bytes(&mut self, _: f64, _: &[f64]) -> usize {
        unreachable!()
    }

    fn close_file(&mut self, _: f64) -> bool {
        unreachable!()
    }

    fn file_exists(&mut self, _: &str, _: &str) -> bool {
        unreachable!()
    }

    fn delete_file(&mut self, _: &str, _: &str) -> bool {
        unreachable!()
    }

    fn copy_file(&mut self, _: &str, _: &str, _: &str) -> bool {
        unreachable!()
    }

    fn rename_file(&mut self, _: &str, _: &str, _: &str) -> bool {
        unreachable!()
    }
}

impl Serial for NoController {
    fn receive_text(&mut self, _: Option<u32>, _: Time) -> Result<Reply<Text>> {
        unreachable!()
    }

    fn receive_byte(&mut self, _: Option<u32>, _: Time) -> Result<Reply<u8>> {
        unreachable!()
    }

    fn receive(&mut self, _: Option<u32>, _: usize, _: Time) -> Result<Reply<Option<Vec<u8>>>> {
        unreachable!()
    }

    fn send(&mut self, _: Option<u32>, _: Outgoing<'_>, _: bool, _: Time) -> Result<Reply<Option<usize>>> {
        unreachable!()
    }

    fn clear_line(&mut self, _: Option<u32>) -> Result<Option<usize>> {
        unreachable!()
    }

    fn control_line(&mut self, _: Option<u32>, _: &str, _: LineValue) -> Result<i8> {
        unreachable!()
    }
}
