//! Programs for SCARA arms. The arm is a TS2-60: links of 380 and 240 mm, a stroke of 200 mm, the tool points down.

use crate::support::{CommandOutput, Folder};

/// Data and power for every program.
const HEAD: &str = "jointRs j\njointRs jEnd\npointRs p\npointRs pEnd\nmdesc m\nnum nStart\nbool bFound\n  m.blend=off\n  \
                    enablePower()\n  wait(isPowered())\n";

fn scara(body: &str) -> CommandOutput {
    Folder::with(&format!("{HEAD}{body}")).val3(&["run", "--arm", "TS2-60"])
}

#[track_caller]
fn check(body: &str, printed: &str) {
    let run = scara(body);
    assert_eq!((run.stdout.as_str(), run.code), (printed, 0), "{}\n{body}", run.stderr);
}

/// 380 mm at 30°, then 240 mm at 90°: x = 380·cos 30°, y = 380·sin 30° + 240.
#[test]
fn positions_are_those_of_the_links() {
    check(
        "  j={30,60,100,45}\n  movej(j,flange,m)\n  waitEndMove()\n  ? herej()\n  ? config(j)\n  p=here(flange,world)\n  ? \
         p.trsf\n  ? abs(p.trsf.x-380*cos(30))<1e-9",
        "{30,60,100,45}\n{righty}\n{329.08965343809,430,100,180,0,-45}\ntrue\n",
    );
}

/// The tool points down, so an approach along -z is above the point; the circle stays at its height.
#[test]
fn lines_and_circles_lead_to_their_points() {
    check(
        "  j={30,60,100,45}\n  movej(j,flange,m)\n  waitEndMove()\n  p=here(flange,world)\n  \
         movel(appro(p,{0,0,-50,0,0,0}),flange,m)\n  waitEndMove()\n  ? here(flange,world).trsf.z\n  pEnd=p\n  \
         pEnd.trsf.y=pEnd.trsf.y-100\n  p=appro(pEnd,{50,0,0,0,0,0})\n  movel(pEnd,flange,m)\n  waitEndMove()\n  ? \
         distance(here(flange,world),pEnd)<1e-9\n  movec(appro(p,{0,50,0,0,0,0}),appro(pEnd,{100,0,0,0,0,0}),flange,m)\n  \
         waitEndMove()\n  ? \
         abs(distance(here(flange,world),pEnd)-100)<1e-9 and abs(here(flange,world).trsf.z-100)<1e-9\n  ? config(herej())",
        "150\ntrue\ntrue\n{righty}\n",
    );
}

/// Axis 1 with 346.5°/s and 1732.5°/s² is slowest: 90/346.5 + 0.2 s; at 5 %, 90/17.325 + 0.01 s. The screw axis turns
/// by 900° with 1584°/s and 7920°/s².
#[test]
fn joint_moves_take_the_time_of_their_slowest_axis() {
    check(&timed("{0,90,50,0}", "{90,90,100,90}"), "0.46\n");
    check(&format!("  m.vel=5\n{}", timed("{0,90,50,0}", "{90,90,100,90}")), "5.208\n");
    check(&timed("{0,90,50,-450}", "{0,90,50,450}"), "0.772\n");
    // A stroke of 150 mm with 1320 mm/s and 6600 mm/s² does not reach full speed: 2·√(150/6600).
    check(&timed("{0,90,20,0}", "{0,90,170,0}"), "0.304\n");
}

/// Code that prints the time of a joint move.
fn timed(from: &str, to: &str) -> String {
    format!(
        "  j={from}\n  jEnd={to}\n  movej(j,flange,m)\n  waitEndMove()\n  nStart=clock()\n  \
         movej(jEnd,flange,m)\n  waitEndMove()\n  ? clock()-nStart\n"
    )
}

#[test]
fn points_have_a_righty_and_a_lefty_solution() {
    check(
        "  j={30,60,100,45}\n  p=jointToPoint(flange,world,j)\n  ? p.config\n  bFound=pointToJoint(flange,j,p,jEnd)\n  ? \
         bFound and abs(j-jEnd)<{1e-9,1e-9,1e-9,1e-9}\n  p.config.shoulder=lefty\n  \
         bFound=pointToJoint(flange,j,p,jEnd)\n  ? jEnd.j2\n  ? jEnd.j3\n  ? distance(jointToPoint(flange,world,jEnd),p)<1e-9",
        "{righty}\ntrue\n-60\n100\ntrue\n",
    );
}

#[test]
fn the_stroke_and_the_screw_axis_have_limits() {
    check(
        "  ? isInRange({0,0,200,500})\n  ? isInRange({0,0,201,0})\n  ? isInRange({0,0,-1,0})\n  ? \
         isInRange({0,142,0,0})\n  ? isInRange({0,0,0,501})",
        "true\nfalse\nfalse\nfalse\nfalse\n",
    );
}

#[test]
fn corners_make_pick_and_place_faster() {
    for (blend, seconds) in [("off", "0.656"), ("joint", "0.54"), ("Cartesian", "0.564")] {
        check(&cycle(blend), &format!("{seconds}\ntrue\n"));
    }
}

/// Code that prints the time of a pick-and-place cycle.
fn cycle(blend: &str) -> String {
    format!(
        "  j={{-30,70,50,0}}\n  movej(j,flange,m)\n  waitEndMove()\n  p=here(flange,world)\n  pEnd=p\n  \
         pEnd.trsf.y=pEnd.trsf.y+250\n  m.blend={blend}\n  m.leave=30\n  m.reach=30\n  nStart=clock()\n  \
         movel(appro(p,{{0,0,-60,0,0,0}}),flange,m)\n  movej(appro(pEnd,{{0,0,-60,0,0,0}}),flange,m)\n  \
         movel(pEnd,flange,m)\n  waitEndMove()\n  ? clock()-nStart\n  ? distance(here(flange,world),pEnd)<1e-9\n"
    )
}

#[test]
fn a_line_keeps_the_configuration_and_the_reach() {
    let start = "  j={30,60,100,45}\n  movej(j,flange,m)\n  waitEndMove()\n  p=here(flange,world)\n";
    for (wrong, reason) in [
        ("p.config.shoulder=lefty", "cannot change the configuration"),
        ("p.trsf.x=700", "from the shoulder"),
        ("p.trsf.z=250", "axis 3 would be at 250.000, its limits are 0 and 200 mm"),
        ("p.trsf.ry=10", "tilted"),
    ] {
        let run = scara(&format!("{start}  p.trsf.x=p.trsf.x-20\n  {wrong}\n  movel(p,flange,m)\n"));
        assert!(run.code == 1 && run.stderr.contains("error[154]") && run.stderr.contains(reason), "{}", run.stderr);
    }
}

/// Programs read the name of the default arm.
#[test]
fn the_default_arm_has_its_name() {
    let folder = Folder::with("  ? getVersion(\"ArmType\")\n");
    for (kind, name) in [("scara", "ts2_60-S1\n"), ("six-axis", "tx2_90-S1\n")] {
        let run = folder.val3(&["run", "--arm", kind]);
        assert_eq!((run.stdout.as_str(), run.code), (name, 0), "{}", run.stderr);
    }
}

/// The TP80 performs up to 200 picks per minute (assemblymag.com/articles/94544): 25 mm up, 305 mm across, 25 mm down,
/// and back in 0.3 s.
#[test]
fn the_fast_picker_makes_its_published_cycle() {
    let pick = "  movel(pAbove,flange,m)\n  movel(pAbovePlace,flange,m)\n  movel(pPlace,flange,m)\n  \
                movel(pAbovePlace,flange,m)\n  movel(pAbove,flange,m)\n  movel(p,flange,m)\n";
    let places = "pointRs pAbove\npointRs pAbovePlace\npointRs pPlace\n";
    let body = format!(
        "{places}{HEAD}  m={{100,100,100,99999,99999,joint,20,60}}\n  p=here(flange,world)\n  p.trsf={{550,-152.5,60,180,0,0}}\n  \
         pPlace=p\n  pPlace.trsf.y=152.5\n  pAbove=appro(p,{{0,0,-25,0,0,0}})\n  \
         pAbovePlace=appro(pPlace,{{0,0,-25,0,0,0}})\n  movej(p,flange,m)\n  waitEndMove()\n  nStart=clock()\n{}  \
         waitEndMove()\n  ? (clock()-nStart)/10\n",
        pick.repeat(10)
    );
    let run = Folder::with(&body).val3(&["run", "--arm", "TP80", "--start", "0,90,50,0"]);
    let seconds: f64 = run.stdout.trim().parse().unwrap_or_else(|_| panic!("{run:?}"));
    assert!((seconds - 0.3).abs() < 0.03, "{seconds} s");
}
