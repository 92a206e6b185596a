// An application with positions, a long array and a parameter by reference.
const { Application } = require("./application");

const shapes = () => new Application("shapes", {
  data: {
    "frame fPart": `x="100" fatherId="world[0]"`,
    "frame fHole": `rz="90" fatherId="fPart[0]"`,
    "point pHole": `x="1" y="2" z="3" fatherId="fHole[0]"`,
    "joint jHome": `j2="-20" j3="110"`,
    "num nLong[100000]": `value="1"`,
    "num nGrid[2 3]": "",
    "bool bFlag": "",
    "string sName": `value="part"`,
  },
  programs: `
program start()
begin
  pHole.trsf.x=5
  pHole.trsf.y=7
  nGrid[1,2]=12
  call show(4,nGrid[1,2])
end
program show(num x_nCopy, num& x_nCell)
  trsf l_trAt
  num l_nMany[4]
begin
  l_trAt.rz=90
  x_nCell=255
  bFlag=true
end
`,
});

module.exports = { shapes };
