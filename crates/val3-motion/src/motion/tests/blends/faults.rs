//! A single blend has the same fault as the same blend in a queue of moves.

use super::*;
use crate::blend_fault;

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn a_corner_alone_has_the_fault_of_the_queue(program in programs()) {
        let (motion, moves) = program.record();
        let arm = program.arm();
        let mut alone = Motion::new(Arc::new(program.arm()), program.start());
        let mut reach = 0.0;
        for (index, pair) in moves.windows(2).enumerate() {
            let [first, second] = pair else { continue };
            let start = alone.destination();
            let stopping = Move { blend: Blend::Off, ..first.clone() };
            // The path after the leave point may be impossible.
            if alone.record(&stopping).is_err() {
                break;
            }
            // A move of length 0 has no corner.
            let is_null = alone.path.segment(&Model(&arm), second).is_ok_and(|(segment, _)| segment.is_null());
            if is_null || start == alone.destination() {
                break;
            }
            let Ok(fault) = blend_fault(&arm, start, [first, second], Millimetres(reach)) else { break };
            let expected = motion.path_fault().filter(|fault| fault.is_blend && fault.serial == index as u64);
            prop_assert_eq!(fault.as_ref(), expected.map(|fault| &fault.cause), "corner {}", index);
            if expected.is_some() {
                break;
            }
            reach = first.blend.distances().map_or(0.0, |(_, reach)| reach);
        }
    }
}
