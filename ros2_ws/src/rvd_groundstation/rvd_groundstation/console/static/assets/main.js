import{r as Nm,a as Fm,b as Td,l as ri}from"./index.js";const be={measured:"#7cc4ff",predicted:"#ffb652",truth:"#f2f5f8",target:"#dbe5ee",plain:"#dbe5ee",pilot:"#7cc4ff",automatic:"#d59bf6",sent:"#56d6b0",limit:"#8aa4bd",guide:"#b9c2a0",goal:"#56d6b0",ok:"#56d6b0",alarm:"#ff7a5c",dim:"#8fa1b3",line:"#263544",text:"#dbe5ee"},Oa=!new URLSearchParams(location.search).has("fine")&&/swiftshader|llvmpipe|softpipe|software|basic render/i.test(Om());function Om(){const i=document.createElement("canvas").getContext("webgl2");if(!i)return"software";const t=i.getExtension("WEBGL_debug_renderer_info"),e=String(i.getParameter(t?t.UNMASKED_RENDERER_WEBGL:i.RENDERER));return i.getExtension("WEBGL_lose_context")?.loseContext(),e}function Mn(i,t){i.textContent!==t&&(i.textContent=t)}const ic=new Map;let _a=12;const km=new ResizeObserver(i=>i.forEach(({target:t})=>Ad(t)));function Ad(i){const{width:t,height:e}=i.getBoundingClientRect();ic.set(i,{w:t,h:e}),_a=parseFloat(getComputedStyle(document.documentElement).fontSize)}function ka(i){ic.has(i)||(Ad(i),km.observe(i));const{w:t,h:e}=ic.get(i),n=Math.min(devicePixelRatio||1,2),s=Math.max(1,Math.round(t*n)),r=Math.max(1,Math.round(e*n));(i.width!==s||i.height!==r)&&Object.assign(i,{width:s,height:r});const o=i.getContext("2d",{willReadFrequently:Oa});return o.setTransform(n,0,0,n,0,0),o.clearRect(0,0,t,e),o.font=`${.74*_a}px system-ui, sans-serif`,o.lineWidth=_a/12,{pen:o,w:t,h:e,rem:_a}}function Rd(i,t,e,n,s,r){i.strokeStyle=s,i.setLineDash(r||[]),i.beginPath(),i.arc(t,e,Math.max(n,0),0,7),i.stroke(),i.setLineDash([])}function si(i,t,e,n,s,r="left",o="middle"){i.fillStyle=s,i.textAlign=r,i.textBaseline=o,i.fillText(t,e,n)}const J={title:"RVD console",clocks:"Three clocks",clock_generated:"generated on board",clock_received:"received on the ground",clock_predicted:"predicted for",modes:"Who decides",mode_manual:"Manual",mode_shared:"Shared",mode_auto:"Auto",pause:"Pause",resume:"Resume",abort:"ABORT",abort_hint:"X twice",abort_armed:"again: ABORT",instruments:"Instruments",columns:{measured:"measured",predicted:"predicted",truth:"truth",plain:""},limit:"limit",weight:"pilot weight",scene:"Scene",views:"Views",camera_side:"Camera, delay and charts",ladder:"Command ladder",ladder_alt:"Commands on their way to the craft and back",ladder_ground:"ground",ladder_link:"on the link",ladder_craft:"at the craft",ladder_back:"telemetry on its way back",ladder_known:"known",round_trip:"Round trip",dial_alt:"Dial of the round trip",restart:"New run",review:"Review",settings:"Stick",help:"Help",stop:"Stop run",review_close:"Leave review",play:"Play",stop_play:"Stop",scrub:"Instant of the review",review_title:"Review a run",review_none:"No finished runs here yet: a run is listed once its bag is closed.",review_loading:"Reading the bag…",review_open:"Open",take:"Take the stick",drop:"Release the stick",taken:"Another page has the stick",stick_yours:"You have the stick",stick_held:"stick live",stick_open:"DEAD-MAN OPEN: automatic alone flies",stick_watch:"watching",stick_none:"you are in charge",keyboard:"keyboard",gamepad:"gamepad",pages_one:"1 page",pages:"{n} pages",of:"of",socket_open:"connected",socket_closed:"NOT CONNECTED",idle:"Ready",idle_text:"Take the stick (T), then start a run (N).",starting:"The graph is coming up…",paused:"PAUSED",stale:"STALE",no_telemetry:"no telemetry yet",first_in:"first telemetry in {s} s",pilot_lost:"PILOT LOST: the automatic controller flies alone",stale_frames:"NO DATA FOR {s} s",aborted:"ABORT in force",aborted_so:"ABORT in force: {does}",abort_sent:"ABORT sent, acting in about {s} s",abort_asked:"ABORT: waiting for the answer",abort_unconfirmed:"ABORT NOT CONFIRMED",abort_again:"no answer; asked {n} times, asking again",abort_accepted:"ABORT accepted, goes out with the next frame",abort_untold:"ABORT sent, NOT ACKNOWLEDGED",abort_untold_hint:"sent {s} s ago; telemetry has not told whether it is in force",unconfirmed:"{name} NOT CONFIRMED",unconfirmed_hint:"The run did not answer in 2 s. Try again.",no_webgl:"No WebGL: the scene is drawn in lines",no_storage:"Storage is blocked: settings are not remembered",stick_gone:"GAMEPAD GONE: automatic alone flies",stick_stuck:"NOT AT REST: {axes} counts as 0 until it has been centred",run_failed:"The run could not be flown: see the terminal",verdict_title:"Verdict",verdict_time:"time",fly_again:"Fly again (N)",close:"Close",cancel:"Cancel",start:"Start",seed:"seed",mode:"mode",seed_hint:"empty: the next one",new_run:"New run",new_run_text:"A new run in a new folder. A run under way is stopped.",no_fly:"This console belongs to one run; start it with ./rvd fly --operator console to fly again.",no_page_token:"This page needs the token of the address that the console printed.",no_token_title:"No token",exaggerated:"{axis} scale × {n}",link:{transit:"transit",p99:"p99",lost:"lost",late:"late",corrupted:"damaged",gap:"last gap"},age:"age {s} s",ago:"{s} s ago",ahead:"in {s} s",now:"now",settings_title:"The stick",settings_dead_zone:"dead zone",settings_axis:"axis",settings_invert:"inverted",settings_button:"dead-man button",settings_space:"keyboard: hold Space as dead-man",settings_none:"No gamepad seen. Press a button on it.",settings_pads:"Gamepads",settings_now:"now",pad_notes:{"":"",choose:"Several gamepads: choose one under Stick (G)",setup:"The gamepad must be set up under Stick (G) before it flies"},pad_plain:"no standard mapping",pad_live:"axes {axes} · pressed {buttons}",pad_nothing:"none",pad_choose:"Several gamepads are connected: choose one.",pad_setup:"This gamepad has no standard mapping: its axes and buttons may be anything. It does not fly before each axis and the dead-man button have been set.",pad_ready:"This gamepad is set up.",pad_start:"Set it up step by step",pad_next:"Next",pad_skip:"No such axis",pad_stop:"Stop",pad_rest:"Let go of all its sticks, triggers and buttons, then go on.",pad_move:"Push the stick all the way for {what} ({name}).",pad_back:"Let it go.",pad_trigger:"Axis {axis} does not rest at 0, as a trigger does not: take another.",pad_hold:"Press the button that is to be held while flying.",help_title:"Keys",help_step:"{name} of the keys",or:"or",review_truth:"Review shows the truth. It never reaches this page while a run is flown.",unknown:"–",desk:{door:"Which volunteer? Enter the number you were given; no name is asked or kept.",volunteer:"volunteer number",begin:"Begin",heading:"{who}, flight {n} of {of}",training:"Training: this flight does not count.",counts:"This flight counts.",condition:"Control: {mode}",clock:"The clock starts when the graph is up.",fly:"Start the flight",rest_title:"A break",rest:"Rest your eyes and hands.",go_on:"Go on",done_title:"Finished",done:"Thank you, {who}. All flights are flown and rated.",next:"Next volunteer",yes:"Yes",no:"No",again:"Answer again",pick:"Pick the sentence that fits best.",save:"Save the ratings",weigh:"Which of the two contributed more to the workload of flying in this way?",pair:"pair {n} of {of}",tree:{controllable:"Was the craft controllable?",adequate:"Was adequate performance ({goal}) attainable with a tolerable pilot workload?",satisfactory:"Was it satisfactory without improvement?"},ratings:["","Excellent, highly desirable: compensation not a factor","Good, negligible deficiencies: compensation not a factor","Fair, some mildly unpleasant deficiencies: minimal compensation","Minor but annoying deficiencies: moderate compensation","Moderately objectionable deficiencies: considerable compensation","Very objectionable but tolerable deficiencies: extensive compensation","Major deficiencies: adequate performance not attainable with maximum tolerable compensation","Major deficiencies: considerable compensation needed for control","Major deficiencies: intense compensation needed to retain control","Major deficiencies: control lost during some part of the flight"],tlx:{mental:["Mental demand","How mentally demanding was the flight?","very low","very high"],physical:["Physical demand","How physically demanding was the flight?","very low","very high"],temporal:["Temporal demand","How hurried or rushed was the pace?","very low","very high"],performance:["Performance","How successful were you in doing what you were asked to do?","perfect","failure"],effort:["Effort","How hard did you have to work for your level of performance?","very low","very high"],frustration:["Frustration","How insecure, discouraged, irritated, stressed and annoyed were you?","very low","very high"]},errors:{VOLUNTEER:"A whole number from 1 to 999, please.",STAGE:"Not now.",RATING:"The rating is incomplete.",TLX:"Please set every scale.",WEIGHTS:"Please choose in every pair."}}},Bm=[["T","take or release the stick"],["Space","dead-man, if so chosen under Stick"],["M","{modes} in turn"],["P","pause, resume"],["X X","ABORT, past every buffer{abort}"],["N","new run"],["V","next view"],["+ − [ ]","zoom and turn the scene"],["L","review a run"],["G","stick settings"],["?","this list"],["Esc","close"],["","A key that is released commands zero. Without focus, without this page, or with the dead-man open, there is no pilot: the automatic controller flies alone."]],zm={ArrowUp:"↑",ArrowDown:"↓",ArrowLeft:"←",ArrowRight:"→"},Hm=["nobody","pilot","automatic","blend","guard"],ph=["","nothing due","wrong length","checksum","out of order","too old","out of range","an input was missing","as the mode says","stick invalid: automatic alone","automatic invalid: counts as neutral","neither valid: neutral","ABORT in force"],Gm=["sent","due","executed","effect seen","refused","missed","unknown"],Vm={LEASE:"Take the stick first (T).",TAKEN:"Another page has the stick.",NO_RUN:"No run is under way.",NO_FLY:J.no_fly,NO_ANSWER:"The run did not answer.",DESK:"The session says what is flown.",MODE:"No such mode.",SEED:"The seed must be a whole number."};function De(i,t){return i.replace(/\{(\w+)\}/g,(e,n)=>t[n])}const yo={"+x":[1,0,0],"-x":[-1,0,0],"+y":[0,1,0],"-y":[0,-1,0],"+z":[0,0,1],"-z":[0,0,-1]};function _i(i,t){const e=i?.signals[t];return e?.ok?e:void 0}function Cr(i,t){return t?_i(i,t.signal)?.parts[t.part]??void 0:void 0}const Cd=(i,t)=>Array.isArray(i)?i[t]:i;function Ui(i,{signal:t,part:e,index:n,factor:s}){const r=_i(i,t)?.parts[e];if(r==null)return;const o=n.map(a=>Cd(r,a));if(!o.some(a=>a==null))return s*(o.length===1?o[0]:Math.hypot(...o))}function Pr(i,t){return t!==null&&typeof t=="object"?Ui(i,t):t??void 0}function Pd(i,t="xyz"){if(i==null)return;const e=[0,0,0];for(let n=0;n<t.length;n+=1){const s=Cd(i,n);if(s==null)return;e["xyz".indexOf(t[n])]=s}return e}function Ii(i,t,e){return Array.isArray(t)?t:Pd(Cr(i,t),e)}function Ci(i,t){const e=yo[i];return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}class Ld{constructor(t,e){this.display=t,this.keep=e,this.trails=new Map;for(const n of t?.lines||[])n.kind==="trail"&&this.trails.set(n.name,[]);this.charts=(t?.charts?.strips||[]).map(n=>({t:[],curves:n.curves.map(()=>[]),spread:[]}))}begin(t){for(const e of this.display.lines)for(const n of t?.[e.name]||[]){const s=Pd(n.slice(2,-1),e.axes);s&&this.trails.get(e.name).push([n[0],n[1],...s,n[n.length-1]??0])}}add(t){for(const e of this.display.lines)e.kind==="trail"&&this.extend(e,t);this.display.charts?.strips.forEach((e,n)=>this.plot(e,this.charts[n],t))}extend(t,e){const n=this.trails.get(t.name),s=Ii(e,t.place,t.axes);if(!s||n.length&&e.t<=n[n.length-1][0])return;const r=t.spread?Ui(e,t.spread)??0:0;n.push([e.t,e.signals[t.place.signal].t,...s,r]),n.length>this.keep&&n.shift()}plot(t,e,n){const s=_i(n,t.curves[0].signal);if(!s||s.t<=(e.t[e.t.length-1]??-1/0))return;e.t.push(s.t),t.curves.forEach((o,a)=>e.curves[a].push(Ui(n,o)??null));const r=t.spread?Ui(n,t.spread):void 0;e.spread.push(r===void 0?null:r*t.spread_factor)}}function Wm(i,t,e,n,s){let r=t.length;for(;r>0&&t[r-1][0]>n;)r-=1;if(!i.since)return{rows:t,at:2,n:r};const o=_i(e,i.since.signal),a=Ii(e,i.place,i.axes),l=Ii(e,i.since,i.axes);if(!o||!a||!l)return{rows:[],at:0,n:0};let c=r;for(;c>0&&t[c-1][1]>o.t;)c-=1;const u=[[...l,i.since_spread?Ui(e,i.since_spread)??0:0]],h=Math.max(1,Math.floor((r-c)/s));for(let f=c;f<r;f+=h)u.push(t[f].slice(2));return u.push([...a,i.spread?Ui(e,i.spread)??0:0]),{rows:u,at:0,n:u.length}}const je=i=>document.getElementById(i),Xm=4,$m=["measured","predicted","truth","plain"];function pn(i,t){return i==null||!Number.isFinite(i)?J.unknown:i.toFixed(t).replace("-","−")}const Fo=(i,t,e)=>typeof i=="number"?String(i).replace("-","−"):pn(t,e);function Dd(i,{low:t,high:e},n){const[s,r]=[Pr(i,t),Pr(i,e)];return s===void 0&&r===void 0?"":r===void 0?`> ${Fo(t,s,n)}`:s===void 0?`< ${Fo(e,r,n)}`:`${Fo(t,s,n)}…${Fo(e,r,n)}`}class qm{setDisplay(t){const e=t.instruments;if(je("instruments").hidden=!e,this.rows=[],!e)return;je("instruments-title").textContent=e.title;const n=$m.filter(r=>e.rows.some(o=>o.readings.some(a=>a.role===r)));je("instruments").style.setProperty("--columns",n.length);const s=ti("div","head");s.append(...[["",""],...n.map(r=>[J.columns[r],r]),["",""],[J.limit,"dim"]].map(([r,o])=>ti("span",o,r))),je("instruments-rows").replaceChildren(s,...e.rows.map(r=>{const o=ti("div","row"),a=new Map(n.map(c=>[c,ti("b",c)])),l=ti("u");return o.append(ti("span","",r.label),...a.values(),ti("u","unit",r.unit),l),this.rows.push({row:r,cells:a,limit:l}),o}))}show(t,e){for(const{row:n,cells:s,limit:r}of this.rows){let o="";for(const a of n.readings){const l=Ui(t,a.value),c=s.get(a.role);Mn(c,pn(l,n.digits)),c.classList.toggle("stale-value",e&&a.role==="measured"),c.classList.toggle("bad",l<=Pr(t,a.low)||l>=Pr(t,a.high)),o=Dd(t,a,n.digits)||o}Mn(r,o)}}}function ti(i,t="",e=""){const n=document.createElement(i);return t&&(n.className=t),n.textContent=e,n}function Ym(i){je("cut").hidden=!i,i&&(je("section-title").textContent=i.title,je("section").setAttribute("aria-label",i.alt),je("foot").hidden=!i.foot,i.foot&&(je("foot-label").textContent=i.foot.label))}const Ud={dot(i,t,e,n,s){i.fillStyle=n,i.beginPath(),i.arc(t,e,s*.3,0,7),i.fill()},ring(i,t,e,n,s,r){i.fillStyle=`${n}30`,i.beginPath(),i.arc(t,e,Math.max(s*.3,r),0,7),i.fill(),i.stroke()},cross(i,t,e,n,s){const r=s*.32;i.beginPath(),i.moveTo(t-r,e-r),i.lineTo(t+r,e+r),i.moveTo(t-r,e+r),i.lineTo(t+r,e-r),i.stroke()},square(i,t,e,n,s){i.strokeRect(t-s*.35,e-s*.35,s*.7,s*.7)}};function Km(i,t){const{pen:e,w:n,h:s,rem:r}=ka(je("section")),[o,a]=[n/2,s/2],l=Math.min(n,s)/2-.9*r;e.strokeStyle=be.line,e.beginPath(),e.moveTo(o-l,a),e.lineTo(o+l,a),e.moveTo(o,a-l),e.lineTo(o,a+l),e.stroke(),sc(i.note?Cr(t,i.note):["",!1],je("section-note"),"dim"),i.foot&&sc(Cr(t,i.foot.words),je("foot-words"));const c=Pr(t,i.extent_m);if(!c)return;const u=l/c;for(const f of i.rings){const d=Pr(t,f.radius_m);d!==void 0&&(Rd(e,o,a,d*u,be[f.role],f.dashed?[r*.3,r*.25]:null),f.written&&si(e,`${d.toFixed(2)} m`,o+d*u*.72,a-d*u*.72-r*.3,be[f.role]))}si(e,mh(i.up),o+r*.3,a-l,be.dim),si(e,mh(i.right),o+l,a-r*.6,be.dim,"right");const h=f=>[o+Ci(i.right,f)*u,a-Ci(i.up,f)*u];for(const f of i.spots){const d=Ii(t,f.place);if(!d)continue;const g=be[f.role],[v,m]=h(d);e.strokeStyle=g;const p=f.origin&&Ii(t,f.origin);p&&(e.setLineDash([r*.2,r*.2]),e.beginPath(),e.moveTo(...h(p)),e.lineTo(v,m),e.stroke(),e.setLineDash([])),Ud[f.mark](e,v,m,g,r,f.spread?(Ui(t,f.spread)??0)*u:0);const E=f.rate&&Ii(t,f.rate);if(E){const T=f.ahead_s*u;e.beginPath(),e.moveTo(v,m),e.lineTo(v+Ci(i.right,E)*T,m-Ci(i.up,E)*T),e.stroke()}}}const mh=i=>i.replace("+","").replace("-","−");function sc(i,t,e=""){const[n,s]=i||[J.unknown,!1];Mn(t,n),t.className=s?"alarm":e}function rc(i,t){const e=i.toFixed(t).replace("-","−");return i>0?`+${e}`:e}function jm(i){const t=ti("div","bar");return t.append(document.createElement("i"),document.createElement("span")),t.firstChild.style.background=i,t}class Zm{setDisplay({commands:t}){this.commands=t,je("commands-title").textContent=t.unit?`${t.title}, ${t.unit}`:t.title;const e=t.axes.map(r=>ti("span","dim",r.name)),n=t.rows.map(r=>ti("span",r.role==="automatic"?"auto":"",r.label));this.rows=t.rows.map(r=>({row:r,bars:t.axes.map(()=>jm(be[r.role]))}));const s=e.length<=Xm?[[ti("span"),...e],...this.rows.map(({bars:r},o)=>[n[o],...r])]:[[ti("span"),...n],...e.map((r,o)=>[r,...this.rows.map(({bars:a})=>a[o])])];je("bars").style.setProperty("--columns",s[0].length-1),je("bars").replaceChildren(...s.flat())}show(t){const e=t.signals[this.commands.sent];for(const{row:s,bars:r}of this.rows){const a=(s.value.signal===this.commands.sent?e:_i(t,s.value.signal))?.parts[s.value.part];this.commands.axes.forEach((l,c)=>this.bar(r[c],a?.[c]??null,l.highest))}const n=e?[Hm[e.parts.by]]:[];e&&e.parts.weight!==null&&e.parts.by===3&&n.push(`${J.weight} ${e.parts.weight}`),e&&ph[e.parts.reason]&&n.push(ph[e.parts.reason]),Mn(je("why"),n.join(" · "))}bar(t,e,n){const s=Math.min(Math.abs(e||0)/n,1)*48;t.firstChild.style.left=`${e<0?50-s:50}%`,t.firstChild.style.width=`${s}%`,Mn(t.lastChild,e===null?J.unknown:rc(e,this.commands.digits))}}function fl(i,t,e,n){const s=je(`clock-${i}`);Mn(s,t===void 0?J.unknown:`${pn(t,1)} s`),Mn(je(`clock-${i}-age`),e),s.parentElement.classList.toggle("stale",!!n)}function Jm(i,t,e,n){const{pen:s,w:r,h:o,rem:a}=ka(i),[l,c,u]=[r/2,o*.56,Math.min(r/2,o*.56)-a*.5],h=t.forward_s+t.back_s,f=Math.max(h*1.5,1),d=v=>Math.PI*(.8+1.4*Math.max(0,Math.min(1,v/f)));s.lineWidth=a*.45,s.strokeStyle="#1b2733",s.beginPath(),s.arc(l,c,u,d(0),d(f)),s.stroke(),e!==void 0&&(s.strokeStyle=e>h+1?be.alarm:be.measured,s.beginPath(),s.arc(l,c,u,d(0),d(e)),s.stroke()),n&&(s.lineWidth=a*.16,s.strokeStyle=be.guide,s.beginPath(),s.arc(l,c,u-a*.5,d(0),d(n)),s.stroke()),s.strokeStyle=be.text,s.lineWidth=a*.12;const g=d(h);s.beginPath(),s.moveTo(l+(u-a*.4)*Math.cos(g),c+(u-a*.4)*Math.sin(g)),s.lineTo(l+(u+a*.4)*Math.cos(g),c+(u+a*.4)*Math.sin(g)),s.stroke(),s.font=`600 ${1.35*a}px system-ui, sans-serif`,si(s,e===void 0?J.unknown:`${e.toFixed(1)} s`,l,c-a*.05,be.text,"center"),s.font=`${.7*a}px system-ui, sans-serif`,si(s,`${t.forward_s} + ${t.back_s} s`,l,c+a*1.05,be.dim,"center")}function Qm(i,t,e){const{link:n,gap:s}=i,r=[[J.link.transit,t?`${pn(t.transit,2)} s`:J.unknown]];n&&r.push([J.link.p99,`${pn(n.delay_p99,2)} s`],[J.link.lost,n.lost+n.outage],[J.link.late,n.late],[J.link.corrupted,n.corrupted]),r.push([J.link.gap,s?De(J.ago,{s:pn((i.k-s.k)*e,0)}):J.unknown]);const o=r.map(([a,l])=>`<dt>${a}</dt><dd>${l}</dd>`).join("");je("link-counts").innerHTML!==o&&(je("link-counts").innerHTML=o)}function tg(i,t,e,n){const{pen:s,w:r,h:o,rem:a}=ka(i),[l,c]=[r/2,o/2];s.strokeStyle="#dbe5ee90",s.beginPath(),s.moveTo(l-r*.3,c),s.lineTo(l-a,c),s.moveTo(l+a,c),s.lineTo(l+r*.3,c),s.moveTo(l,c-o*.36),s.lineTo(l,c-a),s.moveTo(l,c+a),s.lineTo(l,c+o*.36);for(let d=-3;d<=3;d+=1)d&&(s.moveTo(l+d*r*.1,c-a*.25),s.lineTo(l+d*r*.1,c+a*.25));s.stroke();const u=t.known(e.carried_by);if(!u)return;const h=u.item.role==="truth";for(const d of e.marks){const g=Ii(n,d.at),v=g&&!(h&&d.role==="predicted")&&t.onCamera(g);if(!v)continue;const m=be[d.role],[p,E]=[l+v[0]*r/2,c-v[1]*o/2];if(s.strokeStyle=m,d.radius_m===null){Ud.square(s,p,E,m,a);continue}const T=Math.max(Ci(e.look,g)-Ci(e.look,u.at),.05);Rd(s,p,E,Math.min(d.radius_m/T/t.cameraTan*(o/2),o),m),s.strokeStyle=`${m}80`,s.beginPath(),s.moveTo(l,c),s.lineTo(p,E),s.stroke()}e.gauge&&eg(s,r,o,a,e.gauge,n,h);const f=e.distance.map(d=>Ui(n,d.value)).find(d=>d!==void 0);f!==void 0&&si(s,`${pn(f,e.digits)} ${e.unit}`,a*.6,o-a*.9,be.measured)}function eg(i,t,e,n,s,r,o){const[a,l,c]=[t-n*2.9,n*1.5,e-n*1.2],{low:u,high:h}=s,f=d=>c-(Math.max(u,Math.min(h,d))-u)/(h-u)*(c-l);i.strokeStyle="#dbe5eea0",i.beginPath(),i.moveTo(a,l),i.lineTo(a,c);for(let d=0;u+d*s.tick<=h+1e-9;d+=1){const g=f(u+d*s.tick),v=d%s.long_ticks===0;i.moveTo(a,g),i.lineTo(a+n*(v?.5:.25),g),v&&si(i,pn(u+d*s.tick,s.digits),a+n*.65,g,be.text)}i.stroke(),s.limit!==null&&(i.strokeStyle=be.alarm,i.beginPath(),i.moveTo(a-n*.5,f(s.limit)),i.lineTo(a+n*.5,f(s.limit)),i.stroke());for(const{role:d,value:g}of s.readings){const v=Ui(r,g);if(v===void 0||o&&d!=="truth")continue;const m=f(v),p=be[d==="truth"?"measured":d];i.beginPath(),i.moveTo(a-n*.1,m),i.lineTo(a-n*.75,m-n*.36),i.lineTo(a-n*.75,m+n*.36),i.closePath(),d==="predicted"?(i.strokeStyle=p,i.stroke()):(i.fillStyle=p,i.fill())}si(i,s.unit,a,l-n*.7,be.dim,"center")}const vo=()=>document.getElementById("dialog");function Vs(i,t){const e=vo();e.innerHTML=i,e.open||e.showModal();for(const n of e.querySelectorAll("[data-close]"))n.onclick=()=>e.close();return t&&t(e),e}function hu(){vo().open&&vo().close()}const Eo=`<button data-close>${J.close}</button>`;function $e(i){const t=document.createElement("span");return t.textContent=i,t.innerHTML}function fu(i,t){Vs(`<h3>${$e(i)}</h3><p>${$e(t)}</p><div class="buttons">${Eo}</div>`)}const ng=i=>zm[i]||i.replace(/^Key/,"");function ig(i){const t=i?.controller,e=(t?.axes||[]).map(s=>[s.keys.map(r=>r.map(ng).join(" / ")).join(` ${J.or} `),`${t.verb} ${s.positive} / ${s.negative} (${s.name})`]),n=t?.key_deflections.length||0;return n>1&&e.push([Array.from({length:n},(s,r)=>r+1).join(" "),De(J.help_step,{name:t.step_name})]),e}function Id(i){const t=(i?.modes||[]).map(a=>J[`mode_${a}`].toLowerCase()).join(", "),e=i?.abort?`: ${i.abort}`:"",[[n,s],...r]=Bm.map(([a,l])=>[a,De(l,{modes:t,abort:e})]),o=[[n,s],...ig(i),...r].map(([a,l])=>a?`<tr><td><kbd>${$e(a)}</kbd></td><td>${$e(l)}</td></tr>`:`<tr><td colspan="2">${$e(l)}</td></tr>`);Vs(`<h3>${J.help_title}</h3><table>${o.join("")}</table><div class="buttons">${Eo}</div>`)}function du(i){return Vm[i]||i}function sg(i,t){if(!i.can.fly){fu(J.new_run,J.no_fly);return}const e=i.display?.modes||[],n=i.frame?.mode||i.run?.mode||"shared",s=e.map(r=>`<option value="${r}" ${r===n?"selected":""}>${J[`mode_${r}`]}</option>`);Vs(`<h3>${J.new_run}</h3><p>${J.new_run_text}</p>
    <p>${e.length?`<label>${J.mode} <select id="new-mode">${s.join("")}</select></label> &nbsp;`:""}
    <label>${J.seed} <input id="new-seed" size="15" inputmode="numeric" placeholder="${J.seed_hint}"></label></p>
    <p id="new-error" class="alarm"></p>
    <div class="buttons"><button data-close>${J.cancel}</button><button class="primary" id="new-start">${J.start}</button></div>`,r=>{const o=async()=>{const a=r.querySelector("#new-seed").value.trim(),l={do:"fly",mode:r.querySelector("#new-mode")?.value??null};a&&(l.seed=Number(a));const c=await t(l);c.ok?r.close():r.querySelector("#new-error").textContent=du(c.code)};r.querySelector("#new-start").onclick=o,r.querySelector("#new-seed").onkeydown=a=>{a.key==="Enter"&&o()},r.querySelector("#new-start").focus()})}function rg(i,t,e){const n=i.success,s=(o,a,l,c)=>`<tr><th>${$e(o)}</th><td class="${c===!1?"alarm":""}">${$e(a)}</td><td class="dim">${$e(l)}</td></tr>`,r=i.measures.filter(o=>o.value!==null).map(o=>s(o.words,`${pn(o.value,o.digits)} ${o.unit}`,Dd(null,o,o.digits),o.ok));Vs(`<h3>${J.verdict_title}</h3>
    <p class="verdict ${n?"ok":"alarm"}" id="verdict-words">${n?"✓":"✗"} ${$e(bo(i.words))}</p>
    <table>${s(J.verdict_time,`${pn(i.duration,1)} s`,"",null)}${r.join("")}</table>
    <div class="buttons">${Eo}${t?`<button class="primary" id="again">${J.fly_again}</button>`:""}</div>`,o=>{const a=o.querySelector("#again");a&&(a.onclick=()=>{o.close(),e()})})}function og(){return vo().open&&vo().querySelector("#runs")!==null}const bo=i=>i.charAt(0).toUpperCase()+i.slice(1);function ag(i,t){const e=i.map(n=>`<tr><td>${$e(n.name)}</td><td>${$e(n.mode||"")}</td>
    <td class="${n.success?"ok":""}">${n.success?"✓":"✗"} ${$e(bo((n.reason||"").replaceAll("_"," ")))}</td>
    <td><button data-run="${$e(n.name)}">${J.review_open}</button></td></tr>`);Vs(`<h3 id="runs">${J.review_title}</h3><p class="dim">${J.review_truth}</p>
    ${i.length?`<table>${e.join("")}</table>`:`<p>${J.review_none}</p>`}
    <p id="review-error" class="alarm"></p><div class="buttons">${Eo}</div>`,n=>{for(const s of n.querySelectorAll("[data-run]"))s.onclick=()=>t(s.dataset.run,n.querySelector("#review-error"))})}const ye=J.desk,lg=5;class cg{constructor(t){this.link=t,this.task={hint:"",goal:""},this.state=null,this.mine=!1}show(t,e){const n=!this.state||JSON.stringify({...this.state,rest_s:0})!==JSON.stringify({...t,rest_s:0});this.state=t,this.mine=e,n&&this.draw()}lease(t){t!==this.mine&&(this.mine=t,this.state&&this.draw())}draw(){if(clearInterval(this.timer),!this.mine)return;const t=this.state.stage;t==="flying"?hu():this[t]()}async ask(t,e,n){const s=await this.link.ask({do:"desk",act:t,...e}),r=n?.querySelector(".error");return!s.ok&&r&&(r.textContent=ye.errors[s.code]||du(s.code)),s.ok}frame(t,e,n,s){const r=Vs(`<h3>${$e(t)}</h3>${e}<p class="error alarm" role="alert"></p><div class="buttons">${n}</div>`,s);return r.oncancel=o=>o.preventDefault(),r}door(){this.frame(this.state.title,`<p>${ye.door}</p><p><label>${ye.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,`<button class="primary" id="desk-go">${ye.begin}</button>`,t=>{const e=()=>this.ask("begin",{volunteer:Number(t.querySelector("#volunteer").value)},t);t.querySelector("#desk-go").onclick=e,t.querySelector("#volunteer").onkeydown=n=>{n.key==="Enter"&&e()},t.querySelector("#volunteer").focus()})}heading(){return De(ye.heading,{who:this.state.who,n:this.state.number,of:this.state.of})}ready(){const t=this.state.training?ye.training:ye.counts;this.frame(this.heading(),`<p>${t}</p><p>${De(ye.condition,{mode:J[`mode_${this.state.mode}`]})}</p><p class="dim">${$e(this.task.hint)} ${ye.clock}</p>`,`<button class="primary" id="desk-go">${ye.fly}</button>`,e=>{e.querySelector("#desk-go").onclick=()=>this.ask("fly",{},e),e.querySelector("#desk-go").focus()})}rest(){const t=performance.now()+this.state.rest_s*1e3;this.frame(ye.rest_title,`<p>${ye.rest}</p><p class="verdict" id="rest-left"></p>`,`<button class="primary" id="desk-go">${ye.go_on}</button>`,e=>{const n=e.querySelector("#desk-go");n.onclick=()=>this.ask("go_on",{},e);const s=()=>{const r=Math.max(0,(t-performance.now())/1e3);e.querySelector("#rest-left").textContent=`${r.toFixed(0)} s`,n.disabled=r>0};s(),this.timer=setInterval(s,500)})}done(){this.frame(ye.done_title,`<p>${De(ye.done,{who:this.state.who})}</p>`,`<button id="desk-go">${ye.next}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("leave",{},t)})}rate(){this.answers={},this.question("controllable")}question(t){const{verdict:e}=this.state,n=`<button data-answer="yes">${ye.yes}</button><button data-answer="no">${ye.no}</button>`;this.frame(`${this.heading()} · Cooper-Harper`,`<p class="${e.success?"ok":""}">${$e(bo(e.words||""))}</p><p>${$e(De(ye.tree[t],{goal:this.task.goal}))}</p>`,n,s=>{s.querySelector("[data-answer=yes]").focus();for(const r of s.querySelectorAll("[data-answer]"))r.onclick=()=>this.answered(t,r.dataset.answer==="yes")})}answered(t,e){const n=["controllable","adequate","satisfactory"];if(this.answers[t]=e,!e)for(const r of n.slice(n.indexOf(t)+1))this.answers[r]=!1;const s=n[n.indexOf(t)+1];e&&s?this.question(s):this.pick()}pick(){const{controllable:t,adequate:e,satisfactory:n}=this.answers,r=(t?e?n?[1,2,3]:[4,5,6]:[7,8,9]:[10]).map(o=>`<button data-rating="${o}"><b>${o}</b> ${ye.ratings[o]}</button>`).join("");this.frame(`${this.heading()} · Cooper-Harper`,`<p>${ye.pick}</p><div class="choices">${r}</div>`,`<button id="desk-back">${ye.again}</button>`,o=>{o.querySelector("#desk-back").onclick=()=>this.rate();for(const a of o.querySelectorAll("[data-rating]"))a.onclick=()=>{this.answers.rating=Number(a.dataset.rating),this.tlx()};o.querySelector("[data-rating]").focus()})}tlx(){const t=Object.entries(ye.tlx).map(([e,[n,s,r,o]])=>`<fieldset><legend>${n}</legend>
      <label for="tlx-${e}">${s}</label><input type="range" id="tlx-${e}" data-tlx="${e}" min="0" max="100" step="${lg}" value="50">
      <div class="scale-ends"><span>${r}</span><output id="out-${e}">–</output><span>${o}</span></div></fieldset>`).join("");this.frame(`${this.heading()} · NASA-TLX`,t,`<button class="primary" id="desk-go" disabled>${ye.save}</button>`,e=>{const n=new Set,s=r=>{n.add(r.dataset.tlx),e.querySelector(`#out-${r.dataset.tlx}`).textContent=r.value,e.querySelector("#desk-go").disabled=n.size<Object.keys(ye.tlx).length};for(const r of e.querySelectorAll("[data-tlx]"))r.oninput=()=>s(r),r.onkeydown=o=>{o.key==="Enter"&&s(r)},r.onpointerup=()=>s(r);e.querySelector("#desk-go").onclick=()=>{const r=Object.fromEntries([...e.querySelectorAll("[data-tlx]")].map(o=>[o.dataset.tlx,Number(o.value)]));this.ask("rate",{cooper_harper:this.answers,tlx:r},e)}})}weigh(t=[]){const{pairs:e}=this.state,n=e[t.length].map(r=>`<button data-scale="${r}"><b>${ye.tlx[r][0]}</b> ${ye.tlx[r][1]}</button>`).join(""),s=`${this.heading()} · NASA-TLX · ${De(ye.pair,{n:t.length+1,of:e.length})}`;this.frame(s,`<p>${ye.weigh}</p><div class="choices">${n}</div>`,`<button id="desk-back">${ye.again}</button>`,r=>{r.querySelector("#desk-back").onclick=()=>this.weigh();for(const o of r.querySelectorAll("[data-scale]"))o.onclick=()=>{const a=[...t,o.dataset.scale];a.length<e.length?this.weigh(a):this.ask("weigh",{chosen:a},r)};r.querySelector("[data-scale]").focus()})}}const[pu,Nd,Ba,xo,mu,gu,_u]=[0,1,2,3,4,5,6],br=3,Fd=6,gh={[Ba]:"✓",[xo]:"✓",[mu]:"✗",[gu]:"✗",[_u]:"?"};function Od([i,t,e,n,s,r,o,...a]){return{seq:i,sent:t,due:e,kind:n,state:s,refusal:r,told:o,value:a}}function ug(i,t){return i.told>=0&&i.told<=t?i:{...i,state:t<i.due?pu:Nd,told:-1}}const hg=i=>i.kind===br&&(i.state===Ba||i.state===xo);function fg(i,t,e){const n=e.step_s,s=Math.max(i.due-i.sent,1);if(i.told>=0)return .8+.2*Math.min(1,(t-i.told)*n/Fd);if(t<i.due)return .05+.37*((t-i.sent)/s);const r=Math.max(e.back_s/n,1);return .46+.34*Math.min(1,(t-i.due)/r)}function dg(i,t,e,n,s){const{pen:r,w:o,h:a,rem:l}=ka(i),c=s/t.step_s,u=l*1.35,h=[[0,.05,J.ladder_ground],[.05,.42,J.ladder_link],[.42,.5,J.ladder_craft],[.5,.8,J.ladder_back],[.8,1,J.ladder_known]];for(const[v,m,p]of h)r.fillStyle=p===J.ladder_craft?"#17222e":"#0a1018",r.fillRect(v*o+1,u,(m-v)*o-2,a-u),v!==0&&si(r,p,(v+m)/2*o,l*.55,be.dim,"center");si(r,J.ladder_ground,0,l*.55,be.dim);const f=(a-u)/e.length;e.forEach((v,m)=>si(r,v.name,l*.35,u+f*(m+.5),be.dim));const d=Math.max(2,.37*o/Math.max(t.forward_s/t.step_s,8)-1),g={top:u,lane:f,bottom:a,width:Math.min(d,l),rem:l};for(const v of n){const m=fg(v,c,t);m>=1||v.told>=0&&(c-v.told)*t.step_s>Fd||pg(r,v,m*o,e,g)}}function pg(i,t,e,n,{top:s,lane:r,bottom:o,width:a,rem:l}){const c=t.state===mu||t.state===gu,u=t.value.some(f=>f!==0),h=t.kind===br||c?be.alarm:t.state===xo||t.state===Ba?be.ok:t.state===_u?be.dim:t.state===Nd?be.predicted:be.measured;if(i.fillStyle=h,!u&&!c&&t.kind!==br){i.globalAlpha=t.state===xo?.25:.5,n.forEach((f,d)=>i.fillRect(e,s+r*(d+.5)-1,Math.max(a*.5,1),2)),i.globalAlpha=1;return}(t.kind===br||c)&&i.fillRect(e,s,Math.max(1.5,a*.4),o-s),n.forEach((f,d)=>{const g=t.value[d];if(!g)return;const v=Math.min(Math.abs(g)/f.highest,1)*r*.46,m=s+r*(d+.5);t.state===pu&&(i.globalAlpha=.85),i.fillRect(e,g>0?m-v:m,a,v),i.globalAlpha=1}),gh[t.state]&&c&&si(i,gh[t.state],e,s+l*.4,h)}function mg(i){const t={};for(const s of i)t[s.state]=(t[s.state]||0)+1;const n=[`${t[pu]||0} ${J.ladder_link}`];for(const s of[Ba,xo,mu,gu,_u])t[s]&&n.push(`${t[s]} ${Gm[s]}`);return n.join(" · ")}const _h=2500,gg=500,_g=800,vg=8e3,xg=i=>new Promise(t=>{setTimeout(t,i)});class Mg{constructor(t,e){Object.assign(this,{link:t,store:e,wanted:null,unanswered:null})}async steer(t){this.unanswered=null,(await this.link.ask({...t,run:this.store.run?.name},_h)).code==="NO_ANSWER"&&(this.unanswered={wish:t,at:performance.now()})}async abort(){const t=this.store.run?.name;if(this.wanted&&!this.wanted.accepted&&this.goesOn(this.wanted))return;const e={run:t,times:0,since:performance.now(),accepted:!1};this.wanted=e;do{e.times+=1;const n=await this.link.ask({do:"abort",run:t},_h);e.accepted=n.ok,n.ok||await xg(gg)}while(!e.accepted&&this.goesOn(e))}goesOn({run:t}){const{store:e}=this;return e.run!==null&&e.run.name===t&&!e.verdict&&(e.status.phase==="flying"||!e.connected)}words(){const{store:t,wanted:e,unanswered:n}=this,s=t.connected?"":`${J.socket_closed}. `;if(e&&!this.goesOn(e))this.wanted=null;else{if(e&&!e.accepted)return performance.now()-e.since<_g?[J.abort_asked,""]:[J.abort_unconfirmed,s+De(J.abort_again,{n:e.times})];if(e&&t.abortAt===null&&t.connected)return[J.abort_accepted,t.frame?.paused?J.paused:""]}if(!n||performance.now()-n.at>vg||this.done(n.wish))return null;const r=n.wish.do==="mode"?J[`mode_${n.wish.mode}`]:J[n.wish.do];return[De(J.unconfirmed,{name:r.toUpperCase()}),s+J.unconfirmed_hint]}done(t){const{frame:e,verdict:n,connected:s}=this.store;return n?!0:!e||!s?!1:t.do==="mode"?e.mode===t.mode:!!e.paused==(t.do==="pause")}}const Sg=20,yg=4,kd="rvd.stick",Aa=-1;function Eg(i,t){if(!Number.isFinite(i))return 0;const e=Math.min(Math.abs(i),1);return e<=t?0:Math.sign(i)*(e-t)/(1-t)}class bg{constructor(t){this.onChange=t,this.down=new Set,this.step=1,this.source="keyboard",this.pads=[],this.gamepad=null,this.settingUp=!1,this.settings=Tg(),this.setController(null),addEventListener("keydown",n=>this.key(n,!0)),addEventListener("keyup",n=>this.key(n,!1));const e=()=>{this.down.clear(),this.send(!0)};addEventListener("blur",e),document.addEventListener("visibilitychange",e),setInterval(()=>this.poll(),Sg)}setController(t){this.axes=t?.axes||[],this.deflections=t?.key_deflections||[1],this.step=Math.min(this.step,this.deflections.length),this.keys=new Map,this.axes.forEach((e,n)=>e.keys.forEach(([s,r])=>this.keys.set(s,[n,1]).set(r,[n,-1]))),this.disarm()}taken(){this.down.clear(),this.disarm()}disarm(){this.armed=this.axes.map(()=>!1)}wiring(t,e){const n=this.settings.pads[t.id]?.axes[e.name];return n?n.axis<t.axes.length?n:null:t.mapping!=="standard"||e.pad_axis>=t.axes.length?null:{axis:e.pad_axis,sign:e.pad_inverted?-1:1}}button(t){const e=this.settings.pads[t.id]?.button??(t.mapping==="standard"?yg:null);return e!==null&&e<t.buttons.length?e:null}ready(t){return!this.settingUp&&this.button(t)!==null&&this.axes.every(e=>this.wiring(t,e)!==null)}lacks(){return this.pads.length?this.gamepad?this.ready(this.gamepad)?"":"setup":"choose":""}pick(t){this.change({chosen:{id:t.id,index:t.index??0}})}setUp(t,{axes:e={},button:n}){const s=this.settings.pads[t.id]||{axes:{},button:null},r={axes:{...s.axes,...e},button:n??s.button};this.change({pads:{...this.settings.pads,[t.id]:r}})}change(t){this.settings={...this.settings,...t},this.disarm(),Nm("local",kd,JSON.stringify(this.settings))}choose(){const{chosen:t}=this.settings,e=this.pads.filter(n=>n.id===t?.id);return e.length===1?e[0]:e.length>1?e.find(n=>n.index===t.index)||null:this.pads.length===1?this.pads[0]:null}deflection(t){return this.axes.map(e=>{const n=this.wiring(t,e);return n?n.axis===Aa?0:n.sign*Eg(t.axes[n.axis],this.settings.deadZone):null})}key(t,e){if(t.ctrlKey||t.metaKey||t.altKey||Bd(t.target)||e&&t.target instanceof Element&&t.target.closest("input, select, dialog"))return;const n=Number(/^(?:Digit|Numpad)([1-9])$/.exec(t.code)?.[1]);if(e&&n<=this.deflections.length){this.step=n,this.send(!0);return}if(!this.keys.has(t.code)&&t.code!=="Space"||t.code==="Space"&&!this.settings.holdSpace||(t.preventDefault(),t.repeat))return;const s=this.down.has(t.code);e?this.down.add(t.code):this.down.delete(t.code),e&&(this.source="keyboard"),s!==e&&this.send(!0)}poll(){this.pads=wg();const t=this.choose();(t?.id!==this.gamepad?.id||t?.index!==this.gamepad?.index)&&this.disarm(),this.gamepad=t,t&&this.ready(t)&&xh(t,this.button(t))&&(this.source="gamepad"),this.holds()?this.deflection(t).forEach((e,n)=>{e===0&&(this.armed[n]=!0)}):this.disarm(),this.send(!1)}holds(){const t=this.gamepad;return this.source==="gamepad"&&vh()&&t!==null&&this.ready(t)&&xh(t,this.button(t))}gone(){return this.source==="gamepad"&&this.gamepad===null}stuck(){return this.holds()?this.axes.filter((t,e)=>!this.armed[e]).map(t=>t.name):[]}state(){if(this.source==="gamepad"){const n=this.holds();return{held:n,at:n?this.deflection(this.gamepad).map((s,r)=>this.armed[r]?s:0):this.axes.map(()=>0)}}const t=this.axes.map(()=>0);for(const n of this.down)this.keys.has(n)&&(t[this.keys.get(n)[0]]+=this.keys.get(n)[1]);const e=this.deflections[this.step-1];return{held:vh()&&(!this.settings.holdSpace||this.down.has("Space")),at:t.map(n=>Math.max(-1,Math.min(1,n))*e)}}send(t){this.onChange(this.state(),t)}}const vh=()=>document.visibilityState==="visible"&&document.hasFocus();function wg(){try{return[...navigator.getGamepads?.()||[]].filter(i=>i&&i.connected!==!1)}catch{return[]}}function xh(i,t){return!!i.buttons[t]?.pressed}function Bd(i){return i instanceof Element&&!!i.closest("input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]")}function Tg(){let i=null;try{i=JSON.parse(Fm("local",kd))}catch{}const t={};for(const[e,n]of Object.entries(i?.pads??{})){const s=Object.entries(n?.axes??{}).filter(([,r])=>Number.isInteger(r?.axis)&&r.axis>=Aa&&Math.abs(r.sign)===1);t[e]={axes:Object.fromEntries(s),button:Number.isInteger(n?.button)&&n.button>=0?n.button:null}}return{pads:t,chosen:typeof i?.chosen?.id=="string"?i.chosen:null,holdSpace:i?.holdSpace===!0,deadZone:i?.deadZone>=0&&i.deadZone<=.4?Number(i.deadZone):.08}}const Ag=60,[Rg,Mh]=[.5,.3];function Cg(i,t,e){if(t===null)return J.unknown;const{axes:n,digits:s}=i.commands;return n.length===i.controller.axes.length?rc(t*n[e].highest,s):rc(t,2)}class Pg{constructor(t,e){Object.assign(this,{stick:t,display:e,seen:null,lead:null}),this.dialog=Vs(`<h3>${J.settings_title}</h3><p id="pad-note" role="status"></p>
      <fieldset id="pads"><legend>${J.settings_pads}</legend></fieldset><p id="pad-lead" role="status"></p><div id="pad-steps" class="buttons"></div>
      <table id="pad-axes"></table>
      <p><label>${J.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${t.settings.deadZone}"></label></p>
      <p><label><input type="checkbox" id="hold-space" ${t.settings.holdSpace?"checked":""}> ${J.settings_space}</label></p>
      ${Td?"":`<p class="alarm">${J.no_storage}</p>`}<div class="buttons">${Eo}</div>`),this.body=this.$("#pads"),this.dialog.onchange=n=>this.changed(n.target),this.timer=setInterval(()=>this.look(),Ag),this.look()}$(t){return this.dialog.querySelector(t)}look(){const{stick:t}=this;if(!this.dialog.open||!this.dialog.contains(this.body)){clearInterval(this.timer),t.settingUp=!1;return}const e=t.gamepad,n=JSON.stringify([t.pads.map(s=>[s.id,s.index]),e?.index,t.settings.pads,t.settings.chosen]);n!==this.seen&&(this.lead&&this.lead.index!==e?.index&&this.stop(),this.seen=n,this.build()),t.pads.forEach((s,r)=>Mn(this.$(`[data-live="${r}"]`),De(J.pad_live,{axes:s.axes.map(o=>pn(o,2)).join(" "),buttons:s.buttons.flatMap((o,a)=>o.pressed?[a]:[]).join(" ")||J.pad_nothing}))),e&&(t.deflection(e).forEach((s,r)=>Mn(this.$(`[data-now="${t.axes[r].name}"]`),Cg(this.display,s,r))),this.lead&&this.follow(e))}build(){const{stick:t}=this,e=t.gamepad;this.$("#pads").hidden=!t.pads.length,this.$("#pads").innerHTML=`<legend>${J.settings_pads}</legend>${t.pads.map((r,o)=>`<p><label><input type="radio" name="pad" value="${o}" ${r===e?"checked":""}>
      ${$e(r.id)}${r.mapping==="standard"?"":` (${J.pad_plain})`}</label><br><small class="dim num" data-live="${o}"></small></p>`).join("")}`;const n=e&&t.ready(e),s=t.pads.length?e?n||this.lead?J.pad_ready:J.pad_setup:J.pad_choose:J.settings_none;Mn(this.$("#pad-note"),this.lead?"":s),this.$("#pad-note").className=!e||n?"":"alarm",this.$("#pad-axes").innerHTML=e?this.table(e):"",this.lead||this.buttons(e&&t.axes.length?[["pad-start",J.pad_start,()=>this.begin(e)]]:[])}table(t){const{stick:e}=this;return`${e.axes.map(s=>{const r=e.wiring(t,s);return`<tr><td>${$e(`${s.positive} / ${s.negative}`)}</td>
        <td><label>${J.settings_axis} <input type="number" class="short" min="${Aa}" max="${t.axes.length-1}" data-axis="${s.name}" value="${r?.axis??""}"></label></td>
        <td><label><input type="checkbox" data-invert="${s.name}" ${r?.sign<0?"checked":""}> ${J.settings_invert}</label></td>
        <td>${J.settings_now} <b data-now="${s.name}"></b></td></tr>`}).join("")}<tr><td>${J.settings_button}</td><td colspan="3"><input type="number" class="short" min="0" max="${t.buttons.length-1}"
      id="pad-button" aria-label="${J.settings_button}" value="${e.button(t)??""}"></td></tr>`}changed(t){const{stick:e}=this,n=e.gamepad;if(t.name==="pad")e.pick(e.pads[Number(t.value)]);else if(t.id==="pad-zone")e.change({deadZone:Number(t.value)});else if(t.id==="hold-space")e.change({holdSpace:t.checked});else if(n&&t.validity.valid&&(t.type==="checkbox"||t.value!=="")){const s=t.dataset.axis||t.dataset.invert;t.id==="pad-button"?e.setUp(n,{button:Number(t.value)}):s&&this.$(`[data-axis="${s}"]`).value!==""&&e.setUp(n,{axes:{[s]:{axis:Number(this.$(`[data-axis="${s}"]`).value),sign:this.$(`[data-invert="${s}"]`).checked?-1:1}}})}}buttons(t){this.$("#pad-steps").replaceChildren(...t.map(([e,n,s])=>{const r=document.createElement("button");return Object.assign(r,{id:e,textContent:n,onclick:s}),r}))}begin(t){this.stick.settingUp=!0,this.lead={index:t.index,at:-1,axes:{},back:null},this.seen=null,this.say(J.pad_rest),this.buttons([["pad-next",J.pad_next,()=>{Object.assign(this.lead,{rest:[...this.stick.gamepad.axes],down:this.stick.gamepad.buttons.map(e=>e.pressed)}),this.next()}],["pad-stop",J.pad_stop,()=>this.stop()]])}say(t){Mn(this.$("#pad-lead"),t)}stop(){this.stick.settingUp=!1,this.lead=null,this.seen=null,this.say("")}next(){const{lead:t,stick:e}=this;t.at+=1;const n=e.axes[t.at];if(!n){this.say(J.pad_hold),this.buttons([["pad-stop",J.pad_stop,()=>this.stop()]]);return}this.say(De(J.pad_move,{what:n.positive,name:n.name})),this.buttons([["pad-skip",J.pad_skip,()=>{t.axes[n.name]={axis:Aa,sign:1},this.next()}],["pad-stop",J.pad_stop,()=>this.stop()]])}follow(t){const{lead:e,stick:n}=this;if(e.at<0)return;const s=t.axes.map((c,u)=>c-e.rest[u]);if(e.back!==null){if(Math.abs(s[e.back])>Mh)return;e.back=null,this.next();return}const r=n.axes[e.at];if(!r){const c=t.buttons.findIndex((h,f)=>h.pressed&&!e.down[f]);if(c<0)return;const{axes:u}=e;this.stop(),n.setUp(t,{axes:u,button:c});return}const o=Object.values(e.axes).map(c=>c.axis),a=s.map((c,u)=>o.includes(u)?0:Math.abs(c)),l=a.indexOf(Math.max(...a));if(a[l]>Rg){if(Math.abs(e.rest[l])>Mh){this.say(`${De(J.pad_trigger,{axis:l})} ${De(J.pad_move,{what:r.positive,name:r.name})}`);return}e.axes[r.name]={axis:l,sign:Math.sign(s[l])},e.back=l,this.say(J.pad_back)}}}function zd(i,t){return new Pg(i,t)}const Lg=!0,rn="u-",Dg="uplot",Ug=rn+"hz",Ig=rn+"vt",Ng=rn+"title",Fg=rn+"wrap",Og=rn+"under",kg=rn+"over",Bg=rn+"axis",Us=rn+"off",zg=rn+"select",Hg=rn+"cursor-x",Gg=rn+"cursor-y",Vg=rn+"cursor-pt",Wg=rn+"legend",Xg=rn+"live",$g=rn+"inline",qg=rn+"series",Yg=rn+"marker",Sh=rn+"label",Kg=rn+"value",uo="width",ho="height",no="top",yh="bottom",rr="left",dl="right",vu="#000",Eh=vu+"0",pl="mousemove",bh="mousedown",ml="mouseup",wh="mouseenter",Th="mouseleave",Ah="dblclick",jg="resize",Zg="scroll",Rh="change",Ra="dppxchange",xu="--",Hr=typeof window<"u",oc=Hr?document:null,wr=Hr?window:null,Jg=Hr?navigator:null;let Me,Oo;function ac(){let i=devicePixelRatio;Me!=i&&(Me=i,Oo&&cc(Rh,Oo,ac),Oo=matchMedia(`(min-resolution: ${Me-.001}dppx) and (max-resolution: ${Me+.001}dppx)`),ks(Rh,Oo,ac),wr.dispatchEvent(new CustomEvent(Ra)))}function Xn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function lc(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function Oe(i,t,e){i.style[t]=e+"px"}function fi(i,t,e,n){let s=oc.createElement(i);return t!=null&&Xn(s,t),e?.insertBefore(s,n),s}function Qn(i,t){return fi("div",i,t)}const Ch=new WeakMap;function Ti(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Ch.get(i);r!=o&&(i.style.transform=r,Ch.set(i,r),t<0||e<0||t>n||e>s?Xn(i,Us):lc(i,Us))}const Ph=new WeakMap;function Lh(i,t,e){let n=t+e,s=Ph.get(i);n!=s&&(Ph.set(i,n),i.style.background=t,i.style.borderColor=e)}const Dh=new WeakMap;function Uh(i,t,e,n){let s=t+""+e,r=Dh.get(i);s!=r&&(Dh.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}const Mu={passive:!0},Qg={...Mu,capture:!0};function ks(i,t,e,n){t.addEventListener(i,e,n?Qg:Mu)}function cc(i,t,e,n){t.removeEventListener(i,e,Mu)}Hr&&ac();function di(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:qn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function Hd(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}const Gd=i=>i!=null,Vd=i=>i!=null&&i>0,za=Hd(Gd),t_=Hd(Vd);function e_(i,t,e,n=0,s=!1){let r=s?t_:za,o=s?Vd:Gd;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ce,l??-Ce]}function Ha(i,t,e,n){let s=Fh(i),r=Fh(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Ki:Wd,a=s==1?qn:ei,l=r==1?ei:qn,c=a(o(tn(i))),u=l(o(tn(t))),h=Lr(e,c),f=Lr(e,u);return e==10&&(c<0&&(h=Pe(h,-c)),u<0&&(f=Pe(f,-u))),n||e==2?(i=h*s,t=f*r):(i=Yd(i,h),t=Ga(t,f)),[i,t]}function Su(i,t,e,n){let s=Ha(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}const yu=.1,Ih={mode:3,pad:yu},go={pad:0,soft:null,mode:0},n_={min:go,max:go};function Ca(i,t,e,n){return Va(e)?Nh(i,t,e):(go.pad=e,go.soft=n?0:null,go.mode=n?3:0,Nh(i,t,n_))}function _e(i,t){return i??t}function i_(i,t,e){for(t=_e(t,0),e=_e(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Nh(i,t,e){let n=e.min,s=e.max,r=_e(n.pad,0),o=_e(s.pad,0),a=_e(n.hard,-Ce),l=_e(s.hard,Ce),c=_e(n.soft,Ce),u=_e(s.soft,-Ce),h=_e(n.mode,0),f=_e(s.mode,0),d=t-i,g=Ki(d),v=Pn(tn(i),tn(t)),m=Ki(v),p=tn(m-g);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,h==2&&c!=Ce&&(r=0),f==2&&u!=-Ce&&(o=0)));let E=d||v||1e3,T=Ki(E),M=Lr(10,qn(T)),O=E*(d==0?i==0?.1:1:r),R=Pe(Yd(i-O,M/10),24),D=i>=c&&(h==1||h==3&&R<=c||h==2&&R>=c)?c:Ce,U=Pn(a,R<D&&i>=D?D:pi(D,R)),w=E*(d==0?t==0?.1:1:o),S=Pe(Ga(t+w,M/10),24),C=t<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-Ce,G=pi(l,S>C&&t<=C?C:Pn(C,S));return U==G&&U==0&&(G=100),[U,G]}const s_=new Intl.NumberFormat(Hr?Jg.language:"en-US"),Eu=i=>s_.format(i),Yn=Math,va=Yn.PI,tn=Yn.abs,qn=Yn.floor,Qe=Yn.round,ei=Yn.ceil,pi=Yn.min,Pn=Yn.max,Lr=Yn.pow,Fh=Yn.sign,Ki=Yn.log10,Wd=Yn.log2,r_=(i,t=1)=>Yn.sinh(i)*t,gl=(i,t=1)=>Yn.asinh(i/t),Ce=1/0;function Oh(i){return(Ki((i^i>>31)-(i>>31))|0)+1}function uc(i,t,e){return pi(Pn(i,t),e)}function Xd(i){return typeof i=="function"}function re(i){return Xd(i)?i:()=>i}const o_=()=>{},$d=i=>i,qd=(i,t)=>t,a_=i=>null,kh=i=>!0,Bh=(i,t)=>i==t,l_=/\.\d*?(?=9{6,}|0{6,})/gm,Bs=i=>{if(jd(i)||ps.has(i))return i;const t=`${i}`,e=t.match(l_);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Bs(s)}e${r}`}return Pe(i,n)};function Cs(i,t){return Bs(Pe(Bs(i/t))*t)}function Ga(i,t){return Bs(ei(Bs(i/t))*t)}function Yd(i,t){return Bs(qn(Bs(i/t))*t)}function Pe(i,t=0){if(jd(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Qe(n)/e}const ps=new Map;function Kd(i){return((""+i).split(".")[1]||"").length}function Mo(i,t,e,n){let s=[],r=n.map(Kd);for(let o=t;o<e;o++){let a=tn(o),l=Pe(Lr(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:Pe(u,h);s.push(f),ps.set(f,h)}}return s}const _o={},bu=[],Dr=[null,null],us=Array.isArray,jd=Number.isInteger,c_=i=>i===void 0;function zh(i){return typeof i=="string"}function Va(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function u_(i){return i!=null&&typeof i=="object"}const h_=Object.getPrototypeOf(Uint8Array),Zd="__proto__";function Ur(i,t=Va){let e;if(us(i)){let n=i.find(s=>s!=null);if(us(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Ur(i[s],t)}else e=i.slice()}else if(i instanceof h_)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Zd&&(e[n]=Ur(i[n],t))}else e=i;return e}function Ke(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Zd&&(Va(i[s])?Ke(i[s],Ur(n[s])):i[s]=Ur(n[s]))}return i}const f_=0,d_=1,p_=2;function m_(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function g_(i,t){if(x_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return M_(o[0])||(o=v_(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:d_,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?f!=f_&&(h[m]=v,f==p_&&d.push(m)):h[m]=v}m_(h,d,s),n.push(h)}}return n}const __=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function v_(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function x_(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function M_(i,t=100){const e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const r=Pn(1,qn((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){const l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const Jd=["January","February","March","April","May","June","July","August","September","October","November","December"],Qd=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function tp(i){return i.slice(0,3)}const S_=Qd.map(tp),y_=Jd.map(tp),E_={MMMM:Jd,MMM:y_,WWWW:Qd,WWW:S_};function io(i){return(i<10?"0":"")+i}function b_(i){return(i<10?"00":i<100?"0":"")+i}const w_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>io(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>io(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>io(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>io(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>io(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>b_(i.getMilliseconds())};function wu(i,t){t=t||E_;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?w_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const T_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function A_(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==T_?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}const ep=i=>i%1==0,Pa=[1,2,2.5,5],R_=Mo(10,-32,0,Pa),np=Mo(10,0,32,Pa),C_=np.filter(ep),Ps=R_.concat(np),Tu=`
`,ip="{YYYY}",Hh=Tu+ip,sp="{M}/{D}",fo=Tu+sp,ko=fo+"/{YY}",rp="{aa}",P_="{h}:{mm}",Mr=P_+rp,Gh=Tu+Mr,Vh=":{ss}",Ee=null;function op(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?Mo(10,0,3,Pa).filter(ep):Mo(10,-3,0,Pa)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,ip,Ee,Ee,Ee,Ee,Ee,Ee,1],[s*28,"{MMM}",Hh,Ee,Ee,Ee,Ee,Ee,1],[s,sp,Hh,Ee,Ee,Ee,Ee,Ee,1],[n,"{h}"+rp,ko,Ee,fo,Ee,Ee,Ee,1],[e,Mr,ko,Ee,fo,Ee,Ee,Ee,1],[t,Vh,ko+" "+Mr,Ee,fo+" "+Mr,Ee,Gh,Ee,1],[i,Vh+".{fff}",ko+" "+Mr,Ee,fo+" "+Mr,Ee,Gh,Ee,1]];function u(h){return(f,d,g,v,m,p)=>{let E=[],T=m>=o,M=m>=r&&m<o,O=h(g),R=Pe(O*i,3),D=_l(O.getFullYear(),T?0:O.getMonth(),M||T?1:O.getDate()),U=Pe(D*i,3);if(M||T){let w=M?m/r:0,S=T?m/o:0,C=R==U?R:Pe(_l(D.getFullYear()+S,D.getMonth()+w,1)*i,3),G=new Date(Qe(C/i)),I=G.getFullYear(),V=G.getMonth();for(let j=0;C<=v;j++){let K=_l(I+S*j,V+w*j,1),Q=K-h(Pe(K*i,3));C=Pe((+K+Q)*i,3),C<=v&&E.push(C)}}else{let w=m>=s?s:m,S=qn(g)-qn(R),C=U+S+Ga(R-U,w);E.push(C);let G=h(C),I=G.getHours()+G.getMinutes()/e+G.getSeconds()/n,V=m/n,j=f.axes[d]._space,K=p/j;for(;C=Pe(C+m,i==1?0:3),!(C>v);)if(V>1){let Q=qn(Pe(I+V,6))%24,ct=h(C).getHours()-Q;ct>1&&(ct=-1),C-=ct*n,I=(I+V)%24;let mt=E[E.length-1];Pe((C-mt)/m,3)*K>=.7&&E.push(C)}else E.push(C)}return E}}return[l,c,u]}const[L_,D_,U_]=op(1),[I_,N_,F_]=op(.001);Mo(2,-53,53,[1]);function Wh(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Xh(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,f,d;return n.map(g=>{let v=i(g),m=v.getFullYear(),p=v.getMonth(),E=v.getDate(),T=v.getHours(),M=v.getMinutes(),O=v.getSeconds(),R=m!=l&&a[2]||p!=c&&a[3]||E!=u&&a[4]||T!=h&&a[5]||M!=f&&a[6]||O!=d&&a[7]||a[1];return l=m,c=p,u=E,h=T,f=M,d=O,R(v)})}}function O_(i,t){let e=wu(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function _l(i,t,e){return new Date(i,t,e)}function $h(i,t){return t(i)}const k_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function qh(i,t){return(e,n,s,r)=>r==null?xu:t(i(n))}function B_(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function z_(i,t){return i.series[t].fill(i,t)}const H_={show:!0,live:!0,isolate:!1,mount:o_,markers:{show:!0,width:2,stroke:B_,fill:z_,dash:"solid"},idx:null,idxs:null,values:[]};function G_(i,t){let e=i.cursor.points,n=Qn(),s=e.size(i,t);Oe(n,uo,s),Oe(n,ho,s);let r=s/-2;Oe(n,"marginLeft",r),Oe(n,"marginTop",r);let o=e.width(i,t,s);return o&&Oe(n,"borderWidth",o),n}function V_(i,t){let e=i.series[t].points;return e._fill||e._stroke}function W_(i,t){let e=i.series[t].points;return e._stroke||e._fill}function X_(i,t){return i.series[t].points.size}const vl=[0,0];function $_(i,t,e){return vl[0]=t,vl[1]=e,vl}function Bo(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function xl(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}const q_={show:!0,x:!0,y:!0,lock:!1,move:$_,points:{one:!1,show:G_,size:X_,width:0,stroke:W_,fill:V_},bind:{mousedown:Bo,mouseup:Bo,click:Bo,dblclick:Bo,mousemove:xl,mouseleave:xl,mouseenter:xl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},ap={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Au=Ke({},ap,{filter:qd}),lp=Ke({},Au,{size:10}),cp=Ke({},ap,{show:!1}),Ru='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',up="bold "+Ru,hp=1.5,Yh={show:!0,scale:"x",stroke:vu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:up,side:2,grid:Au,ticks:lp,border:cp,font:Ru,lineGap:hp,rotate:0},Y_="Value",K_="Time",Kh={show:!0,scale:"x",auto:!1,sorted:1,min:Ce,max:-Ce,idxs:[]};function j_(i,t,e,n,s){return t.map(r=>r==null?"":Eu(r))}function Z_(i,t,e,n,s,r,o){let a=[],l=ps.get(s)||0;e=o?e:Pe(Ga(e,s),l);for(let c=e;c<=n;c=Pe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function hc(i,t,e,n,s,r,o){const a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Ki:Wd,u=qn(c(e));s=Lr(l,u),l==10&&(s=Ps[di(s,Ps)]);let h=e,f=s*l;l==10&&(f=Ps[di(f,Ps)]);do a.push(h),h=h+s,l==10&&!ps.has(h)&&(h=Pe(h,ps.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Ps[di(f,Ps)]));while(h<=n);return a}function J_(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?hc(i,t,Pn(l,e),n,s):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?hc(i,t,Pn(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}const fp=/./,Q_=/[12357]/,t0=/[125]/,jh=/1/,fc=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function e0(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?fp:l(7,o)-u>=c?Q_:l(5,o)-u>=c?t0:jh;if(h==jh){let f=tn(l(1,o)-u);if(f<c)return fc(t.slice().reverse(),a.distr,h,ei(c/f)).reverse()}return fc(t,a.distr,h,1)}function n0(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=tn(l(1,o)-l(2,o));return c<a?fc(t.slice().reverse(),3,fp,ei(a/c)).reverse():t}function i0(i,t,e,n){return n==null?xu:t==null?"":Eu(t)}const Zh={show:!0,scale:"y",stroke:vu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:up,side:3,grid:Au,ticks:lp,border:cp,font:Ru,lineGap:hp,rotate:0};function s0(i,t){let e=3+(i||1)*2;return Pe(e*t,3)}function r0(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=tn(o-r),l=i.series[t],c=a/(l.points.space*Me);return n[1]-n[0]<=c}const Jh={scale:null,auto:!0,sorted:0,min:Ce,max:-Ce},dp=(i,t,e,n,s)=>s,Qh={show:!0,auto:!0,sorted:0,gaps:dp,alpha:1,facets:[Ke({},Jh,{scale:"x"}),Ke({},Jh,{scale:"y"})]},tf={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:dp,alpha:1,points:{show:r0,filter:null},values:null,min:Ce,max:-Ce,idxs:[],path:null,clip:null};function o0(i,t,e,n,s){return e/10}const pp={time:Lg,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},a0=Ke({},pp,{time:!1,ori:1}),ef={};function mp(i,t){let e=ef[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(ef[i]=e)),e}const Ir=1,dc=2;function Ws(i,t,e){const n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox;let l=r[0],c=n==2?r[1]:r[t],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,v=a.height,m=i.valToPosH,p=i.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,v,Xa,Gr,qa,_p,xp):e(s,l,c,u,h,p,m,d,f,v,g,$a,Vr,Lu,vp,Mp)}function Cu(i,t){let e=0,n=0,s=_e(i.bands,bu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function l0(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ji(i,t,e,n,s,r){return Ws(i,t,(o,a,l,c,u,h,f,d,g,v,m)=>{let p=o.pxRound;const E=c.dir*(c.ori==0?1:-1),T=c.ori==0?Gr:Vr;let M,O;E==1?(M=e,O=n):(M=n,O=e);let R=p(h(a[M],c,v,d)),D=p(f(l[M],u,m,g)),U=p(h(a[O],c,v,d)),w=p(f(r==1?u.max:u.min,u,m,g)),S=new Path2D(s);return T(S,U,w),T(S,R,w),T(S,R,D),S})}function Wa(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;const a=t==0?qa:Lu;let l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function c0(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Pu(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[h]),g=f==h?d:r(i[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(i[v]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=d&&a.push([d,g])}return a}function nf(i){return i==0?$d:i==1?Qe:t=>Cs(t,i)}function gp(i){let t=i==0?Xa:$a,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=pi(c,a/2,l/2),u=pi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const Xa=(i,t,e)=>{i.moveTo(t,e)},$a=(i,t,e)=>{i.moveTo(e,t)},Gr=(i,t,e)=>{i.lineTo(t,e)},Vr=(i,t,e)=>{i.lineTo(e,t)},qa=gp(0),Lu=gp(1),_p=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},vp=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},xp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Mp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function Sp(i){return(t,e,n,s,r)=>Ws(t,e,(o,a,l,c,u,h,f,d,g,v,m)=>{let{pxRound:p,points:E}=o,T,M;c.ori==0?(T=Xa,M=_p):(T=$a,M=vp);const O=Pe(E.width*Me,3);let R=(E.size-E.width)/2*Me,D=Pe(R*2,3),U=new Path2D,w=new Path2D,{left:S,top:C,width:G,height:I}=t.bbox;qa(w,S-D,C-D,G+D*2,I+D*2);const V=j=>{if(l[j]!=null){let K=p(h(a[j],c,v,d)),Q=p(f(l[j],u,m,g));T(U,K+R,Q),M(U,K,Q,R,0,va*2)}};if(r)r.forEach(V);else for(let j=n;j<=s;j++)V(j);return{stroke:O>0?U:null,fill:U,clip:w,flags:Ir|dc}})}function yp(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}const u0=yp(Gr),h0=yp(Vr);function Ep(i){const t=_e(i?.alignGaps,0);return(e,n,s,r)=>Ws(e,n,(o,a,l,c,u,h,f,d,g,v,m)=>{[s,r]=za(l,s,r);let p=o.pxRound,E=I=>p(h(I,c,v,d)),T=I=>p(f(I,u,m,g)),M,O;c.ori==0?(M=Gr,O=u0):(M=Vr,O=h0);const R=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ir},U=D.stroke;let w=!1;if(r-s>=v*4){let I=pt=>e.posToVal(pt,c.key,!0),V=null,j=null,K,Q,tt,ht=E(a[R==1?s:r]),ct=E(a[s]),mt=E(a[r]),Mt=I(R==1?ct+1:mt-1);for(let pt=R==1?s:r;pt>=s&&pt<=r;pt+=R){let it=a[pt],gt=(R==1?it<Mt:it>Mt)?ht:E(it),ot=l[pt];gt==ht?ot!=null?(Q=ot,V==null?(M(U,gt,T(Q)),K=V=j=Q):Q<V?V=Q:Q>j&&(j=Q)):ot===null&&(w=!0):(V!=null&&O(U,ht,T(V),T(j),T(K),T(Q)),ot!=null?(Q=ot,M(U,gt,T(Q)),V=j=K=Q):(V=j=null,ot===null&&(w=!0)),ht=gt,Mt=I(ht+R))}V!=null&&V!=j&&tt!=ht&&O(U,ht,T(V),T(j),T(K),T(Q))}else for(let I=R==1?s:r;I>=s&&I<=r;I+=R){let V=l[I];V===null?w=!0:V!=null&&M(U,E(a[I]),T(V))}let[C,G]=Cu(e,n);if(o.fill!=null||C!=0){let I=D.fill=new Path2D(U),V=o.fillTo(e,n,o.min,o.max,C),j=T(V),K=E(a[s]),Q=E(a[r]);R==-1&&([Q,K]=[K,Q]),M(I,Q,j),M(I,K,j)}if(!o.spanGaps){let I=[];w&&I.push(...Pu(a,l,s,r,R,E,t)),D.gaps=I=o.gaps(e,n,s,r,I),D.clip=Wa(I,c.ori,d,g,v,m)}return G!=0&&(D.band=G==2?[ji(e,n,s,r,U,-1),ji(e,n,s,r,U,1)]:ji(e,n,s,r,U,G)),D})}function f0(i){const t=_e(i.align,1),e=_e(i.ascDesc,!1),n=_e(i.alignGaps,0),s=_e(i.extend,!1);return(r,o,a,l)=>Ws(r,o,(c,u,h,f,d,g,v,m,p,E,T)=>{[a,l]=za(h,a,l);let M=c.pxRound,{left:O,width:R}=r.bbox,D=ct=>M(g(ct,f,E,m)),U=ct=>M(v(ct,d,T,p)),w=f.ori==0?Gr:Vr;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Ir},C=S.stroke,G=f.dir*(f.ori==0?1:-1);let I=U(h[G==1?a:l]),V=D(u[G==1?a:l]),j=V,K=V;s&&t==-1&&(K=O,w(C,K,I)),w(C,V,I);for(let ct=G==1?a:l;ct>=a&&ct<=l;ct+=G){let mt=h[ct];if(mt==null)continue;let Mt=D(u[ct]),pt=U(mt);t==1?w(C,Mt,I):w(C,j,pt),w(C,Mt,pt),I=pt,j=Mt}let Q=j;s&&t==1&&(Q=O+R,w(C,Q,I));let[tt,ht]=Cu(r,o);if(c.fill!=null||tt!=0){let ct=S.fill=new Path2D(C),mt=c.fillTo(r,o,c.min,c.max,tt),Mt=U(mt);w(ct,Q,Mt),w(ct,K,Mt)}if(!c.spanGaps){let ct=[];ct.push(...Pu(u,h,a,l,G,D,n));let mt=c.width*Me/2,Mt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(it=>{it[0]+=Mt,it[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=Wa(ct,f.ori,m,p,E,T)}return ht!=0&&(S.band=ht==2?[ji(r,o,a,l,C,-1),ji(r,o,a,l,C,1)]:ji(r,o,a,l,C,ht)),S})}function sf(i,t,e,n,s,r,o=Ce){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=tn(i[l]-i[a]);u<c&&(c=u,o=tn(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function d0(i){i=i||_o;const t=_e(i.size,[.6,Ce,1]),e=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=re(s),o=1-t[0],a=_e(t[1],Ce),l=_e(t[2],1),c=_e(i.disp,_o),u=_e(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,v,m)=>Ws(d,g,(p,E,T,M,O,R,D,U,w,S,C)=>{let G=p.pxRound,I=e,V=n*Me,j=a*Me,K=l*Me,Q,tt;M.ori==0?[Q,tt]=r(d,g):[tt,Q]=r(d,g);const ht=M.dir*(M.ori==0?1:-1);let ct=M.ori==0?qa:Lu,mt=M.ori==0?u:(W,et,St,_t,wt,Kt,ft)=>{u(W,et,St,wt,_t,ft,Kt)},Mt=_e(d.bands,bu).find(W=>W.series[0]==g),pt=Mt!=null?Mt.dir:0,it=p.fillTo(d,g,p.min,p.max,pt),at=G(D(it,O,C,w)),gt,ot,Bt,Ht=S,It=G(p.width*Me),ce=!1,jt=null,ue=null,B=null,Ze=null;h!=null&&(It==0||f!=null)&&(ce=!0,jt=h.values(d,g,v,m),ue=new Map,new Set(jt).forEach(W=>{W!=null&&ue.set(W,new Path2D)}),It>0&&(B=f.values(d,g,v,m),Ze=new Map,new Set(B).forEach(W=>{W!=null&&Ze.set(W,new Path2D)})));let{x0:Jt,size:te}=c;if(Jt!=null&&te!=null){I=1,E=Jt.values(d,g,v,m),Jt.unit==2&&(E=E.map(St=>d.posToVal(U+St*S,M.key,!0)));let W=te.values(d,g,v,m);te.unit==2?ot=W[0]*S:ot=R(W[0],M,S,U)-R(0,M,S,U),Ht=sf(E,T,R,M,S,U,Ht),Bt=Ht-ot+V}else Ht=sf(E,T,R,M,S,U,Ht),Bt=Ht*o+V,ot=Ht-Bt;Bt<1&&(Bt=0),It>=ot/2&&(It=0),Bt<5&&(G=$d);let Gt=Bt>0,fe=Ht-Bt-(Gt?It:0);ot=G(uc(fe,K,j)),gt=(I==0?ot/2:I==ht?0:ot)-I*ht*((I==0?V/2:0)+(Gt?It/2:0));const Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=ce?null:new Path2D;let y=null;if(Mt!=null)y=d.data[Mt.series[1]];else{let{y0:W,y1:et}=c;W!=null&&et!=null&&(T=et.values(d,g,v,m),y=W.values(d,g,v,m))}let Y=Q*ot,Z=tt*ot;for(let W=ht==1?v:m;W>=v&&W<=m;W+=ht){let et=T[W];if(et==null)continue;if(y!=null){let Ot=y[W]??0;if(et-Ot==0)continue;at=D(Ot,O,C,w)}let St=M.distr!=2||c!=null?E[W]:W,_t=R(St,M,S,U),wt=D(_e(et,it),O,C,w),Kt=G(_t-gt),ft=G(Pn(wt,at)),vt=G(pi(wt,at)),Nt=ft-vt;if(et!=null){let Ot=et<0?Z:Y,Et=et<0?Y:Z;ce?(It>0&&B[W]!=null&&ct(Ze.get(B[W]),Kt,vt+qn(It/2),ot,Pn(0,Nt-It),Ot,Et),jt[W]!=null&&ct(ue.get(jt[W]),Kt,vt+qn(It/2),ot,Pn(0,Nt-It),Ot,Et)):ct(P,Kt,vt+qn(It/2),ot,Pn(0,Nt-It),Ot,Et),mt(d,g,W,Kt-It/2,vt,ot+It,Nt)}}return It>0?Pt.stroke=ce?Ze:P:ce||(Pt._fill=p.width==0?p._fill:p._stroke??p._fill,Pt.width=0),Pt.fill=ce?ue:P,Pt})}function p0(i,t){const e=_e(t?.alignGaps,0);return(n,s,r,o)=>Ws(n,s,(a,l,c,u,h,f,d,g,v,m,p)=>{[r,o]=za(c,r,o);let E=a.pxRound,T=Q=>E(f(Q,u,m,g)),M=Q=>E(d(Q,h,p,v)),O,R,D;u.ori==0?(O=Xa,D=Gr,R=xp):(O=$a,D=Vr,R=Mp);const U=u.dir*(u.ori==0?1:-1);let w=T(l[U==1?r:o]),S=w,C=[],G=[];for(let Q=U==1?r:o;Q>=r&&Q<=o;Q+=U)if(c[Q]!=null){let ht=l[Q],ct=T(ht);C.push(S=ct),G.push(M(c[Q]))}const I={stroke:i(C,G,O,D,R,E),fill:null,clip:null,band:null,gaps:null,flags:Ir},V=I.stroke;let[j,K]=Cu(n,s);if(a.fill!=null||j!=0){let Q=I.fill=new Path2D(V),tt=a.fillTo(n,s,a.min,a.max,j),ht=M(tt);D(Q,S,ht),D(Q,w,ht)}if(!a.spanGaps){let Q=[];Q.push(...Pu(l,c,r,o,U,T,e)),I.gaps=Q=a.gaps(n,s,r,o,Q),I.clip=Wa(Q,u.ori,g,v,m,p)}return K!=0&&(I.band=K==2?[ji(n,s,r,o,V,-1),ji(n,s,r,o,V,1)]:ji(n,s,r,o,V,K)),I})}function m0(i){return p0(g0,i)}function g0(i,t,e,n,s,r){const o=i.length;if(o<2)return null;const a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}const pc=new Set;function rf(){for(let i of pc)i.syncRect(!0)}Hr&&(ks(jg,wr,rf),ks(Zg,wr,rf,!0),ks(Ra,wr,()=>{yn.pxRatio=Me}));const _0=Ep(),v0=Sp();function of(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>mc(r,o,t,e))}function x0(i,t){return i.map((e,n)=>n==0?{}:Ke({},t,e))}function mc(i,t,e,n){return Ke({},t==0?e:n,i)}function bp(i,t,e){return t==null?Dr:[t,e]}const M0=bp;function S0(i,t,e){return t==null?Dr:Ca(t,e,yu,!0)}function wp(i,t,e,n){return t==null?Dr:Ha(t,e,i.scales[n].log,!1)}const y0=wp;function Tp(i,t,e,n){return t==null?Dr:Su(t,e,i.scales[n].log,!1)}const E0=Tp;function b0(i,t,e,n,s){let r=Pn(Oh(i),Oh(t)),o=t-i,a=di(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?ps.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function af(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Qe((e=+s)*Me))+"px"),[i,t,e]}function w0(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=Pe(t[2]*Me,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function yn(i,t,e){const n={mode:_e(i.mode,1)},s=n.mode;function r(_,x,A,L){let N=x.valToPct(_);return L+A*(x.dir==-1?1-N:N)}function o(_,x,A,L){let N=x.valToPct(_);return L+A*(x.dir==-1?N:1-N)}function a(_,x,A,L){return x.ori==0?r(_,x,A,L):o(_,x,A,L)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;const c=n.root=Qn(Dg);if(i.id!=null&&(c.id=i.id),Xn(c,i.class),i.title){let _=Qn(Ng,c);_.textContent=i.title}const u=fi("canvas"),h=n.ctx=u.getContext("2d"),f=Qn(Fg,c);ks("click",f,_=>{_.target===g&&(Ie!=tr||He!=er)&&mn.click(n,_)},!0);const d=n.under=Qn(Og,f);f.appendChild(u);const g=n.over=Qn(kg,f);i=Ur(i);const v=+_e(i.pxAlign,1),m=nf(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});const p=i.ms||.001,E=n.series=s==1?of(i.series||[],Kh,tf,!1):x0(i.series||[null],Qh),T=n.axes=of(i.axes||[],Yh,Zh,!0),M=n.scales={},O=n.bands=i.bands||[];O.forEach(_=>{_.fill=re(_.fill||null),_.dir=_e(_.dir,-1)});const R=s==2?E[1].facets[0].scale:E[0].scale,D={axes:Mm,series:Kn},U=(i.drawOrder||["axes","series"]).map(_=>D[_]);function w(_){const x=_.distr==3?A=>Ki(A>0?A:_.clamp(n,A,_.min,_.max,_.key)):_.distr==4?A=>gl(A,_.asinh):_.distr==100?A=>_.fwd(A):A=>A;return A=>{let L=x(A),{_min:N,_max:q}=_,st=q-N;return(L-N)/st}}function S(_){let x=M[_];if(x==null){let A=(i.scales||_o)[_]||_o;if(A.from!=null){S(A.from);let L=Ke({},M[A.from],A,{key:_});L.valToPct=w(L),M[_]=L}else{x=M[_]=Ke({},_==R?pp:a0,A),x.key=_;let L=x.time,N=x.range,q=us(N);if((_!=R||s==2&&!L)&&(q&&(N[0]==null||N[1]==null)&&(N={min:N[0]==null?Ih:{mode:1,hard:N[0],soft:N[0]},max:N[1]==null?Ih:{mode:1,hard:N[1],soft:N[1]}},q=!1),!q&&Va(N))){let st=N;N=(lt,dt,Rt)=>dt==null?Dr:Ca(dt,Rt,st)}x.range=re(N||(L?M0:_==R?x.distr==3?y0:x.distr==4?E0:bp:x.distr==3?wp:x.distr==4?Tp:S0)),x.auto=re(q?!1:x.auto),x.clamp=re(x.clamp||o0),x._min=x._max=null,x.valToPct=w(x)}}}S("x"),S("y"),s==1&&E.forEach(_=>{S(_.scale)}),T.forEach(_=>{S(_.scale)});for(let _ in i.scales)S(_);const C=M[R],G=C.distr;let I,V;C.ori==0?(Xn(c,Ug),I=r,V=o):(Xn(c,Ig),I=o,V=r);const j={};for(let _ in M){let x=M[_];(x.min!=null||x.max!=null)&&(j[_]={min:x.min,max:x.max},x.min=x.max=null)}const K=i.tzDate||(_=>new Date(Qe(_/p))),Q=i.fmtDate||wu,tt=p==1?U_(K):F_(K),ht=Xh(K,Wh(p==1?D_:N_,Q)),ct=qh(K,$h(k_,Q)),mt=[],Mt=n.legend=Ke({},H_,i.legend),pt=n.cursor=Ke({},q_,{drag:{y:s==2}},i.cursor),it=Mt.show,at=pt.show,gt=Mt.markers;Mt.idxs=mt,gt.width=re(gt.width),gt.dash=re(gt.dash),gt.stroke=re(gt.stroke),gt.fill=re(gt.fill);let ot,Bt,Ht,It=[],ce=[],jt,ue=!1,B={};if(Mt.live){const _=E[1]?E[1].values:null;ue=_!=null,jt=ue?_(n,1,0):{_:0};for(let x in jt)B[x]=xu}if(it)if(ot=fi("table",Wg,c),Ht=fi("tbody",null,ot),Mt.mount(n,ot),ue){Bt=fi("thead",null,ot,Ht);let _=fi("tr",null,Bt);fi("th",null,_);for(var Ze in jt)fi("th",Sh,_).textContent=Ze}else Xn(ot,$g),Mt.live&&Xn(ot,Xg);const Jt={show:!0},te={show:!1};function Gt(_,x){if(x==0&&(ue||!Mt.live||s==2))return Dr;let A=[],L=fi("tr",qg,Ht,Ht.childNodes[x]);Xn(L,_.class),_.show||Xn(L,Us);let N=fi("th",null,L);if(gt.show){let lt=Qn(Yg,N);if(x>0){let dt=gt.width(n,x);dt&&(lt.style.border=dt+"px "+gt.dash(n,x)+" "+gt.stroke(n,x)),lt.style.background=gt.fill(n,x)}}let q=Qn(Sh,N);_.label instanceof HTMLElement?q.appendChild(_.label):q.textContent=_.label,x>0&&(gt.show||(q.style.color=_.width>0?gt.stroke(n,x):gt.fill(n,x)),Pt("click",N,lt=>{if(pt._lock)return;Je(lt);let dt=E.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Rt=E.some((Ct,Lt)=>Lt>0&&Lt!=dt&&Ct.show);E.forEach((Ct,Lt)=>{Lt>0&&yi(Lt,Rt?Lt==dt?Jt:te:Jt,!0,qe.setSeries)})}else yi(dt,{show:!_.show},!0,qe.setSeries)},!1),Oi&&Pt(wh,N,lt=>{pt._lock||(Je(lt),yi(E.indexOf(_),ir,!0,qe.setSeries))},!1));for(var st in jt){let lt=fi("td",Kg,L);lt.textContent="--",A.push(lt)}return[L,A]}const fe=new Map;function Pt(_,x,A,L=!0){const N=fe.get(x)||{},q=pt.bind[_](n,x,A,L);q&&(ks(_,x,N[_]=q),fe.set(x,N))}function P(_,x,A){const L=fe.get(x)||{};for(let N in L)(_==null||N==_)&&(cc(N,x,L[N]),delete L[N]);_==null&&fe.delete(x)}let y=0,Y=0,Z=0,W=0,et=0,St=0,_t=et,wt=St,Kt=Z,ft=W,vt=0,Nt=0,Ot=0,Et=0;n.bbox={};let ne=!1,qt=!1,de=!1,k=!1,xt=!1,nt=!1;function rt(_,x,A){(A||_!=n.width||x!=n.height)&&Tt(_,x),js(!1),de=!0,qt=!0,Zs()}function Tt(_,x){n.width=y=Z=_,n.height=Y=W=x,et=St=0,an(),ve();let A=n.bbox;vt=A.left=Cs(et*Me,.5),Nt=A.top=Cs(St*Me,.5),Ot=A.width=Cs(Z*Me,.5),Et=A.height=Cs(W*Me,.5)}const At=3;function Zt(){let _=!1,x=0;for(;!_;){x++;let A=vm(x),L=xm(x);_=x==At||A&&L,_||(Tt(n.width,n.height),qt=!0)}}function Be({width:_,height:x}){rt(_,x)}n.setSize=Be;function an(){let _=!1,x=!1,A=!1,L=!1;T.forEach((N,q)=>{if(N.show&&N._show){let{side:st,_size:lt}=N,dt=st%2,Rt=N.label!=null?N.labelSize:0,Ct=lt+Rt;Ct>0&&(dt?(Z-=Ct,st==3?(et+=Ct,L=!0):A=!0):(W-=Ct,st==0?(St+=Ct,_=!0):x=!0))}}),xi[0]=_,xi[1]=A,xi[2]=x,xi[3]=L,Z-=b[1]+b[3],et+=b[3],W-=b[2]+b[0],St+=b[0]}function ve(){let _=et+Z,x=St+W,A=et,L=St;function N(q,st){switch(q){case 1:return _+=st,_-st;case 2:return x+=st,x-st;case 3:return A-=st,A+st;case 0:return L-=st,L+st}}T.forEach((q,st)=>{if(q.show&&q._show){let lt=q.side;q._pos=N(lt,q._size),q.label!=null&&(q._lpos=N(lt,q.labelSize))}})}if(pt.dataIdx==null){let _=pt.hover,x=_.skip=new Set(_.skip??[]);x.add(void 0);let A=_.prox=re(_.prox),L=_.bias??=0;pt.dataIdx=(N,q,st,lt)=>{if(q==0)return st;let dt=st,Rt=A(N,q,st,lt)??Ce,Ct=Rt>=0&&Rt<Ce,Lt=C.ori==0?Z:W,Yt=pt.left,xe=t[0],ge=t[q];if(x.has(ge[st])){dt=null;let ie=null,Wt=null,zt;if(L==0||L==-1)for(zt=st;ie==null&&zt-- >0;)x.has(ge[zt])||(ie=zt);if(L==0||L==1)for(zt=st;Wt==null&&zt++<ge.length;)x.has(ge[zt])||(Wt=zt);if(ie!=null||Wt!=null)if(Ct){let Fe=ie==null?-1/0:I(xe[ie],C,Lt,0),We=Wt==null?1/0:I(xe[Wt],C,Lt,0),fn=Yt-Fe,Te=We-Yt;fn<=Te?fn<=Rt&&(dt=ie):Te<=Rt&&(dt=Wt)}else dt=Wt==null?ie:ie==null?Wt:st-ie<=Wt-st?ie:Wt}else Ct&&tn(Yt-I(xe[st],C,Lt,0))>Rt&&(dt=null);return dt}}const Je=_=>{pt.event=_};pt.idxs=mt,pt._lock=!1;let Le=pt.points;Le.show=re(Le.show),Le.size=re(Le.size),Le.stroke=re(Le.stroke),Le.width=re(Le.width),Le.fill=re(Le.fill);const Bn=n.focus=Ke({},i.focus||{alpha:.3},pt.focus),Oi=Bn.prox>=0,Ln=Oi&&Le.one;let gn=[],ki=[],Bi=[];function _s(_,x){let A=Le.show(n,x);if(A instanceof HTMLElement)return Xn(A,Vg),Xn(A,_.class),Ti(A,-10,-10,Z,W),g.insertBefore(A,gn[x]),A}function jr(_,x){if(s==1||x>0){let A=s==1&&M[_.scale].time,L=_.value;_.value=A?zh(L)?qh(K,$h(L,Q)):L||ct:L||i0,_.label=_.label||(A?K_:Y_)}if(Ln||x>0){_.width=_.width==null?1:_.width,_.paths=_.paths||_0||a_,_.fillTo=re(_.fillTo||l0),_.pxAlign=+_e(_.pxAlign,v),_.pxRound=nf(_.pxAlign),_.stroke=re(_.stroke||null),_.fill=re(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let A=s0(Pn(1,_.width),1),L=_.points=Ke({},{size:A,width:Pn(1,A*.2),stroke:_.stroke,space:A*2,paths:v0,_stroke:null,_fill:null},_.points);L.show=re(L.show),L.filter=re(L.filter),L.fill=re(L.fill),L.stroke=re(L.stroke),L.paths=re(L.paths),L.pxAlign=_.pxAlign}if(it){let A=Gt(_,x);It.splice(x,0,A[0]),ce.splice(x,0,A[1]),Mt.values.push(null)}if(at){mt.splice(x,0,null);let A=null;Ln?x==0&&(A=_s(_,x)):x>0&&(A=_s(_,x)),gn.splice(x,0,A),ki.splice(x,0,0),Bi.splice(x,0,0)}hn("addSeries",x)}function Ys(_,x){x=x??E.length,_=s==1?mc(_,x,Kh,tf):mc(_,x,{},Qh),E.splice(x,0,_),jr(E[x],x)}n.addSeries=Ys;function Co(_){if(E.splice(_,1),it){Mt.values.splice(_,1),ce.splice(_,1);let x=It.splice(_,1)[0];P(null,x.firstChild),x.remove()}at&&(mt.splice(_,1),gn.splice(_,1)[0].remove(),ki.splice(_,1),Bi.splice(_,1)),hn("delSeries",_)}n.delSeries=Co;const xi=[!1,!1,!1,!1];function tl(_,x){if(_._show=_.show,_.show){let A=_.side%2,L=M[_.scale];L==null&&(_.scale=A?E[1].scale:R,L=M[_.scale]);let N=L.time;_.size=re(_.size),_.space=re(_.space),_.rotate=re(_.rotate),us(_.incrs)&&_.incrs.forEach(st=>{!ps.has(st)&&ps.set(st,Kd(st))}),_.incrs=re(_.incrs||(L.distr==2?C_:N?p==1?L_:I_:Ps)),_.splits=re(_.splits||(N&&L.distr==1?tt:L.distr==3?hc:L.distr==4?J_:Z_)),_.stroke=re(_.stroke),_.grid.stroke=re(_.grid.stroke),_.ticks.stroke=re(_.ticks.stroke),_.border.stroke=re(_.border.stroke);let q=_.values;_.values=us(q)&&!us(q[0])?re(q):N?us(q)?Xh(K,Wh(q,Q)):zh(q)?O_(K,q):q||ht:q||j_,_.filter=re(_.filter||(L.distr>=3&&L.log==10?e0:L.distr==3&&L.log==2?n0:qd)),_.font=af(_.font),_.labelFont=af(_.labelFont),_._size=_.size(n,null,x,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(xi[x]=!0,_._el=Qn(Bg,f))}}function vs(_,x,A,L){let[N,q,st,lt]=A,dt=x%2,Rt=0;return dt==0&&(lt||q)&&(Rt=x==0&&!N||x==2&&!st?Qe(Yh.size/3):0),dt==1&&(N||st)&&(Rt=x==1&&!q||x==3&&!lt?Qe(Zh.size/2):0),Rt}const Po=n.padding=(i.padding||[vs,vs,vs,vs]).map(_=>re(_e(_,vs))),b=n._padding=Po.map((_,x)=>_(n,x,xi,0));let F,X=null,$=null;const H=s==1?E[0].idxs:null;let ut=null,yt=!1;function Ft(_,x){if(t=_??[],n.data=n._data=t,s==2){F=0;for(let A=1;A<E.length;A++)F+=t[A][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),ut=t[0],F=ut.length;let A=t;if(G==2){A=t.slice();let L=A[0]=Array(F);for(let N=0;N<F;N++)L[N]=N}n._data=t=A}if(js(!0),hn("setData"),G==2&&(de=!0),x!==!1){let A=C;A.auto(n,yt)?Dt():es(R,A.min,A.max),k=k||pt.left>=0,nt=!0,Zs()}}n.setData=Ft;function Dt(){yt=!0;let _,x;s==1&&(F>0?(X=H[0]=0,$=H[1]=F-1,_=t[0][X],x=t[0][$],G==2?(_=X,x=$):_==x&&(G==3?[_,x]=Ha(_,_,C.log,!1):G==4?[_,x]=Su(_,_,C.log,!1):C.time?x=_+Qe(86400/p):[_,x]=Ca(_,x,yu,!0))):(X=H[0]=_=null,$=H[1]=x=null)),es(R,_,x)}let Vt,Xt,Ut,se,Se,we,ln,he,kt,ze;function pe(_,x,A,L,N,q){_??=Eh,A??=bu,L??="butt",N??=Eh,q??="round",_!=Vt&&(h.strokeStyle=Vt=_),N!=Xt&&(h.fillStyle=Xt=N),x!=Ut&&(h.lineWidth=Ut=x),q!=Se&&(h.lineJoin=Se=q),L!=we&&(h.lineCap=we=L),A!=se&&h.setLineDash(se=A)}function Dn(_,x,A,L){x!=Xt&&(h.fillStyle=Xt=x),_!=ln&&(h.font=ln=_),A!=he&&(h.textAlign=he=A),L!=kt&&(h.textBaseline=kt=L)}function Mi(_,x,A,L,N=0){if(L.length>0&&_.auto(n,yt)&&(x==null||x.min==null)){let q=_e(X,0),st=_e($,L.length-1),lt=A.min==null?e_(L,q,st,N,_.distr==3):[A.min,A.max];_.min=pi(_.min,A.min=lt[0]),_.max=Pn(_.max,A.max=lt[1])}}const _n={min:null,max:null};function xs(){for(let L in M){let N=M[L];j[L]==null&&(N.min==null||j[R]!=null&&N.auto(n,yt))&&(j[L]=_n)}for(let L in M){let N=M[L];j[L]==null&&N.from!=null&&j[N.from]!=null&&(j[L]=_n)}j[R]!=null&&js(!0);let _={};for(let L in j){let N=j[L];if(N!=null){let q=_[L]=Ur(M[L],u_);if(N.min!=null)Ke(q,N);else if(L!=R||s==2)if(F==0&&q.from==null){let st=q.range(n,null,null,L);q.min=st[0],q.max=st[1]}else q.min=Ce,q.max=-Ce}}if(F>0){E.forEach((L,N)=>{if(s==1){let q=L.scale,st=j[q];if(st==null)return;let lt=_[q];if(N==0){let dt=lt.range(n,lt.min,lt.max,q);lt.min=dt[0],lt.max=dt[1],X=di(lt.min,t[0]),$=di(lt.max,t[0]),$-X>1&&(t[0][X]<lt.min&&X++,t[0][$]>lt.max&&$--),L.min=ut[X],L.max=ut[$]}else L.show&&L.auto&&Mi(lt,st,L,t[N],L.sorted);L.idxs[0]=X,L.idxs[1]=$}else if(N>0&&L.show&&L.auto){let[q,st]=L.facets,lt=q.scale,dt=st.scale,[Rt,Ct]=t[N],Lt=_[lt],Yt=_[dt];Lt!=null&&Mi(Lt,j[lt],q,Rt,q.sorted),Yt!=null&&Mi(Yt,j[dt],st,Ct,st.sorted),L.min=st.min,L.max=st.max}});for(let L in _){let N=_[L],q=j[L];if(N.from==null&&(q==null||q.min==null)){let st=N.range(n,N.min==Ce?null:N.min,N.max==-Ce?null:N.max,L);N.min=st[0],N.max=st[1]}}}for(let L in _){let N=_[L];if(N.from!=null){let q=_[N.from];if(q.min==null)N.min=N.max=null;else{let st=N.range(n,q.min,q.max,L);N.min=st[0],N.max=st[1]}}}let x={},A=!1;for(let L in _){let N=_[L],q=M[L];if(q.min!=N.min||q.max!=N.max){q.min=N.min,q.max=N.max;let st=q.distr;q._min=st==3?Ki(q.min):st==4?gl(q.min,q.asinh):st==100?q.fwd(q.min):q.min,q._max=st==3?Ki(q.max):st==4?gl(q.max,q.asinh):st==100?q.fwd(q.max):q.max,x[L]=A=!0}}if(A){E.forEach((L,N)=>{s==2?N>0&&x.y&&(L._paths=null):x[L.scale]&&(L._paths=null)});for(let L in x)de=!0,hn("setScale",L);at&&pt.left>=0&&(k=nt=!0)}for(let L in j)j[L]=null}function Re(_){let x=uc(X-1,0,F-1),A=uc($+1,0,F-1);for(;_[x]==null&&x>0;)x--;for(;_[A]==null&&A<F-1;)A++;return[x,A]}function Kn(){if(F>0){let _=E.some(x=>x._focus)&&ze!=Bn.alpha;_&&(h.globalAlpha=ze=Bn.alpha),E.forEach((x,A)=>{if(A>0&&x.show&&(Qi(A,!1),Qi(A,!0),x._paths==null)){let L=ze;ze!=x.alpha&&(h.globalAlpha=ze=x.alpha);let N=s==2?[0,t[A][0].length-1]:Re(t[A]);x._paths=x.paths(n,A,N[0],N[1]),ze!=L&&(h.globalAlpha=ze=L)}}),E.forEach((x,A)=>{if(A>0&&x.show){let L=ze;ze!=x.alpha&&(h.globalAlpha=ze=x.alpha),x._paths!=null&&En(A,!1);{let N=x._paths!=null?x._paths.gaps:null,q=x.points.show(n,A,X,$,N),st=x.points.filter(n,A,q,N);(q||st)&&(x.points._paths=x.points.paths(n,A,X,$,st),En(A,!0))}ze!=L&&(h.globalAlpha=ze=L),hn("drawSeries",A)}}),_&&(h.globalAlpha=ze=1)}}function Qi(_,x){let A=x?E[_].points:E[_];A._stroke=A.stroke(n,_),A._fill=A.fill(n,_)}function En(_,x){let A=x?E[_].points:E[_],{stroke:L,fill:N,clip:q,flags:st,_stroke:lt=A._stroke,_fill:dt=A._fill,_width:Rt=A.width}=A._paths;Rt=Pe(Rt*Me,3);let Ct=null,Lt=Rt%2/2;x&&dt==null&&(dt=Rt>0?"#fff":lt);let Yt=A.pxAlign==1&&Lt>0;if(Yt&&h.translate(Lt,Lt),!x){let xe=vt-Rt/2,ge=Nt-Rt/2,ie=Ot+Rt,Wt=Et+Rt;Ct=new Path2D,Ct.rect(xe,ge,ie,Wt)}x?Ks(lt,Rt,A.dash,A.cap,dt,L,N,st,q):Si(_,lt,Rt,A.dash,A.cap,dt,L,N,st,Ct,q),Yt&&h.translate(-Lt,-Lt)}function Si(_,x,A,L,N,q,st,lt,dt,Rt,Ct){let Lt=!1;dt!=0&&O.forEach((Yt,xe)=>{if(Yt.series[0]==_){let ge=E[Yt.series[1]],ie=t[Yt.series[1]],Wt=(ge._paths||_o).band;us(Wt)&&(Wt=Yt.dir==1?Wt[0]:Wt[1]);let zt,Fe=null;ge.show&&Wt&&i_(ie,X,$)?(Fe=Yt.fill(n,xe)||q,zt=ge._paths.clip):Wt=null,Ks(x,A,L,N,Fe,st,lt,dt,Rt,Ct,zt,Wt),Lt=!0}}),Lt||Ks(x,A,L,N,q,st,lt,dt,Rt,Ct)}const oi=Ir|dc;function Ks(_,x,A,L,N,q,st,lt,dt,Rt,Ct,Lt){pe(_,x,A,L,N),(dt||Rt||Lt)&&(h.save(),dt&&h.clip(dt),Rt&&h.clip(Rt)),Lt?(lt&oi)==oi?(h.clip(Lt),Ct&&h.clip(Ct),Do(N,st),Lo(_,q,x)):lt&dc?(Do(N,st),h.clip(Lt),Lo(_,q,x)):lt&Ir&&(h.save(),h.clip(Lt),Ct&&h.clip(Ct),Do(N,st),h.restore(),Lo(_,q,x)):(Do(N,st),Lo(_,q,x)),(dt||Rt||Lt)&&h.restore()}function Lo(_,x,A){A>0&&(x instanceof Map?x.forEach((L,N)=>{h.strokeStyle=Vt=N,h.stroke(L)}):x!=null&&_&&h.stroke(x))}function Do(_,x){x instanceof Map?x.forEach((A,L)=>{h.fillStyle=Xt=L,h.fill(A)}):x!=null&&_&&h.fill(x)}function _m(_,x,A,L){let N=T[_],q;if(L<=0)q=[0,0];else{let st=N._space=N.space(n,_,x,A,L),lt=N._incrs=N.incrs(n,_,x,A,L,st);q=b0(x,A,lt,L,st)}return N._found=q}function el(_,x,A,L,N,q,st,lt,dt,Rt){let Ct=st%2/2;v==1&&h.translate(Ct,Ct),pe(lt,st,dt,Rt,lt),h.beginPath();let Lt,Yt,xe,ge,ie=N+(L==0||L==3?-q:q);A==0?(Yt=N,ge=ie):(Lt=N,xe=ie);for(let Wt=0;Wt<_.length;Wt++)x[Wt]!=null&&(A==0?Lt=xe=_[Wt]:Yt=ge=_[Wt],h.moveTo(Lt,Yt),h.lineTo(xe,ge));h.stroke(),v==1&&h.translate(-Ct,-Ct)}function vm(_){let x=!0;return T.forEach((A,L)=>{if(!A.show)return;let N=M[A.scale];if(N.min==null){A._show&&(x=!1,A._show=!1,js(!1));return}else A._show||(x=!1,A._show=!0,js(!1));let q=A.side,st=q%2,{min:lt,max:dt}=N,[Rt,Ct]=_m(L,lt,dt,st==0?Z:W);if(Ct==0)return;let Lt=N.distr==2,Yt=A._splits=A.splits(n,L,lt,dt,Rt,Ct,Lt),xe=N.distr==2?Yt.map(zt=>ut[zt]):Yt,ge=N.distr==2?ut[Yt[1]]-ut[Yt[0]]:Rt,ie=A._values=A.values(n,A.filter(n,xe,L,Ct,ge),L,Ct,ge);A._rotate=q==2?A.rotate(n,ie,L,Ct):0;let Wt=A._size;A._size=ei(A.size(n,ie,L,_)),Wt!=null&&A._size!=Wt&&(x=!1)}),x}function xm(_){let x=!0;return Po.forEach((A,L)=>{let N=A(n,L,xi,_);N!=b[L]&&(x=!1),b[L]=N}),x}function Mm(){for(let _=0;_<T.length;_++){let x=T[_];if(!x.show||!x._show)continue;let A=x.side,L=A%2,N,q,st=x.stroke(n,_),lt=A==0||A==3?-1:1,[dt,Rt]=x._found;if(x.label!=null){let wn=x.labelGap*lt,Gn=Qe((x._lpos+wn)*Me);Dn(x.labelFont[0],st,"center",A==2?no:yh),h.save(),L==1?(N=q=0,h.translate(Gn,Qe(Nt+Et/2)),h.rotate((A==3?-va:va)/2)):(N=Qe(vt+Ot/2),q=Gn);let ys=Xd(x.label)?x.label(n,_,dt,Rt):x.label;h.fillText(ys,N,q),h.restore()}if(Rt==0)continue;let Ct=M[x.scale],Lt=L==0?Ot:Et,Yt=L==0?vt:Nt,xe=x._splits,ge=Ct.distr==2?xe.map(wn=>ut[wn]):xe,ie=Ct.distr==2?ut[xe[1]]-ut[xe[0]]:dt,Wt=x.ticks,zt=x.border,Fe=Wt.show?Wt.size:0,We=Qe(Fe*Me),fn=Qe((x.alignTo==2?x._size-Fe-x.gap:x.gap)*Me),Te=x._rotate*-va/180,Xe=m(x._pos*Me),zn=(We+fn)*lt,bn=Xe+zn;q=L==0?bn:0,N=L==1?bn:0;let jn=x.font[0],ai=x.align==1?rr:x.align==2?dl:Te>0?rr:Te<0?dl:L==0?"center":A==3?dl:rr,bi=Te||L==1?"middle":A==2?no:yh;Dn(jn,st,ai,bi);let Hn=x.font[1]*x.lineGap,Zn=xe.map(wn=>m(a(wn,Ct,Lt,Yt))),li=x._values;for(let wn=0;wn<li.length;wn++){let Gn=li[wn];if(Gn!=null){L==0?N=Zn[wn]:q=Zn[wn],Gn=""+Gn;let ys=Gn.indexOf(`
`)==-1?[Gn]:Gn.split(/\n/gm);for(let Tn=0;Tn<ys.length;Tn++){let dh=ys[Tn];Te?(h.save(),h.translate(N,q+Tn*Hn),h.rotate(Te),h.fillText(dh,0,0),h.restore()):h.fillText(dh,N,q+Tn*Hn)}}}Wt.show&&el(Zn,Wt.filter(n,ge,_,Rt,ie),L,A,Xe,We,Pe(Wt.width*Me,3),Wt.stroke(n,_),Wt.dash,Wt.cap);let wi=x.grid;wi.show&&el(Zn,wi.filter(n,ge,_,Rt,ie),L,L==0?2:1,L==0?Nt:vt,L==0?Et:Ot,Pe(wi.width*Me,3),wi.stroke(n,_),wi.dash,wi.cap),zt.show&&el([Xe],[1],L==0?1:0,L==0?1:2,L==1?Nt:vt,L==1?Et:Ot,Pe(zt.width*Me,3),zt.stroke(n,_),zt.dash,zt.cap)}hn("drawAxes")}function js(_){E.forEach((x,A)=>{A>0&&(x._paths=null,_&&(s==1?(x.min=null,x.max=null):x.facets.forEach(L=>{L.min=null,L.max=null})))})}let Uo=!1,nl=!1,Zr=[];function Sm(){nl=!1;for(let _=0;_<Zr.length;_++)hn(...Zr[_]);Zr.length=0}function Zs(){Uo||(__(Ku),Uo=!0)}function ym(_,x=!1){Uo=!0,nl=x,_(n),Ku(),x&&Zr.length>0&&queueMicrotask(Sm)}n.batch=ym;function Ku(){if(ne&&(xs(),ne=!1),de&&(Zt(),de=!1),qt){if(Oe(d,rr,et),Oe(d,no,St),Oe(d,uo,Z),Oe(d,ho,W),Oe(g,rr,et),Oe(g,no,St),Oe(g,uo,Z),Oe(g,ho,W),Oe(f,uo,y),Oe(f,ho,Y),u.width=Qe(y*Me),u.height=Qe(Y*Me),T.forEach(({_el:_,_show:x,_size:A,_pos:L,side:N})=>{if(_!=null)if(x){let q=N===3||N===0?A:0,st=N%2==1;Oe(_,st?"left":"top",L-q),Oe(_,st?"width":"height",A),Oe(_,st?"top":"left",st?St:et),Oe(_,st?"height":"width",st?W:Z),lc(_,Us)}else Xn(_,Us)}),Vt=Xt=Ut=Se=we=ln=he=kt=se=null,ze=1,to(!0),et!=_t||St!=wt||Z!=Kt||W!=ft){js(!1);let _=Z/Kt,x=W/ft;if(at&&!k&&pt.left>=0){pt.left*=_,pt.top*=x,Js&&Ti(Js,Qe(pt.left),0,Z,W),Qs&&Ti(Qs,0,Qe(pt.top),Z,W);for(let A=0;A<gn.length;A++){let L=gn[A];L!=null&&(ki[A]*=_,Bi[A]*=x,Ti(L,ei(ki[A]),ei(Bi[A]),Z,W))}}if(Ne.show&&!xt&&Ne.left>=0&&Ne.width>0){Ne.left*=_,Ne.width*=_,Ne.top*=x,Ne.height*=x;for(let A in ll)Oe(nr,A,Ne[A])}_t=et,wt=St,Kt=Z,ft=W}hn("setSize"),qt=!1}y>0&&Y>0&&(h.clearRect(0,0,u.width,u.height),hn("drawClear"),U.forEach(_=>_()),hn("draw")),Ne.show&&xt&&(Io(Ne),xt=!1),at&&k&&(Ss(null,!0,!1),k=!1),Mt.show&&Mt.live&&nt&&(ol(),nt=!1),l||(l=!0,n.status=1,hn("ready")),yt=!1,Uo=!1}n.redraw=(_,x)=>{de=x||!1,_!==!1?es(R,C.min,C.max):Zs()};function il(_,x){let A=M[_];if(A.from==null){if(F==0){let L=A.range(n,x.min,x.max,_);x.min=L[0],x.max=L[1]}if(x.min>x.max){let L=x.min;x.min=x.max,x.max=L}if(F>1&&x.min!=null&&x.max!=null&&x.max-x.min<1e-16)return;_==R&&A.distr==2&&F>0&&(x.min=di(x.min,t[0]),x.max=di(x.max,t[0]),x.min==x.max&&x.max++),j[_]=x,ne=!0,Zs()}}n.setScale=il;let sl,rl,Js,Qs,ju,Zu,tr,er,Ju,Qu,Ie,He,ts=!1;const mn=pt.drag;let cn=mn.x,un=mn.y;at&&(pt.x&&(sl=Qn(Hg,g)),pt.y&&(rl=Qn(Gg,g)),C.ori==0?(Js=sl,Qs=rl):(Js=rl,Qs=sl),Ie=pt.left,He=pt.top);const Ne=n.select=Ke({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),nr=Ne.show?Qn(zg,Ne.over?g:d):null;function Io(_,x){if(Ne.show){for(let A in _)Ne[A]=_[A],A in ll&&Oe(nr,A,_[A]);x!==!1&&hn("setSelect")}}n.setSelect=Io;function Em(_){if(E[_].show)it&&lc(It[_],Us);else if(it&&Xn(It[_],Us),at){let A=Ln?gn[0]:gn[_];A!=null&&Ti(A,-10,-10,Z,W)}}function es(_,x,A){il(_,{min:x,max:A})}function yi(_,x,A,L){x.focus!=null&&Rm(_),x.show!=null&&E.forEach((N,q)=>{q>0&&(_==q||_==null)&&(N.show=x.show,Em(q),s==2?(es(N.facets[0].scale,null,null),es(N.facets[1].scale,null,null)):es(N.scale,null,null),Zs())}),A!==!1&&hn("setSeries",_,x),L&&eo("setSeries",n,_,x)}n.setSeries=yi;function bm(_,x){Ke(O[_],x)}function wm(_,x){_.fill=re(_.fill||null),_.dir=_e(_.dir,-1),x=x??O.length,O.splice(x,0,_)}function Tm(_){_==null?O.length=0:O.splice(_,1)}n.addBand=wm,n.setBand=bm,n.delBand=Tm;function Am(_,x){E[_].alpha=x,at&&gn[_]!=null&&(gn[_].style.opacity=x),it&&It[_]&&(It[_].style.opacity=x)}let zi,ns,Ms;const ir={focus:!0};function Rm(_){if(_!=Ms){let x=_==null,A=Bn.alpha!=1;E.forEach((L,N)=>{if(s==1||N>0){let q=x||N==0||N==_;L._focus=x?null:q,A&&Am(N,q?1:Bn.alpha)}}),Ms=_,A&&Zs()}}it&&Oi&&Pt(Th,ot,_=>{pt._lock||(Je(_),Ms!=null&&yi(null,ir,!0,qe.setSeries))});function Ei(_,x,A){let L=M[x];A&&(_=_/Me-(L.ori==1?St:et));let N=Z;L.ori==1&&(N=W,_=N-_),L.dir==-1&&(_=N-_);let q=L._min,st=L._max,lt=_/N,dt=q+(st-q)*lt,Rt=L.distr;return Rt==3?Lr(10,dt):Rt==4?r_(dt,L.asinh):Rt==100?L.bwd(dt):dt}function Cm(_,x){let A=Ei(_,R,x);return di(A,t[0],X,$)}n.valToIdx=_=>di(_,t[0]),n.posToIdx=Cm,n.posToVal=Ei,n.valToPos=(_,x,A)=>M[x].ori==0?r(_,M[x],A?Ot:Z,A?vt:0):o(_,M[x],A?Et:W,A?Nt:0),n.setCursor=(_,x,A)=>{Ie=_.left,He=_.top,Ss(null,x,A)};function th(_,x){Oe(nr,rr,Ne.left=_),Oe(nr,uo,Ne.width=x)}function eh(_,x){Oe(nr,no,Ne.top=_),Oe(nr,ho,Ne.height=x)}let Jr=C.ori==0?th:eh,Qr=C.ori==1?th:eh;function Pm(){if(it&&Mt.live)for(let _=s==2?1:0;_<E.length;_++){if(_==0&&ue)continue;let x=Mt.values[_],A=0;for(let L in x)ce[_][A++].firstChild.nodeValue=x[L]}}function ol(_,x){if(_!=null&&(_.idxs?_.idxs.forEach((A,L)=>{mt[L]=A}):c_(_.idx)||mt.fill(_.idx),Mt.idx=mt[0]),it&&Mt.live){for(let A=0;A<E.length;A++)(A>0||s==1&&!ue)&&Lm(A,mt[A]);Pm()}nt=!1,x!==!1&&hn("setLegend")}n.setLegend=ol;function Lm(_,x){let A=E[_],L=_==0&&G==2?ut:t[_],N;ue?N=A.values(n,_,x)??B:(N=A.value(n,x==null?null:L[x],_,x),N=N==null?B:{_:N}),Mt.values[_]=N}function Ss(_,x,A){Ju=Ie,Qu=He,[Ie,He]=pt.move(n,Ie,He),pt.left=Ie,pt.top=He,at&&(Js&&Ti(Js,Qe(Ie),0,Z,W),Qs&&Ti(Qs,0,Qe(He),Z,W));let L,N=X>$;zi=Ce,ns=null;let q=C.ori==0?Z:W,st=C.ori==1?Z:W;if(Ie<0||F==0||N){L=pt.idx=null;for(let lt=0;lt<E.length;lt++){let dt=gn[lt];dt!=null&&Ti(dt,-10,-10,Z,W)}Oi&&yi(null,ir,!0,_==null&&qe.setSeries),Mt.live&&(mt.fill(L),nt=!0)}else{let lt,dt,Rt;s==1&&(lt=C.ori==0?Ie:He,dt=Ei(lt,R),L=pt.idx=di(dt,t[0],X,$),Rt=I(t[0][L],C,q,0));let Ct=-10,Lt=-10,Yt=0,xe=0,ge=!0,ie="",Wt="";for(let zt=s==2?1:0;zt<E.length;zt++){let Fe=E[zt],We=mt[zt],fn=We==null?null:s==1?t[zt][We]:t[zt][1][We],Te=pt.dataIdx(n,zt,L,dt),Xe=Te==null?null:s==1?t[zt][Te]:t[zt][1][Te];if(nt=nt||Xe!=fn||Te!=We,mt[zt]=Te,zt>0&&Fe.show){let zn=Te==null?-10:Te==L?Rt:I(s==1?t[0][Te]:t[zt][0][Te],C,q,0),bn=Xe==null?-10:V(Xe,s==1?M[Fe.scale]:M[Fe.facets[1].scale],st,0);if(Oi&&Xe!=null){let jn=C.ori==1?Ie:He,ai=tn(Bn.dist(n,zt,Te,bn,jn));if(ai<zi){let bi=Bn.bias;if(bi!=0){let Hn=Ei(jn,Fe.scale),Zn=Xe>=0?1:-1,li=Hn>=0?1:-1;li==Zn&&(li==1?bi==1?Xe>=Hn:Xe<=Hn:bi==1?Xe<=Hn:Xe>=Hn)&&(zi=ai,ns=zt)}else zi=ai,ns=zt}}if(nt||Ln){let jn,ai;C.ori==0?(jn=zn,ai=bn):(jn=bn,ai=zn);let bi,Hn,Zn,li,wi,wn,Gn=!0,ys=Le.bbox;if(ys!=null){Gn=!1;let Tn=ys(n,zt);Zn=Tn.left,li=Tn.top,bi=Tn.width,Hn=Tn.height}else Zn=jn,li=ai,bi=Hn=Le.size(n,zt);if(wn=Le.fill(n,zt),wi=Le.stroke(n,zt),Ln)zt==ns&&zi<=Bn.prox&&(Ct=Zn,Lt=li,Yt=bi,xe=Hn,ge=Gn,ie=wn,Wt=wi);else{let Tn=gn[zt];Tn!=null&&(ki[zt]=Zn,Bi[zt]=li,Uh(Tn,bi,Hn,Gn),Lh(Tn,wn,wi),Ti(Tn,ei(Zn),ei(li),Z,W))}}}}if(Ln){let zt=Bn.prox,Fe=Ms==null?zi<=zt:zi>zt||ns!=Ms;if(nt||Fe){let We=gn[0];We!=null&&(ki[0]=Ct,Bi[0]=Lt,Uh(We,Yt,xe,ge),Lh(We,ie,Wt),Ti(We,ei(Ct),ei(Lt),Z,W))}}}if(Ne.show&&ts)if(_!=null){let[lt,dt]=qe.scales,[Rt,Ct]=qe.match,[Lt,Yt]=_.cursor.sync.scales,xe=_.cursor.drag;if(cn=xe._x,un=xe._y,cn||un){let{left:ge,top:ie,width:Wt,height:zt}=_.select,Fe=_.scales[Lt].ori,We=_.posToVal,fn,Te,Xe,zn,bn,jn=lt!=null&&Rt(lt,Lt),ai=dt!=null&&Ct(dt,Yt);jn&&cn?(Fe==0?(fn=ge,Te=Wt):(fn=ie,Te=zt),Xe=M[lt],zn=I(We(fn,Lt),Xe,q,0),bn=I(We(fn+Te,Lt),Xe,q,0),Jr(pi(zn,bn),tn(bn-zn))):Jr(0,q),ai&&un?(Fe==1?(fn=ge,Te=Wt):(fn=ie,Te=zt),Xe=M[dt],zn=V(We(fn,Yt),Xe,st,0),bn=V(We(fn+Te,Yt),Xe,st,0),Qr(pi(zn,bn),tn(bn-zn))):Qr(0,st)}else cl()}else{let lt=tn(Ju-ju),dt=tn(Qu-Zu);if(C.ori==1){let Yt=lt;lt=dt,dt=Yt}cn=mn.x&&lt>=mn.dist,un=mn.y&&dt>=mn.dist;let Rt=mn.uni;Rt!=null?cn&&un&&(cn=lt>=Rt,un=dt>=Rt,!cn&&!un&&(dt>lt?un=!0:cn=!0)):mn.x&&mn.y&&(cn||un)&&(cn=un=!0);let Ct,Lt;cn&&(C.ori==0?(Ct=tr,Lt=Ie):(Ct=er,Lt=He),Jr(pi(Ct,Lt),tn(Lt-Ct)),un||Qr(0,st)),un&&(C.ori==1?(Ct=tr,Lt=Ie):(Ct=er,Lt=He),Qr(pi(Ct,Lt),tn(Lt-Ct)),cn||Jr(0,q)),!cn&&!un&&(Jr(0,0),Qr(0,0))}if(mn._x=cn,mn._y=un,_==null){if(A){if(fh!=null){let[lt,dt]=qe.scales;qe.values[0]=lt!=null?Ei(C.ori==0?Ie:He,lt):null,qe.values[1]=dt!=null?Ei(C.ori==1?Ie:He,dt):null}eo(pl,n,Ie,He,Z,W,L)}if(Oi){let lt=A&&qe.setSeries,dt=Bn.prox;Ms==null?zi<=dt&&yi(ns,ir,!0,lt):zi>dt?yi(null,ir,!0,lt):ns!=Ms&&yi(ns,ir,!0,lt)}}nt&&(Mt.idx=L,ol()),x!==!1&&hn("setCursor")}let is=null;Object.defineProperty(n,"rect",{get(){return is==null&&to(!1),is}});function to(_=!1){_?is=null:(is=g.getBoundingClientRect(),hn("syncRect",is))}function nh(_,x,A,L,N,q,st){pt._lock||ts&&_!=null&&_.movementX==0&&_.movementY==0||(al(_,x,A,L,N,q,st,!1,_!=null),_!=null?Ss(null,!0,!0):Ss(x,!0,!1))}function al(_,x,A,L,N,q,st,lt,dt){if(is==null&&to(!1),Je(_),_!=null)A=_.clientX-is.left,L=_.clientY-is.top;else{if(A<0||L<0){Ie=-10,He=-10;return}let[Rt,Ct]=qe.scales,Lt=x.cursor.sync,[Yt,xe]=Lt.values,[ge,ie]=Lt.scales,[Wt,zt]=qe.match,Fe=x.axes[0].side%2==1,We=C.ori==0?Z:W,fn=C.ori==1?Z:W,Te=Fe?q:N,Xe=Fe?N:q,zn=Fe?L:A,bn=Fe?A:L;if(ge!=null?A=Wt(Rt,ge)?a(Yt,M[Rt],We,0):-10:A=We*(zn/Te),ie!=null?L=zt(Ct,ie)?a(xe,M[Ct],fn,0):-10:L=fn*(bn/Xe),C.ori==1){let jn=A;A=L,L=jn}}dt&&(x==null||x.cursor.event.type==pl)&&((A<=1||A>=Z-1)&&(A=Cs(A,Z)),(L<=1||L>=W-1)&&(L=Cs(L,W))),lt?(ju=A,Zu=L,[tr,er]=pt.move(n,A,L)):(Ie=A,He=L)}const ll={width:0,height:0,left:0,top:0};function cl(){Io(ll,!1)}let ih,sh,rh,oh;function ah(_,x,A,L,N,q,st){ts=!0,cn=un=mn._x=mn._y=!1,al(_,x,A,L,N,q,st,!0,!1),_!=null&&(Pt(ml,oc,lh,!1),eo(bh,n,tr,er,Z,W,null));let{left:lt,top:dt,width:Rt,height:Ct}=Ne;ih=lt,sh=dt,rh=Rt,oh=Ct}function lh(_,x,A,L,N,q,st){ts=mn._x=mn._y=!1,al(_,x,A,L,N,q,st,!1,!0);let{left:lt,top:dt,width:Rt,height:Ct}=Ne,Lt=Rt>0||Ct>0,Yt=ih!=lt||sh!=dt||rh!=Rt||oh!=Ct;if(Lt&&Yt&&Io(Ne),mn.setScale&&Lt&&Yt){let xe=lt,ge=Rt,ie=dt,Wt=Ct;if(C.ori==1&&(xe=dt,ge=Ct,ie=lt,Wt=Rt),cn&&es(R,Ei(xe,R),Ei(xe+ge,R)),un)for(let zt in M){let Fe=M[zt];zt!=R&&Fe.from==null&&Fe.min!=Ce&&es(zt,Ei(ie+Wt,zt),Ei(ie,zt))}cl()}else pt.lock&&(pt._lock=!pt._lock,Ss(x,!0,_!=null));_!=null&&(P(ml,oc),eo(ml,n,Ie,He,Z,W,null))}function Dm(_,x,A,L,N,q,st){if(pt._lock)return;Je(_);let lt=ts;if(ts){let dt=!0,Rt=!0,Ct=10,Lt,Yt;C.ori==0?(Lt=cn,Yt=un):(Lt=un,Yt=cn),Lt&&Yt&&(dt=Ie<=Ct||Ie>=Z-Ct,Rt=He<=Ct||He>=W-Ct),Lt&&dt&&(Ie=Ie<tr?0:Z),Yt&&Rt&&(He=He<er?0:W),Ss(null,!0,!0),ts=!1}Ie=-10,He=-10,mt.fill(null),Ss(null,!0,!0),lt&&(ts=lt)}function ch(_,x,A,L,N,q,st){pt._lock||(Je(_),Dt(),cl(),_!=null&&eo(Ah,n,Ie,He,Z,W,null))}function uh(){T.forEach(w0),rt(n.width,n.height,!0)}ks(Ra,wr,uh);const sr={};sr.mousedown=ah,sr.mousemove=nh,sr.mouseup=lh,sr.dblclick=ch,sr.setSeries=(_,x,A,L)=>{let N=qe.match[2];A=N(n,x,A),A!=-1&&yi(A,L,!0,!1)},at&&(Pt(bh,g,ah),Pt(pl,g,nh),Pt(wh,g,_=>{Je(_),to(!1)}),Pt(Th,g,Dm),Pt(Ah,g,ch),pc.add(n),n.syncRect=to);const No=n.hooks=i.hooks||{};function hn(_,x,A){nl?Zr.push([_,x,A]):_ in No&&No[_].forEach(L=>{L.call(null,n,x,A)})}(i.plugins||[]).forEach(_=>{for(let x in _.hooks)No[x]=(No[x]||[]).concat(_.hooks[x])});const hh=(_,x,A)=>A,qe=Ke({key:null,setSeries:!1,filters:{pub:kh,sub:kh},scales:[R,E[1]?E[1].scale:null],match:[Bh,Bh,hh],values:[null,null]},pt.sync);qe.match.length==2&&qe.match.push(hh),pt.sync=qe;const fh=qe.key,ul=mp(fh);function eo(_,x,A,L,N,q,st){qe.filters.pub(_,x,A,L,N,q,st)&&ul.pub(_,x,A,L,N,q,st)}ul.sub(n);function Um(_,x,A,L,N,q,st){qe.filters.sub(_,x,A,L,N,q,st)&&sr[_](null,x,A,L,N,q,st)}n.pub=Um;function Im(){ul.unsub(n),pc.delete(n),fe.clear(),cc(Ra,wr,uh),c.remove(),ot?.remove(),hn("destroy")}n.destroy=Im;function hl(){hn("init",i,t),Ft(t||i.data,!1),j[R]?il(R,j[R]):Dt(),xt=Ne.show&&(Ne.width>0||Ne.height>0),k=nt=!0,rt(i.width,i.height)}return E.forEach(jr),T.forEach(tl),e?e instanceof HTMLElement?(e.appendChild(c),hl()):e(n,hl):hl(),n}yn.assign=Ke;yn.fmtNum=Eu;yn.rangeNum=Ca;yn.rangeLog=Ha;yn.rangeAsinh=Su;yn.orient=Ws;yn.pxRatio=Me;yn.join=g_;yn.fmtDate=wu,yn.tzDate=A_;yn.sync=mp;{yn.addGap=c0,yn.clipGaps=Wa;let i=yn.paths={points:Sp};i.linear=Ep,i.stepped=f0,i.bars=d0,i.spline=m0}const zo=i=>document.getElementById(i),T0=["#7cc4ff","#56d6b0","#d59bf6","#ffb652","#f2f5f8","#ff7a5c"];function A0(i,t,e,n){const s={stroke:"#8fa1b3",grid:{stroke:"#1b2733",width:1},ticks:{stroke:"#1b2733"},font:`${.68*n}px system-ui`,size:2.3*n},r={stroke:"#ffb65290",width:1,dash:[4,4],points:{show:!1}};return{width:t,height:e,legend:{show:!1},cursor:{show:!1},padding:[n*.3,n*.4,0,0],scales:{x:{time:!1},y:{range:(o,a,l)=>{const c=Math.max(Math.abs(a||0),Math.abs(l||0),i.least);return[-c*1.1,c*1.1]}}},axes:[{...s,size:1.5*n,gap:1},{...s,gap:1,space:1.5*n,label:i.title,labelSize:1.1*n,labelFont:`${.7*n}px system-ui`}],series:[{},...i.curves.map((o,a)=>({stroke:T0[a],width:1.5,points:{show:!1}})),r,r]}}class R0{constructor(t,e){Object.assign(this,{strip:t,window:e,element:document.createElement("div")})}size(){const t=parseFloat(getComputedStyle(document.documentElement).fontSize),e=this.element.parentElement.clientWidth;return{width:Math.max(e,60),height:6.4*t,rem:t}}show({t,curves:e,spread:n},s){const r=this.size();(!this.plot||this.width!==r.width)&&(this.plot&&this.plot.destroy(),this.plot=new yn(A0(this.strip,r.width,r.height,r.rem),[[],...e.map(()=>[]),[],[]],this.element),this.width=r.width);let o=t.length;if(s!==void 0)for(;o>0&&t[o-1]>s;)o-=1;let a=o;for(;a>0&&t[a-1]>(t[o-1]??0)-this.window;)a-=1;const l=u=>u.slice(a,o),c=l(n);this.plot.setData([l(t),...e.map(l),c,c.map(u=>u===null?null:-u)])}}class C0{setDisplay({charts:t}){zo("strips").hidden=!t,this.note=t?.note,this.strips=(t?.strips||[]).map(e=>new R0(e,t.window_s)),zo("charts").replaceChildren(...this.strips.map(e=>e.element)),zo("charts-title").textContent=t?.title||""}show(t,e,n){this.strips.forEach((s,r)=>s.show(t[r],n)),this.note&&sc(Cr(e,this.note)??["",!1],zo("charts-note"),"dim")}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const Du="170",P0=0,lf=1,L0=2,Ap=1,D0=2,$i=3,ms=0,Fn=1,Ri=2,fs=0,Tr=1,cf=2,uf=3,hf=4,U0=5,Is=100,I0=101,N0=102,F0=103,O0=104,k0=200,B0=201,z0=202,H0=203,gc=204,_c=205,G0=206,V0=207,W0=208,X0=209,$0=210,q0=211,Y0=212,K0=213,j0=214,vc=0,xc=1,Mc=2,Nr=3,Sc=4,yc=5,Ec=6,bc=7,Uu=0,Z0=1,J0=2,ds=0,Q0=1,tv=2,ev=3,nv=4,iv=5,sv=6,rv=7,Rp=300,Fr=301,Or=302,wc=303,Tc=304,Ya=306,Ac=1e3,Fs=1001,Rc=1002,vi=1003,ov=1004,Ho=1005,Pi=1006,Ml=1007,Os=1008,Ji=1009,Cp=1010,Pp=1011,So=1012,Iu=1013,zs=1014,qi=1015,wo=1016,Nu=1017,Fu=1018,kr=1020,Lp=35902,Dp=1021,Up=1022,gi=1023,Ip=1024,Np=1025,Ar=1026,Br=1027,Fp=1028,Ou=1029,Op=1030,ku=1031,Bu=1033,xa=33776,Ma=33777,Sa=33778,ya=33779,Cc=35840,Pc=35841,Lc=35842,Dc=35843,Uc=36196,Ic=37492,Nc=37496,Fc=37808,Oc=37809,kc=37810,Bc=37811,zc=37812,Hc=37813,Gc=37814,Vc=37815,Wc=37816,Xc=37817,$c=37818,qc=37819,Yc=37820,Kc=37821,Ea=36492,jc=36494,Zc=36495,kp=36283,Jc=36284,Qc=36285,tu=36286,av=3200,lv=3201,Bp=0,cv=1,hs="",ni="srgb",Xs="srgb-linear",Ka="linear",Ae="srgb",or=7680,ff=519,uv=512,hv=513,fv=514,zp=515,dv=516,pv=517,mv=518,gv=519,df=35044,pf="300 es",Yi=2e3,La=2001;class Wr{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const n=this._listeners;return n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const n=this._listeners[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ba=Math.PI/180,eu=180/Math.PI;function To(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(vn[i&255]+vn[i>>8&255]+vn[i>>16&255]+vn[i>>24&255]+"-"+vn[t&255]+vn[t>>8&255]+"-"+vn[t>>16&15|64]+vn[t>>24&255]+"-"+vn[e&63|128]+vn[e>>8&255]+"-"+vn[e>>16&255]+vn[e>>24&255]+vn[n&255]+vn[n>>8&255]+vn[n>>16&255]+vn[n>>24&255]).toLowerCase()}function Cn(i,t,e){return Math.max(t,Math.min(e,i))}function _v(i,t){return(i%t+t)%t}function Sl(i,t,e){return(1-e)*i+e*t}function so(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Un(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}class ae{constructor(t=0,e=0){ae.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Cn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Qt{constructor(t,e,n,s,r,o,a,l,c){Qt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],g=n[8],v=s[0],m=s[3],p=s[6],E=s[1],T=s[4],M=s[7],O=s[2],R=s[5],D=s[8];return r[0]=o*v+a*E+l*O,r[3]=o*m+a*T+l*R,r[6]=o*p+a*M+l*D,r[1]=c*v+u*E+h*O,r[4]=c*m+u*T+h*R,r[7]=c*p+u*M+h*D,r[2]=f*v+d*E+g*O,r[5]=f*m+d*T+g*R,r[8]=f*p+d*M+g*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return t[0]=h*v,t[1]=(s*c-u*n)*v,t[2]=(a*n-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(n*l-c*e)*v,t[8]=(o*e-n*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(yl.makeScale(t,e)),this}rotate(t){return this.premultiply(yl.makeRotation(-t)),this}translate(t,e){return this.premultiply(yl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const yl=new Qt;function Hp(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Da(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function vv(){const i=Da("canvas");return i.style.display="block",i}const mf={};function po(i){i in mf||(mf[i]=!0,console.warn(i))}function xv(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}function Mv(i){const t=i.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function Sv(i){const t=i.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const me={enabled:!0,workingColorSpace:Xs,spaces:{},convert:function(i,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ae&&(i.r=Zi(i.r),i.g=Zi(i.g),i.b=Zi(i.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(i.applyMatrix3(this.spaces[t].toXYZ),i.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ae&&(i.r=Rr(i.r),i.g=Rr(i.g),i.b=Rr(i.b))),i},fromWorkingColorSpace:function(i,t){return this.convert(i,this.workingColorSpace,t)},toWorkingColorSpace:function(i,t){return this.convert(i,t,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===hs?Ka:this.spaces[i].transfer},getLuminanceCoefficients:function(i,t=this.workingColorSpace){return i.fromArray(this.spaces[t].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,t,e){return i.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}};function Zi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Rr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}const gf=[.64,.33,.3,.6,.15,.06],_f=[.2126,.7152,.0722],vf=[.3127,.329],xf=new Qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Mf=new Qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);me.define({[Xs]:{primaries:gf,whitePoint:vf,transfer:Ka,toXYZ:xf,fromXYZ:Mf,luminanceCoefficients:_f,workingColorSpaceConfig:{unpackColorSpace:ni},outputColorSpaceConfig:{drawingBufferColorSpace:ni}},[ni]:{primaries:gf,whitePoint:vf,transfer:Ae,toXYZ:xf,fromXYZ:Mf,luminanceCoefficients:_f,outputColorSpaceConfig:{drawingBufferColorSpace:ni}}});let ar;class yv{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{ar===void 0&&(ar=Da("canvas")),ar.width=t.width,ar.height=t.height;const n=ar.getContext("2d");t instanceof ImageData?n.putImageData(t,0,0):n.drawImage(t,0,0,t.width,t.height),e=ar}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Da("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Zi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Zi(e[n]/255)*255):e[n]=Zi(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let Ev=0;class Gp{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:Ev++}),this.uuid=To(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(El(s[o].image)):r.push(El(s[o]))}else r=El(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function El(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?yv.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let bv=0;class On extends Wr{constructor(t=On.DEFAULT_IMAGE,e=On.DEFAULT_MAPPING,n=Fs,s=Fs,r=Pi,o=Os,a=gi,l=Ji,c=On.DEFAULT_ANISOTROPY,u=hs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:bv++}),this.uuid=To(),this.name="",this.source=new Gp(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ae(0,0),this.repeat=new ae(1,1),this.center=new ae(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Rp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ac:t.x=t.x-Math.floor(t.x);break;case Fs:t.x=t.x<0?0:1;break;case Rc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ac:t.y=t.y-Math.floor(t.y);break;case Fs:t.y=t.y<0?0:1;break;case Rc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}On.DEFAULT_IMAGE=null;On.DEFAULT_MAPPING=Rp;On.DEFAULT_ANISOTROPY=1;class Ge{constructor(t=0,e=0,n=0,s=1){Ge.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,M=(d+1)/2,O=(p+1)/2,R=(u+f)/4,D=(h+v)/4,U=(g+m)/4;return T>M&&T>O?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=R/n,r=D/n):M>O?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=R/s,r=U/s):O<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(O),n=D/r,s=U/r),this.set(n,s,r,e),this}let E=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(E)<.001&&(E=1),this.x=(m-g)/E,this.y=(h-v)/E,this.z=(f-u)/E,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class wv extends Wr{constructor(t=1,e=1,n={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new Ge(0,0,t,e),this.scissorTest=!1,this.viewport=new Ge(0,0,t,e);const s={width:t,height:e,depth:1};n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Pi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},n);const r=new On(s,n.mapping,n.wrapS,n.wrapT,n.magFilter,n.minFilter,n.format,n.type,n.anisotropy,n.colorSpace);r.flipY=!1,r.generateMipmaps=n.generateMipmaps,r.internalFormat=n.internalFormat,this.textures=[];const o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.depthTexture=n.depthTexture,this.samples=n.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let n=0,s=t.textures.length;n<s;n++)this.textures[n]=t.textures[n].clone(),this.textures[n].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new Gp(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Hs extends wv{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class Vp extends On{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class Tv extends On{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=vi,this.minFilter=vi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class $s{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3];const f=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==f||c!==d||u!==g){let m=1-a;const p=l*f+c*d+u*g+h*v,E=p>=0?1:-1,T=1-p*p;if(T>Number.EPSILON){const O=Math.sqrt(T),R=Math.atan2(O,p*E);m=Math.sin(m*R)/O,a=Math.sin(a*R)/O}const M=a*E;if(l=l*m+f*M,c=c*m+d*M,u=u*m+g*M,h=h*m+v*M,m===1-a){const O=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=O,c*=O,u*=O,h*=O}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){const d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>h){const d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){const d=2*Math.sqrt(1+a-n-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+h-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<Number.EPSILON?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Cn(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const n=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const d=1-e;return this._w=d*o+e*this._w,this._x=d*n+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class z{constructor(t=0,e=0,n=0){z.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Sf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Sf.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),u=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Math.max(t,Math.min(e,n)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return bl.copy(this).projectOnVector(t),this.sub(bl)}reflect(t){return this.sub(bl.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Cn(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const bl=new z,Sf=new $s;class Xr{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(ci.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(ci.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=ci.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ci):ci.fromBufferAttribute(r,o),ci.applyMatrix4(t.matrixWorld),this.expandByPoint(ci);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Go.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Go.copy(n.boundingBox)),Go.applyMatrix4(t.matrixWorld),this.union(Go)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ci),ci.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ro),Vo.subVectors(this.max,ro),lr.subVectors(t.a,ro),cr.subVectors(t.b,ro),ur.subVectors(t.c,ro),ss.subVectors(cr,lr),rs.subVectors(ur,cr),Es.subVectors(lr,ur);let e=[0,-ss.z,ss.y,0,-rs.z,rs.y,0,-Es.z,Es.y,ss.z,0,-ss.x,rs.z,0,-rs.x,Es.z,0,-Es.x,-ss.y,ss.x,0,-rs.y,rs.x,0,-Es.y,Es.x,0];return!wl(e,lr,cr,ur,Vo)||(e=[1,0,0,0,1,0,0,0,1],!wl(e,lr,cr,ur,Vo))?!1:(Wo.crossVectors(ss,rs),e=[Wo.x,Wo.y,Wo.z],wl(e,lr,cr,ur,Vo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ci).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ci).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Hi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Hi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Hi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Hi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Hi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Hi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Hi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Hi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Hi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const Hi=[new z,new z,new z,new z,new z,new z,new z,new z],ci=new z,Go=new Xr,lr=new z,cr=new z,ur=new z,ss=new z,rs=new z,Es=new z,ro=new z,Vo=new z,Wo=new z,bs=new z;function wl(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){bs.fromArray(i,r);const a=s.x*Math.abs(bs.x)+s.y*Math.abs(bs.y)+s.z*Math.abs(bs.z),l=t.dot(bs),c=e.dot(bs),u=n.dot(bs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const Av=new Xr,oo=new z,Tl=new z;class Ao{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):Av.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;oo.subVectors(t,this.center);const e=oo.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(oo,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Tl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(oo.copy(t.center).add(Tl)),this.expandByPoint(oo.copy(t.center).sub(Tl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Gi=new z,Al=new z,Xo=new z,os=new z,Rl=new z,$o=new z,Cl=new z;class zu{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Gi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Gi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Gi.copy(this.origin).addScaledVector(this.direction,e),Gi.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Al.copy(t).add(e).multiplyScalar(.5),Xo.copy(e).sub(t).normalize(),os.copy(this.origin).sub(Al);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Xo),a=os.dot(this.direction),l=-os.dot(Xo),c=os.lengthSq(),u=Math.abs(1-o*o);let h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){const v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Al).addScaledVector(Xo,f),d}intersectSphere(t,e){Gi.subVectors(t.center,this.origin);const n=Gi.dot(this.direction),s=Gi.dot(Gi)-n*n,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Gi)!==null}intersectTriangle(t,e,n,s,r){Rl.subVectors(e,t),$o.subVectors(n,t),Cl.crossVectors(Rl,$o);let o=this.direction.dot(Cl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;os.subVectors(this.origin,t);const l=a*this.direction.dot($o.crossVectors(os,$o));if(l<0)return null;const c=a*this.direction.dot(Rl.cross(os));if(c<0||l+c>o)return null;const u=-a*os.dot(Cl);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Ue{constructor(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m){Ue.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m)}set(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Ue().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,n=t.elements,s=1/hr.setFromMatrixColumn(t,0).length(),r=1/hr.setFromMatrixColumn(t,1).length(),o=1/hr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+g,e[10]=f-v*h}else if(t.order==="XZY"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Rv,t,Cv)}lookAt(t,e,n){const s=this.elements;return Vn.subVectors(t,e),Vn.lengthSq()===0&&(Vn.z=1),Vn.normalize(),as.crossVectors(n,Vn),as.lengthSq()===0&&(Math.abs(n.z)===1?Vn.x+=1e-4:Vn.z+=1e-4,Vn.normalize(),as.crossVectors(n,Vn)),as.normalize(),qo.crossVectors(Vn,as),s[0]=as.x,s[4]=qo.x,s[8]=Vn.x,s[1]=as.y,s[5]=qo.y,s[9]=Vn.y,s[2]=as.z,s[6]=qo.z,s[10]=Vn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],g=n[2],v=n[6],m=n[10],p=n[14],E=n[3],T=n[7],M=n[11],O=n[15],R=s[0],D=s[4],U=s[8],w=s[12],S=s[1],C=s[5],G=s[9],I=s[13],V=s[2],j=s[6],K=s[10],Q=s[14],tt=s[3],ht=s[7],ct=s[11],mt=s[15];return r[0]=o*R+a*S+l*V+c*tt,r[4]=o*D+a*C+l*j+c*ht,r[8]=o*U+a*G+l*K+c*ct,r[12]=o*w+a*I+l*Q+c*mt,r[1]=u*R+h*S+f*V+d*tt,r[5]=u*D+h*C+f*j+d*ht,r[9]=u*U+h*G+f*K+d*ct,r[13]=u*w+h*I+f*Q+d*mt,r[2]=g*R+v*S+m*V+p*tt,r[6]=g*D+v*C+m*j+p*ht,r[10]=g*U+v*G+m*K+p*ct,r[14]=g*w+v*I+m*Q+p*mt,r[3]=E*R+T*S+M*V+O*tt,r[7]=E*D+T*C+M*j+O*ht,r[11]=E*U+T*G+M*K+O*ct,r[15]=E*w+T*I+M*Q+O*mt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*d-n*l*d)+v*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+e*c*h-e*a*d-r*o*h+n*o*d+r*a*u-n*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-n*o*f+n*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],E=h*m*c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,T=g*f*c-u*m*c-g*l*d+o*m*d+u*l*p-o*f*p,M=u*v*c-g*h*c+g*a*d-o*v*d-u*a*p+o*h*p,O=g*h*l-u*v*l-g*a*f+o*v*f+u*a*m-o*h*m,R=e*E+n*T+s*M+r*O;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/R;return t[0]=E*D,t[1]=(v*f*r-h*m*r-v*s*d+n*m*d+h*s*p-n*f*p)*D,t[2]=(a*m*r-v*l*r+v*s*c-n*m*c-a*s*p+n*l*p)*D,t[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*d-n*l*d)*D,t[4]=T*D,t[5]=(u*m*r-g*f*r+g*s*d-e*m*d-u*s*p+e*f*p)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*D,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*D,t[8]=M*D,t[9]=(g*h*r-u*v*r-g*n*d+e*v*d+u*n*p-e*h*p)*D,t[10]=(o*v*r-g*a*r+g*n*c-e*v*c-o*n*p+e*a*p)*D,t[11]=(u*a*r-o*h*r-u*n*c+e*h*c+o*n*d-e*a*d)*D,t[12]=O*D,t[13]=(u*v*s-g*h*s+g*n*f-e*v*f-u*n*m+e*h*m)*D,t[14]=(g*a*s-o*v*s-g*n*l+e*v*l+o*n*m-e*a*m)*D,t[15]=(o*h*s-u*a*s+u*n*l-e*h*l-o*n*f+e*a*f)*D,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,v=o*u,m=o*h,p=a*h,E=l*c,T=l*u,M=l*h,O=n.x,R=n.y,D=n.z;return s[0]=(1-(v+p))*O,s[1]=(d+M)*O,s[2]=(g-T)*O,s[3]=0,s[4]=(d-M)*R,s[5]=(1-(f+p))*R,s[6]=(m+E)*R,s[7]=0,s[8]=(g+T)*D,s[9]=(m-E)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;let r=hr.set(s[0],s[1],s[2]).length();const o=hr.set(s[4],s[5],s[6]).length(),a=hr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],ui.copy(this);const c=1/r,u=1/o,h=1/a;return ui.elements[0]*=c,ui.elements[1]*=c,ui.elements[2]*=c,ui.elements[4]*=u,ui.elements[5]*=u,ui.elements[6]*=u,ui.elements[8]*=h,ui.elements[9]*=h,ui.elements[10]*=h,e.setFromRotationMatrix(ui),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Yi){const l=this.elements,c=2*r/(e-t),u=2*r/(n-s),h=(e+t)/(e-t),f=(n+s)/(n-s);let d,g;if(a===Yi)d=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===La)d=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=d,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Yi){const l=this.elements,c=1/(e-t),u=1/(n-s),h=1/(o-r),f=(e+t)*c,d=(n+s)*u;let g,v;if(a===Yi)g=(o+r)*h,v=-2*h;else if(a===La)g=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-d,l[2]=0,l[6]=0,l[10]=v,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const hr=new z,ui=new Ue,Rv=new z(0,0,0),Cv=new z(1,1,1),as=new z,qo=new z,Vn=new z,yf=new Ue,Ef=new $s;class Fi{constructor(t=0,e=0,n=0,s=Fi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(Cn(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Cn(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(Cn(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Cn(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Cn(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-Cn(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return yf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(yf,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Ef.setFromEuler(this),this.setFromQuaternion(Ef,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Fi.DEFAULT_ORDER="XYZ";class Wp{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let Pv=0;const bf=new z,fr=new $s,Vi=new Ue,Yo=new z,ao=new z,Lv=new z,Dv=new $s,wf=new z(1,0,0),Tf=new z(0,1,0),Af=new z(0,0,1),Rf={type:"added"},Uv={type:"removed"},dr={type:"childadded",child:null},Pl={type:"childremoved",child:null};class en extends Wr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Pv++}),this.uuid=To(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=en.DEFAULT_UP.clone();const t=new z,e=new Fi,n=new $s,s=new z(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ue},normalMatrix:{value:new Qt}}),this.matrix=new Ue,this.matrixWorld=new Ue,this.matrixAutoUpdate=en.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=en.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Wp,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return fr.setFromAxisAngle(t,e),this.quaternion.multiply(fr),this}rotateOnWorldAxis(t,e){return fr.setFromAxisAngle(t,e),this.quaternion.premultiply(fr),this}rotateX(t){return this.rotateOnAxis(wf,t)}rotateY(t){return this.rotateOnAxis(Tf,t)}rotateZ(t){return this.rotateOnAxis(Af,t)}translateOnAxis(t,e){return bf.copy(t).applyQuaternion(this.quaternion),this.position.add(bf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(wf,t)}translateY(t){return this.translateOnAxis(Tf,t)}translateZ(t){return this.translateOnAxis(Af,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Vi.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Yo.copy(t):Yo.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),ao.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Vi.lookAt(ao,Yo,this.up):Vi.lookAt(Yo,ao,this.up),this.quaternion.setFromRotationMatrix(Vi),s&&(Vi.extractRotation(s.matrixWorld),fr.setFromRotationMatrix(Vi),this.quaternion.premultiply(fr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Rf),dr.child=t,this.dispatchEvent(dr),dr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Uv),Pl.child=t,this.dispatchEvent(Pl),Pl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Vi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Vi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Vi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Rf),dr.child=t,this.dispatchEvent(dr),dr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ao,t,Lv),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ao,Dv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){const n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}}en.DEFAULT_UP=new z(0,1,0);en.DEFAULT_MATRIX_AUTO_UPDATE=!0;en.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const hi=new z,Wi=new z,Ll=new z,Xi=new z,pr=new z,mr=new z,Cf=new z,Dl=new z,Ul=new z,Il=new z,Nl=new Ge,Fl=new Ge,Ol=new Ge;class ii{constructor(t=new z,e=new z,n=new z){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),hi.subVectors(t,e),s.cross(hi);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){hi.subVectors(s,e),Wi.subVectors(n,e),Ll.subVectors(t,e);const o=hi.dot(hi),a=hi.dot(Wi),l=hi.dot(Ll),c=Wi.dot(Wi),u=Wi.dot(Ll),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Xi)===null?!1:Xi.x>=0&&Xi.y>=0&&Xi.x+Xi.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Xi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Xi.x),l.addScaledVector(o,Xi.y),l.addScaledVector(a,Xi.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Nl.setScalar(0),Fl.setScalar(0),Ol.setScalar(0),Nl.fromBufferAttribute(t,e),Fl.fromBufferAttribute(t,n),Ol.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Nl,r.x),o.addScaledVector(Fl,r.y),o.addScaledVector(Ol,r.z),o}static isFrontFacing(t,e,n,s){return hi.subVectors(n,e),Wi.subVectors(t,e),hi.cross(Wi).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return hi.subVectors(this.c,this.b),Wi.subVectors(this.a,this.b),hi.cross(Wi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ii.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ii.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return ii.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return ii.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ii.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let o,a;pr.subVectors(s,n),mr.subVectors(r,n),Dl.subVectors(t,n);const l=pr.dot(Dl),c=mr.dot(Dl);if(l<=0&&c<=0)return e.copy(n);Ul.subVectors(t,s);const u=pr.dot(Ul),h=mr.dot(Ul);if(u>=0&&h<=u)return e.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(n).addScaledVector(pr,o);Il.subVectors(t,r);const d=pr.dot(Il),g=mr.dot(Il);if(g>=0&&d<=g)return e.copy(r);const v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(mr,a);const m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return Cf.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(Cf,a);const p=1/(m+v+f);return o=v*p,a=f*p,e.copy(n).addScaledVector(pr,o).addScaledVector(mr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const Xp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ls={h:0,s:0,l:0},Ko={h:0,s:0,l:0};function kl(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class oe{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ni){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,me.toWorkingColorSpace(this,e),this}setRGB(t,e,n,s=me.workingColorSpace){return this.r=t,this.g=e,this.b=n,me.toWorkingColorSpace(this,s),this}setHSL(t,e,n,s=me.workingColorSpace){if(t=_v(t,1),e=Cn(e,0,1),n=Cn(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=kl(o,r,t+1/3),this.g=kl(o,r,t),this.b=kl(o,r,t-1/3)}return me.toWorkingColorSpace(this,s),this}setStyle(t,e=ni){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ni){const n=Xp[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Zi(t.r),this.g=Zi(t.g),this.b=Zi(t.b),this}copyLinearToSRGB(t){return this.r=Rr(t.r),this.g=Rr(t.g),this.b=Rr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ni){return me.fromWorkingColorSpace(xn.copy(this),t),Math.round(Cn(xn.r*255,0,255))*65536+Math.round(Cn(xn.g*255,0,255))*256+Math.round(Cn(xn.b*255,0,255))}getHexString(t=ni){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=me.workingColorSpace){me.fromWorkingColorSpace(xn.copy(this),e);const n=xn.r,s=xn.g,r=xn.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=me.workingColorSpace){return me.fromWorkingColorSpace(xn.copy(this),e),t.r=xn.r,t.g=xn.g,t.b=xn.b,t}getStyle(t=ni){me.fromWorkingColorSpace(xn.copy(this),t);const e=xn.r,n=xn.g,s=xn.b;return t!==ni?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(ls),this.setHSL(ls.h+t,ls.s+e,ls.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ls),t.getHSL(Ko);const n=Sl(ls.h,Ko.h,e),s=Sl(ls.s,Ko.s,e),r=Sl(ls.l,Ko.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const xn=new oe;oe.NAMES=Xp;let Iv=0;class qs extends Wr{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Iv++}),this.uuid=To(),this.name="",this.blending=Tr,this.side=ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=gc,this.blendDst=_c,this.blendEquation=Is,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new oe(0,0,0),this.blendAlpha=0,this.depthFunc=Nr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ff,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=or,this.stencilZFail=or,this.stencilZPass=or,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==Tr&&(n.blending=this.blending),this.side!==ms&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==gc&&(n.blendSrc=this.blendSrc),this.blendDst!==_c&&(n.blendDst=this.blendDst),this.blendEquation!==Is&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Nr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==ff&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==or&&(n.stencilFail=this.stencilFail),this.stencilZFail!==or&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==or&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class $r extends qs{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fi,this.combine=Uu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const Ye=new z,jo=new ae;class kn{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=df,this.updateRanges=[],this.gpuType=qi,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)jo.fromBufferAttribute(this,e),jo.applyMatrix3(t),this.setXY(e,jo.x,jo.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Ye.fromBufferAttribute(this,e),Ye.applyMatrix3(t),this.setXYZ(e,Ye.x,Ye.y,Ye.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Ye.fromBufferAttribute(this,e),Ye.applyMatrix4(t),this.setXYZ(e,Ye.x,Ye.y,Ye.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Ye.fromBufferAttribute(this,e),Ye.applyNormalMatrix(t),this.setXYZ(e,Ye.x,Ye.y,Ye.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Ye.fromBufferAttribute(this,e),Ye.transformDirection(t),this.setXYZ(e,Ye.x,Ye.y,Ye.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=so(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Un(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=so(e,this.array)),e}setX(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=so(e,this.array)),e}setY(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=so(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=so(e,this.array)),e}setW(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array),s=Un(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array),s=Un(s,this.array),r=Un(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==df&&(t.usage=this.usage),t}}class $p extends kn{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class qp extends kn{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class ke extends kn{constructor(t,e,n){super(new Float32Array(t),e,n)}}let Nv=0;const Jn=new Ue,Bl=new en,gr=new z,Wn=new Xr,lo=new Xr,dn=new z;class on extends Wr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Nv++}),this.uuid=To(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Hp(t)?qp:$p)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new Qt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return Jn.makeRotationFromQuaternion(t),this.applyMatrix4(Jn),this}rotateX(t){return Jn.makeRotationX(t),this.applyMatrix4(Jn),this}rotateY(t){return Jn.makeRotationY(t),this.applyMatrix4(Jn),this}rotateZ(t){return Jn.makeRotationZ(t),this.applyMatrix4(Jn),this}translate(t,e,n){return Jn.makeTranslation(t,e,n),this.applyMatrix4(Jn),this}scale(t,e,n){return Jn.makeScale(t,e,n),this.applyMatrix4(Jn),this}lookAt(t){return Bl.lookAt(t),Bl.updateMatrix(),this.applyMatrix4(Bl.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(gr).negate(),this.translate(gr.x,gr.y,gr.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ke(n,3))}else{for(let n=0,s=e.count;n<s;n++){const r=t[n];e.setXYZ(n,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Xr);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];Wn.setFromBufferAttribute(r),this.morphTargetsRelative?(dn.addVectors(this.boundingBox.min,Wn.min),this.boundingBox.expandByPoint(dn),dn.addVectors(this.boundingBox.max,Wn.max),this.boundingBox.expandByPoint(dn)):(this.boundingBox.expandByPoint(Wn.min),this.boundingBox.expandByPoint(Wn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ao);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){const n=this.boundingSphere.center;if(Wn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];lo.setFromBufferAttribute(a),this.morphTargetsRelative?(dn.addVectors(Wn.min,lo.min),Wn.expandByPoint(dn),dn.addVectors(Wn.max,lo.max),Wn.expandByPoint(dn)):(Wn.expandByPoint(lo.min),Wn.expandByPoint(lo.max))}Wn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)dn.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(dn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)dn.fromBufferAttribute(a,c),l&&(gr.fromBufferAttribute(t,c),dn.add(gr)),s=Math.max(s,n.distanceToSquared(dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new kn(new Float32Array(4*n.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let U=0;U<n.count;U++)a[U]=new z,l[U]=new z;const c=new z,u=new z,h=new z,f=new ae,d=new ae,g=new ae,v=new z,m=new z;function p(U,w,S){c.fromBufferAttribute(n,U),u.fromBufferAttribute(n,w),h.fromBufferAttribute(n,S),f.fromBufferAttribute(r,U),d.fromBufferAttribute(r,w),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),d.sub(f),g.sub(f);const C=1/(d.x*g.y-g.x*d.y);isFinite(C)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-d.y).multiplyScalar(C),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(C),a[U].add(v),a[w].add(v),a[S].add(v),l[U].add(m),l[w].add(m),l[S].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let U=0,w=E.length;U<w;++U){const S=E[U],C=S.start,G=S.count;for(let I=C,V=C+G;I<V;I+=3)p(t.getX(I+0),t.getX(I+1),t.getX(I+2))}const T=new z,M=new z,O=new z,R=new z;function D(U){O.fromBufferAttribute(s,U),R.copy(O);const w=a[U];T.copy(w),T.sub(O.multiplyScalar(O.dot(w))).normalize(),M.crossVectors(R,w);const C=M.dot(l[U])<0?-1:1;o.setXYZW(U,T.x,T.y,T.z,C)}for(let U=0,w=E.length;U<w;++U){const S=E[U],C=S.start,G=S.count;for(let I=C,V=C+G;I<V;I+=3)D(t.getX(I+0)),D(t.getX(I+1)),D(t.getX(I+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new kn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);const s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let f=0,d=t.count;f<d;f+=3){const g=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)dn.fromBufferAttribute(t,e),dn.normalize(),t.setXYZ(e,dn.x,dn.y,dn.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new kn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new on,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,n);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone(e));const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Pf=new Ue,ws=new zu,Zo=new Ao,Lf=new z,Jo=new z,Qo=new z,ta=new z,zl=new z,ea=new z,Df=new z,na=new z;class Sn extends en{constructor(t=new on,e=new $r){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){ea.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(zl.fromBufferAttribute(h,t),o?ea.addScaledVector(zl,u):ea.addScaledVector(zl.sub(e),u))}e.add(ea)}return e}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Zo.copy(n.boundingSphere),Zo.applyMatrix4(r),ws.copy(t.ray).recast(t.near),!(Zo.containsPoint(ws.origin)===!1&&(ws.intersectSphere(Zo,Lf)===null||ws.origin.distanceToSquared(Lf)>(t.far-t.near)**2))&&(Pf.copy(r).invert(),ws.copy(t.ray).applyMatrix4(Pf),!(n.boundingBox!==null&&ws.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ws)))}_computeIntersections(t,e,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],E=Math.max(m.start,d.start),T=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let M=E,O=T;M<O;M+=3){const R=a.getX(M),D=a.getX(M+1),U=a.getX(M+2);s=ia(this,p,t,n,c,u,h,R,D,U),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const E=a.getX(m),T=a.getX(m+1),M=a.getX(m+2);s=ia(this,o,t,n,c,u,h,E,T,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],E=Math.max(m.start,d.start),T=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=E,O=T;M<O;M+=3){const R=M,D=M+1,U=M+2;s=ia(this,p,t,n,c,u,h,R,D,U),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const E=m,T=m+1,M=m+2;s=ia(this,o,t,n,c,u,h,E,T,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function Fv(i,t,e,n,s,r,o,a){let l;if(t.side===Fn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===ms,a),l===null)return null;na.copy(a),na.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(na);return c<e.near||c>e.far?null:{distance:c,point:na.clone(),object:i}}function ia(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Jo),i.getVertexPosition(l,Qo),i.getVertexPosition(c,ta);const u=Fv(i,t,e,n,Jo,Qo,ta,Df);if(u){const h=new z;ii.getBarycoord(Df,Jo,Qo,ta,h),s&&(u.uv=ii.getInterpolatedAttribute(s,a,l,c,h,new ae)),r&&(u.uv1=ii.getInterpolatedAttribute(r,a,l,c,h,new ae)),o&&(u.normal=ii.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new z,materialIndex:0};ii.getNormal(Jo,Qo,ta,f.normal),u.face=f,u.barycoord=h}return u}class qr extends on{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new ke(c,3)),this.setAttribute("normal",new ke(u,3)),this.setAttribute("uv",new ke(h,2));function g(v,m,p,E,T,M,O,R,D,U,w){const S=M/D,C=O/U,G=M/2,I=O/2,V=R/2,j=D+1,K=U+1;let Q=0,tt=0;const ht=new z;for(let ct=0;ct<K;ct++){const mt=ct*C-I;for(let Mt=0;Mt<j;Mt++){const pt=Mt*S-G;ht[v]=pt*E,ht[m]=mt*T,ht[p]=V,c.push(ht.x,ht.y,ht.z),ht[v]=0,ht[m]=0,ht[p]=R>0?1:-1,u.push(ht.x,ht.y,ht.z),h.push(Mt/D),h.push(1-ct/U),Q+=1}}for(let ct=0;ct<U;ct++)for(let mt=0;mt<D;mt++){const Mt=f+mt+j*ct,pt=f+mt+j*(ct+1),it=f+(mt+1)+j*(ct+1),at=f+(mt+1)+j*ct;l.push(Mt,pt,at),l.push(pt,it,at),tt+=6}a.addGroup(d,tt,w),d+=tt,f+=Q}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new qr(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function zr(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function An(i){const t={};for(let e=0;e<i.length;e++){const n=zr(i[e]);for(const s in n)t[s]=n[s]}return t}function Ov(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Yp(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:me.workingColorSpace}const kv={clone:zr,merge:An};var Bv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,zv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class gs extends qs{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Bv,this.fragmentShader=zv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=zr(t.uniforms),this.uniformsGroups=Ov(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}}class Kp extends en{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ue,this.projectionMatrix=new Ue,this.projectionMatrixInverse=new Ue,this.coordinateSystem=Yi}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const cs=new z,Uf=new ae,If=new ae;class $n extends Kp{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=eu*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(ba*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return eu*2*Math.atan(Math.tan(ba*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){cs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(cs.x,cs.y).multiplyScalar(-t/cs.z),cs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(cs.x,cs.y).multiplyScalar(-t/cs.z)}getViewSize(t,e){return this.getViewBounds(t,Uf,If),e.subVectors(If,Uf)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(ba*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const _r=-90,vr=1;class Hv extends en{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new $n(_r,vr,t,e);s.layers=this.layers,this.add(s);const r=new $n(_r,vr,t,e);r.layers=this.layers,this.add(r);const o=new $n(_r,vr,t,e);o.layers=this.layers,this.add(o);const a=new $n(_r,vr,t,e);a.layers=this.layers,this.add(a);const l=new $n(_r,vr,t,e);l.layers=this.layers,this.add(l);const c=new $n(_r,vr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===Yi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===La)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;const v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=v,t.setRenderTarget(n,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}}class jp extends On{constructor(t,e,n,s,r,o,a,l,c,u){t=t!==void 0?t:[],e=e!==void 0?e:Fr,super(t,e,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class Gv extends Hs{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new jp(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Pi}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new qr(5,5,5),r=new gs({name:"CubemapFromEquirect",uniforms:zr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Fn,blending:fs});r.uniforms.tEquirect.value=e;const o=new Sn(s,r),a=e.minFilter;return e.minFilter===Os&&(e.minFilter=Pi),new Hv(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,n,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}}const Hl=new z,Vv=new z,Wv=new Qt;class Ls{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Hl.subVectors(n,e).cross(Vv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const n=t.delta(Hl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||Wv.getNormalMatrix(t),s=this.coplanarPoint(Hl).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Ts=new Ao,sa=new z;class Hu{constructor(t=new Ls,e=new Ls,n=new Ls,s=new Ls,r=new Ls,o=new Ls){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Yi){const n=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],f=s[7],d=s[8],g=s[9],v=s[10],m=s[11],p=s[12],E=s[13],T=s[14],M=s[15];if(n[0].setComponents(l-r,f-c,m-d,M-p).normalize(),n[1].setComponents(l+r,f+c,m+d,M+p).normalize(),n[2].setComponents(l+o,f+u,m+g,M+E).normalize(),n[3].setComponents(l-o,f-u,m-g,M-E).normalize(),n[4].setComponents(l-a,f-h,m-v,M-T).normalize(),e===Yi)n[5].setComponents(l+a,f+h,m+v,M+T).normalize();else if(e===La)n[5].setComponents(a,h,v,T).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ts.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ts.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ts)}intersectsSprite(t){return Ts.center.set(0,0,0),Ts.radius=.7071067811865476,Ts.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ts)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(sa.x=s.normal.x>0?t.max.x:t.min.x,sa.y=s.normal.y>0?t.max.y:t.min.y,sa.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(sa)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Zp(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Xv(i){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){const u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){const g=h[f],v=h[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){const v=h[d];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class ja extends on{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){const E=p*f-o;for(let T=0;T<c;T++){const M=T*h-r;g.push(M,-E,0),v.push(0,0,1),m.push(T/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let E=0;E<a;E++){const T=E+c*p,M=E+c*(p+1),O=E+1+c*(p+1),R=E+1+c*p;d.push(T,M,R),d.push(M,O,R)}this.setIndex(d),this.setAttribute("position",new ke(g,3)),this.setAttribute("normal",new ke(v,3)),this.setAttribute("uv",new ke(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ja(t.width,t.height,t.widthSegments,t.heightSegments)}}var $v=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,qv=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Yv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Kv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Zv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Jv=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Qv=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,tx=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,ex=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,nx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ix=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,sx=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,rx=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,ox=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,ax=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,lx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,cx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ux=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,hx=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,fx=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,dx=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,px=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,mx=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,gx=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,_x=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,vx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,xx=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Mx=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Sx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,yx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ex=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,bx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,wx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Tx=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Ax=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Rx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Cx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Px=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Lx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Dx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ux=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Ix=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Nx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Fx=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Ox=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif`,kx=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,Bx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,zx=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Hx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Gx=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Vx=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Wx=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		float v = 0.5 / ( gv + gl );
		return saturate(v);
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = material.clearcoatRoughness;
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Xx=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,$x=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,qx=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Yx=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Kx=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jx=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Zx=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Jx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Qx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,tM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,eM=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,nM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,iM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,sM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,rM=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,oM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,aM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,lM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,cM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,uM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,hM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,fM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,dM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,pM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,mM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,gM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,_M=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,vM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,MM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,SM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,yM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,EM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,bM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,wM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,TM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,AM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		return step( compare, unpackRGBAToDepth( texture2D( depths, uv ) ) );
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow (sampler2D shadow, vec2 uv, float compare ){
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		float hard_shadow = step( compare , distribution.x );
		if (hard_shadow != 1.0 ) {
			float distance = compare - distribution.x ;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,RM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,CM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,PM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,LM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,DM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,UM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,IM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,NM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,FM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,OM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,kM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,BM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,zM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
		
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
		
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		
		#else
		
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,HM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,GM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,VM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,WM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const XM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,$M=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,YM=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,KM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ZM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,JM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	float fragCoordZ = 0.5 * vHighPrecisionZW[0] / vHighPrecisionZW[1] + 0.5;
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,QM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,tS=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,eS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,nS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,iS=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,sS=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,rS=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,oS=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,lS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,cS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,uS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,hS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,fS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,dS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,pS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,gS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <cube_uv_reflection_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_S=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,MS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,SS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,yS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ES=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,bS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ee={alphahash_fragment:$v,alphahash_pars_fragment:qv,alphamap_fragment:Yv,alphamap_pars_fragment:Kv,alphatest_fragment:jv,alphatest_pars_fragment:Zv,aomap_fragment:Jv,aomap_pars_fragment:Qv,batching_pars_vertex:tx,batching_vertex:ex,begin_vertex:nx,beginnormal_vertex:ix,bsdfs:sx,iridescence_fragment:rx,bumpmap_pars_fragment:ox,clipping_planes_fragment:ax,clipping_planes_pars_fragment:lx,clipping_planes_pars_vertex:cx,clipping_planes_vertex:ux,color_fragment:hx,color_pars_fragment:fx,color_pars_vertex:dx,color_vertex:px,common:mx,cube_uv_reflection_fragment:gx,defaultnormal_vertex:_x,displacementmap_pars_vertex:vx,displacementmap_vertex:xx,emissivemap_fragment:Mx,emissivemap_pars_fragment:Sx,colorspace_fragment:yx,colorspace_pars_fragment:Ex,envmap_fragment:bx,envmap_common_pars_fragment:wx,envmap_pars_fragment:Tx,envmap_pars_vertex:Ax,envmap_physical_pars_fragment:kx,envmap_vertex:Rx,fog_vertex:Cx,fog_pars_vertex:Px,fog_fragment:Lx,fog_pars_fragment:Dx,gradientmap_pars_fragment:Ux,lightmap_pars_fragment:Ix,lights_lambert_fragment:Nx,lights_lambert_pars_fragment:Fx,lights_pars_begin:Ox,lights_toon_fragment:Bx,lights_toon_pars_fragment:zx,lights_phong_fragment:Hx,lights_phong_pars_fragment:Gx,lights_physical_fragment:Vx,lights_physical_pars_fragment:Wx,lights_fragment_begin:Xx,lights_fragment_maps:$x,lights_fragment_end:qx,logdepthbuf_fragment:Yx,logdepthbuf_pars_fragment:Kx,logdepthbuf_pars_vertex:jx,logdepthbuf_vertex:Zx,map_fragment:Jx,map_pars_fragment:Qx,map_particle_fragment:tM,map_particle_pars_fragment:eM,metalnessmap_fragment:nM,metalnessmap_pars_fragment:iM,morphinstance_vertex:sM,morphcolor_vertex:rM,morphnormal_vertex:oM,morphtarget_pars_vertex:aM,morphtarget_vertex:lM,normal_fragment_begin:cM,normal_fragment_maps:uM,normal_pars_fragment:hM,normal_pars_vertex:fM,normal_vertex:dM,normalmap_pars_fragment:pM,clearcoat_normal_fragment_begin:mM,clearcoat_normal_fragment_maps:gM,clearcoat_pars_fragment:_M,iridescence_pars_fragment:vM,opaque_fragment:xM,packing:MM,premultiplied_alpha_fragment:SM,project_vertex:yM,dithering_fragment:EM,dithering_pars_fragment:bM,roughnessmap_fragment:wM,roughnessmap_pars_fragment:TM,shadowmap_pars_fragment:AM,shadowmap_pars_vertex:RM,shadowmap_vertex:CM,shadowmask_pars_fragment:PM,skinbase_vertex:LM,skinning_pars_vertex:DM,skinning_vertex:UM,skinnormal_vertex:IM,specularmap_fragment:NM,specularmap_pars_fragment:FM,tonemapping_fragment:OM,tonemapping_pars_fragment:kM,transmission_fragment:BM,transmission_pars_fragment:zM,uv_pars_fragment:HM,uv_pars_vertex:GM,uv_vertex:VM,worldpos_vertex:WM,background_vert:XM,background_frag:$M,backgroundCube_vert:qM,backgroundCube_frag:YM,cube_vert:KM,cube_frag:jM,depth_vert:ZM,depth_frag:JM,distanceRGBA_vert:QM,distanceRGBA_frag:tS,equirect_vert:eS,equirect_frag:nS,linedashed_vert:iS,linedashed_frag:sS,meshbasic_vert:rS,meshbasic_frag:oS,meshlambert_vert:aS,meshlambert_frag:lS,meshmatcap_vert:cS,meshmatcap_frag:uS,meshnormal_vert:hS,meshnormal_frag:fS,meshphong_vert:dS,meshphong_frag:pS,meshphysical_vert:mS,meshphysical_frag:gS,meshtoon_vert:_S,meshtoon_frag:vS,points_vert:xS,points_frag:MS,shadow_vert:SS,shadow_frag:yS,sprite_vert:ES,sprite_frag:bS},bt={common:{diffuse:{value:new oe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qt}},envmap:{envMap:{value:null},envMapRotation:{value:new Qt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qt},normalScale:{value:new ae(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new oe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new oe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0},uvTransform:{value:new Qt}},sprite:{diffuse:{value:new oe(16777215)},opacity:{value:1},center:{value:new ae(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}}},Ai={basic:{uniforms:An([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:ee.meshbasic_vert,fragmentShader:ee.meshbasic_frag},lambert:{uniforms:An([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new oe(0)}}]),vertexShader:ee.meshlambert_vert,fragmentShader:ee.meshlambert_frag},phong:{uniforms:An([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new oe(0)},specular:{value:new oe(1118481)},shininess:{value:30}}]),vertexShader:ee.meshphong_vert,fragmentShader:ee.meshphong_frag},standard:{uniforms:An([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new oe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ee.meshphysical_vert,fragmentShader:ee.meshphysical_frag},toon:{uniforms:An([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new oe(0)}}]),vertexShader:ee.meshtoon_vert,fragmentShader:ee.meshtoon_frag},matcap:{uniforms:An([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:ee.meshmatcap_vert,fragmentShader:ee.meshmatcap_frag},points:{uniforms:An([bt.points,bt.fog]),vertexShader:ee.points_vert,fragmentShader:ee.points_frag},dashed:{uniforms:An([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ee.linedashed_vert,fragmentShader:ee.linedashed_frag},depth:{uniforms:An([bt.common,bt.displacementmap]),vertexShader:ee.depth_vert,fragmentShader:ee.depth_frag},normal:{uniforms:An([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:ee.meshnormal_vert,fragmentShader:ee.meshnormal_frag},sprite:{uniforms:An([bt.sprite,bt.fog]),vertexShader:ee.sprite_vert,fragmentShader:ee.sprite_frag},background:{uniforms:{uvTransform:{value:new Qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ee.background_vert,fragmentShader:ee.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qt}},vertexShader:ee.backgroundCube_vert,fragmentShader:ee.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ee.cube_vert,fragmentShader:ee.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ee.equirect_vert,fragmentShader:ee.equirect_frag},distanceRGBA:{uniforms:An([bt.common,bt.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ee.distanceRGBA_vert,fragmentShader:ee.distanceRGBA_frag},shadow:{uniforms:An([bt.lights,bt.fog,{color:{value:new oe(0)},opacity:{value:1}}]),vertexShader:ee.shadow_vert,fragmentShader:ee.shadow_frag}};Ai.physical={uniforms:An([Ai.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qt},clearcoatNormalScale:{value:new ae(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qt},sheen:{value:0},sheenColor:{value:new oe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qt},transmissionSamplerSize:{value:new ae},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qt},attenuationDistance:{value:0},attenuationColor:{value:new oe(0)},specularColor:{value:new oe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qt},anisotropyVector:{value:new ae},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qt}}]),vertexShader:ee.meshphysical_vert,fragmentShader:ee.meshphysical_frag};const ra={r:0,b:0,g:0},As=new Fi,wS=new Ue;function TS(i,t,e,n,s,r,o){const a=new oe(0);let l=r===!0?0:1,c,u,h=null,f=0,d=null;function g(E){let T=E.isScene===!0?E.background:null;return T&&T.isTexture&&(T=(E.backgroundBlurriness>0?e:t).get(T)),T}function v(E){let T=!1;const M=g(E);M===null?p(a,l):M&&M.isColor&&(p(M,1),T=!0);const O=i.xr.getEnvironmentBlendMode();O==="additive"?n.buffers.color.setClear(0,0,0,1,o):O==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||T)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(E,T){const M=g(T);M&&(M.isCubeTexture||M.mapping===Ya)?(u===void 0&&(u=new Sn(new qr(1,1,1),new gs({name:"BackgroundCubeMaterial",uniforms:zr(Ai.backgroundCube.uniforms),vertexShader:Ai.backgroundCube.vertexShader,fragmentShader:Ai.backgroundCube.fragmentShader,side:Fn,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(O,R,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),As.copy(T.backgroundRotation),As.x*=-1,As.y*=-1,As.z*=-1,M.isCubeTexture&&M.isRenderTargetTexture===!1&&(As.y*=-1,As.z*=-1),u.material.uniforms.envMap.value=M,u.material.uniforms.flipEnvMap.value=M.isCubeTexture&&M.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(wS.makeRotationFromEuler(As)),u.material.toneMapped=me.getTransfer(M.colorSpace)!==Ae,(h!==M||f!==M.version||d!==i.toneMapping)&&(u.material.needsUpdate=!0,h=M,f=M.version,d=i.toneMapping),u.layers.enableAll(),E.unshift(u,u.geometry,u.material,0,0,null)):M&&M.isTexture&&(c===void 0&&(c=new Sn(new ja(2,2),new gs({name:"BackgroundMaterial",uniforms:zr(Ai.background.uniforms),vertexShader:Ai.background.vertexShader,fragmentShader:Ai.background.fragmentShader,side:ms,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=M,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.toneMapped=me.getTransfer(M.colorSpace)!==Ae,M.matrixAutoUpdate===!0&&M.updateMatrix(),c.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||f!==M.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=M,f=M.version,d=i.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function p(E,T){E.getRGB(ra,Yp(i)),n.buffers.color.setClear(ra.r,ra.g,ra.b,T,o)}return{getClearColor:function(){return a},setClearColor:function(E,T=1){a.set(E),l=T,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,p(a,l)},render:v,addToRenderList:m}}function AS(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null);let r=s,o=!1;function a(S,C,G,I,V){let j=!1;const K=h(I,G,C);r!==K&&(r=K,c(r.object)),j=d(S,I,G,V),j&&g(S,I,G,V),V!==null&&t.update(V,i.ELEMENT_ARRAY_BUFFER),(j||o)&&(o=!1,M(S,C,G,I),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function l(){return i.createVertexArray()}function c(S){return i.bindVertexArray(S)}function u(S){return i.deleteVertexArray(S)}function h(S,C,G){const I=G.wireframe===!0;let V=n[S.id];V===void 0&&(V={},n[S.id]=V);let j=V[C.id];j===void 0&&(j={},V[C.id]=j);let K=j[I];return K===void 0&&(K=f(l()),j[I]=K),K}function f(S){const C=[],G=[],I=[];for(let V=0;V<e;V++)C[V]=0,G[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:G,attributeDivisors:I,object:S,attributes:{},index:null}}function d(S,C,G,I){const V=r.attributes,j=C.attributes;let K=0;const Q=G.getAttributes();for(const tt in Q)if(Q[tt].location>=0){const ct=V[tt];let mt=j[tt];if(mt===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;K++}return r.attributesNum!==K||r.index!==I}function g(S,C,G,I){const V={},j=C.attributes;let K=0;const Q=G.getAttributes();for(const tt in Q)if(Q[tt].location>=0){let ct=j[tt];ct===void 0&&(tt==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),tt==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),V[tt]=mt,K++}r.attributes=V,r.attributesNum=K,r.index=I}function v(){const S=r.newAttributes;for(let C=0,G=S.length;C<G;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){const G=r.newAttributes,I=r.enabledAttributes,V=r.attributeDivisors;G[S]=1,I[S]===0&&(i.enableVertexAttribArray(S),I[S]=1),V[S]!==C&&(i.vertexAttribDivisor(S,C),V[S]=C)}function E(){const S=r.newAttributes,C=r.enabledAttributes;for(let G=0,I=C.length;G<I;G++)C[G]!==S[G]&&(i.disableVertexAttribArray(G),C[G]=0)}function T(S,C,G,I,V,j,K){K===!0?i.vertexAttribIPointer(S,C,G,V,j):i.vertexAttribPointer(S,C,G,I,V,j)}function M(S,C,G,I){v();const V=I.attributes,j=G.getAttributes(),K=C.defaultAttributeValues;for(const Q in j){const tt=j[Q];if(tt.location>=0){let ht=V[Q];if(ht===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ht=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ht=S.instanceColor)),ht!==void 0){const ct=ht.normalized,mt=ht.itemSize,Mt=t.get(ht);if(Mt===void 0)continue;const pt=Mt.buffer,it=Mt.type,at=Mt.bytesPerElement,gt=it===i.INT||it===i.UNSIGNED_INT||ht.gpuType===Iu;if(ht.isInterleavedBufferAttribute){const ot=ht.data,Bt=ot.stride,Ht=ht.offset;if(ot.isInstancedInterleavedBuffer){for(let It=0;It<tt.locationSize;It++)p(tt.location+It,ot.meshPerAttribute);S.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let It=0;It<tt.locationSize;It++)m(tt.location+It);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let It=0;It<tt.locationSize;It++)T(tt.location+It,mt/tt.locationSize,it,ct,Bt*at,(Ht+mt/tt.locationSize*It)*at,gt)}else{if(ht.isInstancedBufferAttribute){for(let ot=0;ot<tt.locationSize;ot++)p(tt.location+ot,ht.meshPerAttribute);S.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let ot=0;ot<tt.locationSize;ot++)m(tt.location+ot);i.bindBuffer(i.ARRAY_BUFFER,pt);for(let ot=0;ot<tt.locationSize;ot++)T(tt.location+ot,mt/tt.locationSize,it,ct,mt*at,mt/tt.locationSize*ot*at,gt)}}else if(K!==void 0){const ct=K[Q];if(ct!==void 0)switch(ct.length){case 2:i.vertexAttrib2fv(tt.location,ct);break;case 3:i.vertexAttrib3fv(tt.location,ct);break;case 4:i.vertexAttrib4fv(tt.location,ct);break;default:i.vertexAttrib1fv(tt.location,ct)}}}}E()}function O(){U();for(const S in n){const C=n[S];for(const G in C){const I=C[G];for(const V in I)u(I[V].object),delete I[V];delete C[G]}delete n[S]}}function R(S){if(n[S.id]===void 0)return;const C=n[S.id];for(const G in C){const I=C[G];for(const V in I)u(I[V].object),delete I[V];delete C[G]}delete n[S.id]}function D(S){for(const C in n){const G=n[C];if(G[S.id]===void 0)continue;const I=G[S.id];for(const V in I)u(I[V].object),delete I[V];delete G[S.id]}}function U(){w(),o=!0,r!==s&&(r=s,c(r.object))}function w(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:w,dispose:O,releaseStatesOfGeometry:R,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:E}}function RS(i,t,e){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),e.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),e.update(u,n,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let d=0;for(let g=0;g<h;g++)d+=u[g];e.update(d,n,1)}function l(c,u,h,f){if(h===0)return;const d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];e.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function CS(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==gi&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const U=D===wo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Ji&&n.convert(D)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==qi&&!U)}function l(D){if(D==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),E=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),O=g>0,R=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:E,maxVaryings:T,maxFragmentUniforms:M,vertexTextures:O,maxSamples:R}}function PS(i){const t=this;let e=null,n=0,s=!1,r=!1;const o=new Ls,a=new Qt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const d=h.length!==0||f||n!==0||s;return s=f,n=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){const g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{const E=r?0:n,T=E*4;let M=p.clippingState||null;l.value=M,M=u(g,f,T,d);for(let O=0;O!==T;++O)M[O]=e[O];p.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=E}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,g){const v=h!==null?h.length:0;let m=null;if(v!==0){if(m=l.value,g!==!0||m===null){const p=d+v*4,E=f.matrixWorldInverse;a.getNormalMatrix(E),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,M=d;T!==v;++T,M+=4)o.copy(h[T]).applyMatrix4(E,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function LS(i){let t=new WeakMap;function e(o,a){return a===wc?o.mapping=Fr:a===Tc&&(o.mapping=Or),o}function n(o){if(o&&o.isTexture){const a=o.mapping;if(a===wc||a===Tc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new Gv(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}class Gu extends Kp{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Sr=4,Nf=[.125,.215,.35,.446,.526,.582],Ns=20,Gl=new Gu,Ff=new oe;let Vl=null,Wl=0,Xl=0,$l=!1;const Ds=(1+Math.sqrt(5))/2,xr=1/Ds,Of=[new z(-Ds,xr,0),new z(Ds,xr,0),new z(-xr,0,Ds),new z(xr,0,Ds),new z(0,Ds,-xr),new z(0,Ds,xr),new z(-1,1,-1),new z(1,1,-1),new z(-1,1,1),new z(1,1,1)];class kf{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100){Vl=this._renderer.getRenderTarget(),Wl=this._renderer.getActiveCubeFace(),Xl=this._renderer.getActiveMipmapLevel(),$l=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,n,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Hf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=zf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Vl,Wl,Xl),this._renderer.xr.enabled=$l,t.scissorTest=!1,oa(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Fr||t.mapping===Or?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Vl=this._renderer.getRenderTarget(),Wl=this._renderer.getActiveCubeFace(),Xl=this._renderer.getActiveMipmapLevel(),$l=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:Pi,minFilter:Pi,generateMipmaps:!1,type:wo,format:gi,colorSpace:Xs,depthBuffer:!1},s=Bf(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Bf(t,e,n);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=DS(r)),this._blurMaterial=US(r,t,e)}return s}_compileMaterial(t){const e=new Sn(this._lodPlanes[0],t);this._renderer.compile(e,Gl)}_sceneToCubeUV(t,e,n,s){const a=new $n(90,1,e,n),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,f=u.toneMapping;u.getClearColor(Ff),u.toneMapping=ds,u.autoClear=!1;const d=new $r({name:"PMREM.Background",side:Fn,depthWrite:!1,depthTest:!1}),g=new Sn(new qr,d);let v=!1;const m=t.background;m?m.isColor&&(d.color.copy(m),t.background=null,v=!0):(d.color.copy(Ff),v=!0);for(let p=0;p<6;p++){const E=p%3;E===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):E===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));const T=this._cubeSize;oa(s,E*T,p>2?T:0,T,T),u.setRenderTarget(s),v&&u.render(g,a),u.render(t,a)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=f,u.autoClear=h,t.background=m}_textureToCubeUV(t,e){const n=this._renderer,s=t.mapping===Fr||t.mapping===Or;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Hf()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=zf());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new Sn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;oa(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,Gl)}_applyPMREM(t){const e=this._renderer,n=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Of[(s-r-1)%Of.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new Sn(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Ns-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):Ns;m>Ns&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Ns}`);const p=[];let E=0;for(let D=0;D<Ns;++D){const U=D/v,w=Math.exp(-U*U/2);p.push(w),D===0?E+=w:D<m&&(E+=2*w)}for(let D=0;D<p.length;D++)p[D]=p[D]/E;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:T}=this;f.dTheta.value=g,f.mipInt.value=T-n;const M=this._sizeLods[s],O=3*M*(s>T-Sr?s-T+Sr:0),R=4*(this._cubeSize-M);oa(e,O,R,3*M,2*M),l.setRenderTarget(e),l.render(h,Gl)}}function DS(i){const t=[],e=[],n=[];let s=i;const r=i-Sr+1+Nf.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>i-Sr?l=Nf[o-i+Sr-1]:o===0&&(l=0),n.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,g=6,v=3,m=2,p=1,E=new Float32Array(v*g*d),T=new Float32Array(m*g*d),M=new Float32Array(p*g*d);for(let R=0;R<d;R++){const D=R%3*2/3-1,U=R>2?0:-1,w=[D,U,0,D+2/3,U,0,D+2/3,U+1,0,D,U,0,D+2/3,U+1,0,D,U+1,0];E.set(w,v*g*R),T.set(f,m*g*R);const S=[R,R,R,R,R,R];M.set(S,p*g*R)}const O=new on;O.setAttribute("position",new kn(E,v)),O.setAttribute("uv",new kn(T,m)),O.setAttribute("faceIndex",new kn(M,p)),t.push(O),s>Sr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function Bf(i,t,e){const n=new Hs(i,t,e);return n.texture.mapping=Ya,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function oa(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function US(i,t,e){const n=new Float32Array(Ns),s=new z(0,1,0);return new gs({name:"SphericalGaussianBlur",defines:{n:Ns,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Vu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:fs,depthTest:!1,depthWrite:!1})}function zf(){return new gs({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Vu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:fs,depthTest:!1,depthWrite:!1})}function Hf(){return new gs({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Vu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:fs,depthTest:!1,depthWrite:!1})}function Vu(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function IS(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===wc||l===Tc,u=l===Fr||l===Or;if(c||u){let h=t.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new kf(i)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new kf(i)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function NS(i){const t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&po("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function FS(i,t,e,n){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&t.remove(f.index);for(const g in f.attributes)t.remove(f.attributes[g]);for(const g in f.morphAttributes){const v=f.morphAttributes[g];for(let m=0,p=v.length;m<p;m++)t.remove(v[m])}f.removeEventListener("dispose",o),delete s[f.id];const d=r.get(f);d&&(t.remove(d),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){const f=h.attributes;for(const g in f)t.update(f[g],i.ARRAY_BUFFER);const d=h.morphAttributes;for(const g in d){const v=d[g];for(let m=0,p=v.length;m<p;m++)t.update(v[m],i.ARRAY_BUFFER)}}function c(h){const f=[],d=h.index,g=h.attributes.position;let v=0;if(d!==null){const E=d.array;v=d.version;for(let T=0,M=E.length;T<M;T+=3){const O=E[T+0],R=E[T+1],D=E[T+2];f.push(O,R,R,D,D,O)}}else if(g!==void 0){const E=g.array;v=g.version;for(let T=0,M=E.length/3-1;T<M;T+=3){const O=T+0,R=T+1,D=T+2;f.push(O,R,R,D,D,O)}}else return;const m=new(Hp(f)?qp:$p)(f,1);m.version=v;const p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){const f=r.get(h);if(f){const d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function OS(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){i.drawElements(n,d,r,f*o),e.update(d,n,1)}function c(f,d,g){g!==0&&(i.drawElementsInstanced(n,d,r,f*o,g),e.update(d,n,g))}function u(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,n,1)}function h(f,d,g,v){if(g===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(n,d,0,r,f,0,v,0,g);let p=0;for(let E=0;E<g;E++)p+=d[E]*v[E];e.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function kS(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function BS(i,t,e){const n=new WeakMap,s=new Ge;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=n.get(a);if(f===void 0||f.count!==h){let w=function(){D.dispose(),n.delete(a),a.removeEventListener("dispose",w)};f!==void 0&&f.texture.dispose();const d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],E=a.morphAttributes.color||[];let T=0;d===!0&&(T=1),g===!0&&(T=2),v===!0&&(T=3);let M=a.attributes.position.count*T,O=1;M>t.maxTextureSize&&(O=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);const R=new Float32Array(M*O*4*h),D=new Vp(R,M,O,h);D.type=qi,D.needsUpdate=!0;const U=T*4;for(let S=0;S<h;S++){const C=m[S],G=p[S],I=E[S],V=M*O*4*S;for(let j=0;j<C.count;j++){const K=j*U;d===!0&&(s.fromBufferAttribute(C,j),R[V+K+0]=s.x,R[V+K+1]=s.y,R[V+K+2]=s.z,R[V+K+3]=0),g===!0&&(s.fromBufferAttribute(G,j),R[V+K+4]=s.x,R[V+K+5]=s.y,R[V+K+6]=s.z,R[V+K+7]=0),v===!0&&(s.fromBufferAttribute(I,j),R[V+K+8]=s.x,R[V+K+9]=s.y,R[V+K+10]=s.z,R[V+K+11]=I.itemSize===4?s.w:1)}}f={count:h,texture:D,size:new ae(M,O)},n.set(a,f),a.addEventListener("dispose",w)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];const g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function zS(i,t,e,n){let s=new WeakMap;function r(l){const c=n.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class Jp extends On{constructor(t,e,n,s,r,o,a,l,c,u=Ar){if(u!==Ar&&u!==Br)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");n===void 0&&u===Ar&&(n=zs),n===void 0&&u===Br&&(n=kr),super(null,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:vi,this.minFilter=l!==void 0?l:vi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const Qp=new On,Gf=new Jp(1,1),tm=new Vp,em=new Tv,nm=new jp,Vf=[],Wf=[],Xf=new Float32Array(16),$f=new Float32Array(9),qf=new Float32Array(4);function Yr(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=Vf[s];if(r===void 0&&(r=new Float32Array(s),Vf[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function nn(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function sn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Za(i,t){let e=Wf[t];e===void 0&&(e=new Int32Array(t),Wf[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function HS(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function GS(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(nn(e,t))return;i.uniform2fv(this.addr,t),sn(e,t)}}function VS(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(nn(e,t))return;i.uniform3fv(this.addr,t),sn(e,t)}}function WS(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(nn(e,t))return;i.uniform4fv(this.addr,t),sn(e,t)}}function XS(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(nn(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),sn(e,t)}else{if(nn(e,n))return;qf.set(n),i.uniformMatrix2fv(this.addr,!1,qf),sn(e,n)}}function $S(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(nn(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),sn(e,t)}else{if(nn(e,n))return;$f.set(n),i.uniformMatrix3fv(this.addr,!1,$f),sn(e,n)}}function qS(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(nn(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),sn(e,t)}else{if(nn(e,n))return;Xf.set(n),i.uniformMatrix4fv(this.addr,!1,Xf),sn(e,n)}}function YS(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function KS(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(nn(e,t))return;i.uniform2iv(this.addr,t),sn(e,t)}}function jS(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(nn(e,t))return;i.uniform3iv(this.addr,t),sn(e,t)}}function ZS(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(nn(e,t))return;i.uniform4iv(this.addr,t),sn(e,t)}}function JS(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function QS(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(nn(e,t))return;i.uniform2uiv(this.addr,t),sn(e,t)}}function ty(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(nn(e,t))return;i.uniform3uiv(this.addr,t),sn(e,t)}}function ey(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(nn(e,t))return;i.uniform4uiv(this.addr,t),sn(e,t)}}function ny(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(Gf.compareFunction=zp,r=Gf):r=Qp,e.setTexture2D(t||r,s)}function iy(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||em,s)}function sy(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||nm,s)}function ry(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||tm,s)}function oy(i){switch(i){case 5126:return HS;case 35664:return GS;case 35665:return VS;case 35666:return WS;case 35674:return XS;case 35675:return $S;case 35676:return qS;case 5124:case 35670:return YS;case 35667:case 35671:return KS;case 35668:case 35672:return jS;case 35669:case 35673:return ZS;case 5125:return JS;case 36294:return QS;case 36295:return ty;case 36296:return ey;case 35678:case 36198:case 36298:case 36306:case 35682:return ny;case 35679:case 36299:case 36307:return iy;case 35680:case 36300:case 36308:case 36293:return sy;case 36289:case 36303:case 36311:case 36292:return ry}}function ay(i,t){i.uniform1fv(this.addr,t)}function ly(i,t){const e=Yr(t,this.size,2);i.uniform2fv(this.addr,e)}function cy(i,t){const e=Yr(t,this.size,3);i.uniform3fv(this.addr,e)}function uy(i,t){const e=Yr(t,this.size,4);i.uniform4fv(this.addr,e)}function hy(i,t){const e=Yr(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function fy(i,t){const e=Yr(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function dy(i,t){const e=Yr(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function py(i,t){i.uniform1iv(this.addr,t)}function my(i,t){i.uniform2iv(this.addr,t)}function gy(i,t){i.uniform3iv(this.addr,t)}function _y(i,t){i.uniform4iv(this.addr,t)}function vy(i,t){i.uniform1uiv(this.addr,t)}function xy(i,t){i.uniform2uiv(this.addr,t)}function My(i,t){i.uniform3uiv(this.addr,t)}function Sy(i,t){i.uniform4uiv(this.addr,t)}function yy(i,t,e){const n=this.cache,s=t.length,r=Za(e,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Qp,r[o])}function Ey(i,t,e){const n=this.cache,s=t.length,r=Za(e,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||em,r[o])}function by(i,t,e){const n=this.cache,s=t.length,r=Za(e,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||nm,r[o])}function wy(i,t,e){const n=this.cache,s=t.length,r=Za(e,s);nn(n,r)||(i.uniform1iv(this.addr,r),sn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||tm,r[o])}function Ty(i){switch(i){case 5126:return ay;case 35664:return ly;case 35665:return cy;case 35666:return uy;case 35674:return hy;case 35675:return fy;case 35676:return dy;case 5124:case 35670:return py;case 35667:case 35671:return my;case 35668:case 35672:return gy;case 35669:case 35673:return _y;case 5125:return vy;case 36294:return xy;case 36295:return My;case 36296:return Sy;case 35678:case 36198:case 36298:case 36306:case 35682:return yy;case 35679:case 36299:case 36307:return Ey;case 35680:case 36300:case 36308:case 36293:return by;case 36289:case 36303:case 36311:case 36292:return wy}}class Ay{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=oy(e.type)}}class Ry{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Ty(e.type)}}class Cy{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],n)}}}const ql=/(\w+)(\])?(\[|\.)?/g;function Yf(i,t){i.seq.push(t),i.map[t.id]=t}function Py(i,t,e){const n=i.name,s=n.length;for(ql.lastIndex=0;;){const r=ql.exec(n),o=ql.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Yf(e,c===void 0?new Ay(a,i,t):new Ry(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new Cy(a),Yf(e,h)),e=h}}}class wa{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);Py(r,o,this)}}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&n.push(o)}return n}}function Kf(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const Ly=37297;let Dy=0;function Uy(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}const jf=new Qt;function Iy(i){me._getMatrix(jf,me.workingColorSpace,i);const t=`mat3( ${jf.elements.map(e=>e.toFixed(4))} )`;switch(me.getTransfer(i)){case Ka:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Zf(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),s=i.getShaderInfoLog(t).trim();if(n&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+Uy(i.getShaderSource(t),o)}else return s}function Ny(i,t){const e=Iy(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function Fy(i,t){let e;switch(t){case Q0:e="Linear";break;case tv:e="Reinhard";break;case ev:e="Cineon";break;case nv:e="ACESFilmic";break;case sv:e="AgX";break;case rv:e="Neutral";break;case iv:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const aa=new z;function Oy(){me.getLuminanceCoefficients(aa);const i=aa.x.toFixed(4),t=aa.y.toFixed(4),e=aa.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function ky(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(mo).join(`
`)}function By(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function zy(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function mo(i){return i!==""}function Jf(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Qf(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const Hy=/^[ \t]*#include +<([\w\d./]+)>/gm;function nu(i){return i.replace(Hy,Vy)}const Gy=new Map;function Vy(i,t){let e=ee[t];if(e===void 0){const n=Gy.get(t);if(n!==void 0)e=ee[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return nu(e)}const Wy=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function td(i){return i.replace(Wy,Xy)}function Xy(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function ed(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function $y(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Ap?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===D0?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===$i&&(t="SHADOWMAP_TYPE_VSM"),t}function qy(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case Fr:case Or:t="ENVMAP_TYPE_CUBE";break;case Ya:t="ENVMAP_TYPE_CUBE_UV";break}return t}function Yy(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Or:t="ENVMAP_MODE_REFRACTION";break}return t}function Ky(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Uu:t="ENVMAP_BLENDING_MULTIPLY";break;case Z0:t="ENVMAP_BLENDING_MIX";break;case J0:t="ENVMAP_BLENDING_ADD";break}return t}function jy(i){const t=i.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function Zy(i,t,e,n){const s=i.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=$y(e),c=qy(e),u=Yy(e),h=Ky(e),f=jy(e),d=ky(e),g=By(r),v=s.createProgram();let m,p,E=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(mo).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(mo).join(`
`),p.length>0&&(p+=`
`)):(m=[ed(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(mo).join(`
`),p=[ed(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ds?"#define TONE_MAPPING":"",e.toneMapping!==ds?ee.tonemapping_pars_fragment:"",e.toneMapping!==ds?Fy("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ee.colorspace_pars_fragment,Ny("linearToOutputTexel",e.outputColorSpace),Oy(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(mo).join(`
`)),o=nu(o),o=Jf(o,e),o=Qf(o,e),a=nu(a),a=Jf(a,e),a=Qf(a,e),o=td(o),a=td(a),e.isRawShaderMaterial!==!0&&(E=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===pf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===pf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const T=E+m+o,M=E+p+a,O=Kf(s,s.VERTEX_SHADER,T),R=Kf(s,s.FRAGMENT_SHADER,M);s.attachShader(v,O),s.attachShader(v,R),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(i.debug.checkShaderErrors){const G=s.getProgramInfoLog(v).trim(),I=s.getShaderInfoLog(O).trim(),V=s.getShaderInfoLog(R).trim();let j=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(j=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,O,R);else{const Q=Zf(s,O,"vertex"),tt=Zf(s,R,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+G+`
`+Q+`
`+tt)}else G!==""?console.warn("THREE.WebGLProgram: Program Info Log:",G):(I===""||V==="")&&(K=!1);K&&(C.diagnostics={runnable:j,programLog:G,vertexShader:{log:I,prefix:m},fragmentShader:{log:V,prefix:p}})}s.deleteShader(O),s.deleteShader(R),U=new wa(s,v),w=zy(s,v)}let U;this.getUniforms=function(){return U===void 0&&D(this),U};let w;this.getAttributes=function(){return w===void 0&&D(this),w};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,Ly)),S},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Dy++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=O,this.fragmentShader=R,this}let Jy=0;class Qy{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new tE(t),e.set(t,n)),n}}class tE{constructor(t){this.id=Jy++,this.code=t,this.usedTimes=0}}function eE(i,t,e,n,s,r,o){const a=new Wp,l=new Qy,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let d=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(w){return c.add(w),w===0?"uv":`uv${w}`}function m(w,S,C,G,I){const V=G.fog,j=I.geometry,K=w.isMeshStandardMaterial?G.environment:null,Q=(w.isMeshStandardMaterial?e:t).get(w.envMap||K),tt=Q&&Q.mapping===Ya?Q.image.height:null,ht=g[w.type];w.precision!==null&&(d=s.getMaxPrecision(w.precision),d!==w.precision&&console.warn("THREE.WebGLProgram.getParameters:",w.precision,"not supported, using",d,"instead."));const ct=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mt=ct!==void 0?ct.length:0;let Mt=0;j.morphAttributes.position!==void 0&&(Mt=1),j.morphAttributes.normal!==void 0&&(Mt=2),j.morphAttributes.color!==void 0&&(Mt=3);let pt,it,at,gt;if(ht){const ve=Ai[ht];pt=ve.vertexShader,it=ve.fragmentShader}else pt=w.vertexShader,it=w.fragmentShader,l.update(w),at=l.getVertexShaderID(w),gt=l.getFragmentShaderID(w);const ot=i.getRenderTarget(),Bt=i.state.buffers.depth.getReversed(),Ht=I.isInstancedMesh===!0,It=I.isBatchedMesh===!0,ce=!!w.map,jt=!!w.matcap,ue=!!Q,B=!!w.aoMap,Ze=!!w.lightMap,Jt=!!w.bumpMap,te=!!w.normalMap,Gt=!!w.displacementMap,fe=!!w.emissiveMap,Pt=!!w.metalnessMap,P=!!w.roughnessMap,y=w.anisotropy>0,Y=w.clearcoat>0,Z=w.dispersion>0,W=w.iridescence>0,et=w.sheen>0,St=w.transmission>0,_t=y&&!!w.anisotropyMap,wt=Y&&!!w.clearcoatMap,Kt=Y&&!!w.clearcoatNormalMap,ft=Y&&!!w.clearcoatRoughnessMap,vt=W&&!!w.iridescenceMap,Nt=W&&!!w.iridescenceThicknessMap,Ot=et&&!!w.sheenColorMap,Et=et&&!!w.sheenRoughnessMap,ne=!!w.specularMap,qt=!!w.specularColorMap,de=!!w.specularIntensityMap,k=St&&!!w.transmissionMap,xt=St&&!!w.thicknessMap,nt=!!w.gradientMap,rt=!!w.alphaMap,Tt=w.alphaTest>0,At=!!w.alphaHash,Zt=!!w.extensions;let Be=ds;w.toneMapped&&(ot===null||ot.isXRRenderTarget===!0)&&(Be=i.toneMapping);const an={shaderID:ht,shaderType:w.type,shaderName:w.name,vertexShader:pt,fragmentShader:it,defines:w.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:w.isRawShaderMaterial===!0,glslVersion:w.glslVersion,precision:d,batching:It,batchingColor:It&&I._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&I.instanceColor!==null,instancingMorph:Ht&&I.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:ot===null?i.outputColorSpace:ot.isXRRenderTarget===!0?ot.texture.colorSpace:Xs,alphaToCoverage:!!w.alphaToCoverage,map:ce,matcap:jt,envMap:ue,envMapMode:ue&&Q.mapping,envMapCubeUVHeight:tt,aoMap:B,lightMap:Ze,bumpMap:Jt,normalMap:te,displacementMap:f&&Gt,emissiveMap:fe,normalMapObjectSpace:te&&w.normalMapType===cv,normalMapTangentSpace:te&&w.normalMapType===Bp,metalnessMap:Pt,roughnessMap:P,anisotropy:y,anisotropyMap:_t,clearcoat:Y,clearcoatMap:wt,clearcoatNormalMap:Kt,clearcoatRoughnessMap:ft,dispersion:Z,iridescence:W,iridescenceMap:vt,iridescenceThicknessMap:Nt,sheen:et,sheenColorMap:Ot,sheenRoughnessMap:Et,specularMap:ne,specularColorMap:qt,specularIntensityMap:de,transmission:St,transmissionMap:k,thicknessMap:xt,gradientMap:nt,opaque:w.transparent===!1&&w.blending===Tr&&w.alphaToCoverage===!1,alphaMap:rt,alphaTest:Tt,alphaHash:At,combine:w.combine,mapUv:ce&&v(w.map.channel),aoMapUv:B&&v(w.aoMap.channel),lightMapUv:Ze&&v(w.lightMap.channel),bumpMapUv:Jt&&v(w.bumpMap.channel),normalMapUv:te&&v(w.normalMap.channel),displacementMapUv:Gt&&v(w.displacementMap.channel),emissiveMapUv:fe&&v(w.emissiveMap.channel),metalnessMapUv:Pt&&v(w.metalnessMap.channel),roughnessMapUv:P&&v(w.roughnessMap.channel),anisotropyMapUv:_t&&v(w.anisotropyMap.channel),clearcoatMapUv:wt&&v(w.clearcoatMap.channel),clearcoatNormalMapUv:Kt&&v(w.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&v(w.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&v(w.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&v(w.iridescenceThicknessMap.channel),sheenColorMapUv:Ot&&v(w.sheenColorMap.channel),sheenRoughnessMapUv:Et&&v(w.sheenRoughnessMap.channel),specularMapUv:ne&&v(w.specularMap.channel),specularColorMapUv:qt&&v(w.specularColorMap.channel),specularIntensityMapUv:de&&v(w.specularIntensityMap.channel),transmissionMapUv:k&&v(w.transmissionMap.channel),thicknessMapUv:xt&&v(w.thicknessMap.channel),alphaMapUv:rt&&v(w.alphaMap.channel),vertexTangents:!!j.attributes.tangent&&(te||y),vertexColors:w.vertexColors,vertexAlphas:w.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!j.attributes.uv&&(ce||rt),fog:!!V,useFog:w.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:w.flatShading===!0,sizeAttenuation:w.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:Bt,skinning:I.isSkinnedMesh===!0,morphTargets:j.morphAttributes.position!==void 0,morphNormals:j.morphAttributes.normal!==void 0,morphColors:j.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:Mt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:w.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:Be,decodeVideoTexture:ce&&w.map.isVideoTexture===!0&&me.getTransfer(w.map.colorSpace)===Ae,decodeVideoTextureEmissive:fe&&w.emissiveMap.isVideoTexture===!0&&me.getTransfer(w.emissiveMap.colorSpace)===Ae,premultipliedAlpha:w.premultipliedAlpha,doubleSided:w.side===Ri,flipSided:w.side===Fn,useDepthPacking:w.depthPacking>=0,depthPacking:w.depthPacking||0,index0AttributeName:w.index0AttributeName,extensionClipCullDistance:Zt&&w.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&w.extensions.multiDraw===!0||It)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:w.customProgramCacheKey()};return an.vertexUv1s=c.has(1),an.vertexUv2s=c.has(2),an.vertexUv3s=c.has(3),c.clear(),an}function p(w){const S=[];if(w.shaderID?S.push(w.shaderID):(S.push(w.customVertexShaderID),S.push(w.customFragmentShaderID)),w.defines!==void 0)for(const C in w.defines)S.push(C),S.push(w.defines[C]);return w.isRawShaderMaterial===!1&&(E(S,w),T(S,w),S.push(i.outputColorSpace)),S.push(w.customProgramCacheKey),S.join()}function E(w,S){w.push(S.precision),w.push(S.outputColorSpace),w.push(S.envMapMode),w.push(S.envMapCubeUVHeight),w.push(S.mapUv),w.push(S.alphaMapUv),w.push(S.lightMapUv),w.push(S.aoMapUv),w.push(S.bumpMapUv),w.push(S.normalMapUv),w.push(S.displacementMapUv),w.push(S.emissiveMapUv),w.push(S.metalnessMapUv),w.push(S.roughnessMapUv),w.push(S.anisotropyMapUv),w.push(S.clearcoatMapUv),w.push(S.clearcoatNormalMapUv),w.push(S.clearcoatRoughnessMapUv),w.push(S.iridescenceMapUv),w.push(S.iridescenceThicknessMapUv),w.push(S.sheenColorMapUv),w.push(S.sheenRoughnessMapUv),w.push(S.specularMapUv),w.push(S.specularColorMapUv),w.push(S.specularIntensityMapUv),w.push(S.transmissionMapUv),w.push(S.thicknessMapUv),w.push(S.combine),w.push(S.fogExp2),w.push(S.sizeAttenuation),w.push(S.morphTargetsCount),w.push(S.morphAttributeCount),w.push(S.numDirLights),w.push(S.numPointLights),w.push(S.numSpotLights),w.push(S.numSpotLightMaps),w.push(S.numHemiLights),w.push(S.numRectAreaLights),w.push(S.numDirLightShadows),w.push(S.numPointLightShadows),w.push(S.numSpotLightShadows),w.push(S.numSpotLightShadowsWithMaps),w.push(S.numLightProbes),w.push(S.shadowMapType),w.push(S.toneMapping),w.push(S.numClippingPlanes),w.push(S.numClipIntersection),w.push(S.depthPacking)}function T(w,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),w.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),w.push(a.mask)}function M(w){const S=g[w.type];let C;if(S){const G=Ai[S];C=kv.clone(G.uniforms)}else C=w.uniforms;return C}function O(w,S){let C;for(let G=0,I=u.length;G<I;G++){const V=u[G];if(V.cacheKey===S){C=V,++C.usedTimes;break}}return C===void 0&&(C=new Zy(i,S,w,r),u.push(C)),C}function R(w){if(--w.usedTimes===0){const S=u.indexOf(w);u[S]=u[u.length-1],u.pop(),w.destroy()}}function D(w){l.remove(w)}function U(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:M,acquireProgram:O,releaseProgram:R,releaseShaderCache:D,programs:u,dispose:U}}function nE(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function iE(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function nd(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function id(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(h,f,d,g,v,m){let p=i[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},i[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?n.push(p):d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?n.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||iE),n.length>1&&n.sort(f||nd),s.length>1&&s.sort(f||nd)}function u(){for(let h=t,f=i.length;h<f;h++){const d=i[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function sE(){let i=new WeakMap;function t(n,s){const r=i.get(n);let o;return r===void 0?(o=new id,i.set(n,[o])):s>=r.length?(o=new id,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function rE(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new z,color:new oe};break;case"SpotLight":e={position:new z,direction:new z,color:new oe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new oe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new oe,groundColor:new oe};break;case"RectAreaLight":e={color:new oe,position:new z,halfWidth:new z,halfHeight:new z};break}return i[t.id]=e,e}}}function oE(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ae};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ae};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ae,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let aE=0;function lE(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function cE(i){const t=new rE,e=oE(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new z);const s=new z,r=new Ue,o=new Ue;function a(c){let u=0,h=0,f=0;for(let w=0;w<9;w++)n.probe[w].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,E=0,T=0,M=0,O=0,R=0,D=0;c.sort(lE);for(let w=0,S=c.length;w<S;w++){const C=c[w],G=C.color,I=C.intensity,V=C.distance,j=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=G.r*I,h+=G.g*I,f+=G.b*I;else if(C.isLightProbe){for(let K=0;K<9;K++)n.probe[K].addScaledVector(C.sh.coefficients[K],I);D++}else if(C.isDirectionalLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,n.directionalShadow[d]=tt,n.directionalShadowMap[d]=j,n.directionalShadowMatrix[d]=C.shadow.matrix,E++}n.directional[d]=K,d++}else if(C.isSpotLight){const K=t.get(C);K.position.setFromMatrixPosition(C.matrixWorld),K.color.copy(G).multiplyScalar(I),K.distance=V,K.coneCos=Math.cos(C.angle),K.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),K.decay=C.decay,n.spot[v]=K;const Q=C.shadow;if(C.map&&(n.spotLightMap[O]=C.map,O++,Q.updateMatrices(C),C.castShadow&&R++),n.spotLightMatrix[v]=Q.matrix,C.castShadow){const tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,n.spotShadow[v]=tt,n.spotShadowMap[v]=j,M++}v++}else if(C.isRectAreaLight){const K=t.get(C);K.color.copy(G).multiplyScalar(I),K.halfWidth.set(C.width*.5,0,0),K.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=K,m++}else if(C.isPointLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),K.distance=C.distance,K.decay=C.decay,C.castShadow){const Q=C.shadow,tt=e.get(C);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,n.pointShadow[g]=tt,n.pointShadowMap[g]=j,n.pointShadowMatrix[g]=C.shadow.matrix,T++}n.point[g]=K,g++}else if(C.isHemisphereLight){const K=t.get(C);K.skyColor.copy(C.color).multiplyScalar(I),K.groundColor.copy(C.groundColor).multiplyScalar(I),n.hemi[p]=K,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=bt.LTC_FLOAT_1,n.rectAreaLTC2=bt.LTC_FLOAT_2):(n.rectAreaLTC1=bt.LTC_HALF_1,n.rectAreaLTC2=bt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;const U=n.hash;(U.directionalLength!==d||U.pointLength!==g||U.spotLength!==v||U.rectAreaLength!==m||U.hemiLength!==p||U.numDirectionalShadows!==E||U.numPointShadows!==T||U.numSpotShadows!==M||U.numSpotMaps!==O||U.numLightProbes!==D)&&(n.directional.length=d,n.spot.length=v,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=E,n.directionalShadowMap.length=E,n.pointShadow.length=T,n.pointShadowMap.length=T,n.spotShadow.length=M,n.spotShadowMap.length=M,n.directionalShadowMatrix.length=E,n.pointShadowMatrix.length=T,n.spotLightMatrix.length=M+O-R,n.spotLightMap.length=O,n.numSpotLightShadowsWithMaps=R,n.numLightProbes=D,U.directionalLength=d,U.pointLength=g,U.spotLength=v,U.rectAreaLength=m,U.hemiLength=p,U.numDirectionalShadows=E,U.numPointShadows=T,U.numSpotShadows=M,U.numSpotMaps=O,U.numLightProbes=D,n.version=aE++)}function l(c,u){let h=0,f=0,d=0,g=0,v=0;const m=u.matrixWorldInverse;for(let p=0,E=c.length;p<E;p++){const T=c[p];if(T.isDirectionalLight){const M=n.directional[h];M.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),h++}else if(T.isSpotLight){const M=n.spot[d];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(m),M.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),d++}else if(T.isRectAreaLight){const M=n.rectArea[g];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.extractRotation(r),M.halfWidth.set(T.width*.5,0,0),M.halfHeight.set(0,T.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),g++}else if(T.isPointLight){const M=n.point[f];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){const M=n.hemi[v];M.direction.setFromMatrixPosition(T.matrixWorld),M.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:n}}function sd(i){const t=new cE(i),e=[],n=[];function s(u){c.camera=u,e.length=0,n.length=0}function r(u){e.push(u)}function o(u){n.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function uE(i){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new sd(i),t.set(s,[a])):r>=o.length?(a=new sd(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}class hE extends qs{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=av,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class fE extends qs{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const dE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,pE=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function mE(i,t,e){let n=new Hu;const s=new ae,r=new ae,o=new Ge,a=new hE({depthPacking:lv}),l=new fE,c={},u=e.maxTextureSize,h={[ms]:Fn,[Fn]:ms,[Ri]:Ri},f=new gs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ae},radius:{value:4}},vertexShader:dE,fragmentShader:pE}),d=f.clone();d.defines.HORIZONTAL_PASS=1;const g=new on;g.setAttribute("position",new kn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new Sn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ap;let p=this.type;this.render=function(R,D,U){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;const w=i.getRenderTarget(),S=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),G=i.state;G.setBlending(fs),G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);const I=p!==$i&&this.type===$i,V=p===$i&&this.type!==$i;for(let j=0,K=R.length;j<K;j++){const Q=R[j],tt=Q.shadow;if(tt===void 0){console.warn("THREE.WebGLShadowMap:",Q,"has no shadow.");continue}if(tt.autoUpdate===!1&&tt.needsUpdate===!1)continue;s.copy(tt.mapSize);const ht=tt.getFrameExtents();if(s.multiply(ht),r.copy(tt.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,tt.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,tt.mapSize.y=r.y)),tt.map===null||I===!0||V===!0){const mt=this.type!==$i?{minFilter:vi,magFilter:vi}:{};tt.map!==null&&tt.map.dispose(),tt.map=new Hs(s.x,s.y,mt),tt.map.texture.name=Q.name+".shadowMap",tt.camera.updateProjectionMatrix()}i.setRenderTarget(tt.map),i.clear();const ct=tt.getViewportCount();for(let mt=0;mt<ct;mt++){const Mt=tt.getViewport(mt);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),G.viewport(o),tt.updateMatrices(Q,mt),n=tt.getFrustum(),M(D,U,tt.camera,Q,this.type)}tt.isPointLightShadow!==!0&&this.type===$i&&E(tt,U),tt.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(w,S,C)};function E(R,D){const U=t.update(v);f.defines.VSM_SAMPLES!==R.blurSamples&&(f.defines.VSM_SAMPLES=R.blurSamples,d.defines.VSM_SAMPLES=R.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new Hs(s.x,s.y)),f.uniforms.shadow_pass.value=R.map.texture,f.uniforms.resolution.value=R.mapSize,f.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(D,null,U,f,v,null),d.uniforms.shadow_pass.value=R.mapPass.texture,d.uniforms.resolution.value=R.mapSize,d.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(D,null,U,d,v,null)}function T(R,D,U,w){let S=null;const C=U.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(C!==void 0)S=C;else if(S=U.isPointLight===!0?l:a,i.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const G=S.uuid,I=D.uuid;let V=c[G];V===void 0&&(V={},c[G]=V);let j=V[I];j===void 0&&(j=S.clone(),V[I]=j,D.addEventListener("dispose",O)),S=j}if(S.visible=D.visible,S.wireframe=D.wireframe,w===$i?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:h[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,U.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const G=i.properties.get(S);G.light=U}return S}function M(R,D,U,w,S){if(R.visible===!1)return;if(R.layers.test(D.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&S===$i)&&(!R.frustumCulled||n.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(U.matrixWorldInverse,R.matrixWorld);const I=t.update(R),V=R.material;if(Array.isArray(V)){const j=I.groups;for(let K=0,Q=j.length;K<Q;K++){const tt=j[K],ht=V[tt.materialIndex];if(ht&&ht.visible){const ct=T(R,ht,w,S);R.onBeforeShadow(i,R,D,U,I,ct,tt),i.renderBufferDirect(U,null,I,ct,R,tt),R.onAfterShadow(i,R,D,U,I,ct,tt)}}}else if(V.visible){const j=T(R,V,w,S);R.onBeforeShadow(i,R,D,U,I,j,null),i.renderBufferDirect(U,null,I,j,R,null),R.onAfterShadow(i,R,D,U,I,j,null)}}const G=R.children;for(let I=0,V=G.length;I<V;I++)M(G[I],D,U,w,S)}function O(R){R.target.removeEventListener("dispose",O);for(const U in c){const w=c[U],S=R.target.uuid;S in w&&(w[S].dispose(),delete w[S])}}}const gE={[vc]:xc,[Mc]:Ec,[Sc]:bc,[Nr]:yc,[xc]:vc,[Ec]:Mc,[bc]:Sc,[yc]:Nr};function _E(i,t){function e(){let k=!1;const xt=new Ge;let nt=null;const rt=new Ge(0,0,0,0);return{setMask:function(Tt){nt!==Tt&&!k&&(i.colorMask(Tt,Tt,Tt,Tt),nt=Tt)},setLocked:function(Tt){k=Tt},setClear:function(Tt,At,Zt,Be,an){an===!0&&(Tt*=Be,At*=Be,Zt*=Be),xt.set(Tt,At,Zt,Be),rt.equals(xt)===!1&&(i.clearColor(Tt,At,Zt,Be),rt.copy(xt))},reset:function(){k=!1,nt=null,rt.set(-1,0,0,0)}}}function n(){let k=!1,xt=!1,nt=null,rt=null,Tt=null;return{setReversed:function(At){if(xt!==At){const Zt=t.get("EXT_clip_control");xt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT);const Be=Tt;Tt=null,this.setClear(Be)}xt=At},getReversed:function(){return xt},setTest:function(At){At?ot(i.DEPTH_TEST):Bt(i.DEPTH_TEST)},setMask:function(At){nt!==At&&!k&&(i.depthMask(At),nt=At)},setFunc:function(At){if(xt&&(At=gE[At]),rt!==At){switch(At){case vc:i.depthFunc(i.NEVER);break;case xc:i.depthFunc(i.ALWAYS);break;case Mc:i.depthFunc(i.LESS);break;case Nr:i.depthFunc(i.LEQUAL);break;case Sc:i.depthFunc(i.EQUAL);break;case yc:i.depthFunc(i.GEQUAL);break;case Ec:i.depthFunc(i.GREATER);break;case bc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}rt=At}},setLocked:function(At){k=At},setClear:function(At){Tt!==At&&(xt&&(At=1-At),i.clearDepth(At),Tt=At)},reset:function(){k=!1,nt=null,rt=null,Tt=null,xt=!1}}}function s(){let k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Zt=null,Be=null,an=null;return{setTest:function(ve){k||(ve?ot(i.STENCIL_TEST):Bt(i.STENCIL_TEST))},setMask:function(ve){xt!==ve&&!k&&(i.stencilMask(ve),xt=ve)},setFunc:function(ve,Je,Le){(nt!==ve||rt!==Je||Tt!==Le)&&(i.stencilFunc(ve,Je,Le),nt=ve,rt=Je,Tt=Le)},setOp:function(ve,Je,Le){(At!==ve||Zt!==Je||Be!==Le)&&(i.stencilOp(ve,Je,Le),At=ve,Zt=Je,Be=Le)},setLocked:function(ve){k=ve},setClear:function(ve){an!==ve&&(i.clearStencil(ve),an=ve)},reset:function(){k=!1,xt=null,nt=null,rt=null,Tt=null,At=null,Zt=null,Be=null,an=null}}}const r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,E=null,T=null,M=null,O=null,R=null,D=new oe(0,0,0),U=0,w=!1,S=null,C=null,G=null,I=null,V=null;const j=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let K=!1,Q=0;const tt=i.getParameter(i.VERSION);tt.indexOf("WebGL")!==-1?(Q=parseFloat(/^WebGL (\d)/.exec(tt)[1]),K=Q>=1):tt.indexOf("OpenGL ES")!==-1&&(Q=parseFloat(/^OpenGL ES (\d)/.exec(tt)[1]),K=Q>=2);let ht=null,ct={};const mt=i.getParameter(i.SCISSOR_BOX),Mt=i.getParameter(i.VIEWPORT),pt=new Ge().fromArray(mt),it=new Ge().fromArray(Mt);function at(k,xt,nt,rt){const Tt=new Uint8Array(4),At=i.createTexture();i.bindTexture(k,At),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Zt=0;Zt<nt;Zt++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(xt,0,i.RGBA,1,1,rt,0,i.RGBA,i.UNSIGNED_BYTE,Tt):i.texImage2D(xt+Zt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Tt);return At}const gt={};gt[i.TEXTURE_2D]=at(i.TEXTURE_2D,i.TEXTURE_2D,1),gt[i.TEXTURE_CUBE_MAP]=at(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[i.TEXTURE_2D_ARRAY]=at(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),gt[i.TEXTURE_3D]=at(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ot(i.DEPTH_TEST),o.setFunc(Nr),Jt(!1),te(lf),ot(i.CULL_FACE),B(fs);function ot(k){u[k]!==!0&&(i.enable(k),u[k]=!0)}function Bt(k){u[k]!==!1&&(i.disable(k),u[k]=!1)}function Ht(k,xt){return h[k]!==xt?(i.bindFramebuffer(k,xt),h[k]=xt,k===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=xt),k===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=xt),!0):!1}function It(k,xt){let nt=d,rt=!1;if(k){nt=f.get(xt),nt===void 0&&(nt=[],f.set(xt,nt));const Tt=k.textures;if(nt.length!==Tt.length||nt[0]!==i.COLOR_ATTACHMENT0){for(let At=0,Zt=Tt.length;At<Zt;At++)nt[At]=i.COLOR_ATTACHMENT0+At;nt.length=Tt.length,rt=!0}}else nt[0]!==i.BACK&&(nt[0]=i.BACK,rt=!0);rt&&i.drawBuffers(nt)}function ce(k){return g!==k?(i.useProgram(k),g=k,!0):!1}const jt={[Is]:i.FUNC_ADD,[I0]:i.FUNC_SUBTRACT,[N0]:i.FUNC_REVERSE_SUBTRACT};jt[F0]=i.MIN,jt[O0]=i.MAX;const ue={[k0]:i.ZERO,[B0]:i.ONE,[z0]:i.SRC_COLOR,[gc]:i.SRC_ALPHA,[$0]:i.SRC_ALPHA_SATURATE,[W0]:i.DST_COLOR,[G0]:i.DST_ALPHA,[H0]:i.ONE_MINUS_SRC_COLOR,[_c]:i.ONE_MINUS_SRC_ALPHA,[X0]:i.ONE_MINUS_DST_COLOR,[V0]:i.ONE_MINUS_DST_ALPHA,[q0]:i.CONSTANT_COLOR,[Y0]:i.ONE_MINUS_CONSTANT_COLOR,[K0]:i.CONSTANT_ALPHA,[j0]:i.ONE_MINUS_CONSTANT_ALPHA};function B(k,xt,nt,rt,Tt,At,Zt,Be,an,ve){if(k===fs){v===!0&&(Bt(i.BLEND),v=!1);return}if(v===!1&&(ot(i.BLEND),v=!0),k!==U0){if(k!==m||ve!==w){if((p!==Is||M!==Is)&&(i.blendEquation(i.FUNC_ADD),p=Is,M=Is),ve)switch(k){case Tr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case cf:i.blendFunc(i.ONE,i.ONE);break;case uf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case hf:i.blendFuncSeparate(i.ZERO,i.SRC_COLOR,i.ZERO,i.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}else switch(k){case Tr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case cf:i.blendFunc(i.SRC_ALPHA,i.ONE);break;case uf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case hf:i.blendFunc(i.ZERO,i.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}E=null,T=null,O=null,R=null,D.set(0,0,0),U=0,m=k,w=ve}return}Tt=Tt||xt,At=At||nt,Zt=Zt||rt,(xt!==p||Tt!==M)&&(i.blendEquationSeparate(jt[xt],jt[Tt]),p=xt,M=Tt),(nt!==E||rt!==T||At!==O||Zt!==R)&&(i.blendFuncSeparate(ue[nt],ue[rt],ue[At],ue[Zt]),E=nt,T=rt,O=At,R=Zt),(Be.equals(D)===!1||an!==U)&&(i.blendColor(Be.r,Be.g,Be.b,an),D.copy(Be),U=an),m=k,w=!1}function Ze(k,xt){k.side===Ri?Bt(i.CULL_FACE):ot(i.CULL_FACE);let nt=k.side===Fn;xt&&(nt=!nt),Jt(nt),k.blending===Tr&&k.transparent===!1?B(fs):B(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);const rt=k.stencilWrite;a.setTest(rt),rt&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),fe(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?ot(i.SAMPLE_ALPHA_TO_COVERAGE):Bt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Jt(k){S!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),S=k)}function te(k){k!==P0?(ot(i.CULL_FACE),k!==C&&(k===lf?i.cullFace(i.BACK):k===L0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Bt(i.CULL_FACE),C=k}function Gt(k){k!==G&&(K&&i.lineWidth(k),G=k)}function fe(k,xt,nt){k?(ot(i.POLYGON_OFFSET_FILL),(I!==xt||V!==nt)&&(i.polygonOffset(xt,nt),I=xt,V=nt)):Bt(i.POLYGON_OFFSET_FILL)}function Pt(k){k?ot(i.SCISSOR_TEST):Bt(i.SCISSOR_TEST)}function P(k){k===void 0&&(k=i.TEXTURE0+j-1),ht!==k&&(i.activeTexture(k),ht=k)}function y(k,xt,nt){nt===void 0&&(ht===null?nt=i.TEXTURE0+j-1:nt=ht);let rt=ct[nt];rt===void 0&&(rt={type:void 0,texture:void 0},ct[nt]=rt),(rt.type!==k||rt.texture!==xt)&&(ht!==nt&&(i.activeTexture(nt),ht=nt),i.bindTexture(k,xt||gt[k]),rt.type=k,rt.texture=xt)}function Y(){const k=ct[ht];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Z(){try{i.compressedTexImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function W(){try{i.compressedTexImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function et(){try{i.texSubImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function St(){try{i.texSubImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function _t(){try{i.compressedTexSubImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function wt(){try{i.compressedTexSubImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Kt(){try{i.texStorage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ft(){try{i.texStorage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function vt(){try{i.texImage2D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Nt(){try{i.texImage3D.apply(i,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Ot(k){pt.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),pt.copy(k))}function Et(k){it.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),it.copy(k))}function ne(k,xt){let nt=c.get(xt);nt===void 0&&(nt=new WeakMap,c.set(xt,nt));let rt=nt.get(k);rt===void 0&&(rt=i.getUniformBlockIndex(xt,k.name),nt.set(k,rt))}function qt(k,xt){const rt=c.get(xt).get(k);l.get(xt)!==rt&&(i.uniformBlockBinding(xt,rt,k.__bindingPointIndex),l.set(xt,rt))}function de(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},ht=null,ct={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,E=null,T=null,M=null,O=null,R=null,D=new oe(0,0,0),U=0,w=!1,S=null,C=null,G=null,I=null,V=null,pt.set(0,0,i.canvas.width,i.canvas.height),it.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ot,disable:Bt,bindFramebuffer:Ht,drawBuffers:It,useProgram:ce,setBlending:B,setMaterial:Ze,setFlipSided:Jt,setCullFace:te,setLineWidth:Gt,setPolygonOffset:fe,setScissorTest:Pt,activeTexture:P,bindTexture:y,unbindTexture:Y,compressedTexImage2D:Z,compressedTexImage3D:W,texImage2D:vt,texImage3D:Nt,updateUBOMapping:ne,uniformBlockBinding:qt,texStorage2D:Kt,texStorage3D:ft,texSubImage2D:et,texSubImage3D:St,compressedTexSubImage2D:_t,compressedTexSubImage3D:wt,scissor:Ot,viewport:Et,reset:de}}function rd(i,t,e,n){const s=vE(n);switch(e){case Dp:return i*t;case Ip:return i*t;case Np:return i*t*2;case Fp:return i*t/s.components*s.byteLength;case Ou:return i*t/s.components*s.byteLength;case Op:return i*t*2/s.components*s.byteLength;case ku:return i*t*2/s.components*s.byteLength;case Up:return i*t*3/s.components*s.byteLength;case gi:return i*t*4/s.components*s.byteLength;case Bu:return i*t*4/s.components*s.byteLength;case xa:case Ma:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Sa:case ya:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Pc:case Dc:return Math.max(i,16)*Math.max(t,8)/4;case Cc:case Lc:return Math.max(i,8)*Math.max(t,8)/2;case Uc:case Ic:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Nc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Fc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Oc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case kc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Bc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case zc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Hc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Gc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Vc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Wc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Xc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case $c:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case qc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Yc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Kc:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Ea:case jc:case Zc:return Math.ceil(i/4)*Math.ceil(t/4)*16;case kp:case Jc:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Qc:case tu:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function vE(i){switch(i){case Ji:case Cp:return{byteLength:1,components:1};case So:case Pp:case wo:return{byteLength:2,components:1};case Nu:case Fu:return{byteLength:2,components:4};case zs:case Iu:case qi:return{byteLength:4,components:1};case Lp:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}function xE(i,t,e,n,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ae,u=new WeakMap;let h;const f=new WeakMap;let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,y){return d?new OffscreenCanvas(P,y):Da("canvas")}function v(P,y,Y){let Z=1;const W=Pt(P);if((W.width>Y||W.height>Y)&&(Z=Y/Math.max(W.width,W.height)),Z<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){const et=Math.floor(Z*W.width),St=Math.floor(Z*W.height);h===void 0&&(h=g(et,St));const _t=y?g(et,St):h;return _t.width=et,_t.height=St,_t.getContext("2d").drawImage(P,0,0,et,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+et+"x"+St+")."),_t}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){i.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?i.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(P,y,Y,Z,W=!1){if(P!==null){if(i[P]!==void 0)return i[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let et=y;if(y===i.RED&&(Y===i.FLOAT&&(et=i.R32F),Y===i.HALF_FLOAT&&(et=i.R16F),Y===i.UNSIGNED_BYTE&&(et=i.R8)),y===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.R8UI),Y===i.UNSIGNED_SHORT&&(et=i.R16UI),Y===i.UNSIGNED_INT&&(et=i.R32UI),Y===i.BYTE&&(et=i.R8I),Y===i.SHORT&&(et=i.R16I),Y===i.INT&&(et=i.R32I)),y===i.RG&&(Y===i.FLOAT&&(et=i.RG32F),Y===i.HALF_FLOAT&&(et=i.RG16F),Y===i.UNSIGNED_BYTE&&(et=i.RG8)),y===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.RG8UI),Y===i.UNSIGNED_SHORT&&(et=i.RG16UI),Y===i.UNSIGNED_INT&&(et=i.RG32UI),Y===i.BYTE&&(et=i.RG8I),Y===i.SHORT&&(et=i.RG16I),Y===i.INT&&(et=i.RG32I)),y===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(et=i.RGB16UI),Y===i.UNSIGNED_INT&&(et=i.RGB32UI),Y===i.BYTE&&(et=i.RGB8I),Y===i.SHORT&&(et=i.RGB16I),Y===i.INT&&(et=i.RGB32I)),y===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(et=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(et=i.RGBA16UI),Y===i.UNSIGNED_INT&&(et=i.RGBA32UI),Y===i.BYTE&&(et=i.RGBA8I),Y===i.SHORT&&(et=i.RGBA16I),Y===i.INT&&(et=i.RGBA32I)),y===i.RGB&&Y===i.UNSIGNED_INT_5_9_9_9_REV&&(et=i.RGB9_E5),y===i.RGBA){const St=W?Ka:me.getTransfer(Z);Y===i.FLOAT&&(et=i.RGBA32F),Y===i.HALF_FLOAT&&(et=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(et=St===Ae?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT_4_4_4_4&&(et=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(et=i.RGB5_A1)}return(et===i.R16F||et===i.R32F||et===i.RG16F||et===i.RG32F||et===i.RGBA16F||et===i.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function M(P,y){let Y;return P?y===null||y===zs||y===kr?Y=i.DEPTH24_STENCIL8:y===qi?Y=i.DEPTH32F_STENCIL8:y===So&&(Y=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===zs||y===kr?Y=i.DEPTH_COMPONENT24:y===qi?Y=i.DEPTH_COMPONENT32F:y===So&&(Y=i.DEPTH_COMPONENT16),Y}function O(P,y){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==vi&&P.minFilter!==Pi?Math.log2(Math.max(y.width,y.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?y.mipmaps.length:1}function R(P){const y=P.target;y.removeEventListener("dispose",R),U(y),y.isVideoTexture&&u.delete(y)}function D(P){const y=P.target;y.removeEventListener("dispose",D),S(y)}function U(P){const y=n.get(P);if(y.__webglInit===void 0)return;const Y=P.source,Z=f.get(Y);if(Z){const W=Z[y.__cacheKey];W.usedTimes--,W.usedTimes===0&&w(P),Object.keys(Z).length===0&&f.delete(Y)}n.remove(P)}function w(P){const y=n.get(P);i.deleteTexture(y.__webglTexture);const Y=P.source,Z=f.get(Y);delete Z[y.__cacheKey],o.memory.textures--}function S(P){const y=n.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),n.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(y.__webglFramebuffer[Z]))for(let W=0;W<y.__webglFramebuffer[Z].length;W++)i.deleteFramebuffer(y.__webglFramebuffer[Z][W]);else i.deleteFramebuffer(y.__webglFramebuffer[Z]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[Z])}else{if(Array.isArray(y.__webglFramebuffer))for(let Z=0;Z<y.__webglFramebuffer.length;Z++)i.deleteFramebuffer(y.__webglFramebuffer[Z]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let Z=0;Z<y.__webglColorRenderbuffer.length;Z++)y.__webglColorRenderbuffer[Z]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[Z]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}const Y=P.textures;for(let Z=0,W=Y.length;Z<W;Z++){const et=n.get(Y[Z]);et.__webglTexture&&(i.deleteTexture(et.__webglTexture),o.memory.textures--),n.remove(Y[Z])}n.remove(P)}let C=0;function G(){C=0}function I(){const P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function V(P){const y=[];return y.push(P.wrapS),y.push(P.wrapT),y.push(P.wrapR||0),y.push(P.magFilter),y.push(P.minFilter),y.push(P.anisotropy),y.push(P.internalFormat),y.push(P.format),y.push(P.type),y.push(P.generateMipmaps),y.push(P.premultiplyAlpha),y.push(P.flipY),y.push(P.unpackAlignment),y.push(P.colorSpace),y.join()}function j(P,y){const Y=n.get(P);if(P.isVideoTexture&&Gt(P),P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){const Z=P.image;if(Z===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(Z.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{it(Y,P,y);return}}e.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+y)}function K(P,y){const Y=n.get(P);if(P.version>0&&Y.__version!==P.version){it(Y,P,y);return}e.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+y)}function Q(P,y){const Y=n.get(P);if(P.version>0&&Y.__version!==P.version){it(Y,P,y);return}e.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+y)}function tt(P,y){const Y=n.get(P);if(P.version>0&&Y.__version!==P.version){at(Y,P,y);return}e.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+y)}const ht={[Ac]:i.REPEAT,[Fs]:i.CLAMP_TO_EDGE,[Rc]:i.MIRRORED_REPEAT},ct={[vi]:i.NEAREST,[ov]:i.NEAREST_MIPMAP_NEAREST,[Ho]:i.NEAREST_MIPMAP_LINEAR,[Pi]:i.LINEAR,[Ml]:i.LINEAR_MIPMAP_NEAREST,[Os]:i.LINEAR_MIPMAP_LINEAR},mt={[uv]:i.NEVER,[gv]:i.ALWAYS,[hv]:i.LESS,[zp]:i.LEQUAL,[fv]:i.EQUAL,[mv]:i.GEQUAL,[dv]:i.GREATER,[pv]:i.NOTEQUAL};function Mt(P,y){if(y.type===qi&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Pi||y.magFilter===Ml||y.magFilter===Ho||y.magFilter===Os||y.minFilter===Pi||y.minFilter===Ml||y.minFilter===Ho||y.minFilter===Os)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(P,i.TEXTURE_WRAP_S,ht[y.wrapS]),i.texParameteri(P,i.TEXTURE_WRAP_T,ht[y.wrapT]),(P===i.TEXTURE_3D||P===i.TEXTURE_2D_ARRAY)&&i.texParameteri(P,i.TEXTURE_WRAP_R,ht[y.wrapR]),i.texParameteri(P,i.TEXTURE_MAG_FILTER,ct[y.magFilter]),i.texParameteri(P,i.TEXTURE_MIN_FILTER,ct[y.minFilter]),y.compareFunction&&(i.texParameteri(P,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(P,i.TEXTURE_COMPARE_FUNC,mt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===vi||y.minFilter!==Ho&&y.minFilter!==Os||y.type===qi&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){const Y=t.get("EXT_texture_filter_anisotropic");i.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function pt(P,y){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,y.addEventListener("dispose",R));const Z=y.source;let W=f.get(Z);W===void 0&&(W={},f.set(Z,W));const et=V(y);if(et!==P.__cacheKey){W[et]===void 0&&(W[et]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),W[et].usedTimes++;const St=W[P.__cacheKey];St!==void 0&&(W[P.__cacheKey].usedTimes--,St.usedTimes===0&&w(y)),P.__cacheKey=et,P.__webglTexture=W[et].texture}return Y}function it(P,y,Y){let Z=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(Z=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(Z=i.TEXTURE_3D);const W=pt(P,y),et=y.source;e.bindTexture(Z,P.__webglTexture,i.TEXTURE0+Y);const St=n.get(et);if(et.version!==St.__version||W===!0){e.activeTexture(i.TEXTURE0+Y);const _t=me.getPrimaries(me.workingColorSpace),wt=y.colorSpace===hs?null:me.getPrimaries(y.colorSpace),Kt=y.colorSpace===hs||_t===wt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt);let ft=v(y.image,!1,s.maxTextureSize);ft=fe(y,ft);const vt=r.convert(y.format,y.colorSpace),Nt=r.convert(y.type);let Ot=T(y.internalFormat,vt,Nt,y.colorSpace,y.isVideoTexture);Mt(Z,y);let Et;const ne=y.mipmaps,qt=y.isVideoTexture!==!0,de=St.__version===void 0||W===!0,k=et.dataReady,xt=O(y,ft);if(y.isDepthTexture)Ot=M(y.format===Br,y.type),de&&(qt?e.texStorage2D(i.TEXTURE_2D,1,Ot,ft.width,ft.height):e.texImage2D(i.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,null));else if(y.isDataTexture)if(ne.length>0){qt&&de&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ne[0].width,ne[0].height);for(let nt=0,rt=ne.length;nt<rt;nt++)Et=ne[nt],qt?k&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(i.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,vt,Nt,Et.data);y.generateMipmaps=!1}else qt?(de&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ft.width,ft.height),k&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ft.width,ft.height,vt,Nt,ft.data)):e.texImage2D(i.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,ft.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){qt&&de&&e.texStorage3D(i.TEXTURE_2D_ARRAY,xt,Ot,ne[0].width,ne[0].height,ft.depth);for(let nt=0,rt=ne.length;nt<rt;nt++)if(Et=ne[nt],y.format!==gi)if(vt!==null)if(qt){if(k)if(y.layerUpdates.size>0){const Tt=rd(Et.width,Et.height,y.format,y.type);for(const At of y.layerUpdates){const Zt=Et.data.subarray(At*Tt/Et.data.BYTES_PER_ELEMENT,(At+1)*Tt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,At,Et.width,Et.height,1,vt,Zt)}y.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,Et.width,Et.height,ft.depth,vt,Et.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,Ot,Et.width,Et.height,ft.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else qt?k&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,Et.width,Et.height,ft.depth,vt,Nt,Et.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,Ot,Et.width,Et.height,ft.depth,0,vt,Nt,Et.data)}else{qt&&de&&e.texStorage2D(i.TEXTURE_2D,xt,Ot,ne[0].width,ne[0].height);for(let nt=0,rt=ne.length;nt<rt;nt++)Et=ne[nt],y.format!==gi?vt!==null?qt?k&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Et.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):qt?k&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(i.TEXTURE_2D,nt,Ot,Et.width,Et.height,0,vt,Nt,Et.data)}else if(y.isDataArrayTexture)if(qt){if(de&&e.texStorage3D(i.TEXTURE_2D_ARRAY,xt,Ot,ft.width,ft.height,ft.depth),k)if(y.layerUpdates.size>0){const nt=rd(ft.width,ft.height,y.format,y.type);for(const rt of y.layerUpdates){const Tt=ft.data.subarray(rt*nt/ft.data.BYTES_PER_ELEMENT,(rt+1)*nt/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,rt,ft.width,ft.height,1,vt,Nt,Tt)}y.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(y.isData3DTexture)qt?(de&&e.texStorage3D(i.TEXTURE_3D,xt,Ot,ft.width,ft.height,ft.depth),k&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)):e.texImage3D(i.TEXTURE_3D,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(y.isFramebufferTexture){if(de)if(qt)e.texStorage2D(i.TEXTURE_2D,xt,Ot,ft.width,ft.height);else{let nt=ft.width,rt=ft.height;for(let Tt=0;Tt<xt;Tt++)e.texImage2D(i.TEXTURE_2D,Tt,Ot,nt,rt,0,vt,Nt,null),nt>>=1,rt>>=1}}else if(ne.length>0){if(qt&&de){const nt=Pt(ne[0]);e.texStorage2D(i.TEXTURE_2D,xt,Ot,nt.width,nt.height)}for(let nt=0,rt=ne.length;nt<rt;nt++)Et=ne[nt],qt?k&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,vt,Nt,Et):e.texImage2D(i.TEXTURE_2D,nt,Ot,vt,Nt,Et);y.generateMipmaps=!1}else if(qt){if(de){const nt=Pt(ft);e.texStorage2D(i.TEXTURE_2D,xt,Ot,nt.width,nt.height)}k&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,vt,Nt,ft)}else e.texImage2D(i.TEXTURE_2D,0,Ot,vt,Nt,ft);m(y)&&p(Z),St.__version=et.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function at(P,y,Y){if(y.image.length!==6)return;const Z=pt(P,y),W=y.source;e.bindTexture(i.TEXTURE_CUBE_MAP,P.__webglTexture,i.TEXTURE0+Y);const et=n.get(W);if(W.version!==et.__version||Z===!0){e.activeTexture(i.TEXTURE0+Y);const St=me.getPrimaries(me.workingColorSpace),_t=y.colorSpace===hs?null:me.getPrimaries(y.colorSpace),wt=y.colorSpace===hs||St===_t?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,wt);const Kt=y.isCompressedTexture||y.image[0].isCompressedTexture,ft=y.image[0]&&y.image[0].isDataTexture,vt=[];for(let rt=0;rt<6;rt++)!Kt&&!ft?vt[rt]=v(y.image[rt],!0,s.maxCubemapSize):vt[rt]=ft?y.image[rt].image:y.image[rt],vt[rt]=fe(y,vt[rt]);const Nt=vt[0],Ot=r.convert(y.format,y.colorSpace),Et=r.convert(y.type),ne=T(y.internalFormat,Ot,Et,y.colorSpace),qt=y.isVideoTexture!==!0,de=et.__version===void 0||Z===!0,k=W.dataReady;let xt=O(y,Nt);Mt(i.TEXTURE_CUBE_MAP,y);let nt;if(Kt){qt&&de&&e.texStorage2D(i.TEXTURE_CUBE_MAP,xt,ne,Nt.width,Nt.height);for(let rt=0;rt<6;rt++){nt=vt[rt].mipmaps;for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];y.format!==gi?Ot!==null?qt?k&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,At.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,ne,At.width,At.height,0,At.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,0,0,At.width,At.height,Ot,Et,At.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt,ne,At.width,At.height,0,Ot,Et,At.data)}}}else{if(nt=y.mipmaps,qt&&de){nt.length>0&&xt++;const rt=Pt(vt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,xt,ne,rt.width,rt.height)}for(let rt=0;rt<6;rt++)if(ft){qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,vt[rt].width,vt[rt].height,Ot,Et,vt[rt].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ne,vt[rt].width,vt[rt].height,0,Ot,Et,vt[rt].data);for(let Tt=0;Tt<nt.length;Tt++){const Zt=nt[Tt].image[rt].image;qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Zt.width,Zt.height,Ot,Et,Zt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,ne,Zt.width,Zt.height,0,Ot,Et,Zt.data)}}else{qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,0,0,Ot,Et,vt[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,0,ne,Ot,Et,vt[rt]);for(let Tt=0;Tt<nt.length;Tt++){const At=nt[Tt];qt?k&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,0,0,Ot,Et,At.image[rt]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+rt,Tt+1,ne,Ot,Et,At.image[rt])}}}m(y)&&p(i.TEXTURE_CUBE_MAP),et.__version=W.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function gt(P,y,Y,Z,W,et){const St=r.convert(Y.format,Y.colorSpace),_t=r.convert(Y.type),wt=T(Y.internalFormat,St,_t,Y.colorSpace),Kt=n.get(y),ft=n.get(Y);if(ft.__renderTarget=y,!Kt.__hasExternalTextures){const vt=Math.max(1,y.width>>et),Nt=Math.max(1,y.height>>et);W===i.TEXTURE_3D||W===i.TEXTURE_2D_ARRAY?e.texImage3D(W,et,wt,vt,Nt,y.depth,0,St,_t,null):e.texImage2D(W,et,wt,vt,Nt,0,St,_t,null)}e.bindFramebuffer(i.FRAMEBUFFER,P),te(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Z,W,ft.__webglTexture,0,Jt(y)):(W===i.TEXTURE_2D||W>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,Z,W,ft.__webglTexture,et),e.bindFramebuffer(i.FRAMEBUFFER,null)}function ot(P,y,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,P),y.depthBuffer){const Z=y.depthTexture,W=Z&&Z.isDepthTexture?Z.type:null,et=M(y.stencilBuffer,W),St=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_t=Jt(y);te(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,_t,et,y.width,y.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,_t,et,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,et,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,St,i.RENDERBUFFER,P)}else{const Z=y.textures;for(let W=0;W<Z.length;W++){const et=Z[W],St=r.convert(et.format,et.colorSpace),_t=r.convert(et.type),wt=T(et.internalFormat,St,_t,et.colorSpace),Kt=Jt(y);Y&&te(y)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,Kt,wt,y.width,y.height):te(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Kt,wt,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,wt,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Bt(P,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,P),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const Z=n.get(y.depthTexture);Z.__renderTarget=y,(!Z.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),j(y.depthTexture,0);const W=Z.__webglTexture,et=Jt(y);if(y.depthTexture.format===Ar)te(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,W,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,W,0);else if(y.depthTexture.format===Br)te(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,W,0,et):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,W,0);else throw new Error("Unknown depthTexture format")}function Ht(P){const y=n.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==P.depthTexture){const Z=P.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),Z){const W=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,Z.removeEventListener("dispose",W)};Z.addEventListener("dispose",W),y.__depthDisposeCallback=W}y.__boundDepthTexture=Z}if(P.depthTexture&&!y.__autoAllocateDepthBuffer){if(Y)throw new Error("target.depthTexture not supported in Cube render targets");Bt(y.__webglFramebuffer,P)}else if(Y){y.__webglDepthbuffer=[];for(let Z=0;Z<6;Z++)if(e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[Z]),y.__webglDepthbuffer[Z]===void 0)y.__webglDepthbuffer[Z]=i.createRenderbuffer(),ot(y.__webglDepthbuffer[Z],P,!1);else{const W=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,et=y.__webglDepthbuffer[Z];i.bindRenderbuffer(i.RENDERBUFFER,et),i.framebufferRenderbuffer(i.FRAMEBUFFER,W,i.RENDERBUFFER,et)}}else if(e.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),ot(y.__webglDepthbuffer,P,!1);else{const Z=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,W=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,W),i.framebufferRenderbuffer(i.FRAMEBUFFER,Z,i.RENDERBUFFER,W)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function It(P,y,Y){const Z=n.get(P);y!==void 0&&gt(Z.__webglFramebuffer,P,P.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&Ht(P)}function ce(P){const y=P.texture,Y=n.get(P),Z=n.get(y);P.addEventListener("dispose",D);const W=P.textures,et=P.isWebGLCubeRenderTarget===!0,St=W.length>1;if(St||(Z.__webglTexture===void 0&&(Z.__webglTexture=i.createTexture()),Z.__version=y.version,o.memory.textures++),et){Y.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(y.mipmaps&&y.mipmaps.length>0){Y.__webglFramebuffer[_t]=[];for(let wt=0;wt<y.mipmaps.length;wt++)Y.__webglFramebuffer[_t][wt]=i.createFramebuffer()}else Y.__webglFramebuffer[_t]=i.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){Y.__webglFramebuffer=[];for(let _t=0;_t<y.mipmaps.length;_t++)Y.__webglFramebuffer[_t]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(St)for(let _t=0,wt=W.length;_t<wt;_t++){const Kt=n.get(W[_t]);Kt.__webglTexture===void 0&&(Kt.__webglTexture=i.createTexture(),o.memory.textures++)}if(P.samples>0&&te(P)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let _t=0;_t<W.length;_t++){const wt=W[_t];Y.__webglColorRenderbuffer[_t]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[_t]);const Kt=r.convert(wt.format,wt.colorSpace),ft=r.convert(wt.type),vt=T(wt.internalFormat,Kt,ft,wt.colorSpace,P.isXRRenderTarget===!0),Nt=Jt(P);i.renderbufferStorageMultisample(i.RENDERBUFFER,Nt,vt,P.width,P.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_t,i.RENDERBUFFER,Y.__webglColorRenderbuffer[_t])}i.bindRenderbuffer(i.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),ot(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(et){e.bindTexture(i.TEXTURE_CUBE_MAP,Z.__webglTexture),Mt(i.TEXTURE_CUBE_MAP,y);for(let _t=0;_t<6;_t++)if(y.mipmaps&&y.mipmaps.length>0)for(let wt=0;wt<y.mipmaps.length;wt++)gt(Y.__webglFramebuffer[_t][wt],P,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,wt);else gt(Y.__webglFramebuffer[_t],P,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);m(y)&&p(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let _t=0,wt=W.length;_t<wt;_t++){const Kt=W[_t],ft=n.get(Kt);e.bindTexture(i.TEXTURE_2D,ft.__webglTexture),Mt(i.TEXTURE_2D,Kt),gt(Y.__webglFramebuffer,P,Kt,i.COLOR_ATTACHMENT0+_t,i.TEXTURE_2D,0),m(Kt)&&p(i.TEXTURE_2D)}e.unbindTexture()}else{let _t=i.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(_t,Z.__webglTexture),Mt(_t,y),y.mipmaps&&y.mipmaps.length>0)for(let wt=0;wt<y.mipmaps.length;wt++)gt(Y.__webglFramebuffer[wt],P,y,i.COLOR_ATTACHMENT0,_t,wt);else gt(Y.__webglFramebuffer,P,y,i.COLOR_ATTACHMENT0,_t,0);m(y)&&p(_t),e.unbindTexture()}P.depthBuffer&&Ht(P)}function jt(P){const y=P.textures;for(let Y=0,Z=y.length;Y<Z;Y++){const W=y[Y];if(m(W)){const et=E(P),St=n.get(W).__webglTexture;e.bindTexture(et,St),p(et),e.unbindTexture()}}}const ue=[],B=[];function Ze(P){if(P.samples>0){if(te(P)===!1){const y=P.textures,Y=P.width,Z=P.height;let W=i.COLOR_BUFFER_BIT;const et=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,St=n.get(P),_t=y.length>1;if(_t)for(let wt=0;wt<y.length;wt++)e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+wt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+wt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let wt=0;wt<y.length;wt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(W|=i.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(W|=i.STENCIL_BUFFER_BIT)),_t){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const Kt=n.get(y[wt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,Kt,0)}i.blitFramebuffer(0,0,Y,Z,0,0,Y,Z,W,i.NEAREST),l===!0&&(ue.length=0,B.length=0,ue.push(i.COLOR_ATTACHMENT0+wt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(ue.push(et),B.push(et),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,B)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,ue))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),_t)for(let wt=0;wt<y.length;wt++){e.bindFramebuffer(i.FRAMEBUFFER,St.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+wt,i.RENDERBUFFER,St.__webglColorRenderbuffer[wt]);const Kt=n.get(y[wt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,St.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+wt,i.TEXTURE_2D,Kt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){const y=P.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function Jt(P){return Math.min(s.maxSamples,P.samples)}function te(P){const y=n.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Gt(P){const y=o.render.frame;u.get(P)!==y&&(u.set(P,y),P.update())}function fe(P,y){const Y=P.colorSpace,Z=P.format,W=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==Xs&&Y!==hs&&(me.getTransfer(Y)===Ae?(Z!==gi||W!==Ji)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Y)),y}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=I,this.resetTextureUnits=G,this.setTexture2D=j,this.setTexture2DArray=K,this.setTexture3D=Q,this.setTextureCube=tt,this.rebindTextures=It,this.setupRenderTarget=ce,this.updateRenderTargetMipmap=jt,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Ht,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=te}function ME(i,t){function e(n,s=hs){let r;const o=me.getTransfer(s);if(n===Ji)return i.UNSIGNED_BYTE;if(n===Nu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Fu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Lp)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Cp)return i.BYTE;if(n===Pp)return i.SHORT;if(n===So)return i.UNSIGNED_SHORT;if(n===Iu)return i.INT;if(n===zs)return i.UNSIGNED_INT;if(n===qi)return i.FLOAT;if(n===wo)return i.HALF_FLOAT;if(n===Dp)return i.ALPHA;if(n===Up)return i.RGB;if(n===gi)return i.RGBA;if(n===Ip)return i.LUMINANCE;if(n===Np)return i.LUMINANCE_ALPHA;if(n===Ar)return i.DEPTH_COMPONENT;if(n===Br)return i.DEPTH_STENCIL;if(n===Fp)return i.RED;if(n===Ou)return i.RED_INTEGER;if(n===Op)return i.RG;if(n===ku)return i.RG_INTEGER;if(n===Bu)return i.RGBA_INTEGER;if(n===xa||n===Ma||n===Sa||n===ya)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===xa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ma)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===xa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ma)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Sa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ya)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Cc||n===Pc||n===Lc||n===Dc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Cc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Pc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Lc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Dc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Uc||n===Ic||n===Nc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Uc||n===Ic)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Fc||n===Oc||n===kc||n===Bc||n===zc||n===Hc||n===Gc||n===Vc||n===Wc||n===Xc||n===$c||n===qc||n===Yc||n===Kc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Fc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Oc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===kc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===zc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Hc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Gc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Vc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Wc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Xc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===$c)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===qc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Yc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Kc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ea||n===jc||n===Zc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Ea)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===jc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Zc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===kp||n===Jc||n===Qc||n===tu)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Ea)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Jc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Qc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===tu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===kr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}class SE extends $n{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class Li extends en{constructor(){super(),this.isGroup=!0,this.type="Group"}}const yE={type:"move"};class Yl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Li,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Li,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Li,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,n),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(yE)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new Li;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const EE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,bE=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class wE{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,n){if(this.texture===null){const s=new On,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=n.depthNear||e.depthFar!=n.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new gs({vertexShader:EE,fragmentShader:bE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Sn(new ja(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class TE extends Wr{constructor(t,e){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null;const v=new wE,m=e.getContextAttributes();let p=null,E=null;const T=[],M=[],O=new ae;let R=null;const D=new $n;D.viewport=new Ge;const U=new $n;U.viewport=new Ge;const w=[D,U],S=new SE;let C=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(it){let at=T[it];return at===void 0&&(at=new Yl,T[it]=at),at.getTargetRaySpace()},this.getControllerGrip=function(it){let at=T[it];return at===void 0&&(at=new Yl,T[it]=at),at.getGripSpace()},this.getHand=function(it){let at=T[it];return at===void 0&&(at=new Yl,T[it]=at),at.getHandSpace()};function I(it){const at=M.indexOf(it.inputSource);if(at===-1)return;const gt=T[at];gt!==void 0&&(gt.update(it.inputSource,it.frame,c||o),gt.dispatchEvent({type:it.type,data:it.inputSource}))}function V(){s.removeEventListener("select",I),s.removeEventListener("selectstart",I),s.removeEventListener("selectend",I),s.removeEventListener("squeeze",I),s.removeEventListener("squeezestart",I),s.removeEventListener("squeezeend",I),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",j);for(let it=0;it<T.length;it++){const at=M[it];at!==null&&(M[it]=null,T[it].disconnect(at))}C=null,G=null,v.reset(),t.setRenderTarget(p),d=null,f=null,h=null,s=null,E=null,pt.stop(),n.isPresenting=!1,t.setPixelRatio(R),t.setSize(O.width,O.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(it){r=it,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(it){a=it,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(it){c=it},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(it){if(s=it,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",I),s.addEventListener("selectstart",I),s.addEventListener("selectend",I),s.addEventListener("squeeze",I),s.addEventListener("squeezestart",I),s.addEventListener("squeezeend",I),s.addEventListener("end",V),s.addEventListener("inputsourceschange",j),m.xrCompatible!==!0&&await e.makeXRCompatible(),R=t.getPixelRatio(),t.getSize(O),s.renderState.layers===void 0){const at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),E=new Hs(d.framebufferWidth,d.framebufferHeight,{format:gi,type:Ji,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,gt=null,ot=null;m.depth&&(ot=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?Br:Ar,gt=m.stencil?kr:zs);const Bt={colorFormat:e.RGBA8,depthFormat:ot,scaleFactor:r};h=new XRWebGLBinding(s,e),f=h.createProjectionLayer(Bt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),E=new Hs(f.textureWidth,f.textureHeight,{format:gi,type:Ji,depthTexture:new Jp(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}E.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function j(it){for(let at=0;at<it.removed.length;at++){const gt=it.removed[at],ot=M.indexOf(gt);ot>=0&&(M[ot]=null,T[ot].disconnect(gt))}for(let at=0;at<it.added.length;at++){const gt=it.added[at];let ot=M.indexOf(gt);if(ot===-1){for(let Ht=0;Ht<T.length;Ht++)if(Ht>=M.length){M.push(gt),ot=Ht;break}else if(M[Ht]===null){M[Ht]=gt,ot=Ht;break}if(ot===-1)break}const Bt=T[ot];Bt&&Bt.connect(gt)}}const K=new z,Q=new z;function tt(it,at,gt){K.setFromMatrixPosition(at.matrixWorld),Q.setFromMatrixPosition(gt.matrixWorld);const ot=K.distanceTo(Q),Bt=at.projectionMatrix.elements,Ht=gt.projectionMatrix.elements,It=Bt[14]/(Bt[10]-1),ce=Bt[14]/(Bt[10]+1),jt=(Bt[9]+1)/Bt[5],ue=(Bt[9]-1)/Bt[5],B=(Bt[8]-1)/Bt[0],Ze=(Ht[8]+1)/Ht[0],Jt=It*B,te=It*Ze,Gt=ot/(-B+Ze),fe=Gt*-B;if(at.matrixWorld.decompose(it.position,it.quaternion,it.scale),it.translateX(fe),it.translateZ(Gt),it.matrixWorld.compose(it.position,it.quaternion,it.scale),it.matrixWorldInverse.copy(it.matrixWorld).invert(),Bt[10]===-1)it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Pt=It+Gt,P=ce+Gt,y=Jt-fe,Y=te+(ot-fe),Z=jt*ce/P*Pt,W=ue*ce/P*Pt;it.projectionMatrix.makePerspective(y,Y,Z,W,Pt,P),it.projectionMatrixInverse.copy(it.projectionMatrix).invert()}}function ht(it,at){at===null?it.matrixWorld.copy(it.matrix):it.matrixWorld.multiplyMatrices(at.matrixWorld,it.matrix),it.matrixWorldInverse.copy(it.matrixWorld).invert()}this.updateCamera=function(it){if(s===null)return;let at=it.near,gt=it.far;v.texture!==null&&(v.depthNear>0&&(at=v.depthNear),v.depthFar>0&&(gt=v.depthFar)),S.near=U.near=D.near=at,S.far=U.far=D.far=gt,(C!==S.near||G!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,G=S.far),D.layers.mask=it.layers.mask|2,U.layers.mask=it.layers.mask|4,S.layers.mask=D.layers.mask|U.layers.mask;const ot=it.parent,Bt=S.cameras;ht(S,ot);for(let Ht=0;Ht<Bt.length;Ht++)ht(Bt[Ht],ot);Bt.length===2?tt(S,D,U):S.projectionMatrix.copy(D.projectionMatrix),ct(it,S,ot)};function ct(it,at,gt){gt===null?it.matrix.copy(at.matrixWorld):(it.matrix.copy(gt.matrixWorld),it.matrix.invert(),it.matrix.multiply(at.matrixWorld)),it.matrix.decompose(it.position,it.quaternion,it.scale),it.updateMatrixWorld(!0),it.projectionMatrix.copy(at.projectionMatrix),it.projectionMatrixInverse.copy(at.projectionMatrixInverse),it.isPerspectiveCamera&&(it.fov=eu*2*Math.atan(1/it.projectionMatrix.elements[5]),it.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(it){l=it,f!==null&&(f.fixedFoveation=it),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=it)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let mt=null;function Mt(it,at){if(u=at.getViewerPose(c||o),g=at,u!==null){const gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(E,d.framebuffer),t.setRenderTarget(E));let ot=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,ot=!0);for(let Ht=0;Ht<gt.length;Ht++){const It=gt[Ht];let ce=null;if(d!==null)ce=d.getViewport(It);else{const ue=h.getViewSubImage(f,It);ce=ue.viewport,Ht===0&&(t.setRenderTargetTextures(E,ue.colorTexture,f.ignoreDepthValues?void 0:ue.depthStencilTexture),t.setRenderTarget(E))}let jt=w[Ht];jt===void 0&&(jt=new $n,jt.layers.enable(Ht),jt.viewport=new Ge,w[Ht]=jt),jt.matrix.fromArray(It.transform.matrix),jt.matrix.decompose(jt.position,jt.quaternion,jt.scale),jt.projectionMatrix.fromArray(It.projectionMatrix),jt.projectionMatrixInverse.copy(jt.projectionMatrix).invert(),jt.viewport.set(ce.x,ce.y,ce.width,ce.height),Ht===0&&(S.matrix.copy(jt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),ot===!0&&S.cameras.push(jt)}const Bt=s.enabledFeatures;if(Bt&&Bt.includes("depth-sensing")){const Ht=h.getDepthInformation(gt[0]);Ht&&Ht.isValid&&Ht.texture&&v.init(t,Ht,s.renderState)}}for(let gt=0;gt<T.length;gt++){const ot=M[gt],Bt=T[gt];ot!==null&&Bt!==void 0&&Bt.update(ot,at,c||o)}mt&&mt(it,at),at.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:at}),g=null}const pt=new Zp;pt.setAnimationLoop(Mt),this.setAnimationLoop=function(it){mt=it},this.dispose=function(){}}}const Rs=new Fi,AE=new Ue;function RE(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Yp(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,E,T,M){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,M)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,E,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Fn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Fn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const E=t.get(p),T=E.envMap,M=E.envMapRotation;T&&(m.envMap.value=T,Rs.copy(M),Rs.x*=-1,Rs.y*=-1,Rs.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(Rs.y*=-1,Rs.z*=-1),m.envMapRotation.value.setFromMatrix4(AE.makeRotationFromEuler(Rs)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,E,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*E,m.scale.value=T*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,E){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Fn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=E.texture,m.transmissionSamplerSize.value.set(E.width,E.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const E=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(E.matrixWorld),m.nearDistance.value=E.shadow.camera.near,m.farDistance.value=E.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function CE(i,t,e,n){let s={},r={},o=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(E,T){const M=T.program;n.uniformBlockBinding(E,M)}function c(E,T){let M=s[E.id];M===void 0&&(g(E),M=u(E),s[E.id]=M,E.addEventListener("dispose",m));const O=T.program;n.updateUBOMapping(E,O);const R=t.render.frame;r[E.id]!==R&&(f(E),r[E.id]=R)}function u(E){const T=h();E.__bindingPointIndex=T;const M=i.createBuffer(),O=E.__size,R=E.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,O,R),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,T,M),M}function h(){for(let E=0;E<a;E++)if(o.indexOf(E)===-1)return o.push(E),E;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(E){const T=s[E.id],M=E.uniforms,O=E.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let R=0,D=M.length;R<D;R++){const U=Array.isArray(M[R])?M[R]:[M[R]];for(let w=0,S=U.length;w<S;w++){const C=U[w];if(d(C,R,w,O)===!0){const G=C.__offset,I=Array.isArray(C.value)?C.value:[C.value];let V=0;for(let j=0;j<I.length;j++){const K=I[j],Q=v(K);typeof K=="number"||typeof K=="boolean"?(C.__data[0]=K,i.bufferSubData(i.UNIFORM_BUFFER,G+V,C.__data)):K.isMatrix3?(C.__data[0]=K.elements[0],C.__data[1]=K.elements[1],C.__data[2]=K.elements[2],C.__data[3]=0,C.__data[4]=K.elements[3],C.__data[5]=K.elements[4],C.__data[6]=K.elements[5],C.__data[7]=0,C.__data[8]=K.elements[6],C.__data[9]=K.elements[7],C.__data[10]=K.elements[8],C.__data[11]=0):(K.toArray(C.__data,V),V+=Q.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,G,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(E,T,M,O){const R=E.value,D=T+"_"+M;if(O[D]===void 0)return typeof R=="number"||typeof R=="boolean"?O[D]=R:O[D]=R.clone(),!0;{const U=O[D];if(typeof R=="number"||typeof R=="boolean"){if(U!==R)return O[D]=R,!0}else if(U.equals(R)===!1)return U.copy(R),!0}return!1}function g(E){const T=E.uniforms;let M=0;const O=16;for(let D=0,U=T.length;D<U;D++){const w=Array.isArray(T[D])?T[D]:[T[D]];for(let S=0,C=w.length;S<C;S++){const G=w[S],I=Array.isArray(G.value)?G.value:[G.value];for(let V=0,j=I.length;V<j;V++){const K=I[V],Q=v(K),tt=M%O,ht=tt%Q.boundary,ct=tt+ht;M+=ht,ct!==0&&O-ct<Q.storage&&(M+=O-ct),G.__data=new Float32Array(Q.storage/Float32Array.BYTES_PER_ELEMENT),G.__offset=M,M+=Q.storage}}}const R=M%O;return R>0&&(M+=O-R),E.__size=M,E.__cache={},this}function v(E){const T={boundary:0,storage:0};return typeof E=="number"||typeof E=="boolean"?(T.boundary=4,T.storage=4):E.isVector2?(T.boundary=8,T.storage=8):E.isVector3||E.isColor?(T.boundary=16,T.storage=12):E.isVector4?(T.boundary=16,T.storage=16):E.isMatrix3?(T.boundary=48,T.storage=48):E.isMatrix4?(T.boundary=64,T.storage=64):E.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",E),T}function m(E){const T=E.target;T.removeEventListener("dispose",m);const M=o.indexOf(T.__bindingPointIndex);o.splice(M,1),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(const E in s)i.deleteBuffer(s[E]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class PE{constructor(t={}){const{canvas:e=vv(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=n.getContextAttributes().alpha}else d=o;const g=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const E=[],T=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=ni,this.toneMapping=ds,this.toneMappingExposure=1;const M=this;let O=!1,R=0,D=0,U=null,w=-1,S=null;const C=new Ge,G=new Ge;let I=null;const V=new oe(0);let j=0,K=e.width,Q=e.height,tt=1,ht=null,ct=null;const mt=new Ge(0,0,K,Q),Mt=new Ge(0,0,K,Q);let pt=!1;const it=new Hu;let at=!1,gt=!1;const ot=new Ue,Bt=new Ue,Ht=new z,It=new Ge,ce={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let jt=!1;function ue(){return U===null?tt:1}let B=n;function Ze(b,F){return e.getContext(b,F)}try{const b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${Du}`),e.addEventListener("webglcontextlost",rt,!1),e.addEventListener("webglcontextrestored",Tt,!1),e.addEventListener("webglcontextcreationerror",At,!1),B===null){const F="webgl2";if(B=Ze(F,b),B===null)throw Ze(F)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(b){throw console.error("THREE.WebGLRenderer: "+b.message),b}let Jt,te,Gt,fe,Pt,P,y,Y,Z,W,et,St,_t,wt,Kt,ft,vt,Nt,Ot,Et,ne,qt,de,k;function xt(){Jt=new NS(B),Jt.init(),qt=new ME(B,Jt),te=new CS(B,Jt,t,qt),Gt=new _E(B,Jt),te.reverseDepthBuffer&&f&&Gt.buffers.depth.setReversed(!0),fe=new kS(B),Pt=new nE,P=new xE(B,Jt,Gt,Pt,te,qt,fe),y=new LS(M),Y=new IS(M),Z=new Xv(B),de=new AS(B,Z),W=new FS(B,Z,fe,de),et=new zS(B,W,Z,fe),Ot=new BS(B,te,P),ft=new PS(Pt),St=new eE(M,y,Y,Jt,te,de,ft),_t=new RE(M,Pt),wt=new sE,Kt=new uE(Jt),Nt=new TS(M,y,Y,Gt,et,d,l),vt=new mE(M,et,te),k=new CE(B,fe,te,Gt),Et=new RS(B,Jt,fe),ne=new OS(B,Jt,fe),fe.programs=St.programs,M.capabilities=te,M.extensions=Jt,M.properties=Pt,M.renderLists=wt,M.shadowMap=vt,M.state=Gt,M.info=fe}xt();const nt=new TE(M,B);this.xr=nt,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){const b=Jt.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=Jt.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return tt},this.setPixelRatio=function(b){b!==void 0&&(tt=b,this.setSize(K,Q,!1))},this.getSize=function(b){return b.set(K,Q)},this.setSize=function(b,F,X=!0){if(nt.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=b,Q=F,e.width=Math.floor(b*tt),e.height=Math.floor(F*tt),X===!0&&(e.style.width=b+"px",e.style.height=F+"px"),this.setViewport(0,0,b,F)},this.getDrawingBufferSize=function(b){return b.set(K*tt,Q*tt).floor()},this.setDrawingBufferSize=function(b,F,X){K=b,Q=F,tt=X,e.width=Math.floor(b*X),e.height=Math.floor(F*X),this.setViewport(0,0,b,F)},this.getCurrentViewport=function(b){return b.copy(C)},this.getViewport=function(b){return b.copy(mt)},this.setViewport=function(b,F,X,$){b.isVector4?mt.set(b.x,b.y,b.z,b.w):mt.set(b,F,X,$),Gt.viewport(C.copy(mt).multiplyScalar(tt).round())},this.getScissor=function(b){return b.copy(Mt)},this.setScissor=function(b,F,X,$){b.isVector4?Mt.set(b.x,b.y,b.z,b.w):Mt.set(b,F,X,$),Gt.scissor(G.copy(Mt).multiplyScalar(tt).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(b){Gt.setScissorTest(pt=b)},this.setOpaqueSort=function(b){ht=b},this.setTransparentSort=function(b){ct=b},this.getClearColor=function(b){return b.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(b=!0,F=!0,X=!0){let $=0;if(b){let H=!1;if(U!==null){const ut=U.texture.format;H=ut===Bu||ut===ku||ut===Ou}if(H){const ut=U.texture.type,yt=ut===Ji||ut===zs||ut===So||ut===kr||ut===Nu||ut===Fu,Ft=Nt.getClearColor(),Dt=Nt.getClearAlpha(),Vt=Ft.r,Xt=Ft.g,Ut=Ft.b;yt?(g[0]=Vt,g[1]=Xt,g[2]=Ut,g[3]=Dt,B.clearBufferuiv(B.COLOR,0,g)):(v[0]=Vt,v[1]=Xt,v[2]=Ut,v[3]=Dt,B.clearBufferiv(B.COLOR,0,v))}else $|=B.COLOR_BUFFER_BIT}F&&($|=B.DEPTH_BUFFER_BIT),X&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",rt,!1),e.removeEventListener("webglcontextrestored",Tt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),wt.dispose(),Kt.dispose(),Pt.dispose(),y.dispose(),Y.dispose(),et.dispose(),de.dispose(),k.dispose(),St.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Bn),nt.removeEventListener("sessionend",Oi),Ln.stop()};function rt(b){b.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),O=!0}function Tt(){console.log("THREE.WebGLRenderer: Context Restored."),O=!1;const b=fe.autoReset,F=vt.enabled,X=vt.autoUpdate,$=vt.needsUpdate,H=vt.type;xt(),fe.autoReset=b,vt.enabled=F,vt.autoUpdate=X,vt.needsUpdate=$,vt.type=H}function At(b){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function Zt(b){const F=b.target;F.removeEventListener("dispose",Zt),Be(F)}function Be(b){an(b),Pt.remove(b)}function an(b){const F=Pt.get(b).programs;F!==void 0&&(F.forEach(function(X){St.releaseProgram(X)}),b.isShaderMaterial&&St.releaseShaderCache(b))}this.renderBufferDirect=function(b,F,X,$,H,ut){F===null&&(F=ce);const yt=H.isMesh&&H.matrixWorld.determinant()<0,Ft=tl(b,F,X,$,H);Gt.setMaterial($,yt);let Dt=X.index,Vt=1;if($.wireframe===!0){if(Dt=W.getWireframeAttribute(X),Dt===void 0)return;Vt=2}const Xt=X.drawRange,Ut=X.attributes.position;let se=Xt.start*Vt,Se=(Xt.start+Xt.count)*Vt;ut!==null&&(se=Math.max(se,ut.start*Vt),Se=Math.min(Se,(ut.start+ut.count)*Vt)),Dt!==null?(se=Math.max(se,0),Se=Math.min(Se,Dt.count)):Ut!=null&&(se=Math.max(se,0),Se=Math.min(Se,Ut.count));const we=Se-se;if(we<0||we===1/0)return;de.setup(H,$,Ft,X,Dt);let ln,he=Et;if(Dt!==null&&(ln=Z.get(Dt),he=ne,he.setIndex(ln)),H.isMesh)$.wireframe===!0?(Gt.setLineWidth($.wireframeLinewidth*ue()),he.setMode(B.LINES)):he.setMode(B.TRIANGLES);else if(H.isLine){let kt=$.linewidth;kt===void 0&&(kt=1),Gt.setLineWidth(kt*ue()),H.isLineSegments?he.setMode(B.LINES):H.isLineLoop?he.setMode(B.LINE_LOOP):he.setMode(B.LINE_STRIP)}else H.isPoints?he.setMode(B.POINTS):H.isSprite&&he.setMode(B.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)he.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(Jt.get("WEBGL_multi_draw"))he.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const kt=H._multiDrawStarts,ze=H._multiDrawCounts,pe=H._multiDrawCount,Dn=Dt?Z.get(Dt).bytesPerElement:1,Mi=Pt.get($).currentProgram.getUniforms();for(let _n=0;_n<pe;_n++)Mi.setValue(B,"_gl_DrawID",_n),he.render(kt[_n]/Dn,ze[_n])}else if(H.isInstancedMesh)he.renderInstances(se,we,H.count);else if(X.isInstancedBufferGeometry){const kt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,ze=Math.min(X.instanceCount,kt);he.renderInstances(se,we,ze)}else he.render(se,we)};function ve(b,F,X){b.transparent===!0&&b.side===Ri&&b.forceSinglePass===!1?(b.side=Fn,b.needsUpdate=!0,Ys(b,F,X),b.side=ms,b.needsUpdate=!0,Ys(b,F,X),b.side=Ri):Ys(b,F,X)}this.compile=function(b,F,X=null){X===null&&(X=b),p=Kt.get(X),p.init(F),T.push(p),X.traverseVisible(function(H){H.isLight&&H.layers.test(F.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),b!==X&&b.traverseVisible(function(H){H.isLight&&H.layers.test(F.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),p.setupLights();const $=new Set;return b.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const ut=H.material;if(ut)if(Array.isArray(ut))for(let yt=0;yt<ut.length;yt++){const Ft=ut[yt];ve(Ft,X,H),$.add(Ft)}else ve(ut,X,H),$.add(ut)}),T.pop(),p=null,$},this.compileAsync=function(b,F,X=null){const $=this.compile(b,F,X);return new Promise(H=>{function ut(){if($.forEach(function(yt){Pt.get(yt).currentProgram.isReady()&&$.delete(yt)}),$.size===0){H(b);return}setTimeout(ut,10)}Jt.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let Je=null;function Le(b){Je&&Je(b)}function Bn(){Ln.stop()}function Oi(){Ln.start()}const Ln=new Zp;Ln.setAnimationLoop(Le),typeof self<"u"&&Ln.setContext(self),this.setAnimationLoop=function(b){Je=b,nt.setAnimationLoop(b),b===null?Ln.stop():Ln.start()},nt.addEventListener("sessionstart",Bn),nt.addEventListener("sessionend",Oi),this.render=function(b,F){if(F!==void 0&&F.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(O===!0)return;if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),F.parent===null&&F.matrixWorldAutoUpdate===!0&&F.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(F),F=nt.getCamera()),b.isScene===!0&&b.onBeforeRender(M,b,F,U),p=Kt.get(b,T.length),p.init(F),T.push(p),Bt.multiplyMatrices(F.projectionMatrix,F.matrixWorldInverse),it.setFromProjectionMatrix(Bt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),m=wt.get(b,E.length),m.init(),E.push(m),nt.enabled===!0&&nt.isPresenting===!0){const ut=M.xr.getDepthSensingMesh();ut!==null&&gn(ut,F,-1/0,M.sortObjects)}gn(b,F,0,M.sortObjects),m.finish(),M.sortObjects===!0&&m.sort(ht,ct),jt=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,jt&&Nt.addToRenderList(m,b),this.info.render.frame++,at===!0&&ft.beginShadows();const X=p.state.shadowsArray;vt.render(X,b,F),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const $=m.opaque,H=m.transmissive;if(p.setupLights(),F.isArrayCamera){const ut=F.cameras;if(H.length>0)for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Bi($,H,b,Dt)}jt&&Nt.render(b);for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];ki(m,b,Dt,Dt.viewport)}}else H.length>0&&Bi($,H,b,F),jt&&Nt.render(b),ki(m,b,F);U!==null&&(P.updateMultisampleRenderTarget(U),P.updateRenderTargetMipmap(U)),b.isScene===!0&&b.onAfterRender(M,b,F),de.resetDefaultState(),w=-1,S=null,T.pop(),T.length>0?(p=T[T.length-1],at===!0&&ft.setGlobalState(M.clippingPlanes,p.state.camera)):p=null,E.pop(),E.length>0?m=E[E.length-1]:m=null};function gn(b,F,X,$){if(b.visible===!1)return;if(b.layers.test(F.layers)){if(b.isGroup)X=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(F);else if(b.isLight)p.pushLight(b),b.castShadow&&p.pushShadow(b);else if(b.isSprite){if(!b.frustumCulled||it.intersectsSprite(b)){$&&It.setFromMatrixPosition(b.matrixWorld).applyMatrix4(Bt);const yt=et.update(b),Ft=b.material;Ft.visible&&m.push(b,yt,Ft,X,It.z,null)}}else if((b.isMesh||b.isLine||b.isPoints)&&(!b.frustumCulled||it.intersectsObject(b))){const yt=et.update(b),Ft=b.material;if($&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),It.copy(b.boundingSphere.center)):(yt.boundingSphere===null&&yt.computeBoundingSphere(),It.copy(yt.boundingSphere.center)),It.applyMatrix4(b.matrixWorld).applyMatrix4(Bt)),Array.isArray(Ft)){const Dt=yt.groups;for(let Vt=0,Xt=Dt.length;Vt<Xt;Vt++){const Ut=Dt[Vt],se=Ft[Ut.materialIndex];se&&se.visible&&m.push(b,yt,se,X,It.z,Ut)}}else Ft.visible&&m.push(b,yt,Ft,X,It.z,null)}}const ut=b.children;for(let yt=0,Ft=ut.length;yt<Ft;yt++)gn(ut[yt],F,X,$)}function ki(b,F,X,$){const H=b.opaque,ut=b.transmissive,yt=b.transparent;p.setupLightsView(X),at===!0&&ft.setGlobalState(M.clippingPlanes,X),$&&Gt.viewport(C.copy($)),H.length>0&&_s(H,F,X),ut.length>0&&_s(ut,F,X),yt.length>0&&_s(yt,F,X),Gt.buffers.depth.setTest(!0),Gt.buffers.depth.setMask(!0),Gt.buffers.color.setMask(!0),Gt.setPolygonOffset(!1)}function Bi(b,F,X,$){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[$.id]===void 0&&(p.state.transmissionRenderTarget[$.id]=new Hs(1,1,{generateMipmaps:!0,type:Jt.has("EXT_color_buffer_half_float")||Jt.has("EXT_color_buffer_float")?wo:Ji,minFilter:Os,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:me.workingColorSpace}));const ut=p.state.transmissionRenderTarget[$.id],yt=$.viewport||C;ut.setSize(yt.z,yt.w);const Ft=M.getRenderTarget();M.setRenderTarget(ut),M.getClearColor(V),j=M.getClearAlpha(),j<1&&M.setClearColor(16777215,.5),M.clear(),jt&&Nt.render(X);const Dt=M.toneMapping;M.toneMapping=ds;const Vt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),p.setupLightsView($),at===!0&&ft.setGlobalState(M.clippingPlanes,$),_s(b,X,$),P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut),Jt.has("WEBGL_multisampled_render_to_texture")===!1){let Xt=!1;for(let Ut=0,se=F.length;Ut<se;Ut++){const Se=F[Ut],we=Se.object,ln=Se.geometry,he=Se.material,kt=Se.group;if(he.side===Ri&&we.layers.test($.layers)){const ze=he.side;he.side=Fn,he.needsUpdate=!0,jr(we,X,$,ln,he,kt),he.side=ze,he.needsUpdate=!0,Xt=!0}}Xt===!0&&(P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut))}M.setRenderTarget(Ft),M.setClearColor(V,j),Vt!==void 0&&($.viewport=Vt),M.toneMapping=Dt}function _s(b,F,X){const $=F.isScene===!0?F.overrideMaterial:null;for(let H=0,ut=b.length;H<ut;H++){const yt=b[H],Ft=yt.object,Dt=yt.geometry,Vt=$===null?yt.material:$,Xt=yt.group;Ft.layers.test(X.layers)&&jr(Ft,F,X,Dt,Vt,Xt)}}function jr(b,F,X,$,H,ut){b.onBeforeRender(M,F,X,$,H,ut),b.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),H.onBeforeRender(M,F,X,$,b,ut),H.transparent===!0&&H.side===Ri&&H.forceSinglePass===!1?(H.side=Fn,H.needsUpdate=!0,M.renderBufferDirect(X,F,$,H,b,ut),H.side=ms,H.needsUpdate=!0,M.renderBufferDirect(X,F,$,H,b,ut),H.side=Ri):M.renderBufferDirect(X,F,$,H,b,ut),b.onAfterRender(M,F,X,$,H,ut)}function Ys(b,F,X){F.isScene!==!0&&(F=ce);const $=Pt.get(b),H=p.state.lights,ut=p.state.shadowsArray,yt=H.state.version,Ft=St.getParameters(b,H.state,ut,F,X),Dt=St.getProgramCacheKey(Ft);let Vt=$.programs;$.environment=b.isMeshStandardMaterial?F.environment:null,$.fog=F.fog,$.envMap=(b.isMeshStandardMaterial?Y:y).get(b.envMap||$.environment),$.envMapRotation=$.environment!==null&&b.envMap===null?F.environmentRotation:b.envMapRotation,Vt===void 0&&(b.addEventListener("dispose",Zt),Vt=new Map,$.programs=Vt);let Xt=Vt.get(Dt);if(Xt!==void 0){if($.currentProgram===Xt&&$.lightsStateVersion===yt)return xi(b,Ft),Xt}else Ft.uniforms=St.getUniforms(b),b.onBeforeCompile(Ft,M),Xt=St.acquireProgram(Ft,Dt),Vt.set(Dt,Xt),$.uniforms=Ft.uniforms;const Ut=$.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(Ut.clippingPlanes=ft.uniform),xi(b,Ft),$.needsLights=Po(b),$.lightsStateVersion=yt,$.needsLights&&(Ut.ambientLightColor.value=H.state.ambient,Ut.lightProbe.value=H.state.probe,Ut.directionalLights.value=H.state.directional,Ut.directionalLightShadows.value=H.state.directionalShadow,Ut.spotLights.value=H.state.spot,Ut.spotLightShadows.value=H.state.spotShadow,Ut.rectAreaLights.value=H.state.rectArea,Ut.ltc_1.value=H.state.rectAreaLTC1,Ut.ltc_2.value=H.state.rectAreaLTC2,Ut.pointLights.value=H.state.point,Ut.pointLightShadows.value=H.state.pointShadow,Ut.hemisphereLights.value=H.state.hemi,Ut.directionalShadowMap.value=H.state.directionalShadowMap,Ut.directionalShadowMatrix.value=H.state.directionalShadowMatrix,Ut.spotShadowMap.value=H.state.spotShadowMap,Ut.spotLightMatrix.value=H.state.spotLightMatrix,Ut.spotLightMap.value=H.state.spotLightMap,Ut.pointShadowMap.value=H.state.pointShadowMap,Ut.pointShadowMatrix.value=H.state.pointShadowMatrix),$.currentProgram=Xt,$.uniformsList=null,Xt}function Co(b){if(b.uniformsList===null){const F=b.currentProgram.getUniforms();b.uniformsList=wa.seqWithValue(F.seq,b.uniforms)}return b.uniformsList}function xi(b,F){const X=Pt.get(b);X.outputColorSpace=F.outputColorSpace,X.batching=F.batching,X.batchingColor=F.batchingColor,X.instancing=F.instancing,X.instancingColor=F.instancingColor,X.instancingMorph=F.instancingMorph,X.skinning=F.skinning,X.morphTargets=F.morphTargets,X.morphNormals=F.morphNormals,X.morphColors=F.morphColors,X.morphTargetsCount=F.morphTargetsCount,X.numClippingPlanes=F.numClippingPlanes,X.numIntersection=F.numClipIntersection,X.vertexAlphas=F.vertexAlphas,X.vertexTangents=F.vertexTangents,X.toneMapping=F.toneMapping}function tl(b,F,X,$,H){F.isScene!==!0&&(F=ce),P.resetTextureUnits();const ut=F.fog,yt=$.isMeshStandardMaterial?F.environment:null,Ft=U===null?M.outputColorSpace:U.isXRRenderTarget===!0?U.texture.colorSpace:Xs,Dt=($.isMeshStandardMaterial?Y:y).get($.envMap||yt),Vt=$.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,Xt=!!X.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Ut=!!X.morphAttributes.position,se=!!X.morphAttributes.normal,Se=!!X.morphAttributes.color;let we=ds;$.toneMapped&&(U===null||U.isXRRenderTarget===!0)&&(we=M.toneMapping);const ln=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,he=ln!==void 0?ln.length:0,kt=Pt.get($),ze=p.state.lights;if(at===!0&&(gt===!0||b!==S)){const En=b===S&&$.id===w;ft.setState($,b,En)}let pe=!1;$.version===kt.__version?(kt.needsLights&&kt.lightsStateVersion!==ze.state.version||kt.outputColorSpace!==Ft||H.isBatchedMesh&&kt.batching===!1||!H.isBatchedMesh&&kt.batching===!0||H.isBatchedMesh&&kt.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&kt.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&kt.instancing===!1||!H.isInstancedMesh&&kt.instancing===!0||H.isSkinnedMesh&&kt.skinning===!1||!H.isSkinnedMesh&&kt.skinning===!0||H.isInstancedMesh&&kt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&kt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&kt.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&kt.instancingMorph===!1&&H.morphTexture!==null||kt.envMap!==Dt||$.fog===!0&&kt.fog!==ut||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==ft.numPlanes||kt.numIntersection!==ft.numIntersection)||kt.vertexAlphas!==Vt||kt.vertexTangents!==Xt||kt.morphTargets!==Ut||kt.morphNormals!==se||kt.morphColors!==Se||kt.toneMapping!==we||kt.morphTargetsCount!==he)&&(pe=!0):(pe=!0,kt.__version=$.version);let Dn=kt.currentProgram;pe===!0&&(Dn=Ys($,F,H));let Mi=!1,_n=!1,xs=!1;const Re=Dn.getUniforms(),Kn=kt.uniforms;if(Gt.useProgram(Dn.program)&&(Mi=!0,_n=!0,xs=!0),$.id!==w&&(w=$.id,_n=!0),Mi||S!==b){Gt.buffers.depth.getReversed()?(ot.copy(b.projectionMatrix),Mv(ot),Sv(ot),Re.setValue(B,"projectionMatrix",ot)):Re.setValue(B,"projectionMatrix",b.projectionMatrix),Re.setValue(B,"viewMatrix",b.matrixWorldInverse);const Si=Re.map.cameraPosition;Si!==void 0&&Si.setValue(B,Ht.setFromMatrixPosition(b.matrixWorld)),te.logarithmicDepthBuffer&&Re.setValue(B,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Re.setValue(B,"isOrthographic",b.isOrthographicCamera===!0),S!==b&&(S=b,_n=!0,xs=!0)}if(H.isSkinnedMesh){Re.setOptional(B,H,"bindMatrix"),Re.setOptional(B,H,"bindMatrixInverse");const En=H.skeleton;En&&(En.boneTexture===null&&En.computeBoneTexture(),Re.setValue(B,"boneTexture",En.boneTexture,P))}H.isBatchedMesh&&(Re.setOptional(B,H,"batchingTexture"),Re.setValue(B,"batchingTexture",H._matricesTexture,P),Re.setOptional(B,H,"batchingIdTexture"),Re.setValue(B,"batchingIdTexture",H._indirectTexture,P),Re.setOptional(B,H,"batchingColorTexture"),H._colorsTexture!==null&&Re.setValue(B,"batchingColorTexture",H._colorsTexture,P));const Qi=X.morphAttributes;if((Qi.position!==void 0||Qi.normal!==void 0||Qi.color!==void 0)&&Ot.update(H,X,Dn),(_n||kt.receiveShadow!==H.receiveShadow)&&(kt.receiveShadow=H.receiveShadow,Re.setValue(B,"receiveShadow",H.receiveShadow)),$.isMeshGouraudMaterial&&$.envMap!==null&&(Kn.envMap.value=Dt,Kn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),$.isMeshStandardMaterial&&$.envMap===null&&F.environment!==null&&(Kn.envMapIntensity.value=F.environmentIntensity),_n&&(Re.setValue(B,"toneMappingExposure",M.toneMappingExposure),kt.needsLights&&vs(Kn,xs),ut&&$.fog===!0&&_t.refreshFogUniforms(Kn,ut),_t.refreshMaterialUniforms(Kn,$,tt,Q,p.state.transmissionRenderTarget[b.id]),wa.upload(B,Co(kt),Kn,P)),$.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(wa.upload(B,Co(kt),Kn,P),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Re.setValue(B,"center",H.center),Re.setValue(B,"modelViewMatrix",H.modelViewMatrix),Re.setValue(B,"normalMatrix",H.normalMatrix),Re.setValue(B,"modelMatrix",H.matrixWorld),$.isShaderMaterial||$.isRawShaderMaterial){const En=$.uniformsGroups;for(let Si=0,oi=En.length;Si<oi;Si++){const Ks=En[Si];k.update(Ks,Dn),k.bind(Ks,Dn)}}return Dn}function vs(b,F){b.ambientLightColor.needsUpdate=F,b.lightProbe.needsUpdate=F,b.directionalLights.needsUpdate=F,b.directionalLightShadows.needsUpdate=F,b.pointLights.needsUpdate=F,b.pointLightShadows.needsUpdate=F,b.spotLights.needsUpdate=F,b.spotLightShadows.needsUpdate=F,b.rectAreaLights.needsUpdate=F,b.hemisphereLights.needsUpdate=F}function Po(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return R},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return U},this.setRenderTargetTextures=function(b,F,X){Pt.get(b.texture).__webglTexture=F,Pt.get(b.depthTexture).__webglTexture=X;const $=Pt.get(b);$.__hasExternalTextures=!0,$.__autoAllocateDepthBuffer=X===void 0,$.__autoAllocateDepthBuffer||Jt.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),$.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(b,F){const X=Pt.get(b);X.__webglFramebuffer=F,X.__useDefaultFramebuffer=F===void 0},this.setRenderTarget=function(b,F=0,X=0){U=b,R=F,D=X;let $=!0,H=null,ut=!1,yt=!1;if(b){const Dt=Pt.get(b);if(Dt.__useDefaultFramebuffer!==void 0)Gt.bindFramebuffer(B.FRAMEBUFFER,null),$=!1;else if(Dt.__webglFramebuffer===void 0)P.setupRenderTarget(b);else if(Dt.__hasExternalTextures)P.rebindTextures(b,Pt.get(b.texture).__webglTexture,Pt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const Ut=b.depthTexture;if(Dt.__boundDepthTexture!==Ut){if(Ut!==null&&Pt.has(Ut)&&(b.width!==Ut.image.width||b.height!==Ut.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(b)}}const Vt=b.texture;(Vt.isData3DTexture||Vt.isDataArrayTexture||Vt.isCompressedArrayTexture)&&(yt=!0);const Xt=Pt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(Xt[F])?H=Xt[F][X]:H=Xt[F],ut=!0):b.samples>0&&P.useMultisampledRTT(b)===!1?H=Pt.get(b).__webglMultisampledFramebuffer:Array.isArray(Xt)?H=Xt[X]:H=Xt,C.copy(b.viewport),G.copy(b.scissor),I=b.scissorTest}else C.copy(mt).multiplyScalar(tt).floor(),G.copy(Mt).multiplyScalar(tt).floor(),I=pt;if(Gt.bindFramebuffer(B.FRAMEBUFFER,H)&&$&&Gt.drawBuffers(b,H),Gt.viewport(C),Gt.scissor(G),Gt.setScissorTest(I),ut){const Dt=Pt.get(b.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+F,Dt.__webglTexture,X)}else if(yt){const Dt=Pt.get(b.texture),Vt=F||0;B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,Dt.__webglTexture,X||0,Vt)}w=-1},this.readRenderTargetPixels=function(b,F,X,$,H,ut,yt){if(!(b&&b.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){Gt.bindFramebuffer(B.FRAMEBUFFER,Ft);try{const Dt=b.texture,Vt=Dt.format,Xt=Dt.type;if(!te.textureFormatReadable(Vt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!te.textureTypeReadable(Xt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}F>=0&&F<=b.width-$&&X>=0&&X<=b.height-H&&B.readPixels(F,X,$,H,qt.convert(Vt),qt.convert(Xt),ut)}finally{const Dt=U!==null?Pt.get(U).__webglFramebuffer:null;Gt.bindFramebuffer(B.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(b,F,X,$,H,ut,yt){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){const Dt=b.texture,Vt=Dt.format,Xt=Dt.type;if(!te.textureFormatReadable(Vt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!te.textureTypeReadable(Xt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(F>=0&&F<=b.width-$&&X>=0&&X<=b.height-H){Gt.bindFramebuffer(B.FRAMEBUFFER,Ft);const Ut=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.bufferData(B.PIXEL_PACK_BUFFER,ut.byteLength,B.STREAM_READ),B.readPixels(F,X,$,H,qt.convert(Vt),qt.convert(Xt),0);const se=U!==null?Pt.get(U).__webglFramebuffer:null;Gt.bindFramebuffer(B.FRAMEBUFFER,se);const Se=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await xv(B,Se,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,ut),B.deleteBuffer(Ut),B.deleteSync(Se),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(b,F=null,X=0){b.isTexture!==!0&&(po("WebGLRenderer: copyFramebufferToTexture function signature has changed."),F=arguments[0]||null,b=arguments[1]);const $=Math.pow(2,-X),H=Math.floor(b.image.width*$),ut=Math.floor(b.image.height*$),yt=F!==null?F.x:0,Ft=F!==null?F.y:0;P.setTexture2D(b,0),B.copyTexSubImage2D(B.TEXTURE_2D,X,0,0,yt,Ft,H,ut),Gt.unbindTexture()},this.copyTextureToTexture=function(b,F,X=null,$=null,H=0){b.isTexture!==!0&&(po("WebGLRenderer: copyTextureToTexture function signature has changed."),$=arguments[0]||null,b=arguments[1],F=arguments[2],H=arguments[3]||0,X=null);let ut,yt,Ft,Dt,Vt,Xt,Ut,se,Se;const we=b.isCompressedTexture?b.mipmaps[H]:b.image;X!==null?(ut=X.max.x-X.min.x,yt=X.max.y-X.min.y,Ft=X.isBox3?X.max.z-X.min.z:1,Dt=X.min.x,Vt=X.min.y,Xt=X.isBox3?X.min.z:0):(ut=we.width,yt=we.height,Ft=we.depth||1,Dt=0,Vt=0,Xt=0),$!==null?(Ut=$.x,se=$.y,Se=$.z):(Ut=0,se=0,Se=0);const ln=qt.convert(F.format),he=qt.convert(F.type);let kt;F.isData3DTexture?(P.setTexture3D(F,0),kt=B.TEXTURE_3D):F.isDataArrayTexture||F.isCompressedArrayTexture?(P.setTexture2DArray(F,0),kt=B.TEXTURE_2D_ARRAY):(P.setTexture2D(F,0),kt=B.TEXTURE_2D),B.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,F.flipY),B.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,F.premultiplyAlpha),B.pixelStorei(B.UNPACK_ALIGNMENT,F.unpackAlignment);const ze=B.getParameter(B.UNPACK_ROW_LENGTH),pe=B.getParameter(B.UNPACK_IMAGE_HEIGHT),Dn=B.getParameter(B.UNPACK_SKIP_PIXELS),Mi=B.getParameter(B.UNPACK_SKIP_ROWS),_n=B.getParameter(B.UNPACK_SKIP_IMAGES);B.pixelStorei(B.UNPACK_ROW_LENGTH,we.width),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,we.height),B.pixelStorei(B.UNPACK_SKIP_PIXELS,Dt),B.pixelStorei(B.UNPACK_SKIP_ROWS,Vt),B.pixelStorei(B.UNPACK_SKIP_IMAGES,Xt);const xs=b.isDataArrayTexture||b.isData3DTexture,Re=F.isDataArrayTexture||F.isData3DTexture;if(b.isRenderTargetTexture||b.isDepthTexture){const Kn=Pt.get(b),Qi=Pt.get(F),En=Pt.get(Kn.__renderTarget),Si=Pt.get(Qi.__renderTarget);Gt.bindFramebuffer(B.READ_FRAMEBUFFER,En.__webglFramebuffer),Gt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Si.__webglFramebuffer);for(let oi=0;oi<Ft;oi++)xs&&B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(b).__webglTexture,H,Xt+oi),b.isDepthTexture?(Re&&B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(F).__webglTexture,H,Se+oi),B.blitFramebuffer(Dt,Vt,ut,yt,Ut,se,ut,yt,B.DEPTH_BUFFER_BIT,B.NEAREST)):Re?B.copyTexSubImage3D(kt,H,Ut,se,Se+oi,Dt,Vt,ut,yt):B.copyTexSubImage2D(kt,H,Ut,se,Se+oi,Dt,Vt,ut,yt);Gt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Gt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Re?b.isDataTexture||b.isData3DTexture?B.texSubImage3D(kt,H,Ut,se,Se,ut,yt,Ft,ln,he,we.data):F.isCompressedArrayTexture?B.compressedTexSubImage3D(kt,H,Ut,se,Se,ut,yt,Ft,ln,we.data):B.texSubImage3D(kt,H,Ut,se,Se,ut,yt,Ft,ln,he,we):b.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,H,Ut,se,ut,yt,ln,he,we.data):b.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,H,Ut,se,we.width,we.height,ln,we.data):B.texSubImage2D(B.TEXTURE_2D,H,Ut,se,ut,yt,ln,he,we);B.pixelStorei(B.UNPACK_ROW_LENGTH,ze),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,pe),B.pixelStorei(B.UNPACK_SKIP_PIXELS,Dn),B.pixelStorei(B.UNPACK_SKIP_ROWS,Mi),B.pixelStorei(B.UNPACK_SKIP_IMAGES,_n),H===0&&F.generateMipmaps&&B.generateMipmap(kt),Gt.unbindTexture()},this.copyTextureToTexture3D=function(b,F,X=null,$=null,H=0){return b.isTexture!==!0&&(po("WebGLRenderer: copyTextureToTexture3D function signature has changed."),X=arguments[0]||null,$=arguments[1]||null,b=arguments[2],F=arguments[3],H=arguments[4]||0),po('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(b,F,X,$,H)},this.initRenderTarget=function(b){Pt.get(b).__webglFramebuffer===void 0&&P.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?P.setTextureCube(b,0):b.isData3DTexture?P.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?P.setTexture2DArray(b,0):P.setTexture2D(b,0),Gt.unbindTexture()},this.resetState=function(){R=0,D=0,U=null,Gt.reset(),de.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Yi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=me._getDrawingBufferColorSpace(t),e.unpackColorSpace=me._getUnpackColorSpace()}}let od=class extends en{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Fi,this.environmentIntensity=1,this.environmentRotation=new Fi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};class Ro extends qs{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new oe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const Ua=new z,Ia=new z,ad=new Ue,co=new zu,la=new Ao,Kl=new z,ld=new z;class im extends en{constructor(t=new on,e=new Ro){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ua.fromBufferAttribute(e,s-1),Ia.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ua.distanceTo(Ia);t.setAttribute("lineDistance",new ke(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),la.copy(n.boundingSphere),la.applyMatrix4(s),la.radius+=r,t.ray.intersectsSphere(la)===!1)return;ad.copy(s).invert(),co.copy(t.ray).applyMatrix4(ad);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){const d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=u.getX(v),E=u.getX(v+1),T=ca(this,t,co,l,p,E);T&&e.push(T)}if(this.isLineLoop){const v=u.getX(g-1),m=u.getX(d),p=ca(this,t,co,l,v,m);p&&e.push(p)}}else{const d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=ca(this,t,co,l,v,v+1);p&&e.push(p)}if(this.isLineLoop){const v=ca(this,t,co,l,g-1,d);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function ca(i,t,e,n,s,r){const o=i.geometry.attributes.position;if(Ua.fromBufferAttribute(o,s),Ia.fromBufferAttribute(o,r),e.distanceSqToSegment(Ua,Ia,Kl,ld)>n)return;Kl.applyMatrix4(i.matrixWorld);const l=t.ray.origin.distanceTo(Kl);if(!(l<t.near||l>t.far))return{distance:l,point:ld.clone().applyMatrix4(i.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:i}}const cd=new z,ud=new z;class sm extends im{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)cd.fromBufferAttribute(e,s),ud.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+cd.distanceTo(ud);t.setAttribute("lineDistance",new ke(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class rm extends qs{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new oe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const hd=new Ue,iu=new zu,ua=new Ao,ha=new z;class LE extends en{constructor(t=new on,e=new rm){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ua.copy(n.boundingSphere),ua.applyMatrix4(s),ua.radius+=r,t.ray.intersectsSphere(ua)===!1)return;hd.copy(s).invert(),iu.copy(t.ray).applyMatrix4(hd);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){const f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,v=d;g<v;g++){const m=c.getX(g);ha.fromBufferAttribute(h,m),fd(ha,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let g=f,v=d;g<v;g++)ha.fromBufferAttribute(h,g),fd(ha,g,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function fd(i,t,e,n,s,r,o){const a=iu.distanceSqToPoint(i);if(a<e){const l=new z;iu.closestPointToPoint(i,l),l.applyMatrix4(n);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class Wu extends on{constructor(t=[new ae(0,-.5),new ae(.5,0),new ae(0,.5)],e=12,n=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:n,phiLength:s},e=Math.floor(e),s=Cn(s,0,Math.PI*2);const r=[],o=[],a=[],l=[],c=[],u=1/e,h=new z,f=new ae,d=new z,g=new z,v=new z;let m=0,p=0;for(let E=0;E<=t.length-1;E++)switch(E){case 0:m=t[E+1].x-t[E].x,p=t[E+1].y-t[E].y,d.x=p*1,d.y=-m,d.z=p*0,v.copy(d),d.normalize(),l.push(d.x,d.y,d.z);break;case t.length-1:l.push(v.x,v.y,v.z);break;default:m=t[E+1].x-t[E].x,p=t[E+1].y-t[E].y,d.x=p*1,d.y=-m,d.z=p*0,g.copy(d),d.x+=v.x,d.y+=v.y,d.z+=v.z,d.normalize(),l.push(d.x,d.y,d.z),v.copy(g)}for(let E=0;E<=e;E++){const T=n+E*u*s,M=Math.sin(T),O=Math.cos(T);for(let R=0;R<=t.length-1;R++){h.x=t[R].x*M,h.y=t[R].y,h.z=t[R].x*O,o.push(h.x,h.y,h.z),f.x=E/e,f.y=R/(t.length-1),a.push(f.x,f.y);const D=l[3*R+0]*M,U=l[3*R+1],w=l[3*R+0]*O;c.push(D,U,w)}}for(let E=0;E<e;E++)for(let T=0;T<t.length-1;T++){const M=T+E*t.length,O=M,R=M+t.length,D=M+t.length+1,U=M+1;r.push(O,R,U),r.push(D,U,R)}this.setIndex(r),this.setAttribute("position",new ke(o,3)),this.setAttribute("uv",new ke(a,2)),this.setAttribute("normal",new ke(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Wu(t.points,t.segments,t.phiStart,t.phiLength)}}class Xu extends on{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],f=[],d=[];let g=0;const v=[],m=n/2;let p=0;E(),o===!1&&(t>0&&T(!0),e>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new ke(h,3)),this.setAttribute("normal",new ke(f,3)),this.setAttribute("uv",new ke(d,2));function E(){const M=new z,O=new z;let R=0;const D=(e-t)/n;for(let U=0;U<=r;U++){const w=[],S=U/r,C=S*(e-t)+t;for(let G=0;G<=s;G++){const I=G/s,V=I*l+a,j=Math.sin(V),K=Math.cos(V);O.x=C*j,O.y=-S*n+m,O.z=C*K,h.push(O.x,O.y,O.z),M.set(j,D,K).normalize(),f.push(M.x,M.y,M.z),d.push(I,1-S),w.push(g++)}v.push(w)}for(let U=0;U<s;U++)for(let w=0;w<r;w++){const S=v[w][U],C=v[w+1][U],G=v[w+1][U+1],I=v[w][U+1];(t>0||w!==0)&&(u.push(S,C,I),R+=3),(e>0||w!==r-1)&&(u.push(C,G,I),R+=3)}c.addGroup(p,R,0),p+=R}function T(M){const O=g,R=new ae,D=new z;let U=0;const w=M===!0?t:e,S=M===!0?1:-1;for(let G=1;G<=s;G++)h.push(0,m*S,0),f.push(0,S,0),d.push(.5,.5),g++;const C=g;for(let G=0;G<=s;G++){const V=G/s*l+a,j=Math.cos(V),K=Math.sin(V);D.x=w*K,D.y=m*S,D.z=w*j,h.push(D.x,D.y,D.z),f.push(0,S,0),R.x=j*.5+.5,R.y=K*.5*S+.5,d.push(R.x,R.y),g++}for(let G=0;G<s;G++){const I=O+G,V=C+G;M===!0?u.push(V,V+1,I):u.push(V+1,V,I),U+=3}c.addGroup(p,U,M===!0?1:2),p+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Xu(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}const fa=new z,da=new z,jl=new z,pa=new ii;class om extends on{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){const s=Math.pow(10,4),r=Math.cos(ba*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);const{a:v,b:m,c:p}=pa;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),pa.getNormal(jl),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let E=0;E<3;E++){const T=(E+1)%3,M=h[E],O=h[T],R=pa[u[E]],D=pa[u[T]],U=`${M}_${O}`,w=`${O}_${M}`;w in f&&f[w]?(jl.dot(f[w].normal)<=r&&(d.push(R.x,R.y,R.z),d.push(D.x,D.y,D.z)),f[w]=null):U in f||(f[U]={index0:c[E],index1:c[T],normal:jl.clone()})}}for(const g in f)if(f[g]){const{index0:v,index1:m}=f[g];fa.fromBufferAttribute(a,v),da.fromBufferAttribute(a,m),d.push(fa.x,fa.y,fa.z),d.push(da.x,da.y,da.z)}this.setAttribute("position",new ke(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}}class Ja extends on{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));const l=Math.min(o+a,Math.PI);let c=0;const u=[],h=new z,f=new z,d=[],g=[],v=[],m=[];for(let p=0;p<=n;p++){const E=[],T=p/n;let M=0;p===0&&o===0?M=.5/e:p===n&&l===Math.PI&&(M=-.5/e);for(let O=0;O<=e;O++){const R=O/e;h.x=-t*Math.cos(s+R*r)*Math.sin(o+T*a),h.y=t*Math.cos(o+T*a),h.z=t*Math.sin(s+R*r)*Math.sin(o+T*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),m.push(R+M,1-T),E.push(c++)}u.push(E)}for(let p=0;p<n;p++)for(let E=0;E<e;E++){const T=u[p][E+1],M=u[p][E],O=u[p+1][E],R=u[p+1][E+1];(p!==0||o>0)&&d.push(T,M,R),(p!==n-1||l<Math.PI)&&d.push(M,O,R)}this.setIndex(d),this.setAttribute("position",new ke(g,3)),this.setAttribute("normal",new ke(v,3)),this.setAttribute("uv",new ke(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Ja(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}}class $u extends on{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new z,h=new z,f=new z;for(let d=0;d<=n;d++)for(let g=0;g<=s;g++){const v=g/s*r,m=d/n*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(d/n)}for(let d=1;d<=n;d++)for(let g=1;g<=s;g++){const v=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,E=(s+1)*d+g;o.push(v,m,E),o.push(m,p,E)}this.setIndex(o),this.setAttribute("position",new ke(a,3)),this.setAttribute("normal",new ke(l,3)),this.setAttribute("uv",new ke(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new $u(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class DE extends qs{static get type(){return"MeshLambertMaterial"}constructor(t){super(),this.isMeshLambertMaterial=!0,this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new oe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Bp,this.normalScale=new ae(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Fi,this.combine=Uu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class am extends Ro{static get type(){return"LineDashedMaterial"}constructor(t){super(),this.isLineDashedMaterial=!0,this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}}class lm extends en{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new oe(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class UE extends lm{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(en.DEFAULT_UP),this.updateMatrix(),this.groundColor=new oe(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const Zl=new Ue,dd=new z,pd=new z;class IE{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ae(512,512),this.map=null,this.mapPass=null,this.matrix=new Ue,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Hu,this._frameExtents=new ae(1,1),this._viewportCount=1,this._viewports=[new Ge(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,n=this.matrix;dd.setFromMatrixPosition(t.matrixWorld),e.position.copy(dd),pd.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(pd),e.updateMatrixWorld(),Zl.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix(Zl),n.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),n.multiply(Zl)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class NE extends IE{constructor(){super(new Gu(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class FE extends lm{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(en.DEFAULT_UP),this.updateMatrix(),this.target=new en,this.shadow=new NE}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:Du}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=Du);function Na(i,t=!1){const e=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,l=new on;let c=0;for(let u=0;u<i.length;++u){const h=i[u];let f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(const d in h.attributes){if(!n.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+d+'" attribute exists among all geometries, or in none of them.'),null;r[d]===void 0&&(r[d]=[]),r[d].push(h.attributes[d]),f++}if(f!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(const d in h.morphAttributes){if(!s.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;o[d]===void 0&&(o[d]=[]),o[d].push(h.morphAttributes[d])}if(t){let d;if(e)d=h.index.count;else if(h.attributes.position!==void 0)d=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,d,u),c+=d}}if(e){let u=0;const h=[];for(let f=0;f<i.length;++f){const d=i[f].index;for(let g=0;g<d.count;++g)h.push(d.getX(g)+u);u+=i[f].attributes.position.count}l.setIndex(h)}for(const u in r){const h=md(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(const u in o){const h=o[u][0].length;if(h===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let f=0;f<h;++f){const d=[];for(let v=0;v<o[u].length;++v)d.push(o[u][v][f]);const g=md(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(g)}}return l}function md(i){let t,e,n,s=-1,r=0;for(let c=0;c<i.length;++c){const u=i[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=u.normalized),n!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}const o=new t(r),a=new kn(o,e,n);let l=0;for(let c=0;c<i.length;++c){const u=i[c];if(u.isInterleavedBufferAttribute){const h=l/e;for(let f=0,d=u.count;f<d;f++)for(let g=0;g<e;g++){const v=u.getComponent(f,g);a.setComponent(f+h,g,v)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}const OE={...be,limit:"#6f8aa5"},Gs=i=>OE[i],cm={x:new z(1,0,0),y:new z(0,1,0),z:new z(0,0,1)},Ni=i=>Oa?Math.ceil(i/2):i,kE=i=>new z(...yo[i]),um=(i,t)=>new $s().setFromUnitVectors(cm[i],kE(t));function Jl(i,{colour:t,centre_m:e,along:n},s){i.deleteAttribute("uv");const r=new oe(t),o=new Float32Array(i.attributes.position.count*3);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return i.setAttribute("color",new kn(o,3)),n&&i.applyQuaternion(um(s,n)),i.translate(...e)}const BE={box:i=>Jl(new qr(...i.size_m),i),cylinder:i=>Jl(new Xu(i.radius_m,i.other_radius_m??i.radius_m,i.length_m,Ni(32)),i,"y"),torus:i=>Jl(new $u(i.radius_m,i.thickness_m,Ni(8),Ni(72)),i,"z")},su=i=>i.map(t=>BE[t.kind](t));function zE(i){const t=new Li,e=i.role==="predicted"||i.role==="truth";t.inner=e?GE(i):HE(i),t.add(t.inner);const{min:n,max:s}=new Xr().setFromObject(t.inner);return t.reach="xyz".split("").map(r=>Math.max(-n[r],s[r])),t}function HE({shape:i}){const t=new Li,e=i.filter(s=>s.lit),n=i.filter(s=>!s.lit);return e.length&&(t.lit=new DE({vertexColors:!0}),t.add(new Sn(Na(su(e)),t.lit))),n.length&&t.add(new Sn(Na(su(n)),new $r({vertexColors:!0}))),t}function GE({role:i,shape:t}){const e=su(t),n=Gs(i),s=new Sn(Na(e),new $r({color:n,transparent:!0,opacity:.16,depthWrite:!1}));return s.add(new sm(Na(e.map(r=>new om(r,40))),new Ro({color:n,transparent:!0,opacity:.75}))),s}function ru(i,t){const e=Ni(64);return Array.from({length:e+1},(n,s)=>{const r=s/e*2*Math.PI;return new z(i,t*Math.cos(r),t*Math.sin(r))})}function gd(i,t,e){return Array.from({length:e},(n,s)=>{const r=s/e*2*Math.PI;return i.map((o,a)=>new z(o,t[a]*Math.cos(r),t[a]*Math.sin(r)))})}function ou(i,t){const[e,n]=[[],[]];for(const r of i){let o=0;for(let a=1;a<r.length;a+=1)e.push(r[a-1],r[a]),n.push(o,o+=r[a].distanceTo(r[a-1]))}const s=new on().setFromPoints(e);return s.setAttribute("lineDistance",new ke(n,1)),new sm(s,t)}const qu=(i,t)=>new $r({color:Gs(i),transparent:!0,opacity:t,side:Ri,forceSinglePass:!0,depthWrite:!1}),au=(i,t)=>new Ro({color:Gs(i),transparent:!0,opacity:t});function VE(i){const{stations_m:t,radii_m:e}=i,n=new Li;if(i.skin){const a=new Sn(new Wu(t.map((l,c)=>new ae(e[c],l)),Ni(48)),qu(i.role,.05));a.rotation.z=-Math.PI/2,n.add(a)}const s=[...gd(t,e,i.meridians),...i.rings.map(([a,l])=>ru(a,l))],r=[...gd(t,e,i.faint_meridians),...i.faint_rings.map(([a,l])=>ru(a,l))];i.axis&&r.push([t[0],t[t.length-1]].map(a=>new z(a,0,0)));const o=()=>new am({color:Gs(i.role),dashSize:.35,gapSize:.22,transparent:!0,opacity:.85});return s.length&&n.add(ou(s,i.dashed?o():au(i.role,.8))),r.length&&n.add(ou(r,au(i.role,.38))),n.quaternion.copy(um("x",i.along)),n.position.set(...i.origin_m),n}function WE({role:i,radius_m:t}){const e=new Li,n=([r,o,a])=>[new z(r,o,a),new z(o,r,a),new z(a,o,r)],s=ru(0,t).map(r=>n(r.toArray()));return e.add(new Sn(new Ja(t,Ni(32),Ni(20)),qu(i,.1)),ou([0,1,2].map(r=>s.map(o=>o[r])),au(i,.7))),e}const XE=i=>i.kind==="sphere"?WE(i):VE(i);function $E(){const i=[];let t=7;const e=()=>(t=t*16807%2147483647,t/2147483647);for(let s=0;s<Ni(1400);s+=1){const r=2*e()-1,o=2*Math.PI*e(),a=Math.sqrt(1-r*r);i.push(900*a*Math.cos(o),900*r,900*a*Math.sin(o))}const n=new on;return n.setAttribute("position",new ke(i,3)),new LE(n,new rm({color:9413562,size:1.3,sizeAttenuation:!1,transparent:!0,opacity:.7}))}function qE({direction:i,half_angle_rad:t,colour:e}){const n=new z(...i).normalize(),s=Math.PI/2-t,r=new Ja(500*Math.sin(t),Ni(96),Ni(16),0,2*Math.PI,0,1.05*s);r.applyQuaternion(new $s().setFromUnitVectors(cm.y,n.clone().negate()));const o=r.attributes.position,a=new oe().setStyle(e,Xs),l=[],c=new z;for(let h=0;h<o.count;h+=1){c.fromBufferAttribute(o,h).normalize();const f=Math.sin(23*c.x+5*Math.sin(17*c.z))*Math.sin(19*c.z+4*Math.sin(13*c.x)),g=Math.max(.15,c.x*-.35+c.y*.75+c.z*.35)*(.124+.024*f);l.push(g*a.r,g*a.g,g*a.b)}r.setAttribute("color",new ke(l,3));const u=new Sn(r,new $r({vertexColors:!0}));return u.position.copy(n).multiplyScalar(500),u}function YE(i){const t=new Li;i.stars&&t.add($E());for(const e of i.sky)t.add(qE(e));return t}class KE{constructor(t,e=24,n=10){this.stations=e,this.sides=n,this.places=new Float32Array(e*n*3);const s=[];for(let o=0;o<e-1;o+=1)for(let a=0;a<n;a+=1){const l=o*n+a,c=o*n+(a+1)%n;s.push(l,c,l+n,c,c+n,l+n)}const r=new on;r.setAttribute("position",new kn(this.places,3)),r.setIndex(s),this.mesh=new Sn(r,qu(t,.22)),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set({rows:t,at:e,n}){if(this.mesh.visible=n>1,!!this.mesh.visible){for(let s=0;s<this.stations;s+=1){const r=s/(this.stations-1)*(n-1),o=Math.min(Math.floor(r),n-2),a=r-o,l=u=>t[o][e+u]+(t[o+1][e+u]-t[o][e+u])*a,c=l(3);for(let u=0;u<this.sides;u+=1){const h=u/this.sides*2*Math.PI,f=(s*this.sides+u)*3;this.places[f]=l(0),this.places[f+1]=l(1)+c*Math.cos(h),this.places[f+2]=l(2)+c*Math.sin(h)}}this.mesh.geometry.attributes.position.needsUpdate=!0}}}class jE{constructor(t,e,n){this.most=e,this.places=new Float32Array(e*3);const s=new on;s.setAttribute("position",new kn(this.places,3));const r=n?new am({color:Gs(t),dashSize:.25,gapSize:.2}):new Ro({color:Gs(t)});this.dashed=n,this.line=new im(s,r),this.line.frustumCulled=!1,this.line.visible=!1}set({rows:t,at:e,n}){const s=n>0?t[n-1]:null;if(t===this.rows&&n===this.count&&s===this.last)return;Object.assign(this,{rows:t,count:n,last:s});const r=Math.max(1,Math.ceil(n/this.most));let o=0;for(let a=0;a<n&&o<this.most;a+=r,o+=1){const l=t[a];this.places[o*3]=l[e],this.places[o*3+1]=l[e+1],this.places[o*3+2]=l[e+2]}this.line.geometry.setDrawRange(0,o),this.line.geometry.attributes.position.needsUpdate=!0,this.dashed&&this.line.computeLineDistances(),this.line.visible=o>1}}const ZE=.5,JE=25,QE=[5,4],Ql=new WeakMap,[tc,yr,Er]=[new Ue,new Ge,new Ge];function tb(i){return Ql.has(i)||Ql.set(i,new om(i,JE)),Ql.get(i)}class _d{constructor(t){Object.assign(this,{canvas:t,pen:t.getContext("2d",{willReadFrequently:!0}),ratio:1,cut:!1,colour:"#000"}),this.at={left:0,top:0,width:0,height:0}}setPixelRatio(t){this.ratio=t}setSize(t,e){this.size={width:t,height:e},this.canvas.width=Math.max(1,Math.round(t*this.ratio)),this.canvas.height=Math.max(1,Math.round(e*this.ratio))}setScissorTest(t){this.cut=t}setScissor(){}setViewport(t,e,n,s){this.at={left:t,top:this.size.height-e-s,width:n,height:s}}setClearColor(t){this.colour=`#${t.toString(16).padStart(6,"0")}`}clear(){const{left:t,top:e,width:n,height:s}=this.cut?this.at:{left:0,top:0,...this.size};this.pen.setTransform(this.ratio,0,0,this.ratio,0,0),this.pen.fillStyle=this.colour,this.pen.fillRect(t,e,n,s)}clearDepth(){}dispose(){}render(t,e){const{pen:n,at:s}=this;t.updateMatrixWorld(),e.updateMatrixWorld(),n.save(),n.beginPath(),n.rect(s.left,s.top,s.width,s.height),n.clip();const r=new Ue().multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse);t.traverseVisible(o=>{o.layers.test(e.layers)&&(o.isLine?this.lines(o,o.geometry,o.isLineSegments?2:1,r,`#${o.material.color.getHexString()}`):o.isMesh&&o.material.opacity>ZE&&this.lines(o,tb(o.geometry),2,r,be.plain))}),n.restore()}lines({matrixWorld:t,material:e},n,s,r,o){const{pen:a}=this,{position:l}=n.attributes,c=Math.min(l.count,n.drawRange.count);tc.multiplyMatrices(r,t),a.strokeStyle=o,a.globalAlpha=e.transparent?e.opacity:1,a.lineWidth=1,a.setLineDash(e.isLineDashedMaterial?QE:[]),a.beginPath();for(let u=0;u+1<c;u+=s)yr.fromBufferAttribute(l,u).setW(1).applyMatrix4(tc),Er.fromBufferAttribute(l,u+1).setW(1).applyMatrix4(tc),eb()&&(a.moveTo(...this.place(yr)),a.lineTo(...this.place(Er)));a.stroke(),a.globalAlpha=1}place(t){const{left:e,top:n,width:s,height:r}=this.at;return[e+(t.x/t.w+1)/2*s,n+(1-t.y/t.w)/2*r]}pixels(){return this.pen.getImageData(0,0,this.canvas.width,this.canvas.height).data}}function eb(){const[i,t]=[yr.z+yr.w,Er.z+Er.w];return i<=0&&t<=0?!1:(i<=0?yr.lerp(Er,(1e-6-i)/(t-i)):t<=0&&Er.lerp(yr,(1e-6-t)/(i-t)),!0)}const ma=1,nb=22e5,[ib,sb,vd]=[60,38,.35],ec=Oa?.5:1,rb=1e3,xd=24,ob=64,[ab,lb]=[860723,3159354],ga=i=>new z(...yo[i]);class cb{constructor(t,e,n,s){this.elements={view:e,camera:n,labels:s},this.canvas=t;const r={antialias:!Oa,alpha:!1,powerPreference:"high-performance",preserveDrawingBuffer:!0},o=t.getContext("webgl2",r);this.webgl=o!==null,this.webgl?(this.renderer=new PE({canvas:t,context:o,...r}),this.renderer.autoClear=!1,t.addEventListener("webglcontextlost",()=>this.outline())):this.renderer=new _d(t),this.scene=new od,this.scene.add(new UE(14674431,2763306,.9));const a=new FE(16777215,2.3);a.position.set(-6,9,5),this.scene.add(a),this.far=new od,this.perspective=new $n(32,1,.1,2e3),this.ortho=new Gu(-1,1,1,-1,-100,200),this.onboard=new $n(20,1,.02,2e3);for(const c of[this.perspective,this.ortho])c.layers.enable(ma);Object.assign(this,{display:null,world:null,items:new Map,bodies:[],eyes:[],chosen:0}),Object.assign(this,{enabled:!0,drawn:0,quality:ec,adaptive:!0,pace:33,since:0}),this.marks=new Map,this.follow(e),this.resize();const l=new ResizeObserver(()=>this.resize());for(const c of[e,n])l.observe(c);addEventListener("resize",()=>this.resize())}outline(){const t=this.canvas.cloneNode(!1);this.canvas.replaceWith(t),this.renderer.dispose(),Object.assign(this,{canvas:t,webgl:!1,renderer:new _d(t)}),this.resize()}adapt(t){if(!this.adaptive)return;this.pace=this.pace*.8+Math.min(t,400)*.2,this.since+=1;const e=this.pace>ib&&this.quality>vd,n=this.pace<sb&&this.quality<ec;this.since<(n?150:6)||!(e||n)||(this.quality=Math.max(vd,Math.min(ec,this.quality*(e?.7:1.25))),this.since=0,this.resize())}setDisplay(t){for(const e of[this.world,...this.far.children])ub(e);this.far.clear(),this.far.add(YE(t)),this.world=new Li,this.scene.add(this.world),this.items.clear(),this.bodies=t.bodies.map(e=>this.add(e,zE(e),!Array.isArray(e.place))),this.moving=this.bodies.filter(({moves:e})=>e);for(const e of t.surfaces){const n=this.add(e,XE(e),e.kind==="sphere"&&!Array.isArray(e.place));n.moves?this.moving.push(n):e.kind==="sphere"&&n.object.position.set(...e.place)}this.lines=t.lines.map(e=>this.addLine(e)),this.eyes=t.views.map(e=>({azimuth:e.azimuth_rad,height:e.height_rad,zoom:1,focus:e.kind==="perspective"?new z(...Md(e,null)):null})),(this.display===null||this.chosen>=t.views.length)&&(this.chosen=0),this.display=t,this.frame=null,this.shot=[]}add(t,e,n){const s={item:t,object:e,moves:n};return n?(e.visible=!1,e.traverse(r=>r.layers.set(ma))):t.kind==="body"&&e.position.set(...t.place),this.items.set(t.name,e),this.world.add(e),s}addLine(t){const e=Array.isArray(t.points),n=e?t.points.length:t.kind==="line"?ob:t.since?xd+3:rb,s=new jE(t.role,n,t.dashed);e?s.set({rows:t.points,at:0,n}):s.line.layers.set(ma),this.items.set(t.name,s.line),this.world.add(s.line);const r=t.spread?new KE(t.role):null;return r&&(r.mesh.layers.set(ma),this.world.add(r.mesh)),{line:t,path:s,tube:r,stands:e}}place(t,e,n,s){this.frame=t;for(const{item:r,object:o}of this.moving){const a=Ii(t,r.place,r.axes);o.visible=!!a,a&&o.position.set(...a);const l=a&&r.attitude?Cr(t,r.attitude):void 0;l&&o.inner.quaternion.set(...l),r.role==="measured"&&o.inner?.lit&&o.inner.lit.emissive.setHex(s?lb:ab)}for(const{line:r,path:o,tube:a,stands:l}of this.lines)if(!l)if(r.kind==="line"){const c=Cr(t,r.points)||[];o.set({rows:c,at:0,n:c.length})}else{const c=Wm(r,e?.trails.get(r.name)||[],t,n,xd);o.set(c),a?.set(c)}}known(t){for(const e of t){const{item:n}=this.bodies.find(r=>r.item.name===e),s=Ii(this.frame,n.place,n.axes);if(s)return{item:n,at:s}}return null}resize(){const t=[this.elements.view,this.elements.camera].map(u=>u.getBoundingClientRect()),e=t.filter(u=>u.width>0),n=Math.min(...e.map(u=>u.left)),s=Math.min(...e.map(u=>u.top)),r=Math.max(...e.map(u=>u.right))-n,o=Math.max(...e.map(u=>u.bottom))-s,a=u=>({left:u.left-n,bottom:s+o-u.bottom,width:u.width,height:u.height});this.places={view:a(t[0]),camera:a(t[1])};const{canvas:l}=this;Object.assign(l.style,{left:`${n}px`,top:`${s}px`,width:`${r}px`,height:`${o}px`});const c=Math.min(devicePixelRatio||1,Math.sqrt(nb/Math.max(r*o,1)));this.renderer.setPixelRatio(c*this.quality),this.renderer.setSize(r,o,!1),this.renderer.setScissorTest(!1),this.renderer.setClearColor(527378,1),this.renderer.clear(),this.renderer.setScissorTest(!0),this.shot=[],this.tall=parseFloat(getComputedStyle(this.elements.labels).fontSize)}follow(t){let e=null;t.addEventListener("pointerdown",n=>{n.target.closest("button")||(e=[n.clientX,n.clientY],t.setPointerCapture(n.pointerId))}),t.addEventListener("pointermove",n=>{e&&(this.turn((n.clientX-e[0])*.005,(n.clientY-e[1])*.005),e=[n.clientX,n.clientY])}),t.addEventListener("pointerup",()=>{e=null}),t.addEventListener("wheel",n=>{n.preventDefault(),this.zoom(Math.exp(n.deltaY*.001))},{passive:!1})}turn(t,e){const n=this.eyes[this.chosen];n?.focus&&(n.azimuth+=t,n.height=Math.max(-1.4,Math.min(1.4,n.height+e)))}zoom(t){const e=this.eyes[this.chosen];e&&(e.zoom=Math.max(.15,Math.min(4,e.zoom*t)))}draw(){if(!this.enabled||!this.display)return;this.drawn+=1;const{view:t,camera:e}=this.places,n=this.display.views[this.chosen],s=n.kind==="flat";if(s)for(const{object:a}of this.bodies)a.scale.setComponent("xyz".indexOf(n.up[1]),1/n.stretch);const r=s?this.flat(n,t):this.orbit(n,t);if(this.into(t,r,!s),this.label(r,t,s?n:null),s)for(const{object:a}of this.bodies)a.scale.set(1,1,1);if(!this.display.camera||e.height<=20)return;const o=this.known(this.display.camera.carried_by)?.at||this.display.camera.start_m;o.some((a,l)=>a!==this.shot[l])&&(this.shot=[...o],this.aim(this.display.camera,o,e),this.into(e,this.onboard,!0))}orbit(t,e){const n=this.perspective,s=e.width/Math.max(e.height,1),r=this.eyes[this.chosen],{focus:o}=r;o.lerp(new z(...Md(t,this.known(t.follow)?.at)),.08);const a=o.distanceTo(new z(...t.centre_m)),l=r.zoom*(t.distance_m+t.growth*a)*Math.max(1,1.45/s),c=Math.cos(r.height);return n.position.set(o.x+l*c*Math.cos(r.azimuth),o.y+l*Math.sin(r.height),o.z+l*c*Math.sin(r.azimuth)),n.lookAt(o),n.aspect=s,n.updateProjectionMatrix(),n}flat(t,e){const n=this.ortho,s=t.span_m/2*this.eyes[this.chosen].zoom,r=s/(e.width/Math.max(e.height,1))/t.stretch;Object.assign(n,{left:-s,right:s,top:r,bottom:-r});const o=new z(...t.centre_m);return n.up.copy(ga(t.up)),n.position.copy(ga(t.right)).cross(n.up).multiplyScalar(50).add(o),n.lookAt(o),n.updateProjectionMatrix(),n}aim(t,e,n){const s=this.onboard;s.up.copy(ga(t.up)),s.position.set(...e),s.lookAt(s.position.clone().add(ga(t.look)));const r=Math.max(Ci(t.look,t.aim_m)-Ci(t.look,e),.4),[o,a]=t.half_field;this.cameraTan=Math.max(o,Math.min(a,t.half_height_m/r)),s.fov=2*Math.atan(this.cameraTan)*180/Math.PI,s.aspect=n.width/Math.max(n.height,1),s.updateProjectionMatrix(),s.updateMatrixWorld()}into(t,e,n){if(this.renderer.setViewport(t.left,t.bottom,t.width,t.height),this.renderer.setScissor(t.left,t.bottom,t.width,t.height),this.renderer.setClearColor(329740,1),this.renderer.clear(!0,!0),n){const s=e.position.clone();e.position.set(0,0,0),e.updateMatrixWorld(),this.renderer.render(this.far,e),e.position.copy(s),e.updateMatrixWorld(),this.renderer.clearDepth()}this.renderer.render(this.scene,e)}label(t,e,n){const s=n?n.up:"+y",r=n?n.stretch:1,o=new Map;for(const{text:l,at_m:c}of this.display.labels)o.set(l,{text:l,at:c,drop:1});for(const{item:l,object:c}of this.bodies){const u=l.label?Ii(this.frame,l.place,l.axes):void 0;if(!u)continue;const h=u.map((f,d)=>f+yo[s][d]*c.reach[d]/r);o.set(`body ${l.name}`,{text:l.label,at:h,role:l.role})}for(const[l,c]of this.marks)o.has(l)||(c.remove(),this.marks.delete(l));t.updateMatrixWorld();const a=[];for(const[l,{text:c,at:u,role:h,drop:f}]of o){let d=this.marks.get(l);d||(d=document.createElement("span"),d.textContent=c,h&&(d.className="body",d.style.color=Gs(h)),this.elements.labels.append(d),this.marks.set(l,d));const g=new z(u[0],u[1],u[2]).project(t),v=Math.abs(g.x)<.98&&Math.abs(g.y)<.96&&g.z<1;d.style.display=v?"":"none";const m=Math.round((g.x+1)/2*e.width);let p=Math.round((1-g.y)/2*e.height)+(f?14:0);if(h){const E=([T,M])=>Math.abs(T-m)<5*this.tall&&Math.abs(M-p)<this.tall;for(;a.some(E);)p-=2;a.push([m,p])}d.style.left=`${m}px`,d.style.top=`${p}px`}}onCamera(t){const e=new z(...t).project(this.onboard);return e.z>1?null:[e.x,e.y]}covers(t){const e=this.items.get(t),n=e.visible,s=[n,!1].map(o=>{if(e.visible=o,this.draw(),!this.webgl)return this.renderer.pixels();const a=this.renderer.getContext(),l=new Uint8Array(a.drawingBufferWidth*a.drawingBufferHeight*4);return a.readPixels(0,0,a.drawingBufferWidth,a.drawingBufferHeight,a.RGBA,a.UNSIGNED_BYTE,l),l});e.visible=n;let r=0;for(let o=0;o<s[0].length;o+=4)(s[0][o]!==s[1][o]||s[0][o+1]!==s[1][o+1])&&(r+=1);return r}}function ub(i){i?.traverse(t=>{t.geometry?.dispose(),t.material?.dispose()}),i?.removeFromParent()}function Md(i,t){if(!i.follow.length)return i.centre_m;const e=t?Ci(i.along,t)-Ci(i.along,i.centre_m):i.start_m,n=i.share*Math.sign(i.start_m)*Math.max(i.least_m,e*Math.sign(i.start_m));return i.centre_m.map((s,r)=>s+n*yo[i.along][r])}function hb(i){return i.kind==="flat"&&i.stretch!==1?De(J.exaggerated,{axis:i.up[1],n:i.stretch}):""}const In=i=>document.getElementById(i),fb=250;class db{constructor(t){this.scene=t,this.instruments=new qm,this.commands=new Zm,this.charts=new C0,this.chartsAt=0,this.text=""}setDisplay(t){const e=JSON.stringify(t);if(e===this.text){this.scene.place(null,null,0,!1);return}this.text=e,this.display=t,this.instruments.setDisplay(t),this.commands.setDisplay(t),this.charts.setDisplay(t),Ym(t.section),In("camera").hidden=!t.camera,In("clock-pred").parentElement.hidden=!t.predicted,t.camera&&(In("camera").setAttribute("aria-label",t.camera.title),In("camera-tag").textContent=t.camera.title),In("modes").hidden=!t.modes.length;for(const n of document.querySelectorAll("[data-mode]"))n.hidden=!t.modes.includes(n.dataset.mode);In("legend").replaceChildren(...t.legend.map(({role:n,words:s,dashed:r})=>{const o=document.createElement("span");return o.className=r?"dash":"",o.style.color=be[n],o.textContent=s,o})),this.scene.setDisplay(t),In("views").replaceChildren(...t.views.map((n,s)=>{const r=document.createElement("button");return r.textContent=n.label,r.dataset.view=n.label.toLowerCase(),r.onclick=()=>this.setView(s),r})),In("views").hidden=t.views.length<2,this.setView(this.scene.chosen)}setView(t){this.scene.chosen=t,[...In("views").children].forEach((e,n)=>e.setAttribute("aria-pressed",String(n===t))),In("scale").textContent=hb(this.display.views[t])}nextView(){this.display&&this.setView((this.scene.chosen+1)%this.display.views.length)}clocks(t,e,n,s,r){const o=_i(t,this.display.measured),a=_i(t,this.display.predicted);fl("gen",o?.t,n,r),fl("rx",o?.received,s,r),fl("pred",a?.t,a?De(J.ahead,{s:pn(a.t-e,1)}):"",r)}show({run:t,frame:e,rungs:n,history:s,now:r,stale:o,until:a}){const{display:l}=this,c=_i(e,l.measured);this.instruments.show(e,o),l.section&&Km(l.section,e),this.commands.show(e),Jm(In("dial"),t,e.round_trip,c?.transit),Qm(e,c,t.step_s),dg(In("ladder"),t,l.commands.axes,n,r),Mn(In("ladder-counts"),mg(n)),this.scene.place(e,s,r,o),performance.now()-this.chartsAt>fb&&(this.chartsAt=performance.now(),this.charts.show(s.charts,e,a))}showReticle(t){this.display?.camera&&t&&tg(In("reticle"),this.scene,this.display.camera,t)}}const Ve=i=>document.getElementById(i),pb=4;class mb{constructor(t,e,n){Object.assign(this,{link:t,panels:e,back:n,on:!1,run:null,at:0,playing:!1}),Ve("review-close").onclick=()=>this.leave(),Ve("review-play").onclick=()=>this.play(!this.playing),Ve("review-time").oninput=()=>this.go(Number(Ve("review-time").value)),addEventListener("keydown",s=>{this.on&&s.key==="Escape"&&!Ve("dialog").open&&this.leave()})}async list(){try{const t=await this.link.get("api/runs");ag(t,(e,n)=>this.open(e,n))}catch(t){fu(J.review_title,t.message)}}async open(t,e){e.textContent=J.review_loading;try{this.run=await this.link.get(`api/runs/${t.split("/").map(encodeURIComponent).join("/")}`)}catch(n){e.textContent=n.message;return}hu(),this.start()}start(){const{run:t}=this;this.on=!0,this.history=new Ld(t.display,1/0);for(const e of t.frames)this.history.add(e);this.rungs=t.ladder.map(Od),Ve("scrubber").hidden=!1,Ve("bottom").hidden=!0,Ve("review-time").max=String(t.frames.length-1),this.panels.setDisplay(t.display),t.display.camera&&(Ve("camera-tag").textContent=t.display.camera.review_title),Ve("run-name").textContent=`${J.review}: ${t.name}`,this.marks(),this.go(t.frames.length-1),Ve("review-time").focus()}leave(){this.on=!1,this.playing=!1,Ve("scrubber").hidden=!0,Ve("bottom").hidden=!1,Ve("camera-tag").textContent=this.run.display.camera?.title||"",this.back()}play(t){this.playing=t,Ve("review-play").textContent=t?J.stop_play:J.play,t&&this.at>=this.run.frames.length-1&&this.go(0),this.playedAt=performance.now(),this.playedFrom=this.run.frames[this.at].t}go(t){this.at=Math.max(0,Math.min(this.run.frames.length-1,t)),Ve("review-time").value=String(this.at);const e=this.run.frames[this.at].t,n=this.run.events.filter(r=>r.t<=e),s=n[n.length-1];Ve("review-now").textContent=`${pn(e,1)} s${s&&e-s.t<5?` · ${s.text}`:""}`,Ve("review-time").setAttribute("aria-valuetext",Ve("review-now").textContent),this.playing&&(this.playedAt=performance.now(),this.playedFrom=e)}advance(){if(!this.playing)return;const t=this.playedFrom+pb*(performance.now()-this.playedAt)/1e3;let e=this.at;for(;e<this.run.frames.length-1&&this.run.frames[e].t<t;)e+=1;if(e!==this.at){const[n,s]=[this.playedAt,this.playedFrom];this.go(e),Object.assign(this,{playedAt:n,playedFrom:s})}e>=this.run.frames.length-1&&this.play(!1)}marks(){const t=Ve("review-time").getBoundingClientRect(),e=Ve("review-marks"),n=this.run.frames[this.run.frames.length-1].t||1;e.style.left=`${Ve("review-time").offsetLeft}px`,e.style.width=`${t.width}px`,e.innerHTML="";for(const s of this.run.events){const r=document.createElement("i");r.style.left=`${s.t/n*100}%`,r.title=`${pn(s.t,1)} s ${s.node}: ${s.text}`,e.append(r)}}frame(){return this.run.frames[this.at]}show(){this.advance();const{run:t}=this,e=this.frame(),n=_i(e,t.display.measured);this.banner(),this.panels.clocks(e,e.t,n?De(J.age,{s:pn(e.t-n.t,1)}):"","",!1),this.panels.show({run:t,frame:e,history:this.history,now:e.t,stale:!1,until:e.t,rungs:this.rungs.filter(s=>s.sent<=e.k).map(s=>ug(s,e.k))})}banner(){const t=Ve("banner"),e=this.at===this.run.frames.length-1&&this.run.verdict,n=e?bo(this.run.verdict.words):"";t.dataset.said!==n&&(t.dataset.said=n,t.textContent=n),t.classList.toggle("alarm",!!e&&!this.run.verdict.success)}}const gb=6e3;class _b{constructor(){this.status={phase:"idle",lease:"free",pages:0,note:""},this.can={fly:!1,desk:!1},this.connected=!1,this.display=null,this.reset(null)}reset(t){this.run=t,this.frame=null,this.frameAt=0,this.verdict=null,this.ladder=new Map,this.events=[],this.abortAt=null,t&&(this.display=t.display,this.history=new Ld(t.display,gb),this.history.begin(t.trails),this.rungs(t.ladder||[]))}take(t){switch(t.type){case"hello":this.can=t.can,t.display&&!this.display&&(this.display=t.display);break;case"run":this.reset(t);break;case"status":this.status=t;break;case"frame":this.takeFrame(t);break;case"ladder":this.rungs(t.ladder);break;case"verdict":this.verdict=t;break;case"event":this.events.push(t);break}!t.type&&t.link&&(this.connected=t.link==="open",t.why&&(this.why=t.why))}takeFrame(t){if(this.frame=t,this.frameAt=performance.now(),this.rungs(t.ladder),this.history.add(t),this.sent?.parts.kind===br&&this.abortAt===null){const e=[...this.ladder.values()].find(n=>n.kind===br);this.abortAt=(e?.sent??t.k)*this.run.step_s}}get measured(){return _i(this.frame,this.display?.measured)}get predicted(){return _i(this.frame,this.display?.predicted)}get sent(){return this.frame?.signals[this.display.commands.sent]}rungs(t){for(const e of t)this.ladder.set(e[0],Od(e));for(;this.ladder.size>700;)this.ladder.delete(this.ladder.keys().next().value)}now(){if(!this.frame)return 0;if(this.frame.paused||this.verdict||this.status.phase!=="flying")return this.frame.t;const t=(performance.now()-this.frameAt)/1e3*this.run.pace;return this.frame.t+Math.min(t,this.run.step_s)}silence(){return!this.frame||this.verdict||this.frame.paused||this.status.phase!=="flying"?0:(performance.now()-this.frameAt)/1e3}}const le=i=>document.getElementById(i),vb=1e3/30,[xb,Mb]=[60,120],Fa=1,lu=2e3;for(const i of document.querySelectorAll("[data-s]"))i.textContent=J[i.dataset.s];for(const i of document.querySelectorAll("[data-a]"))i.setAttribute("aria-label",J[i.dataset.a]);const $t=new _b,Di=new cb(le("gl"),le("view"),le("camera"),le("labels")),Kr=new db(Di);Di.enabled=!new URLSearchParams(location.search).has("plain");let Ta=-1/0,nc=0,Sd=0,yd=null,Ed=null;const Rn=new bg((i,t)=>ri?.stick(i,t)),cu=new cg(ri),Qa=new Mg(ri,$t),mi=new mb(ri,Kr,()=>hm());function Sb(i){if(i.type==="desk"){cu.show(i,$t.status.lease==="you");return}const{phase:t,lease:e}=$t.status;$t.take(i),(i.type==="run"||i.type==="hello")&&!mi.on&&hm(),i.type==="status"&&(i.phase==="starting"&&t!=="starting"&&hu(),i.phase==="ended"&&t==="closing"&&og()&&mi.list(),i.lease==="you"&&e!=="you"&&Rn.taken(),uu(),cu.lease(i.lease==="you")),i.type==="verdict"&&$t.frame&&Ed!==i&&!mi.on&&!$t.can.desk&&(Ed=i,rg(i,$t.can.fly&&$t.status.lease==="you",()=>Yu())),i.type==="event"&&(le("event").textContent=`${pn(i.t,1)} s · ${i.text}`),i.type==="reply"&&!i.ok&&(le("event").textContent=i.code?du(i.code):i.text),i.type||uu()}function hm(){const{display:i}=$t;if(i){if(Kr.setDisplay(i),Rn.setController(i.controller),cu.task={hint:i.hint,goal:i.goal},!$t.run){le("run-name").textContent="";return}le("run-name").textContent=`${$t.run.name} · ${$t.run.forward_s} s + ${$t.run.back_s} s`,le("run-name").title=le("run-name").textContent}}async function fm(){await ri.ask({do:$t.status.lease==="you"?"drop":"take"})}function dm(i){$t.frame&&Qa.steer({do:"mode",mode:i})}function pm(){$t.frame&&Qa.steer({do:$t.frame.paused?"resume":"pause"})}function mm(){const i=performance.now();i-Ta<lu?(Ta=-1/0,Qa.abort()):Ta=i,bd(),setTimeout(bd,lu+50)}function bd(){const i=performance.now()-Ta<lu;le("abort").classList.toggle("armed",i),le("abort").querySelector("small").textContent=i?J.abort_armed:J.abort_hint}function Yu(){$t.status.lease!=="you"&&ri.ask({do:"take"}),sg($t,i=>ri.ask(i))}function yb(){const i=$t.display?.modes||[];i.length&&dm(i[(i.indexOf($t.frame?.mode)+1)%i.length])}const wd={KeyT:fm,KeyP:pm,KeyX:mm,KeyN:Yu,KeyV:()=>Kr.nextView(),KeyL:()=>mi.list(),KeyG:()=>zd(Rn,$t.display),Slash:()=>Id($t.display),KeyM:yb,Equal:()=>Di.zoom(.85),Minus:()=>Di.zoom(1.18),BracketLeft:()=>Di.turn(.15,0),BracketRight:()=>Di.turn(-.15,0)};addEventListener("keydown",i=>{i.repeat||i.ctrlKey||i.metaKey||i.altKey||Bd(i.target)||le("dialog").open&&i.code!=="KeyX"||wd[i.code]&&ri&&wd[i.code]()});le("lease").onclick=fm;le("pause").onclick=pm;le("abort").onclick=mm;le("restart").onclick=Yu;le("open-review").onclick=()=>mi.list();le("open-settings").onclick=()=>zd(Rn,$t.display);le("open-help").onclick=()=>Id($t.display);for(const i of document.querySelectorAll("[data-mode]"))i.onclick=()=>dm(i.dataset.mode);function uu(){const{status:i}=$t,t=i.lease==="you";le("lease").textContent=t?J.drop:i.lease==="other"?J.taken:J.take,le("lease").disabled=i.lease==="other",le("lease").classList.toggle("primary",i.lease==="free"),le("pages").textContent=i.pages===1?J.pages_one:De(J.pages,{n:i.pages}),le("socket-state").textContent=$t.connected?`● ${J.socket_open}`:`○ ${J.socket_closed}`,le("socket-state").className=$t.connected?"ok":"alarm";for(const e of["pause","restart"])le(e).disabled=!t;for(const e of document.querySelectorAll("[data-mode]"))e.disabled=!t}function Nn(i,t,e){const n=le("banner"),s=i?`${$e(i)}${t?`<small>${$e(t)}</small>`:""}`:"";n.dataset.said!==s&&(n.dataset.said=s,n.innerHTML=s),n.classList.toggle("alarm",!!e)}function Eb(i){const{status:t,frame:e,run:n,verdict:s}=$t,r=Qa.words();if(r)Nn(...r,!0);else if(!$t.connected&&ri)Nn(J.socket_closed,"",!0);else if(t.phase==="idle")Nn(J.idle,J.idle_text);else if(t.phase==="starting")Nn(J.starting,t.run||"");else if(t.note==="failed")Nn(J.run_failed,"",!0);else if(i>Fa)Nn(De(J.stale_frames,{s:i.toFixed(0)}),"",!0);else if($t.abortAt!==null&&!s&&e){const o=[...$t.ladder.values()].some(hg),a=$t.display.abort,l=e.t-$t.abortAt,c=l>n.forward_s+n.back_s+2*n.step_s+Fa;o?Nn(a?De(J.aborted_so,{does:a}):J.aborted,"",!0):c?Nn(J.abort_untold,De(J.abort_untold_hint,{s:l.toFixed(0)}),!0):Nn(De(J.abort_sent,{s:Math.max(0,n.forward_s-l).toFixed(0)}),"",!0)}else t.pilot_lost?Nn(J.pilot_lost,"",!0):e?.paused?Nn(J.paused,""):e&&!$t.measured&&t.phase==="flying"?Nn(J.no_telemetry,De(J.first_in,{s:Math.max(0,n.back_s-e.t).toFixed(0)})):s?Nn(bo(s.words),"",!s.success):Nn("")}function bb(){const i=$t.status.lease==="you",t=Rn.state().held,e=Rn.stuck(),n=i?Rn.axes.length?Rn.gone()?J.stick_gone:e.length?De(J.stick_stuck,{axes:e.join(", ")}):t?`${J.stick_held} · ${J[Rn.source]}`:J.stick_open:J.stick_none:J.stick_watch;Mn(le("stick-state"),n),le("stick-state").className=i?t&&!e.length?"ok":"alarm":"dim";const s=$t.display?.controller?.step_name;Mn(le("step"),i&&Rn.source==="keyboard"&&Rn.deflections.length>1?`${s} ${Rn.step}`:"")}function wb(){const i=[Di.webgl?"":J.no_webgl,Td?"":J.no_storage,Rn.axes.length?J.pad_notes[Rn.lacks()]:""];Mn(le("notes"),i.filter(Boolean).join(" · ")),le("notes").title=le("notes").textContent}function Tb(i,t){const{run:e,measured:n}=$t,s=n?t-n.t:null,r=s!==null&&s>e.back_s+Fa*Math.max(e.pace,1);return Kr.clocks(i,t,s===null?"":De(J.age,{s:pn(s,1)}),n?De(J.ago,{s:pn(Math.max(t-n.received,0),1)}):"",r),r}function Ab(){const{frame:i,run:t,history:e}=$t,n=$t.silence();Eb(n),bb(),wb(),Mn(le("pause"),i?.paused?J.resume:J.pause);for(const o of document.querySelectorAll("[data-mode]"))o.setAttribute("aria-pressed",String(o.dataset.mode===(i?.mode||t?.mode)));if(!t||!i)return;const s=$t.now(),r=Tb(i,s)||n>Fa||!$t.connected;document.body.classList.toggle("stale",r),Kr.show({run:t,frame:i,history:e,rungs:[...$t.ladder.values()],now:s,stale:r})}function gm(i){if(requestAnimationFrame(gm),i-nc<vb-2)return;Di.adapt(i-nc),nc=i;const t=i-Sd>($t.frame===yd&&!mi.on?Mb:xb);t&&(Sd=i,yd=$t.frame,mi.on?mi.show():Ab()),Di.draw(),t&&Kr.showReticle(mi.on?mi.frame():$t.frame)}uu();ri?ri.listen(Sb):fu(J.no_token_title,J.no_page_token);requestAnimationFrame(gm);window.rvd={store:$t,scene:Di,stick:Rn,review:mi,link:ri};
