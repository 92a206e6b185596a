// The application of several tests: it counts, without an arm that moves.
const { Application } = require("./application");

const counter = () => new Application("counter", {
  libraries: {
    tools: {
      data: { "num nCalls": "" },
      programs: `
program square(num x_nValue, num& x_nSquare)
begin
  nCalls=nCalls+1
  x_nSquare=x_nValue*x_nValue
end
`,
    },
  },
  data: { "num nIndex": "", "num nSum": "", "num nSquare": "", "num nMany[20]": "", "string sText": `value="none"` },
  programs: `
program start()
begin
  nSum=0
  // Rounds
  for nIndex=1 to 12
    call add(nIndex,nSum)
    nMany[nIndex]=nSum
    call tools:square(nIndex,nSquare)
  endFor
  sText="done"
  logMsg(sText)
end
program add(num x_nValue, num& x_nTotal)
  num l_nBefore
begin
  l_nBefore=x_nTotal
  x_nTotal=l_nBefore+x_nValue
end
`,
});

module.exports = { counter };
