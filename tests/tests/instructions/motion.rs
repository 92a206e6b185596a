//! Instructions that read the state of an arm at rest (9.2.3, 10.6, 11.1).

use val3_tests::running::Running;

#[track_caller]
fn check(body: &str, printed: &str) {
    assert_eq!(Running::start(body).to_the_end().printed(), printed, "{body}");
}

#[test]
fn an_arm_that_does_not_move_has_arrived() {
    check("  ? isEmpty()\n  ? isSettled()\n  ? isCompliant()", "true\ntrue\nfalse\n");
    check("  waitEndMove()\n  ? \"there\"", "there\n");
    check("  ? herej()\n  ? getPositionErr()", "{0,0,0,0,0,0}\n{0,0,0,0,0,0}\n");
}

#[test]
fn the_limits_of_the_arm_are_known() {
    check(
        "  ? isInRange(herej())\n  ? isInRange({0,148,0,0,0,0})\n  ? isInRange({0,0,0,-270,0,270})",
        "true\nfalse\ntrue\n",
    );
}

#[test]
fn the_speed_at_standstill_is_zero() {
    check("  ? getSpeed(flange)", "0\n");
}

#[test]
fn a_program_sets_the_id_of_the_next_move_and_resets_it() {
    check(
        "joint jStart\n  setMoveId(1000)\n  ? getMoveId()\n  resetMotion()\n  ? getMoveId()\n  resetMotion(jStart)",
        "1000\n0\n",
    );
}

#[test]
fn the_operator_connects_until_a_program_chooses_otherwise() {
    check("  ? autoConnectMove()\n  autoConnectMove(true)\n  ? autoConnectMove()", "false\ntrue\n");
}

#[test]
fn the_arm_is_held_until_a_program_releases_it() {
    let is_held = |body| Running::start(body).to_the_end().controller.devices.state.arm.is_stopped();
    assert!(is_held("  stopMove()"));
    assert!(!is_held("  stopMove()\n  restartMove()"));
    assert!(!is_held("  stopMove()\n  resetMotion()"));
}

#[test]
fn a_move_ends_the_run_at_its_line() {
    check("tool tHand\njoint jPark\nmdesc mFast\n  ? 1\n  movej(jPark,tHand,mFast)\n  ? 2", "1\nline 6: no movej\n");
}
