// Cells that the test of the tables writes: one in the s5 format and ISO-8859-1, and one with thousands of points.

const HEAD = '<?xml version="1.0" encoding="iso-8859-1" ?>';
const crlf = (...lines) => [...lines, ""].join("\r\n");

/** Data in the format of s5 controllers. */
const COFFEE = {
  "coffee/coffee.pjx": crlf(HEAD, '<project xmlns="ProjectNameSpace" >', '  <parameters version="s5.3.2" stackSize="5000" millimeterUnit="true" />',
    "  <programSection>", '    <program file="start.pgx" />', '    <program file="stop.pgx" />', "  </programSection>",
    "  <dataSection>", '    <data file="coffee.dtx" />', "  </dataSection>", "  <aliasSection>", "  </aliasSection>", "</project>"),
  "coffee/coffee.dtx": crlf(HEAD, '<dataList xmlns="DataNameSpace" >',
    "  <boolSection>", '    <bool name="bHot" public="false" privilege="0" >', '      <valueBool index="0" value="true" />', "    </bool>", "  </boolSection>",
    "  <dioSection>", '    <dio name="dValve" public="false" privilege="0" size="2" />', "  </dioSection>",
    "  <frameSection>", '    <frame name="fTable" public="false" privilege="0" >', '      <fFather alias="" name="world" fatherIndex="0" />', '      <valueFrame index="0" >',
    '        <tfValue x="100" y="0" z="0" rx="0" ry="0" rz="0" />', "      </valueFrame>", "    </frame>", "  </frameSection>",
    "  <jointSection>", '    <joint name="jHome" public="false" privilege="0" >', '      <valueJoint index="0" >',
    '        <jointValue j1="0" j2="0" j3="90" j4="0" j5="0" j6="0" />', "      </valueJoint>", "    </joint>", "  </jointSection>",
    "  <mdescSection>", '    <mdesc name="mSlow" public="false" privilege="0" >', '      <valueMdesc index="0" >',
    '        <mdescValue accel="100" vel="50" decel="100" tmax="99999" rmax="99999" blend="off" leave="50" reach="50" />', "      </valueMdesc>", "    </mdesc>", "  </mdescSection>",
    "  <numSection>", '    <num name="nCups" public="false" privilege="0" >', '      <valueNum index="0" value="3" />', '      <valueNum index="1" value="4" />', "    </num>", "  </numSection>",
    "  <pointSection>", '    <point name="pCup" public="true" privilege="0" >', '      <pFather alias="" name="fTable" fatherIndex="0" />', '      <valuePoint index="0" >',
    '        <tpValue x="1" y="2" z="3" rx="0" ry="0" rz="0" />', '        <cpValue shoulder="ssame" elbow="esame" wrist="wsame" />', "      </valuePoint>", "    </point>", "  </pointSection>",
    "  <stringSection>", '    <string name="sDrink" public="false" privilege="0" >', '      <valueString index="0" value="café &amp; crème" />', "    </string>", "  </stringSection>",
    "  <toolSection>", '    <tool name="tGrip" public="false" privilege="0" >', '      <tFather alias="" name="flange" fatherIndex="0" />', '      <valueTool index="0" >',
    '        <ttValue x="0" y="0" z="95" rx="0" ry="0" rz="0" />', '        <io alias="" name="dValve" ioIndex="0" open="0" close="0" />', "      </valueTool>", "    </tool>", "  </toolSection>",
    "  <trsfSection />", "</dataList>"),
  "coffee/start.pgx": crlf(HEAD, '<programList xmlns="ProgramNameSpace" >', '  <program name="start" public="false" >', "    <source><code>begin", "  nCups=3", "end", "    </code></source>", "  </program>", "</programList>"),
  "coffee/stop.pgx": crlf(HEAD, '<programList xmlns="ProgramNameSpace" >', '  <program name="stop" public="false" >', "    <source><code>begin", "end", "    </code></source>", "  </program>", "</programList>"),
};

/** Number of points, and of array elements. */
const POINTS = 10000;

const lines = (...lines) => ["\xef\xbb\xbf" + '<?xml version="1.0" encoding="utf-8"?>', ...lines, ""].join("\n");
const program = (name) => lines('<Programs xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Program/2">',
  `  <Program name="${name}">`, "    <Code><![CDATA[begin", "end]]></Code>", "  </Program>", "</Programs>");

const LARGE = {
  "large/large.pjx": lines('<Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">', '  <Parameters version="s7.8.1" stackSize="5000" millimeterUnit="true" />',
    "  <Programs>", '    <Program file="start.pgx" />', '    <Program file="stop.pgx" />', "  </Programs>", "  <Database>", '    <Data file="large.dtx" />', "  </Database>", "  <Libraries />", "  <Types />", "</Project>"),
  "large/large.dtx": lines('<Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">', "  <Datas>",
    '    <Data name="nMany" access="private" xsi:type="array" type="num" size="10000">', '      <Value key="9999" value="1" />', "    </Data>",
    ...Array.from({ length: POINTS }, (_, index) => [`    <Data name="pPoint${index}" access="private" xsi:type="array" type="pointRx" size="1">`,
      `      <Value key="0" x="${index % 1000}" y="${index / 8}" z="400" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="world[0]" />`, "    </Data>"]).flat(),
    "  </Datas>", "</Database>"),
  "large/start.pgx": program("start"),
  "large/stop.pgx": program("stop"),
};

module.exports = { COFFEE, LARGE, POINTS };
