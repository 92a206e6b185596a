//! Listings with a data file, for tests of rules about the arm.

/// A listing with this code, these `<Data>` elements, and the motion descriptor `mX`.
pub(crate) fn listing(code: &str, data: &str) -> String {
    format!(
        "{code}\n\n=== main/main.dtx\n<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<Database \
         xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n{data}    \
         <Data name=\"mX\" access=\"private\" xsi:type=\"array\" type=\"mdesc\" size=\"1\" />\n  \
         </Datas>\n</Database>\n"
    )
}

/// Array element with these values: `0 x="1" fatherId="world[0]"`.
pub(crate) fn data(name: &str, ty: &str, values: &[&str]) -> String {
    let size = values.len();
    let values: String =
        values.iter().enumerate().map(|(key, value)| format!("      <Value key=\"{key}\" {value} />\n")).collect();
    format!(
        "    <Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"{ty}\" size=\"{size}\">\n{values}    \
         </Data>\n"
    )
}
