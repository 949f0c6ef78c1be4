import{l as Fn}from"./index.js";const Te={measured:"#7cc4ff",predicted:"#ffb652",truth:"#f2f5f8",target:"#dbe5ee",plain:"#dbe5ee",pilot:"#7cc4ff",automatic:"#d59bf6",sent:"#56d6b0",limit:"#8aa4bd",guide:"#b9c2a0",goal:"#56d6b0",ok:"#56d6b0",alarm:"#ff7a5c",dim:"#8fa1b3",line:"#263544",text:"#dbe5ee"},Ua=!new URLSearchParams(location.search).has("fine")&&/swiftshader|llvmpipe|softpipe|software|basic render/i.test(Sm());function Sm(){const n=document.createElement("canvas").getContext("webgl2");if(!n)return"";const t=n.getExtension("WEBGL_debug_renderer_info"),e=String(n.getParameter(t?t.UNMASKED_RENDERER_WEBGL:n.RENDERER));return n.getExtension("WEBGL_lose_context")?.loseContext(),e}function _i(n,t){n.textContent!==t&&(n.textContent=t)}const jl=new Map;let ma=12;const ym=new ResizeObserver(n=>n.forEach(({target:t})=>md(t)));function md(n){const{width:t,height:e}=n.getBoundingClientRect();jl.set(n,{w:t,h:e}),ma=parseFloat(getComputedStyle(document.documentElement).fontSize)}function Ia(n){jl.has(n)||(md(n),ym.observe(n));const{w:t,h:e}=jl.get(n),i=Math.min(devicePixelRatio||1,2),s=Math.max(1,Math.round(t*i)),r=Math.max(1,Math.round(e*i));(n.width!==s||n.height!==r)&&Object.assign(n,{width:s,height:r});const o=n.getContext("2d",{willReadFrequently:Ua});return o.setTransform(i,0,0,i,0,0),o.clearRect(0,0,t,e),o.font=`${.74*ma}px system-ui, sans-serif`,o.lineWidth=ma/12,{pen:o,w:t,h:e,rem:ma}}function gd(n,t,e,i,s,r){n.strokeStyle=s,n.setLineDash(r||[]),n.beginPath(),n.arc(t,e,Math.max(i,0),0,7),n.stroke(),n.setLineDash([])}function ni(n,t,e,i,s,r="left",o="middle"){n.fillStyle=s,n.textAlign=r,n.textBaseline=o,n.fillText(t,e,i)}const ot={title:"RVD console",clocks:"Three clocks",clock_generated:"generated on board",clock_received:"received on the ground",clock_predicted:"predicted for",modes:"Who decides",mode_manual:"Manual",mode_shared:"Shared",mode_auto:"Auto",pause:"Pause",resume:"Resume",abort:"ABORT",abort_hint:"X twice",abort_armed:"again: ABORT",instruments:"Instruments",columns:{measured:"measured",predicted:"predicted",truth:"truth",plain:""},limit:"limit",weight:"pilot weight",scene:"Scene",views:"Views",camera_side:"Camera, delay and charts",ladder:"Command ladder",ladder_alt:"Commands on their way to the craft and back",ladder_ground:"ground",ladder_link:"on the link",ladder_craft:"at the craft",ladder_back:"telemetry on its way back",ladder_known:"known",round_trip:"Round trip",dial_alt:"Dial of the round trip",restart:"New run",review:"Review",settings:"Stick",help:"Help",stop:"Stop run",review_close:"Leave review",play:"Play",stop_play:"Stop",scrub:"Instant of the review",review_title:"Review a run",review_none:"No finished runs here yet.",review_loading:"Reading the bag…",review_open:"Open",take:"Take the stick",drop:"Release the stick",taken:"Another page has the stick",stick_yours:"You have the stick",stick_held:"stick live",stick_open:"DEAD-MAN OPEN: automatic alone flies",stick_watch:"watching",stick_none:"you are in charge",keyboard:"keyboard",gamepad:"gamepad",pages_one:"1 page",pages:"{n} pages",of:"of",socket_open:"connected",socket_closed:"NOT CONNECTED",idle:"Ready",idle_text:"Take the stick (T), then start a run (N).",starting:"The graph is coming up…",paused:"PAUSED",stale:"STALE",no_telemetry:"no telemetry yet",first_in:"first telemetry in {s} s",pilot_lost:"PILOT LOST: the automatic half flies alone",stale_frames:"NO DATA FOR {s} s",aborted:"ABORT in force",aborted_so:"ABORT in force: {does}",abort_sent:"ABORT sent, acting in about {s} s",run_failed:"The run could not be flown: see the terminal",verdict_title:"Verdict",verdict_time:"time",fly_again:"Fly again (N)",close:"Close",cancel:"Cancel",start:"Start",seed:"seed",mode:"mode",seed_hint:"empty: the next one",new_run:"New run",new_run_text:"A new run in a new folder. A run under way is stopped.",no_fly:"This console belongs to one run; start it with ./rvd fly --operator console to fly again.",no_page_token:"This page needs the token of the address that the console printed.",no_token_title:"No token",exaggerated:"{axis} scale × {n}",link:{transit:"transit",p99:"p99",lost:"lost",late:"late",corrupted:"damaged",gap:"last gap"},age:"age {s} s",ago:"{s} s ago",ahead:"in {s} s",now:"now",settings_title:"The stick",settings_dead_zone:"dead zone",settings_axis:"axis",settings_invert:"inverted",settings_button:"dead-man button",settings_space:"keyboard: hold Space as dead-man",settings_none:"No gamepad seen. Press a button on it.",settings_found:"Gamepad: {name}",help_title:"Keys",help_step:"{name} of the keys",or:"or",review_truth:"Review shows the truth. It never reaches this page while a run is flown.",unknown:"–",desk:{door:"Which volunteer? Enter the number you were given; no name is asked or kept.",volunteer:"volunteer number",begin:"Begin",heading:"{who}, flight {n} of {of}",training:"Training: this flight does not count.",counts:"This flight counts.",condition:"Control: {mode}",clock:"The clock starts when the graph is up.",fly:"Start the flight",rest_title:"A break",rest:"Rest your eyes and hands.",go_on:"Go on",done_title:"Finished",done:"Thank you, {who}. All flights are flown and rated.",next:"Next volunteer",yes:"Yes",no:"No",again:"Answer again",pick:"Pick the sentence that fits best.",save:"Save the ratings",weigh:"Which of the two contributed more to the workload of flying in this way?",pair:"pair {n} of {of}",tree:{controllable:"Was the craft controllable?",adequate:"Was adequate performance ({goal}) attainable with a tolerable pilot workload?",satisfactory:"Was it satisfactory without improvement?"},ratings:["","Excellent, highly desirable: compensation not a factor","Good, negligible deficiencies: compensation not a factor","Fair, some mildly unpleasant deficiencies: minimal compensation","Minor but annoying deficiencies: moderate compensation","Moderately objectionable deficiencies: considerable compensation","Very objectionable but tolerable deficiencies: extensive compensation","Major deficiencies: adequate performance not attainable with maximum tolerable compensation","Major deficiencies: considerable compensation needed for control","Major deficiencies: intense compensation needed to retain control","Major deficiencies: control lost during some part of the flight"],tlx:{mental:["Mental demand","How mentally demanding was the flight?","very low","very high"],physical:["Physical demand","How physically demanding was the flight?","very low","very high"],temporal:["Temporal demand","How hurried or rushed was the pace?","very low","very high"],performance:["Performance","How successful were you in doing what you were asked to do?","perfect","failure"],effort:["Effort","How hard did you have to work for your level of performance?","very low","very high"],frustration:["Frustration","How insecure, discouraged, irritated, stressed and annoyed were you?","very low","very high"]},errors:{VOLUNTEER:"A whole number from 1 to 999, please.",STAGE:"Not now.",RATING:"The rating is incomplete.",TLX:"Please set every scale.",WEIGHTS:"Please choose in every pair."}}},Em=[["T","take or release the stick"],["Space","dead-man, if so chosen under Stick"],["M","{modes} in turn"],["P","pause, resume"],["X X","ABORT, past every buffer{abort}"],["N","new run"],["V","next view"],["L","review a run"],["G","stick settings"],["?","this list"],["Esc","close"],["","A key that comes up is zero. Without focus, without this page, or with the dead-man open, the pilot is lost and the automatic half flies alone."]],bm={ArrowUp:"↑",ArrowDown:"↓",ArrowLeft:"←",ArrowRight:"→"},Tm=["nobody","pilot","automatic","blend","guard"],ah=["","nothing due","wrong length","checksum","out of order","too old","out of range","an input was missing","as the mode says","stick invalid: automatic alone","automatic invalid: counts as neutral","neither valid: neutral","ABORT in force"],wm=["sent","due","executed","effect seen","refused","missed","unknown"],Am={LEASE:"Take the stick first (T).",TAKEN:"Another page has the stick.",NO_RUN:"No run is under way.",NO_FLY:ot.no_fly,DESK:"The session says what is flown.",MODE:"No such mode.",SEED:"The seed must be a whole number."};function tn(n,t){return n.replace(/\{(\w+)\}/g,(e,i)=>t[i])}const Mo={"+x":[1,0,0],"-x":[-1,0,0],"+y":[0,1,0],"-y":[0,-1,0],"+z":[0,0,1],"-z":[0,0,-1]};function mi(n,t){const e=n?.signals[t];return e?.ok?e:void 0}function wr(n,t){return t?mi(n,t.signal)?.parts[t.part]??void 0:void 0}const _d=(n,t)=>Array.isArray(n)?n[t]:n;function Di(n,{signal:t,part:e,index:i,factor:s}){const r=mi(n,t)?.parts[e];if(r==null)return;const o=i.map(a=>_d(r,a));if(!o.some(a=>a==null))return s*(o.length===1?o[0]:Math.hypot(...o))}function Ar(n,t){return t!==null&&typeof t=="object"?Di(n,t):t??void 0}function vd(n,t="xyz"){if(n==null)return;const e=[0,0,0];for(let i=0;i<t.length;i+=1){const s=_d(n,i);if(s==null)return;e["xyz".indexOf(t[i])]=s}return e}function Ui(n,t,e){return Array.isArray(t)?t:vd(wr(n,t),e)}function Ci(n,t){const e=Mo[n];return e[0]*t[0]+e[1]*t[1]+e[2]*t[2]}class xd{constructor(t,e){this.display=t,this.keep=e,this.trails=new Map;for(const i of t?.lines||[])i.kind==="trail"&&this.trails.set(i.name,[]);this.charts=(t?.charts?.strips||[]).map(i=>({t:[],curves:i.curves.map(()=>[]),spread:[]}))}begin(t){for(const e of this.display.lines)for(const i of t?.[e.name]||[]){const s=vd(i.slice(2,-1),e.axes);s&&this.trails.get(e.name).push([i[0],i[1],...s,i[i.length-1]??0])}}add(t){for(const e of this.display.lines)e.kind==="trail"&&this.extend(e,t);this.display.charts?.strips.forEach((e,i)=>this.plot(e,this.charts[i],t))}extend(t,e){const i=this.trails.get(t.name),s=Ui(e,t.place,t.axes);if(!s||i.length&&e.t<=i[i.length-1][0])return;const r=t.spread?Di(e,t.spread)??0:0;i.push([e.t,e.signals[t.place.signal].t,...s,r]),i.length>this.keep&&i.shift()}plot(t,e,i){const s=mi(i,t.curves[0].signal);if(!s||s.t<=(e.t[e.t.length-1]??-1/0))return;e.t.push(s.t),t.curves.forEach((o,a)=>e.curves[a].push(Di(i,o)??null));const r=t.spread?Di(i,t.spread):void 0;e.spread.push(r===void 0?null:r*t.spread_factor)}}function Rm(n,t,e,i,s){let r=t.length;for(;r>0&&t[r-1][0]>i;)r-=1;if(!n.since)return{rows:t,at:2,n:r};const o=mi(e,n.since.signal),a=Ui(e,n.place,n.axes),l=Ui(e,n.since,n.axes);if(!o||!a||!l)return{rows:[],at:0,n:0};let c=r;for(;c>0&&t[c-1][1]>o.t;)c-=1;const u=[[...l,n.since_spread?Di(e,n.since_spread)??0:0]],h=Math.max(1,Math.floor((r-c)/s));for(let f=c;f<r;f+=h)u.push(t[f].slice(2));return u.push([...a,n.spread?Di(e,n.spread)??0:0]),{rows:u,at:0,n:u.length}}const Ke=n=>document.getElementById(n),Cm=4,Pm=["measured","predicted","truth","plain"];function mn(n,t){return n==null||!Number.isFinite(n)?ot.unknown:n.toFixed(t).replace("-","−")}const Io=(n,t,e)=>typeof n=="number"?String(n).replace("-","−"):mn(t,e);function Md(n,{low:t,high:e},i){const[s,r]=[Ar(n,t),Ar(n,e)];return s===void 0&&r===void 0?"":r===void 0?`> ${Io(t,s,i)}`:s===void 0?`< ${Io(e,r,i)}`:`${Io(t,s,i)}…${Io(e,r,i)}`}class Lm{setDisplay(t){const e=t.instruments;if(Ke("instruments").hidden=!e,this.rows=[],!e)return;Ke("instruments-title").textContent=e.title;const i=Pm.filter(r=>e.rows.some(o=>o.readings.some(a=>a.role===r)));Ke("instruments").style.setProperty("--columns",i.length);const s=Jn("div","head");s.append(...[["",""],...i.map(r=>[ot.columns[r],r]),["",""],[ot.limit,"dim"]].map(([r,o])=>Jn("span",o,r))),Ke("instruments-rows").replaceChildren(s,...e.rows.map(r=>{const o=Jn("div","row"),a=new Map(i.map(c=>[c,Jn("b",c)])),l=Jn("u");return o.append(Jn("span","",r.label),...a.values(),Jn("u","unit",r.unit),l),this.rows.push({row:r,cells:a,limit:l}),o}))}show(t,e){for(const{row:i,cells:s,limit:r}of this.rows){let o="";for(const a of i.readings){const l=Di(t,a.value),c=s.get(a.role);_i(c,mn(l,i.digits)),c.classList.toggle("stale-value",e&&a.role==="measured"),c.classList.toggle("bad",l<=Ar(t,a.low)||l>=Ar(t,a.high)),o=Md(t,a,i.digits)||o}_i(r,o)}}}function Jn(n,t="",e=""){const i=document.createElement(n);return t&&(i.className=t),i.textContent=e,i}function Dm(n){Ke("cut").hidden=!n,n&&(Ke("section-title").textContent=n.title,Ke("section").setAttribute("aria-label",n.alt),Ke("foot").hidden=!n.foot,n.foot&&(Ke("foot-label").textContent=n.foot.label))}const Sd={dot(n,t,e,i,s){n.fillStyle=i,n.beginPath(),n.arc(t,e,s*.3,0,7),n.fill()},ring(n,t,e,i,s,r){n.fillStyle=`${i}30`,n.beginPath(),n.arc(t,e,Math.max(s*.3,r),0,7),n.fill(),n.stroke()},cross(n,t,e,i,s){const r=s*.32;n.beginPath(),n.moveTo(t-r,e-r),n.lineTo(t+r,e+r),n.moveTo(t-r,e+r),n.lineTo(t+r,e-r),n.stroke()},square(n,t,e,i,s){n.strokeRect(t-s*.35,e-s*.35,s*.7,s*.7)}};function Um(n,t){const{pen:e,w:i,h:s,rem:r}=Ia(Ke("section")),[o,a]=[i/2,s/2],l=Math.min(i,s)/2-.9*r;e.strokeStyle=Te.line,e.beginPath(),e.moveTo(o-l,a),e.lineTo(o+l,a),e.moveTo(o,a-l),e.lineTo(o,a+l),e.stroke(),Zl(n.note?wr(t,n.note):["",!1],Ke("section-note"),"dim"),n.foot&&Zl(wr(t,n.foot.words),Ke("foot-words"));const c=Ar(t,n.extent_m);if(!c)return;const u=l/c;for(const f of n.rings){const d=Ar(t,f.radius_m);d!==void 0&&(gd(e,o,a,d*u,Te[f.role],f.dashed?[r*.3,r*.25]:null),f.written&&ni(e,`${d.toFixed(2)} m`,o+d*u*.72,a-d*u*.72-r*.3,Te[f.role]))}ni(e,lh(n.up),o+r*.3,a-l,Te.dim),ni(e,lh(n.right),o+l,a-r*.6,Te.dim,"right");const h=f=>[o+Ci(n.right,f)*u,a-Ci(n.up,f)*u];for(const f of n.spots){const d=Ui(t,f.place);if(!d)continue;const g=Te[f.role],[v,m]=h(d);e.strokeStyle=g;const p=f.origin&&Ui(t,f.origin);p&&(e.setLineDash([r*.2,r*.2]),e.beginPath(),e.moveTo(...h(p)),e.lineTo(v,m),e.stroke(),e.setLineDash([])),Sd[f.mark](e,v,m,g,r,f.spread?(Di(t,f.spread)??0)*u:0);const E=f.rate&&Ui(t,f.rate);if(E){const w=f.ahead_s*u;e.beginPath(),e.moveTo(v,m),e.lineTo(v+Ci(n.right,E)*w,m-Ci(n.up,E)*w),e.stroke()}}}const lh=n=>n.replace("+","").replace("-","−");function Zl(n,t,e=""){const[i,s]=n||[ot.unknown,!1];_i(t,i),t.className=s?"alarm":e}function Im(n,t){const e=n.toFixed(t).replace("-","−");return n>0?`+${e}`:e}function Nm(n){const t=Jn("div","bar");return t.append(document.createElement("i"),document.createElement("span")),t.firstChild.style.background=n,t}class Fm{setDisplay({commands:t}){this.commands=t,Ke("commands-title").textContent=t.unit?`${t.title}, ${t.unit}`:t.title;const e=t.axes.map(r=>Jn("span","dim",r.name)),i=t.rows.map(r=>Jn("span",r.role==="automatic"?"auto":"",r.label));this.rows=t.rows.map(r=>({row:r,bars:t.axes.map(()=>Nm(Te[r.role]))}));const s=e.length<=Cm?[[Jn("span"),...e],...this.rows.map(({bars:r},o)=>[i[o],...r])]:[[Jn("span"),...i],...e.map((r,o)=>[r,...this.rows.map(({bars:a})=>a[o])])];Ke("bars").style.setProperty("--columns",s[0].length-1),Ke("bars").replaceChildren(...s.flat())}show(t){const e=t.signals[this.commands.sent];for(const{row:s,bars:r}of this.rows){const a=(s.value.signal===this.commands.sent?e:mi(t,s.value.signal))?.parts[s.value.part];this.commands.axes.forEach((l,c)=>this.bar(r[c],a?.[c]??null,l.highest))}const i=e?[Tm[e.parts.by]]:[];e&&e.parts.weight!==null&&e.parts.by===3&&i.push(`${ot.weight} ${e.parts.weight}`),e&&ah[e.parts.reason]&&i.push(ah[e.parts.reason]),_i(Ke("why"),i.join(" · "))}bar(t,e,i){const s=Math.min(Math.abs(e||0)/i,1)*48;t.firstChild.style.left=`${e<0?50-s:50}%`,t.firstChild.style.width=`${s}%`,_i(t.lastChild,e===null?ot.unknown:Im(e,this.commands.digits))}}function al(n,t,e,i){const s=Ke(`clock-${n}`);_i(s,t===void 0?ot.unknown:`${mn(t,1)} s`),_i(Ke(`clock-${n}-age`),e),s.parentElement.classList.toggle("stale",!!i)}function Om(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=Ia(n),[l,c,u]=[r/2,o*.56,Math.min(r/2,o*.56)-a*.5],h=t.forward_s+t.back_s,f=Math.max(h*1.5,1),d=v=>Math.PI*(.8+1.4*Math.max(0,Math.min(1,v/f)));s.lineWidth=a*.45,s.strokeStyle="#1b2733",s.beginPath(),s.arc(l,c,u,d(0),d(f)),s.stroke(),e!==void 0&&(s.strokeStyle=e>h+1?Te.alarm:Te.measured,s.beginPath(),s.arc(l,c,u,d(0),d(e)),s.stroke()),i&&(s.lineWidth=a*.16,s.strokeStyle=Te.guide,s.beginPath(),s.arc(l,c,u-a*.5,d(0),d(i)),s.stroke()),s.strokeStyle=Te.text,s.lineWidth=a*.12;const g=d(h);s.beginPath(),s.moveTo(l+(u-a*.4)*Math.cos(g),c+(u-a*.4)*Math.sin(g)),s.lineTo(l+(u+a*.4)*Math.cos(g),c+(u+a*.4)*Math.sin(g)),s.stroke(),s.font=`600 ${1.35*a}px system-ui, sans-serif`,ni(s,e===void 0?ot.unknown:`${e.toFixed(1)} s`,l,c-a*.05,Te.text,"center"),s.font=`${.7*a}px system-ui, sans-serif`,ni(s,`${t.forward_s} + ${t.back_s} s`,l,c+a*1.05,Te.dim,"center")}function km(n,t,e){const{link:i,gap:s}=n,r=[[ot.link.transit,t?`${mn(t.transit,2)} s`:ot.unknown]];i&&r.push([ot.link.p99,`${mn(i.delay_p99,2)} s`],[ot.link.lost,i.lost+i.outage],[ot.link.late,i.late],[ot.link.corrupted,i.corrupted]),r.push([ot.link.gap,s?tn(ot.ago,{s:mn((n.k-s.k)*e,0)}):ot.unknown]);const o=r.map(([a,l])=>`<dt>${a}</dt><dd>${l}</dd>`).join("");Ke("link-counts").innerHTML!==o&&(Ke("link-counts").innerHTML=o)}function Bm(n,t,e,i){const{pen:s,w:r,h:o,rem:a}=Ia(n),[l,c]=[r/2,o/2];s.strokeStyle="#dbe5ee90",s.beginPath(),s.moveTo(l-r*.3,c),s.lineTo(l-a,c),s.moveTo(l+a,c),s.lineTo(l+r*.3,c),s.moveTo(l,c-o*.36),s.lineTo(l,c-a),s.moveTo(l,c+a),s.lineTo(l,c+o*.36);for(let d=-3;d<=3;d+=1)d&&(s.moveTo(l+d*r*.1,c-a*.25),s.lineTo(l+d*r*.1,c+a*.25));s.stroke();const u=t.known(e.carried_by);if(!u)return;const h=u.item.role==="truth";for(const d of e.marks){const g=Ui(i,d.at),v=g&&!(h&&d.role==="predicted")&&t.onCamera(g);if(!v)continue;const m=Te[d.role],[p,E]=[l+v[0]*r/2,c-v[1]*o/2];if(s.strokeStyle=m,d.radius_m===null){Sd.square(s,p,E,m,a);continue}const w=Math.max(Ci(e.look,g)-Ci(e.look,u.at),.05);gd(s,p,E,Math.min(d.radius_m/w/t.cameraTan*(o/2),o),m),s.strokeStyle=`${m}80`,s.beginPath(),s.moveTo(l,c),s.lineTo(p,E),s.stroke()}e.gauge&&zm(s,r,o,a,e.gauge,i,h);const f=e.distance.map(d=>Di(i,d.value)).find(d=>d!==void 0);f!==void 0&&ni(s,`${mn(f,e.digits)} ${e.unit}`,a*.6,o-a*.9,Te.measured)}function zm(n,t,e,i,s,r,o){const[a,l,c]=[t-i*2.9,i*1.5,e-i*1.2],{low:u,high:h}=s,f=d=>c-(Math.max(u,Math.min(h,d))-u)/(h-u)*(c-l);n.strokeStyle="#dbe5eea0",n.beginPath(),n.moveTo(a,l),n.lineTo(a,c);for(let d=0;u+d*s.tick<=h+1e-9;d+=1){const g=f(u+d*s.tick),v=d%s.long_ticks===0;n.moveTo(a,g),n.lineTo(a+i*(v?.5:.25),g),v&&ni(n,mn(u+d*s.tick,s.digits),a+i*.65,g,Te.text)}n.stroke(),s.limit!==null&&(n.strokeStyle=Te.alarm,n.beginPath(),n.moveTo(a-i*.5,f(s.limit)),n.lineTo(a+i*.5,f(s.limit)),n.stroke());for(const{role:d,value:g}of s.readings){const v=Di(r,g);if(v===void 0||o&&d!=="truth")continue;const m=f(v),p=Te[d==="truth"?"measured":d];n.beginPath(),n.moveTo(a-i*.1,m),n.lineTo(a-i*.75,m-i*.36),n.lineTo(a-i*.75,m+i*.36),n.closePath(),d==="predicted"?(n.strokeStyle=p,n.stroke()):(n.fillStyle=p,n.fill())}ni(n,s.unit,a,l-i*.7,Te.dim,"center")}const go=()=>document.getElementById("dialog");function Gs(n,t){const e=go();e.innerHTML=n,e.open||e.showModal();for(const i of e.querySelectorAll("[data-close]"))i.onclick=()=>e.close();return t&&t(e),e}function iu(){go().open&&go().close()}const So=`<button data-close>${ot.close}</button>`;function Xe(n){const t=document.createElement("span");return t.textContent=n,t.innerHTML}function su(n,t){Gs(`<h3>${Xe(n)}</h3><p>${Xe(t)}</p><div class="buttons">${So}</div>`)}const Hm=n=>bm[n]||n.replace(/^Key/,"");function Vm(n){const t=n?.controller,e=(t?.axes||[]).map(s=>[s.keys.map(r=>r.map(Hm).join(" / ")).join(` ${ot.or} `),`${t.verb} ${s.positive} / ${s.negative} (${s.name})`]),i=t?.key_deflections.length||0;return i>1&&e.push([Array.from({length:i},(s,r)=>r+1).join(" "),tn(ot.help_step,{name:t.step_name})]),e}function yd(n){const t=(n?.modes||[]).map(a=>ot[`mode_${a}`].toLowerCase()).join(", "),e=n?.abort?`: ${n.abort}`:"",[[i,s],...r]=Em.map(([a,l])=>[a,tn(l,{modes:t,abort:e})]),o=[[i,s],...Vm(n),...r].map(([a,l])=>a?`<tr><td><kbd>${Xe(a)}</kbd></td><td>${Xe(l)}</td></tr>`:`<tr><td colspan="2">${Xe(l)}</td></tr>`);Gs(`<h3>${ot.help_title}</h3><table>${o.join("")}</table><div class="buttons">${So}</div>`)}function ru(n){return Am[n]||n}function Gm(n,t){if(!n.can.fly){su(ot.new_run,ot.no_fly);return}const e=n.display?.modes||[],i=n.frame?.mode||n.run?.mode||"shared",s=e.map(r=>`<option value="${r}" ${r===i?"selected":""}>${ot[`mode_${r}`]}</option>`);Gs(`<h3>${ot.new_run}</h3><p>${ot.new_run_text}</p>
    <p>${e.length?`<label>${ot.mode} <select id="new-mode">${s.join("")}</select></label> &nbsp;`:""}
    <label>${ot.seed} <input id="new-seed" size="8" inputmode="numeric" placeholder="${ot.seed_hint}"></label></p>
    <p id="new-error" class="alarm"></p>
    <div class="buttons"><button data-close>${ot.cancel}</button><button class="primary" id="new-start">${ot.start}</button></div>`,r=>{const o=async()=>{const a=r.querySelector("#new-seed").value.trim(),l={do:"fly",mode:r.querySelector("#new-mode")?.value??null};a&&(l.seed=Number(a));const c=await t(l);c.ok?r.close():r.querySelector("#new-error").textContent=ru(c.code)};r.querySelector("#new-start").onclick=o,r.querySelector("#new-seed").onkeydown=a=>{a.key==="Enter"&&o()},r.querySelector("#new-start").focus()})}function Wm(n,t,e){const i=n.success,s=(o,a,l,c)=>`<tr><th>${Xe(o)}</th><td class="${c===!1?"alarm":""}">${Xe(a)}</td><td class="dim">${Xe(l)}</td></tr>`,r=n.measures.filter(o=>o.value!==null).map(o=>s(o.words,`${mn(o.value,o.digits)} ${o.unit}`,Md(null,o,o.digits),o.ok));Gs(`<h3>${ot.verdict_title}</h3>
    <p class="verdict ${i?"ok":"alarm"}" id="verdict-words">${i?"✓":"✗"} ${Xe(yo(n.words))}</p>
    <table>${s(ot.verdict_time,`${mn(n.duration,1)} s`,"",null)}${r.join("")}</table>
    <div class="buttons">${So}${t?`<button class="primary" id="again">${ot.fly_again}</button>`:""}</div>`,o=>{const a=o.querySelector("#again");a&&(a.onclick=()=>{o.close(),e()})})}function Ed(n){const t=n.settings,e=i=>{const{axis:s,sign:r}=n.wiring(i);return`<tr><td>${Xe(`${i.positive} / ${i.negative}`)}</td>
    <td><label>${ot.settings_axis} <input type="number" class="short" min="0" max="15" data-axis="${i.name}" value="${s}"></label></td>
    <td><label><input type="checkbox" data-invert="${i.name}" ${r<0?"checked":""}> ${ot.settings_invert}</label></td></tr>`};Gs(`<h3>${ot.settings_title}</h3><p id="pad-name">${n.gamepad?Xe(tn(ot.settings_found,{name:n.gamepad.id})):ot.settings_none}</p>
    <table>${n.axes.map(e).join("")}</table>
    <p><label>${ot.settings_button} <input type="number" class="short" min="0" max="31" id="pad-button" value="${t.button}"></label></p>
    <p><label>${ot.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${t.deadZone}"></label></p>
    <p><label><input type="checkbox" id="hold-space" ${t.holdSpace?"checked":""}> ${ot.settings_space}</label></p>
    <div class="buttons">${So}</div>`,i=>{i.onchange=()=>{const s=({name:r})=>[r,{axis:Number(i.querySelector(`[data-axis="${r}"]`).value),sign:i.querySelector(`[data-invert="${r}"]`).checked?-1:1}];n.change({axes:{...t.axes,...Object.fromEntries(n.axes.map(s))},button:Number(i.querySelector("#pad-button").value),deadZone:Number(i.querySelector("#pad-zone").value),holdSpace:i.querySelector("#hold-space").checked})}})}function Xm(){return go().open&&go().querySelector("#runs")!==null}const yo=n=>n.charAt(0).toUpperCase()+n.slice(1);function $m(n,t){const e=n.map(i=>`<tr><td>${Xe(i.name)}</td><td>${Xe(i.mode||"")}</td>
    <td class="${i.success?"ok":""}">${i.success?"✓":"✗"} ${Xe(yo((i.reason||"").replaceAll("_"," ")))}</td>
    <td><button data-run="${Xe(i.name)}">${ot.review_open}</button></td></tr>`);Gs(`<h3 id="runs">${ot.review_title}</h3><p class="dim">${ot.review_truth}</p>
    ${n.length?`<table>${e.join("")}</table>`:`<p>${ot.review_none}</p>`}
    <p id="review-error" class="alarm"></p><div class="buttons">${So}</div>`,i=>{for(const s of i.querySelectorAll("[data-run]"))s.onclick=()=>t(s.dataset.run,i.querySelector("#review-error"))})}const ye=ot.desk,qm=5;class Ym{constructor(t){this.link=t,this.task={hint:"",goal:""},this.state=null,this.mine=!1}show(t,e){const i=!this.state||JSON.stringify({...this.state,rest_s:0})!==JSON.stringify({...t,rest_s:0});this.state=t,this.mine=e,i&&this.draw()}lease(t){t!==this.mine&&(this.mine=t,this.state&&this.draw())}draw(){if(clearInterval(this.timer),!this.mine)return;const t=this.state.stage;t==="flying"?iu():this[t]()}async ask(t,e,i){const s=await this.link.ask({do:"desk",act:t,...e}),r=i?.querySelector(".error");return!s.ok&&r&&(r.textContent=ye.errors[s.code]||ru(s.code)),s.ok}frame(t,e,i,s){const r=Gs(`<h3>${Xe(t)}</h3>${e}<p class="error alarm" role="alert"></p><div class="buttons">${i}</div>`,s);return r.oncancel=o=>o.preventDefault(),r}door(){this.frame(this.state.title,`<p>${ye.door}</p><p><label>${ye.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,`<button class="primary" id="desk-go">${ye.begin}</button>`,t=>{const e=()=>this.ask("begin",{volunteer:Number(t.querySelector("#volunteer").value)},t);t.querySelector("#desk-go").onclick=e,t.querySelector("#volunteer").onkeydown=i=>{i.key==="Enter"&&e()},t.querySelector("#volunteer").focus()})}heading(){return tn(ye.heading,{who:this.state.who,n:this.state.number,of:this.state.of})}ready(){const t=this.state.training?ye.training:ye.counts;this.frame(this.heading(),`<p>${t}</p><p>${tn(ye.condition,{mode:ot[`mode_${this.state.mode}`]})}</p><p class="dim">${Xe(this.task.hint)} ${ye.clock}</p>`,`<button class="primary" id="desk-go">${ye.fly}</button>`,e=>{e.querySelector("#desk-go").onclick=()=>this.ask("fly",{},e),e.querySelector("#desk-go").focus()})}rest(){const t=performance.now()+this.state.rest_s*1e3;this.frame(ye.rest_title,`<p>${ye.rest}</p><p class="verdict" id="rest-left"></p>`,`<button class="primary" id="desk-go">${ye.go_on}</button>`,e=>{const i=e.querySelector("#desk-go");i.onclick=()=>this.ask("go_on",{},e);const s=()=>{const r=Math.max(0,(t-performance.now())/1e3);e.querySelector("#rest-left").textContent=`${r.toFixed(0)} s`,i.disabled=r>0};s(),this.timer=setInterval(s,500)})}done(){this.frame(ye.done_title,`<p>${tn(ye.done,{who:this.state.who})}</p>`,`<button id="desk-go">${ye.next}</button>`,t=>{t.querySelector("#desk-go").onclick=()=>this.ask("leave",{},t)})}rate(){this.answers={},this.question("controllable")}question(t){const{verdict:e}=this.state,i=`<button data-answer="yes">${ye.yes}</button><button data-answer="no">${ye.no}</button>`;this.frame(`${this.heading()} · Cooper-Harper`,`<p class="${e.success?"ok":""}">${Xe(yo(e.words||""))}</p><p>${Xe(tn(ye.tree[t],{goal:this.task.goal}))}</p>`,i,s=>{s.querySelector("[data-answer=yes]").focus();for(const r of s.querySelectorAll("[data-answer]"))r.onclick=()=>this.answered(t,r.dataset.answer==="yes")})}answered(t,e){const i=["controllable","adequate","satisfactory"];if(this.answers[t]=e,!e)for(const r of i.slice(i.indexOf(t)+1))this.answers[r]=!1;const s=i[i.indexOf(t)+1];e&&s?this.question(s):this.pick()}pick(){const{controllable:t,adequate:e,satisfactory:i}=this.answers,r=(t?e?i?[1,2,3]:[4,5,6]:[7,8,9]:[10]).map(o=>`<button data-rating="${o}"><b>${o}</b> ${ye.ratings[o]}</button>`).join("");this.frame(`${this.heading()} · Cooper-Harper`,`<p>${ye.pick}</p><div class="choices">${r}</div>`,`<button id="desk-back">${ye.again}</button>`,o=>{o.querySelector("#desk-back").onclick=()=>this.rate();for(const a of o.querySelectorAll("[data-rating]"))a.onclick=()=>{this.answers.rating=Number(a.dataset.rating),this.tlx()};o.querySelector("[data-rating]").focus()})}tlx(){const t=Object.entries(ye.tlx).map(([e,[i,s,r,o]])=>`<fieldset><legend>${i}</legend>
      <label for="tlx-${e}">${s}</label><input type="range" id="tlx-${e}" data-tlx="${e}" min="0" max="100" step="${qm}" value="50">
      <div class="scale-ends"><span>${r}</span><output id="out-${e}">–</output><span>${o}</span></div></fieldset>`).join("");this.frame(`${this.heading()} · NASA-TLX`,t,`<button class="primary" id="desk-go" disabled>${ye.save}</button>`,e=>{const i=new Set,s=r=>{i.add(r.dataset.tlx),e.querySelector(`#out-${r.dataset.tlx}`).textContent=r.value,e.querySelector("#desk-go").disabled=i.size<Object.keys(ye.tlx).length};for(const r of e.querySelectorAll("[data-tlx]"))r.oninput=()=>s(r),r.onkeydown=o=>{o.key==="Enter"&&s(r)},r.onpointerup=()=>s(r);e.querySelector("#desk-go").onclick=()=>{const r=Object.fromEntries([...e.querySelectorAll("[data-tlx]")].map(o=>[o.dataset.tlx,Number(o.value)]));this.ask("rate",{cooper_harper:this.answers,tlx:r},e)}})}weigh(t=[]){const{pairs:e}=this.state,i=e[t.length].map(r=>`<button data-scale="${r}"><b>${ye.tlx[r][0]}</b> ${ye.tlx[r][1]}</button>`).join(""),s=`${this.heading()} · NASA-TLX · ${tn(ye.pair,{n:t.length+1,of:e.length})}`;this.frame(s,`<p>${ye.weigh}</p><div class="choices">${i}</div>`,`<button id="desk-back">${ye.again}</button>`,r=>{r.querySelector("#desk-back").onclick=()=>this.weigh();for(const o of r.querySelectorAll("[data-scale]"))o.onclick=()=>{const a=[...t,o.dataset.scale];a.length<e.length?this.weigh(a):this.ask("weigh",{chosen:a},r)};r.querySelector("[data-scale]").focus()})}}const[ou,bd,Na,_o,au,lu,cu]=[0,1,2,3,4,5,6],fo=3,Td=6,ch={[Na]:"✓",[_o]:"✓",[au]:"✗",[lu]:"✗",[cu]:"?"};function wd([n,t,e,i,s,r,o,...a]){return{seq:n,sent:t,due:e,kind:i,state:s,refusal:r,told:o,value:a}}function Km(n,t){return n.told>=0&&n.told<=t?n:{...n,state:t<n.due?ou:bd,told:-1}}const jm=n=>n.kind===fo&&(n.state===Na||n.state===_o);function Zm(n,t,e){const i=e.step_s,s=Math.max(n.due-n.sent,1);if(n.told>=0)return .8+.2*Math.min(1,(t-n.told)*i/Td);if(t<n.due)return .05+.37*((t-n.sent)/s);const r=Math.max(e.back_s/i,1);return .46+.34*Math.min(1,(t-n.due)/r)}function Jm(n,t,e,i,s){const{pen:r,w:o,h:a,rem:l}=Ia(n),c=s/t.step_s,u=l*1.35,h=[[0,.05,ot.ladder_ground],[.05,.42,ot.ladder_link],[.42,.5,ot.ladder_craft],[.5,.8,ot.ladder_back],[.8,1,ot.ladder_known]];for(const[v,m,p]of h)r.fillStyle=p===ot.ladder_craft?"#17222e":"#0a1018",r.fillRect(v*o+1,u,(m-v)*o-2,a-u),v!==0&&ni(r,p,(v+m)/2*o,l*.55,Te.dim,"center");ni(r,ot.ladder_ground,0,l*.55,Te.dim);const f=(a-u)/e.length;e.forEach((v,m)=>ni(r,v.name,l*.35,u+f*(m+.5),Te.dim));const d=Math.max(2,.37*o/Math.max(t.forward_s/t.step_s,8)-1),g={top:u,lane:f,bottom:a,width:Math.min(d,l),rem:l};for(const v of i){const m=Zm(v,c,t);m>=1||v.told>=0&&(c-v.told)*t.step_s>Td||Qm(r,v,m*o,e,g)}}function Qm(n,t,e,i,{top:s,lane:r,bottom:o,width:a,rem:l}){const c=t.state===au||t.state===lu,u=t.value.some(f=>f!==0),h=t.kind===fo||c?Te.alarm:t.state===_o||t.state===Na?Te.ok:t.state===cu?Te.dim:t.state===bd?Te.predicted:Te.measured;if(n.fillStyle=h,!u&&!c&&t.kind!==fo){n.globalAlpha=t.state===_o?.25:.5,i.forEach((f,d)=>n.fillRect(e,s+r*(d+.5)-1,Math.max(a*.5,1),2)),n.globalAlpha=1;return}(t.kind===fo||c)&&n.fillRect(e,s,Math.max(1.5,a*.4),o-s),i.forEach((f,d)=>{const g=t.value[d];if(!g)return;const v=Math.min(Math.abs(g)/f.highest,1)*r*.46,m=s+r*(d+.5);t.state===ou&&(n.globalAlpha=.85),n.fillRect(e,g>0?m-v:m,a,v),n.globalAlpha=1}),ch[t.state]&&c&&ni(n,ch[t.state],e,s+l*.4,h)}function tg(n){const t={};for(const s of n)t[s.state]=(t[s.state]||0)+1;const i=[`${t[ou]||0} ${ot.ladder_link}`];for(const s of[Na,_o,au,lu,cu])t[s]&&i.push(`${t[s]} ${wm[s]}`);return i.join(" · ")}const eg=!0,rn="u-",ng="uplot",ig=rn+"hz",sg=rn+"vt",rg=rn+"title",og=rn+"wrap",ag=rn+"under",lg=rn+"over",cg=rn+"axis",Us=rn+"off",ug=rn+"select",hg=rn+"cursor-x",fg=rn+"cursor-y",dg=rn+"cursor-pt",pg=rn+"legend",mg=rn+"live",gg=rn+"inline",_g=rn+"series",vg=rn+"marker",uh=rn+"label",xg=rn+"value",ao="width",lo="height",Qr="top",hh="bottom",rr="left",ll="right",uu="#000",fh=uu+"0",cl="mousemove",dh="mousedown",ul="mouseup",ph="mouseenter",mh="mouseleave",gh="dblclick",Mg="resize",Sg="scroll",_h="change",Ta="dppxchange",hu="--",kr=typeof window<"u",Jl=kr?document:null,yr=kr?window:null,yg=kr?navigator:null;let Me,No;function Ql(){let n=devicePixelRatio;Me!=n&&(Me=n,No&&ec(_h,No,Ql),No=matchMedia(`(min-resolution: ${Me-.001}dppx) and (max-resolution: ${Me+.001}dppx)`),ks(_h,No,Ql),yr.dispatchEvent(new CustomEvent(Ta)))}function Gn(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function tc(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function Ne(n,t,e){n.style[t]=e+"px"}function ui(n,t,e,i){let s=Jl.createElement(n);return t!=null&&Gn(s,t),e?.insertBefore(s,i),s}function Zn(n,t){return ui("div",n,t)}const vh=new WeakMap;function Ti(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=vh.get(n);r!=o&&(n.style.transform=r,vh.set(n,r),t<0||e<0||t>i||e>s?Gn(n,Us):tc(n,Us))}const xh=new WeakMap;function Mh(n,t,e){let i=t+e,s=xh.get(n);i!=s&&(xh.set(n,i),n.style.background=t,n.style.borderColor=e)}const Sh=new WeakMap;function yh(n,t,e,i){let s=t+""+e,r=Sh.get(n);s!=r&&(Sh.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}const fu={passive:!0},Eg={...fu,capture:!0};function ks(n,t,e,i){t.addEventListener(n,e,i?Eg:fu)}function ec(n,t,e,i){t.removeEventListener(n,e,fu)}kr&&Ql();function hi(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:Xn((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function Ad(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}const Rd=n=>n!=null,Cd=n=>n!=null&&n>0,Fa=Ad(Rd),bg=Ad(Cd);function Tg(n,t,e,i=0,s=!1){let r=s?bg:Fa,o=s?Cd:Rd;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ce,l??-Ce]}function Oa(n,t,e,i){let s=Th(n),r=Th(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?Ki:Pd,a=s==1?Xn:Qn,l=r==1?Qn:Xn,c=a(o(Qe(n))),u=l(o(Qe(t))),h=Rr(e,c),f=Rr(e,u);return e==10&&(c<0&&(h=Pe(h,-c)),u<0&&(f=Pe(f,-u))),i||e==2?(n=h*s,t=f*r):(n=Id(n,h),t=ka(t,f)),[n,t]}function du(n,t,e,i){let s=Oa(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}const pu=.1,Eh={mode:3,pad:pu},po={pad:0,soft:null,mode:0},wg={min:po,max:po};function wa(n,t,e,i){return Ba(e)?bh(n,t,e):(po.pad=e,po.soft=i?0:null,po.mode=i?3:0,bh(n,t,wg))}function ge(n,t){return n??t}function Ag(n,t,e){for(t=ge(t,0),e=ge(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function bh(n,t,e){let i=e.min,s=e.max,r=ge(i.pad,0),o=ge(s.pad,0),a=ge(i.hard,-Ce),l=ge(s.hard,Ce),c=ge(i.soft,Ce),u=ge(s.soft,-Ce),h=ge(i.mode,0),f=ge(s.mode,0),d=t-n,g=Ki(d),v=Rn(Qe(n),Qe(t)),m=Ki(v),p=Qe(m-g);(d<1e-24||p>10)&&(d=0,(n==0||t==0)&&(d=1e-24,h==2&&c!=Ce&&(r=0),f==2&&u!=-Ce&&(o=0)));let E=d||v||1e3,w=Ki(E),M=Rr(10,Xn(w)),O=E*(d==0?n==0?.1:1:r),R=Pe(Id(n-O,M/10),24),D=n>=c&&(h==1||h==3&&R<=c||h==2&&R>=c)?c:Ce,U=Rn(a,R<D&&n>=D?D:fi(D,R)),T=E*(d==0?t==0?.1:1:o),S=Pe(ka(t+T,M/10),24),C=t<=u&&(f==1||f==3&&S>=u||f==2&&S<=u)?u:-Ce,V=fi(l,S>C&&t<=C?C:Rn(C,S));return U==V&&U==0&&(V=100),[U,V]}const Rg=new Intl.NumberFormat(kr?yg.language:"en-US"),mu=n=>Rg.format(n),$n=Math,ga=$n.PI,Qe=$n.abs,Xn=$n.floor,Je=$n.round,Qn=$n.ceil,fi=$n.min,Rn=$n.max,Rr=$n.pow,Th=$n.sign,Ki=$n.log10,Pd=$n.log2,Cg=(n,t=1)=>$n.sinh(n)*t,hl=(n,t=1)=>$n.asinh(n/t),Ce=1/0;function wh(n){return(Ki((n^n>>31)-(n>>31))|0)+1}function nc(n,t,e){return fi(Rn(n,t),e)}function Ld(n){return typeof n=="function"}function re(n){return Ld(n)?n:()=>n}const Pg=()=>{},Dd=n=>n,Ud=(n,t)=>t,Lg=n=>null,Ah=n=>!0,Rh=(n,t)=>n==t,Dg=/\.\d*?(?=9{6,}|0{6,})/gm,Bs=n=>{if(Fd(n)||ps.has(n))return n;const t=`${n}`,e=t.match(Dg);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Bs(s)}e${r}`}return Pe(n,i)};function Cs(n,t){return Bs(Pe(Bs(n/t))*t)}function ka(n,t){return Bs(Qn(Bs(n/t))*t)}function Id(n,t){return Bs(Xn(Bs(n/t))*t)}function Pe(n,t=0){if(Fd(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return Je(i)/e}const ps=new Map;function Nd(n){return((""+n).split(".")[1]||"").length}function vo(n,t,e,i){let s=[],r=i.map(Nd);for(let o=t;o<e;o++){let a=Qe(o),l=Pe(Rr(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:Pe(u,h);s.push(f),ps.set(f,h)}}return s}const mo={},gu=[],Cr=[null,null],us=Array.isArray,Fd=Number.isInteger,Ug=n=>n===void 0;function Ch(n){return typeof n=="string"}function Ba(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Ig(n){return n!=null&&typeof n=="object"}const Ng=Object.getPrototypeOf(Uint8Array),Od="__proto__";function Pr(n,t=Ba){let e;if(us(n)){let i=n.find(s=>s!=null);if(us(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Pr(n[s],t)}else e=n.slice()}else if(n instanceof Ng)e=n.slice();else if(t(n)){e={};for(let i in n)i!=Od&&(e[i]=Pr(n[i],t))}else e=n;return e}function Ye(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=Od&&(Ba(n[s])?Ye(n[s],Pr(i[s])):n[s]=Pr(i[s]))}return n}const Fg=0,Og=1,kg=2;function Bg(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function zg(n,t){if(Gg(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Wg(o[0])||(o=Vg(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:Og,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?f!=Fg&&(h[m]=v,f==kg&&d.push(m)):h[m]=v}Bg(h,d,s),i.push(h)}}return i}const Hg=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Vg(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function Gg(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function Wg(n,t=100){const e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;const r=Rn(1,Xn((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){const l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const kd=["January","February","March","April","May","June","July","August","September","October","November","December"],Bd=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function zd(n){return n.slice(0,3)}const Xg=Bd.map(zd),$g=kd.map(zd),qg={MMMM:kd,MMM:$g,WWWW:Bd,WWW:Xg};function to(n){return(n<10?"0":"")+n}function Yg(n){return(n<10?"00":n<100?"0":"")+n}const Kg={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>to(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>to(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>to(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>to(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>to(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Yg(n.getMilliseconds())};function _u(n,t){t=t||qg;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?Kg[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const jg=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Zg(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==jg?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}const Hd=n=>n%1==0,Aa=[1,2,2.5,5],Jg=vo(10,-32,0,Aa),Vd=vo(10,0,32,Aa),Qg=Vd.filter(Hd),Ps=Jg.concat(Vd),vu=`
`,Gd="{YYYY}",Ph=vu+Gd,Wd="{M}/{D}",co=vu+Wd,Fo=co+"/{YY}",Xd="{aa}",t_="{h}:{mm}",Mr=t_+Xd,Lh=vu+Mr,Dh=":{ss}",Ee=null;function $d(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?vo(10,0,3,Aa).filter(Hd):vo(10,-3,0,Aa)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Gd,Ee,Ee,Ee,Ee,Ee,Ee,1],[s*28,"{MMM}",Ph,Ee,Ee,Ee,Ee,Ee,1],[s,Wd,Ph,Ee,Ee,Ee,Ee,Ee,1],[i,"{h}"+Xd,Fo,Ee,co,Ee,Ee,Ee,1],[e,Mr,Fo,Ee,co,Ee,Ee,Ee,1],[t,Dh,Fo+" "+Mr,Ee,co+" "+Mr,Ee,Lh,Ee,1],[n,Dh+".{fff}",Fo+" "+Mr,Ee,co+" "+Mr,Ee,Lh,Ee,1]];function u(h){return(f,d,g,v,m,p)=>{let E=[],w=m>=o,M=m>=r&&m<o,O=h(g),R=Pe(O*n,3),D=fl(O.getFullYear(),w?0:O.getMonth(),M||w?1:O.getDate()),U=Pe(D*n,3);if(M||w){let T=M?m/r:0,S=w?m/o:0,C=R==U?R:Pe(fl(D.getFullYear()+S,D.getMonth()+T,1)*n,3),V=new Date(Je(C/n)),I=V.getFullYear(),G=V.getMonth();for(let j=0;C<=v;j++){let K=fl(I+S*j,G+T*j,1),J=K-h(Pe(K*n,3));C=Pe((+K+J)*n,3),C<=v&&E.push(C)}}else{let T=m>=s?s:m,S=Xn(g)-Xn(R),C=U+S+ka(R-U,T);E.push(C);let V=h(C),I=V.getHours()+V.getMinutes()/e+V.getSeconds()/i,G=m/i,j=f.axes[d]._space,K=p/j;for(;C=Pe(C+m,n==1?0:3),!(C>v);)if(G>1){let J=Xn(Pe(I+G,6))%24,ct=h(C).getHours()-J;ct>1&&(ct=-1),C-=ct*i,I=(I+G)%24;let mt=E[E.length-1];Pe((C-mt)/m,3)*K>=.7&&E.push(C)}else E.push(C)}return E}}return[l,c,u]}const[e_,n_,i_]=$d(1),[s_,r_,o_]=$d(.001);vo(2,-53,53,[1]);function Uh(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function Ih(n,t){return(e,i,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,f,d;return i.map(g=>{let v=n(g),m=v.getFullYear(),p=v.getMonth(),E=v.getDate(),w=v.getHours(),M=v.getMinutes(),O=v.getSeconds(),R=m!=l&&a[2]||p!=c&&a[3]||E!=u&&a[4]||w!=h&&a[5]||M!=f&&a[6]||O!=d&&a[7]||a[1];return l=m,c=p,u=E,h=w,f=M,d=O,R(v)})}}function a_(n,t){let e=_u(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function fl(n,t,e){return new Date(n,t,e)}function Nh(n,t){return t(n)}const l_="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Fh(n,t){return(e,i,s,r)=>r==null?hu:t(n(i))}function c_(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function u_(n,t){return n.series[t].fill(n,t)}const h_={show:!0,live:!0,isolate:!1,mount:Pg,markers:{show:!0,width:2,stroke:c_,fill:u_,dash:"solid"},idx:null,idxs:null,values:[]};function f_(n,t){let e=n.cursor.points,i=Zn(),s=e.size(n,t);Ne(i,ao,s),Ne(i,lo,s);let r=s/-2;Ne(i,"marginLeft",r),Ne(i,"marginTop",r);let o=e.width(n,t,s);return o&&Ne(i,"borderWidth",o),i}function d_(n,t){let e=n.series[t].points;return e._fill||e._stroke}function p_(n,t){let e=n.series[t].points;return e._stroke||e._fill}function m_(n,t){return n.series[t].points.size}const dl=[0,0];function g_(n,t,e){return dl[0]=t,dl[1]=e,dl}function Oo(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function pl(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}const __={show:!0,x:!0,y:!0,lock:!1,move:g_,points:{one:!1,show:f_,size:m_,width:0,stroke:p_,fill:d_},bind:{mousedown:Oo,mouseup:Oo,click:Oo,dblclick:Oo,mousemove:pl,mouseleave:pl,mouseenter:pl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},qd={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},xu=Ye({},qd,{filter:Ud}),Yd=Ye({},xu,{size:10}),Kd=Ye({},qd,{show:!1}),Mu='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',jd="bold "+Mu,Zd=1.5,Oh={show:!0,scale:"x",stroke:uu,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jd,side:2,grid:xu,ticks:Yd,border:Kd,font:Mu,lineGap:Zd,rotate:0},v_="Value",x_="Time",kh={show:!0,scale:"x",auto:!1,sorted:1,min:Ce,max:-Ce,idxs:[]};function M_(n,t,e,i,s){return t.map(r=>r==null?"":mu(r))}function S_(n,t,e,i,s,r,o){let a=[],l=ps.get(s)||0;e=o?e:Pe(ka(e,s),l);for(let c=e;c<=i;c=Pe(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ic(n,t,e,i,s,r,o){const a=[],l=n.scales[n.axes[t].scale].log,c=l==10?Ki:Pd,u=Xn(c(e));s=Rr(l,u),l==10&&(s=Ps[hi(s,Ps)]);let h=e,f=s*l;l==10&&(f=Ps[hi(f,Ps)]);do a.push(h),h=h+s,l==10&&!ps.has(h)&&(h=Pe(h,ps.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Ps[hi(f,Ps)]));while(h<=i);return a}function y_(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?ic(n,t,Rn(l,e),i,s):[l],u=i>=0&&e<=0?[0]:[];return(e<-l?ic(n,t,Rn(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}const Jd=/./,E_=/[12357]/,b_=/[125]/,Bh=/1/,sc=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function T_(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Jd:l(7,o)-u>=c?E_:l(5,o)-u>=c?b_:Bh;if(h==Bh){let f=Qe(l(1,o)-u);if(f<c)return sc(t.slice().reverse(),a.distr,h,Qn(c/f)).reverse()}return sc(t,a.distr,h,1)}function w_(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=Qe(l(1,o)-l(2,o));return c<a?sc(t.slice().reverse(),3,Jd,Qn(a/c)).reverse():t}function A_(n,t,e,i){return i==null?hu:t==null?"":mu(t)}const zh={show:!0,scale:"y",stroke:uu,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:jd,side:3,grid:xu,ticks:Yd,border:Kd,font:Mu,lineGap:Zd,rotate:0};function R_(n,t){let e=3+(n||1)*2;return Pe(e*t,3)}function C_(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=Qe(o-r),l=n.series[t],c=a/(l.points.space*Me);return i[1]-i[0]<=c}const Hh={scale:null,auto:!0,sorted:0,min:Ce,max:-Ce},Qd=(n,t,e,i,s)=>s,Vh={show:!0,auto:!0,sorted:0,gaps:Qd,alpha:1,facets:[Ye({},Hh,{scale:"x"}),Ye({},Hh,{scale:"y"})]},Gh={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Qd,alpha:1,points:{show:C_,filter:null},values:null,min:Ce,max:-Ce,idxs:[],path:null,clip:null};function P_(n,t,e,i,s){return e/10}const tp={time:eg,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},L_=Ye({},tp,{time:!1,ori:1}),Wh={};function ep(n,t){let e=Wh[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Wh[n]=e)),e}const Lr=1,rc=2;function Ws(n,t,e){const i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox;let l=r[0],c=i==2?r[1]:r[t],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,v=a.height,m=n.valToPosH,p=n.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,v,Ha,Br,Ga,ip,rp):e(s,l,c,u,h,p,m,d,f,v,g,Va,zr,Eu,sp,op)}function Su(n,t){let e=0,i=0,s=ge(n.bands,gu);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function D_(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function ji(n,t,e,i,s,r){return Ws(n,t,(o,a,l,c,u,h,f,d,g,v,m)=>{let p=o.pxRound;const E=c.dir*(c.ori==0?1:-1),w=c.ori==0?Br:zr;let M,O;E==1?(M=e,O=i):(M=i,O=e);let R=p(h(a[M],c,v,d)),D=p(f(l[M],u,m,g)),U=p(h(a[O],c,v,d)),T=p(f(r==1?u.max:u.min,u,m,g)),S=new Path2D(s);return w(S,U,T),w(S,R,T),w(S,R,D),S})}function za(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;const a=t==0?Ga:Eu;let l=e;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function U_(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function yu(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(n[h]),g=f==h?d:r(n[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(n[v]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(n[p]):g,g>=d&&a.push([d,g])}return a}function Xh(n){return n==0?Dd:n==1?Je:t=>Cs(t,n)}function np(n){let t=n==0?Ha:Va,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=fi(c,a/2,l/2),u=fi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const Ha=(n,t,e)=>{n.moveTo(t,e)},Va=(n,t,e)=>{n.moveTo(e,t)},Br=(n,t,e)=>{n.lineTo(t,e)},zr=(n,t,e)=>{n.lineTo(e,t)},Ga=np(0),Eu=np(1),ip=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},sp=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},rp=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},op=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function ap(n){return(t,e,i,s,r)=>Ws(t,e,(o,a,l,c,u,h,f,d,g,v,m)=>{let{pxRound:p,points:E}=o,w,M;c.ori==0?(w=Ha,M=ip):(w=Va,M=sp);const O=Pe(E.width*Me,3);let R=(E.size-E.width)/2*Me,D=Pe(R*2,3),U=new Path2D,T=new Path2D,{left:S,top:C,width:V,height:I}=t.bbox;Ga(T,S-D,C-D,V+D*2,I+D*2);const G=j=>{if(l[j]!=null){let K=p(h(a[j],c,v,d)),J=p(f(l[j],u,m,g));w(U,K+R,J),M(U,K,J,R,0,ga*2)}};if(r)r.forEach(G);else for(let j=i;j<=s;j++)G(j);return{stroke:O>0?U:null,fill:U,clip:T,flags:Lr|rc}})}function lp(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}const I_=lp(Br),N_=lp(zr);function cp(n){const t=ge(n?.alignGaps,0);return(e,i,s,r)=>Ws(e,i,(o,a,l,c,u,h,f,d,g,v,m)=>{[s,r]=Fa(l,s,r);let p=o.pxRound,E=I=>p(h(I,c,v,d)),w=I=>p(f(I,u,m,g)),M,O;c.ori==0?(M=Br,O=I_):(M=zr,O=N_);const R=c.dir*(c.ori==0?1:-1),D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lr},U=D.stroke;let T=!1;if(r-s>=v*4){let I=pt=>e.posToVal(pt,c.key,!0),G=null,j=null,K,J,Q,ht=E(a[R==1?s:r]),ct=E(a[s]),mt=E(a[r]),Mt=I(R==1?ct+1:mt-1);for(let pt=R==1?s:r;pt>=s&&pt<=r;pt+=R){let nt=a[pt],gt=(R==1?nt<Mt:nt>Mt)?ht:E(nt),rt=l[pt];gt==ht?rt!=null?(J=rt,G==null?(M(U,gt,w(J)),K=G=j=J):J<G?G=J:J>j&&(j=J)):rt===null&&(T=!0):(G!=null&&O(U,ht,w(G),w(j),w(K),w(J)),rt!=null?(J=rt,M(U,gt,w(J)),G=j=K=J):(G=j=null,rt===null&&(T=!0)),ht=gt,Mt=I(ht+R))}G!=null&&G!=j&&Q!=ht&&O(U,ht,w(G),w(j),w(K),w(J))}else for(let I=R==1?s:r;I>=s&&I<=r;I+=R){let G=l[I];G===null?T=!0:G!=null&&M(U,E(a[I]),w(G))}let[C,V]=Su(e,i);if(o.fill!=null||C!=0){let I=D.fill=new Path2D(U),G=o.fillTo(e,i,o.min,o.max,C),j=w(G),K=E(a[s]),J=E(a[r]);R==-1&&([J,K]=[K,J]),M(I,J,j),M(I,K,j)}if(!o.spanGaps){let I=[];T&&I.push(...yu(a,l,s,r,R,E,t)),D.gaps=I=o.gaps(e,i,s,r,I),D.clip=za(I,c.ori,d,g,v,m)}return V!=0&&(D.band=V==2?[ji(e,i,s,r,U,-1),ji(e,i,s,r,U,1)]:ji(e,i,s,r,U,V)),D})}function F_(n){const t=ge(n.align,1),e=ge(n.ascDesc,!1),i=ge(n.alignGaps,0),s=ge(n.extend,!1);return(r,o,a,l)=>Ws(r,o,(c,u,h,f,d,g,v,m,p,E,w)=>{[a,l]=Fa(h,a,l);let M=c.pxRound,{left:O,width:R}=r.bbox,D=ct=>M(g(ct,f,E,m)),U=ct=>M(v(ct,d,w,p)),T=f.ori==0?Br:zr;const S={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Lr},C=S.stroke,V=f.dir*(f.ori==0?1:-1);let I=U(h[V==1?a:l]),G=D(u[V==1?a:l]),j=G,K=G;s&&t==-1&&(K=O,T(C,K,I)),T(C,G,I);for(let ct=V==1?a:l;ct>=a&&ct<=l;ct+=V){let mt=h[ct];if(mt==null)continue;let Mt=D(u[ct]),pt=U(mt);t==1?T(C,Mt,I):T(C,j,pt),T(C,Mt,pt),I=pt,j=Mt}let J=j;s&&t==1&&(J=O+R,T(C,J,I));let[Q,ht]=Su(r,o);if(c.fill!=null||Q!=0){let ct=S.fill=new Path2D(C),mt=c.fillTo(r,o,c.min,c.max,Q),Mt=U(mt);T(ct,J,Mt),T(ct,K,Mt)}if(!c.spanGaps){let ct=[];ct.push(...yu(u,h,a,l,V,D,i));let mt=c.width*Me/2,Mt=e||t==1?mt:-mt,pt=e||t==-1?-mt:mt;ct.forEach(nt=>{nt[0]+=Mt,nt[1]+=pt}),S.gaps=ct=c.gaps(r,o,a,l,ct),S.clip=za(ct,f.ori,m,p,E,w)}return ht!=0&&(S.band=ht==2?[ji(r,o,a,l,C,-1),ji(r,o,a,l,C,1)]:ji(r,o,a,l,C,ht)),S})}function $h(n,t,e,i,s,r,o=Ce){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let u=Qe(n[l]-n[a]);u<c&&(c=u,o=Qe(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function O_(n){n=n||mo;const t=ge(n.size,[.6,Ce,1]),e=n.align||0,i=n.gap||0;let s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=re(s),o=1-t[0],a=ge(t[1],Ce),l=ge(t[2],1),c=ge(n.disp,mo),u=ge(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,v,m)=>Ws(d,g,(p,E,w,M,O,R,D,U,T,S,C)=>{let V=p.pxRound,I=e,G=i*Me,j=a*Me,K=l*Me,J,Q;M.ori==0?[J,Q]=r(d,g):[Q,J]=r(d,g);const ht=M.dir*(M.ori==0?1:-1);let ct=M.ori==0?Ga:Eu,mt=M.ori==0?u:(W,tt,St,_t,Tt,Yt,ft)=>{u(W,tt,St,Tt,_t,ft,Yt)},Mt=ge(d.bands,gu).find(W=>W.series[0]==g),pt=Mt!=null?Mt.dir:0,nt=p.fillTo(d,g,p.min,p.max,pt),at=V(D(nt,O,C,T)),gt,rt,Bt,Ht=S,It=V(p.width*Me),le=!1,jt=null,ce=null,B=null,je=null;h!=null&&(It==0||f!=null)&&(le=!0,jt=h.values(d,g,v,m),ce=new Map,new Set(jt).forEach(W=>{W!=null&&ce.set(W,new Path2D)}),It>0&&(B=f.values(d,g,v,m),je=new Map,new Set(B).forEach(W=>{W!=null&&je.set(W,new Path2D)})));let{x0:Jt,size:te}=c;if(Jt!=null&&te!=null){I=1,E=Jt.values(d,g,v,m),Jt.unit==2&&(E=E.map(St=>d.posToVal(U+St*S,M.key,!0)));let W=te.values(d,g,v,m);te.unit==2?rt=W[0]*S:rt=R(W[0],M,S,U)-R(0,M,S,U),Ht=$h(E,w,R,M,S,U,Ht),Bt=Ht-rt+G}else Ht=$h(E,w,R,M,S,U,Ht),Bt=Ht*o+G,rt=Ht-Bt;Bt<1&&(Bt=0),It>=rt/2&&(It=0),Bt<5&&(V=Dd);let Vt=Bt>0,he=Ht-Bt-(Vt?It:0);rt=V(nc(he,K,j)),gt=(I==0?rt/2:I==ht?0:rt)-I*ht*((I==0?G/2:0)+(Vt?It/2:0));const Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},P=le?null:new Path2D;let y=null;if(Mt!=null)y=d.data[Mt.series[1]];else{let{y0:W,y1:tt}=c;W!=null&&tt!=null&&(w=tt.values(d,g,v,m),y=W.values(d,g,v,m))}let Y=J*rt,Z=Q*rt;for(let W=ht==1?v:m;W>=v&&W<=m;W+=ht){let tt=w[W];if(tt==null)continue;if(y!=null){let Ot=y[W]??0;if(tt-Ot==0)continue;at=D(Ot,O,C,T)}let St=M.distr!=2||c!=null?E[W]:W,_t=R(St,M,S,U),Tt=D(ge(tt,nt),O,C,T),Yt=V(_t-gt),ft=V(Rn(Tt,at)),vt=V(fi(Tt,at)),Nt=ft-vt;if(tt!=null){let Ot=tt<0?Z:Y,Et=tt<0?Y:Z;le?(It>0&&B[W]!=null&&ct(je.get(B[W]),Yt,vt+Xn(It/2),rt,Rn(0,Nt-It),Ot,Et),jt[W]!=null&&ct(ce.get(jt[W]),Yt,vt+Xn(It/2),rt,Rn(0,Nt-It),Ot,Et)):ct(P,Yt,vt+Xn(It/2),rt,Rn(0,Nt-It),Ot,Et),mt(d,g,W,Yt-It/2,vt,rt+It,Nt)}}return It>0?Pt.stroke=le?je:P:le||(Pt._fill=p.width==0?p._fill:p._stroke??p._fill,Pt.width=0),Pt.fill=le?ce:P,Pt})}function k_(n,t){const e=ge(t?.alignGaps,0);return(i,s,r,o)=>Ws(i,s,(a,l,c,u,h,f,d,g,v,m,p)=>{[r,o]=Fa(c,r,o);let E=a.pxRound,w=J=>E(f(J,u,m,g)),M=J=>E(d(J,h,p,v)),O,R,D;u.ori==0?(O=Ha,D=Br,R=rp):(O=Va,D=zr,R=op);const U=u.dir*(u.ori==0?1:-1);let T=w(l[U==1?r:o]),S=T,C=[],V=[];for(let J=U==1?r:o;J>=r&&J<=o;J+=U)if(c[J]!=null){let ht=l[J],ct=w(ht);C.push(S=ct),V.push(M(c[J]))}const I={stroke:n(C,V,O,D,R,E),fill:null,clip:null,band:null,gaps:null,flags:Lr},G=I.stroke;let[j,K]=Su(i,s);if(a.fill!=null||j!=0){let J=I.fill=new Path2D(G),Q=a.fillTo(i,s,a.min,a.max,j),ht=M(Q);D(J,S,ht),D(J,T,ht)}if(!a.spanGaps){let J=[];J.push(...yu(l,c,r,o,U,w,e)),I.gaps=J=a.gaps(i,s,r,o,J),I.clip=za(J,u.ori,g,v,m,p)}return K!=0&&(I.band=K==2?[ji(i,s,r,o,G,-1),ji(i,s,r,o,G,1)]:ji(i,s,r,o,G,K)),I})}function B_(n){return k_(z_,n)}function z_(n,t,e,i,s,r){const o=n.length;if(o<2)return null;const a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,t[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,n[f+1],t[f+1])}return a}const oc=new Set;function qh(){for(let n of oc)n.syncRect(!0)}kr&&(ks(Mg,yr,qh),ks(Sg,yr,qh,!0),ks(Ta,yr,()=>{Sn.pxRatio=Me}));const H_=cp(),V_=ap();function Yh(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>ac(r,o,t,e))}function G_(n,t){return n.map((e,i)=>i==0?{}:Ye({},t,e))}function ac(n,t,e,i){return Ye({},t==0?e:i,n)}function up(n,t,e){return t==null?Cr:[t,e]}const W_=up;function X_(n,t,e){return t==null?Cr:wa(t,e,pu,!0)}function hp(n,t,e,i){return t==null?Cr:Oa(t,e,n.scales[i].log,!1)}const $_=hp;function fp(n,t,e,i){return t==null?Cr:du(t,e,n.scales[i].log,!1)}const q_=fp;function Y_(n,t,e,i,s){let r=Rn(wh(n),wh(t)),o=t-n,a=hi(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?ps.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function Kh(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=Je((e=+s)*Me))+"px"),[n,t,e]}function K_(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Pe(t[2]*Me,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function Sn(n,t,e){const i={mode:ge(n.mode,1)},s=i.mode;function r(_,x,A,L){let N=x.valToPct(_);return L+A*(x.dir==-1?1-N:N)}function o(_,x,A,L){let N=x.valToPct(_);return L+A*(x.dir==-1?N:1-N)}function a(_,x,A,L){return x.ori==0?r(_,x,A,L):o(_,x,A,L)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;const c=i.root=Zn(ng);if(n.id!=null&&(c.id=n.id),Gn(c,n.class),n.title){let _=Zn(rg,c);_.textContent=n.title}const u=ui("canvas"),h=i.ctx=u.getContext("2d"),f=Zn(og,c);ks("click",f,_=>{_.target===g&&(De!=tr||Be!=er)&&pn.click(i,_)},!0);const d=i.under=Zn(ag,f);f.appendChild(u);const g=i.over=Zn(lg,f);n=Pr(n);const v=+ge(n.pxAlign,1),m=Xh(v);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});const p=n.ms||.001,E=i.series=s==1?Yh(n.series||[],kh,Gh,!1):G_(n.series||[null],Vh),w=i.axes=Yh(n.axes||[],Oh,zh,!0),M=i.scales={},O=i.bands=n.bands||[];O.forEach(_=>{_.fill=re(_.fill||null),_.dir=ge(_.dir,-1)});const R=s==2?E[1].facets[0].scale:E[0].scale,D={axes:om,series:qn},U=(n.drawOrder||["axes","series"]).map(_=>D[_]);function T(_){const x=_.distr==3?A=>Ki(A>0?A:_.clamp(i,A,_.min,_.max,_.key)):_.distr==4?A=>hl(A,_.asinh):_.distr==100?A=>_.fwd(A):A=>A;return A=>{let L=x(A),{_min:N,_max:q}=_,it=q-N;return(L-N)/it}}function S(_){let x=M[_];if(x==null){let A=(n.scales||mo)[_]||mo;if(A.from!=null){S(A.from);let L=Ye({},M[A.from],A,{key:_});L.valToPct=T(L),M[_]=L}else{x=M[_]=Ye({},_==R?tp:L_,A),x.key=_;let L=x.time,N=x.range,q=us(N);if((_!=R||s==2&&!L)&&(q&&(N[0]==null||N[1]==null)&&(N={min:N[0]==null?Eh:{mode:1,hard:N[0],soft:N[0]},max:N[1]==null?Eh:{mode:1,hard:N[1],soft:N[1]}},q=!1),!q&&Ba(N))){let it=N;N=(lt,dt,Rt)=>dt==null?Cr:wa(dt,Rt,it)}x.range=re(N||(L?W_:_==R?x.distr==3?$_:x.distr==4?q_:up:x.distr==3?hp:x.distr==4?fp:X_)),x.auto=re(q?!1:x.auto),x.clamp=re(x.clamp||P_),x._min=x._max=null,x.valToPct=T(x)}}}S("x"),S("y"),s==1&&E.forEach(_=>{S(_.scale)}),w.forEach(_=>{S(_.scale)});for(let _ in n.scales)S(_);const C=M[R],V=C.distr;let I,G;C.ori==0?(Gn(c,ig),I=r,G=o):(Gn(c,sg),I=o,G=r);const j={};for(let _ in M){let x=M[_];(x.min!=null||x.max!=null)&&(j[_]={min:x.min,max:x.max},x.min=x.max=null)}const K=n.tzDate||(_=>new Date(Je(_/p))),J=n.fmtDate||_u,Q=p==1?i_(K):o_(K),ht=Ih(K,Uh(p==1?n_:r_,J)),ct=Fh(K,Nh(l_,J)),mt=[],Mt=i.legend=Ye({},h_,n.legend),pt=i.cursor=Ye({},__,{drag:{y:s==2}},n.cursor),nt=Mt.show,at=pt.show,gt=Mt.markers;Mt.idxs=mt,gt.width=re(gt.width),gt.dash=re(gt.dash),gt.stroke=re(gt.stroke),gt.fill=re(gt.fill);let rt,Bt,Ht,It=[],le=[],jt,ce=!1,B={};if(Mt.live){const _=E[1]?E[1].values:null;ce=_!=null,jt=ce?_(i,1,0):{_:0};for(let x in jt)B[x]=hu}if(nt)if(rt=ui("table",pg,c),Ht=ui("tbody",null,rt),Mt.mount(i,rt),ce){Bt=ui("thead",null,rt,Ht);let _=ui("tr",null,Bt);ui("th",null,_);for(var je in jt)ui("th",uh,_).textContent=je}else Gn(rt,gg),Mt.live&&Gn(rt,mg);const Jt={show:!0},te={show:!1};function Vt(_,x){if(x==0&&(ce||!Mt.live||s==2))return Cr;let A=[],L=ui("tr",_g,Ht,Ht.childNodes[x]);Gn(L,_.class),_.show||Gn(L,Us);let N=ui("th",null,L);if(gt.show){let lt=Zn(vg,N);if(x>0){let dt=gt.width(i,x);dt&&(lt.style.border=dt+"px "+gt.dash(i,x)+" "+gt.stroke(i,x)),lt.style.background=gt.fill(i,x)}}let q=Zn(uh,N);_.label instanceof HTMLElement?q.appendChild(_.label):q.textContent=_.label,x>0&&(gt.show||(q.style.color=_.width>0?gt.stroke(i,x):gt.fill(i,x)),Pt("click",N,lt=>{if(pt._lock)return;Ze(lt);let dt=E.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Rt=E.some((Ct,Lt)=>Lt>0&&Lt!=dt&&Ct.show);E.forEach((Ct,Lt)=>{Lt>0&&Si(Lt,Rt?Lt==dt?Jt:te:Jt,!0,$e.setSeries)})}else Si(dt,{show:!_.show},!0,$e.setSeries)},!1),Fi&&Pt(ph,N,lt=>{pt._lock||(Ze(lt),Si(E.indexOf(_),ir,!0,$e.setSeries))},!1));for(var it in jt){let lt=ui("td",xg,L);lt.textContent="--",A.push(lt)}return[L,A]}const he=new Map;function Pt(_,x,A,L=!0){const N=he.get(x)||{},q=pt.bind[_](i,x,A,L);q&&(ks(_,x,N[_]=q),he.set(x,N))}function P(_,x,A){const L=he.get(x)||{};for(let N in L)(_==null||N==_)&&(ec(N,x,L[N]),delete L[N]);_==null&&he.delete(x)}let y=0,Y=0,Z=0,W=0,tt=0,St=0,_t=tt,Tt=St,Yt=Z,ft=W,vt=0,Nt=0,Ot=0,Et=0;i.bbox={};let ne=!1,$t=!1,fe=!1,k=!1,xt=!1,et=!1;function st(_,x,A){(A||_!=i.width||x!=i.height)&&wt(_,x),js(!1),fe=!0,$t=!0,Zs()}function wt(_,x){i.width=y=Z=_,i.height=Y=W=x,tt=St=0,an(),ve();let A=i.bbox;vt=A.left=Cs(tt*Me,.5),Nt=A.top=Cs(St*Me,.5),Ot=A.width=Cs(Z*Me,.5),Et=A.height=Cs(W*Me,.5)}const At=3;function Zt(){let _=!1,x=0;for(;!_;){x++;let A=sm(x),L=rm(x);_=x==At||A&&L,_||(wt(i.width,i.height),$t=!0)}}function Oe({width:_,height:x}){st(_,x)}i.setSize=Oe;function an(){let _=!1,x=!1,A=!1,L=!1;w.forEach((N,q)=>{if(N.show&&N._show){let{side:it,_size:lt}=N,dt=it%2,Rt=N.label!=null?N.labelSize:0,Ct=lt+Rt;Ct>0&&(dt?(Z-=Ct,it==3?(tt+=Ct,L=!0):A=!0):(W-=Ct,it==0?(St+=Ct,_=!0):x=!0))}}),vi[0]=_,vi[1]=A,vi[2]=x,vi[3]=L,Z-=b[1]+b[3],tt+=b[3],W-=b[2]+b[0],St+=b[0]}function ve(){let _=tt+Z,x=St+W,A=tt,L=St;function N(q,it){switch(q){case 1:return _+=it,_-it;case 2:return x+=it,x-it;case 3:return A-=it,A+it;case 0:return L-=it,L+it}}w.forEach((q,it)=>{if(q.show&&q._show){let lt=q.side;q._pos=N(lt,q._size),q.label!=null&&(q._lpos=N(lt,q.labelSize))}})}if(pt.dataIdx==null){let _=pt.hover,x=_.skip=new Set(_.skip??[]);x.add(void 0);let A=_.prox=re(_.prox),L=_.bias??=0;pt.dataIdx=(N,q,it,lt)=>{if(q==0)return it;let dt=it,Rt=A(N,q,it,lt)??Ce,Ct=Rt>=0&&Rt<Ce,Lt=C.ori==0?Z:W,qt=pt.left,xe=t[0],me=t[q];if(x.has(me[it])){dt=null;let ie=null,Wt=null,zt;if(L==0||L==-1)for(zt=it;ie==null&&zt-- >0;)x.has(me[zt])||(ie=zt);if(L==0||L==1)for(zt=it;Wt==null&&zt++<me.length;)x.has(me[zt])||(Wt=zt);if(ie!=null||Wt!=null)if(Ct){let Ie=ie==null?-1/0:I(xe[ie],C,Lt,0),Ve=Wt==null?1/0:I(xe[Wt],C,Lt,0),fn=qt-Ie,we=Ve-qt;fn<=we?fn<=Rt&&(dt=ie):we<=Rt&&(dt=Wt)}else dt=Wt==null?ie:ie==null?Wt:it-ie<=Wt-it?ie:Wt}else Ct&&Qe(qt-I(xe[it],C,Lt,0))>Rt&&(dt=null);return dt}}const Ze=_=>{pt.event=_};pt.idxs=mt,pt._lock=!1;let Le=pt.points;Le.show=re(Le.show),Le.size=re(Le.size),Le.stroke=re(Le.stroke),Le.width=re(Le.width),Le.fill=re(Le.fill);const On=i.focus=Ye({},n.focus||{alpha:.3},pt.focus),Fi=On.prox>=0,Cn=Fi&&Le.one;let gn=[],Oi=[],ki=[];function _s(_,x){let A=Le.show(i,x);if(A instanceof HTMLElement)return Gn(A,dg),Gn(A,_.class),Ti(A,-10,-10,Z,W),g.insertBefore(A,gn[x]),A}function qr(_,x){if(s==1||x>0){let A=s==1&&M[_.scale].time,L=_.value;_.value=A?Ch(L)?Fh(K,Nh(L,J)):L||ct:L||A_,_.label=_.label||(A?x_:v_)}if(Cn||x>0){_.width=_.width==null?1:_.width,_.paths=_.paths||H_||Lg,_.fillTo=re(_.fillTo||D_),_.pxAlign=+ge(_.pxAlign,v),_.pxRound=Xh(_.pxAlign),_.stroke=re(_.stroke||null),_.fill=re(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let A=R_(Rn(1,_.width),1),L=_.points=Ye({},{size:A,width:Rn(1,A*.2),stroke:_.stroke,space:A*2,paths:V_,_stroke:null,_fill:null},_.points);L.show=re(L.show),L.filter=re(L.filter),L.fill=re(L.fill),L.stroke=re(L.stroke),L.paths=re(L.paths),L.pxAlign=_.pxAlign}if(nt){let A=Vt(_,x);It.splice(x,0,A[0]),le.splice(x,0,A[1]),Mt.values.push(null)}if(at){mt.splice(x,0,null);let A=null;Cn?x==0&&(A=_s(_,x)):x>0&&(A=_s(_,x)),gn.splice(x,0,A),Oi.splice(x,0,0),ki.splice(x,0,0)}hn("addSeries",x)}function Ys(_,x){x=x??E.length,_=s==1?ac(_,x,kh,Gh):ac(_,x,{},Vh),E.splice(x,0,_),qr(E[x],x)}i.addSeries=Ys;function Ao(_){if(E.splice(_,1),nt){Mt.values.splice(_,1),le.splice(_,1);let x=It.splice(_,1)[0];P(null,x.firstChild),x.remove()}at&&(mt.splice(_,1),gn.splice(_,1)[0].remove(),Oi.splice(_,1),ki.splice(_,1)),hn("delSeries",_)}i.delSeries=Ao;const vi=[!1,!1,!1,!1];function Ka(_,x){if(_._show=_.show,_.show){let A=_.side%2,L=M[_.scale];L==null&&(_.scale=A?E[1].scale:R,L=M[_.scale]);let N=L.time;_.size=re(_.size),_.space=re(_.space),_.rotate=re(_.rotate),us(_.incrs)&&_.incrs.forEach(it=>{!ps.has(it)&&ps.set(it,Nd(it))}),_.incrs=re(_.incrs||(L.distr==2?Qg:N?p==1?e_:s_:Ps)),_.splits=re(_.splits||(N&&L.distr==1?Q:L.distr==3?ic:L.distr==4?y_:S_)),_.stroke=re(_.stroke),_.grid.stroke=re(_.grid.stroke),_.ticks.stroke=re(_.ticks.stroke),_.border.stroke=re(_.border.stroke);let q=_.values;_.values=us(q)&&!us(q[0])?re(q):N?us(q)?Ih(K,Uh(q,J)):Ch(q)?a_(K,q):q||ht:q||M_,_.filter=re(_.filter||(L.distr>=3&&L.log==10?T_:L.distr==3&&L.log==2?w_:Ud)),_.font=Kh(_.font),_.labelFont=Kh(_.labelFont),_._size=_.size(i,null,x,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(vi[x]=!0,_._el=Zn(cg,f))}}function vs(_,x,A,L){let[N,q,it,lt]=A,dt=x%2,Rt=0;return dt==0&&(lt||q)&&(Rt=x==0&&!N||x==2&&!it?Je(Oh.size/3):0),dt==1&&(N||it)&&(Rt=x==1&&!q||x==3&&!lt?Je(zh.size/2):0),Rt}const Ro=i.padding=(n.padding||[vs,vs,vs,vs]).map(_=>re(ge(_,vs))),b=i._padding=Ro.map((_,x)=>_(i,x,vi,0));let F,X=null,$=null;const H=s==1?E[0].idxs:null;let ut=null,yt=!1;function Ft(_,x){if(t=_??[],i.data=i._data=t,s==2){F=0;for(let A=1;A<E.length;A++)F+=t[A][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),ut=t[0],F=ut.length;let A=t;if(V==2){A=t.slice();let L=A[0]=Array(F);for(let N=0;N<F;N++)L[N]=N}i._data=t=A}if(js(!0),hn("setData"),V==2&&(fe=!0),x!==!1){let A=C;A.auto(i,yt)?Dt():es(R,A.min,A.max),k=k||pt.left>=0,et=!0,Zs()}}i.setData=Ft;function Dt(){yt=!0;let _,x;s==1&&(F>0?(X=H[0]=0,$=H[1]=F-1,_=t[0][X],x=t[0][$],V==2?(_=X,x=$):_==x&&(V==3?[_,x]=Oa(_,_,C.log,!1):V==4?[_,x]=du(_,_,C.log,!1):C.time?x=_+Je(86400/p):[_,x]=wa(_,x,pu,!0))):(X=H[0]=_=null,$=H[1]=x=null)),es(R,_,x)}let Gt,Xt,Ut,se,Se,be,ln,ue,kt,ke;function de(_,x,A,L,N,q){_??=fh,A??=gu,L??="butt",N??=fh,q??="round",_!=Gt&&(h.strokeStyle=Gt=_),N!=Xt&&(h.fillStyle=Xt=N),x!=Ut&&(h.lineWidth=Ut=x),q!=Se&&(h.lineJoin=Se=q),L!=be&&(h.lineCap=be=L),A!=se&&h.setLineDash(se=A)}function Pn(_,x,A,L){x!=Xt&&(h.fillStyle=Xt=x),_!=ln&&(h.font=ln=_),A!=ue&&(h.textAlign=ue=A),L!=kt&&(h.textBaseline=kt=L)}function xi(_,x,A,L,N=0){if(L.length>0&&_.auto(i,yt)&&(x==null||x.min==null)){let q=ge(X,0),it=ge($,L.length-1),lt=A.min==null?Tg(L,q,it,N,_.distr==3):[A.min,A.max];_.min=fi(_.min,A.min=lt[0]),_.max=Rn(_.max,A.max=lt[1])}}const _n={min:null,max:null};function xs(){for(let L in M){let N=M[L];j[L]==null&&(N.min==null||j[R]!=null&&N.auto(i,yt))&&(j[L]=_n)}for(let L in M){let N=M[L];j[L]==null&&N.from!=null&&j[N.from]!=null&&(j[L]=_n)}j[R]!=null&&js(!0);let _={};for(let L in j){let N=j[L];if(N!=null){let q=_[L]=Pr(M[L],Ig);if(N.min!=null)Ye(q,N);else if(L!=R||s==2)if(F==0&&q.from==null){let it=q.range(i,null,null,L);q.min=it[0],q.max=it[1]}else q.min=Ce,q.max=-Ce}}if(F>0){E.forEach((L,N)=>{if(s==1){let q=L.scale,it=j[q];if(it==null)return;let lt=_[q];if(N==0){let dt=lt.range(i,lt.min,lt.max,q);lt.min=dt[0],lt.max=dt[1],X=hi(lt.min,t[0]),$=hi(lt.max,t[0]),$-X>1&&(t[0][X]<lt.min&&X++,t[0][$]>lt.max&&$--),L.min=ut[X],L.max=ut[$]}else L.show&&L.auto&&xi(lt,it,L,t[N],L.sorted);L.idxs[0]=X,L.idxs[1]=$}else if(N>0&&L.show&&L.auto){let[q,it]=L.facets,lt=q.scale,dt=it.scale,[Rt,Ct]=t[N],Lt=_[lt],qt=_[dt];Lt!=null&&xi(Lt,j[lt],q,Rt,q.sorted),qt!=null&&xi(qt,j[dt],it,Ct,it.sorted),L.min=it.min,L.max=it.max}});for(let L in _){let N=_[L],q=j[L];if(N.from==null&&(q==null||q.min==null)){let it=N.range(i,N.min==Ce?null:N.min,N.max==-Ce?null:N.max,L);N.min=it[0],N.max=it[1]}}}for(let L in _){let N=_[L];if(N.from!=null){let q=_[N.from];if(q.min==null)N.min=N.max=null;else{let it=N.range(i,q.min,q.max,L);N.min=it[0],N.max=it[1]}}}let x={},A=!1;for(let L in _){let N=_[L],q=M[L];if(q.min!=N.min||q.max!=N.max){q.min=N.min,q.max=N.max;let it=q.distr;q._min=it==3?Ki(q.min):it==4?hl(q.min,q.asinh):it==100?q.fwd(q.min):q.min,q._max=it==3?Ki(q.max):it==4?hl(q.max,q.asinh):it==100?q.fwd(q.max):q.max,x[L]=A=!0}}if(A){E.forEach((L,N)=>{s==2?N>0&&x.y&&(L._paths=null):x[L.scale]&&(L._paths=null)});for(let L in x)fe=!0,hn("setScale",L);at&&pt.left>=0&&(k=et=!0)}for(let L in j)j[L]=null}function Re(_){let x=nc(X-1,0,F-1),A=nc($+1,0,F-1);for(;_[x]==null&&x>0;)x--;for(;_[A]==null&&A<F-1;)A++;return[x,A]}function qn(){if(F>0){let _=E.some(x=>x._focus)&&ke!=On.alpha;_&&(h.globalAlpha=ke=On.alpha),E.forEach((x,A)=>{if(A>0&&x.show&&(Qi(A,!1),Qi(A,!0),x._paths==null)){let L=ke;ke!=x.alpha&&(h.globalAlpha=ke=x.alpha);let N=s==2?[0,t[A][0].length-1]:Re(t[A]);x._paths=x.paths(i,A,N[0],N[1]),ke!=L&&(h.globalAlpha=ke=L)}}),E.forEach((x,A)=>{if(A>0&&x.show){let L=ke;ke!=x.alpha&&(h.globalAlpha=ke=x.alpha),x._paths!=null&&yn(A,!1);{let N=x._paths!=null?x._paths.gaps:null,q=x.points.show(i,A,X,$,N),it=x.points.filter(i,A,q,N);(q||it)&&(x.points._paths=x.points.paths(i,A,X,$,it),yn(A,!0))}ke!=L&&(h.globalAlpha=ke=L),hn("drawSeries",A)}}),_&&(h.globalAlpha=ke=1)}}function Qi(_,x){let A=x?E[_].points:E[_];A._stroke=A.stroke(i,_),A._fill=A.fill(i,_)}function yn(_,x){let A=x?E[_].points:E[_],{stroke:L,fill:N,clip:q,flags:it,_stroke:lt=A._stroke,_fill:dt=A._fill,_width:Rt=A.width}=A._paths;Rt=Pe(Rt*Me,3);let Ct=null,Lt=Rt%2/2;x&&dt==null&&(dt=Rt>0?"#fff":lt);let qt=A.pxAlign==1&&Lt>0;if(qt&&h.translate(Lt,Lt),!x){let xe=vt-Rt/2,me=Nt-Rt/2,ie=Ot+Rt,Wt=Et+Rt;Ct=new Path2D,Ct.rect(xe,me,ie,Wt)}x?Ks(lt,Rt,A.dash,A.cap,dt,L,N,it,q):Mi(_,lt,Rt,A.dash,A.cap,dt,L,N,it,Ct,q),qt&&h.translate(-Lt,-Lt)}function Mi(_,x,A,L,N,q,it,lt,dt,Rt,Ct){let Lt=!1;dt!=0&&O.forEach((qt,xe)=>{if(qt.series[0]==_){let me=E[qt.series[1]],ie=t[qt.series[1]],Wt=(me._paths||mo).band;us(Wt)&&(Wt=qt.dir==1?Wt[0]:Wt[1]);let zt,Ie=null;me.show&&Wt&&Ag(ie,X,$)?(Ie=qt.fill(i,xe)||q,zt=me._paths.clip):Wt=null,Ks(x,A,L,N,Ie,it,lt,dt,Rt,Ct,zt,Wt),Lt=!0}}),Lt||Ks(x,A,L,N,q,it,lt,dt,Rt,Ct)}const ii=Lr|rc;function Ks(_,x,A,L,N,q,it,lt,dt,Rt,Ct,Lt){de(_,x,A,L,N),(dt||Rt||Lt)&&(h.save(),dt&&h.clip(dt),Rt&&h.clip(Rt)),Lt?(lt&ii)==ii?(h.clip(Lt),Ct&&h.clip(Ct),Po(N,it),Co(_,q,x)):lt&rc?(Po(N,it),h.clip(Lt),Co(_,q,x)):lt&Lr&&(h.save(),h.clip(Lt),Ct&&h.clip(Ct),Po(N,it),h.restore(),Co(_,q,x)):(Po(N,it),Co(_,q,x)),(dt||Rt||Lt)&&h.restore()}function Co(_,x,A){A>0&&(x instanceof Map?x.forEach((L,N)=>{h.strokeStyle=Gt=N,h.stroke(L)}):x!=null&&_&&h.stroke(x))}function Po(_,x){x instanceof Map?x.forEach((A,L)=>{h.fillStyle=Xt=L,h.fill(A)}):x!=null&&_&&h.fill(x)}function im(_,x,A,L){let N=w[_],q;if(L<=0)q=[0,0];else{let it=N._space=N.space(i,_,x,A,L),lt=N._incrs=N.incrs(i,_,x,A,L,it);q=Y_(x,A,lt,L,it)}return N._found=q}function ja(_,x,A,L,N,q,it,lt,dt,Rt){let Ct=it%2/2;v==1&&h.translate(Ct,Ct),de(lt,it,dt,Rt,lt),h.beginPath();let Lt,qt,xe,me,ie=N+(L==0||L==3?-q:q);A==0?(qt=N,me=ie):(Lt=N,xe=ie);for(let Wt=0;Wt<_.length;Wt++)x[Wt]!=null&&(A==0?Lt=xe=_[Wt]:qt=me=_[Wt],h.moveTo(Lt,qt),h.lineTo(xe,me));h.stroke(),v==1&&h.translate(-Ct,-Ct)}function sm(_){let x=!0;return w.forEach((A,L)=>{if(!A.show)return;let N=M[A.scale];if(N.min==null){A._show&&(x=!1,A._show=!1,js(!1));return}else A._show||(x=!1,A._show=!0,js(!1));let q=A.side,it=q%2,{min:lt,max:dt}=N,[Rt,Ct]=im(L,lt,dt,it==0?Z:W);if(Ct==0)return;let Lt=N.distr==2,qt=A._splits=A.splits(i,L,lt,dt,Rt,Ct,Lt),xe=N.distr==2?qt.map(zt=>ut[zt]):qt,me=N.distr==2?ut[qt[1]]-ut[qt[0]]:Rt,ie=A._values=A.values(i,A.filter(i,xe,L,Ct,me),L,Ct,me);A._rotate=q==2?A.rotate(i,ie,L,Ct):0;let Wt=A._size;A._size=Qn(A.size(i,ie,L,_)),Wt!=null&&A._size!=Wt&&(x=!1)}),x}function rm(_){let x=!0;return Ro.forEach((A,L)=>{let N=A(i,L,vi,_);N!=b[L]&&(x=!1),b[L]=N}),x}function om(){for(let _=0;_<w.length;_++){let x=w[_];if(!x.show||!x._show)continue;let A=x.side,L=A%2,N,q,it=x.stroke(i,_),lt=A==0||A==3?-1:1,[dt,Rt]=x._found;if(x.label!=null){let bn=x.labelGap*lt,zn=Je((x._lpos+bn)*Me);Pn(x.labelFont[0],it,"center",A==2?Qr:hh),h.save(),L==1?(N=q=0,h.translate(zn,Je(Nt+Et/2)),h.rotate((A==3?-ga:ga)/2)):(N=Je(vt+Ot/2),q=zn);let ys=Ld(x.label)?x.label(i,_,dt,Rt):x.label;h.fillText(ys,N,q),h.restore()}if(Rt==0)continue;let Ct=M[x.scale],Lt=L==0?Ot:Et,qt=L==0?vt:Nt,xe=x._splits,me=Ct.distr==2?xe.map(bn=>ut[bn]):xe,ie=Ct.distr==2?ut[xe[1]]-ut[xe[0]]:dt,Wt=x.ticks,zt=x.border,Ie=Wt.show?Wt.size:0,Ve=Je(Ie*Me),fn=Je((x.alignTo==2?x._size-Ie-x.gap:x.gap)*Me),we=x._rotate*-ga/180,Ge=m(x._pos*Me),kn=(Ve+fn)*lt,En=Ge+kn;q=L==0?En:0,N=L==1?En:0;let Yn=x.font[0],si=x.align==1?rr:x.align==2?ll:we>0?rr:we<0?ll:L==0?"center":A==3?ll:rr,Ei=we||L==1?"middle":A==2?Qr:hh;Pn(Yn,it,si,Ei);let Bn=x.font[1]*x.lineGap,Kn=xe.map(bn=>m(a(bn,Ct,Lt,qt))),ri=x._values;for(let bn=0;bn<ri.length;bn++){let zn=ri[bn];if(zn!=null){L==0?N=Kn[bn]:q=Kn[bn],zn=""+zn;let ys=zn.indexOf(`
`)==-1?[zn]:zn.split(/\n/gm);for(let Tn=0;Tn<ys.length;Tn++){let oh=ys[Tn];we?(h.save(),h.translate(N,q+Tn*Bn),h.rotate(we),h.fillText(oh,0,0),h.restore()):h.fillText(oh,N,q+Tn*Bn)}}}Wt.show&&ja(Kn,Wt.filter(i,me,_,Rt,ie),L,A,Ge,Ve,Pe(Wt.width*Me,3),Wt.stroke(i,_),Wt.dash,Wt.cap);let bi=x.grid;bi.show&&ja(Kn,bi.filter(i,me,_,Rt,ie),L,L==0?2:1,L==0?Nt:vt,L==0?Et:Ot,Pe(bi.width*Me,3),bi.stroke(i,_),bi.dash,bi.cap),zt.show&&ja([Ge],[1],L==0?1:0,L==0?1:2,L==1?Nt:vt,L==1?Et:Ot,Pe(zt.width*Me,3),zt.stroke(i,_),zt.dash,zt.cap)}hn("drawAxes")}function js(_){E.forEach((x,A)=>{A>0&&(x._paths=null,_&&(s==1?(x.min=null,x.max=null):x.facets.forEach(L=>{L.min=null,L.max=null})))})}let Lo=!1,Za=!1,Yr=[];function am(){Za=!1;for(let _=0;_<Yr.length;_++)hn(...Yr[_]);Yr.length=0}function Zs(){Lo||(Hg(Vu),Lo=!0)}function lm(_,x=!1){Lo=!0,Za=x,_(i),Vu(),x&&Yr.length>0&&queueMicrotask(am)}i.batch=lm;function Vu(){if(ne&&(xs(),ne=!1),fe&&(Zt(),fe=!1),$t){if(Ne(d,rr,tt),Ne(d,Qr,St),Ne(d,ao,Z),Ne(d,lo,W),Ne(g,rr,tt),Ne(g,Qr,St),Ne(g,ao,Z),Ne(g,lo,W),Ne(f,ao,y),Ne(f,lo,Y),u.width=Je(y*Me),u.height=Je(Y*Me),w.forEach(({_el:_,_show:x,_size:A,_pos:L,side:N})=>{if(_!=null)if(x){let q=N===3||N===0?A:0,it=N%2==1;Ne(_,it?"left":"top",L-q),Ne(_,it?"width":"height",A),Ne(_,it?"top":"left",it?St:tt),Ne(_,it?"height":"width",it?W:Z),tc(_,Us)}else Gn(_,Us)}),Gt=Xt=Ut=Se=be=ln=ue=kt=se=null,ke=1,Zr(!0),tt!=_t||St!=Tt||Z!=Yt||W!=ft){js(!1);let _=Z/Yt,x=W/ft;if(at&&!k&&pt.left>=0){pt.left*=_,pt.top*=x,Js&&Ti(Js,Je(pt.left),0,Z,W),Qs&&Ti(Qs,0,Je(pt.top),Z,W);for(let A=0;A<gn.length;A++){let L=gn[A];L!=null&&(Oi[A]*=_,ki[A]*=x,Ti(L,Qn(Oi[A]),Qn(ki[A]),Z,W))}}if(Ue.show&&!xt&&Ue.left>=0&&Ue.width>0){Ue.left*=_,Ue.width*=_,Ue.top*=x,Ue.height*=x;for(let A in il)Ne(nr,A,Ue[A])}_t=tt,Tt=St,Yt=Z,ft=W}hn("setSize"),$t=!1}y>0&&Y>0&&(h.clearRect(0,0,u.width,u.height),hn("drawClear"),U.forEach(_=>_()),hn("draw")),Ue.show&&xt&&(Do(Ue),xt=!1),at&&k&&(Ss(null,!0,!1),k=!1),Mt.show&&Mt.live&&et&&(el(),et=!1),l||(l=!0,i.status=1,hn("ready")),yt=!1,Lo=!1}i.redraw=(_,x)=>{fe=x||!1,_!==!1?es(R,C.min,C.max):Zs()};function Ja(_,x){let A=M[_];if(A.from==null){if(F==0){let L=A.range(i,x.min,x.max,_);x.min=L[0],x.max=L[1]}if(x.min>x.max){let L=x.min;x.min=x.max,x.max=L}if(F>1&&x.min!=null&&x.max!=null&&x.max-x.min<1e-16)return;_==R&&A.distr==2&&F>0&&(x.min=hi(x.min,t[0]),x.max=hi(x.max,t[0]),x.min==x.max&&x.max++),j[_]=x,ne=!0,Zs()}}i.setScale=Ja;let Qa,tl,Js,Qs,Gu,Wu,tr,er,Xu,$u,De,Be,ts=!1;const pn=pt.drag;let cn=pn.x,un=pn.y;at&&(pt.x&&(Qa=Zn(hg,g)),pt.y&&(tl=Zn(fg,g)),C.ori==0?(Js=Qa,Qs=tl):(Js=tl,Qs=Qa),De=pt.left,Be=pt.top);const Ue=i.select=Ye({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),nr=Ue.show?Zn(ug,Ue.over?g:d):null;function Do(_,x){if(Ue.show){for(let A in _)Ue[A]=_[A],A in il&&Ne(nr,A,_[A]);x!==!1&&hn("setSelect")}}i.setSelect=Do;function cm(_){if(E[_].show)nt&&tc(It[_],Us);else if(nt&&Gn(It[_],Us),at){let A=Cn?gn[0]:gn[_];A!=null&&Ti(A,-10,-10,Z,W)}}function es(_,x,A){Ja(_,{min:x,max:A})}function Si(_,x,A,L){x.focus!=null&&pm(_),x.show!=null&&E.forEach((N,q)=>{q>0&&(_==q||_==null)&&(N.show=x.show,cm(q),s==2?(es(N.facets[0].scale,null,null),es(N.facets[1].scale,null,null)):es(N.scale,null,null),Zs())}),A!==!1&&hn("setSeries",_,x),L&&Jr("setSeries",i,_,x)}i.setSeries=Si;function um(_,x){Ye(O[_],x)}function hm(_,x){_.fill=re(_.fill||null),_.dir=ge(_.dir,-1),x=x??O.length,O.splice(x,0,_)}function fm(_){_==null?O.length=0:O.splice(_,1)}i.addBand=hm,i.setBand=um,i.delBand=fm;function dm(_,x){E[_].alpha=x,at&&gn[_]!=null&&(gn[_].style.opacity=x),nt&&It[_]&&(It[_].style.opacity=x)}let Bi,ns,Ms;const ir={focus:!0};function pm(_){if(_!=Ms){let x=_==null,A=On.alpha!=1;E.forEach((L,N)=>{if(s==1||N>0){let q=x||N==0||N==_;L._focus=x?null:q,A&&dm(N,q?1:On.alpha)}}),Ms=_,A&&Zs()}}nt&&Fi&&Pt(mh,rt,_=>{pt._lock||(Ze(_),Ms!=null&&Si(null,ir,!0,$e.setSeries))});function yi(_,x,A){let L=M[x];A&&(_=_/Me-(L.ori==1?St:tt));let N=Z;L.ori==1&&(N=W,_=N-_),L.dir==-1&&(_=N-_);let q=L._min,it=L._max,lt=_/N,dt=q+(it-q)*lt,Rt=L.distr;return Rt==3?Rr(10,dt):Rt==4?Cg(dt,L.asinh):Rt==100?L.bwd(dt):dt}function mm(_,x){let A=yi(_,R,x);return hi(A,t[0],X,$)}i.valToIdx=_=>hi(_,t[0]),i.posToIdx=mm,i.posToVal=yi,i.valToPos=(_,x,A)=>M[x].ori==0?r(_,M[x],A?Ot:Z,A?vt:0):o(_,M[x],A?Et:W,A?Nt:0),i.setCursor=(_,x,A)=>{De=_.left,Be=_.top,Ss(null,x,A)};function qu(_,x){Ne(nr,rr,Ue.left=_),Ne(nr,ao,Ue.width=x)}function Yu(_,x){Ne(nr,Qr,Ue.top=_),Ne(nr,lo,Ue.height=x)}let Kr=C.ori==0?qu:Yu,jr=C.ori==1?qu:Yu;function gm(){if(nt&&Mt.live)for(let _=s==2?1:0;_<E.length;_++){if(_==0&&ce)continue;let x=Mt.values[_],A=0;for(let L in x)le[_][A++].firstChild.nodeValue=x[L]}}function el(_,x){if(_!=null&&(_.idxs?_.idxs.forEach((A,L)=>{mt[L]=A}):Ug(_.idx)||mt.fill(_.idx),Mt.idx=mt[0]),nt&&Mt.live){for(let A=0;A<E.length;A++)(A>0||s==1&&!ce)&&_m(A,mt[A]);gm()}et=!1,x!==!1&&hn("setLegend")}i.setLegend=el;function _m(_,x){let A=E[_],L=_==0&&V==2?ut:t[_],N;ce?N=A.values(i,_,x)??B:(N=A.value(i,x==null?null:L[x],_,x),N=N==null?B:{_:N}),Mt.values[_]=N}function Ss(_,x,A){Xu=De,$u=Be,[De,Be]=pt.move(i,De,Be),pt.left=De,pt.top=Be,at&&(Js&&Ti(Js,Je(De),0,Z,W),Qs&&Ti(Qs,0,Je(Be),Z,W));let L,N=X>$;Bi=Ce,ns=null;let q=C.ori==0?Z:W,it=C.ori==1?Z:W;if(De<0||F==0||N){L=pt.idx=null;for(let lt=0;lt<E.length;lt++){let dt=gn[lt];dt!=null&&Ti(dt,-10,-10,Z,W)}Fi&&Si(null,ir,!0,_==null&&$e.setSeries),Mt.live&&(mt.fill(L),et=!0)}else{let lt,dt,Rt;s==1&&(lt=C.ori==0?De:Be,dt=yi(lt,R),L=pt.idx=hi(dt,t[0],X,$),Rt=I(t[0][L],C,q,0));let Ct=-10,Lt=-10,qt=0,xe=0,me=!0,ie="",Wt="";for(let zt=s==2?1:0;zt<E.length;zt++){let Ie=E[zt],Ve=mt[zt],fn=Ve==null?null:s==1?t[zt][Ve]:t[zt][1][Ve],we=pt.dataIdx(i,zt,L,dt),Ge=we==null?null:s==1?t[zt][we]:t[zt][1][we];if(et=et||Ge!=fn||we!=Ve,mt[zt]=we,zt>0&&Ie.show){let kn=we==null?-10:we==L?Rt:I(s==1?t[0][we]:t[zt][0][we],C,q,0),En=Ge==null?-10:G(Ge,s==1?M[Ie.scale]:M[Ie.facets[1].scale],it,0);if(Fi&&Ge!=null){let Yn=C.ori==1?De:Be,si=Qe(On.dist(i,zt,we,En,Yn));if(si<Bi){let Ei=On.bias;if(Ei!=0){let Bn=yi(Yn,Ie.scale),Kn=Ge>=0?1:-1,ri=Bn>=0?1:-1;ri==Kn&&(ri==1?Ei==1?Ge>=Bn:Ge<=Bn:Ei==1?Ge<=Bn:Ge>=Bn)&&(Bi=si,ns=zt)}else Bi=si,ns=zt}}if(et||Cn){let Yn,si;C.ori==0?(Yn=kn,si=En):(Yn=En,si=kn);let Ei,Bn,Kn,ri,bi,bn,zn=!0,ys=Le.bbox;if(ys!=null){zn=!1;let Tn=ys(i,zt);Kn=Tn.left,ri=Tn.top,Ei=Tn.width,Bn=Tn.height}else Kn=Yn,ri=si,Ei=Bn=Le.size(i,zt);if(bn=Le.fill(i,zt),bi=Le.stroke(i,zt),Cn)zt==ns&&Bi<=On.prox&&(Ct=Kn,Lt=ri,qt=Ei,xe=Bn,me=zn,ie=bn,Wt=bi);else{let Tn=gn[zt];Tn!=null&&(Oi[zt]=Kn,ki[zt]=ri,yh(Tn,Ei,Bn,zn),Mh(Tn,bn,bi),Ti(Tn,Qn(Kn),Qn(ri),Z,W))}}}}if(Cn){let zt=On.prox,Ie=Ms==null?Bi<=zt:Bi>zt||ns!=Ms;if(et||Ie){let Ve=gn[0];Ve!=null&&(Oi[0]=Ct,ki[0]=Lt,yh(Ve,qt,xe,me),Mh(Ve,ie,Wt),Ti(Ve,Qn(Ct),Qn(Lt),Z,W))}}}if(Ue.show&&ts)if(_!=null){let[lt,dt]=$e.scales,[Rt,Ct]=$e.match,[Lt,qt]=_.cursor.sync.scales,xe=_.cursor.drag;if(cn=xe._x,un=xe._y,cn||un){let{left:me,top:ie,width:Wt,height:zt}=_.select,Ie=_.scales[Lt].ori,Ve=_.posToVal,fn,we,Ge,kn,En,Yn=lt!=null&&Rt(lt,Lt),si=dt!=null&&Ct(dt,qt);Yn&&cn?(Ie==0?(fn=me,we=Wt):(fn=ie,we=zt),Ge=M[lt],kn=I(Ve(fn,Lt),Ge,q,0),En=I(Ve(fn+we,Lt),Ge,q,0),Kr(fi(kn,En),Qe(En-kn))):Kr(0,q),si&&un?(Ie==1?(fn=me,we=Wt):(fn=ie,we=zt),Ge=M[dt],kn=G(Ve(fn,qt),Ge,it,0),En=G(Ve(fn+we,qt),Ge,it,0),jr(fi(kn,En),Qe(En-kn))):jr(0,it)}else sl()}else{let lt=Qe(Xu-Gu),dt=Qe($u-Wu);if(C.ori==1){let qt=lt;lt=dt,dt=qt}cn=pn.x&&lt>=pn.dist,un=pn.y&&dt>=pn.dist;let Rt=pn.uni;Rt!=null?cn&&un&&(cn=lt>=Rt,un=dt>=Rt,!cn&&!un&&(dt>lt?un=!0:cn=!0)):pn.x&&pn.y&&(cn||un)&&(cn=un=!0);let Ct,Lt;cn&&(C.ori==0?(Ct=tr,Lt=De):(Ct=er,Lt=Be),Kr(fi(Ct,Lt),Qe(Lt-Ct)),un||jr(0,it)),un&&(C.ori==1?(Ct=tr,Lt=De):(Ct=er,Lt=Be),jr(fi(Ct,Lt),Qe(Lt-Ct)),cn||Kr(0,q)),!cn&&!un&&(Kr(0,0),jr(0,0))}if(pn._x=cn,pn._y=un,_==null){if(A){if(rh!=null){let[lt,dt]=$e.scales;$e.values[0]=lt!=null?yi(C.ori==0?De:Be,lt):null,$e.values[1]=dt!=null?yi(C.ori==1?De:Be,dt):null}Jr(cl,i,De,Be,Z,W,L)}if(Fi){let lt=A&&$e.setSeries,dt=On.prox;Ms==null?Bi<=dt&&Si(ns,ir,!0,lt):Bi>dt?Si(null,ir,!0,lt):ns!=Ms&&Si(ns,ir,!0,lt)}}et&&(Mt.idx=L,el()),x!==!1&&hn("setCursor")}let is=null;Object.defineProperty(i,"rect",{get(){return is==null&&Zr(!1),is}});function Zr(_=!1){_?is=null:(is=g.getBoundingClientRect(),hn("syncRect",is))}function Ku(_,x,A,L,N,q,it){pt._lock||ts&&_!=null&&_.movementX==0&&_.movementY==0||(nl(_,x,A,L,N,q,it,!1,_!=null),_!=null?Ss(null,!0,!0):Ss(x,!0,!1))}function nl(_,x,A,L,N,q,it,lt,dt){if(is==null&&Zr(!1),Ze(_),_!=null)A=_.clientX-is.left,L=_.clientY-is.top;else{if(A<0||L<0){De=-10,Be=-10;return}let[Rt,Ct]=$e.scales,Lt=x.cursor.sync,[qt,xe]=Lt.values,[me,ie]=Lt.scales,[Wt,zt]=$e.match,Ie=x.axes[0].side%2==1,Ve=C.ori==0?Z:W,fn=C.ori==1?Z:W,we=Ie?q:N,Ge=Ie?N:q,kn=Ie?L:A,En=Ie?A:L;if(me!=null?A=Wt(Rt,me)?a(qt,M[Rt],Ve,0):-10:A=Ve*(kn/we),ie!=null?L=zt(Ct,ie)?a(xe,M[Ct],fn,0):-10:L=fn*(En/Ge),C.ori==1){let Yn=A;A=L,L=Yn}}dt&&(x==null||x.cursor.event.type==cl)&&((A<=1||A>=Z-1)&&(A=Cs(A,Z)),(L<=1||L>=W-1)&&(L=Cs(L,W))),lt?(Gu=A,Wu=L,[tr,er]=pt.move(i,A,L)):(De=A,Be=L)}const il={width:0,height:0,left:0,top:0};function sl(){Do(il,!1)}let ju,Zu,Ju,Qu;function th(_,x,A,L,N,q,it){ts=!0,cn=un=pn._x=pn._y=!1,nl(_,x,A,L,N,q,it,!0,!1),_!=null&&(Pt(ul,Jl,eh,!1),Jr(dh,i,tr,er,Z,W,null));let{left:lt,top:dt,width:Rt,height:Ct}=Ue;ju=lt,Zu=dt,Ju=Rt,Qu=Ct}function eh(_,x,A,L,N,q,it){ts=pn._x=pn._y=!1,nl(_,x,A,L,N,q,it,!1,!0);let{left:lt,top:dt,width:Rt,height:Ct}=Ue,Lt=Rt>0||Ct>0,qt=ju!=lt||Zu!=dt||Ju!=Rt||Qu!=Ct;if(Lt&&qt&&Do(Ue),pn.setScale&&Lt&&qt){let xe=lt,me=Rt,ie=dt,Wt=Ct;if(C.ori==1&&(xe=dt,me=Ct,ie=lt,Wt=Rt),cn&&es(R,yi(xe,R),yi(xe+me,R)),un)for(let zt in M){let Ie=M[zt];zt!=R&&Ie.from==null&&Ie.min!=Ce&&es(zt,yi(ie+Wt,zt),yi(ie,zt))}sl()}else pt.lock&&(pt._lock=!pt._lock,Ss(x,!0,_!=null));_!=null&&(P(ul,Jl),Jr(ul,i,De,Be,Z,W,null))}function vm(_,x,A,L,N,q,it){if(pt._lock)return;Ze(_);let lt=ts;if(ts){let dt=!0,Rt=!0,Ct=10,Lt,qt;C.ori==0?(Lt=cn,qt=un):(Lt=un,qt=cn),Lt&&qt&&(dt=De<=Ct||De>=Z-Ct,Rt=Be<=Ct||Be>=W-Ct),Lt&&dt&&(De=De<tr?0:Z),qt&&Rt&&(Be=Be<er?0:W),Ss(null,!0,!0),ts=!1}De=-10,Be=-10,mt.fill(null),Ss(null,!0,!0),lt&&(ts=lt)}function nh(_,x,A,L,N,q,it){pt._lock||(Ze(_),Dt(),sl(),_!=null&&Jr(gh,i,De,Be,Z,W,null))}function ih(){w.forEach(K_),st(i.width,i.height,!0)}ks(Ta,yr,ih);const sr={};sr.mousedown=th,sr.mousemove=Ku,sr.mouseup=eh,sr.dblclick=nh,sr.setSeries=(_,x,A,L)=>{let N=$e.match[2];A=N(i,x,A),A!=-1&&Si(A,L,!0,!1)},at&&(Pt(dh,g,th),Pt(cl,g,Ku),Pt(ph,g,_=>{Ze(_),Zr(!1)}),Pt(mh,g,vm),Pt(gh,g,nh),oc.add(i),i.syncRect=Zr);const Uo=i.hooks=n.hooks||{};function hn(_,x,A){Za?Yr.push([_,x,A]):_ in Uo&&Uo[_].forEach(L=>{L.call(null,i,x,A)})}(n.plugins||[]).forEach(_=>{for(let x in _.hooks)Uo[x]=(Uo[x]||[]).concat(_.hooks[x])});const sh=(_,x,A)=>A,$e=Ye({key:null,setSeries:!1,filters:{pub:Ah,sub:Ah},scales:[R,E[1]?E[1].scale:null],match:[Rh,Rh,sh],values:[null,null]},pt.sync);$e.match.length==2&&$e.match.push(sh),pt.sync=$e;const rh=$e.key,rl=ep(rh);function Jr(_,x,A,L,N,q,it){$e.filters.pub(_,x,A,L,N,q,it)&&rl.pub(_,x,A,L,N,q,it)}rl.sub(i);function xm(_,x,A,L,N,q,it){$e.filters.sub(_,x,A,L,N,q,it)&&sr[_](null,x,A,L,N,q,it)}i.pub=xm;function Mm(){rl.unsub(i),oc.delete(i),he.clear(),ec(Ta,yr,ih),c.remove(),rt?.remove(),hn("destroy")}i.destroy=Mm;function ol(){hn("init",n,t),Ft(t||n.data,!1),j[R]?Ja(R,j[R]):Dt(),xt=Ue.show&&(Ue.width>0||Ue.height>0),k=et=!0,st(n.width,n.height)}return E.forEach(qr),w.forEach(Ka),e?e instanceof HTMLElement?(e.appendChild(c),ol()):e(i,ol):ol(),i}Sn.assign=Ye;Sn.fmtNum=mu;Sn.rangeNum=wa;Sn.rangeLog=Oa;Sn.rangeAsinh=du;Sn.orient=Ws;Sn.pxRatio=Me;Sn.join=zg;Sn.fmtDate=_u,Sn.tzDate=Zg;Sn.sync=ep;{Sn.addGap=U_,Sn.clipGaps=za;let n=Sn.paths={points:ap};n.linear=cp,n.stepped=F_,n.bars=O_,n.spline=B_}const ko=n=>document.getElementById(n),j_=["#7cc4ff","#56d6b0","#d59bf6","#ffb652","#f2f5f8","#ff7a5c"];function Z_(n,t,e,i){const s={stroke:"#8fa1b3",grid:{stroke:"#1b2733",width:1},ticks:{stroke:"#1b2733"},font:`${.68*i}px system-ui`,size:2.3*i},r={stroke:"#ffb65290",width:1,dash:[4,4],points:{show:!1}};return{width:t,height:e,legend:{show:!1},cursor:{show:!1},padding:[i*.3,i*.4,0,0],scales:{x:{time:!1},y:{range:(o,a,l)=>{const c=Math.max(Math.abs(a||0),Math.abs(l||0),n.least);return[-c*1.1,c*1.1]}}},axes:[{...s,size:1.5*i,gap:1},{...s,gap:1,space:1.5*i,label:n.title,labelSize:1.1*i,labelFont:`${.7*i}px system-ui`}],series:[{},...n.curves.map((o,a)=>({stroke:j_[a],width:1.5,points:{show:!1}})),r,r]}}class J_{constructor(t,e){Object.assign(this,{strip:t,window:e,element:document.createElement("div")})}size(){const t=parseFloat(getComputedStyle(document.documentElement).fontSize),e=this.element.parentElement.clientWidth;return{width:Math.max(e,60),height:6.4*t,rem:t}}show({t,curves:e,spread:i},s){const r=this.size();(!this.plot||this.width!==r.width)&&(this.plot&&this.plot.destroy(),this.plot=new Sn(Z_(this.strip,r.width,r.height,r.rem),[[],...e.map(()=>[]),[],[]],this.element),this.width=r.width);let o=t.length;if(s!==void 0)for(;o>0&&t[o-1]>s;)o-=1;let a=o;for(;a>0&&t[a-1]>(t[o-1]??0)-this.window;)a-=1;const l=u=>u.slice(a,o),c=l(i);this.plot.setData([l(t),...e.map(l),c,c.map(u=>u===null?null:-u)])}}class Q_{setDisplay({charts:t}){ko("strips").hidden=!t,this.note=t?.note,this.strips=(t?.strips||[]).map(e=>new J_(e,t.window_s)),ko("charts").replaceChildren(...this.strips.map(e=>e.element)),ko("charts-title").textContent=t?.title||""}show(t,e,i){this.strips.forEach((s,r)=>s.show(t[r],i)),this.note&&Zl(wr(e,this.note)??["",!1],ko("charts-note"),"dim")}}/**
 * @license
 * Copyright 2010-2024 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const bu="170",t0=0,jh=1,e0=2,dp=1,n0=2,Xi=3,ms=0,Un=1,Ri=2,fs=0,Er=1,Zh=2,Jh=3,Qh=4,i0=5,Is=100,s0=101,r0=102,o0=103,a0=104,l0=200,c0=201,u0=202,h0=203,lc=204,cc=205,f0=206,d0=207,p0=208,m0=209,g0=210,_0=211,v0=212,x0=213,M0=214,uc=0,hc=1,fc=2,Dr=3,dc=4,pc=5,mc=6,gc=7,Tu=0,S0=1,y0=2,ds=0,E0=1,b0=2,T0=3,w0=4,A0=5,R0=6,C0=7,pp=300,Ur=301,Ir=302,_c=303,vc=304,Wa=306,xc=1e3,Fs=1001,Mc=1002,gi=1003,P0=1004,Bo=1005,Pi=1006,ml=1007,Os=1008,Ji=1009,mp=1010,gp=1011,xo=1012,wu=1013,zs=1014,$i=1015,Eo=1016,Au=1017,Ru=1018,Nr=1020,_p=35902,vp=1021,xp=1022,pi=1023,Mp=1024,Sp=1025,br=1026,Fr=1027,yp=1028,Cu=1029,Ep=1030,Pu=1031,Lu=1033,_a=33776,va=33777,xa=33778,Ma=33779,Sc=35840,yc=35841,Ec=35842,bc=35843,Tc=36196,wc=37492,Ac=37496,Rc=37808,Cc=37809,Pc=37810,Lc=37811,Dc=37812,Uc=37813,Ic=37814,Nc=37815,Fc=37816,Oc=37817,kc=37818,Bc=37819,zc=37820,Hc=37821,Sa=36492,Vc=36494,Gc=36495,bp=36283,Wc=36284,Xc=36285,$c=36286,L0=3200,D0=3201,Tp=0,U0=1,hs="",ti="srgb",Xs="srgb-linear",Xa="linear",Ae="srgb",or=7680,tf=519,I0=512,N0=513,F0=514,wp=515,O0=516,k0=517,B0=518,z0=519,ef=35044,nf="300 es",qi=2e3,Ra=2001;class Hr{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){if(this._listeners===void 0)return!1;const i=this._listeners;return i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){if(this._listeners===void 0)return;const s=this._listeners[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){if(this._listeners===void 0)return;const i=this._listeners[t.type];if(i!==void 0){t.target=this;const s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ya=Math.PI/180,qc=180/Math.PI;function bo(){const n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(vn[n&255]+vn[n>>8&255]+vn[n>>16&255]+vn[n>>24&255]+"-"+vn[t&255]+vn[t>>8&255]+"-"+vn[t>>16&15|64]+vn[t>>24&255]+"-"+vn[e&63|128]+vn[e>>8&255]+"-"+vn[e>>16&255]+vn[e>>24&255]+vn[i&255]+vn[i>>8&255]+vn[i>>16&255]+vn[i>>24&255]).toLowerCase()}function An(n,t,e){return Math.max(t,Math.min(e,n))}function H0(n,t){return(n%t+t)%t}function gl(n,t,e){return(1-e)*n+e*t}function eo(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return n/4294967295;case Uint16Array:return n/65535;case Uint8Array:return n/255;case Int32Array:return Math.max(n/2147483647,-1);case Int16Array:return Math.max(n/32767,-1);case Int8Array:return Math.max(n/127,-1);default:throw new Error("Invalid component type.")}}function Ln(n,t){switch(t.constructor){case Float32Array:return n;case Uint32Array:return Math.round(n*4294967295);case Uint16Array:return Math.round(n*65535);case Uint8Array:return Math.round(n*255);case Int32Array:return Math.round(n*2147483647);case Int16Array:return Math.round(n*32767);case Int8Array:return Math.round(n*127);default:throw new Error("Invalid component type.")}}class ae{constructor(t=0,e=0){ae.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(An(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Qt{constructor(t,e,i,s,r,o,a,l,c){Qt.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],g=i[8],v=s[0],m=s[3],p=s[6],E=s[1],w=s[4],M=s[7],O=s[2],R=s[5],D=s[8];return r[0]=o*v+a*E+l*O,r[3]=o*m+a*w+l*R,r[6]=o*p+a*M+l*D,r[1]=c*v+u*E+h*O,r[4]=c*m+u*w+h*R,r[7]=c*p+u*M+h*D,r[2]=f*v+d*E+g*O,r[5]=f*m+d*w+g*R,r[8]=f*p+d*M+g*D,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+i*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return t[0]=h*v,t[1]=(s*c-u*i)*v,t[2]=(a*i-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(i*l-c*e)*v,t[8]=(o*e-i*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(_l.makeScale(t,e)),this}rotate(t){return this.premultiply(_l.makeRotation(-t)),this}translate(t,e){return this.premultiply(_l.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const _l=new Qt;function Ap(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Ca(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function V0(){const n=Ca("canvas");return n.style.display="block",n}const sf={};function uo(n){n in sf||(sf[n]=!0,console.warn(n))}function G0(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}function W0(n){const t=n.elements;t[2]=.5*t[2]+.5*t[3],t[6]=.5*t[6]+.5*t[7],t[10]=.5*t[10]+.5*t[11],t[14]=.5*t[14]+.5*t[15]}function X0(n){const t=n.elements;t[11]===-1?(t[10]=-t[10]-1,t[14]=-t[14]):(t[10]=-t[10],t[14]=-t[14]+1)}const pe={enabled:!0,workingColorSpace:Xs,spaces:{},convert:function(n,t,e){return this.enabled===!1||t===e||!t||!e||(this.spaces[t].transfer===Ae&&(n.r=Zi(n.r),n.g=Zi(n.g),n.b=Zi(n.b)),this.spaces[t].primaries!==this.spaces[e].primaries&&(n.applyMatrix3(this.spaces[t].toXYZ),n.applyMatrix3(this.spaces[e].fromXYZ)),this.spaces[e].transfer===Ae&&(n.r=Tr(n.r),n.g=Tr(n.g),n.b=Tr(n.b))),n},fromWorkingColorSpace:function(n,t){return this.convert(n,this.workingColorSpace,t)},toWorkingColorSpace:function(n,t){return this.convert(n,t,this.workingColorSpace)},getPrimaries:function(n){return this.spaces[n].primaries},getTransfer:function(n){return n===hs?Xa:this.spaces[n].transfer},getLuminanceCoefficients:function(n,t=this.workingColorSpace){return n.fromArray(this.spaces[t].luminanceCoefficients)},define:function(n){Object.assign(this.spaces,n)},_getMatrix:function(n,t,e){return n.copy(this.spaces[t].toXYZ).multiply(this.spaces[e].fromXYZ)},_getDrawingBufferColorSpace:function(n){return this.spaces[n].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(n=this.workingColorSpace){return this.spaces[n].workingColorSpaceConfig.unpackColorSpace}};function Zi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Tr(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}const rf=[.64,.33,.3,.6,.15,.06],of=[.2126,.7152,.0722],af=[.3127,.329],lf=new Qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),cf=new Qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);pe.define({[Xs]:{primaries:rf,whitePoint:af,transfer:Xa,toXYZ:lf,fromXYZ:cf,luminanceCoefficients:of,workingColorSpaceConfig:{unpackColorSpace:ti},outputColorSpaceConfig:{drawingBufferColorSpace:ti}},[ti]:{primaries:rf,whitePoint:af,transfer:Ae,toXYZ:lf,fromXYZ:cf,luminanceCoefficients:of,outputColorSpaceConfig:{drawingBufferColorSpace:ti}}});let ar;class $0{static getDataURL(t){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let e;if(t instanceof HTMLCanvasElement)e=t;else{ar===void 0&&(ar=Ca("canvas")),ar.width=t.width,ar.height=t.height;const i=ar.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),e=ar}return e.width>2048||e.height>2048?(console.warn("THREE.ImageUtils.getDataURL: Image converted to jpg for performance reasons",t),e.toDataURL("image/jpeg",.6)):e.toDataURL("image/png")}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Ca("canvas");e.width=t.width,e.height=t.height;const i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);const s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Zi(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Zi(e[i]/255)*255):e[i]=Zi(e[i]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let q0=0;class Rp{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:q0++}),this.uuid=bo(),this.data=t,this.dataReady=!0,this.version=0}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(vl(s[o].image)):r.push(vl(s[o]))}else r=vl(s);i.url=r}return e||(t.images[this.uuid]=i),i}}function vl(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?$0.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let Y0=0;class In extends Hr{constructor(t=In.DEFAULT_IMAGE,e=In.DEFAULT_MAPPING,i=Fs,s=Fs,r=Pi,o=Os,a=pi,l=Ji,c=In.DEFAULT_ANISOTROPY,u=hs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Y0++}),this.uuid=bo(),this.name="",this.source=new Rp(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ae(0,0),this.repeat=new ae(1,1),this.center=new ae(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qt,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.version=0,this.onUpdate=null,this.isRenderTargetTexture=!1,this.pmremVersion=0}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const i={metadata:{version:4.6,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==pp)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case xc:t.x=t.x-Math.floor(t.x);break;case Fs:t.x=t.x<0?0:1;break;case Mc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case xc:t.y=t.y-Math.floor(t.y);break;case Fs:t.y=t.y<0?0:1;break;case Mc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}In.DEFAULT_IMAGE=null;In.DEFAULT_MAPPING=pp;In.DEFAULT_ANISOTROPY=1;class We{constructor(t=0,e=0,i=0,s=1){We.prototype.isVector4=!0,this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const w=(c+1)/2,M=(d+1)/2,O=(p+1)/2,R=(u+f)/4,D=(h+v)/4,U=(g+m)/4;return w>M&&w>O?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=R/i,r=D/i):M>O?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=R/s,r=U/s):O<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(O),i=D/r,s=U/r),this.set(i,s,r,e),this}let E=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(E)<.001&&(E=1),this.x=(m-g)/E,this.y=(h-v)/E,this.z=(f-u)/E,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this.w=Math.max(t.w,Math.min(e.w,this.w)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this.w=Math.max(t,Math.min(e,this.w)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class K0 extends Hr{constructor(t=1,e=1,i={}){super(),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=1,this.scissor=new We(0,0,t,e),this.scissorTest=!1,this.viewport=new We(0,0,t,e);const s={width:t,height:e,depth:1};i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Pi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1},i);const r=new In(s,i.mapping,i.wrapS,i.wrapT,i.magFilter,i.minFilter,i.format,i.type,i.anisotropy,i.colorSpace);r.flipY=!1,r.generateMipmaps=i.generateMipmaps,r.internalFormat=i.internalFormat,this.textures=[];const o=i.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0;this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.depthTexture=i.depthTexture,this.samples=i.samples}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let i=0,s=t.textures.length;i<s;i++)this.textures[i]=t.textures[i].clone(),this.textures[i].isRenderTargetTexture=!0;const e=Object.assign({},t.texture.image);return this.texture.source=new Rp(e),this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Hs extends K0{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}}class Cp extends In{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=gi,this.minFilter=gi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class j0 extends In{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=gi,this.minFilter=gi,this.wrapR=Fs,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class $s{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3];const f=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==f||c!==d||u!==g){let m=1-a;const p=l*f+c*d+u*g+h*v,E=p>=0?1:-1,w=1-p*p;if(w>Number.EPSILON){const O=Math.sqrt(w),R=Math.atan2(O,p*E);m=Math.sin(m*R)/O,a=Math.sin(a*R)/O}const M=a*E;if(l=l*m+f*M,c=c*m+d*M,u=u*m+g*M,h=h*m+v*M,m===1-a){const O=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=O,c*=O,u*=O,h*=O}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,i,s,r,o){const a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=i+a+h;if(f>0){const d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){const d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){const d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<Number.EPSILON?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(An(this.dot(t),-1,1)))}rotateTowards(t,e){const i=this.angleTo(t);if(i===0)return this;const s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const i=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+i*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=i,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const d=1-e;return this._w=d*o+e*this._w,this._x=d*i+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=i*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class z{constructor(t=0,e=0,i=0){z.prototype.isVector3=!0,this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(uf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(uf.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),u=2*(a*e-r*s),h=2*(r*i-o*e);return this.x=e+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Math.max(t.x,Math.min(e.x,this.x)),this.y=Math.max(t.y,Math.min(e.y,this.y)),this.z=Math.max(t.z,Math.min(e.z,this.z)),this}clampScalar(t,e){return this.x=Math.max(t,Math.min(e,this.x)),this.y=Math.max(t,Math.min(e,this.y)),this.z=Math.max(t,Math.min(e,this.z)),this}clampLength(t,e){const i=this.length();return this.divideScalar(i||1).multiplyScalar(Math.max(t,Math.min(e,i)))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return xl.copy(this).projectOnVector(t),this.sub(xl)}reflect(t){return this.sub(xl.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const i=this.dot(t)/e;return Math.acos(An(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){const s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const xl=new z,uf=new $s;class Vr{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(oi.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(oi.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const i=oi.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const i=t.geometry;if(i!==void 0){const r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,oi):oi.fromBufferAttribute(r,o),oi.applyMatrix4(t.matrixWorld),this.expandByPoint(oi);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),zo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),zo.copy(i.boundingBox)),zo.applyMatrix4(t.matrixWorld),this.union(zo)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,oi),oi.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(no),Ho.subVectors(this.max,no),lr.subVectors(t.a,no),cr.subVectors(t.b,no),ur.subVectors(t.c,no),ss.subVectors(cr,lr),rs.subVectors(ur,cr),Es.subVectors(lr,ur);let e=[0,-ss.z,ss.y,0,-rs.z,rs.y,0,-Es.z,Es.y,ss.z,0,-ss.x,rs.z,0,-rs.x,Es.z,0,-Es.x,-ss.y,ss.x,0,-rs.y,rs.x,0,-Es.y,Es.x,0];return!Ml(e,lr,cr,ur,Ho)||(e=[1,0,0,0,1,0,0,0,1],!Ml(e,lr,cr,ur,Ho))?!1:(Vo.crossVectors(ss,rs),e=[Vo.x,Vo.y,Vo.z],Ml(e,lr,cr,ur,Ho))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,oi).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(oi).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(zi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),zi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),zi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),zi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),zi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),zi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),zi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),zi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(zi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}}const zi=[new z,new z,new z,new z,new z,new z,new z,new z],oi=new z,zo=new Vr,lr=new z,cr=new z,ur=new z,ss=new z,rs=new z,Es=new z,no=new z,Ho=new z,Vo=new z,bs=new z;function Ml(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){bs.fromArray(n,r);const a=s.x*Math.abs(bs.x)+s.y*Math.abs(bs.y)+s.z*Math.abs(bs.z),l=t.dot(bs),c=e.dot(bs),u=i.dot(bs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const Z0=new Vr,io=new z,Sl=new z;class To{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const i=this.center;e!==void 0?i.copy(e):Z0.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;io.subVectors(t,this.center);const e=io.lengthSq();if(e>this.radius*this.radius){const i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(io,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Sl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(io.copy(t.center).add(Sl)),this.expandByPoint(io.copy(t.center).sub(Sl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}}const Hi=new z,yl=new z,Go=new z,os=new z,El=new z,Wo=new z,bl=new z;class Du{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Hi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Hi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Hi.copy(this.origin).addScaledVector(this.direction,e),Hi.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){yl.copy(t).add(e).multiplyScalar(.5),Go.copy(e).sub(t).normalize(),os.copy(this.origin).sub(yl);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Go),a=os.dot(this.direction),l=-os.dot(Go),c=os.lengthSq(),u=Math.abs(1-o*o);let h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){const v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(yl).addScaledVector(Go,f),d}intersectSphere(t,e){Hi.subVectors(t.center,this.origin);const i=Hi.dot(this.direction),s=Hi.dot(Hi)-i*i,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){const i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Hi)!==null}intersectTriangle(t,e,i,s,r){El.subVectors(e,t),Wo.subVectors(i,t),bl.crossVectors(El,Wo);let o=this.direction.dot(bl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;os.subVectors(this.origin,t);const l=a*this.direction.dot(Wo.crossVectors(os,Wo));if(l<0)return null;const c=a*this.direction.dot(El.cross(os));if(c<0||l+c>o)return null;const u=-a*os.dot(bl);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class ze{constructor(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){ze.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m)}set(t,e,i,s,r,o,a,l,c,u,h,f,d,g,v,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=i,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new ze().fromArray(this.elements)}copy(t){const e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){const e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,i=t.elements,s=1/hr.setFromMatrixColumn(t,0).length(),r=1/hr.setFromMatrixColumn(t,1).length(),o=1/hr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+g,e[10]=f-v*h}else if(t.order==="XZY"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(J0,t,Q0)}lookAt(t,e,i){const s=this.elements;return Hn.subVectors(t,e),Hn.lengthSq()===0&&(Hn.z=1),Hn.normalize(),as.crossVectors(i,Hn),as.lengthSq()===0&&(Math.abs(i.z)===1?Hn.x+=1e-4:Hn.z+=1e-4,Hn.normalize(),as.crossVectors(i,Hn)),as.normalize(),Xo.crossVectors(Hn,as),s[0]=as.x,s[4]=Xo.x,s[8]=Hn.x,s[1]=as.y,s[5]=Xo.y,s[9]=Hn.y,s[2]=as.z,s[6]=Xo.z,s[10]=Hn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],g=i[2],v=i[6],m=i[10],p=i[14],E=i[3],w=i[7],M=i[11],O=i[15],R=s[0],D=s[4],U=s[8],T=s[12],S=s[1],C=s[5],V=s[9],I=s[13],G=s[2],j=s[6],K=s[10],J=s[14],Q=s[3],ht=s[7],ct=s[11],mt=s[15];return r[0]=o*R+a*S+l*G+c*Q,r[4]=o*D+a*C+l*j+c*ht,r[8]=o*U+a*V+l*K+c*ct,r[12]=o*T+a*I+l*J+c*mt,r[1]=u*R+h*S+f*G+d*Q,r[5]=u*D+h*C+f*j+d*ht,r[9]=u*U+h*V+f*K+d*ct,r[13]=u*T+h*I+f*J+d*mt,r[2]=g*R+v*S+m*G+p*Q,r[6]=g*D+v*C+m*j+p*ht,r[10]=g*U+v*V+m*K+p*ct,r[14]=g*T+v*I+m*J+p*mt,r[3]=E*R+w*S+M*G+O*Q,r[7]=E*D+w*C+M*j+O*ht,r[11]=E*U+w*V+M*K+O*ct,r[15]=E*T+w*I+M*J+O*mt,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*f+i*c*f+s*a*d-i*l*d)+v*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+e*c*h-e*a*d-r*o*h+i*o*d+r*a*u-i*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-i*o*f+i*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){const t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],E=h*m*c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,w=g*f*c-u*m*c-g*l*d+o*m*d+u*l*p-o*f*p,M=u*v*c-g*h*c+g*a*d-o*v*d-u*a*p+o*h*p,O=g*h*l-u*v*l-g*a*f+o*v*f+u*a*m-o*h*m,R=e*E+i*w+s*M+r*O;if(R===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const D=1/R;return t[0]=E*D,t[1]=(v*f*r-h*m*r-v*s*d+i*m*d+h*s*p-i*f*p)*D,t[2]=(a*m*r-v*l*r+v*s*c-i*m*c-a*s*p+i*l*p)*D,t[3]=(h*l*r-a*f*r-h*s*c+i*f*c+a*s*d-i*l*d)*D,t[4]=w*D,t[5]=(u*m*r-g*f*r+g*s*d-e*m*d-u*s*p+e*f*p)*D,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*D,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*D,t[8]=M*D,t[9]=(g*h*r-u*v*r-g*i*d+e*v*d+u*i*p-e*h*p)*D,t[10]=(o*v*r-g*a*r+g*i*c-e*v*c-o*i*p+e*a*p)*D,t[11]=(u*a*r-o*h*r-u*i*c+e*h*c+o*i*d-e*a*d)*D,t[12]=O*D,t[13]=(u*v*s-g*h*s+g*i*f-e*v*f-u*i*m+e*h*m)*D,t[14]=(g*a*s-o*v*s-g*i*l+e*v*l+o*i*m-e*a*m)*D,t[15]=(o*h*s-u*a*s+u*i*l-e*h*l-o*i*f+e*a*f)*D,this}scale(t){const e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,v=o*u,m=o*h,p=a*h,E=l*c,w=l*u,M=l*h,O=i.x,R=i.y,D=i.z;return s[0]=(1-(v+p))*O,s[1]=(d+M)*O,s[2]=(g-w)*O,s[3]=0,s[4]=(d-M)*R,s[5]=(1-(f+p))*R,s[6]=(m+E)*R,s[7]=0,s[8]=(g+w)*D,s[9]=(m-E)*D,s[10]=(1-(f+v))*D,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){const s=this.elements;let r=hr.set(s[0],s[1],s[2]).length();const o=hr.set(s[4],s[5],s[6]).length(),a=hr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],ai.copy(this);const c=1/r,u=1/o,h=1/a;return ai.elements[0]*=c,ai.elements[1]*=c,ai.elements[2]*=c,ai.elements[4]*=u,ai.elements[5]*=u,ai.elements[6]*=u,ai.elements[8]*=h,ai.elements[9]*=h,ai.elements[10]*=h,e.setFromRotationMatrix(ai),i.x=r,i.y=o,i.z=a,this}makePerspective(t,e,i,s,r,o,a=qi){const l=this.elements,c=2*r/(e-t),u=2*r/(i-s),h=(e+t)/(e-t),f=(i+s)/(i-s);let d,g;if(a===qi)d=-(o+r)/(o-r),g=-2*o*r/(o-r);else if(a===Ra)d=-o/(o-r),g=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=c,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=d,l[14]=g,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=qi){const l=this.elements,c=1/(e-t),u=1/(i-s),h=1/(o-r),f=(e+t)*c,d=(i+s)*u;let g,v;if(a===qi)g=(o+r)*h,v=-2*h;else if(a===Ra)g=r*h,v=-1*h;else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=2*c,l[4]=0,l[8]=0,l[12]=-f,l[1]=0,l[5]=2*u,l[9]=0,l[13]=-d,l[2]=0,l[6]=0,l[10]=v,l[14]=-g,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){const e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){const i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}}const hr=new z,ai=new ze,J0=new z(0,0,0),Q0=new z(1,1,1),as=new z,Xo=new z,Hn=new z,hf=new ze,ff=new $s;class Ni{constructor(t=0,e=0,i=0,s=Ni.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(An(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-An(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(An(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-An(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(An(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-An(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return hf.makeRotationFromQuaternion(t),this.setFromRotationMatrix(hf,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return ff.setFromEuler(this),this.setFromQuaternion(ff,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Ni.DEFAULT_ORDER="XYZ";class Pp{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let tv=0;const df=new z,fr=new $s,Vi=new ze,$o=new z,so=new z,ev=new z,nv=new $s,pf=new z(1,0,0),mf=new z(0,1,0),gf=new z(0,0,1),_f={type:"added"},iv={type:"removed"},dr={type:"childadded",child:null},Tl={type:"childremoved",child:null};class en extends Hr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:tv++}),this.uuid=bo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=en.DEFAULT_UP.clone();const t=new z,e=new Ni,i=new $s,s=new z(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ze},normalMatrix:{value:new Qt}}),this.matrix=new ze,this.matrixWorld=new ze,this.matrixAutoUpdate=en.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=en.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Pp,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return fr.setFromAxisAngle(t,e),this.quaternion.multiply(fr),this}rotateOnWorldAxis(t,e){return fr.setFromAxisAngle(t,e),this.quaternion.premultiply(fr),this}rotateX(t){return this.rotateOnAxis(pf,t)}rotateY(t){return this.rotateOnAxis(mf,t)}rotateZ(t){return this.rotateOnAxis(gf,t)}translateOnAxis(t,e){return df.copy(t).applyQuaternion(this.quaternion),this.position.add(df.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(pf,t)}translateY(t){return this.translateOnAxis(mf,t)}translateZ(t){return this.translateOnAxis(gf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Vi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?$o.copy(t):$o.set(t,e,i);const s=this.parent;this.updateWorldMatrix(!0,!1),so.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Vi.lookAt(so,$o,this.up):Vi.lookAt($o,so,this.up),this.quaternion.setFromRotationMatrix(Vi),s&&(Vi.extractRotation(s.matrixWorld),fr.setFromRotationMatrix(Vi),this.quaternion.premultiply(fr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(_f),dr.child=t,this.dispatchEvent(dr),dr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(iv),Tl.child=t,this.dispatchEvent(Tl),Tl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Vi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Vi.multiply(t.parent.matrixWorld)),t.applyMatrix4(Vi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(_f),dr.child=t,this.dispatchEvent(dr),dr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){const o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(so,t,ev),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(so,nv,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e){const i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.6,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.visibility=this._visibility,s.active=this._active,s.bounds=this._bounds.map(a=>({boxInitialized:a.boxInitialized,boxMin:a.box.min.toArray(),boxMax:a.box.max.toArray(),sphereInitialized:a.sphereInitialized,sphereRadius:a.sphere.radius,sphereCenter:a.sphere.center.toArray()})),s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.geometryCount=this._geometryCount,s.matricesTexture=this._matricesTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere={center:s.boundingSphere.center.toArray(),radius:s.boundingSphere.radius}),this.boundingBox!==null&&(s.boundingBox={min:s.boundingBox.min.toArray(),max:s.boundingBox.max.toArray()}));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){const s=t.children[i];this.add(s.clone())}return this}}en.DEFAULT_UP=new z(0,1,0);en.DEFAULT_MATRIX_AUTO_UPDATE=!0;en.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const li=new z,Gi=new z,wl=new z,Wi=new z,pr=new z,mr=new z,vf=new z,Al=new z,Rl=new z,Cl=new z,Pl=new We,Ll=new We,Dl=new We;class ei{constructor(t=new z,e=new z,i=new z){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),li.subVectors(t,e),s.cross(li);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){li.subVectors(s,e),Gi.subVectors(i,e),wl.subVectors(t,e);const o=li.dot(li),a=li.dot(Gi),l=li.dot(wl),c=Gi.dot(Gi),u=Gi.dot(wl),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,Wi)===null?!1:Wi.x>=0&&Wi.y>=0&&Wi.x+Wi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,Wi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Wi.x),l.addScaledVector(o,Wi.y),l.addScaledVector(a,Wi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Pl.setScalar(0),Ll.setScalar(0),Dl.setScalar(0),Pl.fromBufferAttribute(t,e),Ll.fromBufferAttribute(t,i),Dl.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Pl,r.x),o.addScaledVector(Ll,r.y),o.addScaledVector(Dl,r.z),o}static isFrontFacing(t,e,i,s){return li.subVectors(i,e),Gi.subVectors(t,e),li.cross(Gi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return li.subVectors(this.c,this.b),Gi.subVectors(this.a,this.b),li.cross(Gi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ei.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ei.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return ei.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return ei.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ei.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const i=this.a,s=this.b,r=this.c;let o,a;pr.subVectors(s,i),mr.subVectors(r,i),Al.subVectors(t,i);const l=pr.dot(Al),c=mr.dot(Al);if(l<=0&&c<=0)return e.copy(i);Rl.subVectors(t,s);const u=pr.dot(Rl),h=mr.dot(Rl);if(u>=0&&h<=u)return e.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(i).addScaledVector(pr,o);Cl.subVectors(t,r);const d=pr.dot(Cl),g=mr.dot(Cl);if(g>=0&&d<=g)return e.copy(r);const v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(mr,a);const m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return vf.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(vf,a);const p=1/(m+v+f);return o=v*p,a=f*p,e.copy(i).addScaledVector(pr,o).addScaledVector(mr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const Lp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ls={h:0,s:0,l:0},qo={h:0,s:0,l:0};function Ul(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}class oe{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=ti){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,pe.toWorkingColorSpace(this,e),this}setRGB(t,e,i,s=pe.workingColorSpace){return this.r=t,this.g=e,this.b=i,pe.toWorkingColorSpace(this,s),this}setHSL(t,e,i,s=pe.workingColorSpace){if(t=H0(t,1),e=An(e,0,1),i=An(i,0,1),e===0)this.r=this.g=this.b=i;else{const r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Ul(o,r,t+1/3),this.g=Ul(o,r,t),this.b=Ul(o,r,t-1/3)}return pe.toWorkingColorSpace(this,s),this}setStyle(t,e=ti){function i(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=ti){const i=Lp[t.toLowerCase()];return i!==void 0?this.setHex(i,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Zi(t.r),this.g=Zi(t.g),this.b=Zi(t.b),this}copyLinearToSRGB(t){return this.r=Tr(t.r),this.g=Tr(t.g),this.b=Tr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=ti){return pe.fromWorkingColorSpace(xn.copy(this),t),Math.round(An(xn.r*255,0,255))*65536+Math.round(An(xn.g*255,0,255))*256+Math.round(An(xn.b*255,0,255))}getHexString(t=ti){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=pe.workingColorSpace){pe.fromWorkingColorSpace(xn.copy(this),e);const i=xn.r,s=xn.g,r=xn.b,o=Math.max(i,s,r),a=Math.min(i,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=pe.workingColorSpace){return pe.fromWorkingColorSpace(xn.copy(this),e),t.r=xn.r,t.g=xn.g,t.b=xn.b,t}getStyle(t=ti){pe.fromWorkingColorSpace(xn.copy(this),t);const e=xn.r,i=xn.g,s=xn.b;return t!==ti?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(ls),this.setHSL(ls.h+t,ls.s+e,ls.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(ls),t.getHSL(qo);const i=gl(ls.h,qo.h,e),s=gl(ls.s,qo.s,e),r=gl(ls.l,qo.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const xn=new oe;oe.NAMES=Lp;let sv=0;class qs extends Hr{static get type(){return"Material"}get type(){return this.constructor.type}set type(t){}constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:sv++}),this.uuid=bo(),this.name="",this.blending=Er,this.side=ms,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=lc,this.blendDst=cc,this.blendEquation=Is,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new oe(0,0,0),this.blendAlpha=0,this.depthFunc=Dr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=tf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=or,this.stencilZFail=or,this.stencilZPass=or,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const i=t[e];if(i===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const i={metadata:{version:4.6,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,this.name!==""&&(i.name=this.name),this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(i.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.shadowSide!==null&&(i.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),this.blending!==Er&&(i.blending=this.blending),this.side!==ms&&(i.side=this.side),this.vertexColors===!0&&(i.vertexColors=!0),this.opacity<1&&(i.opacity=this.opacity),this.transparent===!0&&(i.transparent=!0),this.blendSrc!==lc&&(i.blendSrc=this.blendSrc),this.blendDst!==cc&&(i.blendDst=this.blendDst),this.blendEquation!==Is&&(i.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(i.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(i.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(i.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(i.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(i.blendAlpha=this.blendAlpha),this.depthFunc!==Dr&&(i.depthFunc=this.depthFunc),this.depthTest===!1&&(i.depthTest=this.depthTest),this.depthWrite===!1&&(i.depthWrite=this.depthWrite),this.colorWrite===!1&&(i.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(i.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==tf&&(i.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(i.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(i.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==or&&(i.stencilFail=this.stencilFail),this.stencilZFail!==or&&(i.stencilZFail=this.stencilZFail),this.stencilZPass!==or&&(i.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(i.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(i.rotation=this.rotation),this.polygonOffset===!0&&(i.polygonOffset=!0),this.polygonOffsetFactor!==0&&(i.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(i.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(i.linewidth=this.linewidth),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.dithering===!0&&(i.dithering=!0),this.alphaTest>0&&(i.alphaTest=this.alphaTest),this.alphaHash===!0&&(i.alphaHash=!0),this.alphaToCoverage===!0&&(i.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(i.premultipliedAlpha=!0),this.forceSinglePass===!0&&(i.forceSinglePass=!0),this.wireframe===!0&&(i.wireframe=!0),this.wireframeLinewidth>1&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(i.flatShading=!0),this.visible===!1&&(i.visible=!1),this.toneMapped===!1&&(i.toneMapped=!1),this.fog===!1&&(i.fog=!1),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let i=null;if(e!==null){const s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}onBuild(){console.warn("Material: onBuild() has been removed.")}}class Gr extends qs{static get type(){return"MeshBasicMaterial"}constructor(t){super(),this.isMeshBasicMaterial=!0,this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ni,this.combine=Tu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const qe=new z,Yo=new ae;class Nn{constructor(t,e,i=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=ef,this.updateRanges=[],this.gpuType=$i,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Yo.fromBufferAttribute(this,e),Yo.applyMatrix3(t),this.setXY(e,Yo.x,Yo.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)qe.fromBufferAttribute(this,e),qe.applyMatrix3(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)qe.fromBufferAttribute(this,e),qe.applyMatrix4(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)qe.fromBufferAttribute(this,e),qe.applyNormalMatrix(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)qe.fromBufferAttribute(this,e),qe.transformDirection(t),this.setXYZ(e,qe.x,qe.y,qe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=eo(i,this.array)),i}setComponent(t,e,i){return this.normalized&&(i=Ln(i,this.array)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=eo(e,this.array)),e}setX(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=eo(e,this.array)),e}setY(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=eo(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=eo(e,this.array)),e}setW(t,e){return this.normalized&&(e=Ln(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=Ln(e,this.array),i=Ln(i,this.array)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=Ln(e,this.array),i=Ln(i,this.array),s=Ln(s,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=Ln(e,this.array),i=Ln(i,this.array),s=Ln(s,this.array),r=Ln(r,this.array)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==ef&&(t.usage=this.usage),t}}class Dp extends Nn{constructor(t,e,i){super(new Uint16Array(t),e,i)}}class Up extends Nn{constructor(t,e,i){super(new Uint32Array(t),e,i)}}class Fe extends Nn{constructor(t,e,i){super(new Float32Array(t),e,i)}}let rv=0;const jn=new ze,Il=new en,gr=new z,Vn=new Vr,ro=new Vr,dn=new z;class on extends Hr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:rv++}),this.uuid=bo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Ap(t)?Up:Dp)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const i=this.attributes.normal;if(i!==void 0){const r=new Qt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return jn.makeRotationFromQuaternion(t),this.applyMatrix4(jn),this}rotateX(t){return jn.makeRotationX(t),this.applyMatrix4(jn),this}rotateY(t){return jn.makeRotationY(t),this.applyMatrix4(jn),this}rotateZ(t){return jn.makeRotationZ(t),this.applyMatrix4(jn),this}translate(t,e,i){return jn.makeTranslation(t,e,i),this.applyMatrix4(jn),this}scale(t,e,i){return jn.makeScale(t,e,i),this.applyMatrix4(jn),this}lookAt(t){return Il.lookAt(t),Il.updateMatrix(),this.applyMatrix4(Il.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(gr).negate(),this.translate(gr.x,gr.y,gr.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const i=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Fe(i,3))}else{for(let i=0,s=e.count;i<s;i++){const r=t[i];e.setXYZ(i,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Vr);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){const r=e[i];Vn.setFromBufferAttribute(r),this.morphTargetsRelative?(dn.addVectors(this.boundingBox.min,Vn.min),this.boundingBox.expandByPoint(dn),dn.addVectors(this.boundingBox.max,Vn.max),this.boundingBox.expandByPoint(dn)):(this.boundingBox.expandByPoint(Vn.min),this.boundingBox.expandByPoint(Vn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new To);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){const i=this.boundingSphere.center;if(Vn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];ro.setFromBufferAttribute(a),this.morphTargetsRelative?(dn.addVectors(Vn.min,ro.min),Vn.expandByPoint(dn),dn.addVectors(Vn.max,ro.max),Vn.expandByPoint(dn)):(Vn.expandByPoint(ro.min),Vn.expandByPoint(ro.max))}Vn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)dn.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(dn));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)dn.fromBufferAttribute(a,c),l&&(gr.fromBufferAttribute(t,c),dn.add(gr)),s=Math.max(s,i.distanceToSquared(dn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const i=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new Nn(new Float32Array(4*i.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let U=0;U<i.count;U++)a[U]=new z,l[U]=new z;const c=new z,u=new z,h=new z,f=new ae,d=new ae,g=new ae,v=new z,m=new z;function p(U,T,S){c.fromBufferAttribute(i,U),u.fromBufferAttribute(i,T),h.fromBufferAttribute(i,S),f.fromBufferAttribute(r,U),d.fromBufferAttribute(r,T),g.fromBufferAttribute(r,S),u.sub(c),h.sub(c),d.sub(f),g.sub(f);const C=1/(d.x*g.y-g.x*d.y);isFinite(C)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-d.y).multiplyScalar(C),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(C),a[U].add(v),a[T].add(v),a[S].add(v),l[U].add(m),l[T].add(m),l[S].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:t.count}]);for(let U=0,T=E.length;U<T;++U){const S=E[U],C=S.start,V=S.count;for(let I=C,G=C+V;I<G;I+=3)p(t.getX(I+0),t.getX(I+1),t.getX(I+2))}const w=new z,M=new z,O=new z,R=new z;function D(U){O.fromBufferAttribute(s,U),R.copy(O);const T=a[U];w.copy(T),w.sub(O.multiplyScalar(O.dot(T))).normalize(),M.crossVectors(R,T);const C=M.dot(l[U])<0?-1:1;o.setXYZW(U,w.x,w.y,w.z,C)}for(let U=0,T=E.length;U<T;++U){const S=E[U],C=S.start,V=S.count;for(let I=C,G=C+V;I<G;I+=3)D(t.getX(I+0)),D(t.getX(I+1)),D(t.getX(I+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0)i=new Nn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);const s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let f=0,d=t.count;f<d;f+=3){const g=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)dn.fromBufferAttribute(t,e),dn.normalize(),t.setXYZ(e,dn.x,dn.y,dn.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new Nn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new on,i=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,i);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],d=t(f,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.6,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const i=this.attributes;for(const l in i){const c=i[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere={center:a.center.toArray(),radius:a.radius}),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const i=t.index;i!==null&&this.setIndex(i.clone(e));const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const xf=new ze,Ts=new Du,Ko=new To,Mf=new z,jo=new z,Zo=new z,Jo=new z,Nl=new z,Qo=new z,Sf=new z,ta=new z;class Mn extends en{constructor(t=new on,e=new Gr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){Qo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(Nl.fromBufferAttribute(h,t),o?Qo.addScaledVector(Nl,u):Qo.addScaledVector(Nl.sub(e),u))}e.add(Qo)}return e}raycast(t,e){const i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Ko.copy(i.boundingSphere),Ko.applyMatrix4(r),Ts.copy(t.ray).recast(t.near),!(Ko.containsPoint(Ts.origin)===!1&&(Ts.intersectSphere(Ko,Mf)===null||Ts.origin.distanceToSquared(Mf)>(t.far-t.near)**2))&&(xf.copy(r).invert(),Ts.copy(t.ray).applyMatrix4(xf),!(i.boundingBox!==null&&Ts.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Ts)))}_computeIntersections(t,e,i){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],E=Math.max(m.start,d.start),w=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let M=E,O=w;M<O;M+=3){const R=a.getX(M),D=a.getX(M+1),U=a.getX(M+2);s=ea(this,p,t,i,c,u,h,R,D,U),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const E=a.getX(m),w=a.getX(m+1),M=a.getX(m+2);s=ea(this,o,t,i,c,u,h,E,w,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],E=Math.max(m.start,d.start),w=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=E,O=w;M<O;M+=3){const R=M,D=M+1,U=M+2;s=ea(this,p,t,i,c,u,h,R,D,U),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const E=m,w=m+1,M=m+2;s=ea(this,o,t,i,c,u,h,E,w,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function ov(n,t,e,i,s,r,o,a){let l;if(t.side===Un?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===ms,a),l===null)return null;ta.copy(a),ta.applyMatrix4(n.matrixWorld);const c=e.ray.origin.distanceTo(ta);return c<e.near||c>e.far?null:{distance:c,point:ta.clone(),object:n}}function ea(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,jo),n.getVertexPosition(l,Zo),n.getVertexPosition(c,Jo);const u=ov(n,t,e,i,jo,Zo,Jo,Sf);if(u){const h=new z;ei.getBarycoord(Sf,jo,Zo,Jo,h),s&&(u.uv=ei.getInterpolatedAttribute(s,a,l,c,h,new ae)),r&&(u.uv1=ei.getInterpolatedAttribute(r,a,l,c,h,new ae)),o&&(u.normal=ei.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new z,materialIndex:0};ei.getNormal(jo,Zo,Jo,f.normal),u.face=f,u.barycoord=h}return u}class Wr extends on{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,d=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Fe(c,3)),this.setAttribute("normal",new Fe(u,3)),this.setAttribute("uv",new Fe(h,2));function g(v,m,p,E,w,M,O,R,D,U,T){const S=M/D,C=O/U,V=M/2,I=O/2,G=R/2,j=D+1,K=U+1;let J=0,Q=0;const ht=new z;for(let ct=0;ct<K;ct++){const mt=ct*C-I;for(let Mt=0;Mt<j;Mt++){const pt=Mt*S-V;ht[v]=pt*E,ht[m]=mt*w,ht[p]=G,c.push(ht.x,ht.y,ht.z),ht[v]=0,ht[m]=0,ht[p]=R>0?1:-1,u.push(ht.x,ht.y,ht.z),h.push(Mt/D),h.push(1-ct/U),J+=1}}for(let ct=0;ct<U;ct++)for(let mt=0;mt<D;mt++){const Mt=f+mt+j*ct,pt=f+mt+j*(ct+1),nt=f+(mt+1)+j*(ct+1),at=f+(mt+1)+j*ct;l.push(Mt,pt,at),l.push(pt,nt,at),Q+=6}a.addGroup(d,Q,T),d+=Q,f+=J}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Wr(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function Or(n){const t={};for(const e in n){t[e]={};for(const i in n[e]){const s=n[e][i];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone():Array.isArray(s)?t[e][i]=s.slice():t[e][i]=s}}return t}function wn(n){const t={};for(let e=0;e<n.length;e++){const i=Or(n[e]);for(const s in i)t[s]=i[s]}return t}function av(n){const t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Ip(n){const t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:pe.workingColorSpace}const lv={clone:Or,merge:wn};var cv=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,uv=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class gs extends qs{static get type(){return"ShaderMaterial"}constructor(t){super(),this.isShaderMaterial=!0,this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=cv,this.fragmentShader=uv,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Or(t.uniforms),this.uniformsGroups=av(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const i={};for(const s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}}class Np extends en{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ze,this.projectionMatrix=new ze,this.projectionMatrixInverse=new ze,this.coordinateSystem=qi}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const cs=new z,yf=new ae,Ef=new ae;class Wn extends Np{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=qc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(ya*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return qc*2*Math.atan(Math.tan(ya*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){cs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(cs.x,cs.y).multiplyScalar(-t/cs.z),cs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(cs.x,cs.y).multiplyScalar(-t/cs.z)}getViewSize(t,e){return this.getViewBounds(t,yf,Ef),e.subVectors(Ef,yf)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(ya*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const _r=-90,vr=1;class hv extends en{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Wn(_r,vr,t,e);s.layers=this.layers,this.add(s);const r=new Wn(_r,vr,t,e);r.layers=this.layers,this.add(r);const o=new Wn(_r,vr,t,e);o.layers=this.layers,this.add(o);const a=new Wn(_r,vr,t,e);a.layers=this.layers,this.add(a);const l=new Wn(_r,vr,t,e);l.layers=this.layers,this.add(l);const c=new Wn(_r,vr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===qi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ra)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;const v=i.texture.generateMipmaps;i.texture.generateMipmaps=!1,t.setRenderTarget(i,0,s),t.render(e,r),t.setRenderTarget(i,1,s),t.render(e,o),t.setRenderTarget(i,2,s),t.render(e,a),t.setRenderTarget(i,3,s),t.render(e,l),t.setRenderTarget(i,4,s),t.render(e,c),i.texture.generateMipmaps=v,t.setRenderTarget(i,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}}class Fp extends In{constructor(t,e,i,s,r,o,a,l,c,u){t=t!==void 0?t:[],e=e!==void 0?e:Ur,super(t,e,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class fv extends Hs{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Fp(s,e.mapping,e.wrapS,e.wrapT,e.magFilter,e.minFilter,e.format,e.type,e.anisotropy,e.colorSpace),this.texture.isRenderTargetTexture=!0,this.texture.generateMipmaps=e.generateMipmaps!==void 0?e.generateMipmaps:!1,this.texture.minFilter=e.minFilter!==void 0?e.minFilter:Pi}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Wr(5,5,5),r=new gs({name:"CubemapFromEquirect",uniforms:Or(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Un,blending:fs});r.uniforms.tEquirect.value=e;const o=new Mn(s,r),a=e.minFilter;return e.minFilter===Os&&(e.minFilter=Pi),new hv(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e,i,s){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}}const Fl=new z,dv=new z,pv=new Qt;class Ls{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){const s=Fl.subVectors(i,e).cross(dv.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const i=t.delta(Fl),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const i=e||pv.getNormalMatrix(t),s=this.coplanarPoint(Fl).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const ws=new To,na=new z;class Uu{constructor(t=new Ls,e=new Ls,i=new Ls,s=new Ls,r=new Ls,o=new Ls){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=qi){const i=this.planes,s=t.elements,r=s[0],o=s[1],a=s[2],l=s[3],c=s[4],u=s[5],h=s[6],f=s[7],d=s[8],g=s[9],v=s[10],m=s[11],p=s[12],E=s[13],w=s[14],M=s[15];if(i[0].setComponents(l-r,f-c,m-d,M-p).normalize(),i[1].setComponents(l+r,f+c,m+d,M+p).normalize(),i[2].setComponents(l+o,f+u,m+g,M+E).normalize(),i[3].setComponents(l-o,f-u,m-g,M-E).normalize(),i[4].setComponents(l-a,f-h,m-v,M-w).normalize(),e===qi)i[5].setComponents(l+a,f+h,m+v,M+w).normalize();else if(e===Ra)i[5].setComponents(a,h,v,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ws.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ws.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ws)}intersectsSprite(t){return ws.center.set(0,0,0),ws.radius=.7071067811865476,ws.applyMatrix4(t.matrixWorld),this.intersectsSphere(ws)}intersectsSphere(t){const e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let i=0;i<6;i++){const s=e[i];if(na.x=s.normal.x>0?t.max.x:t.min.x,na.y=s.normal.y>0?t.max.y:t.min.y,na.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(na)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}function Op(){let n=null,t=!1,e=null,i=null;function s(r,o){e(r,o),i=n.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function mv(n){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){const u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){const g=h[f],v=h[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){const v=h[d];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}class $a extends on{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){const E=p*f-o;for(let w=0;w<c;w++){const M=w*h-r;g.push(M,-E,0),v.push(0,0,1),m.push(w/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let E=0;E<a;E++){const w=E+c*p,M=E+c*(p+1),O=E+1+c*(p+1),R=E+1+c*p;d.push(w,M,R),d.push(M,O,R)}this.setIndex(d),this.setAttribute("position",new Fe(g,3)),this.setAttribute("normal",new Fe(v,3)),this.setAttribute("uv",new Fe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new $a(t.width,t.height,t.widthSegments,t.heightSegments)}}var gv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,_v=`#ifdef USE_ALPHAHASH
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
#endif`,vv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,xv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Mv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Sv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,yv=`#ifdef USE_AOMAP
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
#endif`,Ev=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,bv=`#ifdef USE_BATCHING
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
#endif`,Tv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,wv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Av=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Rv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Cv=`#ifdef USE_IRIDESCENCE
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
#endif`,Pv=`#ifdef USE_BUMPMAP
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
#endif`,Lv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Dv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Uv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Iv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Nv=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Fv=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Ov=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,kv=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Bv=`#define PI 3.141592653589793
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
} // validated`,zv=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Hv=`vec3 transformedNormal = objectNormal;
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
#endif`,Vv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Gv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Wv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Xv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,$v="gl_FragColor = linearToOutputTexel( gl_FragColor );",qv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Yv=`#ifdef USE_ENVMAP
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
#endif`,Kv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,jv=`#ifdef USE_ENVMAP
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
#endif`,Zv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Jv=`#ifdef USE_ENVMAP
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
#endif`,Qv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,tx=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ex=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,nx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ix=`#ifdef USE_GRADIENTMAP
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
}`,sx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,rx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ox=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ax=`uniform bool receiveShadow;
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
#endif`,lx=`#ifdef USE_ENVMAP
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
#endif`,cx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,ux=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,hx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,fx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,dx=`PhysicalMaterial material;
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
#endif`,px=`struct PhysicalMaterial {
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
}`,mx=`
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
#endif`,gx=`#if defined( RE_IndirectDiffuse )
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
#endif`,_x=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,vx=`#if defined( USE_LOGDEPTHBUF )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,xx=`#if defined( USE_LOGDEPTHBUF )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Mx=`#ifdef USE_LOGDEPTHBUF
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Sx=`#ifdef USE_LOGDEPTHBUF
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,yx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Ex=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,bx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Tx=`#if defined( USE_POINTS_UV )
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
#endif`,wx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Ax=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Rx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Cx=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Px=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Lx=`#ifdef USE_MORPHTARGETS
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
#endif`,Dx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ux=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Ix=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Nx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Fx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ox=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,kx=`#ifdef USE_NORMALMAP
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
#endif`,Bx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,zx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Hx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Vx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Gx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Wx=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Xx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$x=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,qx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Yx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Kx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,jx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Zx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Jx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Qx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,tM=`float getShadowMask() {
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
}`,eM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,nM=`#ifdef USE_SKINNING
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
#endif`,iM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,sM=`#ifdef USE_SKINNING
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
#endif`,rM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,oM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,aM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,lM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,cM=`#ifdef USE_TRANSMISSION
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
#endif`,uM=`#ifdef USE_TRANSMISSION
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
#endif`,hM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,fM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,dM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const mM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,gM=`uniform sampler2D t2D;
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
}`,_M=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vM=`#ifdef ENVMAP_TYPE_CUBE
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
}`,xM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,MM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SM=`#include <common>
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
}`,yM=`#if DEPTH_PACKING == 3200
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
}`,EM=`#define DISTANCE
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
}`,bM=`#define DISTANCE
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
}`,TM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,wM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,AM=`uniform float scale;
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
}`,RM=`uniform vec3 diffuse;
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
}`,CM=`#include <common>
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
}`,PM=`uniform vec3 diffuse;
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
}`,LM=`#define LAMBERT
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
}`,DM=`#define LAMBERT
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
}`,UM=`#define MATCAP
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
}`,IM=`#define MATCAP
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
}`,NM=`#define NORMAL
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
}`,FM=`#define NORMAL
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
}`,OM=`#define PHONG
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
}`,kM=`#define PHONG
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
}`,BM=`#define STANDARD
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
}`,zM=`#define STANDARD
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
}`,HM=`#define TOON
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
}`,VM=`#define TOON
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
}`,GM=`uniform float size;
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
}`,WM=`uniform vec3 diffuse;
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
}`,XM=`#include <common>
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
}`,$M=`uniform vec3 color;
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
}`,qM=`uniform float rotation;
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
}`,YM=`uniform vec3 diffuse;
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
}`,ee={alphahash_fragment:gv,alphahash_pars_fragment:_v,alphamap_fragment:vv,alphamap_pars_fragment:xv,alphatest_fragment:Mv,alphatest_pars_fragment:Sv,aomap_fragment:yv,aomap_pars_fragment:Ev,batching_pars_vertex:bv,batching_vertex:Tv,begin_vertex:wv,beginnormal_vertex:Av,bsdfs:Rv,iridescence_fragment:Cv,bumpmap_pars_fragment:Pv,clipping_planes_fragment:Lv,clipping_planes_pars_fragment:Dv,clipping_planes_pars_vertex:Uv,clipping_planes_vertex:Iv,color_fragment:Nv,color_pars_fragment:Fv,color_pars_vertex:Ov,color_vertex:kv,common:Bv,cube_uv_reflection_fragment:zv,defaultnormal_vertex:Hv,displacementmap_pars_vertex:Vv,displacementmap_vertex:Gv,emissivemap_fragment:Wv,emissivemap_pars_fragment:Xv,colorspace_fragment:$v,colorspace_pars_fragment:qv,envmap_fragment:Yv,envmap_common_pars_fragment:Kv,envmap_pars_fragment:jv,envmap_pars_vertex:Zv,envmap_physical_pars_fragment:lx,envmap_vertex:Jv,fog_vertex:Qv,fog_pars_vertex:tx,fog_fragment:ex,fog_pars_fragment:nx,gradientmap_pars_fragment:ix,lightmap_pars_fragment:sx,lights_lambert_fragment:rx,lights_lambert_pars_fragment:ox,lights_pars_begin:ax,lights_toon_fragment:cx,lights_toon_pars_fragment:ux,lights_phong_fragment:hx,lights_phong_pars_fragment:fx,lights_physical_fragment:dx,lights_physical_pars_fragment:px,lights_fragment_begin:mx,lights_fragment_maps:gx,lights_fragment_end:_x,logdepthbuf_fragment:vx,logdepthbuf_pars_fragment:xx,logdepthbuf_pars_vertex:Mx,logdepthbuf_vertex:Sx,map_fragment:yx,map_pars_fragment:Ex,map_particle_fragment:bx,map_particle_pars_fragment:Tx,metalnessmap_fragment:wx,metalnessmap_pars_fragment:Ax,morphinstance_vertex:Rx,morphcolor_vertex:Cx,morphnormal_vertex:Px,morphtarget_pars_vertex:Lx,morphtarget_vertex:Dx,normal_fragment_begin:Ux,normal_fragment_maps:Ix,normal_pars_fragment:Nx,normal_pars_vertex:Fx,normal_vertex:Ox,normalmap_pars_fragment:kx,clearcoat_normal_fragment_begin:Bx,clearcoat_normal_fragment_maps:zx,clearcoat_pars_fragment:Hx,iridescence_pars_fragment:Vx,opaque_fragment:Gx,packing:Wx,premultiplied_alpha_fragment:Xx,project_vertex:$x,dithering_fragment:qx,dithering_pars_fragment:Yx,roughnessmap_fragment:Kx,roughnessmap_pars_fragment:jx,shadowmap_pars_fragment:Zx,shadowmap_pars_vertex:Jx,shadowmap_vertex:Qx,shadowmask_pars_fragment:tM,skinbase_vertex:eM,skinning_pars_vertex:nM,skinning_vertex:iM,skinnormal_vertex:sM,specularmap_fragment:rM,specularmap_pars_fragment:oM,tonemapping_fragment:aM,tonemapping_pars_fragment:lM,transmission_fragment:cM,transmission_pars_fragment:uM,uv_pars_fragment:hM,uv_pars_vertex:fM,uv_vertex:dM,worldpos_vertex:pM,background_vert:mM,background_frag:gM,backgroundCube_vert:_M,backgroundCube_frag:vM,cube_vert:xM,cube_frag:MM,depth_vert:SM,depth_frag:yM,distanceRGBA_vert:EM,distanceRGBA_frag:bM,equirect_vert:TM,equirect_frag:wM,linedashed_vert:AM,linedashed_frag:RM,meshbasic_vert:CM,meshbasic_frag:PM,meshlambert_vert:LM,meshlambert_frag:DM,meshmatcap_vert:UM,meshmatcap_frag:IM,meshnormal_vert:NM,meshnormal_frag:FM,meshphong_vert:OM,meshphong_frag:kM,meshphysical_vert:BM,meshphysical_frag:zM,meshtoon_vert:HM,meshtoon_frag:VM,points_vert:GM,points_frag:WM,shadow_vert:XM,shadow_frag:$M,sprite_vert:qM,sprite_frag:YM},bt={common:{diffuse:{value:new oe(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qt}},envmap:{envMap:{value:null},envMapRotation:{value:new Qt},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qt},normalScale:{value:new ae(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new oe(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new oe(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0},uvTransform:{value:new Qt}},sprite:{diffuse:{value:new oe(16777215)},opacity:{value:1},center:{value:new ae(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qt},alphaMap:{value:null},alphaMapTransform:{value:new Qt},alphaTest:{value:0}}},wi={basic:{uniforms:wn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.fog]),vertexShader:ee.meshbasic_vert,fragmentShader:ee.meshbasic_frag},lambert:{uniforms:wn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new oe(0)}}]),vertexShader:ee.meshlambert_vert,fragmentShader:ee.meshlambert_frag},phong:{uniforms:wn([bt.common,bt.specularmap,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,bt.lights,{emissive:{value:new oe(0)},specular:{value:new oe(1118481)},shininess:{value:30}}]),vertexShader:ee.meshphong_vert,fragmentShader:ee.meshphong_frag},standard:{uniforms:wn([bt.common,bt.envmap,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.roughnessmap,bt.metalnessmap,bt.fog,bt.lights,{emissive:{value:new oe(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ee.meshphysical_vert,fragmentShader:ee.meshphysical_frag},toon:{uniforms:wn([bt.common,bt.aomap,bt.lightmap,bt.emissivemap,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.gradientmap,bt.fog,bt.lights,{emissive:{value:new oe(0)}}]),vertexShader:ee.meshtoon_vert,fragmentShader:ee.meshtoon_frag},matcap:{uniforms:wn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,bt.fog,{matcap:{value:null}}]),vertexShader:ee.meshmatcap_vert,fragmentShader:ee.meshmatcap_frag},points:{uniforms:wn([bt.points,bt.fog]),vertexShader:ee.points_vert,fragmentShader:ee.points_frag},dashed:{uniforms:wn([bt.common,bt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ee.linedashed_vert,fragmentShader:ee.linedashed_frag},depth:{uniforms:wn([bt.common,bt.displacementmap]),vertexShader:ee.depth_vert,fragmentShader:ee.depth_frag},normal:{uniforms:wn([bt.common,bt.bumpmap,bt.normalmap,bt.displacementmap,{opacity:{value:1}}]),vertexShader:ee.meshnormal_vert,fragmentShader:ee.meshnormal_frag},sprite:{uniforms:wn([bt.sprite,bt.fog]),vertexShader:ee.sprite_vert,fragmentShader:ee.sprite_frag},background:{uniforms:{uvTransform:{value:new Qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ee.background_vert,fragmentShader:ee.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qt}},vertexShader:ee.backgroundCube_vert,fragmentShader:ee.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ee.cube_vert,fragmentShader:ee.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ee.equirect_vert,fragmentShader:ee.equirect_frag},distanceRGBA:{uniforms:wn([bt.common,bt.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ee.distanceRGBA_vert,fragmentShader:ee.distanceRGBA_frag},shadow:{uniforms:wn([bt.lights,bt.fog,{color:{value:new oe(0)},opacity:{value:1}}]),vertexShader:ee.shadow_vert,fragmentShader:ee.shadow_frag}};wi.physical={uniforms:wn([wi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qt},clearcoatNormalScale:{value:new ae(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qt},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qt},sheen:{value:0},sheenColor:{value:new oe(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qt},transmissionSamplerSize:{value:new ae},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qt},attenuationDistance:{value:0},attenuationColor:{value:new oe(0)},specularColor:{value:new oe(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qt},anisotropyVector:{value:new ae},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qt}}]),vertexShader:ee.meshphysical_vert,fragmentShader:ee.meshphysical_frag};const ia={r:0,b:0,g:0},As=new Ni,KM=new ze;function jM(n,t,e,i,s,r,o){const a=new oe(0);let l=r===!0?0:1,c,u,h=null,f=0,d=null;function g(E){let w=E.isScene===!0?E.background:null;return w&&w.isTexture&&(w=(E.backgroundBlurriness>0?e:t).get(w)),w}function v(E){let w=!1;const M=g(E);M===null?p(a,l):M&&M.isColor&&(p(M,1),w=!0);const O=n.xr.getEnvironmentBlendMode();O==="additive"?i.buffers.color.setClear(0,0,0,1,o):O==="alpha-blend"&&i.buffers.color.setClear(0,0,0,0,o),(n.autoClear||w)&&(i.buffers.depth.setTest(!0),i.buffers.depth.setMask(!0),i.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(E,w){const M=g(w);M&&(M.isCubeTexture||M.mapping===Wa)?(u===void 0&&(u=new Mn(new Wr(1,1,1),new gs({name:"BackgroundCubeMaterial",uniforms:Or(wi.backgroundCube.uniforms),vertexShader:wi.backgroundCube.vertexShader,fragmentShader:wi.backgroundCube.fragmentShader,side:Un,depthTest:!1,depthWrite:!1,fog:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(O,R,D){this.matrixWorld.copyPosition(D.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),As.copy(w.backgroundRotation),As.x*=-1,As.y*=-1,As.z*=-1,M.isCubeTexture&&M.isRenderTargetTexture===!1&&(As.y*=-1,As.z*=-1),u.material.uniforms.envMap.value=M,u.material.uniforms.flipEnvMap.value=M.isCubeTexture&&M.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(KM.makeRotationFromEuler(As)),u.material.toneMapped=pe.getTransfer(M.colorSpace)!==Ae,(h!==M||f!==M.version||d!==n.toneMapping)&&(u.material.needsUpdate=!0,h=M,f=M.version,d=n.toneMapping),u.layers.enableAll(),E.unshift(u,u.geometry,u.material,0,0,null)):M&&M.isTexture&&(c===void 0&&(c=new Mn(new $a(2,2),new gs({name:"BackgroundMaterial",uniforms:Or(wi.background.uniforms),vertexShader:wi.background.vertexShader,fragmentShader:wi.background.fragmentShader,side:ms,depthTest:!1,depthWrite:!1,fog:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=M,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.toneMapped=pe.getTransfer(M.colorSpace)!==Ae,M.matrixAutoUpdate===!0&&M.updateMatrix(),c.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||f!==M.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,f=M.version,d=n.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function p(E,w){E.getRGB(ia,Ip(n)),i.buffers.color.setClear(ia.r,ia.g,ia.b,w,o)}return{getClearColor:function(){return a},setClearColor:function(E,w=1){a.set(E),l=w,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(E){l=E,p(a,l)},render:v,addToRenderList:m}}function ZM(n,t){const e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null);let r=s,o=!1;function a(S,C,V,I,G){let j=!1;const K=h(I,V,C);r!==K&&(r=K,c(r.object)),j=d(S,I,V,G),j&&g(S,I,V,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),(j||o)&&(o=!1,M(S,C,V,I),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(S){return n.bindVertexArray(S)}function u(S){return n.deleteVertexArray(S)}function h(S,C,V){const I=V.wireframe===!0;let G=i[S.id];G===void 0&&(G={},i[S.id]=G);let j=G[C.id];j===void 0&&(j={},G[C.id]=j);let K=j[I];return K===void 0&&(K=f(l()),j[I]=K),K}function f(S){const C=[],V=[],I=[];for(let G=0;G<e;G++)C[G]=0,V[G]=0,I[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:V,attributeDivisors:I,object:S,attributes:{},index:null}}function d(S,C,V,I){const G=r.attributes,j=C.attributes;let K=0;const J=V.getAttributes();for(const Q in J)if(J[Q].location>=0){const ct=G[Q];let mt=j[Q];if(mt===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(mt=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(mt=S.instanceColor)),ct===void 0||ct.attribute!==mt||mt&&ct.data!==mt.data)return!0;K++}return r.attributesNum!==K||r.index!==I}function g(S,C,V,I){const G={},j=C.attributes;let K=0;const J=V.getAttributes();for(const Q in J)if(J[Q].location>=0){let ct=j[Q];ct===void 0&&(Q==="instanceMatrix"&&S.instanceMatrix&&(ct=S.instanceMatrix),Q==="instanceColor"&&S.instanceColor&&(ct=S.instanceColor));const mt={};mt.attribute=ct,ct&&ct.data&&(mt.data=ct.data),G[Q]=mt,K++}r.attributes=G,r.attributesNum=K,r.index=I}function v(){const S=r.newAttributes;for(let C=0,V=S.length;C<V;C++)S[C]=0}function m(S){p(S,0)}function p(S,C){const V=r.newAttributes,I=r.enabledAttributes,G=r.attributeDivisors;V[S]=1,I[S]===0&&(n.enableVertexAttribArray(S),I[S]=1),G[S]!==C&&(n.vertexAttribDivisor(S,C),G[S]=C)}function E(){const S=r.newAttributes,C=r.enabledAttributes;for(let V=0,I=C.length;V<I;V++)C[V]!==S[V]&&(n.disableVertexAttribArray(V),C[V]=0)}function w(S,C,V,I,G,j,K){K===!0?n.vertexAttribIPointer(S,C,V,G,j):n.vertexAttribPointer(S,C,V,I,G,j)}function M(S,C,V,I){v();const G=I.attributes,j=V.getAttributes(),K=C.defaultAttributeValues;for(const J in j){const Q=j[J];if(Q.location>=0){let ht=G[J];if(ht===void 0&&(J==="instanceMatrix"&&S.instanceMatrix&&(ht=S.instanceMatrix),J==="instanceColor"&&S.instanceColor&&(ht=S.instanceColor)),ht!==void 0){const ct=ht.normalized,mt=ht.itemSize,Mt=t.get(ht);if(Mt===void 0)continue;const pt=Mt.buffer,nt=Mt.type,at=Mt.bytesPerElement,gt=nt===n.INT||nt===n.UNSIGNED_INT||ht.gpuType===wu;if(ht.isInterleavedBufferAttribute){const rt=ht.data,Bt=rt.stride,Ht=ht.offset;if(rt.isInstancedInterleavedBuffer){for(let It=0;It<Q.locationSize;It++)p(Q.location+It,rt.meshPerAttribute);S.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=rt.meshPerAttribute*rt.count)}else for(let It=0;It<Q.locationSize;It++)m(Q.location+It);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let It=0;It<Q.locationSize;It++)w(Q.location+It,mt/Q.locationSize,nt,ct,Bt*at,(Ht+mt/Q.locationSize*It)*at,gt)}else{if(ht.isInstancedBufferAttribute){for(let rt=0;rt<Q.locationSize;rt++)p(Q.location+rt,ht.meshPerAttribute);S.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ht.meshPerAttribute*ht.count)}else for(let rt=0;rt<Q.locationSize;rt++)m(Q.location+rt);n.bindBuffer(n.ARRAY_BUFFER,pt);for(let rt=0;rt<Q.locationSize;rt++)w(Q.location+rt,mt/Q.locationSize,nt,ct,mt*at,mt/Q.locationSize*rt*at,gt)}}else if(K!==void 0){const ct=K[J];if(ct!==void 0)switch(ct.length){case 2:n.vertexAttrib2fv(Q.location,ct);break;case 3:n.vertexAttrib3fv(Q.location,ct);break;case 4:n.vertexAttrib4fv(Q.location,ct);break;default:n.vertexAttrib1fv(Q.location,ct)}}}}E()}function O(){U();for(const S in i){const C=i[S];for(const V in C){const I=C[V];for(const G in I)u(I[G].object),delete I[G];delete C[V]}delete i[S]}}function R(S){if(i[S.id]===void 0)return;const C=i[S.id];for(const V in C){const I=C[V];for(const G in I)u(I[G].object),delete I[G];delete C[V]}delete i[S.id]}function D(S){for(const C in i){const V=i[C];if(V[S.id]===void 0)continue;const I=V[S.id];for(const G in I)u(I[G].object),delete I[G];delete V[S.id]}}function U(){T(),o=!0,r!==s&&(r=s,c(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:T,dispose:O,releaseStatesOfGeometry:R,releaseStatesOfProgram:D,initAttributes:v,enableAttribute:m,disableUnusedAttributes:E}}function JM(n,t,e){let i;function s(c){i=c}function r(c,u){n.drawArrays(i,c,u),e.update(u,i,1)}function o(c,u,h){h!==0&&(n.drawArraysInstanced(i,c,u,h),e.update(u,i,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,u,0,h);let d=0;for(let g=0;g<h;g++)d+=u[g];e.update(d,i,1)}function l(c,u,h,f){if(h===0)return;const d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(i,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];e.update(g,i,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function QM(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const D=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(D.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(D){return!(D!==pi&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(D){const U=D===Eo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(D!==Ji&&i.convert(D)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE)&&D!==$i&&!U)}function l(D){if(D==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";D="mediump"}return D==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,f=e.reverseDepthBuffer===!0&&t.has("EXT_clip_control"),d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),E=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),O=g>0,R=n.getParameter(n.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reverseDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:E,maxVaryings:w,maxFragmentUniforms:M,vertexTextures:O,maxSamples:R}}function tS(n){const t=this;let e=null,i=0,s=!1,r=!1;const o=new Ls,a=new Qt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){const g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=n.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{const E=r?0:i,w=E*4;let M=p.clippingState||null;l.value=M,M=u(g,f,w,d);for(let O=0;O!==w;++O)M[O]=e[O];p.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=E}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function u(h,f,d,g){const v=h!==null?h.length:0;let m=null;if(v!==0){if(m=l.value,g!==!0||m===null){const p=d+v*4,E=f.matrixWorldInverse;a.getNormalMatrix(E),(m===null||m.length<p)&&(m=new Float32Array(p));for(let w=0,M=d;w!==v;++w,M+=4)o.copy(h[w]).applyMatrix4(E,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function eS(n){let t=new WeakMap;function e(o,a){return a===_c?o.mapping=Ur:a===vc&&(o.mapping=Ir),o}function i(o){if(o&&o.isTexture){const a=o.mapping;if(a===_c||a===vc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new fv(l.height);return c.fromEquirectangularTexture(n,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:i,dispose:r}}class Iu extends Np{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Sr=4,bf=[.125,.215,.35,.446,.526,.582],Ns=20,Ol=new Iu,Tf=new oe;let kl=null,Bl=0,zl=0,Hl=!1;const Ds=(1+Math.sqrt(5))/2,xr=1/Ds,wf=[new z(-Ds,xr,0),new z(Ds,xr,0),new z(-xr,0,Ds),new z(xr,0,Ds),new z(0,Ds,-xr),new z(0,Ds,xr),new z(-1,1,-1),new z(1,1,-1),new z(-1,1,1),new z(1,1,1)];class Af{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,i=.1,s=100){kl=this._renderer.getRenderTarget(),Bl=this._renderer.getActiveCubeFace(),zl=this._renderer.getActiveMipmapLevel(),Hl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(256);const r=this._allocateTargets();return r.depthBuffer=!0,this._sceneToCubeUV(t,i,s,r),e>0&&this._blur(r,0,0,e),this._applyPMREM(r),this._cleanup(r),r}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Pf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(kl,Bl,zl),this._renderer.xr.enabled=Hl,t.scissorTest=!1,sa(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Ur||t.mapping===Ir?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),kl=this._renderer.getRenderTarget(),Bl=this._renderer.getActiveCubeFace(),zl=this._renderer.getActiveMipmapLevel(),Hl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const i=e||this._allocateTargets();return this._textureToCubeUV(t,i),this._applyPMREM(i),this._cleanup(i),i}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,i={magFilter:Pi,minFilter:Pi,generateMipmaps:!1,type:Eo,format:pi,colorSpace:Xs,depthBuffer:!1},s=Rf(t,e,i);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=Rf(t,e,i);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=nS(r)),this._blurMaterial=iS(r,t,e)}return s}_compileMaterial(t){const e=new Mn(this._lodPlanes[0],t);this._renderer.compile(e,Ol)}_sceneToCubeUV(t,e,i,s){const a=new Wn(90,1,e,i),l=[1,-1,1,1,1,1],c=[1,1,1,-1,-1,-1],u=this._renderer,h=u.autoClear,f=u.toneMapping;u.getClearColor(Tf),u.toneMapping=ds,u.autoClear=!1;const d=new Gr({name:"PMREM.Background",side:Un,depthWrite:!1,depthTest:!1}),g=new Mn(new Wr,d);let v=!1;const m=t.background;m?m.isColor&&(d.color.copy(m),t.background=null,v=!0):(d.color.copy(Tf),v=!0);for(let p=0;p<6;p++){const E=p%3;E===0?(a.up.set(0,l[p],0),a.lookAt(c[p],0,0)):E===1?(a.up.set(0,0,l[p]),a.lookAt(0,c[p],0)):(a.up.set(0,l[p],0),a.lookAt(0,0,c[p]));const w=this._cubeSize;sa(s,E*w,p>2?w:0,w,w),u.setRenderTarget(s),v&&u.render(g,a),u.render(t,a)}g.geometry.dispose(),g.material.dispose(),u.toneMapping=f,u.autoClear=h,t.background=m}_textureToCubeUV(t,e){const i=this._renderer,s=t.mapping===Ur||t.mapping===Ir;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=Pf()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=Cf());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new Mn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;sa(e,0,0,3*l,2*l),i.setRenderTarget(e),i.render(o,Ol)}_applyPMREM(t){const e=this._renderer,i=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=wf[(s-r-1)%wf.length];this._blur(t,r-1,r,o,a)}e.autoClear=i}_blur(t,e,i,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,i,s,"latitudinal",r),this._halfBlur(o,t,i,i,s,"longitudinal",r)}_halfBlur(t,e,i,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new Mn(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[i]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Ns-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):Ns;m>Ns&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Ns}`);const p=[];let E=0;for(let D=0;D<Ns;++D){const U=D/v,T=Math.exp(-U*U/2);p.push(T),D===0?E+=T:D<m&&(E+=2*T)}for(let D=0;D<p.length;D++)p[D]=p[D]/E;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:w}=this;f.dTheta.value=g,f.mipInt.value=w-i;const M=this._sizeLods[s],O=3*M*(s>w-Sr?s-w+Sr:0),R=4*(this._cubeSize-M);sa(e,O,R,3*M,2*M),l.setRenderTarget(e),l.render(h,Ol)}}function nS(n){const t=[],e=[],i=[];let s=n;const r=n-Sr+1+bf.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>n-Sr?l=bf[o-n+Sr-1]:o===0&&(l=0),i.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,g=6,v=3,m=2,p=1,E=new Float32Array(v*g*d),w=new Float32Array(m*g*d),M=new Float32Array(p*g*d);for(let R=0;R<d;R++){const D=R%3*2/3-1,U=R>2?0:-1,T=[D,U,0,D+2/3,U,0,D+2/3,U+1,0,D,U,0,D+2/3,U+1,0,D,U+1,0];E.set(T,v*g*R),w.set(f,m*g*R);const S=[R,R,R,R,R,R];M.set(S,p*g*R)}const O=new on;O.setAttribute("position",new Nn(E,v)),O.setAttribute("uv",new Nn(w,m)),O.setAttribute("faceIndex",new Nn(M,p)),t.push(O),s>Sr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:i}}function Rf(n,t,e){const i=new Hs(n,t,e);return i.texture.mapping=Wa,i.texture.name="PMREM.cubeUv",i.scissorTest=!0,i}function sa(n,t,e,i,s){n.viewport.set(t,e,i,s),n.scissor.set(t,e,i,s)}function iS(n,t,e){const i=new Float32Array(Ns),s=new z(0,1,0);return new gs({name:"SphericalGaussianBlur",defines:{n:Ns,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${n}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:i},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:Nu(),fragmentShader:`

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
		`,blending:fs,depthTest:!1,depthWrite:!1})}function Cf(){return new gs({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:Nu(),fragmentShader:`

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
		`,blending:fs,depthTest:!1,depthWrite:!1})}function Pf(){return new gs({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:Nu(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:fs,depthTest:!1,depthWrite:!1})}function Nu(){return`

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
	`}function sS(n){let t=new WeakMap,e=null;function i(a){if(a&&a.isTexture){const l=a.mapping,c=l===_c||l===vc,u=l===Ur||l===Ir;if(c||u){let h=t.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new Af(n)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new Af(n)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:i,dispose:o}}function rS(n){const t={};function e(i){if(t[i]!==void 0)return t[i];let s;switch(i){case"WEBGL_depth_texture":s=n.getExtension("WEBGL_depth_texture")||n.getExtension("MOZ_WEBGL_depth_texture")||n.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=n.getExtension("EXT_texture_filter_anisotropic")||n.getExtension("MOZ_EXT_texture_filter_anisotropic")||n.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=n.getExtension("WEBGL_compressed_texture_s3tc")||n.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=n.getExtension("WEBGL_compressed_texture_pvrtc")||n.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=n.getExtension(i)}return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){const s=e(i);return s===null&&uo("THREE.WebGLRenderer: "+i+" extension not supported."),s}}}function oS(n,t,e,i){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&t.remove(f.index);for(const g in f.attributes)t.remove(f.attributes[g]);for(const g in f.morphAttributes){const v=f.morphAttributes[g];for(let m=0,p=v.length;m<p;m++)t.remove(v[m])}f.removeEventListener("dispose",o),delete s[f.id];const d=r.get(f);d&&(t.remove(d),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){const f=h.attributes;for(const g in f)t.update(f[g],n.ARRAY_BUFFER);const d=h.morphAttributes;for(const g in d){const v=d[g];for(let m=0,p=v.length;m<p;m++)t.update(v[m],n.ARRAY_BUFFER)}}function c(h){const f=[],d=h.index,g=h.attributes.position;let v=0;if(d!==null){const E=d.array;v=d.version;for(let w=0,M=E.length;w<M;w+=3){const O=E[w+0],R=E[w+1],D=E[w+2];f.push(O,R,R,D,D,O)}}else if(g!==void 0){const E=g.array;v=g.version;for(let w=0,M=E.length/3-1;w<M;w+=3){const O=w+0,R=w+1,D=w+2;f.push(O,R,R,D,D,O)}}else return;const m=new(Ap(f)?Up:Dp)(f,1);m.version=v;const p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){const f=r.get(h);if(f){const d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function aS(n,t,e){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){n.drawElements(i,d,r,f*o),e.update(d,i,1)}function c(f,d,g){g!==0&&(n.drawElementsInstanced(i,d,r,f*o,g),e.update(d,i,g))}function u(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,i,1)}function h(f,d,g,v){if(g===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(i,d,0,r,f,0,v,0,g);let p=0;for(let E=0;E<g;E++)p+=d[E]*v[E];e.update(p,i,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function lS(n){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function cS(n,t,e){const i=new WeakMap,s=new We;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=i.get(a);if(f===void 0||f.count!==h){let T=function(){D.dispose(),i.delete(a),a.removeEventListener("dispose",T)};f!==void 0&&f.texture.dispose();const d=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],E=a.morphAttributes.color||[];let w=0;d===!0&&(w=1),g===!0&&(w=2),v===!0&&(w=3);let M=a.attributes.position.count*w,O=1;M>t.maxTextureSize&&(O=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);const R=new Float32Array(M*O*4*h),D=new Cp(R,M,O,h);D.type=$i,D.needsUpdate=!0;const U=w*4;for(let S=0;S<h;S++){const C=m[S],V=p[S],I=E[S],G=M*O*4*S;for(let j=0;j<C.count;j++){const K=j*U;d===!0&&(s.fromBufferAttribute(C,j),R[G+K+0]=s.x,R[G+K+1]=s.y,R[G+K+2]=s.z,R[G+K+3]=0),g===!0&&(s.fromBufferAttribute(V,j),R[G+K+4]=s.x,R[G+K+5]=s.y,R[G+K+6]=s.z,R[G+K+7]=0),v===!0&&(s.fromBufferAttribute(I,j),R[G+K+8]=s.x,R[G+K+9]=s.y,R[G+K+10]=s.z,R[G+K+11]=I.itemSize===4?s.w:1)}}f={count:h,texture:D,size:new ae(M,O)},i.set(a,f),a.addEventListener("dispose",T)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let v=0;v<c.length;v++)d+=c[v];const g=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function uS(n,t,e,i){let s=new WeakMap;function r(l){const c=i.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}class kp extends In{constructor(t,e,i,s,r,o,a,l,c,u=br){if(u!==br&&u!==Fr)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");i===void 0&&u===br&&(i=zs),i===void 0&&u===Fr&&(i=Nr),super(null,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.image={width:t,height:e},this.magFilter=a!==void 0?a:gi,this.minFilter=l!==void 0?l:gi,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}const Bp=new In,Lf=new kp(1,1),zp=new Cp,Hp=new j0,Vp=new Fp,Df=[],Uf=[],If=new Float32Array(16),Nf=new Float32Array(9),Ff=new Float32Array(4);function Xr(n,t,e){const i=n[0];if(i<=0||i>0)return n;const s=t*e;let r=Df[s];if(r===void 0&&(r=new Float32Array(s),Df[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function nn(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function sn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function qa(n,t){let e=Uf[t];e===void 0&&(e=new Int32Array(t),Uf[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function hS(n,t){const e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function fS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(nn(e,t))return;n.uniform2fv(this.addr,t),sn(e,t)}}function dS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(nn(e,t))return;n.uniform3fv(this.addr,t),sn(e,t)}}function pS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(nn(e,t))return;n.uniform4fv(this.addr,t),sn(e,t)}}function mS(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(nn(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),sn(e,t)}else{if(nn(e,i))return;Ff.set(i),n.uniformMatrix2fv(this.addr,!1,Ff),sn(e,i)}}function gS(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(nn(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),sn(e,t)}else{if(nn(e,i))return;Nf.set(i),n.uniformMatrix3fv(this.addr,!1,Nf),sn(e,i)}}function _S(n,t){const e=this.cache,i=t.elements;if(i===void 0){if(nn(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),sn(e,t)}else{if(nn(e,i))return;If.set(i),n.uniformMatrix4fv(this.addr,!1,If),sn(e,i)}}function vS(n,t){const e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function xS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(nn(e,t))return;n.uniform2iv(this.addr,t),sn(e,t)}}function MS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(nn(e,t))return;n.uniform3iv(this.addr,t),sn(e,t)}}function SS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(nn(e,t))return;n.uniform4iv(this.addr,t),sn(e,t)}}function yS(n,t){const e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function ES(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(nn(e,t))return;n.uniform2uiv(this.addr,t),sn(e,t)}}function bS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(nn(e,t))return;n.uniform3uiv(this.addr,t),sn(e,t)}}function TS(n,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(nn(e,t))return;n.uniform4uiv(this.addr,t),sn(e,t)}}function wS(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?(Lf.compareFunction=wp,r=Lf):r=Bp,e.setTexture2D(t||r,s)}function AS(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Hp,s)}function RS(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTextureCube(t||Vp,s)}function CS(n,t,e){const i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||zp,s)}function PS(n){switch(n){case 5126:return hS;case 35664:return fS;case 35665:return dS;case 35666:return pS;case 35674:return mS;case 35675:return gS;case 35676:return _S;case 5124:case 35670:return vS;case 35667:case 35671:return xS;case 35668:case 35672:return MS;case 35669:case 35673:return SS;case 5125:return yS;case 36294:return ES;case 36295:return bS;case 36296:return TS;case 35678:case 36198:case 36298:case 36306:case 35682:return wS;case 35679:case 36299:case 36307:return AS;case 35680:case 36300:case 36308:case 36293:return RS;case 36289:case 36303:case 36311:case 36292:return CS}}function LS(n,t){n.uniform1fv(this.addr,t)}function DS(n,t){const e=Xr(t,this.size,2);n.uniform2fv(this.addr,e)}function US(n,t){const e=Xr(t,this.size,3);n.uniform3fv(this.addr,e)}function IS(n,t){const e=Xr(t,this.size,4);n.uniform4fv(this.addr,e)}function NS(n,t){const e=Xr(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function FS(n,t){const e=Xr(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function OS(n,t){const e=Xr(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function kS(n,t){n.uniform1iv(this.addr,t)}function BS(n,t){n.uniform2iv(this.addr,t)}function zS(n,t){n.uniform3iv(this.addr,t)}function HS(n,t){n.uniform4iv(this.addr,t)}function VS(n,t){n.uniform1uiv(this.addr,t)}function GS(n,t){n.uniform2uiv(this.addr,t)}function WS(n,t){n.uniform3uiv(this.addr,t)}function XS(n,t){n.uniform4uiv(this.addr,t)}function $S(n,t,e){const i=this.cache,s=t.length,r=qa(e,s);nn(i,r)||(n.uniform1iv(this.addr,r),sn(i,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Bp,r[o])}function qS(n,t,e){const i=this.cache,s=t.length,r=qa(e,s);nn(i,r)||(n.uniform1iv(this.addr,r),sn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Hp,r[o])}function YS(n,t,e){const i=this.cache,s=t.length,r=qa(e,s);nn(i,r)||(n.uniform1iv(this.addr,r),sn(i,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Vp,r[o])}function KS(n,t,e){const i=this.cache,s=t.length,r=qa(e,s);nn(i,r)||(n.uniform1iv(this.addr,r),sn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||zp,r[o])}function jS(n){switch(n){case 5126:return LS;case 35664:return DS;case 35665:return US;case 35666:return IS;case 35674:return NS;case 35675:return FS;case 35676:return OS;case 5124:case 35670:return kS;case 35667:case 35671:return BS;case 35668:case 35672:return zS;case 35669:case 35673:return HS;case 5125:return VS;case 36294:return GS;case 36295:return WS;case 36296:return XS;case 35678:case 36198:case 36298:case 36306:case 35682:return $S;case 35679:case 36299:case 36307:return qS;case 35680:case 36300:case 36308:case 36293:return YS;case 36289:case 36303:case 36311:case 36292:return KS}}class ZS{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=PS(e.type)}}class JS{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=jS(e.type)}}class QS{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],i)}}}const Vl=/(\w+)(\])?(\[|\.)?/g;function Of(n,t){n.seq.push(t),n.map[t.id]=t}function ty(n,t,e){const i=n.name,s=i.length;for(Vl.lastIndex=0;;){const r=Vl.exec(i),o=Vl.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Of(e,c===void 0?new ZS(a,n,t):new JS(a,n,t));break}else{let h=e.map[a];h===void 0&&(h=new QS(a),Of(e,h)),e=h}}}class Ea{constructor(t,e){this.seq=[],this.map={};const i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<i;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);ty(r,o,this)}}setValue(t,e,i,s){const r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){const s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const i=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&i.push(o)}return i}}function kf(n,t,e){const i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}const ey=37297;let ny=0;function iy(n,t){const e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}const Bf=new Qt;function sy(n){pe._getMatrix(Bf,pe.workingColorSpace,n);const t=`mat3( ${Bf.elements.map(e=>e.toFixed(4))} )`;switch(pe.getTransfer(n)){case Xa:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function zf(n,t,e){const i=n.getShaderParameter(t,n.COMPILE_STATUS),s=n.getShaderInfoLog(t).trim();if(i&&s==="")return"";const r=/ERROR: 0:(\d+)/.exec(s);if(r){const o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+iy(n.getShaderSource(t),o)}else return s}function ry(n,t){const e=sy(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function oy(n,t){let e;switch(t){case E0:e="Linear";break;case b0:e="Reinhard";break;case T0:e="Cineon";break;case w0:e="ACESFilmic";break;case R0:e="AgX";break;case C0:e="Neutral";break;case A0:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const ra=new z;function ay(){pe.getLuminanceCoefficients(ra);const n=ra.x.toFixed(4),t=ra.y.toFixed(4),e=ra.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function ly(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ho).join(`
`)}function cy(n){const t=[];for(const e in n){const i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function uy(n,t){const e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){const r=n.getActiveAttrib(t,s),o=r.name;let a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function ho(n){return n!==""}function Hf(n,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Vf(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const hy=/^[ \t]*#include +<([\w\d./]+)>/gm;function Yc(n){return n.replace(hy,dy)}const fy=new Map;function dy(n,t){let e=ee[t];if(e===void 0){const i=fy.get(t);if(i!==void 0)e=ee[i],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,i);else throw new Error("Can not resolve #include <"+t+">")}return Yc(e)}const py=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Gf(n){return n.replace(py,my)}function my(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Wf(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function gy(n){let t="SHADOWMAP_TYPE_BASIC";return n.shadowMapType===dp?t="SHADOWMAP_TYPE_PCF":n.shadowMapType===n0?t="SHADOWMAP_TYPE_PCF_SOFT":n.shadowMapType===Xi&&(t="SHADOWMAP_TYPE_VSM"),t}function _y(n){let t="ENVMAP_TYPE_CUBE";if(n.envMap)switch(n.envMapMode){case Ur:case Ir:t="ENVMAP_TYPE_CUBE";break;case Wa:t="ENVMAP_TYPE_CUBE_UV";break}return t}function vy(n){let t="ENVMAP_MODE_REFLECTION";if(n.envMap)switch(n.envMapMode){case Ir:t="ENVMAP_MODE_REFRACTION";break}return t}function xy(n){let t="ENVMAP_BLENDING_NONE";if(n.envMap)switch(n.combine){case Tu:t="ENVMAP_BLENDING_MULTIPLY";break;case S0:t="ENVMAP_BLENDING_MIX";break;case y0:t="ENVMAP_BLENDING_ADD";break}return t}function My(n){const t=n.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,i=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:i,maxMip:e}}function Sy(n,t,e,i){const s=n.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=gy(e),c=_y(e),u=vy(e),h=xy(e),f=My(e),d=ly(e),g=cy(r),v=s.createProgram();let m,p,E=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(ho).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(ho).join(`
`),p.length>0&&(p+=`
`)):(m=[Wf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ho).join(`
`),p=[Wf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGDEPTHBUF":"",e.reverseDepthBuffer?"#define USE_REVERSEDEPTHBUF":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ds?"#define TONE_MAPPING":"",e.toneMapping!==ds?ee.tonemapping_pars_fragment:"",e.toneMapping!==ds?oy("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ee.colorspace_pars_fragment,ry("linearToOutputTexel",e.outputColorSpace),ay(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(ho).join(`
`)),o=Yc(o),o=Hf(o,e),o=Vf(o,e),a=Yc(a),a=Hf(a,e),a=Vf(a,e),o=Gf(o),a=Gf(a),e.isRawShaderMaterial!==!0&&(E=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===nf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===nf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const w=E+m+o,M=E+p+a,O=kf(s,s.VERTEX_SHADER,w),R=kf(s,s.FRAGMENT_SHADER,M);s.attachShader(v,O),s.attachShader(v,R),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function D(C){if(n.debug.checkShaderErrors){const V=s.getProgramInfoLog(v).trim(),I=s.getShaderInfoLog(O).trim(),G=s.getShaderInfoLog(R).trim();let j=!0,K=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(j=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,v,O,R);else{const J=zf(s,O,"vertex"),Q=zf(s,R,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+V+`
`+J+`
`+Q)}else V!==""?console.warn("THREE.WebGLProgram: Program Info Log:",V):(I===""||G==="")&&(K=!1);K&&(C.diagnostics={runnable:j,programLog:V,vertexShader:{log:I,prefix:m},fragmentShader:{log:G,prefix:p}})}s.deleteShader(O),s.deleteShader(R),U=new Ea(s,v),T=uy(s,v)}let U;this.getUniforms=function(){return U===void 0&&D(this),U};let T;this.getAttributes=function(){return T===void 0&&D(this),T};let S=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return S===!1&&(S=s.getProgramParameter(v,ey)),S},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=ny++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=O,this.fragmentShader=R,this}let yy=0;class Ey{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,i=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(i),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){const e=this.shaderCache;let i=e.get(t);return i===void 0&&(i=new by(t),e.set(t,i)),i}}class by{constructor(t){this.id=yy++,this.code=t,this.usedTimes=0}}function Ty(n,t,e,i,s,r,o){const a=new Pp,l=new Ey,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let d=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(T){return c.add(T),T===0?"uv":`uv${T}`}function m(T,S,C,V,I){const G=V.fog,j=I.geometry,K=T.isMeshStandardMaterial?V.environment:null,J=(T.isMeshStandardMaterial?e:t).get(T.envMap||K),Q=J&&J.mapping===Wa?J.image.height:null,ht=g[T.type];T.precision!==null&&(d=s.getMaxPrecision(T.precision),d!==T.precision&&console.warn("THREE.WebGLProgram.getParameters:",T.precision,"not supported, using",d,"instead."));const ct=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mt=ct!==void 0?ct.length:0;let Mt=0;j.morphAttributes.position!==void 0&&(Mt=1),j.morphAttributes.normal!==void 0&&(Mt=2),j.morphAttributes.color!==void 0&&(Mt=3);let pt,nt,at,gt;if(ht){const ve=wi[ht];pt=ve.vertexShader,nt=ve.fragmentShader}else pt=T.vertexShader,nt=T.fragmentShader,l.update(T),at=l.getVertexShaderID(T),gt=l.getFragmentShaderID(T);const rt=n.getRenderTarget(),Bt=n.state.buffers.depth.getReversed(),Ht=I.isInstancedMesh===!0,It=I.isBatchedMesh===!0,le=!!T.map,jt=!!T.matcap,ce=!!J,B=!!T.aoMap,je=!!T.lightMap,Jt=!!T.bumpMap,te=!!T.normalMap,Vt=!!T.displacementMap,he=!!T.emissiveMap,Pt=!!T.metalnessMap,P=!!T.roughnessMap,y=T.anisotropy>0,Y=T.clearcoat>0,Z=T.dispersion>0,W=T.iridescence>0,tt=T.sheen>0,St=T.transmission>0,_t=y&&!!T.anisotropyMap,Tt=Y&&!!T.clearcoatMap,Yt=Y&&!!T.clearcoatNormalMap,ft=Y&&!!T.clearcoatRoughnessMap,vt=W&&!!T.iridescenceMap,Nt=W&&!!T.iridescenceThicknessMap,Ot=tt&&!!T.sheenColorMap,Et=tt&&!!T.sheenRoughnessMap,ne=!!T.specularMap,$t=!!T.specularColorMap,fe=!!T.specularIntensityMap,k=St&&!!T.transmissionMap,xt=St&&!!T.thicknessMap,et=!!T.gradientMap,st=!!T.alphaMap,wt=T.alphaTest>0,At=!!T.alphaHash,Zt=!!T.extensions;let Oe=ds;T.toneMapped&&(rt===null||rt.isXRRenderTarget===!0)&&(Oe=n.toneMapping);const an={shaderID:ht,shaderType:T.type,shaderName:T.name,vertexShader:pt,fragmentShader:nt,defines:T.defines,customVertexShaderID:at,customFragmentShaderID:gt,isRawShaderMaterial:T.isRawShaderMaterial===!0,glslVersion:T.glslVersion,precision:d,batching:It,batchingColor:It&&I._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&I.instanceColor!==null,instancingMorph:Ht&&I.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:rt===null?n.outputColorSpace:rt.isXRRenderTarget===!0?rt.texture.colorSpace:Xs,alphaToCoverage:!!T.alphaToCoverage,map:le,matcap:jt,envMap:ce,envMapMode:ce&&J.mapping,envMapCubeUVHeight:Q,aoMap:B,lightMap:je,bumpMap:Jt,normalMap:te,displacementMap:f&&Vt,emissiveMap:he,normalMapObjectSpace:te&&T.normalMapType===U0,normalMapTangentSpace:te&&T.normalMapType===Tp,metalnessMap:Pt,roughnessMap:P,anisotropy:y,anisotropyMap:_t,clearcoat:Y,clearcoatMap:Tt,clearcoatNormalMap:Yt,clearcoatRoughnessMap:ft,dispersion:Z,iridescence:W,iridescenceMap:vt,iridescenceThicknessMap:Nt,sheen:tt,sheenColorMap:Ot,sheenRoughnessMap:Et,specularMap:ne,specularColorMap:$t,specularIntensityMap:fe,transmission:St,transmissionMap:k,thicknessMap:xt,gradientMap:et,opaque:T.transparent===!1&&T.blending===Er&&T.alphaToCoverage===!1,alphaMap:st,alphaTest:wt,alphaHash:At,combine:T.combine,mapUv:le&&v(T.map.channel),aoMapUv:B&&v(T.aoMap.channel),lightMapUv:je&&v(T.lightMap.channel),bumpMapUv:Jt&&v(T.bumpMap.channel),normalMapUv:te&&v(T.normalMap.channel),displacementMapUv:Vt&&v(T.displacementMap.channel),emissiveMapUv:he&&v(T.emissiveMap.channel),metalnessMapUv:Pt&&v(T.metalnessMap.channel),roughnessMapUv:P&&v(T.roughnessMap.channel),anisotropyMapUv:_t&&v(T.anisotropyMap.channel),clearcoatMapUv:Tt&&v(T.clearcoatMap.channel),clearcoatNormalMapUv:Yt&&v(T.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ft&&v(T.clearcoatRoughnessMap.channel),iridescenceMapUv:vt&&v(T.iridescenceMap.channel),iridescenceThicknessMapUv:Nt&&v(T.iridescenceThicknessMap.channel),sheenColorMapUv:Ot&&v(T.sheenColorMap.channel),sheenRoughnessMapUv:Et&&v(T.sheenRoughnessMap.channel),specularMapUv:ne&&v(T.specularMap.channel),specularColorMapUv:$t&&v(T.specularColorMap.channel),specularIntensityMapUv:fe&&v(T.specularIntensityMap.channel),transmissionMapUv:k&&v(T.transmissionMap.channel),thicknessMapUv:xt&&v(T.thicknessMap.channel),alphaMapUv:st&&v(T.alphaMap.channel),vertexTangents:!!j.attributes.tangent&&(te||y),vertexColors:T.vertexColors,vertexAlphas:T.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!j.attributes.uv&&(le||st),fog:!!G,useFog:T.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:T.flatShading===!0,sizeAttenuation:T.sizeAttenuation===!0,logarithmicDepthBuffer:h,reverseDepthBuffer:Bt,skinning:I.isSkinnedMesh===!0,morphTargets:j.morphAttributes.position!==void 0,morphNormals:j.morphAttributes.normal!==void 0,morphColors:j.morphAttributes.color!==void 0,morphTargetsCount:mt,morphTextureStride:Mt,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:T.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:Oe,decodeVideoTexture:le&&T.map.isVideoTexture===!0&&pe.getTransfer(T.map.colorSpace)===Ae,decodeVideoTextureEmissive:he&&T.emissiveMap.isVideoTexture===!0&&pe.getTransfer(T.emissiveMap.colorSpace)===Ae,premultipliedAlpha:T.premultipliedAlpha,doubleSided:T.side===Ri,flipSided:T.side===Un,useDepthPacking:T.depthPacking>=0,depthPacking:T.depthPacking||0,index0AttributeName:T.index0AttributeName,extensionClipCullDistance:Zt&&T.extensions.clipCullDistance===!0&&i.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Zt&&T.extensions.multiDraw===!0||It)&&i.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:i.has("KHR_parallel_shader_compile"),customProgramCacheKey:T.customProgramCacheKey()};return an.vertexUv1s=c.has(1),an.vertexUv2s=c.has(2),an.vertexUv3s=c.has(3),c.clear(),an}function p(T){const S=[];if(T.shaderID?S.push(T.shaderID):(S.push(T.customVertexShaderID),S.push(T.customFragmentShaderID)),T.defines!==void 0)for(const C in T.defines)S.push(C),S.push(T.defines[C]);return T.isRawShaderMaterial===!1&&(E(S,T),w(S,T),S.push(n.outputColorSpace)),S.push(T.customProgramCacheKey),S.join()}function E(T,S){T.push(S.precision),T.push(S.outputColorSpace),T.push(S.envMapMode),T.push(S.envMapCubeUVHeight),T.push(S.mapUv),T.push(S.alphaMapUv),T.push(S.lightMapUv),T.push(S.aoMapUv),T.push(S.bumpMapUv),T.push(S.normalMapUv),T.push(S.displacementMapUv),T.push(S.emissiveMapUv),T.push(S.metalnessMapUv),T.push(S.roughnessMapUv),T.push(S.anisotropyMapUv),T.push(S.clearcoatMapUv),T.push(S.clearcoatNormalMapUv),T.push(S.clearcoatRoughnessMapUv),T.push(S.iridescenceMapUv),T.push(S.iridescenceThicknessMapUv),T.push(S.sheenColorMapUv),T.push(S.sheenRoughnessMapUv),T.push(S.specularMapUv),T.push(S.specularColorMapUv),T.push(S.specularIntensityMapUv),T.push(S.transmissionMapUv),T.push(S.thicknessMapUv),T.push(S.combine),T.push(S.fogExp2),T.push(S.sizeAttenuation),T.push(S.morphTargetsCount),T.push(S.morphAttributeCount),T.push(S.numDirLights),T.push(S.numPointLights),T.push(S.numSpotLights),T.push(S.numSpotLightMaps),T.push(S.numHemiLights),T.push(S.numRectAreaLights),T.push(S.numDirLightShadows),T.push(S.numPointLightShadows),T.push(S.numSpotLightShadows),T.push(S.numSpotLightShadowsWithMaps),T.push(S.numLightProbes),T.push(S.shadowMapType),T.push(S.toneMapping),T.push(S.numClippingPlanes),T.push(S.numClipIntersection),T.push(S.depthPacking)}function w(T,S){a.disableAll(),S.supportsVertexTextures&&a.enable(0),S.instancing&&a.enable(1),S.instancingColor&&a.enable(2),S.instancingMorph&&a.enable(3),S.matcap&&a.enable(4),S.envMap&&a.enable(5),S.normalMapObjectSpace&&a.enable(6),S.normalMapTangentSpace&&a.enable(7),S.clearcoat&&a.enable(8),S.iridescence&&a.enable(9),S.alphaTest&&a.enable(10),S.vertexColors&&a.enable(11),S.vertexAlphas&&a.enable(12),S.vertexUv1s&&a.enable(13),S.vertexUv2s&&a.enable(14),S.vertexUv3s&&a.enable(15),S.vertexTangents&&a.enable(16),S.anisotropy&&a.enable(17),S.alphaHash&&a.enable(18),S.batching&&a.enable(19),S.dispersion&&a.enable(20),S.batchingColor&&a.enable(21),T.push(a.mask),a.disableAll(),S.fog&&a.enable(0),S.useFog&&a.enable(1),S.flatShading&&a.enable(2),S.logarithmicDepthBuffer&&a.enable(3),S.reverseDepthBuffer&&a.enable(4),S.skinning&&a.enable(5),S.morphTargets&&a.enable(6),S.morphNormals&&a.enable(7),S.morphColors&&a.enable(8),S.premultipliedAlpha&&a.enable(9),S.shadowMapEnabled&&a.enable(10),S.doubleSided&&a.enable(11),S.flipSided&&a.enable(12),S.useDepthPacking&&a.enable(13),S.dithering&&a.enable(14),S.transmission&&a.enable(15),S.sheen&&a.enable(16),S.opaque&&a.enable(17),S.pointsUvs&&a.enable(18),S.decodeVideoTexture&&a.enable(19),S.decodeVideoTextureEmissive&&a.enable(20),S.alphaToCoverage&&a.enable(21),T.push(a.mask)}function M(T){const S=g[T.type];let C;if(S){const V=wi[S];C=lv.clone(V.uniforms)}else C=T.uniforms;return C}function O(T,S){let C;for(let V=0,I=u.length;V<I;V++){const G=u[V];if(G.cacheKey===S){C=G,++C.usedTimes;break}}return C===void 0&&(C=new Sy(n,S,T,r),u.push(C)),C}function R(T){if(--T.usedTimes===0){const S=u.indexOf(T);u[S]=u[u.length-1],u.pop(),T.destroy()}}function D(T){l.remove(T)}function U(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:M,acquireProgram:O,releaseProgram:R,releaseShaderCache:D,programs:u,dispose:U}}function wy(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function Ay(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.z!==t.z?n.z-t.z:n.id-t.id}function Xf(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function $f(){const n=[];let t=0;const e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(h,f,d,g,v,m){let p=n[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},n[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.push(p):d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?i.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||Ay),i.length>1&&i.sort(f||Xf),s.length>1&&s.sort(f||Xf)}function u(){for(let h=t,f=n.length;h<f;h++){const d=n[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function Ry(){let n=new WeakMap;function t(i,s){const r=n.get(i);let o;return r===void 0?(o=new $f,n.set(i,[o])):s>=r.length?(o=new $f,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function Cy(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new z,color:new oe};break;case"SpotLight":e={position:new z,direction:new z,color:new oe,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new oe,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new oe,groundColor:new oe};break;case"RectAreaLight":e={color:new oe,position:new z,halfWidth:new z,halfHeight:new z};break}return n[t.id]=e,e}}}function Py(){const n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ae};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ae};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ae,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}let Ly=0;function Dy(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function Uy(n){const t=new Cy,e=Py(),i={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);const s=new z,r=new ze,o=new ze;function a(c){let u=0,h=0,f=0;for(let T=0;T<9;T++)i.probe[T].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,E=0,w=0,M=0,O=0,R=0,D=0;c.sort(Dy);for(let T=0,S=c.length;T<S;T++){const C=c[T],V=C.color,I=C.intensity,G=C.distance,j=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=V.r*I,h+=V.g*I,f+=V.b*I;else if(C.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(C.sh.coefficients[K],I);D++}else if(C.isDirectionalLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const J=C.shadow,Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,i.directionalShadow[d]=Q,i.directionalShadowMap[d]=j,i.directionalShadowMatrix[d]=C.shadow.matrix,E++}i.directional[d]=K,d++}else if(C.isSpotLight){const K=t.get(C);K.position.setFromMatrixPosition(C.matrixWorld),K.color.copy(V).multiplyScalar(I),K.distance=G,K.coneCos=Math.cos(C.angle),K.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),K.decay=C.decay,i.spot[v]=K;const J=C.shadow;if(C.map&&(i.spotLightMap[O]=C.map,O++,J.updateMatrices(C),C.castShadow&&R++),i.spotLightMatrix[v]=J.matrix,C.castShadow){const Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,i.spotShadow[v]=Q,i.spotShadowMap[v]=j,M++}v++}else if(C.isRectAreaLight){const K=t.get(C);K.color.copy(V).multiplyScalar(I),K.halfWidth.set(C.width*.5,0,0),K.halfHeight.set(0,C.height*.5,0),i.rectArea[m]=K,m++}else if(C.isPointLight){const K=t.get(C);if(K.color.copy(C.color).multiplyScalar(C.intensity),K.distance=C.distance,K.decay=C.decay,C.castShadow){const J=C.shadow,Q=e.get(C);Q.shadowIntensity=J.intensity,Q.shadowBias=J.bias,Q.shadowNormalBias=J.normalBias,Q.shadowRadius=J.radius,Q.shadowMapSize=J.mapSize,Q.shadowCameraNear=J.camera.near,Q.shadowCameraFar=J.camera.far,i.pointShadow[g]=Q,i.pointShadowMap[g]=j,i.pointShadowMatrix[g]=C.shadow.matrix,w++}i.point[g]=K,g++}else if(C.isHemisphereLight){const K=t.get(C);K.skyColor.copy(C.color).multiplyScalar(I),K.groundColor.copy(C.groundColor).multiplyScalar(I),i.hemi[p]=K,p++}}m>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=bt.LTC_FLOAT_1,i.rectAreaLTC2=bt.LTC_FLOAT_2):(i.rectAreaLTC1=bt.LTC_HALF_1,i.rectAreaLTC2=bt.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;const U=i.hash;(U.directionalLength!==d||U.pointLength!==g||U.spotLength!==v||U.rectAreaLength!==m||U.hemiLength!==p||U.numDirectionalShadows!==E||U.numPointShadows!==w||U.numSpotShadows!==M||U.numSpotMaps!==O||U.numLightProbes!==D)&&(i.directional.length=d,i.spot.length=v,i.rectArea.length=m,i.point.length=g,i.hemi.length=p,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.pointShadow.length=w,i.pointShadowMap.length=w,i.spotShadow.length=M,i.spotShadowMap.length=M,i.directionalShadowMatrix.length=E,i.pointShadowMatrix.length=w,i.spotLightMatrix.length=M+O-R,i.spotLightMap.length=O,i.numSpotLightShadowsWithMaps=R,i.numLightProbes=D,U.directionalLength=d,U.pointLength=g,U.spotLength=v,U.rectAreaLength=m,U.hemiLength=p,U.numDirectionalShadows=E,U.numPointShadows=w,U.numSpotShadows=M,U.numSpotMaps=O,U.numLightProbes=D,i.version=Ly++)}function l(c,u){let h=0,f=0,d=0,g=0,v=0;const m=u.matrixWorldInverse;for(let p=0,E=c.length;p<E;p++){const w=c[p];if(w.isDirectionalLight){const M=i.directional[h];M.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),h++}else if(w.isSpotLight){const M=i.spot[d];M.position.setFromMatrixPosition(w.matrixWorld),M.position.applyMatrix4(m),M.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),d++}else if(w.isRectAreaLight){const M=i.rectArea[g];M.position.setFromMatrixPosition(w.matrixWorld),M.position.applyMatrix4(m),o.identity(),r.copy(w.matrixWorld),r.premultiply(m),o.extractRotation(r),M.halfWidth.set(w.width*.5,0,0),M.halfHeight.set(0,w.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),g++}else if(w.isPointLight){const M=i.point[f];M.position.setFromMatrixPosition(w.matrixWorld),M.position.applyMatrix4(m),f++}else if(w.isHemisphereLight){const M=i.hemi[v];M.direction.setFromMatrixPosition(w.matrixWorld),M.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:i}}function qf(n){const t=new Uy(n),e=[],i=[];function s(u){c.camera=u,e.length=0,i.length=0}function r(u){e.push(u)}function o(u){i.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:i,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function Iy(n){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new qf(n),t.set(s,[a])):r>=o.length?(a=new qf(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}class Ny extends qs{static get type(){return"MeshDepthMaterial"}constructor(t){super(),this.isMeshDepthMaterial=!0,this.depthPacking=L0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class Fy extends qs{static get type(){return"MeshDistanceMaterial"}constructor(t){super(),this.isMeshDistanceMaterial=!0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const Oy=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,ky=`uniform sampler2D shadow_pass;
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
}`;function By(n,t,e){let i=new Uu;const s=new ae,r=new ae,o=new We,a=new Ny({depthPacking:D0}),l=new Fy,c={},u=e.maxTextureSize,h={[ms]:Un,[Un]:ms,[Ri]:Ri},f=new gs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ae},radius:{value:4}},vertexShader:Oy,fragmentShader:ky}),d=f.clone();d.defines.HORIZONTAL_PASS=1;const g=new on;g.setAttribute("position",new Nn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new Mn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=dp;let p=this.type;this.render=function(R,D,U){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||R.length===0)return;const T=n.getRenderTarget(),S=n.getActiveCubeFace(),C=n.getActiveMipmapLevel(),V=n.state;V.setBlending(fs),V.buffers.color.setClear(1,1,1,1),V.buffers.depth.setTest(!0),V.setScissorTest(!1);const I=p!==Xi&&this.type===Xi,G=p===Xi&&this.type!==Xi;for(let j=0,K=R.length;j<K;j++){const J=R[j],Q=J.shadow;if(Q===void 0){console.warn("THREE.WebGLShadowMap:",J,"has no shadow.");continue}if(Q.autoUpdate===!1&&Q.needsUpdate===!1)continue;s.copy(Q.mapSize);const ht=Q.getFrameExtents();if(s.multiply(ht),r.copy(Q.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ht.x),s.x=r.x*ht.x,Q.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ht.y),s.y=r.y*ht.y,Q.mapSize.y=r.y)),Q.map===null||I===!0||G===!0){const mt=this.type!==Xi?{minFilter:gi,magFilter:gi}:{};Q.map!==null&&Q.map.dispose(),Q.map=new Hs(s.x,s.y,mt),Q.map.texture.name=J.name+".shadowMap",Q.camera.updateProjectionMatrix()}n.setRenderTarget(Q.map),n.clear();const ct=Q.getViewportCount();for(let mt=0;mt<ct;mt++){const Mt=Q.getViewport(mt);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),V.viewport(o),Q.updateMatrices(J,mt),i=Q.getFrustum(),M(D,U,Q.camera,J,this.type)}Q.isPointLightShadow!==!0&&this.type===Xi&&E(Q,U),Q.needsUpdate=!1}p=this.type,m.needsUpdate=!1,n.setRenderTarget(T,S,C)};function E(R,D){const U=t.update(v);f.defines.VSM_SAMPLES!==R.blurSamples&&(f.defines.VSM_SAMPLES=R.blurSamples,d.defines.VSM_SAMPLES=R.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),R.mapPass===null&&(R.mapPass=new Hs(s.x,s.y)),f.uniforms.shadow_pass.value=R.map.texture,f.uniforms.resolution.value=R.mapSize,f.uniforms.radius.value=R.radius,n.setRenderTarget(R.mapPass),n.clear(),n.renderBufferDirect(D,null,U,f,v,null),d.uniforms.shadow_pass.value=R.mapPass.texture,d.uniforms.resolution.value=R.mapSize,d.uniforms.radius.value=R.radius,n.setRenderTarget(R.map),n.clear(),n.renderBufferDirect(D,null,U,d,v,null)}function w(R,D,U,T){let S=null;const C=U.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(C!==void 0)S=C;else if(S=U.isPointLight===!0?l:a,n.localClippingEnabled&&D.clipShadows===!0&&Array.isArray(D.clippingPlanes)&&D.clippingPlanes.length!==0||D.displacementMap&&D.displacementScale!==0||D.alphaMap&&D.alphaTest>0||D.map&&D.alphaTest>0){const V=S.uuid,I=D.uuid;let G=c[V];G===void 0&&(G={},c[V]=G);let j=G[I];j===void 0&&(j=S.clone(),G[I]=j,D.addEventListener("dispose",O)),S=j}if(S.visible=D.visible,S.wireframe=D.wireframe,T===Xi?S.side=D.shadowSide!==null?D.shadowSide:D.side:S.side=D.shadowSide!==null?D.shadowSide:h[D.side],S.alphaMap=D.alphaMap,S.alphaTest=D.alphaTest,S.map=D.map,S.clipShadows=D.clipShadows,S.clippingPlanes=D.clippingPlanes,S.clipIntersection=D.clipIntersection,S.displacementMap=D.displacementMap,S.displacementScale=D.displacementScale,S.displacementBias=D.displacementBias,S.wireframeLinewidth=D.wireframeLinewidth,S.linewidth=D.linewidth,U.isPointLight===!0&&S.isMeshDistanceMaterial===!0){const V=n.properties.get(S);V.light=U}return S}function M(R,D,U,T,S){if(R.visible===!1)return;if(R.layers.test(D.layers)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&S===Xi)&&(!R.frustumCulled||i.intersectsObject(R))){R.modelViewMatrix.multiplyMatrices(U.matrixWorldInverse,R.matrixWorld);const I=t.update(R),G=R.material;if(Array.isArray(G)){const j=I.groups;for(let K=0,J=j.length;K<J;K++){const Q=j[K],ht=G[Q.materialIndex];if(ht&&ht.visible){const ct=w(R,ht,T,S);R.onBeforeShadow(n,R,D,U,I,ct,Q),n.renderBufferDirect(U,null,I,ct,R,Q),R.onAfterShadow(n,R,D,U,I,ct,Q)}}}else if(G.visible){const j=w(R,G,T,S);R.onBeforeShadow(n,R,D,U,I,j,null),n.renderBufferDirect(U,null,I,j,R,null),R.onAfterShadow(n,R,D,U,I,j,null)}}const V=R.children;for(let I=0,G=V.length;I<G;I++)M(V[I],D,U,T,S)}function O(R){R.target.removeEventListener("dispose",O);for(const U in c){const T=c[U],S=R.target.uuid;S in T&&(T[S].dispose(),delete T[S])}}}const zy={[uc]:hc,[fc]:mc,[dc]:gc,[Dr]:pc,[hc]:uc,[mc]:fc,[gc]:dc,[pc]:Dr};function Hy(n,t){function e(){let k=!1;const xt=new We;let et=null;const st=new We(0,0,0,0);return{setMask:function(wt){et!==wt&&!k&&(n.colorMask(wt,wt,wt,wt),et=wt)},setLocked:function(wt){k=wt},setClear:function(wt,At,Zt,Oe,an){an===!0&&(wt*=Oe,At*=Oe,Zt*=Oe),xt.set(wt,At,Zt,Oe),st.equals(xt)===!1&&(n.clearColor(wt,At,Zt,Oe),st.copy(xt))},reset:function(){k=!1,et=null,st.set(-1,0,0,0)}}}function i(){let k=!1,xt=!1,et=null,st=null,wt=null;return{setReversed:function(At){if(xt!==At){const Zt=t.get("EXT_clip_control");xt?Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.ZERO_TO_ONE_EXT):Zt.clipControlEXT(Zt.LOWER_LEFT_EXT,Zt.NEGATIVE_ONE_TO_ONE_EXT);const Oe=wt;wt=null,this.setClear(Oe)}xt=At},getReversed:function(){return xt},setTest:function(At){At?rt(n.DEPTH_TEST):Bt(n.DEPTH_TEST)},setMask:function(At){et!==At&&!k&&(n.depthMask(At),et=At)},setFunc:function(At){if(xt&&(At=zy[At]),st!==At){switch(At){case uc:n.depthFunc(n.NEVER);break;case hc:n.depthFunc(n.ALWAYS);break;case fc:n.depthFunc(n.LESS);break;case Dr:n.depthFunc(n.LEQUAL);break;case dc:n.depthFunc(n.EQUAL);break;case pc:n.depthFunc(n.GEQUAL);break;case mc:n.depthFunc(n.GREATER);break;case gc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}st=At}},setLocked:function(At){k=At},setClear:function(At){wt!==At&&(xt&&(At=1-At),n.clearDepth(At),wt=At)},reset:function(){k=!1,et=null,st=null,wt=null,xt=!1}}}function s(){let k=!1,xt=null,et=null,st=null,wt=null,At=null,Zt=null,Oe=null,an=null;return{setTest:function(ve){k||(ve?rt(n.STENCIL_TEST):Bt(n.STENCIL_TEST))},setMask:function(ve){xt!==ve&&!k&&(n.stencilMask(ve),xt=ve)},setFunc:function(ve,Ze,Le){(et!==ve||st!==Ze||wt!==Le)&&(n.stencilFunc(ve,Ze,Le),et=ve,st=Ze,wt=Le)},setOp:function(ve,Ze,Le){(At!==ve||Zt!==Ze||Oe!==Le)&&(n.stencilOp(ve,Ze,Le),At=ve,Zt=Ze,Oe=Le)},setLocked:function(ve){k=ve},setClear:function(ve){an!==ve&&(n.clearStencil(ve),an=ve)},reset:function(){k=!1,xt=null,et=null,st=null,wt=null,At=null,Zt=null,Oe=null,an=null}}}const r=new e,o=new i,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,E=null,w=null,M=null,O=null,R=null,D=new oe(0,0,0),U=0,T=!1,S=null,C=null,V=null,I=null,G=null;const j=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let K=!1,J=0;const Q=n.getParameter(n.VERSION);Q.indexOf("WebGL")!==-1?(J=parseFloat(/^WebGL (\d)/.exec(Q)[1]),K=J>=1):Q.indexOf("OpenGL ES")!==-1&&(J=parseFloat(/^OpenGL ES (\d)/.exec(Q)[1]),K=J>=2);let ht=null,ct={};const mt=n.getParameter(n.SCISSOR_BOX),Mt=n.getParameter(n.VIEWPORT),pt=new We().fromArray(mt),nt=new We().fromArray(Mt);function at(k,xt,et,st){const wt=new Uint8Array(4),At=n.createTexture();n.bindTexture(k,At),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Zt=0;Zt<et;Zt++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(xt,0,n.RGBA,1,1,st,0,n.RGBA,n.UNSIGNED_BYTE,wt):n.texImage2D(xt+Zt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,wt);return At}const gt={};gt[n.TEXTURE_2D]=at(n.TEXTURE_2D,n.TEXTURE_2D,1),gt[n.TEXTURE_CUBE_MAP]=at(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),gt[n.TEXTURE_2D_ARRAY]=at(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),gt[n.TEXTURE_3D]=at(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),rt(n.DEPTH_TEST),o.setFunc(Dr),Jt(!1),te(jh),rt(n.CULL_FACE),B(fs);function rt(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function Bt(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function Ht(k,xt){return h[k]!==xt?(n.bindFramebuffer(k,xt),h[k]=xt,k===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=xt),k===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=xt),!0):!1}function It(k,xt){let et=d,st=!1;if(k){et=f.get(xt),et===void 0&&(et=[],f.set(xt,et));const wt=k.textures;if(et.length!==wt.length||et[0]!==n.COLOR_ATTACHMENT0){for(let At=0,Zt=wt.length;At<Zt;At++)et[At]=n.COLOR_ATTACHMENT0+At;et.length=wt.length,st=!0}}else et[0]!==n.BACK&&(et[0]=n.BACK,st=!0);st&&n.drawBuffers(et)}function le(k){return g!==k?(n.useProgram(k),g=k,!0):!1}const jt={[Is]:n.FUNC_ADD,[s0]:n.FUNC_SUBTRACT,[r0]:n.FUNC_REVERSE_SUBTRACT};jt[o0]=n.MIN,jt[a0]=n.MAX;const ce={[l0]:n.ZERO,[c0]:n.ONE,[u0]:n.SRC_COLOR,[lc]:n.SRC_ALPHA,[g0]:n.SRC_ALPHA_SATURATE,[p0]:n.DST_COLOR,[f0]:n.DST_ALPHA,[h0]:n.ONE_MINUS_SRC_COLOR,[cc]:n.ONE_MINUS_SRC_ALPHA,[m0]:n.ONE_MINUS_DST_COLOR,[d0]:n.ONE_MINUS_DST_ALPHA,[_0]:n.CONSTANT_COLOR,[v0]:n.ONE_MINUS_CONSTANT_COLOR,[x0]:n.CONSTANT_ALPHA,[M0]:n.ONE_MINUS_CONSTANT_ALPHA};function B(k,xt,et,st,wt,At,Zt,Oe,an,ve){if(k===fs){v===!0&&(Bt(n.BLEND),v=!1);return}if(v===!1&&(rt(n.BLEND),v=!0),k!==i0){if(k!==m||ve!==T){if((p!==Is||M!==Is)&&(n.blendEquation(n.FUNC_ADD),p=Is,M=Is),ve)switch(k){case Er:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Zh:n.blendFunc(n.ONE,n.ONE);break;case Jh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Qh:n.blendFuncSeparate(n.ZERO,n.SRC_COLOR,n.ZERO,n.SRC_ALPHA);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}else switch(k){case Er:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Zh:n.blendFunc(n.SRC_ALPHA,n.ONE);break;case Jh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Qh:n.blendFunc(n.ZERO,n.SRC_COLOR);break;default:console.error("THREE.WebGLState: Invalid blending: ",k);break}E=null,w=null,O=null,R=null,D.set(0,0,0),U=0,m=k,T=ve}return}wt=wt||xt,At=At||et,Zt=Zt||st,(xt!==p||wt!==M)&&(n.blendEquationSeparate(jt[xt],jt[wt]),p=xt,M=wt),(et!==E||st!==w||At!==O||Zt!==R)&&(n.blendFuncSeparate(ce[et],ce[st],ce[At],ce[Zt]),E=et,w=st,O=At,R=Zt),(Oe.equals(D)===!1||an!==U)&&(n.blendColor(Oe.r,Oe.g,Oe.b,an),D.copy(Oe),U=an),m=k,T=!1}function je(k,xt){k.side===Ri?Bt(n.CULL_FACE):rt(n.CULL_FACE);let et=k.side===Un;xt&&(et=!et),Jt(et),k.blending===Er&&k.transparent===!1?B(fs):B(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);const st=k.stencilWrite;a.setTest(st),st&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),he(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?rt(n.SAMPLE_ALPHA_TO_COVERAGE):Bt(n.SAMPLE_ALPHA_TO_COVERAGE)}function Jt(k){S!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),S=k)}function te(k){k!==t0?(rt(n.CULL_FACE),k!==C&&(k===jh?n.cullFace(n.BACK):k===e0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Bt(n.CULL_FACE),C=k}function Vt(k){k!==V&&(K&&n.lineWidth(k),V=k)}function he(k,xt,et){k?(rt(n.POLYGON_OFFSET_FILL),(I!==xt||G!==et)&&(n.polygonOffset(xt,et),I=xt,G=et)):Bt(n.POLYGON_OFFSET_FILL)}function Pt(k){k?rt(n.SCISSOR_TEST):Bt(n.SCISSOR_TEST)}function P(k){k===void 0&&(k=n.TEXTURE0+j-1),ht!==k&&(n.activeTexture(k),ht=k)}function y(k,xt,et){et===void 0&&(ht===null?et=n.TEXTURE0+j-1:et=ht);let st=ct[et];st===void 0&&(st={type:void 0,texture:void 0},ct[et]=st),(st.type!==k||st.texture!==xt)&&(ht!==et&&(n.activeTexture(et),ht=et),n.bindTexture(k,xt||gt[k]),st.type=k,st.texture=xt)}function Y(){const k=ct[ht];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Z(){try{n.compressedTexImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function W(){try{n.compressedTexImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function tt(){try{n.texSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function St(){try{n.texSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function _t(){try{n.compressedTexSubImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Tt(){try{n.compressedTexSubImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Yt(){try{n.texStorage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function ft(){try{n.texStorage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function vt(){try{n.texImage2D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Nt(){try{n.texImage3D.apply(n,arguments)}catch(k){console.error("THREE.WebGLState:",k)}}function Ot(k){pt.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),pt.copy(k))}function Et(k){nt.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),nt.copy(k))}function ne(k,xt){let et=c.get(xt);et===void 0&&(et=new WeakMap,c.set(xt,et));let st=et.get(k);st===void 0&&(st=n.getUniformBlockIndex(xt,k.name),et.set(k,st))}function $t(k,xt){const st=c.get(xt).get(k);l.get(xt)!==st&&(n.uniformBlockBinding(xt,st,k.__bindingPointIndex),l.set(xt,st))}function fe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),u={},ht=null,ct={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,E=null,w=null,M=null,O=null,R=null,D=new oe(0,0,0),U=0,T=!1,S=null,C=null,V=null,I=null,G=null,pt.set(0,0,n.canvas.width,n.canvas.height),nt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:rt,disable:Bt,bindFramebuffer:Ht,drawBuffers:It,useProgram:le,setBlending:B,setMaterial:je,setFlipSided:Jt,setCullFace:te,setLineWidth:Vt,setPolygonOffset:he,setScissorTest:Pt,activeTexture:P,bindTexture:y,unbindTexture:Y,compressedTexImage2D:Z,compressedTexImage3D:W,texImage2D:vt,texImage3D:Nt,updateUBOMapping:ne,uniformBlockBinding:$t,texStorage2D:Yt,texStorage3D:ft,texSubImage2D:tt,texSubImage3D:St,compressedTexSubImage2D:_t,compressedTexSubImage3D:Tt,scissor:Ot,viewport:Et,reset:fe}}function Yf(n,t,e,i){const s=Vy(i);switch(e){case vp:return n*t;case Mp:return n*t;case Sp:return n*t*2;case yp:return n*t/s.components*s.byteLength;case Cu:return n*t/s.components*s.byteLength;case Ep:return n*t*2/s.components*s.byteLength;case Pu:return n*t*2/s.components*s.byteLength;case xp:return n*t*3/s.components*s.byteLength;case pi:return n*t*4/s.components*s.byteLength;case Lu:return n*t*4/s.components*s.byteLength;case _a:case va:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case xa:case Ma:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case yc:case bc:return Math.max(n,16)*Math.max(t,8)/4;case Sc:case Ec:return Math.max(n,8)*Math.max(t,8)/2;case Tc:case wc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Ac:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Rc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Cc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Pc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Lc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Dc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Uc:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Ic:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Nc:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Fc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Oc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case kc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Bc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case zc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Hc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Sa:case Vc:case Gc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case bp:case Wc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Xc:case $c:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Vy(n){switch(n){case Ji:case mp:return{byteLength:1,components:1};case xo:case gp:case Eo:return{byteLength:2,components:1};case Au:case Ru:return{byteLength:2,components:4};case zs:case wu:case $i:return{byteLength:4,components:1};case _p:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${n}.`)}function Gy(n,t,e,i,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ae,u=new WeakMap;let h;const f=new WeakMap;let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(P,y){return d?new OffscreenCanvas(P,y):Ca("canvas")}function v(P,y,Y){let Z=1;const W=Pt(P);if((W.width>Y||W.height>Y)&&(Z=Y/Math.max(W.width,W.height)),Z<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){const tt=Math.floor(Z*W.width),St=Math.floor(Z*W.height);h===void 0&&(h=g(tt,St));const _t=y?g(tt,St):h;return _t.width=tt,_t.height=St,_t.getContext("2d").drawImage(P,0,0,tt,St),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+W.width+"x"+W.height+") to ("+tt+"x"+St+")."),_t}else return"data"in P&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+W.width+"x"+W.height+")."),P;return P}function m(P){return P.generateMipmaps}function p(P){n.generateMipmap(P)}function E(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function w(P,y,Y,Z,W=!1){if(P!==null){if(n[P]!==void 0)return n[P];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let tt=y;if(y===n.RED&&(Y===n.FLOAT&&(tt=n.R32F),Y===n.HALF_FLOAT&&(tt=n.R16F),Y===n.UNSIGNED_BYTE&&(tt=n.R8)),y===n.RED_INTEGER&&(Y===n.UNSIGNED_BYTE&&(tt=n.R8UI),Y===n.UNSIGNED_SHORT&&(tt=n.R16UI),Y===n.UNSIGNED_INT&&(tt=n.R32UI),Y===n.BYTE&&(tt=n.R8I),Y===n.SHORT&&(tt=n.R16I),Y===n.INT&&(tt=n.R32I)),y===n.RG&&(Y===n.FLOAT&&(tt=n.RG32F),Y===n.HALF_FLOAT&&(tt=n.RG16F),Y===n.UNSIGNED_BYTE&&(tt=n.RG8)),y===n.RG_INTEGER&&(Y===n.UNSIGNED_BYTE&&(tt=n.RG8UI),Y===n.UNSIGNED_SHORT&&(tt=n.RG16UI),Y===n.UNSIGNED_INT&&(tt=n.RG32UI),Y===n.BYTE&&(tt=n.RG8I),Y===n.SHORT&&(tt=n.RG16I),Y===n.INT&&(tt=n.RG32I)),y===n.RGB_INTEGER&&(Y===n.UNSIGNED_BYTE&&(tt=n.RGB8UI),Y===n.UNSIGNED_SHORT&&(tt=n.RGB16UI),Y===n.UNSIGNED_INT&&(tt=n.RGB32UI),Y===n.BYTE&&(tt=n.RGB8I),Y===n.SHORT&&(tt=n.RGB16I),Y===n.INT&&(tt=n.RGB32I)),y===n.RGBA_INTEGER&&(Y===n.UNSIGNED_BYTE&&(tt=n.RGBA8UI),Y===n.UNSIGNED_SHORT&&(tt=n.RGBA16UI),Y===n.UNSIGNED_INT&&(tt=n.RGBA32UI),Y===n.BYTE&&(tt=n.RGBA8I),Y===n.SHORT&&(tt=n.RGBA16I),Y===n.INT&&(tt=n.RGBA32I)),y===n.RGB&&Y===n.UNSIGNED_INT_5_9_9_9_REV&&(tt=n.RGB9_E5),y===n.RGBA){const St=W?Xa:pe.getTransfer(Z);Y===n.FLOAT&&(tt=n.RGBA32F),Y===n.HALF_FLOAT&&(tt=n.RGBA16F),Y===n.UNSIGNED_BYTE&&(tt=St===Ae?n.SRGB8_ALPHA8:n.RGBA8),Y===n.UNSIGNED_SHORT_4_4_4_4&&(tt=n.RGBA4),Y===n.UNSIGNED_SHORT_5_5_5_1&&(tt=n.RGB5_A1)}return(tt===n.R16F||tt===n.R32F||tt===n.RG16F||tt===n.RG32F||tt===n.RGBA16F||tt===n.RGBA32F)&&t.get("EXT_color_buffer_float"),tt}function M(P,y){let Y;return P?y===null||y===zs||y===Nr?Y=n.DEPTH24_STENCIL8:y===$i?Y=n.DEPTH32F_STENCIL8:y===xo&&(Y=n.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===zs||y===Nr?Y=n.DEPTH_COMPONENT24:y===$i?Y=n.DEPTH_COMPONENT32F:y===xo&&(Y=n.DEPTH_COMPONENT16),Y}function O(P,y){return m(P)===!0||P.isFramebufferTexture&&P.minFilter!==gi&&P.minFilter!==Pi?Math.log2(Math.max(y.width,y.height))+1:P.mipmaps!==void 0&&P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?y.mipmaps.length:1}function R(P){const y=P.target;y.removeEventListener("dispose",R),U(y),y.isVideoTexture&&u.delete(y)}function D(P){const y=P.target;y.removeEventListener("dispose",D),S(y)}function U(P){const y=i.get(P);if(y.__webglInit===void 0)return;const Y=P.source,Z=f.get(Y);if(Z){const W=Z[y.__cacheKey];W.usedTimes--,W.usedTimes===0&&T(P),Object.keys(Z).length===0&&f.delete(Y)}i.remove(P)}function T(P){const y=i.get(P);n.deleteTexture(y.__webglTexture);const Y=P.source,Z=f.get(Y);delete Z[y.__cacheKey],o.memory.textures--}function S(P){const y=i.get(P);if(P.depthTexture&&(P.depthTexture.dispose(),i.remove(P.depthTexture)),P.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(y.__webglFramebuffer[Z]))for(let W=0;W<y.__webglFramebuffer[Z].length;W++)n.deleteFramebuffer(y.__webglFramebuffer[Z][W]);else n.deleteFramebuffer(y.__webglFramebuffer[Z]);y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer[Z])}else{if(Array.isArray(y.__webglFramebuffer))for(let Z=0;Z<y.__webglFramebuffer.length;Z++)n.deleteFramebuffer(y.__webglFramebuffer[Z]);else n.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&n.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&n.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let Z=0;Z<y.__webglColorRenderbuffer.length;Z++)y.__webglColorRenderbuffer[Z]&&n.deleteRenderbuffer(y.__webglColorRenderbuffer[Z]);y.__webglDepthRenderbuffer&&n.deleteRenderbuffer(y.__webglDepthRenderbuffer)}const Y=P.textures;for(let Z=0,W=Y.length;Z<W;Z++){const tt=i.get(Y[Z]);tt.__webglTexture&&(n.deleteTexture(tt.__webglTexture),o.memory.textures--),i.remove(Y[Z])}i.remove(P)}let C=0;function V(){C=0}function I(){const P=C;return P>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+P+" texture units while this GPU supports only "+s.maxTextures),C+=1,P}function G(P){const y=[];return y.push(P.wrapS),y.push(P.wrapT),y.push(P.wrapR||0),y.push(P.magFilter),y.push(P.minFilter),y.push(P.anisotropy),y.push(P.internalFormat),y.push(P.format),y.push(P.type),y.push(P.generateMipmaps),y.push(P.premultiplyAlpha),y.push(P.flipY),y.push(P.unpackAlignment),y.push(P.colorSpace),y.join()}function j(P,y){const Y=i.get(P);if(P.isVideoTexture&&Vt(P),P.isRenderTargetTexture===!1&&P.version>0&&Y.__version!==P.version){const Z=P.image;if(Z===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(Z.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{nt(Y,P,y);return}}e.bindTexture(n.TEXTURE_2D,Y.__webglTexture,n.TEXTURE0+y)}function K(P,y){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){nt(Y,P,y);return}e.bindTexture(n.TEXTURE_2D_ARRAY,Y.__webglTexture,n.TEXTURE0+y)}function J(P,y){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){nt(Y,P,y);return}e.bindTexture(n.TEXTURE_3D,Y.__webglTexture,n.TEXTURE0+y)}function Q(P,y){const Y=i.get(P);if(P.version>0&&Y.__version!==P.version){at(Y,P,y);return}e.bindTexture(n.TEXTURE_CUBE_MAP,Y.__webglTexture,n.TEXTURE0+y)}const ht={[xc]:n.REPEAT,[Fs]:n.CLAMP_TO_EDGE,[Mc]:n.MIRRORED_REPEAT},ct={[gi]:n.NEAREST,[P0]:n.NEAREST_MIPMAP_NEAREST,[Bo]:n.NEAREST_MIPMAP_LINEAR,[Pi]:n.LINEAR,[ml]:n.LINEAR_MIPMAP_NEAREST,[Os]:n.LINEAR_MIPMAP_LINEAR},mt={[I0]:n.NEVER,[z0]:n.ALWAYS,[N0]:n.LESS,[wp]:n.LEQUAL,[F0]:n.EQUAL,[B0]:n.GEQUAL,[O0]:n.GREATER,[k0]:n.NOTEQUAL};function Mt(P,y){if(y.type===$i&&t.has("OES_texture_float_linear")===!1&&(y.magFilter===Pi||y.magFilter===ml||y.magFilter===Bo||y.magFilter===Os||y.minFilter===Pi||y.minFilter===ml||y.minFilter===Bo||y.minFilter===Os)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,ht[y.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,ht[y.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,ht[y.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,ct[y.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,ct[y.minFilter]),y.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,mt[y.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===gi||y.minFilter!==Bo&&y.minFilter!==Os||y.type===$i&&t.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||i.get(y).__currentAnisotropy){const Y=t.get("EXT_texture_filter_anisotropic");n.texParameterf(P,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),i.get(y).__currentAnisotropy=y.anisotropy}}}function pt(P,y){let Y=!1;P.__webglInit===void 0&&(P.__webglInit=!0,y.addEventListener("dispose",R));const Z=y.source;let W=f.get(Z);W===void 0&&(W={},f.set(Z,W));const tt=G(y);if(tt!==P.__cacheKey){W[tt]===void 0&&(W[tt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),W[tt].usedTimes++;const St=W[P.__cacheKey];St!==void 0&&(W[P.__cacheKey].usedTimes--,St.usedTimes===0&&T(y)),P.__cacheKey=tt,P.__webglTexture=W[tt].texture}return Y}function nt(P,y,Y){let Z=n.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(Z=n.TEXTURE_2D_ARRAY),y.isData3DTexture&&(Z=n.TEXTURE_3D);const W=pt(P,y),tt=y.source;e.bindTexture(Z,P.__webglTexture,n.TEXTURE0+Y);const St=i.get(tt);if(tt.version!==St.__version||W===!0){e.activeTexture(n.TEXTURE0+Y);const _t=pe.getPrimaries(pe.workingColorSpace),Tt=y.colorSpace===hs?null:pe.getPrimaries(y.colorSpace),Yt=y.colorSpace===hs||_t===Tt?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Yt);let ft=v(y.image,!1,s.maxTextureSize);ft=he(y,ft);const vt=r.convert(y.format,y.colorSpace),Nt=r.convert(y.type);let Ot=w(y.internalFormat,vt,Nt,y.colorSpace,y.isVideoTexture);Mt(Z,y);let Et;const ne=y.mipmaps,$t=y.isVideoTexture!==!0,fe=St.__version===void 0||W===!0,k=tt.dataReady,xt=O(y,ft);if(y.isDepthTexture)Ot=M(y.format===Fr,y.type),fe&&($t?e.texStorage2D(n.TEXTURE_2D,1,Ot,ft.width,ft.height):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,null));else if(y.isDataTexture)if(ne.length>0){$t&&fe&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ne[0].width,ne[0].height);for(let et=0,st=ne.length;et<st;et++)Et=ne[et],$t?k&&e.texSubImage2D(n.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(n.TEXTURE_2D,et,Ot,Et.width,Et.height,0,vt,Nt,Et.data);y.generateMipmaps=!1}else $t?(fe&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height),k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ft.width,ft.height,vt,Nt,ft.data)):e.texImage2D(n.TEXTURE_2D,0,Ot,ft.width,ft.height,0,vt,Nt,ft.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){$t&&fe&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,ne[0].width,ne[0].height,ft.depth);for(let et=0,st=ne.length;et<st;et++)if(Et=ne[et],y.format!==pi)if(vt!==null)if($t){if(k)if(y.layerUpdates.size>0){const wt=Yf(Et.width,Et.height,y.format,y.type);for(const At of y.layerUpdates){const Zt=Et.data.subarray(At*wt/Et.data.BYTES_PER_ELEMENT,(At+1)*wt/Et.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,et,0,0,At,Et.width,Et.height,1,vt,Zt)}y.clearLayerUpdates()}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,et,0,0,0,Et.width,Et.height,ft.depth,vt,Et.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,et,Ot,Et.width,Et.height,ft.depth,0,Et.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else $t?k&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,et,0,0,0,Et.width,Et.height,ft.depth,vt,Nt,Et.data):e.texImage3D(n.TEXTURE_2D_ARRAY,et,Ot,Et.width,Et.height,ft.depth,0,vt,Nt,Et.data)}else{$t&&fe&&e.texStorage2D(n.TEXTURE_2D,xt,Ot,ne[0].width,ne[0].height);for(let et=0,st=ne.length;et<st;et++)Et=ne[et],y.format!==pi?vt!==null?$t?k&&e.compressedTexSubImage2D(n.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Et.data):e.compressedTexImage2D(n.TEXTURE_2D,et,Ot,Et.width,Et.height,0,Et.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):$t?k&&e.texSubImage2D(n.TEXTURE_2D,et,0,0,Et.width,Et.height,vt,Nt,Et.data):e.texImage2D(n.TEXTURE_2D,et,Ot,Et.width,Et.height,0,vt,Nt,Et.data)}else if(y.isDataArrayTexture)if($t){if(fe&&e.texStorage3D(n.TEXTURE_2D_ARRAY,xt,Ot,ft.width,ft.height,ft.depth),k)if(y.layerUpdates.size>0){const et=Yf(ft.width,ft.height,y.format,y.type);for(const st of y.layerUpdates){const wt=ft.data.subarray(st*et/ft.data.BYTES_PER_ELEMENT,(st+1)*et/ft.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,st,ft.width,ft.height,1,vt,Nt,wt)}y.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(y.isData3DTexture)$t?(fe&&e.texStorage3D(n.TEXTURE_3D,xt,Ot,ft.width,ft.height,ft.depth),k&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ft.width,ft.height,ft.depth,vt,Nt,ft.data)):e.texImage3D(n.TEXTURE_3D,0,Ot,ft.width,ft.height,ft.depth,0,vt,Nt,ft.data);else if(y.isFramebufferTexture){if(fe)if($t)e.texStorage2D(n.TEXTURE_2D,xt,Ot,ft.width,ft.height);else{let et=ft.width,st=ft.height;for(let wt=0;wt<xt;wt++)e.texImage2D(n.TEXTURE_2D,wt,Ot,et,st,0,vt,Nt,null),et>>=1,st>>=1}}else if(ne.length>0){if($t&&fe){const et=Pt(ne[0]);e.texStorage2D(n.TEXTURE_2D,xt,Ot,et.width,et.height)}for(let et=0,st=ne.length;et<st;et++)Et=ne[et],$t?k&&e.texSubImage2D(n.TEXTURE_2D,et,0,0,vt,Nt,Et):e.texImage2D(n.TEXTURE_2D,et,Ot,vt,Nt,Et);y.generateMipmaps=!1}else if($t){if(fe){const et=Pt(ft);e.texStorage2D(n.TEXTURE_2D,xt,Ot,et.width,et.height)}k&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,vt,Nt,ft)}else e.texImage2D(n.TEXTURE_2D,0,Ot,vt,Nt,ft);m(y)&&p(Z),St.__version=tt.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function at(P,y,Y){if(y.image.length!==6)return;const Z=pt(P,y),W=y.source;e.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+Y);const tt=i.get(W);if(W.version!==tt.__version||Z===!0){e.activeTexture(n.TEXTURE0+Y);const St=pe.getPrimaries(pe.workingColorSpace),_t=y.colorSpace===hs?null:pe.getPrimaries(y.colorSpace),Tt=y.colorSpace===hs||St===_t?n.NONE:n.BROWSER_DEFAULT_WEBGL;n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,y.flipY),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),n.pixelStorei(n.UNPACK_ALIGNMENT,y.unpackAlignment),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Tt);const Yt=y.isCompressedTexture||y.image[0].isCompressedTexture,ft=y.image[0]&&y.image[0].isDataTexture,vt=[];for(let st=0;st<6;st++)!Yt&&!ft?vt[st]=v(y.image[st],!0,s.maxCubemapSize):vt[st]=ft?y.image[st].image:y.image[st],vt[st]=he(y,vt[st]);const Nt=vt[0],Ot=r.convert(y.format,y.colorSpace),Et=r.convert(y.type),ne=w(y.internalFormat,Ot,Et,y.colorSpace),$t=y.isVideoTexture!==!0,fe=tt.__version===void 0||Z===!0,k=W.dataReady;let xt=O(y,Nt);Mt(n.TEXTURE_CUBE_MAP,y);let et;if(Yt){$t&&fe&&e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,ne,Nt.width,Nt.height);for(let st=0;st<6;st++){et=vt[st].mipmaps;for(let wt=0;wt<et.length;wt++){const At=et[wt];y.format!==pi?Ot!==null?$t?k&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt,0,0,At.width,At.height,Ot,At.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt,ne,At.width,At.height,0,At.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$t?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt,0,0,At.width,At.height,Ot,Et,At.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt,ne,At.width,At.height,0,Ot,Et,At.data)}}}else{if(et=y.mipmaps,$t&&fe){et.length>0&&xt++;const st=Pt(vt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,xt,ne,st.width,st.height)}for(let st=0;st<6;st++)if(ft){$t?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,vt[st].width,vt[st].height,Ot,Et,vt[st].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,ne,vt[st].width,vt[st].height,0,Ot,Et,vt[st].data);for(let wt=0;wt<et.length;wt++){const Zt=et[wt].image[st].image;$t?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt+1,0,0,Zt.width,Zt.height,Ot,Et,Zt.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt+1,ne,Zt.width,Zt.height,0,Ot,Et,Zt.data)}}else{$t?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,Ot,Et,vt[st]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,ne,Ot,Et,vt[st]);for(let wt=0;wt<et.length;wt++){const At=et[wt];$t?k&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt+1,0,0,Ot,Et,At.image[st]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+st,wt+1,ne,Ot,Et,At.image[st])}}}m(y)&&p(n.TEXTURE_CUBE_MAP),tt.__version=W.version,y.onUpdate&&y.onUpdate(y)}P.__version=y.version}function gt(P,y,Y,Z,W,tt){const St=r.convert(Y.format,Y.colorSpace),_t=r.convert(Y.type),Tt=w(Y.internalFormat,St,_t,Y.colorSpace),Yt=i.get(y),ft=i.get(Y);if(ft.__renderTarget=y,!Yt.__hasExternalTextures){const vt=Math.max(1,y.width>>tt),Nt=Math.max(1,y.height>>tt);W===n.TEXTURE_3D||W===n.TEXTURE_2D_ARRAY?e.texImage3D(W,tt,Tt,vt,Nt,y.depth,0,St,_t,null):e.texImage2D(W,tt,Tt,vt,Nt,0,St,_t,null)}e.bindFramebuffer(n.FRAMEBUFFER,P),te(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,Z,W,ft.__webglTexture,0,Jt(y)):(W===n.TEXTURE_2D||W>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&W<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,Z,W,ft.__webglTexture,tt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function rt(P,y,Y){if(n.bindRenderbuffer(n.RENDERBUFFER,P),y.depthBuffer){const Z=y.depthTexture,W=Z&&Z.isDepthTexture?Z.type:null,tt=M(y.stencilBuffer,W),St=y.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_t=Jt(y);te(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,_t,tt,y.width,y.height):Y?n.renderbufferStorageMultisample(n.RENDERBUFFER,_t,tt,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,tt,y.width,y.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,St,n.RENDERBUFFER,P)}else{const Z=y.textures;for(let W=0;W<Z.length;W++){const tt=Z[W],St=r.convert(tt.format,tt.colorSpace),_t=r.convert(tt.type),Tt=w(tt.internalFormat,St,_t,tt.colorSpace),Yt=Jt(y);Y&&te(y)===!1?n.renderbufferStorageMultisample(n.RENDERBUFFER,Yt,Tt,y.width,y.height):te(y)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,Yt,Tt,y.width,y.height):n.renderbufferStorage(n.RENDERBUFFER,Tt,y.width,y.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Bt(P,y){if(y&&y.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(n.FRAMEBUFFER,P),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const Z=i.get(y.depthTexture);Z.__renderTarget=y,(!Z.__webglTexture||y.depthTexture.image.width!==y.width||y.depthTexture.image.height!==y.height)&&(y.depthTexture.image.width=y.width,y.depthTexture.image.height=y.height,y.depthTexture.needsUpdate=!0),j(y.depthTexture,0);const W=Z.__webglTexture,tt=Jt(y);if(y.depthTexture.format===br)te(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0,tt):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_ATTACHMENT,n.TEXTURE_2D,W,0);else if(y.depthTexture.format===Fr)te(y)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0,tt):n.framebufferTexture2D(n.FRAMEBUFFER,n.DEPTH_STENCIL_ATTACHMENT,n.TEXTURE_2D,W,0);else throw new Error("Unknown depthTexture format")}function Ht(P){const y=i.get(P),Y=P.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==P.depthTexture){const Z=P.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),Z){const W=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,Z.removeEventListener("dispose",W)};Z.addEventListener("dispose",W),y.__depthDisposeCallback=W}y.__boundDepthTexture=Z}if(P.depthTexture&&!y.__autoAllocateDepthBuffer){if(Y)throw new Error("target.depthTexture not supported in Cube render targets");Bt(y.__webglFramebuffer,P)}else if(Y){y.__webglDepthbuffer=[];for(let Z=0;Z<6;Z++)if(e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer[Z]),y.__webglDepthbuffer[Z]===void 0)y.__webglDepthbuffer[Z]=n.createRenderbuffer(),rt(y.__webglDepthbuffer[Z],P,!1);else{const W=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,tt=y.__webglDepthbuffer[Z];n.bindRenderbuffer(n.RENDERBUFFER,tt),n.framebufferRenderbuffer(n.FRAMEBUFFER,W,n.RENDERBUFFER,tt)}}else if(e.bindFramebuffer(n.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=n.createRenderbuffer(),rt(y.__webglDepthbuffer,P,!1);else{const Z=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,W=y.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,W),n.framebufferRenderbuffer(n.FRAMEBUFFER,Z,n.RENDERBUFFER,W)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function It(P,y,Y){const Z=i.get(P);y!==void 0&&gt(Z.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),Y!==void 0&&Ht(P)}function le(P){const y=P.texture,Y=i.get(P),Z=i.get(y);P.addEventListener("dispose",D);const W=P.textures,tt=P.isWebGLCubeRenderTarget===!0,St=W.length>1;if(St||(Z.__webglTexture===void 0&&(Z.__webglTexture=n.createTexture()),Z.__version=y.version,o.memory.textures++),tt){Y.__webglFramebuffer=[];for(let _t=0;_t<6;_t++)if(y.mipmaps&&y.mipmaps.length>0){Y.__webglFramebuffer[_t]=[];for(let Tt=0;Tt<y.mipmaps.length;Tt++)Y.__webglFramebuffer[_t][Tt]=n.createFramebuffer()}else Y.__webglFramebuffer[_t]=n.createFramebuffer()}else{if(y.mipmaps&&y.mipmaps.length>0){Y.__webglFramebuffer=[];for(let _t=0;_t<y.mipmaps.length;_t++)Y.__webglFramebuffer[_t]=n.createFramebuffer()}else Y.__webglFramebuffer=n.createFramebuffer();if(St)for(let _t=0,Tt=W.length;_t<Tt;_t++){const Yt=i.get(W[_t]);Yt.__webglTexture===void 0&&(Yt.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&te(P)===!1){Y.__webglMultisampledFramebuffer=n.createFramebuffer(),Y.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let _t=0;_t<W.length;_t++){const Tt=W[_t];Y.__webglColorRenderbuffer[_t]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,Y.__webglColorRenderbuffer[_t]);const Yt=r.convert(Tt.format,Tt.colorSpace),ft=r.convert(Tt.type),vt=w(Tt.internalFormat,Yt,ft,Tt.colorSpace,P.isXRRenderTarget===!0),Nt=Jt(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,Nt,vt,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+_t,n.RENDERBUFFER,Y.__webglColorRenderbuffer[_t])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(Y.__webglDepthRenderbuffer=n.createRenderbuffer(),rt(Y.__webglDepthRenderbuffer,P,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(tt){e.bindTexture(n.TEXTURE_CUBE_MAP,Z.__webglTexture),Mt(n.TEXTURE_CUBE_MAP,y);for(let _t=0;_t<6;_t++)if(y.mipmaps&&y.mipmaps.length>0)for(let Tt=0;Tt<y.mipmaps.length;Tt++)gt(Y.__webglFramebuffer[_t][Tt],P,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,Tt);else gt(Y.__webglFramebuffer[_t],P,y,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0);m(y)&&p(n.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(St){for(let _t=0,Tt=W.length;_t<Tt;_t++){const Yt=W[_t],ft=i.get(Yt);e.bindTexture(n.TEXTURE_2D,ft.__webglTexture),Mt(n.TEXTURE_2D,Yt),gt(Y.__webglFramebuffer,P,Yt,n.COLOR_ATTACHMENT0+_t,n.TEXTURE_2D,0),m(Yt)&&p(n.TEXTURE_2D)}e.unbindTexture()}else{let _t=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(_t=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(_t,Z.__webglTexture),Mt(_t,y),y.mipmaps&&y.mipmaps.length>0)for(let Tt=0;Tt<y.mipmaps.length;Tt++)gt(Y.__webglFramebuffer[Tt],P,y,n.COLOR_ATTACHMENT0,_t,Tt);else gt(Y.__webglFramebuffer,P,y,n.COLOR_ATTACHMENT0,_t,0);m(y)&&p(_t),e.unbindTexture()}P.depthBuffer&&Ht(P)}function jt(P){const y=P.textures;for(let Y=0,Z=y.length;Y<Z;Y++){const W=y[Y];if(m(W)){const tt=E(P),St=i.get(W).__webglTexture;e.bindTexture(tt,St),p(tt),e.unbindTexture()}}}const ce=[],B=[];function je(P){if(P.samples>0){if(te(P)===!1){const y=P.textures,Y=P.width,Z=P.height;let W=n.COLOR_BUFFER_BIT;const tt=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,St=i.get(P),_t=y.length>1;if(_t)for(let Tt=0;Tt<y.length;Tt++)e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,St.__webglMultisampledFramebuffer),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglFramebuffer);for(let Tt=0;Tt<y.length;Tt++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(W|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(W|=n.STENCIL_BUFFER_BIT)),_t){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const Yt=i.get(y[Tt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,Yt,0)}n.blitFramebuffer(0,0,Y,Z,0,0,Y,Z,W,n.NEAREST),l===!0&&(ce.length=0,B.length=0,ce.push(n.COLOR_ATTACHMENT0+Tt),P.depthBuffer&&P.resolveDepthBuffer===!1&&(ce.push(tt),B.push(tt),n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,B)),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,ce))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),_t)for(let Tt=0;Tt<y.length;Tt++){e.bindFramebuffer(n.FRAMEBUFFER,St.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.RENDERBUFFER,St.__webglColorRenderbuffer[Tt]);const Yt=i.get(y[Tt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,St.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+Tt,n.TEXTURE_2D,Yt,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,St.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.resolveDepthBuffer===!1&&l){const y=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[y])}}}function Jt(P){return Math.min(s.maxSamples,P.samples)}function te(P){const y=i.get(P);return P.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Vt(P){const y=o.render.frame;u.get(P)!==y&&(u.set(P,y),P.update())}function he(P,y){const Y=P.colorSpace,Z=P.format,W=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||Y!==Xs&&Y!==hs&&(pe.getTransfer(Y)===Ae?(Z!==pi||W!==Ji)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",Y)),y}function Pt(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=I,this.resetTextureUnits=V,this.setTexture2D=j,this.setTexture2DArray=K,this.setTexture3D=J,this.setTextureCube=Q,this.rebindTextures=It,this.setupRenderTarget=le,this.updateRenderTargetMipmap=jt,this.updateMultisampleRenderTarget=je,this.setupDepthRenderbuffer=Ht,this.setupFrameBufferTexture=gt,this.useMultisampledRTT=te}function Wy(n,t){function e(i,s=hs){let r;const o=pe.getTransfer(s);if(i===Ji)return n.UNSIGNED_BYTE;if(i===Au)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ru)return n.UNSIGNED_SHORT_5_5_5_1;if(i===_p)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===mp)return n.BYTE;if(i===gp)return n.SHORT;if(i===xo)return n.UNSIGNED_SHORT;if(i===wu)return n.INT;if(i===zs)return n.UNSIGNED_INT;if(i===$i)return n.FLOAT;if(i===Eo)return n.HALF_FLOAT;if(i===vp)return n.ALPHA;if(i===xp)return n.RGB;if(i===pi)return n.RGBA;if(i===Mp)return n.LUMINANCE;if(i===Sp)return n.LUMINANCE_ALPHA;if(i===br)return n.DEPTH_COMPONENT;if(i===Fr)return n.DEPTH_STENCIL;if(i===yp)return n.RED;if(i===Cu)return n.RED_INTEGER;if(i===Ep)return n.RG;if(i===Pu)return n.RG_INTEGER;if(i===Lu)return n.RGBA_INTEGER;if(i===_a||i===va||i===xa||i===Ma)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===_a)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===_a)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===xa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ma)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Sc||i===yc||i===Ec||i===bc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Sc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===yc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ec)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===bc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Tc||i===wc||i===Ac)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Tc||i===wc)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ac)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(i===Rc||i===Cc||i===Pc||i===Lc||i===Dc||i===Uc||i===Ic||i===Nc||i===Fc||i===Oc||i===kc||i===Bc||i===zc||i===Hc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Rc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Cc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Pc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Lc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Dc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Uc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Ic)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Fc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Oc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===kc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===zc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Hc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Sa||i===Vc||i===Gc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Sa)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Vc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Gc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===bp||i===Wc||i===Xc||i===$c)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Sa)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Wc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Xc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===$c)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Nr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}class Xy extends Wn{constructor(t=[]){super(),this.isArrayCamera=!0,this.cameras=t}}class Li extends en{constructor(){super(),this.isGroup=!0,this.type="Group"}}const $y={type:"move"};class Gl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Li,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Li,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Li,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,i),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent($y)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const i=new Li;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}}const qy=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Yy=`
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

}`;class Ky{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e,i){if(this.texture===null){const s=new In,r=t.properties.get(s);r.__webglTexture=e.texture,(e.depthNear!=i.depthNear||e.depthFar!=i.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=s}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,i=new gs({vertexShader:qy,fragmentShader:Yy,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Mn(new $a(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class jy extends Hr{constructor(t,e){super();const i=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null;const v=new Ky,m=e.getContextAttributes();let p=null,E=null;const w=[],M=[],O=new ae;let R=null;const D=new Wn;D.viewport=new We;const U=new Wn;U.viewport=new We;const T=[D,U],S=new Xy;let C=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(nt){let at=w[nt];return at===void 0&&(at=new Gl,w[nt]=at),at.getTargetRaySpace()},this.getControllerGrip=function(nt){let at=w[nt];return at===void 0&&(at=new Gl,w[nt]=at),at.getGripSpace()},this.getHand=function(nt){let at=w[nt];return at===void 0&&(at=new Gl,w[nt]=at),at.getHandSpace()};function I(nt){const at=M.indexOf(nt.inputSource);if(at===-1)return;const gt=w[at];gt!==void 0&&(gt.update(nt.inputSource,nt.frame,c||o),gt.dispatchEvent({type:nt.type,data:nt.inputSource}))}function G(){s.removeEventListener("select",I),s.removeEventListener("selectstart",I),s.removeEventListener("selectend",I),s.removeEventListener("squeeze",I),s.removeEventListener("squeezestart",I),s.removeEventListener("squeezeend",I),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",j);for(let nt=0;nt<w.length;nt++){const at=M[nt];at!==null&&(M[nt]=null,w[nt].disconnect(at))}C=null,V=null,v.reset(),t.setRenderTarget(p),d=null,f=null,h=null,s=null,E=null,pt.stop(),i.isPresenting=!1,t.setPixelRatio(R),t.setSize(O.width,O.height,!1),i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(nt){r=nt,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(nt){a=nt,i.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(nt){c=nt},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(nt){if(s=nt,s!==null){if(p=t.getRenderTarget(),s.addEventListener("select",I),s.addEventListener("selectstart",I),s.addEventListener("selectend",I),s.addEventListener("squeeze",I),s.addEventListener("squeezestart",I),s.addEventListener("squeezeend",I),s.addEventListener("end",G),s.addEventListener("inputsourceschange",j),m.xrCompatible!==!0&&await e.makeXRCompatible(),R=t.getPixelRatio(),t.getSize(O),s.renderState.layers===void 0){const at={antialias:m.antialias,alpha:!0,depth:m.depth,stencil:m.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,at),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),E=new Hs(d.framebufferWidth,d.framebufferHeight,{format:pi,type:Ji,colorSpace:t.outputColorSpace,stencilBuffer:m.stencil})}else{let at=null,gt=null,rt=null;m.depth&&(rt=m.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,at=m.stencil?Fr:br,gt=m.stencil?Nr:zs);const Bt={colorFormat:e.RGBA8,depthFormat:rt,scaleFactor:r};h=new XRWebGLBinding(s,e),f=h.createProjectionLayer(Bt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),E=new Hs(f.textureWidth,f.textureHeight,{format:pi,type:Ji,depthTexture:new kp(f.textureWidth,f.textureHeight,gt,void 0,void 0,void 0,void 0,void 0,void 0,at),stencilBuffer:m.stencil,colorSpace:t.outputColorSpace,samples:m.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1})}E.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),pt.setContext(s),pt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function j(nt){for(let at=0;at<nt.removed.length;at++){const gt=nt.removed[at],rt=M.indexOf(gt);rt>=0&&(M[rt]=null,w[rt].disconnect(gt))}for(let at=0;at<nt.added.length;at++){const gt=nt.added[at];let rt=M.indexOf(gt);if(rt===-1){for(let Ht=0;Ht<w.length;Ht++)if(Ht>=M.length){M.push(gt),rt=Ht;break}else if(M[Ht]===null){M[Ht]=gt,rt=Ht;break}if(rt===-1)break}const Bt=w[rt];Bt&&Bt.connect(gt)}}const K=new z,J=new z;function Q(nt,at,gt){K.setFromMatrixPosition(at.matrixWorld),J.setFromMatrixPosition(gt.matrixWorld);const rt=K.distanceTo(J),Bt=at.projectionMatrix.elements,Ht=gt.projectionMatrix.elements,It=Bt[14]/(Bt[10]-1),le=Bt[14]/(Bt[10]+1),jt=(Bt[9]+1)/Bt[5],ce=(Bt[9]-1)/Bt[5],B=(Bt[8]-1)/Bt[0],je=(Ht[8]+1)/Ht[0],Jt=It*B,te=It*je,Vt=rt/(-B+je),he=Vt*-B;if(at.matrixWorld.decompose(nt.position,nt.quaternion,nt.scale),nt.translateX(he),nt.translateZ(Vt),nt.matrixWorld.compose(nt.position,nt.quaternion,nt.scale),nt.matrixWorldInverse.copy(nt.matrixWorld).invert(),Bt[10]===-1)nt.projectionMatrix.copy(at.projectionMatrix),nt.projectionMatrixInverse.copy(at.projectionMatrixInverse);else{const Pt=It+Vt,P=le+Vt,y=Jt-he,Y=te+(rt-he),Z=jt*le/P*Pt,W=ce*le/P*Pt;nt.projectionMatrix.makePerspective(y,Y,Z,W,Pt,P),nt.projectionMatrixInverse.copy(nt.projectionMatrix).invert()}}function ht(nt,at){at===null?nt.matrixWorld.copy(nt.matrix):nt.matrixWorld.multiplyMatrices(at.matrixWorld,nt.matrix),nt.matrixWorldInverse.copy(nt.matrixWorld).invert()}this.updateCamera=function(nt){if(s===null)return;let at=nt.near,gt=nt.far;v.texture!==null&&(v.depthNear>0&&(at=v.depthNear),v.depthFar>0&&(gt=v.depthFar)),S.near=U.near=D.near=at,S.far=U.far=D.far=gt,(C!==S.near||V!==S.far)&&(s.updateRenderState({depthNear:S.near,depthFar:S.far}),C=S.near,V=S.far),D.layers.mask=nt.layers.mask|2,U.layers.mask=nt.layers.mask|4,S.layers.mask=D.layers.mask|U.layers.mask;const rt=nt.parent,Bt=S.cameras;ht(S,rt);for(let Ht=0;Ht<Bt.length;Ht++)ht(Bt[Ht],rt);Bt.length===2?Q(S,D,U):S.projectionMatrix.copy(D.projectionMatrix),ct(nt,S,rt)};function ct(nt,at,gt){gt===null?nt.matrix.copy(at.matrixWorld):(nt.matrix.copy(gt.matrixWorld),nt.matrix.invert(),nt.matrix.multiply(at.matrixWorld)),nt.matrix.decompose(nt.position,nt.quaternion,nt.scale),nt.updateMatrixWorld(!0),nt.projectionMatrix.copy(at.projectionMatrix),nt.projectionMatrixInverse.copy(at.projectionMatrixInverse),nt.isPerspectiveCamera&&(nt.fov=qc*2*Math.atan(1/nt.projectionMatrix.elements[5]),nt.zoom=1)}this.getCamera=function(){return S},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(nt){l=nt,f!==null&&(f.fixedFoveation=nt),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=nt)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(S)};let mt=null;function Mt(nt,at){if(u=at.getViewerPose(c||o),g=at,u!==null){const gt=u.views;d!==null&&(t.setRenderTargetFramebuffer(E,d.framebuffer),t.setRenderTarget(E));let rt=!1;gt.length!==S.cameras.length&&(S.cameras.length=0,rt=!0);for(let Ht=0;Ht<gt.length;Ht++){const It=gt[Ht];let le=null;if(d!==null)le=d.getViewport(It);else{const ce=h.getViewSubImage(f,It);le=ce.viewport,Ht===0&&(t.setRenderTargetTextures(E,ce.colorTexture,f.ignoreDepthValues?void 0:ce.depthStencilTexture),t.setRenderTarget(E))}let jt=T[Ht];jt===void 0&&(jt=new Wn,jt.layers.enable(Ht),jt.viewport=new We,T[Ht]=jt),jt.matrix.fromArray(It.transform.matrix),jt.matrix.decompose(jt.position,jt.quaternion,jt.scale),jt.projectionMatrix.fromArray(It.projectionMatrix),jt.projectionMatrixInverse.copy(jt.projectionMatrix).invert(),jt.viewport.set(le.x,le.y,le.width,le.height),Ht===0&&(S.matrix.copy(jt.matrix),S.matrix.decompose(S.position,S.quaternion,S.scale)),rt===!0&&S.cameras.push(jt)}const Bt=s.enabledFeatures;if(Bt&&Bt.includes("depth-sensing")){const Ht=h.getDepthInformation(gt[0]);Ht&&Ht.isValid&&Ht.texture&&v.init(t,Ht,s.renderState)}}for(let gt=0;gt<w.length;gt++){const rt=M[gt],Bt=w[gt];rt!==null&&Bt!==void 0&&Bt.update(rt,at,c||o)}mt&&mt(nt,at),at.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:at}),g=null}const pt=new Op;pt.setAnimationLoop(Mt),this.setAnimationLoop=function(nt){mt=nt},this.dispose=function(){}}}const Rs=new Ni,Zy=new ze;function Jy(n,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function i(m,p){p.color.getRGB(m.fogColor.value,Ip(n)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,E,w,M){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,M)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,E,w):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Un&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Un&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const E=t.get(p),w=E.envMap,M=E.envMapRotation;w&&(m.envMap.value=w,Rs.copy(M),Rs.x*=-1,Rs.y*=-1,Rs.z*=-1,w.isCubeTexture&&w.isRenderTargetTexture===!1&&(Rs.y*=-1,Rs.z*=-1),m.envMapRotation.value.setFromMatrix4(Zy.makeRotationFromEuler(Rs)),m.flipEnvMap.value=w.isCubeTexture&&w.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,E,w){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*E,m.scale.value=w*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,E){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Un&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=E.texture,m.transmissionSamplerSize.value.set(E.width,E.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const E=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(E.matrixWorld),m.nearDistance.value=E.shadow.camera.near,m.farDistance.value=E.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function Qy(n,t,e,i){let s={},r={},o=[];const a=n.getParameter(n.MAX_UNIFORM_BUFFER_BINDINGS);function l(E,w){const M=w.program;i.uniformBlockBinding(E,M)}function c(E,w){let M=s[E.id];M===void 0&&(g(E),M=u(E),s[E.id]=M,E.addEventListener("dispose",m));const O=w.program;i.updateUBOMapping(E,O);const R=t.render.frame;r[E.id]!==R&&(f(E),r[E.id]=R)}function u(E){const w=h();E.__bindingPointIndex=w;const M=n.createBuffer(),O=E.__size,R=E.usage;return n.bindBuffer(n.UNIFORM_BUFFER,M),n.bufferData(n.UNIFORM_BUFFER,O,R),n.bindBuffer(n.UNIFORM_BUFFER,null),n.bindBufferBase(n.UNIFORM_BUFFER,w,M),M}function h(){for(let E=0;E<a;E++)if(o.indexOf(E)===-1)return o.push(E),E;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(E){const w=s[E.id],M=E.uniforms,O=E.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let R=0,D=M.length;R<D;R++){const U=Array.isArray(M[R])?M[R]:[M[R]];for(let T=0,S=U.length;T<S;T++){const C=U[T];if(d(C,R,T,O)===!0){const V=C.__offset,I=Array.isArray(C.value)?C.value:[C.value];let G=0;for(let j=0;j<I.length;j++){const K=I[j],J=v(K);typeof K=="number"||typeof K=="boolean"?(C.__data[0]=K,n.bufferSubData(n.UNIFORM_BUFFER,V+G,C.__data)):K.isMatrix3?(C.__data[0]=K.elements[0],C.__data[1]=K.elements[1],C.__data[2]=K.elements[2],C.__data[3]=0,C.__data[4]=K.elements[3],C.__data[5]=K.elements[4],C.__data[6]=K.elements[5],C.__data[7]=0,C.__data[8]=K.elements[6],C.__data[9]=K.elements[7],C.__data[10]=K.elements[8],C.__data[11]=0):(K.toArray(C.__data,G),G+=J.storage/Float32Array.BYTES_PER_ELEMENT)}n.bufferSubData(n.UNIFORM_BUFFER,V,C.__data)}}}n.bindBuffer(n.UNIFORM_BUFFER,null)}function d(E,w,M,O){const R=E.value,D=w+"_"+M;if(O[D]===void 0)return typeof R=="number"||typeof R=="boolean"?O[D]=R:O[D]=R.clone(),!0;{const U=O[D];if(typeof R=="number"||typeof R=="boolean"){if(U!==R)return O[D]=R,!0}else if(U.equals(R)===!1)return U.copy(R),!0}return!1}function g(E){const w=E.uniforms;let M=0;const O=16;for(let D=0,U=w.length;D<U;D++){const T=Array.isArray(w[D])?w[D]:[w[D]];for(let S=0,C=T.length;S<C;S++){const V=T[S],I=Array.isArray(V.value)?V.value:[V.value];for(let G=0,j=I.length;G<j;G++){const K=I[G],J=v(K),Q=M%O,ht=Q%J.boundary,ct=Q+ht;M+=ht,ct!==0&&O-ct<J.storage&&(M+=O-ct),V.__data=new Float32Array(J.storage/Float32Array.BYTES_PER_ELEMENT),V.__offset=M,M+=J.storage}}}const R=M%O;return R>0&&(M+=O-R),E.__size=M,E.__cache={},this}function v(E){const w={boundary:0,storage:0};return typeof E=="number"||typeof E=="boolean"?(w.boundary=4,w.storage=4):E.isVector2?(w.boundary=8,w.storage=8):E.isVector3||E.isColor?(w.boundary=16,w.storage=12):E.isVector4?(w.boundary=16,w.storage=16):E.isMatrix3?(w.boundary=48,w.storage=48):E.isMatrix4?(w.boundary=64,w.storage=64):E.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",E),w}function m(E){const w=E.target;w.removeEventListener("dispose",m);const M=o.indexOf(w.__bindingPointIndex);o.splice(M,1),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function p(){for(const E in s)n.deleteBuffer(s[E]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class tE{constructor(t={}){const{canvas:e=V0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reverseDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=i.getContextAttributes().alpha}else d=o;const g=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const E=[],w=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this._outputColorSpace=ti,this.toneMapping=ds,this.toneMappingExposure=1;const M=this;let O=!1,R=0,D=0,U=null,T=-1,S=null;const C=new We,V=new We;let I=null;const G=new oe(0);let j=0,K=e.width,J=e.height,Q=1,ht=null,ct=null;const mt=new We(0,0,K,J),Mt=new We(0,0,K,J);let pt=!1;const nt=new Uu;let at=!1,gt=!1;const rt=new ze,Bt=new ze,Ht=new z,It=new We,le={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let jt=!1;function ce(){return U===null?Q:1}let B=i;function je(b,F){return e.getContext(b,F)}try{const b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${bu}`),e.addEventListener("webglcontextlost",st,!1),e.addEventListener("webglcontextrestored",wt,!1),e.addEventListener("webglcontextcreationerror",At,!1),B===null){const F="webgl2";if(B=je(F,b),B===null)throw je(F)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(b){throw console.error("THREE.WebGLRenderer: "+b.message),b}let Jt,te,Vt,he,Pt,P,y,Y,Z,W,tt,St,_t,Tt,Yt,ft,vt,Nt,Ot,Et,ne,$t,fe,k;function xt(){Jt=new rS(B),Jt.init(),$t=new Wy(B,Jt),te=new QM(B,Jt,t,$t),Vt=new Hy(B,Jt),te.reverseDepthBuffer&&f&&Vt.buffers.depth.setReversed(!0),he=new lS(B),Pt=new wy,P=new Gy(B,Jt,Vt,Pt,te,$t,he),y=new eS(M),Y=new sS(M),Z=new mv(B),fe=new ZM(B,Z),W=new oS(B,Z,he,fe),tt=new uS(B,W,Z,he),Ot=new cS(B,te,P),ft=new tS(Pt),St=new Ty(M,y,Y,Jt,te,fe,ft),_t=new Jy(M,Pt),Tt=new Ry,Yt=new Iy(Jt),Nt=new jM(M,y,Y,Vt,tt,d,l),vt=new By(M,tt,te),k=new Qy(B,he,te,Vt),Et=new JM(B,Jt,he),ne=new aS(B,Jt,he),he.programs=St.programs,M.capabilities=te,M.extensions=Jt,M.properties=Pt,M.renderLists=Tt,M.shadowMap=vt,M.state=Vt,M.info=he}xt();const et=new jy(M,B);this.xr=et,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){const b=Jt.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){const b=Jt.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return Q},this.setPixelRatio=function(b){b!==void 0&&(Q=b,this.setSize(K,J,!1))},this.getSize=function(b){return b.set(K,J)},this.setSize=function(b,F,X=!0){if(et.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}K=b,J=F,e.width=Math.floor(b*Q),e.height=Math.floor(F*Q),X===!0&&(e.style.width=b+"px",e.style.height=F+"px"),this.setViewport(0,0,b,F)},this.getDrawingBufferSize=function(b){return b.set(K*Q,J*Q).floor()},this.setDrawingBufferSize=function(b,F,X){K=b,J=F,Q=X,e.width=Math.floor(b*X),e.height=Math.floor(F*X),this.setViewport(0,0,b,F)},this.getCurrentViewport=function(b){return b.copy(C)},this.getViewport=function(b){return b.copy(mt)},this.setViewport=function(b,F,X,$){b.isVector4?mt.set(b.x,b.y,b.z,b.w):mt.set(b,F,X,$),Vt.viewport(C.copy(mt).multiplyScalar(Q).round())},this.getScissor=function(b){return b.copy(Mt)},this.setScissor=function(b,F,X,$){b.isVector4?Mt.set(b.x,b.y,b.z,b.w):Mt.set(b,F,X,$),Vt.scissor(V.copy(Mt).multiplyScalar(Q).round())},this.getScissorTest=function(){return pt},this.setScissorTest=function(b){Vt.setScissorTest(pt=b)},this.setOpaqueSort=function(b){ht=b},this.setTransparentSort=function(b){ct=b},this.getClearColor=function(b){return b.copy(Nt.getClearColor())},this.setClearColor=function(){Nt.setClearColor.apply(Nt,arguments)},this.getClearAlpha=function(){return Nt.getClearAlpha()},this.setClearAlpha=function(){Nt.setClearAlpha.apply(Nt,arguments)},this.clear=function(b=!0,F=!0,X=!0){let $=0;if(b){let H=!1;if(U!==null){const ut=U.texture.format;H=ut===Lu||ut===Pu||ut===Cu}if(H){const ut=U.texture.type,yt=ut===Ji||ut===zs||ut===xo||ut===Nr||ut===Au||ut===Ru,Ft=Nt.getClearColor(),Dt=Nt.getClearAlpha(),Gt=Ft.r,Xt=Ft.g,Ut=Ft.b;yt?(g[0]=Gt,g[1]=Xt,g[2]=Ut,g[3]=Dt,B.clearBufferuiv(B.COLOR,0,g)):(v[0]=Gt,v[1]=Xt,v[2]=Ut,v[3]=Dt,B.clearBufferiv(B.COLOR,0,v))}else $|=B.COLOR_BUFFER_BIT}F&&($|=B.DEPTH_BUFFER_BIT),X&&($|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),B.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",st,!1),e.removeEventListener("webglcontextrestored",wt,!1),e.removeEventListener("webglcontextcreationerror",At,!1),Tt.dispose(),Yt.dispose(),Pt.dispose(),y.dispose(),Y.dispose(),tt.dispose(),fe.dispose(),k.dispose(),St.dispose(),et.dispose(),et.removeEventListener("sessionstart",On),et.removeEventListener("sessionend",Fi),Cn.stop()};function st(b){b.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),O=!0}function wt(){console.log("THREE.WebGLRenderer: Context Restored."),O=!1;const b=he.autoReset,F=vt.enabled,X=vt.autoUpdate,$=vt.needsUpdate,H=vt.type;xt(),he.autoReset=b,vt.enabled=F,vt.autoUpdate=X,vt.needsUpdate=$,vt.type=H}function At(b){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function Zt(b){const F=b.target;F.removeEventListener("dispose",Zt),Oe(F)}function Oe(b){an(b),Pt.remove(b)}function an(b){const F=Pt.get(b).programs;F!==void 0&&(F.forEach(function(X){St.releaseProgram(X)}),b.isShaderMaterial&&St.releaseShaderCache(b))}this.renderBufferDirect=function(b,F,X,$,H,ut){F===null&&(F=le);const yt=H.isMesh&&H.matrixWorld.determinant()<0,Ft=Ka(b,F,X,$,H);Vt.setMaterial($,yt);let Dt=X.index,Gt=1;if($.wireframe===!0){if(Dt=W.getWireframeAttribute(X),Dt===void 0)return;Gt=2}const Xt=X.drawRange,Ut=X.attributes.position;let se=Xt.start*Gt,Se=(Xt.start+Xt.count)*Gt;ut!==null&&(se=Math.max(se,ut.start*Gt),Se=Math.min(Se,(ut.start+ut.count)*Gt)),Dt!==null?(se=Math.max(se,0),Se=Math.min(Se,Dt.count)):Ut!=null&&(se=Math.max(se,0),Se=Math.min(Se,Ut.count));const be=Se-se;if(be<0||be===1/0)return;fe.setup(H,$,Ft,X,Dt);let ln,ue=Et;if(Dt!==null&&(ln=Z.get(Dt),ue=ne,ue.setIndex(ln)),H.isMesh)$.wireframe===!0?(Vt.setLineWidth($.wireframeLinewidth*ce()),ue.setMode(B.LINES)):ue.setMode(B.TRIANGLES);else if(H.isLine){let kt=$.linewidth;kt===void 0&&(kt=1),Vt.setLineWidth(kt*ce()),H.isLineSegments?ue.setMode(B.LINES):H.isLineLoop?ue.setMode(B.LINE_LOOP):ue.setMode(B.LINE_STRIP)}else H.isPoints?ue.setMode(B.POINTS):H.isSprite&&ue.setMode(B.TRIANGLES);if(H.isBatchedMesh)if(H._multiDrawInstances!==null)ue.renderMultiDrawInstances(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount,H._multiDrawInstances);else if(Jt.get("WEBGL_multi_draw"))ue.renderMultiDraw(H._multiDrawStarts,H._multiDrawCounts,H._multiDrawCount);else{const kt=H._multiDrawStarts,ke=H._multiDrawCounts,de=H._multiDrawCount,Pn=Dt?Z.get(Dt).bytesPerElement:1,xi=Pt.get($).currentProgram.getUniforms();for(let _n=0;_n<de;_n++)xi.setValue(B,"_gl_DrawID",_n),ue.render(kt[_n]/Pn,ke[_n])}else if(H.isInstancedMesh)ue.renderInstances(se,be,H.count);else if(X.isInstancedBufferGeometry){const kt=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,ke=Math.min(X.instanceCount,kt);ue.renderInstances(se,be,ke)}else ue.render(se,be)};function ve(b,F,X){b.transparent===!0&&b.side===Ri&&b.forceSinglePass===!1?(b.side=Un,b.needsUpdate=!0,Ys(b,F,X),b.side=ms,b.needsUpdate=!0,Ys(b,F,X),b.side=Ri):Ys(b,F,X)}this.compile=function(b,F,X=null){X===null&&(X=b),p=Yt.get(X),p.init(F),w.push(p),X.traverseVisible(function(H){H.isLight&&H.layers.test(F.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),b!==X&&b.traverseVisible(function(H){H.isLight&&H.layers.test(F.layers)&&(p.pushLight(H),H.castShadow&&p.pushShadow(H))}),p.setupLights();const $=new Set;return b.traverse(function(H){if(!(H.isMesh||H.isPoints||H.isLine||H.isSprite))return;const ut=H.material;if(ut)if(Array.isArray(ut))for(let yt=0;yt<ut.length;yt++){const Ft=ut[yt];ve(Ft,X,H),$.add(Ft)}else ve(ut,X,H),$.add(ut)}),w.pop(),p=null,$},this.compileAsync=function(b,F,X=null){const $=this.compile(b,F,X);return new Promise(H=>{function ut(){if($.forEach(function(yt){Pt.get(yt).currentProgram.isReady()&&$.delete(yt)}),$.size===0){H(b);return}setTimeout(ut,10)}Jt.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let Ze=null;function Le(b){Ze&&Ze(b)}function On(){Cn.stop()}function Fi(){Cn.start()}const Cn=new Op;Cn.setAnimationLoop(Le),typeof self<"u"&&Cn.setContext(self),this.setAnimationLoop=function(b){Ze=b,et.setAnimationLoop(b),b===null?Cn.stop():Cn.start()},et.addEventListener("sessionstart",On),et.addEventListener("sessionend",Fi),this.render=function(b,F){if(F!==void 0&&F.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(O===!0)return;if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),F.parent===null&&F.matrixWorldAutoUpdate===!0&&F.updateMatrixWorld(),et.enabled===!0&&et.isPresenting===!0&&(et.cameraAutoUpdate===!0&&et.updateCamera(F),F=et.getCamera()),b.isScene===!0&&b.onBeforeRender(M,b,F,U),p=Yt.get(b,w.length),p.init(F),w.push(p),Bt.multiplyMatrices(F.projectionMatrix,F.matrixWorldInverse),nt.setFromProjectionMatrix(Bt),gt=this.localClippingEnabled,at=ft.init(this.clippingPlanes,gt),m=Tt.get(b,E.length),m.init(),E.push(m),et.enabled===!0&&et.isPresenting===!0){const ut=M.xr.getDepthSensingMesh();ut!==null&&gn(ut,F,-1/0,M.sortObjects)}gn(b,F,0,M.sortObjects),m.finish(),M.sortObjects===!0&&m.sort(ht,ct),jt=et.enabled===!1||et.isPresenting===!1||et.hasDepthSensing()===!1,jt&&Nt.addToRenderList(m,b),this.info.render.frame++,at===!0&&ft.beginShadows();const X=p.state.shadowsArray;vt.render(X,b,F),at===!0&&ft.endShadows(),this.info.autoReset===!0&&this.info.reset();const $=m.opaque,H=m.transmissive;if(p.setupLights(),F.isArrayCamera){const ut=F.cameras;if(H.length>0)for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];ki($,H,b,Dt)}jt&&Nt.render(b);for(let yt=0,Ft=ut.length;yt<Ft;yt++){const Dt=ut[yt];Oi(m,b,Dt,Dt.viewport)}}else H.length>0&&ki($,H,b,F),jt&&Nt.render(b),Oi(m,b,F);U!==null&&(P.updateMultisampleRenderTarget(U),P.updateRenderTargetMipmap(U)),b.isScene===!0&&b.onAfterRender(M,b,F),fe.resetDefaultState(),T=-1,S=null,w.pop(),w.length>0?(p=w[w.length-1],at===!0&&ft.setGlobalState(M.clippingPlanes,p.state.camera)):p=null,E.pop(),E.length>0?m=E[E.length-1]:m=null};function gn(b,F,X,$){if(b.visible===!1)return;if(b.layers.test(F.layers)){if(b.isGroup)X=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(F);else if(b.isLight)p.pushLight(b),b.castShadow&&p.pushShadow(b);else if(b.isSprite){if(!b.frustumCulled||nt.intersectsSprite(b)){$&&It.setFromMatrixPosition(b.matrixWorld).applyMatrix4(Bt);const yt=tt.update(b),Ft=b.material;Ft.visible&&m.push(b,yt,Ft,X,It.z,null)}}else if((b.isMesh||b.isLine||b.isPoints)&&(!b.frustumCulled||nt.intersectsObject(b))){const yt=tt.update(b),Ft=b.material;if($&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),It.copy(b.boundingSphere.center)):(yt.boundingSphere===null&&yt.computeBoundingSphere(),It.copy(yt.boundingSphere.center)),It.applyMatrix4(b.matrixWorld).applyMatrix4(Bt)),Array.isArray(Ft)){const Dt=yt.groups;for(let Gt=0,Xt=Dt.length;Gt<Xt;Gt++){const Ut=Dt[Gt],se=Ft[Ut.materialIndex];se&&se.visible&&m.push(b,yt,se,X,It.z,Ut)}}else Ft.visible&&m.push(b,yt,Ft,X,It.z,null)}}const ut=b.children;for(let yt=0,Ft=ut.length;yt<Ft;yt++)gn(ut[yt],F,X,$)}function Oi(b,F,X,$){const H=b.opaque,ut=b.transmissive,yt=b.transparent;p.setupLightsView(X),at===!0&&ft.setGlobalState(M.clippingPlanes,X),$&&Vt.viewport(C.copy($)),H.length>0&&_s(H,F,X),ut.length>0&&_s(ut,F,X),yt.length>0&&_s(yt,F,X),Vt.buffers.depth.setTest(!0),Vt.buffers.depth.setMask(!0),Vt.buffers.color.setMask(!0),Vt.setPolygonOffset(!1)}function ki(b,F,X,$){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[$.id]===void 0&&(p.state.transmissionRenderTarget[$.id]=new Hs(1,1,{generateMipmaps:!0,type:Jt.has("EXT_color_buffer_half_float")||Jt.has("EXT_color_buffer_float")?Eo:Ji,minFilter:Os,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:pe.workingColorSpace}));const ut=p.state.transmissionRenderTarget[$.id],yt=$.viewport||C;ut.setSize(yt.z,yt.w);const Ft=M.getRenderTarget();M.setRenderTarget(ut),M.getClearColor(G),j=M.getClearAlpha(),j<1&&M.setClearColor(16777215,.5),M.clear(),jt&&Nt.render(X);const Dt=M.toneMapping;M.toneMapping=ds;const Gt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),p.setupLightsView($),at===!0&&ft.setGlobalState(M.clippingPlanes,$),_s(b,X,$),P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut),Jt.has("WEBGL_multisampled_render_to_texture")===!1){let Xt=!1;for(let Ut=0,se=F.length;Ut<se;Ut++){const Se=F[Ut],be=Se.object,ln=Se.geometry,ue=Se.material,kt=Se.group;if(ue.side===Ri&&be.layers.test($.layers)){const ke=ue.side;ue.side=Un,ue.needsUpdate=!0,qr(be,X,$,ln,ue,kt),ue.side=ke,ue.needsUpdate=!0,Xt=!0}}Xt===!0&&(P.updateMultisampleRenderTarget(ut),P.updateRenderTargetMipmap(ut))}M.setRenderTarget(Ft),M.setClearColor(G,j),Gt!==void 0&&($.viewport=Gt),M.toneMapping=Dt}function _s(b,F,X){const $=F.isScene===!0?F.overrideMaterial:null;for(let H=0,ut=b.length;H<ut;H++){const yt=b[H],Ft=yt.object,Dt=yt.geometry,Gt=$===null?yt.material:$,Xt=yt.group;Ft.layers.test(X.layers)&&qr(Ft,F,X,Dt,Gt,Xt)}}function qr(b,F,X,$,H,ut){b.onBeforeRender(M,F,X,$,H,ut),b.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),H.onBeforeRender(M,F,X,$,b,ut),H.transparent===!0&&H.side===Ri&&H.forceSinglePass===!1?(H.side=Un,H.needsUpdate=!0,M.renderBufferDirect(X,F,$,H,b,ut),H.side=ms,H.needsUpdate=!0,M.renderBufferDirect(X,F,$,H,b,ut),H.side=Ri):M.renderBufferDirect(X,F,$,H,b,ut),b.onAfterRender(M,F,X,$,H,ut)}function Ys(b,F,X){F.isScene!==!0&&(F=le);const $=Pt.get(b),H=p.state.lights,ut=p.state.shadowsArray,yt=H.state.version,Ft=St.getParameters(b,H.state,ut,F,X),Dt=St.getProgramCacheKey(Ft);let Gt=$.programs;$.environment=b.isMeshStandardMaterial?F.environment:null,$.fog=F.fog,$.envMap=(b.isMeshStandardMaterial?Y:y).get(b.envMap||$.environment),$.envMapRotation=$.environment!==null&&b.envMap===null?F.environmentRotation:b.envMapRotation,Gt===void 0&&(b.addEventListener("dispose",Zt),Gt=new Map,$.programs=Gt);let Xt=Gt.get(Dt);if(Xt!==void 0){if($.currentProgram===Xt&&$.lightsStateVersion===yt)return vi(b,Ft),Xt}else Ft.uniforms=St.getUniforms(b),b.onBeforeCompile(Ft,M),Xt=St.acquireProgram(Ft,Dt),Gt.set(Dt,Xt),$.uniforms=Ft.uniforms;const Ut=$.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(Ut.clippingPlanes=ft.uniform),vi(b,Ft),$.needsLights=Ro(b),$.lightsStateVersion=yt,$.needsLights&&(Ut.ambientLightColor.value=H.state.ambient,Ut.lightProbe.value=H.state.probe,Ut.directionalLights.value=H.state.directional,Ut.directionalLightShadows.value=H.state.directionalShadow,Ut.spotLights.value=H.state.spot,Ut.spotLightShadows.value=H.state.spotShadow,Ut.rectAreaLights.value=H.state.rectArea,Ut.ltc_1.value=H.state.rectAreaLTC1,Ut.ltc_2.value=H.state.rectAreaLTC2,Ut.pointLights.value=H.state.point,Ut.pointLightShadows.value=H.state.pointShadow,Ut.hemisphereLights.value=H.state.hemi,Ut.directionalShadowMap.value=H.state.directionalShadowMap,Ut.directionalShadowMatrix.value=H.state.directionalShadowMatrix,Ut.spotShadowMap.value=H.state.spotShadowMap,Ut.spotLightMatrix.value=H.state.spotLightMatrix,Ut.spotLightMap.value=H.state.spotLightMap,Ut.pointShadowMap.value=H.state.pointShadowMap,Ut.pointShadowMatrix.value=H.state.pointShadowMatrix),$.currentProgram=Xt,$.uniformsList=null,Xt}function Ao(b){if(b.uniformsList===null){const F=b.currentProgram.getUniforms();b.uniformsList=Ea.seqWithValue(F.seq,b.uniforms)}return b.uniformsList}function vi(b,F){const X=Pt.get(b);X.outputColorSpace=F.outputColorSpace,X.batching=F.batching,X.batchingColor=F.batchingColor,X.instancing=F.instancing,X.instancingColor=F.instancingColor,X.instancingMorph=F.instancingMorph,X.skinning=F.skinning,X.morphTargets=F.morphTargets,X.morphNormals=F.morphNormals,X.morphColors=F.morphColors,X.morphTargetsCount=F.morphTargetsCount,X.numClippingPlanes=F.numClippingPlanes,X.numIntersection=F.numClipIntersection,X.vertexAlphas=F.vertexAlphas,X.vertexTangents=F.vertexTangents,X.toneMapping=F.toneMapping}function Ka(b,F,X,$,H){F.isScene!==!0&&(F=le),P.resetTextureUnits();const ut=F.fog,yt=$.isMeshStandardMaterial?F.environment:null,Ft=U===null?M.outputColorSpace:U.isXRRenderTarget===!0?U.texture.colorSpace:Xs,Dt=($.isMeshStandardMaterial?Y:y).get($.envMap||yt),Gt=$.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,Xt=!!X.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Ut=!!X.morphAttributes.position,se=!!X.morphAttributes.normal,Se=!!X.morphAttributes.color;let be=ds;$.toneMapped&&(U===null||U.isXRRenderTarget===!0)&&(be=M.toneMapping);const ln=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,ue=ln!==void 0?ln.length:0,kt=Pt.get($),ke=p.state.lights;if(at===!0&&(gt===!0||b!==S)){const yn=b===S&&$.id===T;ft.setState($,b,yn)}let de=!1;$.version===kt.__version?(kt.needsLights&&kt.lightsStateVersion!==ke.state.version||kt.outputColorSpace!==Ft||H.isBatchedMesh&&kt.batching===!1||!H.isBatchedMesh&&kt.batching===!0||H.isBatchedMesh&&kt.batchingColor===!0&&H.colorTexture===null||H.isBatchedMesh&&kt.batchingColor===!1&&H.colorTexture!==null||H.isInstancedMesh&&kt.instancing===!1||!H.isInstancedMesh&&kt.instancing===!0||H.isSkinnedMesh&&kt.skinning===!1||!H.isSkinnedMesh&&kt.skinning===!0||H.isInstancedMesh&&kt.instancingColor===!0&&H.instanceColor===null||H.isInstancedMesh&&kt.instancingColor===!1&&H.instanceColor!==null||H.isInstancedMesh&&kt.instancingMorph===!0&&H.morphTexture===null||H.isInstancedMesh&&kt.instancingMorph===!1&&H.morphTexture!==null||kt.envMap!==Dt||$.fog===!0&&kt.fog!==ut||kt.numClippingPlanes!==void 0&&(kt.numClippingPlanes!==ft.numPlanes||kt.numIntersection!==ft.numIntersection)||kt.vertexAlphas!==Gt||kt.vertexTangents!==Xt||kt.morphTargets!==Ut||kt.morphNormals!==se||kt.morphColors!==Se||kt.toneMapping!==be||kt.morphTargetsCount!==ue)&&(de=!0):(de=!0,kt.__version=$.version);let Pn=kt.currentProgram;de===!0&&(Pn=Ys($,F,H));let xi=!1,_n=!1,xs=!1;const Re=Pn.getUniforms(),qn=kt.uniforms;if(Vt.useProgram(Pn.program)&&(xi=!0,_n=!0,xs=!0),$.id!==T&&(T=$.id,_n=!0),xi||S!==b){Vt.buffers.depth.getReversed()?(rt.copy(b.projectionMatrix),W0(rt),X0(rt),Re.setValue(B,"projectionMatrix",rt)):Re.setValue(B,"projectionMatrix",b.projectionMatrix),Re.setValue(B,"viewMatrix",b.matrixWorldInverse);const Mi=Re.map.cameraPosition;Mi!==void 0&&Mi.setValue(B,Ht.setFromMatrixPosition(b.matrixWorld)),te.logarithmicDepthBuffer&&Re.setValue(B,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&Re.setValue(B,"isOrthographic",b.isOrthographicCamera===!0),S!==b&&(S=b,_n=!0,xs=!0)}if(H.isSkinnedMesh){Re.setOptional(B,H,"bindMatrix"),Re.setOptional(B,H,"bindMatrixInverse");const yn=H.skeleton;yn&&(yn.boneTexture===null&&yn.computeBoneTexture(),Re.setValue(B,"boneTexture",yn.boneTexture,P))}H.isBatchedMesh&&(Re.setOptional(B,H,"batchingTexture"),Re.setValue(B,"batchingTexture",H._matricesTexture,P),Re.setOptional(B,H,"batchingIdTexture"),Re.setValue(B,"batchingIdTexture",H._indirectTexture,P),Re.setOptional(B,H,"batchingColorTexture"),H._colorsTexture!==null&&Re.setValue(B,"batchingColorTexture",H._colorsTexture,P));const Qi=X.morphAttributes;if((Qi.position!==void 0||Qi.normal!==void 0||Qi.color!==void 0)&&Ot.update(H,X,Pn),(_n||kt.receiveShadow!==H.receiveShadow)&&(kt.receiveShadow=H.receiveShadow,Re.setValue(B,"receiveShadow",H.receiveShadow)),$.isMeshGouraudMaterial&&$.envMap!==null&&(qn.envMap.value=Dt,qn.flipEnvMap.value=Dt.isCubeTexture&&Dt.isRenderTargetTexture===!1?-1:1),$.isMeshStandardMaterial&&$.envMap===null&&F.environment!==null&&(qn.envMapIntensity.value=F.environmentIntensity),_n&&(Re.setValue(B,"toneMappingExposure",M.toneMappingExposure),kt.needsLights&&vs(qn,xs),ut&&$.fog===!0&&_t.refreshFogUniforms(qn,ut),_t.refreshMaterialUniforms(qn,$,Q,J,p.state.transmissionRenderTarget[b.id]),Ea.upload(B,Ao(kt),qn,P)),$.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Ea.upload(B,Ao(kt),qn,P),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&Re.setValue(B,"center",H.center),Re.setValue(B,"modelViewMatrix",H.modelViewMatrix),Re.setValue(B,"normalMatrix",H.normalMatrix),Re.setValue(B,"modelMatrix",H.matrixWorld),$.isShaderMaterial||$.isRawShaderMaterial){const yn=$.uniformsGroups;for(let Mi=0,ii=yn.length;Mi<ii;Mi++){const Ks=yn[Mi];k.update(Ks,Pn),k.bind(Ks,Pn)}}return Pn}function vs(b,F){b.ambientLightColor.needsUpdate=F,b.lightProbe.needsUpdate=F,b.directionalLights.needsUpdate=F,b.directionalLightShadows.needsUpdate=F,b.pointLights.needsUpdate=F,b.pointLightShadows.needsUpdate=F,b.spotLights.needsUpdate=F,b.spotLightShadows.needsUpdate=F,b.rectAreaLights.needsUpdate=F,b.hemisphereLights.needsUpdate=F}function Ro(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return R},this.getActiveMipmapLevel=function(){return D},this.getRenderTarget=function(){return U},this.setRenderTargetTextures=function(b,F,X){Pt.get(b.texture).__webglTexture=F,Pt.get(b.depthTexture).__webglTexture=X;const $=Pt.get(b);$.__hasExternalTextures=!0,$.__autoAllocateDepthBuffer=X===void 0,$.__autoAllocateDepthBuffer||Jt.has("WEBGL_multisampled_render_to_texture")===!0&&(console.warn("THREE.WebGLRenderer: Render-to-texture extension was disabled because an external texture was provided"),$.__useRenderToTexture=!1)},this.setRenderTargetFramebuffer=function(b,F){const X=Pt.get(b);X.__webglFramebuffer=F,X.__useDefaultFramebuffer=F===void 0},this.setRenderTarget=function(b,F=0,X=0){U=b,R=F,D=X;let $=!0,H=null,ut=!1,yt=!1;if(b){const Dt=Pt.get(b);if(Dt.__useDefaultFramebuffer!==void 0)Vt.bindFramebuffer(B.FRAMEBUFFER,null),$=!1;else if(Dt.__webglFramebuffer===void 0)P.setupRenderTarget(b);else if(Dt.__hasExternalTextures)P.rebindTextures(b,Pt.get(b.texture).__webglTexture,Pt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){const Ut=b.depthTexture;if(Dt.__boundDepthTexture!==Ut){if(Ut!==null&&Pt.has(Ut)&&(b.width!==Ut.image.width||b.height!==Ut.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");P.setupDepthRenderbuffer(b)}}const Gt=b.texture;(Gt.isData3DTexture||Gt.isDataArrayTexture||Gt.isCompressedArrayTexture)&&(yt=!0);const Xt=Pt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(Xt[F])?H=Xt[F][X]:H=Xt[F],ut=!0):b.samples>0&&P.useMultisampledRTT(b)===!1?H=Pt.get(b).__webglMultisampledFramebuffer:Array.isArray(Xt)?H=Xt[X]:H=Xt,C.copy(b.viewport),V.copy(b.scissor),I=b.scissorTest}else C.copy(mt).multiplyScalar(Q).floor(),V.copy(Mt).multiplyScalar(Q).floor(),I=pt;if(Vt.bindFramebuffer(B.FRAMEBUFFER,H)&&$&&Vt.drawBuffers(b,H),Vt.viewport(C),Vt.scissor(V),Vt.setScissorTest(I),ut){const Dt=Pt.get(b.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+F,Dt.__webglTexture,X)}else if(yt){const Dt=Pt.get(b.texture),Gt=F||0;B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,Dt.__webglTexture,X||0,Gt)}T=-1},this.readRenderTargetPixels=function(b,F,X,$,H,ut,yt){if(!(b&&b.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){Vt.bindFramebuffer(B.FRAMEBUFFER,Ft);try{const Dt=b.texture,Gt=Dt.format,Xt=Dt.type;if(!te.textureFormatReadable(Gt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!te.textureTypeReadable(Xt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}F>=0&&F<=b.width-$&&X>=0&&X<=b.height-H&&B.readPixels(F,X,$,H,$t.convert(Gt),$t.convert(Xt),ut)}finally{const Dt=U!==null?Pt.get(U).__webglFramebuffer:null;Vt.bindFramebuffer(B.FRAMEBUFFER,Dt)}}},this.readRenderTargetPixelsAsync=async function(b,F,X,$,H,ut,yt){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ft=Pt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&yt!==void 0&&(Ft=Ft[yt]),Ft){const Dt=b.texture,Gt=Dt.format,Xt=Dt.type;if(!te.textureFormatReadable(Gt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!te.textureTypeReadable(Xt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");if(F>=0&&F<=b.width-$&&X>=0&&X<=b.height-H){Vt.bindFramebuffer(B.FRAMEBUFFER,Ft);const Ut=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.bufferData(B.PIXEL_PACK_BUFFER,ut.byteLength,B.STREAM_READ),B.readPixels(F,X,$,H,$t.convert(Gt),$t.convert(Xt),0);const se=U!==null?Pt.get(U).__webglFramebuffer:null;Vt.bindFramebuffer(B.FRAMEBUFFER,se);const Se=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await G0(B,Se,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,Ut),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,ut),B.deleteBuffer(Ut),B.deleteSync(Se),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")}},this.copyFramebufferToTexture=function(b,F=null,X=0){b.isTexture!==!0&&(uo("WebGLRenderer: copyFramebufferToTexture function signature has changed."),F=arguments[0]||null,b=arguments[1]);const $=Math.pow(2,-X),H=Math.floor(b.image.width*$),ut=Math.floor(b.image.height*$),yt=F!==null?F.x:0,Ft=F!==null?F.y:0;P.setTexture2D(b,0),B.copyTexSubImage2D(B.TEXTURE_2D,X,0,0,yt,Ft,H,ut),Vt.unbindTexture()},this.copyTextureToTexture=function(b,F,X=null,$=null,H=0){b.isTexture!==!0&&(uo("WebGLRenderer: copyTextureToTexture function signature has changed."),$=arguments[0]||null,b=arguments[1],F=arguments[2],H=arguments[3]||0,X=null);let ut,yt,Ft,Dt,Gt,Xt,Ut,se,Se;const be=b.isCompressedTexture?b.mipmaps[H]:b.image;X!==null?(ut=X.max.x-X.min.x,yt=X.max.y-X.min.y,Ft=X.isBox3?X.max.z-X.min.z:1,Dt=X.min.x,Gt=X.min.y,Xt=X.isBox3?X.min.z:0):(ut=be.width,yt=be.height,Ft=be.depth||1,Dt=0,Gt=0,Xt=0),$!==null?(Ut=$.x,se=$.y,Se=$.z):(Ut=0,se=0,Se=0);const ln=$t.convert(F.format),ue=$t.convert(F.type);let kt;F.isData3DTexture?(P.setTexture3D(F,0),kt=B.TEXTURE_3D):F.isDataArrayTexture||F.isCompressedArrayTexture?(P.setTexture2DArray(F,0),kt=B.TEXTURE_2D_ARRAY):(P.setTexture2D(F,0),kt=B.TEXTURE_2D),B.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,F.flipY),B.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,F.premultiplyAlpha),B.pixelStorei(B.UNPACK_ALIGNMENT,F.unpackAlignment);const ke=B.getParameter(B.UNPACK_ROW_LENGTH),de=B.getParameter(B.UNPACK_IMAGE_HEIGHT),Pn=B.getParameter(B.UNPACK_SKIP_PIXELS),xi=B.getParameter(B.UNPACK_SKIP_ROWS),_n=B.getParameter(B.UNPACK_SKIP_IMAGES);B.pixelStorei(B.UNPACK_ROW_LENGTH,be.width),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,be.height),B.pixelStorei(B.UNPACK_SKIP_PIXELS,Dt),B.pixelStorei(B.UNPACK_SKIP_ROWS,Gt),B.pixelStorei(B.UNPACK_SKIP_IMAGES,Xt);const xs=b.isDataArrayTexture||b.isData3DTexture,Re=F.isDataArrayTexture||F.isData3DTexture;if(b.isRenderTargetTexture||b.isDepthTexture){const qn=Pt.get(b),Qi=Pt.get(F),yn=Pt.get(qn.__renderTarget),Mi=Pt.get(Qi.__renderTarget);Vt.bindFramebuffer(B.READ_FRAMEBUFFER,yn.__webglFramebuffer),Vt.bindFramebuffer(B.DRAW_FRAMEBUFFER,Mi.__webglFramebuffer);for(let ii=0;ii<Ft;ii++)xs&&B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(b).__webglTexture,H,Xt+ii),b.isDepthTexture?(Re&&B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Pt.get(F).__webglTexture,H,Se+ii),B.blitFramebuffer(Dt,Gt,ut,yt,Ut,se,ut,yt,B.DEPTH_BUFFER_BIT,B.NEAREST)):Re?B.copyTexSubImage3D(kt,H,Ut,se,Se+ii,Dt,Gt,ut,yt):B.copyTexSubImage2D(kt,H,Ut,se,Se+ii,Dt,Gt,ut,yt);Vt.bindFramebuffer(B.READ_FRAMEBUFFER,null),Vt.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Re?b.isDataTexture||b.isData3DTexture?B.texSubImage3D(kt,H,Ut,se,Se,ut,yt,Ft,ln,ue,be.data):F.isCompressedArrayTexture?B.compressedTexSubImage3D(kt,H,Ut,se,Se,ut,yt,Ft,ln,be.data):B.texSubImage3D(kt,H,Ut,se,Se,ut,yt,Ft,ln,ue,be):b.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,H,Ut,se,ut,yt,ln,ue,be.data):b.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,H,Ut,se,be.width,be.height,ln,be.data):B.texSubImage2D(B.TEXTURE_2D,H,Ut,se,ut,yt,ln,ue,be);B.pixelStorei(B.UNPACK_ROW_LENGTH,ke),B.pixelStorei(B.UNPACK_IMAGE_HEIGHT,de),B.pixelStorei(B.UNPACK_SKIP_PIXELS,Pn),B.pixelStorei(B.UNPACK_SKIP_ROWS,xi),B.pixelStorei(B.UNPACK_SKIP_IMAGES,_n),H===0&&F.generateMipmaps&&B.generateMipmap(kt),Vt.unbindTexture()},this.copyTextureToTexture3D=function(b,F,X=null,$=null,H=0){return b.isTexture!==!0&&(uo("WebGLRenderer: copyTextureToTexture3D function signature has changed."),X=arguments[0]||null,$=arguments[1]||null,b=arguments[2],F=arguments[3],H=arguments[4]||0),uo('WebGLRenderer: copyTextureToTexture3D function has been deprecated. Use "copyTextureToTexture" instead.'),this.copyTextureToTexture(b,F,X,$,H)},this.initRenderTarget=function(b){Pt.get(b).__webglFramebuffer===void 0&&P.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?P.setTextureCube(b,0):b.isData3DTexture?P.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?P.setTexture2DArray(b,0):P.setTexture2D(b,0),Vt.unbindTexture()},this.resetState=function(){R=0,D=0,U=null,Vt.reset(),fe.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return qi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorspace=pe._getDrawingBufferColorSpace(t),e.unpackColorSpace=pe._getUnpackColorSpace()}}let Kf=class extends en{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ni,this.environmentIntensity=1,this.environmentRotation=new Ni,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}};class wo extends qs{static get type(){return"LineBasicMaterial"}constructor(t){super(),this.isLineBasicMaterial=!0,this.color=new oe(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const Pa=new z,La=new z,jf=new ze,oo=new Du,oa=new To,Wl=new z,Zf=new z;class Gp extends en{constructor(t=new on,e=new wo){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Pa.fromBufferAttribute(e,s-1),La.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Pa.distanceTo(La);t.setAttribute("lineDistance",new Fe(i,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),oa.copy(i.boundingSphere),oa.applyMatrix4(s),oa.radius+=r,t.ray.intersectsSphere(oa)===!1)return;jf.copy(s).invert(),oo.copy(t.ray).applyMatrix4(jf);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){const d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=u.getX(v),E=u.getX(v+1),w=aa(this,t,oo,l,p,E);w&&e.push(w)}if(this.isLineLoop){const v=u.getX(g-1),m=u.getX(d),p=aa(this,t,oo,l,v,m);p&&e.push(p)}}else{const d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=aa(this,t,oo,l,v,v+1);p&&e.push(p)}if(this.isLineLoop){const v=aa(this,t,oo,l,g-1,d);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function aa(n,t,e,i,s,r){const o=n.geometry.attributes.position;if(Pa.fromBufferAttribute(o,s),La.fromBufferAttribute(o,r),e.distanceSqToSegment(Pa,La,Wl,Zf)>i)return;Wl.applyMatrix4(n.matrixWorld);const l=t.ray.origin.distanceTo(Wl);if(!(l<t.near||l>t.far))return{distance:l,point:Zf.clone().applyMatrix4(n.matrixWorld),index:s,face:null,faceIndex:null,barycoord:null,object:n}}const Jf=new z,Qf=new z;class Wp extends Gp{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Jf.fromBufferAttribute(e,s),Qf.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Jf.distanceTo(Qf);t.setAttribute("lineDistance",new Fe(i,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class Xp extends qs{static get type(){return"PointsMaterial"}constructor(t){super(),this.isPointsMaterial=!0,this.color=new oe(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const td=new ze,Kc=new Du,la=new To,ca=new z;class eE extends en{constructor(t=new on,e=new Xp){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const i=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),la.copy(i.boundingSphere),la.applyMatrix4(s),la.radius+=r,t.ray.intersectsSphere(la)===!1)return;td.copy(s).invert(),Kc.copy(t.ray).applyMatrix4(td);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,h=i.attributes.position;if(c!==null){const f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,v=d;g<v;g++){const m=c.getX(g);ca.fromBufferAttribute(h,m),ed(ca,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let g=f,v=d;g<v;g++)ca.fromBufferAttribute(h,g),ed(ca,g,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){const s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function ed(n,t,e,i,s,r,o){const a=Kc.distanceSqToPoint(n);if(a<e){const l=new z;Kc.closestPointToPoint(n,l),l.applyMatrix4(i);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class Fu extends on{constructor(t=[new ae(0,-.5),new ae(.5,0),new ae(0,.5)],e=12,i=0,s=Math.PI*2){super(),this.type="LatheGeometry",this.parameters={points:t,segments:e,phiStart:i,phiLength:s},e=Math.floor(e),s=An(s,0,Math.PI*2);const r=[],o=[],a=[],l=[],c=[],u=1/e,h=new z,f=new ae,d=new z,g=new z,v=new z;let m=0,p=0;for(let E=0;E<=t.length-1;E++)switch(E){case 0:m=t[E+1].x-t[E].x,p=t[E+1].y-t[E].y,d.x=p*1,d.y=-m,d.z=p*0,v.copy(d),d.normalize(),l.push(d.x,d.y,d.z);break;case t.length-1:l.push(v.x,v.y,v.z);break;default:m=t[E+1].x-t[E].x,p=t[E+1].y-t[E].y,d.x=p*1,d.y=-m,d.z=p*0,g.copy(d),d.x+=v.x,d.y+=v.y,d.z+=v.z,d.normalize(),l.push(d.x,d.y,d.z),v.copy(g)}for(let E=0;E<=e;E++){const w=i+E*u*s,M=Math.sin(w),O=Math.cos(w);for(let R=0;R<=t.length-1;R++){h.x=t[R].x*M,h.y=t[R].y,h.z=t[R].x*O,o.push(h.x,h.y,h.z),f.x=E/e,f.y=R/(t.length-1),a.push(f.x,f.y);const D=l[3*R+0]*M,U=l[3*R+1],T=l[3*R+0]*O;c.push(D,U,T)}}for(let E=0;E<e;E++)for(let w=0;w<t.length-1;w++){const M=w+E*t.length,O=M,R=M+t.length,D=M+t.length+1,U=M+1;r.push(O,R,U),r.push(D,U,R)}this.setIndex(r),this.setAttribute("position",new Fe(o,3)),this.setAttribute("uv",new Fe(a,2)),this.setAttribute("normal",new Fe(c,3))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Fu(t.points,t.segments,t.phiStart,t.phiLength)}}class Ou extends on{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};const c=this;s=Math.floor(s),r=Math.floor(r);const u=[],h=[],f=[],d=[];let g=0;const v=[],m=i/2;let p=0;E(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(u),this.setAttribute("position",new Fe(h,3)),this.setAttribute("normal",new Fe(f,3)),this.setAttribute("uv",new Fe(d,2));function E(){const M=new z,O=new z;let R=0;const D=(e-t)/i;for(let U=0;U<=r;U++){const T=[],S=U/r,C=S*(e-t)+t;for(let V=0;V<=s;V++){const I=V/s,G=I*l+a,j=Math.sin(G),K=Math.cos(G);O.x=C*j,O.y=-S*i+m,O.z=C*K,h.push(O.x,O.y,O.z),M.set(j,D,K).normalize(),f.push(M.x,M.y,M.z),d.push(I,1-S),T.push(g++)}v.push(T)}for(let U=0;U<s;U++)for(let T=0;T<r;T++){const S=v[T][U],C=v[T+1][U],V=v[T+1][U+1],I=v[T][U+1];(t>0||T!==0)&&(u.push(S,C,I),R+=3),(e>0||T!==r-1)&&(u.push(C,V,I),R+=3)}c.addGroup(p,R,0),p+=R}function w(M){const O=g,R=new ae,D=new z;let U=0;const T=M===!0?t:e,S=M===!0?1:-1;for(let V=1;V<=s;V++)h.push(0,m*S,0),f.push(0,S,0),d.push(.5,.5),g++;const C=g;for(let V=0;V<=s;V++){const G=V/s*l+a,j=Math.cos(G),K=Math.sin(G);D.x=T*K,D.y=m*S,D.z=T*j,h.push(D.x,D.y,D.z),f.push(0,S,0),R.x=j*.5+.5,R.y=K*.5*S+.5,d.push(R.x,R.y),g++}for(let V=0;V<s;V++){const I=O+V,G=C+V;M===!0?u.push(G,G+1,I):u.push(G+1,G,I),U+=3}c.addGroup(p,U,M===!0?1:2),p+=U}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Ou(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}}const ua=new z,ha=new z,Xl=new z,fa=new ei;class nE extends on{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){const s=Math.pow(10,4),r=Math.cos(ya*e),o=t.getIndex(),a=t.getAttribute("position"),l=o?o.count:a.count,c=[0,0,0],u=["a","b","c"],h=new Array(3),f={},d=[];for(let g=0;g<l;g+=3){o?(c[0]=o.getX(g),c[1]=o.getX(g+1),c[2]=o.getX(g+2)):(c[0]=g,c[1]=g+1,c[2]=g+2);const{a:v,b:m,c:p}=fa;if(v.fromBufferAttribute(a,c[0]),m.fromBufferAttribute(a,c[1]),p.fromBufferAttribute(a,c[2]),fa.getNormal(Xl),h[0]=`${Math.round(v.x*s)},${Math.round(v.y*s)},${Math.round(v.z*s)}`,h[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,h[2]=`${Math.round(p.x*s)},${Math.round(p.y*s)},${Math.round(p.z*s)}`,!(h[0]===h[1]||h[1]===h[2]||h[2]===h[0]))for(let E=0;E<3;E++){const w=(E+1)%3,M=h[E],O=h[w],R=fa[u[E]],D=fa[u[w]],U=`${M}_${O}`,T=`${O}_${M}`;T in f&&f[T]?(Xl.dot(f[T].normal)<=r&&(d.push(R.x,R.y,R.z),d.push(D.x,D.y,D.z)),f[T]=null):U in f||(f[U]={index0:c[E],index1:c[w],normal:Xl.clone()})}}for(const g in f)if(f[g]){const{index0:v,index1:m}=f[g];ua.fromBufferAttribute(a,v),ha.fromBufferAttribute(a,m),d.push(ua.x,ua.y,ua.z),d.push(ha.x,ha.y,ha.z)}this.setAttribute("position",new Fe(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}}class Ya extends on{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));const l=Math.min(o+a,Math.PI);let c=0;const u=[],h=new z,f=new z,d=[],g=[],v=[],m=[];for(let p=0;p<=i;p++){const E=[],w=p/i;let M=0;p===0&&o===0?M=.5/e:p===i&&l===Math.PI&&(M=-.5/e);for(let O=0;O<=e;O++){const R=O/e;h.x=-t*Math.cos(s+R*r)*Math.sin(o+w*a),h.y=t*Math.cos(o+w*a),h.z=t*Math.sin(s+R*r)*Math.sin(o+w*a),g.push(h.x,h.y,h.z),f.copy(h).normalize(),v.push(f.x,f.y,f.z),m.push(R+M,1-w),E.push(c++)}u.push(E)}for(let p=0;p<i;p++)for(let E=0;E<e;E++){const w=u[p][E+1],M=u[p][E],O=u[p+1][E],R=u[p+1][E+1];(p!==0||o>0)&&d.push(w,M,R),(p!==i-1||l<Math.PI)&&d.push(M,O,R)}this.setIndex(d),this.setAttribute("position",new Fe(g,3)),this.setAttribute("normal",new Fe(v,3)),this.setAttribute("uv",new Fe(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Ya(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}}class ku extends on{constructor(t=1,e=.4,i=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:i,tubularSegments:s,arc:r},i=Math.floor(i),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new z,h=new z,f=new z;for(let d=0;d<=i;d++)for(let g=0;g<=s;g++){const v=g/s*r,m=d/i*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(d/i)}for(let d=1;d<=i;d++)for(let g=1;g<=s;g++){const v=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,E=(s+1)*d+g;o.push(v,m,E),o.push(m,p,E)}this.setIndex(o),this.setAttribute("position",new Fe(a,3)),this.setAttribute("normal",new Fe(l,3)),this.setAttribute("uv",new Fe(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ku(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class iE extends qs{static get type(){return"MeshLambertMaterial"}constructor(t){super(),this.isMeshLambertMaterial=!0,this.color=new oe(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new oe(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Tp,this.normalScale=new ae(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ni,this.combine=Tu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}}class $p extends wo{static get type(){return"LineDashedMaterial"}constructor(t){super(),this.isLineDashedMaterial=!0,this.scale=1,this.dashSize=3,this.gapSize=1,this.setValues(t)}copy(t){return super.copy(t),this.scale=t.scale,this.dashSize=t.dashSize,this.gapSize=t.gapSize,this}}class qp extends en{constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new oe(t),this.intensity=e}dispose(){}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){const e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,this.groundColor!==void 0&&(e.object.groundColor=this.groundColor.getHex()),this.distance!==void 0&&(e.object.distance=this.distance),this.angle!==void 0&&(e.object.angle=this.angle),this.decay!==void 0&&(e.object.decay=this.decay),this.penumbra!==void 0&&(e.object.penumbra=this.penumbra),this.shadow!==void 0&&(e.object.shadow=this.shadow.toJSON()),this.target!==void 0&&(e.object.target=this.target.uuid),e}}class sE extends qp{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(en.DEFAULT_UP),this.updateMatrix(),this.groundColor=new oe(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}}const $l=new ze,nd=new z,id=new z;class rE{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ae(512,512),this.map=null,this.mapPass=null,this.matrix=new ze,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Uu,this._frameExtents=new ae(1,1),this._viewportCount=1,this._viewports=[new We(0,0,1,1)]}getViewportCount(){return this._viewportCount}getFrustum(){return this._frustum}updateMatrices(t){const e=this.camera,i=this.matrix;nd.setFromMatrixPosition(t.matrixWorld),e.position.copy(nd),id.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(id),e.updateMatrixWorld(),$l.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),this._frustum.setFromProjectionMatrix($l),i.set(.5,0,0,.5,0,.5,0,.5,0,0,.5,.5,0,0,0,1),i.multiply($l)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.mapSize.copy(t.mapSize),this}clone(){return new this.constructor().copy(this)}toJSON(){const t={};return this.intensity!==1&&(t.intensity=this.intensity),this.bias!==0&&(t.bias=this.bias),this.normalBias!==0&&(t.normalBias=this.normalBias),this.radius!==1&&(t.radius=this.radius),(this.mapSize.x!==512||this.mapSize.y!==512)&&(t.mapSize=this.mapSize.toArray()),t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}}class oE extends rE{constructor(){super(new Iu(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}}class aE extends qp{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(en.DEFAULT_UP),this.updateMatrix(),this.target=new en,this.shadow=new oE}dispose(){this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:bu}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=bu);function Da(n,t=!1){const e=n[0].index!==null,i=new Set(Object.keys(n[0].attributes)),s=new Set(Object.keys(n[0].morphAttributes)),r={},o={},a=n[0].morphTargetsRelative,l=new on;let c=0;for(let u=0;u<n.length;++u){const h=n[u];let f=0;if(e!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(const d in h.attributes){if(!i.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+d+'" attribute exists among all geometries, or in none of them.'),null;r[d]===void 0&&(r[d]=[]),r[d].push(h.attributes[d]),f++}if(f!==i.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(const d in h.morphAttributes){if(!s.has(d))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;o[d]===void 0&&(o[d]=[]),o[d].push(h.morphAttributes[d])}if(t){let d;if(e)d=h.index.count;else if(h.attributes.position!==void 0)d=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,d,u),c+=d}}if(e){let u=0;const h=[];for(let f=0;f<n.length;++f){const d=n[f].index;for(let g=0;g<d.count;++g)h.push(d.getX(g)+u);u+=n[f].attributes.position.count}l.setIndex(h)}for(const u in r){const h=sd(r[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(const u in o){const h=o[u][0].length;if(h===0)break;l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let f=0;f<h;++f){const d=[];for(let v=0;v<o[u].length;++v)d.push(o[u][v][f]);const g=sd(d);if(!g)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(g)}}return l}function sd(n){let t,e,i,s=-1,r=0;for(let c=0;c<n.length;++c){const u=n[c];if(t===void 0&&(t=u.array.constructor),t!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(e===void 0&&(e=u.itemSize),e!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(i===void 0&&(i=u.normalized),i!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*e}const o=new t(r),a=new Nn(o,e,i);let l=0;for(let c=0;c<n.length;++c){const u=n[c];if(u.isInterleavedBufferAttribute){const h=l/e;for(let f=0,d=u.count;f<d;f++)for(let g=0;g<e;g++){const v=u.getComponent(f,g);a.setComponent(f+h,g,v)}}else o.set(u.array,l);l+=u.count*e}return s!==void 0&&(a.gpuType=s),a}const lE={...Te,limit:"#6f8aa5"},Vs=n=>lE[n],Yp={x:new z(1,0,0),y:new z(0,1,0),z:new z(0,0,1)},Ii=n=>Ua?Math.ceil(n/2):n,cE=n=>new z(...Mo[n]),Kp=(n,t)=>new $s().setFromUnitVectors(Yp[n],cE(t));function ql(n,{colour:t,centre_m:e,along:i},s){n.deleteAttribute("uv");const r=new oe(t),o=new Float32Array(n.attributes.position.count*3);for(let a=0;a<o.length;a+=3)r.toArray(o,a);return n.setAttribute("color",new Nn(o,3)),i&&n.applyQuaternion(Kp(s,i)),n.translate(...e)}const uE={box:n=>ql(new Wr(...n.size_m),n),cylinder:n=>ql(new Ou(n.radius_m,n.other_radius_m??n.radius_m,n.length_m,Ii(32)),n,"y"),torus:n=>ql(new ku(n.radius_m,n.thickness_m,Ii(8),Ii(72)),n,"z")},jc=n=>n.map(t=>uE[t.kind](t));function hE(n){const t=new Li,e=n.role==="predicted"||n.role==="truth";t.inner=e?dE(n):fE(n),t.add(t.inner);const{min:i,max:s}=new Vr().setFromObject(t.inner);return t.reach="xyz".split("").map(r=>Math.max(-i[r],s[r])),t}function fE({shape:n}){const t=new Li,e=n.filter(s=>s.lit),i=n.filter(s=>!s.lit);return e.length&&(t.lit=new iE({vertexColors:!0}),t.add(new Mn(Da(jc(e)),t.lit))),i.length&&t.add(new Mn(Da(jc(i)),new Gr({vertexColors:!0}))),t}function dE({role:n,shape:t}){const e=jc(t),i=Vs(n),s=new Mn(Da(e),new Gr({color:i,transparent:!0,opacity:.16,depthWrite:!1}));return s.add(new Wp(Da(e.map(r=>new nE(r,40))),new wo({color:i,transparent:!0,opacity:.75}))),s}function Zc(n,t){const e=Ii(64);return Array.from({length:e+1},(i,s)=>{const r=s/e*2*Math.PI;return new z(n,t*Math.cos(r),t*Math.sin(r))})}function rd(n,t,e){return Array.from({length:e},(i,s)=>{const r=s/e*2*Math.PI;return n.map((o,a)=>new z(o,t[a]*Math.cos(r),t[a]*Math.sin(r)))})}function Jc(n,t){const[e,i]=[[],[]];for(const r of n){let o=0;for(let a=1;a<r.length;a+=1)e.push(r[a-1],r[a]),i.push(o,o+=r[a].distanceTo(r[a-1]))}const s=new on().setFromPoints(e);return s.setAttribute("lineDistance",new Fe(i,1)),new Wp(s,t)}const Bu=(n,t)=>new Gr({color:Vs(n),transparent:!0,opacity:t,side:Ri,forceSinglePass:!0,depthWrite:!1}),Qc=(n,t)=>new wo({color:Vs(n),transparent:!0,opacity:t});function pE(n){const{stations_m:t,radii_m:e}=n,i=new Li;if(n.skin){const a=new Mn(new Fu(t.map((l,c)=>new ae(e[c],l)),Ii(48)),Bu(n.role,.05));a.rotation.z=-Math.PI/2,i.add(a)}const s=[...rd(t,e,n.meridians),...n.rings.map(([a,l])=>Zc(a,l))],r=[...rd(t,e,n.faint_meridians),...n.faint_rings.map(([a,l])=>Zc(a,l))];n.axis&&r.push([t[0],t[t.length-1]].map(a=>new z(a,0,0)));const o=()=>new $p({color:Vs(n.role),dashSize:.35,gapSize:.22,transparent:!0,opacity:.85});return s.length&&i.add(Jc(s,n.dashed?o():Qc(n.role,.8))),r.length&&i.add(Jc(r,Qc(n.role,.38))),i.quaternion.copy(Kp("x",n.along)),i.position.set(...n.origin_m),i}function mE({role:n,radius_m:t}){const e=new Li,i=([r,o,a])=>[new z(r,o,a),new z(o,r,a),new z(a,o,r)],s=Zc(0,t).map(r=>i(r.toArray()));return e.add(new Mn(new Ya(t,Ii(32),Ii(20)),Bu(n,.1)),Jc([0,1,2].map(r=>s.map(o=>o[r])),Qc(n,.7))),e}const gE=n=>n.kind==="sphere"?mE(n):pE(n);function _E(){const n=[];let t=7;const e=()=>(t=t*16807%2147483647,t/2147483647);for(let s=0;s<Ii(1400);s+=1){const r=2*e()-1,o=2*Math.PI*e(),a=Math.sqrt(1-r*r);n.push(900*a*Math.cos(o),900*r,900*a*Math.sin(o))}const i=new on;return i.setAttribute("position",new Fe(n,3)),new eE(i,new Xp({color:9413562,size:1.3,sizeAttenuation:!1,transparent:!0,opacity:.7}))}function vE({direction:n,half_angle_rad:t,colour:e}){const i=new z(...n).normalize(),s=Math.PI/2-t,r=new Ya(500*Math.sin(t),Ii(96),Ii(16),0,2*Math.PI,0,1.05*s);r.applyQuaternion(new $s().setFromUnitVectors(Yp.y,i.clone().negate()));const o=r.attributes.position,a=new oe().setStyle(e,Xs),l=[],c=new z;for(let h=0;h<o.count;h+=1){c.fromBufferAttribute(o,h).normalize();const f=Math.sin(23*c.x+5*Math.sin(17*c.z))*Math.sin(19*c.z+4*Math.sin(13*c.x)),g=Math.max(.15,c.x*-.35+c.y*.75+c.z*.35)*(.124+.024*f);l.push(g*a.r,g*a.g,g*a.b)}r.setAttribute("color",new Fe(l,3));const u=new Mn(r,new Gr({vertexColors:!0}));return u.position.copy(i).multiplyScalar(500),u}function xE(n){const t=new Li;n.stars&&t.add(_E());for(const e of n.sky)t.add(vE(e));return t}class ME{constructor(t,e=24,i=10){this.stations=e,this.sides=i,this.places=new Float32Array(e*i*3);const s=[];for(let o=0;o<e-1;o+=1)for(let a=0;a<i;a+=1){const l=o*i+a,c=o*i+(a+1)%i;s.push(l,c,l+i,c,c+i,l+i)}const r=new on;r.setAttribute("position",new Nn(this.places,3)),r.setIndex(s),this.mesh=new Mn(r,Bu(t,.22)),this.mesh.frustumCulled=!1,this.mesh.visible=!1}set({rows:t,at:e,n:i}){if(this.mesh.visible=i>1,!!this.mesh.visible){for(let s=0;s<this.stations;s+=1){const r=s/(this.stations-1)*(i-1),o=Math.min(Math.floor(r),i-2),a=r-o,l=u=>t[o][e+u]+(t[o+1][e+u]-t[o][e+u])*a,c=l(3);for(let u=0;u<this.sides;u+=1){const h=u/this.sides*2*Math.PI,f=(s*this.sides+u)*3;this.places[f]=l(0),this.places[f+1]=l(1)+c*Math.cos(h),this.places[f+2]=l(2)+c*Math.sin(h)}}this.mesh.geometry.attributes.position.needsUpdate=!0}}}class SE{constructor(t,e,i){this.most=e,this.places=new Float32Array(e*3);const s=new on;s.setAttribute("position",new Nn(this.places,3));const r=i?new $p({color:Vs(t),dashSize:.25,gapSize:.2}):new wo({color:Vs(t)});this.dashed=i,this.line=new Gp(s,r),this.line.frustumCulled=!1,this.line.visible=!1}set({rows:t,at:e,n:i}){const s=i>0?t[i-1]:null;if(t===this.rows&&i===this.count&&s===this.last)return;Object.assign(this,{rows:t,count:i,last:s});const r=Math.max(1,Math.ceil(i/this.most));let o=0;for(let a=0;a<i&&o<this.most;a+=r,o+=1){const l=t[a];this.places[o*3]=l[e],this.places[o*3+1]=l[e+1],this.places[o*3+2]=l[e+2]}this.line.geometry.setDrawRange(0,o),this.line.geometry.attributes.position.needsUpdate=!0,this.dashed&&this.line.computeLineDistances(),this.line.visible=o>1}}const da=1,yE=22e5,[EE,bE,od]=[60,38,.35],Yl=Ua?.5:1,TE=1e3,ad=24,wE=64,[AE,RE]=[860723,3159354],pa=n=>new z(...Mo[n]);class CE{constructor(t,e,i,s){this.elements={view:e,camera:i,labels:s},this.canvas=t,this.renderer=new tE({canvas:t,antialias:!Ua,alpha:!1,powerPreference:"high-performance",preserveDrawingBuffer:!0}),this.renderer.autoClear=!1,this.scene=new Kf,this.scene.add(new sE(14674431,2763306,.9));const r=new aE(16777215,2.3);r.position.set(-6,9,5),this.scene.add(r),this.far=new Kf,this.perspective=new Wn(32,1,.1,2e3),this.ortho=new Iu(-1,1,1,-1,-100,200),this.onboard=new Wn(20,1,.02,2e3);for(const a of[this.perspective,this.ortho])a.layers.enable(da);Object.assign(this,{display:null,world:null,items:new Map,bodies:[],eyes:[],chosen:0}),Object.assign(this,{enabled:!0,drawn:0,quality:Yl,adaptive:!0,pace:33,since:0}),this.marks=new Map,this.follow(e),this.resize();const o=new ResizeObserver(()=>this.resize());for(const a of[e,i])o.observe(a);addEventListener("resize",()=>this.resize())}adapt(t){if(!this.adaptive)return;this.pace=this.pace*.8+Math.min(t,400)*.2,this.since+=1;const e=this.pace>EE&&this.quality>od,i=this.pace<bE&&this.quality<Yl;this.since<(i?150:6)||!(e||i)||(this.quality=Math.max(od,Math.min(Yl,this.quality*(e?.7:1.25))),this.since=0,this.resize())}setDisplay(t){for(const e of[this.world,...this.far.children])PE(e);this.far.clear(),this.far.add(xE(t)),this.world=new Li,this.scene.add(this.world),this.items.clear(),this.bodies=t.bodies.map(e=>this.add(e,hE(e),!Array.isArray(e.place))),this.moving=this.bodies.filter(({moves:e})=>e);for(const e of t.surfaces){const i=this.add(e,gE(e),e.kind==="sphere"&&!Array.isArray(e.place));i.moves?this.moving.push(i):e.kind==="sphere"&&i.object.position.set(...e.place)}this.lines=t.lines.map(e=>this.addLine(e)),this.eyes=t.views.map(e=>({azimuth:e.azimuth_rad,height:e.height_rad,zoom:1,focus:e.kind==="perspective"?new z(...ld(e,null)):null})),(this.display===null||this.chosen>=t.views.length)&&(this.chosen=0),this.display=t,this.frame=null,this.shot=[]}add(t,e,i){const s={item:t,object:e,moves:i};return i?(e.visible=!1,e.traverse(r=>r.layers.set(da))):t.kind==="body"&&e.position.set(...t.place),this.items.set(t.name,e),this.world.add(e),s}addLine(t){const e=Array.isArray(t.points),i=e?t.points.length:t.kind==="line"?wE:t.since?ad+3:TE,s=new SE(t.role,i,t.dashed);e?s.set({rows:t.points,at:0,n:i}):s.line.layers.set(da),this.items.set(t.name,s.line),this.world.add(s.line);const r=t.spread?new ME(t.role):null;return r&&(r.mesh.layers.set(da),this.world.add(r.mesh)),{line:t,path:s,tube:r,stands:e}}place(t,e,i,s){this.frame=t;for(const{item:r,object:o}of this.moving){const a=Ui(t,r.place,r.axes);o.visible=!!a,a&&o.position.set(...a);const l=a&&r.attitude?wr(t,r.attitude):void 0;l&&o.inner.quaternion.set(...l),r.role==="measured"&&o.inner?.lit&&o.inner.lit.emissive.setHex(s?RE:AE)}for(const{line:r,path:o,tube:a,stands:l}of this.lines)if(!l)if(r.kind==="line"){const c=wr(t,r.points)||[];o.set({rows:c,at:0,n:c.length})}else{const c=Rm(r,e?.trails.get(r.name)||[],t,i,ad);o.set(c),a?.set(c)}}known(t){for(const e of t){const{item:i}=this.bodies.find(r=>r.item.name===e),s=Ui(this.frame,i.place,i.axes);if(s)return{item:i,at:s}}return null}resize(){const t=[this.elements.view,this.elements.camera].map(u=>u.getBoundingClientRect()),e=t.filter(u=>u.width>0),i=Math.min(...e.map(u=>u.left)),s=Math.min(...e.map(u=>u.top)),r=Math.max(...e.map(u=>u.right))-i,o=Math.max(...e.map(u=>u.bottom))-s,a=u=>({left:u.left-i,bottom:s+o-u.bottom,width:u.width,height:u.height});this.places={view:a(t[0]),camera:a(t[1])};const{canvas:l}=this;Object.assign(l.style,{left:`${i}px`,top:`${s}px`,width:`${r}px`,height:`${o}px`});const c=Math.min(devicePixelRatio||1,Math.sqrt(yE/Math.max(r*o,1)));this.renderer.setPixelRatio(c*this.quality),this.renderer.setSize(r,o,!1),this.renderer.setScissorTest(!1),this.renderer.setClearColor(527378,1),this.renderer.clear(),this.renderer.setScissorTest(!0),this.shot=[],this.tall=parseFloat(getComputedStyle(this.elements.labels).fontSize)}follow(t){let e=null;t.addEventListener("pointerdown",i=>{i.target.closest("button")||(e=[i.clientX,i.clientY],t.setPointerCapture(i.pointerId))}),t.addEventListener("pointermove",i=>{e&&(this.turn((i.clientX-e[0])*.005,(i.clientY-e[1])*.005),e=[i.clientX,i.clientY])}),t.addEventListener("pointerup",()=>{e=null}),t.addEventListener("wheel",i=>{i.preventDefault(),this.zoom(Math.exp(i.deltaY*.001))},{passive:!1})}turn(t,e){const i=this.eyes[this.chosen];i?.focus&&(i.azimuth+=t,i.height=Math.max(-1.4,Math.min(1.4,i.height+e)))}zoom(t){const e=this.eyes[this.chosen];e&&(e.zoom=Math.max(.15,Math.min(4,e.zoom*t)))}draw(){if(!this.enabled||!this.display)return;this.drawn+=1;const{view:t,camera:e}=this.places,i=this.display.views[this.chosen],s=i.kind==="flat";if(s)for(const{object:a}of this.bodies)a.scale.setComponent("xyz".indexOf(i.up[1]),1/i.stretch);const r=s?this.flat(i,t):this.orbit(i,t);if(this.into(t,r,!s),this.label(r,t,s?i:null),s)for(const{object:a}of this.bodies)a.scale.set(1,1,1);if(!this.display.camera||e.height<=20)return;const o=this.known(this.display.camera.carried_by)?.at||this.display.camera.start_m;o.some((a,l)=>a!==this.shot[l])&&(this.shot=[...o],this.aim(this.display.camera,o,e),this.into(e,this.onboard,!0))}orbit(t,e){const i=this.perspective,s=e.width/Math.max(e.height,1),r=this.eyes[this.chosen],{focus:o}=r;o.lerp(new z(...ld(t,this.known(t.follow)?.at)),.08);const a=o.distanceTo(new z(...t.centre_m)),l=r.zoom*(t.distance_m+t.growth*a)*Math.max(1,1.45/s),c=Math.cos(r.height);return i.position.set(o.x+l*c*Math.cos(r.azimuth),o.y+l*Math.sin(r.height),o.z+l*c*Math.sin(r.azimuth)),i.lookAt(o),i.aspect=s,i.updateProjectionMatrix(),i}flat(t,e){const i=this.ortho,s=t.span_m/2*this.eyes[this.chosen].zoom,r=s/(e.width/Math.max(e.height,1))/t.stretch;Object.assign(i,{left:-s,right:s,top:r,bottom:-r});const o=new z(...t.centre_m);return i.up.copy(pa(t.up)),i.position.copy(pa(t.right)).cross(i.up).multiplyScalar(50).add(o),i.lookAt(o),i.updateProjectionMatrix(),i}aim(t,e,i){const s=this.onboard;s.up.copy(pa(t.up)),s.position.set(...e),s.lookAt(s.position.clone().add(pa(t.look)));const r=Math.max(Ci(t.look,t.aim_m)-Ci(t.look,e),.4),[o,a]=t.half_field;this.cameraTan=Math.max(o,Math.min(a,t.half_height_m/r)),s.fov=2*Math.atan(this.cameraTan)*180/Math.PI,s.aspect=i.width/Math.max(i.height,1),s.updateProjectionMatrix(),s.updateMatrixWorld()}into(t,e,i){if(this.renderer.setViewport(t.left,t.bottom,t.width,t.height),this.renderer.setScissor(t.left,t.bottom,t.width,t.height),this.renderer.setClearColor(329740,1),this.renderer.clear(!0,!0),i){const s=e.position.clone();e.position.set(0,0,0),e.updateMatrixWorld(),this.renderer.render(this.far,e),e.position.copy(s),e.updateMatrixWorld(),this.renderer.clearDepth()}this.renderer.render(this.scene,e)}label(t,e,i){const s=i?i.up:"+y",r=i?i.stretch:1,o=new Map;for(const{text:l,at_m:c}of this.display.labels)o.set(l,{text:l,at:c,drop:1});for(const{item:l,object:c}of this.bodies){const u=l.label?Ui(this.frame,l.place,l.axes):void 0;if(!u)continue;const h=u.map((f,d)=>f+Mo[s][d]*c.reach[d]/r);o.set(`body ${l.name}`,{text:l.label,at:h,role:l.role})}for(const[l,c]of this.marks)o.has(l)||(c.remove(),this.marks.delete(l));t.updateMatrixWorld();const a=[];for(const[l,{text:c,at:u,role:h,drop:f}]of o){let d=this.marks.get(l);d||(d=document.createElement("span"),d.textContent=c,h&&(d.className="body",d.style.color=Vs(h)),this.elements.labels.append(d),this.marks.set(l,d));const g=new z(u[0],u[1],u[2]).project(t),v=Math.abs(g.x)<.98&&Math.abs(g.y)<.96&&g.z<1;d.style.display=v?"":"none";const m=Math.round((g.x+1)/2*e.width);let p=Math.round((1-g.y)/2*e.height)+(f?14:0);if(h){const E=([w,M])=>Math.abs(w-m)<5*this.tall&&Math.abs(M-p)<this.tall;for(;a.some(E);)p-=2;a.push([m,p])}d.style.left=`${m}px`,d.style.top=`${p}px`}}onCamera(t){const e=new z(...t).project(this.onboard);return e.z>1?null:[e.x,e.y]}covers(t){const e=this.items.get(t),i=e.visible,s=[i,!1].map(o=>{e.visible=o,this.draw();const a=this.renderer.getContext(),l=new Uint8Array(a.drawingBufferWidth*a.drawingBufferHeight*4);return a.readPixels(0,0,a.drawingBufferWidth,a.drawingBufferHeight,a.RGBA,a.UNSIGNED_BYTE,l),l});e.visible=i;let r=0;for(let o=0;o<s[0].length;o+=4)(s[0][o]!==s[1][o]||s[0][o+1]!==s[1][o+1])&&(r+=1);return r}}function PE(n){n?.traverse(t=>{t.geometry?.dispose(),t.material?.dispose()}),n?.removeFromParent()}function ld(n,t){if(!n.follow.length)return n.centre_m;const e=t?Ci(n.along,t)-Ci(n.along,n.centre_m):n.start_m,i=n.share*Math.sign(n.start_m)*Math.max(n.least_m,e*Math.sign(n.start_m));return n.centre_m.map((s,r)=>s+i*Mo[n.along][r])}function LE(n){return n.kind==="flat"&&n.stretch!==1?tn(ot.exaggerated,{axis:n.up[1],n:n.stretch}):""}const Dn=n=>document.getElementById(n),DE=250;class UE{constructor(t){this.scene=t,this.instruments=new Lm,this.commands=new Fm,this.charts=new Q_,this.chartsAt=0,this.text=""}setDisplay(t){const e=JSON.stringify(t);if(e===this.text){this.scene.place(null,null,0,!1);return}this.text=e,this.display=t,this.instruments.setDisplay(t),this.commands.setDisplay(t),this.charts.setDisplay(t),Dm(t.section),Dn("camera").hidden=!t.camera,Dn("clock-pred").parentElement.hidden=!t.predicted,t.camera&&(Dn("camera").setAttribute("aria-label",t.camera.title),Dn("camera-tag").textContent=t.camera.title),Dn("modes").hidden=!t.modes.length;for(const i of document.querySelectorAll("[data-mode]"))i.hidden=!t.modes.includes(i.dataset.mode);Dn("legend").replaceChildren(...t.legend.map(({role:i,words:s,dashed:r})=>{const o=document.createElement("span");return o.className=r?"dash":"",o.style.color=Te[i],o.textContent=s,o})),this.scene.setDisplay(t),Dn("views").replaceChildren(...t.views.map((i,s)=>{const r=document.createElement("button");return r.textContent=i.label,r.dataset.view=i.label.toLowerCase(),r.onclick=()=>this.setView(s),r})),Dn("views").hidden=t.views.length<2,this.setView(this.scene.chosen)}setView(t){this.scene.chosen=t,[...Dn("views").children].forEach((e,i)=>e.setAttribute("aria-pressed",String(i===t))),Dn("scale").textContent=LE(this.display.views[t])}nextView(){this.display&&this.setView((this.scene.chosen+1)%this.display.views.length)}clocks(t,e,i,s,r){const o=mi(t,this.display.measured),a=mi(t,this.display.predicted);al("gen",o?.t,i,r),al("rx",o?.received,s,r),al("pred",a?.t,a?tn(ot.ahead,{s:mn(a.t-e,1)}):"",r)}show({run:t,frame:e,rungs:i,history:s,now:r,stale:o,until:a}){const{display:l}=this,c=mi(e,l.measured);this.instruments.show(e,o),l.section&&Um(l.section,e),this.commands.show(e),Om(Dn("dial"),t,e.round_trip,c?.transit),km(e,c,t.step_s),Jm(Dn("ladder"),t,l.commands.axes,i,r),_i(Dn("ladder-counts"),tg(i)),this.scene.place(e,s,r,o),performance.now()-this.chartsAt>DE&&(this.chartsAt=performance.now(),this.charts.show(s.charts,e,a))}showReticle(t){this.display?.camera&&t&&Bm(Dn("reticle"),this.scene,this.display.camera,t)}}const He=n=>document.getElementById(n),IE=4;class NE{constructor(t,e,i){Object.assign(this,{link:t,panels:e,back:i,on:!1,run:null,at:0,playing:!1}),He("review-close").onclick=()=>this.leave(),He("review-play").onclick=()=>this.play(!this.playing),He("review-time").oninput=()=>this.go(Number(He("review-time").value)),addEventListener("keydown",s=>{this.on&&s.key==="Escape"&&!He("dialog").open&&this.leave()})}async list(){try{const t=await this.link.get("api/runs");$m(t,(e,i)=>this.open(e,i))}catch(t){su(ot.review_title,t.message)}}async open(t,e){e.textContent=ot.review_loading;try{this.run=await this.link.get(`api/runs/${t.split("/").map(encodeURIComponent).join("/")}`)}catch(i){e.textContent=i.message;return}iu(),this.start()}start(){const{run:t}=this;this.on=!0,this.history=new xd(t.display,1/0);for(const e of t.frames)this.history.add(e);this.rungs=t.ladder.map(wd),He("scrubber").hidden=!1,He("bottom").hidden=!0,He("review-time").max=String(t.frames.length-1),this.panels.setDisplay(t.display),t.display.camera&&(He("camera-tag").textContent=t.display.camera.review_title),He("run-name").textContent=`${ot.review}: ${t.name}`,this.marks(),this.go(t.frames.length-1),He("review-time").focus()}leave(){this.on=!1,this.playing=!1,He("scrubber").hidden=!0,He("bottom").hidden=!1,He("camera-tag").textContent=this.run.display.camera?.title||"",this.back()}play(t){this.playing=t,He("review-play").textContent=t?ot.stop_play:ot.play,t&&this.at>=this.run.frames.length-1&&this.go(0),this.playedAt=performance.now(),this.playedFrom=this.run.frames[this.at].t}go(t){this.at=Math.max(0,Math.min(this.run.frames.length-1,t)),He("review-time").value=String(this.at);const e=this.run.frames[this.at].t,i=this.run.events.filter(r=>r.t<=e),s=i[i.length-1];He("review-now").textContent=`${mn(e,1)} s${s&&e-s.t<5?` · ${s.text}`:""}`,He("review-time").setAttribute("aria-valuetext",He("review-now").textContent),this.playing&&(this.playedAt=performance.now(),this.playedFrom=e)}advance(){if(!this.playing)return;const t=this.playedFrom+IE*(performance.now()-this.playedAt)/1e3;let e=this.at;for(;e<this.run.frames.length-1&&this.run.frames[e].t<t;)e+=1;if(e!==this.at){const[i,s]=[this.playedAt,this.playedFrom];this.go(e),Object.assign(this,{playedAt:i,playedFrom:s})}e>=this.run.frames.length-1&&this.play(!1)}marks(){const t=He("review-time").getBoundingClientRect(),e=He("review-marks"),i=this.run.frames[this.run.frames.length-1].t||1;e.style.left=`${He("review-time").offsetLeft}px`,e.style.width=`${t.width}px`,e.innerHTML="";for(const s of this.run.events){const r=document.createElement("i");r.style.left=`${s.t/i*100}%`,r.title=`${mn(s.t,1)} s ${s.node}: ${s.text}`,e.append(r)}}frame(){return this.run.frames[this.at]}show(){this.advance();const{run:t}=this,e=this.frame(),i=mi(e,t.display.measured);this.banner(),this.panels.clocks(e,e.t,i?tn(ot.age,{s:mn(e.t-i.t,1)}):"","",!1),this.panels.show({run:t,frame:e,history:this.history,now:e.t,stale:!1,until:e.t,rungs:this.rungs.filter(s=>s.sent<=e.k).map(s=>Km(s,e.k))})}banner(){const t=He("banner"),e=this.at===this.run.frames.length-1&&this.run.verdict,i=e?yo(this.run.verdict.words):"";t.dataset.said!==i&&(t.dataset.said=i,t.textContent=i),t.classList.toggle("alarm",!!e&&!this.run.verdict.success)}}const FE=20,OE={axes:{},button:4,deadZone:.08,holdSpace:!1};function kE(n,t){if(!Number.isFinite(n))return 0;const e=Math.min(Math.abs(n),1);return e<=t?0:Math.sign(n)*(e-t)/(1-t)}class BE{constructor(t){this.onChange=t,this.down=new Set,this.step=1,this.source="keyboard",this.gamepad=null,this.settings={...OE,...zE()},this.setController(null),addEventListener("keydown",i=>this.key(i,!0)),addEventListener("keyup",i=>this.key(i,!1));const e=()=>{this.down.clear(),this.send(!0)};addEventListener("blur",e),document.addEventListener("visibilitychange",e),setInterval(()=>this.poll(),FE)}setController(t){this.axes=t?.axes||[],this.deflections=t?.key_deflections||[1],this.step=Math.min(this.step,this.deflections.length),this.keys=new Map,this.axes.forEach((e,i)=>e.keys.forEach(([s,r])=>this.keys.set(s,[i,1]).set(r,[i,-1])))}wiring(t){return this.settings.axes[t.name]||{axis:t.pad_axis,sign:t.pad_inverted?-1:1}}change(t){this.settings={...this.settings,...t},localStorage.setItem("rvd.stick",JSON.stringify(this.settings))}key(t,e){if(t.ctrlKey||t.metaKey||t.altKey||jp(t.target)||e&&t.target instanceof Element&&t.target.closest("input, select, dialog"))return;const i=Number(/^(?:Digit|Numpad)([1-9])$/.exec(t.code)?.[1]);if(e&&i<=this.deflections.length){this.step=i,this.send(!0);return}if(!this.keys.has(t.code)&&t.code!=="Space"||t.code==="Space"&&!this.settings.holdSpace)return;t.preventDefault();const s=this.down.has(t.code);e?this.down.add(t.code):this.down.delete(t.code),e&&(this.source="keyboard"),s!==e&&this.send(!0)}poll(){const t=navigator.getGamepads?[...navigator.getGamepads()].filter(Boolean):[];this.gamepad=t.find(e=>e.connected!==!1)||null,this.gamepad&&cd(this.gamepad,this.settings.button)&&(this.source="gamepad"),!this.gamepad&&this.source==="gamepad"&&(this.source="keyboard"),this.send(!1)}state(){const t=document.visibilityState==="visible"&&document.hasFocus();if(this.source==="gamepad"){const s=({axis:r,sign:o})=>o*kE(this.gamepad.axes[r],this.settings.deadZone);return{held:t&&cd(this.gamepad,this.settings.button),at:this.axes.map(r=>s(this.wiring(r)))}}const e=this.axes.map(()=>0);for(const s of this.down)this.keys.has(s)&&(e[this.keys.get(s)[0]]+=this.keys.get(s)[1]);const i=this.deflections[this.step-1];return{held:t&&(!this.settings.holdSpace||this.down.has("Space")),at:e.map(s=>Math.max(-1,Math.min(1,s))*i)}}send(t){this.onChange(this.state(),t)}}function cd(n,t){return!!(n.buttons[t]&&n.buttons[t].pressed)}function jp(n){return n instanceof Element&&!!n.closest("input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]")}function zE(){try{return JSON.parse(localStorage.getItem("rvd.stick"))||{}}catch{return{}}}const HE=6e3;class VE{constructor(){this.status={phase:"idle",lease:"free",pages:0,note:""},this.can={fly:!1,desk:!1},this.connected=!1,this.display=null,this.reset(null)}reset(t){this.run=t,this.frame=null,this.frameAt=0,this.verdict=null,this.ladder=new Map,this.events=[],this.abortAt=null,t&&(this.display=t.display,this.history=new xd(t.display,HE),this.history.begin(t.trails),this.rungs(t.ladder||[]))}take(t){switch(t.type){case"hello":this.can=t.can,t.display&&!this.display&&(this.display=t.display);break;case"run":this.reset(t);break;case"status":this.status=t;break;case"frame":this.takeFrame(t);break;case"ladder":this.rungs(t.ladder);break;case"verdict":this.verdict=t;break;case"event":this.events.push(t);break}!t.type&&t.link&&(this.connected=t.link==="open",t.why&&(this.why=t.why))}takeFrame(t){this.frame=t,this.frameAt=performance.now(),this.rungs(t.ladder),this.history.add(t),this.sent?.parts.kind===fo&&this.abortAt===null&&(this.abortAt=t.t)}get measured(){return mi(this.frame,this.display?.measured)}get predicted(){return mi(this.frame,this.display?.predicted)}get sent(){return this.frame?.signals[this.display.commands.sent]}rungs(t){for(const e of t)this.ladder.set(e[0],wd(e));for(;this.ladder.size>700;)this.ladder.delete(this.ladder.keys().next().value)}now(){if(!this.frame)return 0;if(this.frame.paused||this.verdict||this.status.phase!=="flying")return this.frame.t;const t=(performance.now()-this.frameAt)/1e3*this.run.pace;return this.frame.t+Math.min(t,this.run.step_s)}silence(){return!this.frame||this.verdict||this.frame.paused||this.status.phase!=="flying"?0:(performance.now()-this.frameAt)/1e3}}const _e=n=>document.getElementById(n),GE=1e3/30,[WE,XE]=[60,120],zu=1,tu=2e3;for(const n of document.querySelectorAll("[data-s]"))n.textContent=ot[n.dataset.s];for(const n of document.querySelectorAll("[data-a]"))n.setAttribute("aria-label",ot[n.dataset.a]);const Kt=new VE,Yi=new CE(_e("gl"),_e("view"),_e("camera"),_e("labels")),$r=new UE(Yi);Yi.enabled=!new URLSearchParams(location.search).has("plain");let ba=-1/0,Kl=0,ud=0,hd=null,fd=null;const Ai=new BE((n,t)=>Fn?.stick(n,t)),eu=new Ym(Fn),di=new NE(Fn,$r,()=>Zp());function $E(n){if(n.type==="desk"){eu.show(n,Kt.status.lease==="you");return}const t=Kt.status.phase;Kt.take(n),(n.type==="run"||n.type==="hello")&&!di.on&&Zp(),n.type==="status"&&(n.phase==="starting"&&t!=="starting"&&iu(),n.phase==="ended"&&t==="closing"&&Xm()&&di.list(),nu(),eu.lease(n.lease==="you")),n.type==="verdict"&&Kt.frame&&fd!==n&&!di.on&&!Kt.can.desk&&(fd=n,Wm(n,Kt.can.fly&&Kt.status.lease==="you",()=>Hu())),n.type==="event"&&(_e("event").textContent=`${mn(n.t,1)} s · ${n.text}`),n.type==="reply"&&!n.ok&&(_e("event").textContent=n.code?ru(n.code):n.text),n.type||nu()}function Zp(){const{display:n}=Kt;if(n){if($r.setDisplay(n),Ai.setController(n.controller),eu.task={hint:n.hint,goal:n.goal},!Kt.run){_e("run-name").textContent="";return}_e("run-name").textContent=`${Kt.run.name} · ${Kt.run.forward_s} s + ${Kt.run.back_s} s`,_e("run-name").title=_e("run-name").textContent}}async function Jp(){await Fn.ask({do:Kt.status.lease==="you"?"drop":"take"})}function Qp(n){Kt.frame&&Fn.ask({do:"mode",mode:n})}function tm(){Kt.frame&&Fn.ask({do:Kt.frame.paused?"resume":"pause"})}function em(){const n=performance.now();n-ba<tu?(ba=-1/0,Fn.ask({do:"abort"})):ba=n,dd(),setTimeout(dd,tu+50)}function dd(){const n=performance.now()-ba<tu;_e("abort").classList.toggle("armed",n),_e("abort").querySelector("small").textContent=n?ot.abort_armed:ot.abort_hint}function Hu(){Kt.status.lease!=="you"&&Fn.ask({do:"take"}),Gm(Kt,n=>Fn.ask(n))}function qE(){const n=Kt.display?.modes||[];n.length&&Qp(n[(n.indexOf(Kt.frame?.mode)+1)%n.length])}const pd={KeyT:Jp,KeyP:tm,KeyX:em,KeyN:Hu,KeyV:()=>$r.nextView(),KeyL:()=>di.list(),KeyG:()=>Ed(Ai),Slash:()=>yd(Kt.display),KeyM:qE,Equal:()=>Yi.zoom(.85),Minus:()=>Yi.zoom(1.18),BracketLeft:()=>Yi.turn(.15,0),BracketRight:()=>Yi.turn(-.15,0)};addEventListener("keydown",n=>{n.repeat||n.ctrlKey||n.metaKey||n.altKey||jp(n.target)||_e("dialog").open&&n.code!=="KeyX"||pd[n.code]&&Fn&&pd[n.code]()});_e("lease").onclick=Jp;_e("pause").onclick=tm;_e("abort").onclick=em;_e("restart").onclick=Hu;_e("open-review").onclick=()=>di.list();_e("open-settings").onclick=()=>Ed(Ai);_e("open-help").onclick=()=>yd(Kt.display);for(const n of document.querySelectorAll("[data-mode]"))n.onclick=()=>Qp(n.dataset.mode);function nu(){const{status:n}=Kt,t=n.lease==="you";_e("lease").textContent=t?ot.drop:n.lease==="other"?ot.taken:ot.take,_e("lease").disabled=n.lease==="other",_e("lease").classList.toggle("primary",n.lease==="free"),_e("pages").textContent=n.pages===1?ot.pages_one:tn(ot.pages,{n:n.pages}),_e("socket-state").textContent=Kt.connected?`● ${ot.socket_open}`:`○ ${ot.socket_closed}`,_e("socket-state").className=Kt.connected?"ok":"alarm";for(const e of["pause","restart"])_e(e).disabled=!t;for(const e of document.querySelectorAll("[data-mode]"))e.disabled=!t}function ci(n,t,e){const i=_e("banner"),s=n?`${Xe(n)}${t?`<small>${Xe(t)}</small>`:""}`:"";i.dataset.said!==s&&(i.dataset.said=s,i.innerHTML=s),i.classList.toggle("alarm",!!e)}function YE(n){const{status:t,frame:e,run:i,verdict:s}=Kt;if(!Kt.connected&&Fn)ci(ot.socket_closed,"",!0);else if(t.phase==="idle")ci(ot.idle,ot.idle_text);else if(t.phase==="starting")ci(ot.starting,t.run||"");else if(t.note==="failed")ci(ot.run_failed,"",!0);else if(n>zu)ci(tn(ot.stale_frames,{s:n.toFixed(0)}),"",!0);else if(Kt.abortAt!==null&&!s&&e){const r=[...Kt.ladder.values()].some(jm),o=Kt.display.abort;ci(r?o?tn(ot.aborted_so,{does:o}):ot.aborted:tn(ot.abort_sent,{s:Math.max(0,i.forward_s-(e.t-Kt.abortAt)).toFixed(0)}),"",!0)}else t.pilot_lost?ci(ot.pilot_lost,"",!0):e?.paused?ci(ot.paused,""):e&&!Kt.measured&&t.phase==="flying"?ci(ot.no_telemetry,tn(ot.first_in,{s:Math.max(0,i.back_s-e.t).toFixed(0)})):s?ci(yo(s.words),"",!s.success):ci("")}function KE(){const n=Kt.status.lease==="you",t=Ai.state().held,e=n?Ai.axes.length?t?`${ot.stick_held} · ${ot[Ai.source]}`:ot.stick_open:ot.stick_none:ot.stick_watch;_i(_e("stick-state"),e),_e("stick-state").className=n?t?"ok":"alarm":"dim";const i=Kt.display?.controller?.step_name;_i(_e("step"),n&&Ai.source==="keyboard"&&Ai.deflections.length>1?`${i} ${Ai.step}`:"")}function jE(n,t){const{run:e,measured:i}=Kt,s=i?t-i.t:null,r=s!==null&&s>e.back_s+zu*Math.max(e.pace,1);return $r.clocks(n,t,s===null?"":tn(ot.age,{s:mn(s,1)}),i?tn(ot.ago,{s:mn(Math.max(t-i.received,0),1)}):"",r),r}function ZE(){const{frame:n,run:t,history:e}=Kt,i=Kt.silence();YE(i),KE(),_i(_e("pause"),n?.paused?ot.resume:ot.pause);for(const o of document.querySelectorAll("[data-mode]"))o.setAttribute("aria-pressed",String(o.dataset.mode===(n?.mode||t?.mode)));if(!t||!n)return;const s=Kt.now(),r=jE(n,s)||i>zu||!Kt.connected;document.body.classList.toggle("stale",r),$r.show({run:t,frame:n,history:e,rungs:[...Kt.ladder.values()],now:s,stale:r})}function nm(n){if(requestAnimationFrame(nm),n-Kl<GE-2)return;Yi.adapt(n-Kl),Kl=n;const t=n-ud>(Kt.frame===hd&&!di.on?XE:WE);t&&(ud=n,hd=Kt.frame,di.on?di.show():ZE()),Yi.draw(),t&&$r.showReticle(di.on?di.frame():Kt.frame)}nu();Fn?Fn.listen($E):su(ot.no_token_title,ot.no_page_token);requestAnimationFrame(nm);window.rvd={store:Kt,scene:Yi,stick:Ai,review:di,link:Fn};
