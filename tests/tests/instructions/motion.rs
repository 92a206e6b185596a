//! Moves, and the instructions that read the state of the arm (9.2.3, 9.6.3, 9.7, 10.6, 11). The arm is a TX2-90.

use val3_lang::types::BaseType;
use val3_machine::event::EventKind;
use val3_machine::script::Script;
use val3_tests::running::Running;

/// Switches the power on and moves to the start position of most programs.
const READY: &str = "mdesc mSlow\nmdesc mStop\njoint jReady\npoint pNear\n  mStop.blend=off\n  enablePower()\n  \
                     wait(isPowered())\n  jReady={0,0,90,0,90,0}\n  movej(jReady,flange,mStop)\n  waitEndMove()\n";

#[track_caller]
fn check(body: &str, printed: &str) {
    assert_eq!(Running::start(body).to_the_end().printed(), printed, "{body}");
}

/// Checks the output of a program whose arm is ready.
#[track_caller]
fn check_ready(body: &str, printed: &str) {
    check(&format!("{READY}{body}"), printed);
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
fn the_operator_connects_until_a_program_chooses_otherwise() {
    check("  ? autoConnectMove()\n  autoConnectMove(true)\n  ? autoConnectMove()", "false\ntrue\n");
}

#[test]
fn a_joint_move_takes_the_time_of_its_slowest_axis() {
    check_ready(
        "num nStart\njoint jEnd\n  jEnd={90,0,90,0,90,0}\n  nStart=clock()\n  ? movej(jEnd,flange,mStop)\n  \
         waitEndMove()\n  ? clock()-nStart\n  ? herej()",
        "1\n0.54\n{90,0,90,0,90,0}\n",
    );
}

#[test]
fn a_line_ends_at_its_point() {
    check_ready(
        "num nStart\n  pNear=here(flange,world)\n  pNear.trsf.y=pNear.trsf.y+200\n  nStart=clock()\n  \
         movel(pNear,flange,mStop)\n  waitEndMove()\n  ? clock()-nStart\n  ? distance(here(flange,world),pNear)<1e-9",
        "0.264\ntrue\n",
    );
}

#[test]
fn a_circle_passes_its_intermediate_point() {
    check_ready(
        "num nLeast\npoint pMiddle\npoint pEnd\n  pMiddle=appro(here(flange,world),{0,100,50,0,0,0})\n  \
         pEnd=appro(here(flange,world),{0,0,100,0,0,0})\n  mStop.tvel=100\n  movec(pMiddle,pEnd,flange,mStop)\n  nLeast=1000\n  while \
         isEmpty()==false\n    nLeast=min(nLeast,distance(here(flange,world),pMiddle))\n    delay(0)\n  endWhile\n  ? \
         nLeast<1\n  ? distance(here(flange,world),pEnd)<1e-9",
        "true\ntrue\n",
    );
}

/// The manual's example of `setMoveId`.
#[test]
fn ids_count_the_moves() {
    check_ready(
        "num nId1\nnum nId2\nnum nId3\nnum nId4\n  pNear=here(flange,world)\n  pNear.trsf.z=pNear.trsf.z+10\n  \
         resetMotion()\n  nId1=getMoveId()\n  setMoveId(1000)\n  nId2=getMoveId()\n  nId3=movel(pNear,flange,mStop)\n  \
         pNear.trsf.z=pNear.trsf.z+10\n  nId4=movel(pNear,flange,mStop)\n  waitEndMove()\n  ? nId1\n  ? nId2\n  ? nId3\n  ? nId4\n  ? \
         getMoveId()",
        "0\n0\n1000\n1001\n1002\n",
    );
}

/// The first example of 10.6: the fraction is the completed part of the move.
#[test]
fn the_fraction_of_the_id_is_the_part_of_the_move() {
    check_ready(
        "num nWhole\npoint pStart\n  pStart=here(flange,world)\n  pNear=pStart\n  pNear.trsf.y=pNear.trsf.y+200\n  \
         setMoveId(15)\n  movel(pNear,flange,mStop)\n  wait(getMoveId()>=15.8)\n  \
         nWhole=distance(pStart,here(flange,world))/200\n  ? abs(nWhole-(getMoveId()-15))<1e-9\n  ? \
         nWhole>=0.8 and nWhole<0.85",
        "true\ntrue\n",
    );
}

/// 10.2.2: without the next move the arm moves to the leave point and waits there.
#[test]
fn the_arm_waits_at_the_leave_point_of_the_last_move() {
    check_ready(
        "  pNear=here(flange,world)\n  pNear.trsf.y=pNear.trsf.y+200\n  mStop.blend=joint\n  \
         movel(pNear,flange,mStop)\n  delay(5)\n  ? roundDown(distance(here(flange,world),pNear)*1000+0.5)/1000\n  ? \
         isSettled() and !isEmpty()\n  waitEndMove()\n  ? isEmpty()\n  ? getMoveId()",
        "50\ntrue\ntrue\n2\n",
    );
}

#[test]
fn a_stopped_arm_continues_on_its_path() {
    check_ready(
        "joint jEnd\njoint jHeld\n  jEnd={90,0,90,0,90,0}\n  movej(jEnd,flange,mStop)\n  delay(0.2)\n  stopMove()\n  \
         delay(1)\n  jHeld=herej()\n  delay(1)\n  ? jHeld==herej() and isSettled() and !isEmpty()\n  restartMove()\n  \
         waitEndMove()\n  ? herej()",
        "true\n{90,0,90,0,90,0}\n",
    );
}

#[test]
fn a_reset_forgets_the_moves() {
    check_ready(
        "joint jEnd\n  jEnd={90,0,90,0,90,0}\n  movej(jEnd,flange,mStop)\n  delay(0.2)\n  resetMotion()\n  ? \
         getMoveId()\n  wait(isSettled())\n  ? isEmpty() and herej()!=jEnd\n  movej(jReady,flange,mStop)\n  \
         waitEndMove()\n  ? herej()\n  ? getMoveId()",
        "0\ntrue\n{0,0,90,0,90,0}\n1\n",
    );
}

#[test]
fn without_power_the_arm_waits() {
    check(
        "joint jEnd\nmdesc mFast\n  jEnd={90,0,90,0,90,0}\n  movej(jEnd,flange,mFast)\n  delay(1)\n  ? \
         herej()\n  ? isEmpty()\n  enablePower()\n  waitEndMove()\n  ? herej()",
        "{0,0,0,0,0,0}\nfalse\n{90,0,90,0,90,0}\n",
    );
}

#[test]
fn the_monitor_speed_stretches_time() {
    check_ready(
        "num nStart\njoint jEnd\n  jEnd={90,0,90,0,90,0}\n  setMonitorSpeed(50)\n  delay(1)\n  nStart=clock()\n  \
         movej(jEnd,flange,mStop)\n  waitEndMove()\n  ? clock()-nStart",
        "1.08\n",
    );
}

#[test]
fn points_and_joints_become_one_another() {
    check(
        "joint j\npoint p\nbool bFound\n  j={10,20,70,30,60,-40}\n  p=jointToPoint(flange,world,j)\n  ? p.config\n  \
         bFound=pointToJoint(flange,{0,0,90,0,90,0},p,j)\n  ? bFound\n  ? abs(j-{10,20,70,30,60,-40})<{1e-9,1e-9,1e-9,1e-9,1e-9,1e-9}\n  ? config({0,0,-90,0,-90,0})",
        "{lefty,epositive,wpositive}\ntrue\ntrue\n{righty,enegative,wnegative}\n",
    );
}

#[test]
fn a_point_out_of_reach_has_no_joints() {
    check(
        "joint j\npoint p\nbool bFound\n  j={1,2,3,4,5,6}\n  p=jointToPoint(flange,world,j)\n  p.trsf.x=5000\n  \
         bFound=pointToJoint(flange,herej(),p,j)\n  ? bFound\n  ? j",
        "false\n{1,2,3,4,5,6}\n",
    );
}

#[test]
fn geometrical_parameters_are_those_of_the_arm() {
    check(
        "num nTheta[6]\nnum nD[7]\nnum nA[6]\nnum nAlpha[6]\nnum nBeta[6]\n  getDH(nTheta,nD,nA,nAlpha,nBeta)\n  ? \
         nTheta[1]\n  ? nD[2]\n  ? nA[1]\n  ? nAlpha[0]",
        "-90\n50\n425\n-90\n",
    );
}

#[test]
fn an_array_that_is_too_small_is_an_error() {
    check("num nForce[5]\n  getJointForce(nForce)", "error 70\n");
    check("num n[6]\nnum nShort[3]\n  getDH(n,n,n,n,nShort)", "error 70\n");
}

#[test]
fn impossible_moves_are_errors_at_their_line() {
    check_ready("  pNear=here(flange,world)\n  pNear.trsf.x=5000\n  movel(pNear,flange,mStop)", "error 154\n");
    check_ready("  jReady.j2=150\n  movej(jReady,flange,mStop)", "error 154\n");
    check_ready("  mStop.vel=0\n  movej(jReady,flange,mStop)", "error 100\n");
    check_ready("  mStop.leave=-1\n  movej(jReady,flange,mStop)", "error 106\n");
    check_ready(
        "  pNear=here(flange,world)\n  pNear.trsf.y=pNear.trsf.y+50\n  pNear.config.shoulder=righty\n  \
         movel(pNear,flange,mStop)",
        "error 154\n",
    );
}

/// Checks the events of moves: `phase type line`.
#[track_caller]
fn check_moves(body: &str, expected: &str) {
    let running = Running::start(&format!("{READY}{body}")).to_the_end();
    let moves = running.events.iter().filter_map(|event| match &event.kind {
        EventKind::Move { id, phase, instruction, .. } => Some(format!("{id:.2} {phase} {instruction}")),
        _ => None,
    });
    assert_eq!(moves.skip(3).collect::<Vec<_>>().join("\n"), expected);
}

#[test]
fn the_steps_of_moves_are_events() {
    check_moves(
        "  pNear=here(flange,world)\n  pNear.trsf.y=pNear.trsf.y+200\n  movel(pNear,flange,mSlow)\n  \
         movej(jReady,flange,mStop)\n  delay(0.1)\n  stopMove()\n  delay(1)\n  restartMove()\n  waitEndMove()\n  \
         resetMotion()",
        "1.00 recorded movel\n2.00 recorded movej\n1.00 started movel\n1.28 stopped stopMove\n1.57 restarted \
         restartMove\n1.00 blend movel\n1.00 reached movel\n1.00 done movel\n2.00 started movej\n2.00 done movej\n3.00 \
         reset resetMotion",
    );
}

fn follow(body: &str, script: &str) -> Running {
    let mut running = Running::start(body);
    running.controller.follow(Script::parse(script).unwrap());
    running.to_the_end()
}

/// The arm stops on its path when the power is switched off, and continues when it is on again.
#[test]
fn an_emergency_stop_holds_the_arm_on_its_path() {
    let body = format!(
        "{READY}joint jEnd\n  jEnd={{90,0,90,0,90,0}}\n  movej(jEnd,flange,mStop)\n  wait(!isPowered())\n  delay(0.5)\n  ? \
         isSettled() and !isEmpty()\n  enablePower()\n  waitEndMove()\n  ? herej()"
    );
    let script = "at = [{t = 1.75, estop = true}, {t = 4, estop = false}, {t = 5, estop = false}]";
    let running = follow(
        &body.replace("enablePower()\n  waitEndMove()\n  ? h", "delay(2)\n  enablePower()\n  waitEndMove()\n  ? h"),
        script,
    );
    assert_eq!(running.printed(), "true\n{90,0,90,0,90,0}\n");
}

#[test]
fn an_arm_that_was_moved_by_hand_returns_before_it_continues() {
    let body = format!(
        "{READY}joint jEnd\n  autoConnectMove(true)\n  jEnd={{90,0,90,0,90,0}}\n  movej(jEnd,flange,mStop)\n  delay(0.3)\n  \
         disablePower()\n  delay(5)\n  ? herej()\n  enablePower()\n  waitEndMove()\n  ? herej()"
    );
    let running = follow(&body, "at = [{t = 2.5, jog = [0, 10, 90, 0, 90, 0]}]");
    assert_eq!(running.printed(), "{0,10,90,0,90,0}\n{90,0,90,0,90,0}\n");
}

#[test]
fn the_operator_moves_and_holds_the_arm_in_local_mode() {
    let body = "joint jEnd\nmdesc mStop\nnum nStatus\n  mStop.blend=off\n  jEnd={90,0,0,0,0,0}\n  wait(isPowered())\n  \
                movej(jEnd,flange,mStop)\n  delay(1)\n  ? getMoveId()\n  wait(isEmpty())\n  ? workingMode(nStatus)\n  ? \
                nStatus\n  ? herej()";
    let script = "at = [{t = 0.1, mode = \"local\"}, {t = 1, power = true}, {t = 3, move = true}, {t = 3.3, move = false}, \
                  {t = 5, move = true}]";
    let running = follow(body, script);
    assert_eq!(running.printed(), "0\n3\n0\n{90,0,0,0,0,0}\n");
}

#[test]
fn the_operator_lets_the_arm_return() {
    let body = format!(
        "{READY}joint jEnd\n  jEnd={{90,0,90,0,90,0}}\n  resetMotion(jEnd)\n  movej(jReady,flange,mStop)\n  delay(1)\n  ? herej()\n  waitEndMove()\n  ? herej()"
    );
    let running = follow(&body, "at = [{t = 4, connect = true}]");
    assert_eq!(running.printed(), "{0,0,90,0,90,0}\n{0,0,90,0,90,0}\n");
}

#[test]
fn the_latch_keeps_the_position_at_the_edge() {
    let mut devices = Running::devices();
    devices.state.io.declare_device("Fast", ["fIn0", "fIn5"].map(|name| (name, BaseType::Dio)));
    let listing = r#"
joint l_jEnd
joint l_jEdge
mdesc l_mStop
begin
  l_mStop.blend=off
  enablePower()
  wait(isPowered())
  setLatch(diFast)
  delay(0)
  ? getLatch(l_jEdge)
  l_jEnd={90,0,90,0,90,0}
  movej(l_jEnd,flange,l_mStop)
  wait(getLatch(l_jEdge))
  ? l_jEdge.j1>1 and l_jEdge.j1<89
  waitEndMove()
  ? getLatch(l_jEdge) and l_jEdge.j1<89
  setLatch(diOther)
end
=== main/main.dtx
<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="diFast" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Fast\fIn0" /></Data>
    <Data name="diOther" access="private" xsi:type="array" type="dio" size="1"><Value key="0" link="Fast\fIn5" /></Data>
  </Datas>
</Database>
"#;
    let mut running = Running::on(devices, &format!("program start(){listing}"));
    let script = "at = [{t = 1.2, io = {'Fast\\fIn0' = true}}]";
    running.controller.follow(Script::parse(script).unwrap());
    assert_eq!(running.to_the_end().printed(), "false\ntrue\ntrue\nerror 70\n");
}

const PRESS: &str = "joint jPress\n  jPress={20,0,90,0,90,0}\n";

/// 11.1.3: the sign of the force determines the direction of the arm; an external force moves it as well.
#[test]
fn a_compliant_move_follows_forces() {
    check_ready(
        &format!("{PRESS}  movejf(jPress,flange,mStop,50)\n  waitEndMove()\n  ? herej()"),
        "{20,0,90,0,90,0}\n",
    );
    let passive = |force: f64| {
        format!(
            "{READY}{PRESS}  movejf(jPress,flange,mStop,{force})\n  delay(2)\n  ? isCompliant()\n  ? herej()==jReady\n  \
             waitEndMove()\n  ? herej()\n  ? isCompliant()"
        )
    };
    for force in [0.0, -20.0] {
        assert_eq!(follow(&passive(force), "at = [{t = 3, force = 0.5}]").printed(), "true\ntrue\n", "{force}");
        let pushed = follow(&passive(force), "at = [{t = 10, force = 500}]");
        assert_eq!(pushed.printed(), "true\ntrue\n{20,0,90,0,90,0}\nfalse\n", "{force}");
    }
}

#[test]
fn compliant_moves_have_errors_of_their_own() {
    check_ready(&format!("{PRESS}  movejf(jPress,flange,mStop,1001)"), "error 70\n");
    check_ready(&format!("{PRESS}  movej(jPress,flange,mSlow)\n  movejf(jReady,flange,mStop,10)"), "error 154\n");
    let mut running = Running::start(&format!("{READY}{PRESS}  movejf(jPress,flange,mStop,10)"));
    running.controller.devices.state.versions.set_licence("compliance", None);
    assert_eq!(running.to_the_end().printed(), "error 250\n");
}

/// A line of 200 mm along y with a deviation by a task of 4 ms: a twentieth of a mm per cycle, up to 5 mm.
const DEVIATED: &str = r"
program start()
  num l_nStatus
  point l_pEnd
  mdesc l_mSlow
  joint l_jReady
begin
  l_mSlow.blend=off
  enablePower()
  wait(isPowered())
  l_jReady={0,0,90,0,90,0}
  movej(l_jReady,flange,l_mSlow)
  waitEndMove()
  l_pEnd=here(flange,world)
  l_pEnd.trsf.y=l_pEnd.trsf.y+200
  l_mSlow.tvel=100
  ? alterEnd()
  l_nStatus=alterBegin(world,l_mSlow)
  ? l_nStatus
  alterMovel(l_pEnd,flange,l_mSlow)
  l_mSlow.tvel=150
  wait(alterBegin(world,l_mSlow)==1)
  ? alterBegin(world,l_mSlow)
  taskCreateSync 'deviate',0.004,bLate,deviate()
  waitEndMove()
  ? round(here(flange,world).trsf.z-l_pEnd.trsf.z)
  ? alterStopTime()<0
  ? alterEnd()
  ? alter({0,0,0,0,0,0})
end

program deviate()
  trsf l_trUp
begin
  while l_trUp.z<5
    l_trUp.z=min(5,l_trUp.z+0.05)
    alter(l_trUp)
    delay(0)
  endWhile
end
";

#[test]
fn alter_deviates_the_path_while_the_arm_follows_it() {
    let listing = format!("{}=== main/main.dtx\n{LATE}", DEVIATED.trim_start().replace('\'', "\""));
    assert_eq!(Running::start(&listing).to_the_end().printed(), "-1\n0\n-1\n5\ntrue\n1\n-1\n");
}

const LATE: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
  <Datas>
    <Data name="bLate" access="private" xsi:type="array" type="bool" size="1" />
  </Datas>
</Database>
"#;

#[test]
fn alter_needs_its_licence() {
    let mut running =
        Running::start("mdesc mSlow\n  ? alterBegin(world,mSlow)\n  ? alter({0,0,0,0,0,0})\n  ? alterEnd()");
    running.controller.devices.state.versions.set_licence("alter", None);
    assert_eq!(running.to_the_end().printed(), "-2\n-2\n-1\n");
}
