//! x
use val3_analysis::load::load; use val3_analysis::system::Disk;
fn main() {
    let t = std::time::Instant::now();
    let paths: Vec<_> = std::env::args().skip(1).map(Into::into).collect();
    let ws = load(&Disk, &paths).unwrap();
    let db = &ws.db;
    eprintln!("load {:?}", t.elapsed());
    let units = val3_check::units(db, &ws.projects);
    let found: Vec<_> = val3_check::finish(units.iter().flat_map(|u| val3_check::check_unit(db, *u)).collect());
    eprintln!("check {:?}", t.elapsed());
    for d in &found { let text: &str = d.place.file.text(db); let s = usize::from(d.place.range.start()); let line = 1 + text[..s].matches('\n').count();
      println!("{:?} {} {}:{} {} | {}", d.severity, d.rule.code, d.place.file.path(db), line, d.message, text.lines().nth(line-1).unwrap_or("").trim()); }
    eprintln!("{:?} {}", val3_check::statistics(db, &ws.projects), found.len());
}
