var EM=Object.create;var Zg=Object.defineProperty;var AM=Object.getOwnPropertyDescriptor;var CM=Object.getOwnPropertyNames;var RM=Object.getPrototypeOf,PM=Object.prototype.hasOwnProperty;var IM=(n,e)=>()=>{try{return e||n((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var LM=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let r of CM(e))!PM.call(n,r)&&r!==t&&Zg(n,r,{get:()=>e[r],enumerable:!(i=AM(e,r))||i.enumerable});return n};var DM=(n,e,t)=>(t=n!=null?EM(RM(n)):{},LM(e||!n||!n.__esModule?Zg(t,"default",{value:n,enumerable:!0}):t,n));var Pv=IM(vp=>{var bv=Object.defineProperty,_T=n=>bv(n,"__esModule",{value:!0}),vT=(n,e)=>{for(var t in e)bv(n,t,{get:e[t],enumerable:!0})};_T(vp);vT(vp,{GIFEncoder:()=>Cv,applyPalette:()=>AT,default:()=>OT,nearestColor:()=>IT,nearestColorIndex:()=>Ev,nearestColorIndexWithDistance:()=>Av,prequantize:()=>ET,quantize:()=>wT,snapColorsToPalette:()=>PT});var yT={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};function Sv(n=256){let e=0,t=new Uint8Array(n);return{get buffer(){return t.buffer},reset(){e=0},bytesView(){return t.subarray(0,e)},bytes(){return t.slice(0,e)},writeByte(r){i(e+1),t[e]=r,e++},writeBytes(r,s=0,o=r.length){i(e+o);for(let a=0;a<o;a++)t[e++]=r[a+s]},writeBytesView(r,s=0,o=r.byteLength){i(e+o),t.set(r.subarray(s,s+o),e),e+=o}};function i(r){var s=t.length;if(s>=r)return;var o=1024*1024;r=Math.max(r,s*(s<o?2:1.125)>>>0),s!=0&&(r=Math.max(r,256));let a=t;t=new Uint8Array(r),e>0&&t.set(a.subarray(0,e),0)}}var mp=12,vv=5003,xT=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function bT(n,e,t,i,r=Sv(512),s=new Uint8Array(256),o=new Int32Array(vv),a=new Int32Array(vv)){let l=o.length,c=Math.max(2,i);s.fill(0),a.fill(0),o.fill(-1);let u=0,d=0,f=c+1,p=f,m=!1,x=p,_=(1<<x)-1,g=1<<f-1,b=g+1,A=g+2,S=0,P=t[0],C=0;for(let k=l;k<65536;k*=2)++C;C=8-C,r.writeByte(c),E(g);let v=t.length;for(let k=1;k<v;k++)e:{let N=t[k],L=(N<<mp)+P,B=N<<C^P;if(o[B]===L){P=a[B];break e}let z=B===0?1:l-B;for(;o[B]>=0;)if(B-=z,B<0&&(B+=l),o[B]===L){P=a[B];break e}E(P),P=N,A<1<<mp?(a[B]=A++,o[B]=L):(o.fill(-1),A=g+2,m=!0,E(g))}return E(P),E(b),r.writeByte(0),r.bytesView();function E(k){for(u&=xT[d],d>0?u|=k<<d:u=k,d+=x;d>=8;)s[S++]=u&255,S>=254&&(r.writeByte(S),r.writeBytesView(s,0,S),S=0),u>>=8,d-=8;if((A>_||m)&&(m?(x=p,_=(1<<x)-1,m=!1):(++x,_=x===mp?1<<x:(1<<x)-1)),k==b){for(;d>0;)s[S++]=u&255,S>=254&&(r.writeByte(S),r.writeBytesView(s,0,S),S=0),u>>=8,d-=8;S>0&&(r.writeByte(S),r.writeBytesView(s,0,S),S=0)}}}var ST=bT;function Mv(n,e,t){return n<<8&63488|e<<2&992|t>>3}function wv(n,e,t,i){return n>>4|e&240|(t&240)<<4|(i&240)<<8}function Tv(n,e,t){return n>>4<<8|e&240|t>>4}function yu(n,e,t){return n<e?e:n>t?t:n}function Ul(n){return n*n}function yv(n,e,t){var i=0,r=1e100;let s=n[e],o=s.cnt,a=s.ac,l=s.rc,c=s.gc,u=s.bc;for(var d=s.fw;d!=0;d=n[d].fw){let p=n[d],m=p.cnt,x=o*m/(o+m);if(!(x>=r)){var f=0;t&&(f+=x*Ul(p.ac-a),f>=r)||(f+=x*Ul(p.rc-l),!(f>=r)&&(f+=x*Ul(p.gc-c),!(f>=r)&&(f+=x*Ul(p.bc-u),!(f>=r)&&(r=f,i=d))))}}s.err=r,s.nn=i}function gp(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function MT(n,e){let t=e==="rgb444"?4096:65536,i=new Array(t),r=n.length;if(e==="rgba4444")for(let s=0;s<r;++s){let o=n[s],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255,d=wv(u,c,l,a),f=d in i?i[d]:i[d]=gp();f.rc+=u,f.gc+=c,f.bc+=l,f.ac+=a,f.cnt++}else if(e==="rgb444")for(let s=0;s<r;++s){let o=n[s],a=o>>16&255,l=o>>8&255,c=o&255,u=Tv(c,l,a),d=u in i?i[u]:i[u]=gp();d.rc+=c,d.gc+=l,d.bc+=a,d.cnt++}else for(let s=0;s<r;++s){let o=n[s],a=o>>16&255,l=o>>8&255,c=o&255,u=Mv(c,l,a),d=u in i?i[u]:i[u]=gp();d.rc+=c,d.gc+=l,d.bc+=a,d.cnt++}return i}function wT(n,e,t={}){let{format:i="rgb565",clearAlpha:r=!0,clearAlphaColor:s=0,clearAlphaThreshold:o=0,oneBitAlpha:a=!1}=t;if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(n.buffer),c=t.useSqrt!==!1,u=i==="rgba4444",d=MT(l,i),f=d.length,p=f-1,m=new Uint32Array(f+1);for(var x=0,g=0;g<f;++g){let H=d[g];if(H!=null){var _=1/H.cnt;u&&(H.ac*=_),H.rc*=_,H.gc*=_,H.bc*=_,d[x++]=H}}Ul(e)/x<.022&&(c=!1);for(var g=0;g<x-1;++g)d[g].fw=g+1,d[g+1].bk=g,c&&(d[g].cnt=Math.sqrt(d[g].cnt));c&&(d[g].cnt=Math.sqrt(d[g].cnt));var b,A,S;for(g=0;g<x;++g){yv(d,g,!1);var P=d[g].err;for(A=++m[0];A>1&&(S=A>>1,!(d[b=m[S]].err<=P));A=S)m[A]=b;m[A]=g}var C=x-e;for(g=0;g<C;){for(var v;;){var E=m[1];if(v=d[E],v.tm>=v.mtm&&d[v.nn].mtm<=v.tm)break;v.mtm==p?E=m[1]=m[m[0]--]:(yv(d,E,!1),v.tm=g);var P=d[E].err;for(A=1;(S=A+A)<=m[0]&&(S<m[0]&&d[m[S]].err>d[m[S+1]].err&&S++,!(P<=d[b=m[S]].err));A=S)m[A]=b;m[A]=E}var k=d[v.nn],N=v.cnt,L=k.cnt,_=1/(N+L);u&&(v.ac=_*(N*v.ac+L*k.ac)),v.rc=_*(N*v.rc+L*k.rc),v.gc=_*(N*v.gc+L*k.gc),v.bc=_*(N*v.bc+L*k.bc),v.cnt+=k.cnt,v.mtm=++g,d[k.bk].fw=k.fw,d[k.fw].bk=k.bk,k.mtm=p}let B=[];var z=0;for(g=0;;++z){let U=yu(Math.round(d[g].rc),0,255),H=yu(Math.round(d[g].gc),0,255),Y=yu(Math.round(d[g].bc),0,255),G=255;u&&(G=yu(Math.round(d[g].ac),0,255),a&&(G=G<=(typeof a=="number"?a:127)?0:255),r&&G<=o&&(U=H=Y=s,G=0));let le=u?[U,H,Y,G]:[U,H,Y];if(TT(B,le)||B.push(le),(g=d[g].fw)==0)break}return B}function TT(n,e){for(let t=0;t<n.length;t++){let i=n[t],r=i[0]===e[0]&&i[1]===e[1]&&i[2]===e[2],s=i.length>=4&&e.length>=4?i[3]===e[3]:!0;if(r&&s)return!0}return!1}function bu(n,e){var t=0,i;for(i=0;i<n.length;i++){let r=n[i]-e[i];t+=r*r}return t}function xu(n,e){return e>1?Math.round(n/e)*e:n}function ET(n,{roundRGB:e=5,roundAlpha:t=10,oneBitAlpha:i=null}={}){let r=new Uint32Array(n.buffer);for(let s=0;s<r.length;s++){let o=r[s],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255;a=xu(a,t),i&&(a=a<=(typeof i=="number"?i:127)?0:255),u=xu(u,e),c=xu(c,e),l=xu(l,e),r[s]=a<<24|l<<16|c<<8|u<<0}}function AT(n,e,t="rgb565"){if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let i=new Uint32Array(n.buffer),r=i.length,s=t==="rgb444"?4096:65536,o=new Uint8Array(r),a=new Array(s),l=t==="rgba4444";if(t==="rgba4444")for(let c=0;c<r;c++){let u=i[c],d=u>>24&255,f=u>>16&255,p=u>>8&255,m=u&255,x=wv(m,p,f,d),_=x in a?a[x]:a[x]=CT(m,p,f,d,e);o[c]=_}else{let c=t==="rgb444"?Tv:Mv;for(let u=0;u<r;u++){let d=i[u],f=d>>16&255,p=d>>8&255,m=d&255,x=c(m,p,f),_=x in a?a[x]:a[x]=RT(m,p,f,e);o[u]=_}}return o}function CT(n,e,t,i,r){let s=0,o=1e100;for(let a=0;a<r.length;a++){let l=r[a],c=l[3],u=po(c-i);if(u>o)continue;let d=l[0];if(u+=po(d-n),u>o)continue;let f=l[1];if(u+=po(f-e),u>o)continue;let p=l[2];u+=po(p-t),!(u>o)&&(o=u,s=a)}return s}function RT(n,e,t,i){let r=0,s=1e100;for(let o=0;o<i.length;o++){let a=i[o],l=a[0],c=po(l-n);if(c>s)continue;let u=a[1];if(c+=po(u-e),c>s)continue;let d=a[2];c+=po(d-t),!(c>s)&&(s=c,r=o)}return r}function PT(n,e,t=5){if(!n.length||!e.length)return;let i=n.map(o=>o.slice(0,3)),r=t*t,s=n[0].length;for(let o=0;o<e.length;o++){let a=e[o];a.length<s?a=[a[0],a[1],a[2],255]:a.length>s?a=a.slice(0,3):a=a.slice();let l=Av(i,a.slice(0,3),bu),c=l[0],u=l[1];u>0&&u<=r&&(n[c]=a)}}function po(n){return n*n}function Ev(n,e,t=bu){let i=1/0,r=-1;for(let s=0;s<n.length;s++){let o=n[s],a=t(e,o);a<i&&(i=a,r=s)}return r}function Av(n,e,t=bu){let i=1/0,r=-1;for(let s=0;s<n.length;s++){let o=n[s],a=t(e,o);a<i&&(i=a,r=s)}return[r,i]}function IT(n,e,t=bu){return n[Ev(n,e,t)]}function Cv(n={}){let{initialCapacity:e=4096,auto:t=!0}=n,i=Sv(e),r=5003,s=new Uint8Array(256),o=new Int32Array(r),a=new Int32Array(r),l=!1;return{reset(){i.reset(),l=!1},finish(){i.writeByte(yT.trailer)},bytes(){return i.bytes()},bytesView(){return i.bytesView()},get buffer(){return i.buffer},get stream(){return i},writeHeader:c,writeFrame(u,d,f,p={}){let{transparent:m=!1,transparentIndex:x=0,delay:_=0,palette:g=null,repeat:b=0,colorDepth:A=8,dispose:S=-1}=p,P=!1;if(t?l||(P=!0,c(),l=!0):P=!!p.first,d=Math.max(0,Math.floor(d)),f=Math.max(0,Math.floor(f)),P){if(!g)throw new Error("First frame must include a { palette } option");DT(i,d,f,g,A),xv(i,g),b>=0&&NT(i,b)}let C=Math.round(_/10);LT(i,S,C,m,x);let v=!!g&&!P;UT(i,d,f,v?g:null),v&&xv(i,g),FT(i,u,d,f,A,s,o,a)}};function c(){Rv(i,"GIF89a")}}function LT(n,e,t,i,r){n.writeByte(33),n.writeByte(249),n.writeByte(4),r<0&&(r=0,i=!1);var s,o;i?(s=1,o=2):(s=0,o=0),e>=0&&(o=e&7),o<<=2,n.writeByte(0|o|0|s),Is(n,t),n.writeByte(r||0),n.writeByte(0)}function DT(n,e,t,i,r=8){let a=_p(i.length)-1,l=128|r-1<<4|0|a,c=0,u=0;Is(n,e),Is(n,t),n.writeBytes([l,c,u])}function NT(n,e){n.writeByte(33),n.writeByte(255),n.writeByte(11),Rv(n,"NETSCAPE2.0"),n.writeByte(3),n.writeByte(1),Is(n,e),n.writeByte(0)}function xv(n,e){let t=1<<_p(e.length);for(let i=0;i<t;i++){let r=[0,0,0];i<e.length&&(r=e[i]),n.writeByte(r[0]),n.writeByte(r[1]),n.writeByte(r[2])}}function UT(n,e,t,i){if(n.writeByte(44),Is(n,0),Is(n,0),Is(n,e),Is(n,t),i){let o=_p(i.length)-1;n.writeByte(128|o)}else n.writeByte(0)}function FT(n,e,t,i,r=8,s,o,a){ST(t,i,e,r,n,s,o,a)}function Is(n,e){n.writeByte(e&255),n.writeByte(e>>8&255)}function Rv(n,e){for(var t=0;t<e.length;t++)n.writeByte(e.charCodeAt(t))}function _p(n){return Math.max(Math.ceil(Math.log2(n)),1)}var OT=Cv});var Et,Qg,xd,Ss,vd,Gc,e0,zc,t0,bd,yd,NM,vl=Symbol.for("pv"),Hc={},Wc=[],UM=/^m(i|n|o|s|text|space)$/,Sd=Array.isArray,Md=Wc.slice,ro=Object.assign;function io(n){n&&n.parentNode&&n.remove()}function n0(n,e,t){var i,r,s,o={},a=arguments.length;for(s in e)s=="key"?i=e[s]:s=="ref"&&typeof n!="function"?r=e[s]:o[s]=e[s];return a>2&&(o.children=a>3?Md.call(arguments,2):t),_l(n,o,i,r,null)}function _l(n,e,t,i,r){var s={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:vl,__v:r||++Qg,__i:-1,__u:0};return!r&&Et.vnode&&Et.vnode(s),s}function Ct(n){return n.children}function Yo(n,e){this.props=n,this.context=e,this.__g=0}function Ms(n,e){if(e==null)return n.__&&Ms(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Ms(n)}function FM(n){var e,t=n.__v,i=t.__e,r=[],s=[],o=n.__P;o&&((e=ro({constructor:vl},t)).__v=t.__v+1,Et.vnode&&Et.vnode(e),wd(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,r,i||Ms(t),32&t.__u,s),e.__v=t.__v,e.__.__k[e.__i]=e,l0(r,e,s),t.__=t.__e=null,e.__e!=i&&i0(e))}function i0(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),i0(n)}function Jg(n){(8&n.__g||(n.__g|=8,Ss.push(n),Gc++))&&vd==Et.debounceRendering||((vd=Et.debounceRendering)||queueMicrotask)(r0)}function r0(){try{for(var n,e=1;Ss.length;)Ss.length>e&&Ss.sort(e0),n=Ss.shift(),e=Ss.length,8&n.__g&&FM(n)}finally{(Gc=Ss.length)&&(vd||queueMicrotask)(r0)}}function s0(n,e,t,i,r,s,o,a,l,c,u){var d,f,p,m,x,_,g=i.__k||Wc,b=e.length;for(l=OM(t,e,g,l,b),d=0;d<b;d++)(p=t.__k[d])!=null&&(f=~p.__i&&g[p.__i]||Hc,p.__i=d,_=wd(n,p,f,r,s,o,a,l,c,u),m=p.__e,(f.ref!=p.ref||8&f.__u)&&(f.ref&&Td(f.ref,null,p,f),p.ref&&u.push(p.ref,p.__c||m,p)),x=x||m,4&p.__u?(l=o0(p,l,n,!f.__v),f.__e&&(f.__e=null)):typeof p.type=="function"&&_!==void 0?l=_:m&&(l=m.nextSibling),p.__u&=-21);return t.__e=x,l}function OM(n,e,t,i,r){var s,o,a,l,c,u,d,f,p,m=t.length,x=m,_=0,g=0,b=n.__k=Array(r);for(s=0;s<r;s++)(o=e[s])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=b[s]=_l(null,o):Sd(o)?o=b[s]=_l(Ct,{children:o}):o.constructor===vl&&o.__b?o=b[s]=_l(o.type,o.props,o.key,o.ref,o.__v):b[s]=o,l=s+_,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=kM(o,t,l,x))&&(x--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?_--:c==l+1?_++:c!=l&&(c>l?_--:_++,g=1)):(~c||(r>m?_--:r<m&&_++),typeof o.type!="function"&&(o.__u|=4))):b[s]=null;if(g){for(u=[],d=[],s=0;s<r;s++)if((o=b[s])&&16&o.__u){for(_=0,f=u.length;_<f;)u[p=_+f>>1]<o.__i?_=p+1:f=p;u[_]=o.__i,d[s]=_+1}for(_=u.length;s--;)d[s]&&(d[s]==_?_--:b[s].__u|=4)}if(x)for(s=0;s<m;s++)!(a=t[s])||2&a.__u||(a.__e==i&&(i=Ms(a)),Ed(a,a));return i}function o0(n,e,t,i){var r,s,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(r=n.__k)for(s=0;s<r.length;s++)r[s]&&(r[s].__=n,e=o0(r[s],e,t,!1));return e}for(e&&!e.parentNode&&(e=Ms(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function kM(n,e,t,i){var r,s=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&s==null||l&&s==a.key&&o==a.type)return t;if(i>(l?1:0)){for(r=t-1;r>=0;r--)if((a=e[r])&&!(2&a.__u)&&s==a.key&&o==a.type)return r;for(r=t+1;r<e.length;r++)if((a=e[r])&&!(2&a.__u)&&s==a.key&&o==a.type)return r}return-1}function jg(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Bc(n,e,t,i,r){var s,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||jg(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||jg(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=yd[e]||(yd[e]=BM(e)),(n.__a||(n.__a={}))[e]=bd,s=e!=(e=e.replace(t0,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,s):n.removeEventListener(e,o,s));else{if(r=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function BM(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[zc]==null)e[zc]=bd++;else if(e[zc]<this.__a[n])return;return t(Et.event?Et.event(e):e)}}}function wd(n,e,t,i,r,s,o,a,l,c){var u,d,f,p,m,x,_,g,b,A,S,P,C,v,E,k,N,L,B=e.type;if(e.constructor!==vl)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,d=s=[],u.nodeType==8?a=Vc(u,s):s.push(u),a=s[0]||a),(u=Et.__b)&&u(e);e:if(typeof B=="function"){f=o.length;try{if(g=e.props,b=(u=B.prototype)&&u.render,A=(u=B.contextType)&&i[u.__c],S=u?A?A.props.value:u.__:i,(p=t.__c)?(e.__c=p,2&p.__g&&(p.__g|=1)):(b?e.__c=p=new B(g,S):(e.__c=p=new Yo(g,S),p.constructor=B,p.render=VM),A&&A.sub(p),p.state||(p.state={}),p.__n=i,p.__g|=8,p.__h=[],p.__k=[]),b&&(p.__s||(p.__s=p.state),B.getDerivedStateFromProps&&(p.__s==p.state&&(p.__s=ro({},p.__s)),ro(p.__s,B.getDerivedStateFromProps(g,p.__s)))),m=p.props,x=p.state,p.__v=e,t.__c){if(g!==m&&b&&!B.getDerivedStateFromProps&&p.componentWillReceiveProps&&p.componentWillReceiveProps(g,S),e.__v==t.__v&&!(8&p.__g)||!(4&p.__g)&&p.shouldComponentUpdate&&p.shouldComponentUpdate(g,p.__s,S)===!1){e.__v!=t.__v&&(p.props=g,p.state=p.__s,p.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),Wc.push.apply(p.__h,p.__k),p.__k=[],p.__h.length&&o.push(p),a=Ms(t);break e}p.componentWillUpdate&&p.componentWillUpdate(g,p.__s,S),b&&p.componentDidUpdate&&p.__h.push(function(){p.componentDidUpdate(m,x,_)})}else b&&!B.getDerivedStateFromProps&&p.componentWillMount&&p.componentWillMount(),b&&p.componentDidMount&&p.__h.push(p.componentDidMount);p.context=S,p.props=g,p.__P=n,p.__g&=-5,P=Et.__r,C=b?25:0;do p.__g&=-9,P&&P(e),u=p.render(p.props,p.state=p.__s,p.context);while(8&p.__g&&++C<25);b&&(Wc.push.apply(p.__h,p.__k),p.__k=[]),p.state=p.__s,p.getChildContext&&(i=ro({},i,p.getChildContext())),b&&t.__c&&p.getSnapshotBeforeUpdate&&(_=p.getSnapshotBeforeUpdate(m,x)),v=u&&u.type===Ct&&u.key==null?u.props.children:u,g.__P&&(u=a,r=(n=g.__P).namespaceURI,l=s=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&Ed(z,z)}),t.__k=null),a=t.__k?Ms(t,0):null),a=s0(n,Sd(v)?v:[v],e,t,i,r,s,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,d&&d.some(io),p.__h.length&&o.push(p),1&p.__g&&(p.__g&=-4)}catch(z){if(o.length=f,e.__v=null,l||s)if(z&&z.then){if(e.__u|=128|l,s){for(~(N=s.indexOf(a||void 0))||(N=s.length);(L=s[N-1])&&L.nodeType==8;)N--;for(;N<s.length;N++)if(L=s[N])if(s[N]=null,E){if(L==k)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(k=Vc(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=Vc(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else s&&s.some(io);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||a0(e),Et.__e(z,e,t)}}else a=e.__e=zM(t.__e,e,t,i,r,s,o,l,c,n);return(u=Et.diffed)&&u(e),a}function Vc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function a0(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(a0))}function l0(n,e,t){for(var i=0;i<t.length;)Td(t[i++],t[i++],t[i++]);Et.__c&&Et.__c(e,n),n.some(function(r){try{n=r.__h,r.__h=[],n.some(function(s){s.call(r)})}catch(s){Et.__e(s,r.__v)}})}function zM(n,e,t,i,r,s,o,a,l,c){var u,d,f,p,m,x,_,g,b=t.props||Hc,A=e.props,S=e.type;if(S=="svg"?r="http://www.w3.org/2000/svg":S=="math"?r="http://www.w3.org/1998/Math/MathML":r||(r="http://www.w3.org/1999/xhtml"),s){for(u=0;u<s.length;u++)if((m=s[u])&&(S?m.localName==S:m.nodeType==3)){n=m,s[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!S)return g.createTextNode(A);n=g.createElementNS(r,S,A.is?A:c),a&&(Et.__m&&Et.__m(e,s),a=!1),s=null}if(S){if(c=S=="template"&&n.content||n,s=S=="textarea"&&A.defaultValue!=null?null:s&&Md.call(c.childNodes),!a&&s)for(b={},u=0;u<n.attributes.length;u++)b[(m=n.attributes[u]).name]=m.value;for(u in b)m=b[u],u=="dangerouslySetInnerHTML"?f=m:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||Bc(n,u,null,m,r);for(u in A)m=A[u],u=="children"?p=m:u=="dangerouslySetInnerHTML"?d=m:u=="value"?x=m:u=="checked"?_=m:a&&typeof m!="function"||b[u]===m||Bc(n,u,m,b[u],r);d?(a||f&&(d.__html==f.__html||d.__html==n.innerHTML)||(n.innerHTML=d.__html),e.__k=[]):(f&&(n.textContent=""),(S=="foreignObject"||r=="http://www.w3.org/1998/Math/MathML"&&UM.test(S))&&(r="http://www.w3.org/1999/xhtml"),s0(c,Sd(p)?p:[p],e,t,i,r,s,o,s?s[0]:t.__k&&Ms(t,0),a,l),s&&s.some(io)),a&&S!="textarea"||(u="value",S=="progress"&&x==null?n.removeAttribute(u):x==null||x===n[u]&&(S!="progress"||x)||Bc(n,u,x,b[u],r),u="checked",_!=null&&_!=n[u]&&Bc(n,u,_,b[u],r))}else b===A||a&&n.data==A||(n.data=A);return n}function Td(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(r){Et.__e(r,t)}}function Ed(n,e,t){var i,r,s,o;if(Et.unmount&&Et.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Td(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Et.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Ed(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(r=Vc(i,s=[]))&&(i==n.__e&&s.some(io),io(r),io(i)),t||io(n.__e),n.__e=n.__c=n.__=null}function VM(n,e,t){return this.constructor(n,t)}function yl(n,e){var t,i,r,s;Et.__&&Et.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=_l(Ct,{children:[n]}),r=[],s=[],wd(e,e.__k,i||Hc,Hc,e.namespaceURI,i?null:e.firstChild?Md.call(e.childNodes):null,r,i?i.__e:e.firstChild,t,s),l0(r,e.__k,s),e.__k.props.children=null}Et={__e:function(n,e,t,i){for(var r,s,o;e=e.__;)if((r=e.__c)&&!(1&r.__g)){r.__g|=4;try{if((o=(s=r.constructor)&&s.getDerivedStateFromError)&&r.setState(s.getDerivedStateFromError(n)),r.componentDidCatch&&(r.componentDidCatch(n,i||{}),o=1),o&&8&r.__g)return void(r.__g|=2)}catch(a){n=a}}throw Gc=0,n}},Qg=0,xd=function(n){return n!=null&&n.constructor===vl},Yo.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=ro({},this.state)),typeof n=="function"&&(n=n(ro({},t),this.props)),n&&(ro(t,n),this.__v&&(e&&this.__k.push(e),Jg(this)))},Yo.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Jg(this))},Yo.prototype.render=Ct,Ss=[],Gc=0,e0=function(n,e){return n.__v.__b-e.__v.__b},zc=Symbol(),t0=/(PointerCapture)$|Capture$/i,bd=0,yd={},NM=0;var Ko,Tn,Ad,c0,Cd=Object.is,qc=0,v0=[],Rd=[],vn=Et,u0=vn.__b,h0=vn.__r,f0=vn.diffed,d0=vn.__c,p0=vn.unmount,m0=vn.__;function Xc(n,e){vn.__h&&vn.__h(Tn,n,qc||e),qc=0;var t=Tn.__H||(Tn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Lt(n){return qc=1,GM(y0,n)}function GM(n,e,t){var i=Xc(Ko++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):y0(void 0,e),function(s){var o=(i.__N||i.__)[0],a=i.t(o,s);Cd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Tn,!Tn.__f)){Tn.__f=!0;var r=Tn.shouldComponentUpdate;Tn.shouldComponentUpdate=function(s,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=s;if(l.__.some(function(f){f.__N&&(c=!0,Cd(f.__[0],f.__N[0])||(u=!0))}),r){var d=r.call(this,s,o,a);return c?d||u:d}return!c||u}}return i.__}function Ut(n,e){var t=Xc(Ko++,3);!vn.__s&&Id(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Tn.__H.__h.push(t))}function Qi(n,e){var t=Xc(Ko++,4);!vn.__s&&Id(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,Tn.__h.push(t))}function lt(n){return qc=5,gt(function(){return{current:n}},[])}function gt(n,e){var t=Xc(Ko++,7);return Id(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function HM(){var n;do{for(;n=Rd.shift();)try{xl(n)}catch(t){vn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=v0.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(xl),e.__h.some(Pd),e.__h=[]}catch(t){e.__h=[],vn.__e(t,n.__v)}}}while(Rd.length)}vn.__b=function(n){Tn=null,u0&&u0(n)},vn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),m0&&m0(n,e)},vn.__r=function(n){h0&&h0(n),Ko=0;var e=(Tn=n.__c).__H;e&&(Ad==Tn?Tn.__h=[]:(e.__h.some(xl),e.__h.some(Pd),Ko=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Ad=Tn},vn.diffed=function(n){f0&&f0(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&_0(v0.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Ad=Tn=null},vn.__c=function(n,e){e.some(function(t){try{t.__h.some(xl),t.__h=t.__h.filter(function(i){return!i.__||Pd(i)})}catch(i){t.__h=[function(){throw i}]}}),d0&&d0(n,e)},vn.unmount=function(n){p0&&p0(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(r){try{if(r.__P&&r.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}r.__P=t,_0(Rd.push(r))}else xl(r)}catch(s){e=s}}),i.__H=void 0,e&&vn.__e(e,i.__v))};var g0=typeof requestAnimationFrame=="function";function WM(n){var e,t=function(){clearTimeout(i),g0&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);g0&&(e=requestAnimationFrame(t))}function _0(n){n!=1&&c0==vn.requestAnimationFrame||((c0=vn.requestAnimationFrame)||WM)(HM)}function xl(n){var e=Tn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Tn=e}function Pd(n){var e=Tn;n.__c=n.__(),Tn=e}function Id(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Cd(t,n[i])})}function y0(n,e){return typeof e=="function"?e(n):e}var qM=Symbol.for("preact-signals");function Zc(){if(Yr>1)Yr--;else{var n,e=!1;for((function(){var r=Yc;for(Yc=void 0;r!==void 0;){var s=r.S;if(s.v===r.v)for(var o=s.t;o!==void 0;o=o.x)o.i===r.i&&(o.i=s.i);r=r.o}})();Sl!==void 0;){var t=Sl;for(Sl=void 0,$c++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&b0(t))try{t.c()}catch(r){e||(n=r,e=!0)}t=i}}if($c=0,Yr--,e)throw n}}function Jc(n){if(Yr>0)return n();Ld=++XM,Yr++;try{return n()}finally{Zc()}}var bl,nn=void 0;function Ml(n){var e=nn,t=bl;nn=void 0,bl=void 0;try{return n()}finally{nn=e,bl=t}}var Sl=void 0,Yr=0,$c=0,XM=0,Ld=0,Yc=void 0,Kc=0;function x0(n){if(nn!==void 0){var e=n.n;if(e===void 0||e.t!==nn)return e={i:0,S:n,p:nn.s,n:void 0,t:nn,e:void 0,x:void 0,r:e},nn.s!==void 0&&(nn.s.n=e),nn.s=e,n.n=e,32&nn.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=nn.s,e.n=void 0,nn.s.n=e,nn.s=e),e}}function Pn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Pn.prototype.brand=qM;Pn.prototype.h=function(){return!0};Pn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:Ml(function(){var i;(i=e.W)==null||i.call(e)}))};Pn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&Ml(function(){var r;(r=e.Z)==null||r.call(e)}))}};Pn.prototype.subscribe=function(n){var e=this;return et(function(){var t=e.value;Ml(function(){return n(t)})},{name:"sub"})};Pn.prototype.valueOf=function(){return this.value};Pn.prototype.toString=function(){return this.value+""};Pn.prototype.toJSON=function(){return this.value};Pn.prototype.peek=function(){var n=this;return Ml(function(){return n.value})};Object.defineProperty(Pn.prototype,"value",{get:function(){var n=x0(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if($c>100)throw new Error("Cycle detected");(function(t){Yr!==0&&$c===0&&t.l!==Ld&&(t.l=Ld,Yc={S:t,v:t.v,i:t.i,o:Yc})})(this),this.v=n,this.i++,Kc++,Yr++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{Zc()}}}});function pe(n,e){return new Pn(n,e)}function b0(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function S0(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function M0(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function so(n,e){Pn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Kc-1,this.f=4}so.prototype=new Pn;so.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Kc))return!0;if(this.g=Kc,this.f|=1,this.i>0&&!b0(this))return this.f&=-2,!0;var n=nn;try{S0(this),nn=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return nn=n,M0(this),this.f&=-2,!0};so.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Pn.prototype.S.call(this,n)};so.prototype.U=function(n){if(this.t!==void 0&&(Pn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};so.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(so.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=x0(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function xt(n,e){return new so(n,e)}function w0(n){var e=n.j;if(n.j=void 0,typeof e=="function"){Yr++;var t=nn;nn=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,Dd(n),i}finally{nn=t,Zc()}}}function Dd(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,w0(n)}function $M(n){if(nn!==this)throw new Error("Out-of-order effect");M0(this),nn=n,this.f&=-2;try{8&this.f&&Dd(this)}finally{Zc()}}function Zo(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,bl&&bl.push(this)}Zo.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Zo.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,w0(this),S0(this),Yr++;var n=nn;return nn=this,$M.bind(this,n)};Zo.prototype.N=function(){2&this.f||(this.f|=2,this.u=Sl,Sl=this)};Zo.prototype.d=function(){this.f|=8,1&this.f||Dd(this)};Zo.prototype.dispose=function(){this.d()};function et(n,e){var t=new Zo(n,e);try{t.c()}catch(r){throw t.d(),r}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var Nd,Tl,jc,YM=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,T0=[],E0=[];et(function(){Nd=this.N})();function Jo(n,e){Et[n]=e.bind(null,Et[n]||function(){})}function wl(n){if(jc){var e=jc;jc=void 0,e()}jc=n&&n.S()}function A0(n){var e=this,t=n.data,i=ZM(t);i.name="ReactiveDom",i.value=t;var r=gt(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=xt(function(){var p=i.value.value;return p===0?0:p===!0?"":p||""}),u=xt(function(){return!Array.isArray(c.value)&&!xd(c.value)}),d=et(function(){if(this.N=C0,u.value){var p=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=p)}}),f=e.__$u.d;return e.__$u.d=function(){d(),f.call(this)},[u,c]},[]),s=r[0],o=r[1];return s.value?o.peek():o.value}A0.displayName="ReactiveTextNode";Object.defineProperties(Pn.prototype,{constructor:{configurable:!0,value:n0(Ct,null).constructor},type:{configurable:!0,value:A0},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});Jo("__b",function(n,e){if(wl(),Tl=void 0,typeof e.type=="string"){var t,i=e.props;for(var r in i)if(r!=="children"){var s=i[r];s instanceof Pn&&(t||(e.__np=t={}),t[r]=s,i[r]=s.peek())}}n(e)});Jo("__r",function(n,e){if(n(e),e.type!==Ct){wl();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(r,s){var o;return et(function(){o=this},{name:s}),o.c=r,o})((function(r){return function(){var s;YM&&((s=this.y)==null||s.call(this)),r.__$f|=1,r.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),Tl=i,wl(t)}});Jo("__e",function(n,e,t,i){wl(),Tl=void 0,n(e,t,i)});Jo("diffed",function(n,e){wl(),Tl=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,r=e.props,s=t.U;if(s)for(var o in s){var a=s[o];a===void 0||i&&o in i||(a.d(),s[o]=void 0)}if(i){s||(s={},t.U=s);for(var l in i){var c=s[l],u=i[l];c===void 0?(c=KM(t,l,u,r),s[l]=c):c.o(u,r)}}}n(e)});function KM(n,e,t,i){var r=e in n&&n.ownerSVGElement===void 0,s=pe(t);return{o:function(o,a){s.value=o,i=a},d:et(function(){this.N=C0;var o=s.value.value;i[e]!==o&&(i[e]=o,r?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}Jo("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var r in i){var s=i[r];s&&s.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});Jo("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});Yo.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var r in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var s=2&this.__$f;if(!(i||s||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function ZM(n,e){return gt(function(){return pe(n,e)},[])}var JM=typeof requestAnimationFrame>"u"?setTimeout:function(n){var e=function(){clearTimeout(t),cancelAnimationFrame(i),n()},t=setTimeout(e,35),i=requestAnimationFrame(e)},jM=function(n){queueMicrotask(function(){queueMicrotask(n)})};function QM(){Jc(function(){for(var n;n=T0.shift();)Nd.call(n)})}function ew(){T0.push(this)===1&&(Et.requestAnimationFrame||JM)(QM)}function tw(){Jc(function(){for(var n;n=E0.shift();)Nd.call(n)})}function C0(){E0.push(this)===1&&(Et.requestAnimationFrame||jM)(tw)}function R0(n,e){var t=lt(n);t.current=n;var i=Tl;Ut(function(){return et(function(){if(this.N=ew,!(i&&8&i.__$f))return t.current()},e)},[])}var jo=pe([]);function El(n,e){let t={title:n,keys:e};return jo.value=[...jo.peek(),t],()=>jo.value=jo.peek().filter(i=>i!==t)}var nw="input, textarea, select",iw="button, summary, a";function wr(n,e){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return;let t=n.target;if(t.closest(nw)!==null||n.key===" "&&t.closest(iw)!==null)return;let i=e.map(r=>r.actions[n.key]).find(r=>r!==void 0);i!==void 0&&(n.preventDefault(),i(n))}var P0=8,rw={"<f8":Float64Array,"<f4":Float32Array,"<i4":Int32Array,"<i2":Int16Array,"|i1":Int8Array},Qo=class n{constructor(e,t,i){this.header=e;this.content=t;this.front=i}header;content;front;static read(e){let t=new DataView(e).getUint32(0,!0),i=new TextDecoder().decode(new Uint8Array(e,4,t)),r=Math.ceil((4+t)/P0)*P0;return new n(JSON.parse(i),e,r)}has(e){return e in this.header.variables}values(e){let{type:t,start:i,shape:r}=this.described(e);if(t===void 0||i===void 0)throw new Error(`${e} has no numbers`);let s=r.reduce((o,a)=>o*a,1);return new rw[t](this.content,this.front+i,s)}scale(e){return this.described(e).scale??1}texts(e){return this.described(e).texts??[]}shape(e){return this.described(e).shape}unit(e){return this.described(e).attrs.units??""}title(e){return this.described(e).attrs.long_name??e}parsed(e){return JSON.parse(String(this.header.attrs[e]))}described(e){let t=this.header.variables[e];if(t===void 0)throw new Error(`the dataset has no variable ${e}`);return t}};var sw=Symbol.for("pv"),ow=0;function h(n,e,t,i,r,s){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:sw,__v:--ow,__i:-1,__u:0};return(r||s)&&(c.__source=r,c.__self=s),Et.vnode&&Et.vnode(c),c}function er({title:n,units:e,unit:t}){return h("label",{children:[n," ",h("select",{value:t.value.name,onChange:({currentTarget:i})=>t.value=e[i.selectedIndex]??t.value,children:e.map(({name:i})=>h("option",{children:i}))})]})}function ea({playing:n}){return h("button",{type:"button",onClick:()=>n.value=!n.value,children:n.value?"Stop":"Move"})}function ta({pace:n}){return h("label",{children:["pace, cycles per second: ",n.value.toFixed(1),h("input",{type:"range",min:"0.1",max:"3",step:"0.1",value:n.value,onInput:e=>n.value=Number(e.currentTarget.value)})]})}function ws({facts:n}){return h("dl",{children:n.filter(([,e])=>e).map(([e,t])=>h("div",{children:[h("dt",{children:e}),h("dd",{children:t})]}))})}var oo=n=>String(n.header.attrs.origin??"simulated");function tr({name:n,data:e,keys:t,foot:i,isOld:r=!1,children:s}){Ut(()=>El(e.header.title,t),[e,t]);let o=e.header.extra.summary??[];return h("div",{class:n,tabIndex:-1,onKeyDown:a=>wr(a,t),children:[h("header",{children:[h("h1",{children:e.header.title}),h("p",{class:"origin",children:oo(e)}),h("div",{class:r?"old":"",children:o.map(a=>h("p",{children:a}))})]}),s,h("footer",{children:h("p",{children:["haptonic ",String(e.header.attrs.haptonic_version??""),". ",i]})})]})}function Tr(n){return[{keys:"t",effect:"tables",actions:{t:()=>Ud(n,"table")}},{keys:"?",effect:"this list",actions:{"?":()=>Ud(n,"keys")}}]}function Ud(n,e){n.value=n.value===e?"none":e}function Er({listing:n,keys:e,children:t}){let i=lt(null);return R0(()=>{n.value!=="none"&&i.current?.focus()}),h("section",{"aria-label":"Tables and keys",children:[h("p",{class:"opened",children:[["table","Tables"],["keys","Keys"]].map(([s,o])=>h("button",{type:"button","aria-expanded":n.value===s,onClick:()=>Ud(n,s),children:o}))}),h("div",{ref:i,tabIndex:-1,children:[n.value==="table"&&t,n.value==="keys"&&h(Al,{title:"Keys",keys:e})]})]})}function Al({title:n,keys:e}){return h("table",{children:[n&&h("caption",{children:n}),h("tbody",{children:e.map(({keys:t,effect:i})=>h("tr",{children:[h("th",{scope:"row",children:h("kbd",{children:t})}),h("td",{children:i})]}))})]})}function Hn(n,e){if(!(Number.isFinite(e)&&e>0))return n.toFixed(3);e=Math.max(e,10**-6);let t=Math.floor(Math.log10(e)+1e-9);e<2*10**t&&(t-=1);let i=Math.ceil(e/10**t-1e-9);i===10&&([i,t]=[1,t+1]);let r=Math.min(Math.max(-t,0),6);return`${n.toFixed(r)} ± ${(i*10**t).toFixed(r)}`}var I0=[{name:"Hz",factor:1},{name:"kHz",factor:1e3},{name:"MHz",factor:1e6}],aw=1e4;function Ts(n){let{pitch_m:e,shear_speed_m_per_s:t}=n.header.attrs;return typeof e!="number"||typeof t!="number"?I0:[...I0,{name:"ωa/(2πcₜ)",factor:t/e,relative:!0}]}function Es(n,e){return n.find(({factor:i,relative:r})=>!r&&e<aw*i)??n[0]}function Qc(n){return[{name:"rad/m",factor:1},{name:"π/a",factor:Math.PI/n},{name:"2π/a",factor:2*Math.PI/n}]}function oi(n,{name:e,relative:t}){return t?`${e} = ${n}`:`${n} ${e}`}function In(n,{name:e,relative:t}){return t?e:`${n} / ${e.includes("/")?`(${e})`:e}`}function Ar(n){return`${Number(n.toPrecision(6))}`}function pi({label:n,describedBy:e="point",onKeyDown:t,children:i}){return h("div",{class:"walk",tabIndex:0,role:"application","aria-label":n,"aria-describedby":e,onKeyDown:t,children:i})}var lw="uplot",cw="u-hz",uw="u-vt",hw="u-title",fw="u-wrap",dw="u-under",pw="u-over",mw="u-axis",co="u-off",gw="u-select",_w="u-cursor-x",vw="u-cursor-y",yw="u-cursor-pt",xw="u-legend",bw="u-live",Sw="u-inline",Mw="u-series",ww="u-marker",L0="u-label",Tw="u-value",Rl="width",Pl="height";var D0="bottom",na="left",Fd="right",Qd="#000",N0=Qd+"0",Od="mousemove",U0="mousedown",kd="mouseup",F0="mouseenter",O0="mouseleave",k0="dblclick",Ew="resize",Aw="scroll",B0="change",ru="dppxchange",ep="--",ca=typeof window<"u",Hd=ca?document:null,ra=ca?window:null,Cw=ca?navigator:null,Dt,eu;function Wd(){let n=devicePixelRatio;Dt!=n&&(Dt=n,eu&&Xd(B0,eu,Wd),eu=matchMedia(`(min-resolution: ${Dt-.001}dppx) and (max-resolution: ${Dt+.001}dppx)`),uo(B0,eu,Wd),ra.dispatchEvent(new CustomEvent(ru)))}function wi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function qd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Jt(n,e,t){n.style[e]=t+"px"}function nr(n,e,t,i){let r=Hd.createElement(n);return e!=null&&wi(r,e),t?.insertBefore(r,i),r}function Vi(n,e){return nr("div",n,e)}var z0=new WeakMap;function Cr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=z0.get(n);s!=o&&(n.style.transform=s,z0.set(n,s),e<0||t<0||e>i||t>r?wi(n,co):qd(n,co))}var V0=new WeakMap;function G0(n,e,t){let i=e+t,r=V0.get(n);i!=r&&(V0.set(n,i),n.style.background=e,n.style.borderColor=t)}var H0=new WeakMap;function W0(n,e,t,i){let r=e+""+t,s=H0.get(n);r!=s&&(H0.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var tp={passive:!0},Rw={...tp,capture:!0};function uo(n,e,t,i){e.addEventListener(n,t,i?Rw:tp)}function Xd(n,e,t,i){e.removeEventListener(n,t,tp)}ca&&Wd();function ir(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:Ti((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function v_(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var y_=n=>n!=null,x_=n=>n!=null&&n>0,au=v_(y_),Pw=v_(x_);function Iw(n,e,t,i=0,r=!1){let s=r?Pw:au,o=r?x_:y_;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Wt,l??-Wt]}function lu(n,e,t,i){let r=$0(n),s=$0(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Kr:b_,a=r==1?Ti:Gi,l=s==1?Gi:Ti,c=a(o(Dn(n))),u=l(o(Dn(e))),d=sa(t,c),f=sa(t,u);return t==10&&(c<0&&(d=qt(d,-c)),u<0&&(f=qt(f,-u))),i||t==2?(n=d*r,e=f*s):(n=T_(n,d),e=cu(e,f)),[n,e]}function np(n,e,t,i){let r=lu(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var ip=.1,q0={mode:3,pad:ip},Ll={pad:0,soft:null,mode:0},Lw={min:Ll,max:Ll};function su(n,e,t,i){return uu(t)?X0(n,e,t):(Ll.pad=t,Ll.soft=i?0:null,Ll.mode=i?3:0,X0(n,e,Lw))}function Rt(n,e){return n??e}function Dw(n,e,t){for(e=Rt(e,0),t=Rt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function X0(n,e,t){let i=t.min,r=t.max,s=Rt(i.pad,0),o=Rt(r.pad,0),a=Rt(i.hard,-Wt),l=Rt(r.hard,Wt),c=Rt(i.soft,Wt),u=Rt(r.soft,-Wt),d=Rt(i.mode,0),f=Rt(r.mode,0),p=e-n,m=Kr(p),x=ai(Dn(n),Dn(e)),_=Kr(x),g=Dn(_-m);(p<1e-24||g>10)&&(p=0,(n==0||e==0)&&(p=1e-24,d==2&&c!=Wt&&(s=0),f==2&&u!=-Wt&&(o=0)));let b=p||x||1e3,A=Kr(b),S=sa(10,Ti(A)),P=b*(p==0?n==0?.1:1:s),C=qt(T_(n-P,S/10),24),v=n>=c&&(d==1||d==3&&C<=c||d==2&&C>=c)?c:Wt,E=ai(a,C<v&&n>=v?v:rr(v,C)),k=b*(p==0?e==0?.1:1:o),N=qt(cu(e+k,S/10),24),L=e<=u&&(f==1||f==3&&N>=u||f==2&&N<=u)?u:-Wt,B=rr(l,N>L&&e<=L?L:ai(L,N));return E==B&&E==0&&(B=100),[E,B]}var Nw=new Intl.NumberFormat(ca?Cw.language:"en-US"),rp=n=>Nw.format(n),Ei=Math,iu=Ei.PI,Dn=Ei.abs,Ti=Ei.floor,Ln=Ei.round,Gi=Ei.ceil,rr=Ei.min,ai=Ei.max,sa=Ei.pow,$0=Ei.sign,Kr=Ei.log10,b_=Ei.log2,Uw=(n,e=1)=>Ei.sinh(n)*e,Bd=(n,e=1)=>Ei.asinh(n/e),Wt=1/0;function Y0(n){return(Kr((n^n>>31)-(n>>31))|0)+1}function $d(n,e,t){return rr(ai(n,e),t)}function S_(n){return typeof n=="function"}function bt(n){return S_(n)?n:()=>n}var Fw=()=>{},M_=n=>n,w_=(n,e)=>e,Ow=n=>null,K0=n=>!0,Z0=(n,e)=>n==e,kw=/\.\d*?(?=9{6,}|0{6,})/gm,ho=n=>{if(A_(n)||Cs.has(n))return n;let e=`${n}`,t=e.match(kw);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${ho(r)}e${s}`}return qt(n,i)};function ao(n,e){return ho(qt(ho(n/e))*e)}function cu(n,e){return ho(Gi(ho(n/e))*e)}function T_(n,e){return ho(Ti(ho(n/e))*e)}function qt(n,e=0){if(A_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Ln(i)/t}var Cs=new Map;function E_(n){return((""+n).split(".")[1]||"").length}function Nl(n,e,t,i){let r=[],s=i.map(E_);for(let o=e;o<t;o++){let a=Dn(o),l=qt(sa(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=n==10?u:qt(u,d);r.push(f),Cs.set(f,d)}}return r}var Dl={},sp=[],oa=[null,null],As=Array.isArray,A_=Number.isInteger,Bw=n=>n===void 0;function J0(n){return typeof n=="string"}function uu(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function zw(n){return n!=null&&typeof n=="object"}var Vw=Object.getPrototypeOf(Uint8Array),C_="__proto__";function aa(n,e=uu){let t;if(As(n)){let i=n.find(r=>r!=null);if(As(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=aa(n[r],e)}else t=n.slice()}else if(n instanceof Vw)t=n.slice();else if(e(n)){t={};for(let i in n)i!=C_&&(t[i]=aa(n[i],e))}else t=n;return t}function En(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=C_&&(uu(n[r])?En(n[r],aa(i[r])):n[r]=aa(i[r]))}return n}var Gw=0,Hw=1,Ww=2;function qw(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function Xw(n,e){if(Kw(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Zw(o[0])||(o=Yw(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(r).fill(void 0),f=e?e[o][c]:Hw,p=[];for(let m=0;m<u.length;m++){let x=u[m],_=s.get(l[m]);x===null?f!=Gw&&(d[_]=x,f==Ww&&p.push(_)):d[_]=x}qw(d,p,r),i.push(d)}}return i}var $w=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Yw(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function Kw(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function Zw(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=ai(1,Ti((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var R_=["January","February","March","April","May","June","July","August","September","October","November","December"],P_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function I_(n){return n.slice(0,3)}var Jw=P_.map(I_),jw=R_.map(I_),Qw={MMMM:R_,MMM:jw,WWWW:P_,WWW:Jw};function Cl(n){return(n<10?"0":"")+n}function e1(n){return(n<10?"00":n<100?"0":"")+n}var t1={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Cl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Cl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Cl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Cl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Cl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>e1(n.getMilliseconds())};function op(n,e){e=e||Qw;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?t1[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var n1=new Intl.DateTimeFormat().resolvedOptions().timeZone;function i1(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==n1?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var L_=n=>n%1==0,ou=[1,2,2.5,5],r1=Nl(10,-32,0,ou),D_=Nl(10,0,32,ou),s1=D_.filter(L_),lo=r1.concat(D_),ap=`
`,N_="{YYYY}",j0=ap+N_,U_="{M}/{D}",Il=ap+U_,tu=Il+"/{YY}",F_="{aa}",o1="{h}:{mm}",ia=o1+F_,Q0=ap+ia,e_=":{ss}",Ft=null;function O_(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?Nl(10,0,3,ou).filter(L_):Nl(10,-3,0,ou)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,N_,Ft,Ft,Ft,Ft,Ft,Ft,1],[r*28,"{MMM}",j0,Ft,Ft,Ft,Ft,Ft,1],[r,U_,j0,Ft,Ft,Ft,Ft,Ft,1],[i,"{h}"+F_,tu,Ft,Il,Ft,Ft,Ft,1],[t,ia,tu,Ft,Il,Ft,Ft,Ft,1],[e,e_,tu+" "+ia,Ft,Il+" "+ia,Ft,Q0,Ft,1],[n,e_+".{fff}",tu+" "+ia,Ft,Il+" "+ia,Ft,Q0,Ft,1]];function u(d){return(f,p,m,x,_,g)=>{let b=[],A=_>=o,S=_>=s&&_<o,P=d(m),C=qt(P*n,3),v=zd(P.getFullYear(),A?0:P.getMonth(),S||A?1:P.getDate()),E=qt(v*n,3);if(S||A){let k=S?_/s:0,N=A?_/o:0,L=C==E?C:qt(zd(v.getFullYear()+N,v.getMonth()+k,1)*n,3),B=new Date(Ln(L/n)),z=B.getFullYear(),U=B.getMonth();for(let H=0;L<=x;H++){let Y=zd(z+N*H,U+k*H,1),G=Y-d(qt(Y*n,3));L=qt((+Y+G)*n,3),L<=x&&b.push(L)}}else{let k=_>=r?r:_,N=Ti(m)-Ti(C),L=E+N+cu(C-E,k);b.push(L);let B=d(L),z=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,U=_/i,H=f.axes[p]._space,Y=g/H;for(;L=qt(L+_,n==1?0:3),!(L>x);)if(U>1){let G=Ti(qt(z+U,6))%24,Q=d(L).getHours()-G;Q>1&&(Q=-1),L-=Q*i,z=(z+U)%24;let re=b[b.length-1];qt((L-re)/_,3)*Y>=.7&&b.push(L)}else b.push(L)}return b}}return[l,c,u]}var[a1,l1,c1]=O_(1),[u1,h1,f1]=O_(.001);Nl(2,-53,53,[1]);function t_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function n_(n,e){return(t,i,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,d,f,p;return i.map(m=>{let x=n(m),_=x.getFullYear(),g=x.getMonth(),b=x.getDate(),A=x.getHours(),S=x.getMinutes(),P=x.getSeconds(),C=_!=l&&a[2]||g!=c&&a[3]||b!=u&&a[4]||A!=d&&a[5]||S!=f&&a[6]||P!=p&&a[7]||a[1];return l=_,c=g,u=b,d=A,f=S,p=P,C(x)})}}function d1(n,e){let t=op(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function zd(n,e,t){return new Date(n,e,t)}function i_(n,e){return e(n)}var p1="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function r_(n,e){return(t,i,r,s)=>s==null?ep:e(n(i))}function m1(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function g1(n,e){return n.series[e].fill(n,e)}var _1={show:!0,live:!0,isolate:!1,mount:Fw,markers:{show:!0,width:2,stroke:m1,fill:g1,dash:"solid"},idx:null,idxs:null,values:[]};function v1(n,e){let t=n.cursor.points,i=Vi(),r=t.size(n,e);Jt(i,Rl,r),Jt(i,Pl,r);let s=r/-2;Jt(i,"marginLeft",s),Jt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Jt(i,"borderWidth",o),i}function y1(n,e){let t=n.series[e].points;return t._fill||t._stroke}function x1(n,e){let t=n.series[e].points;return t._stroke||t._fill}function b1(n,e){return n.series[e].points.size}var Vd=[0,0];function S1(n,e,t){return Vd[0]=e,Vd[1]=t,Vd}function nu(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function Gd(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var M1={show:!0,x:!0,y:!0,lock:!1,move:S1,points:{one:!1,show:v1,size:b1,width:0,stroke:x1,fill:y1},bind:{mousedown:nu,mouseup:nu,click:nu,dblclick:nu,mousemove:Gd,mouseleave:Gd,mouseenter:Gd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},k_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},lp=En({},k_,{filter:w_}),B_=En({},lp,{size:10}),z_=En({},k_,{show:!1}),cp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',V_="bold "+cp,G_=1.5,s_={show:!0,scale:"x",stroke:Qd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:V_,side:2,grid:lp,ticks:B_,border:z_,font:cp,lineGap:G_,rotate:0},w1="Value",T1="Time",o_={show:!0,scale:"x",auto:!1,sorted:1,min:Wt,max:-Wt,idxs:[]};function E1(n,e,t,i,r){return e.map(s=>s==null?"":rp(s))}function A1(n,e,t,i,r,s,o){let a=[],l=Cs.get(r)||0;t=o?t:qt(cu(t,r),l);for(let c=t;c<=i;c=qt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function Yd(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Kr:b_,u=Ti(c(t));r=sa(l,u),l==10&&(r=lo[ir(r,lo)]);let d=t,f=r*l;l==10&&(f=lo[ir(f,lo)]);do a.push(d),d=d+r,l==10&&!Cs.has(d)&&(d=qt(d,Cs.get(r))),d>=f&&(r=d,f=r*l,l==10&&(f=lo[ir(f,lo)]));while(d<=i);return a}function C1(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Yd(n,e,ai(l,t),i,r):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Yd(n,e,ai(l,-i),-t,r):[l]).reverse().map(f=>-f).concat(u,c)}var H_=/./,R1=/[12357]/,P1=/[125]/,a_=/1/,Kd=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function I1(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,u=l(10,o),d=l(9,o)-u>=c?H_:l(7,o)-u>=c?R1:l(5,o)-u>=c?P1:a_;if(d==a_){let f=Dn(l(1,o)-u);if(f<c)return Kd(e.slice().reverse(),a.distr,d,Gi(c/f)).reverse()}return Kd(e,a.distr,d,1)}function L1(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=Dn(l(1,o)-l(2,o));return c<a?Kd(e.slice().reverse(),3,H_,Gi(a/c)).reverse():e}function D1(n,e,t,i){return i==null?ep:e==null?"":rp(e)}var l_={show:!0,scale:"y",stroke:Qd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:V_,side:3,grid:lp,ticks:B_,border:z_,font:cp,lineGap:G_,rotate:0};function N1(n,e){let t=3+(n||1)*2;return qt(t*e,3)}function U1(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Dn(o-s),l=n.series[e],c=a/(l.points.space*Dt);return i[1]-i[0]<=c}var c_={scale:null,auto:!0,sorted:0,min:Wt,max:-Wt},W_=(n,e,t,i,r)=>r,u_={show:!0,auto:!0,sorted:0,gaps:W_,alpha:1,facets:[En({},c_,{scale:"x"}),En({},c_,{scale:"y"})]},h_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:W_,alpha:1,points:{show:U1,filter:null},values:null,min:Wt,max:-Wt,idxs:[],path:null,clip:null};function F1(n,e,t,i,r){return t/10}var q_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},O1=En({},q_,{time:!1,ori:1}),f_={};function X_(n,e){let t=f_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=r&&t.plots[u].pub(i,r,s,o,a,l,c)}},n!=null&&(f_[n]=t)),t}var la=1,Zd=2;function fo(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],u=i==2?o[r.facets[0].scale]:o[n.series[0].scale],d=i==2?o[r.facets[1].scale]:o[r.scale],f=a.left,p=a.top,m=a.width,x=a.height,_=n.valToPosH,g=n.valToPosV;return u.ori==0?t(r,l,c,u,d,_,g,f,p,m,x,fu,ua,pu,Y_,Z_):t(r,l,c,u,d,g,_,p,f,x,m,du,ha,fp,K_,J_)}function up(n,e){let t=0,i=0,r=Rt(n.bands,sp);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function k1(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Zr(n,e,t,i,r,s){return fo(n,e,(o,a,l,c,u,d,f,p,m,x,_)=>{let g=o.pxRound,b=c.dir*(c.ori==0?1:-1),A=c.ori==0?ua:ha,S,P;b==1?(S=t,P=i):(S=i,P=t);let C=g(d(a[S],c,x,p)),v=g(f(l[S],u,_,m)),E=g(d(a[P],c,x,p)),k=g(f(s==1?u.max:u.min,u,_,m)),N=new Path2D(r);return A(N,E,k),A(N,C,k),A(N,C,v),N})}function hu(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?pu:fp,l=t;for(let d=0;d<n.length;d++){let f=n[d];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+s),l=f[1]}}let c=t+r-l,u=10;c>0&&a(o,l,i-u/2,c,i+s+u)}return o}function B1(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function hp(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let d=c,f=c;if(r==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=s(n[d]),m=f==d?p:s(n[f]),x=d-r;p=o<=0&&x>=0&&x<l?s(n[x]):p;let g=f+r;m=o>=0&&g>=0&&g<l?s(n[g]):m,m>=p&&a.push([p,m])}return a}function d_(n){return n==0?M_:n==1?Ln:e=>ao(e,n)}function $_(n){let e=n==0?fu:du,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?i(r,s,o,a,l):(c=rr(c,a/2,l/2),u=rr(u,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,u),t(r,s,o+l,s,o,u),t(r,s,o,s+a,o,c),r.closePath())}}var fu=(n,e,t)=>{n.moveTo(e,t)},du=(n,e,t)=>{n.moveTo(t,e)},ua=(n,e,t)=>{n.lineTo(e,t)},ha=(n,e,t)=>{n.lineTo(t,e)},pu=$_(0),fp=$_(1),Y_=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},K_=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Z_=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},J_=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function j_(n){return(e,t,i,r,s)=>fo(e,t,(o,a,l,c,u,d,f,p,m,x,_)=>{let{pxRound:g,points:b}=o,A,S;c.ori==0?(A=fu,S=Y_):(A=du,S=K_);let P=qt(b.width*Dt,3),C=(b.size-b.width)/2*Dt,v=qt(C*2,3),E=new Path2D,k=new Path2D,{left:N,top:L,width:B,height:z}=e.bbox;pu(k,N-v,L-v,B+v*2,z+v*2);let U=H=>{if(l[H]!=null){let Y=g(d(a[H],c,x,p)),G=g(f(l[H],u,_,m));A(E,Y+C,G),S(E,Y,G,C,0,iu*2)}};if(s)s.forEach(U);else for(let H=i;H<=r;H++)U(H);return{stroke:P>0?E:null,fill:E,clip:k,flags:la|Zd}})}function Q_(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var z1=Q_(ua),V1=Q_(ha);function ev(n){let e=Rt(n?.alignGaps,0);return(t,i,r,s)=>fo(t,i,(o,a,l,c,u,d,f,p,m,x,_)=>{[r,s]=au(l,r,s);let g=o.pxRound,b=z=>g(d(z,c,x,p)),A=z=>g(f(z,u,_,m)),S,P;c.ori==0?(S=ua,P=z1):(S=ha,P=V1);let C=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:la},E=v.stroke,k=!1;if(s-r>=x*4){let z=he=>t.posToVal(he,c.key,!0),U=null,H=null,Y,G,le,J=b(a[C==1?r:s]),Q=b(a[r]),re=b(a[s]),fe=z(C==1?Q+1:re-1);for(let he=C==1?r:s;he>=r&&he<=s;he+=C){let ee=a[he],ye=(C==1?ee<fe:ee>fe)?J:b(ee),Ce=l[he];ye==J?Ce!=null?(G=Ce,U==null?(S(E,ye,A(G)),Y=U=H=G):G<U?U=G:G>H&&(H=G)):Ce===null&&(k=!0):(U!=null&&P(E,J,A(U),A(H),A(Y),A(G)),Ce!=null?(G=Ce,S(E,ye,A(G)),U=H=Y=G):(U=H=null,Ce===null&&(k=!0)),J=ye,fe=z(J+C))}U!=null&&U!=H&&le!=J&&P(E,J,A(U),A(H),A(Y),A(G))}else for(let z=C==1?r:s;z>=r&&z<=s;z+=C){let U=l[z];U===null?k=!0:U!=null&&S(E,b(a[z]),A(U))}let[L,B]=up(t,i);if(o.fill!=null||L!=0){let z=v.fill=new Path2D(E),U=o.fillTo(t,i,o.min,o.max,L),H=A(U),Y=b(a[r]),G=b(a[s]);C==-1&&([G,Y]=[Y,G]),S(z,G,H),S(z,Y,H)}if(!o.spanGaps){let z=[];k&&z.push(...hp(a,l,r,s,C,b,e)),v.gaps=z=o.gaps(t,i,r,s,z),v.clip=hu(z,c.ori,p,m,x,_)}return B!=0&&(v.band=B==2?[Zr(t,i,r,s,E,-1),Zr(t,i,r,s,E,1)]:Zr(t,i,r,s,E,B)),v})}function G1(n){let e=Rt(n.align,1),t=Rt(n.ascDesc,!1),i=Rt(n.alignGaps,0),r=Rt(n.extend,!1);return(s,o,a,l)=>fo(s,o,(c,u,d,f,p,m,x,_,g,b,A)=>{[a,l]=au(d,a,l);let S=c.pxRound,{left:P,width:C}=s.bbox,v=Q=>S(m(Q,f,b,_)),E=Q=>S(x(Q,p,A,g)),k=f.ori==0?ua:ha,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:la},L=N.stroke,B=f.dir*(f.ori==0?1:-1),z=E(d[B==1?a:l]),U=v(u[B==1?a:l]),H=U,Y=U;r&&e==-1&&(Y=P,k(L,Y,z)),k(L,U,z);for(let Q=B==1?a:l;Q>=a&&Q<=l;Q+=B){let re=d[Q];if(re==null)continue;let fe=v(u[Q]),he=E(re);e==1?k(L,fe,z):k(L,H,he),k(L,fe,he),z=he,H=fe}let G=H;r&&e==1&&(G=P+C,k(L,G,z));let[le,J]=up(s,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(L),re=c.fillTo(s,o,c.min,c.max,le),fe=E(re);k(Q,G,fe),k(Q,Y,fe)}if(!c.spanGaps){let Q=[];Q.push(...hp(u,d,a,l,B,v,i));let re=c.width*Dt/2,fe=t||e==1?re:-re,he=t||e==-1?-re:re;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),N.gaps=Q=c.gaps(s,o,a,l,Q),N.clip=hu(Q,f.ori,_,g,b,A)}return J!=0&&(N.band=J==2?[Zr(s,o,a,l,L,-1),Zr(s,o,a,l,L,1)]:Zr(s,o,a,l,L,J)),N})}function p_(n,e,t,i,r,s,o=Wt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Dn(n[l]-n[a]);u<c&&(c=u,o=Dn(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function H1(n){n=n||Dl;let e=Rt(n.size,[.6,Wt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=bt(r),o=1-e[0],a=Rt(e[1],Wt),l=Rt(e[2],1),c=Rt(n.disp,Dl),u=Rt(n.each,p=>{}),{fill:d,stroke:f}=c;return(p,m,x,_)=>fo(p,m,(g,b,A,S,P,C,v,E,k,N,L)=>{let B=g.pxRound,z=t,U=i*Dt,H=a*Dt,Y=l*Dt,G,le;S.ori==0?[G,le]=s(p,m):[le,G]=s(p,m);let J=S.dir*(S.ori==0?1:-1),Q=S.ori==0?pu:fp,re=S.ori==0?u:(Pe,Ke,at,we,Ht,Ge,$e)=>{u(Pe,Ke,at,Ht,we,$e,Ge)},fe=Rt(p.bands,sp).find(Pe=>Pe.series[0]==m),he=fe!=null?fe.dir:0,ee=g.fillTo(p,m,g.min,g.max,he),ge=B(v(ee,P,L,k)),ye,Ce,Me,qe=N,ot=B(g.width*Dt),He=!1,dt=null,ut=null,rt=null,en=null;d!=null&&(ot==0||f!=null)&&(He=!0,dt=d.values(p,m,x,_),ut=new Map,new Set(dt).forEach(Pe=>{Pe!=null&&ut.set(Pe,new Path2D)}),ot>0&&(rt=f.values(p,m,x,_),en=new Map,new Set(rt).forEach(Pe=>{Pe!=null&&en.set(Pe,new Path2D)})));let{x0:Xt,size:yn}=c;if(Xt!=null&&yn!=null){z=1,b=Xt.values(p,m,x,_),Xt.unit==2&&(b=b.map(at=>p.posToVal(E+at*N,S.key,!0)));let Pe=yn.values(p,m,x,_);yn.unit==2?Ce=Pe[0]*N:Ce=C(Pe[0],S,N,E)-C(0,S,N,E),qe=p_(b,A,C,S,N,E,qe),Me=qe-Ce+U}else qe=p_(b,A,C,S,N,E,qe),Me=qe*o+U,Ce=qe-Me;Me<1&&(Me=0),ot>=Ce/2&&(ot=0),Me<5&&(B=M_);let Vt=Me>0,kn=qe-Me-(Vt?ot:0);Ce=B($d(kn,Y,H)),ye=(z==0?Ce/2:z==J?0:Ce)-z*J*((z==0?U/2:0)+(Vt?ot/2:0));let Tt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Cn=He?null:new Path2D,hn=null;if(fe!=null)hn=p.data[fe.series[1]];else{let{y0:Pe,y1:Ke}=c;Pe!=null&&Ke!=null&&(A=Ke.values(p,m,x,_),hn=Pe.values(p,m,x,_))}let xn=G*Ce,O=le*Ce;for(let Pe=J==1?x:_;Pe>=x&&Pe<=_;Pe+=J){let Ke=A[Pe];if(Ke==null)continue;if(hn!=null){let q=hn[Pe]??0;if(Ke-q==0)continue;ge=v(q,P,L,k)}let at=S.distr!=2||c!=null?b[Pe]:Pe,we=C(at,S,N,E),Ht=v(Rt(Ke,ee),P,L,k),Ge=B(we-ye),$e=B(ai(Ht,ge)),R=B(rr(Ht,ge)),M=$e-R;if(Ke!=null){let q=Ke<0?O:xn,ue=Ke<0?xn:O;He?(ot>0&&rt[Pe]!=null&&Q(en.get(rt[Pe]),Ge,R+Ti(ot/2),Ce,ai(0,M-ot),q,ue),dt[Pe]!=null&&Q(ut.get(dt[Pe]),Ge,R+Ti(ot/2),Ce,ai(0,M-ot),q,ue)):Q(Cn,Ge,R+Ti(ot/2),Ce,ai(0,M-ot),q,ue),re(p,m,Pe,Ge-ot/2,R,Ce+ot,M)}}return ot>0?Tt.stroke=He?en:Cn:He||(Tt._fill=g.width==0?g._fill:g._stroke??g._fill,Tt.width=0),Tt.fill=He?ut:Cn,Tt})}function W1(n,e){let t=Rt(e?.alignGaps,0);return(i,r,s,o)=>fo(i,r,(a,l,c,u,d,f,p,m,x,_,g)=>{[s,o]=au(c,s,o);let b=a.pxRound,A=G=>b(f(G,u,_,m)),S=G=>b(p(G,d,g,x)),P,C,v;u.ori==0?(P=fu,v=ua,C=Z_):(P=du,v=ha,C=J_);let E=u.dir*(u.ori==0?1:-1),k=A(l[E==1?s:o]),N=k,L=[],B=[];for(let G=E==1?s:o;G>=s&&G<=o;G+=E)if(c[G]!=null){let J=l[G],Q=A(J);L.push(N=Q),B.push(S(c[G]))}let z={stroke:n(L,B,P,v,C,b),fill:null,clip:null,band:null,gaps:null,flags:la},U=z.stroke,[H,Y]=up(i,r);if(a.fill!=null||H!=0){let G=z.fill=new Path2D(U),le=a.fillTo(i,r,a.min,a.max,H),J=S(le);v(G,N,J),v(G,k,J)}if(!a.spanGaps){let G=[];G.push(...hp(l,c,s,o,E,A,t)),z.gaps=G=a.gaps(i,r,s,o,G),z.clip=hu(G,u.ori,m,x,_,g)}return Y!=0&&(z.band=Y==2?[Zr(i,r,s,o,U,-1),Zr(i,r,s,o,U,1)]:Zr(i,r,s,o,U,Y)),z})}function q1(n){return W1(X1,n)}function X1(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],d[f]=n[f+1]-n[f],c[f]=u[f]/d[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(d[f-1]+d[f])/((2*d[f]+d[f-1])/c[f-1]+(d[f]+2*d[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,n[f]+d[f]/3,e[f]+l[f]*d[f]/3,n[f+1]-d[f]/3,e[f+1]-l[f+1]*d[f]/3,n[f+1],e[f+1])}return a}var Jd=new Set;function m_(){for(let n of Jd)n.syncRect(!0)}ca&&(uo(Ew,ra,m_),uo(Aw,ra,m_,!0),uo(ru,ra,()=>{jt.pxRatio=Dt}));var $1=ev(),Y1=j_();function g_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>jd(s,o,e,t))}function K1(n,e){return n.map((t,i)=>i==0?{}:En({},e,t))}function jd(n,e,t,i){return En({},e==0?t:i,n)}function tv(n,e,t){return e==null?oa:[e,t]}var Z1=tv;function J1(n,e,t){return e==null?oa:su(e,t,ip,!0)}function nv(n,e,t,i){return e==null?oa:lu(e,t,n.scales[i].log,!1)}var j1=nv;function iv(n,e,t,i){return e==null?oa:np(e,t,n.scales[i].log,!1)}var Q1=iv;function eT(n,e,t,i,r){let s=ai(Y0(n),Y0(e)),o=e-n,a=ir(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?Cs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function __(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Ln((t=+r)*Dt))+"px"),[n,e,t]}function tT(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=qt(e[2]*Dt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function jt(n,e,t){let i={mode:Rt(n.mode,1)},r=i.mode;function s(y,w,I,D){let W=w.valToPct(y);return D+I*(w.dir==-1?1-W:W)}function o(y,w,I,D){let W=w.valToPct(y);return D+I*(w.dir==-1?W:1-W)}function a(y,w,I,D){return w.ori==0?s(y,w,I,D):o(y,w,I,D)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Vi(lw);if(n.id!=null&&(c.id=n.id),wi(c,n.class),n.title){let y=Vi(hw,c);y.textContent=n.title}let u=nr("canvas"),d=i.ctx=u.getContext("2d"),f=Vi(fw,c);uo("click",f,y=>{y.target===m&&(Yt!=Ho||tn!=Wo)&&Xn.click(i,y)},!0);let p=i.under=Vi(dw,f);f.appendChild(u);let m=i.over=Vi(pw,f);n=aa(n);let x=+Rt(n.pxAlign,1),_=d_(x);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let g=n.ms||.001,b=i.series=r==1?g_(n.series||[],o_,h_,!1):K1(n.series||[null],u_),A=i.axes=g_(n.axes||[],s_,l_,!0),S=i.scales={},P=i.bands=n.bands||[];P.forEach(y=>{y.fill=bt(y.fill||null),y.dir=Rt(y.dir,-1)});let C=r==2?b[1].facets[0].scale:b[0].scale,v={axes:Xr,series:mt},E=(n.drawOrder||["axes","series"]).map(y=>v[y]);function k(y){let w=y.distr==3?I=>Kr(I>0?I:y.clamp(i,I,y.min,y.max,y.key)):y.distr==4?I=>Bd(I,y.asinh):y.distr==100?I=>y.fwd(I):I=>I;return I=>{let D=w(I),{_min:W,_max:Z}=y,ae=Z-W;return(D-W)/ae}}function N(y){let w=S[y];if(w==null){let I=(n.scales||Dl)[y]||Dl;if(I.from!=null){N(I.from);let D=En({},S[I.from],I,{key:y});D.valToPct=k(D),S[y]=D}else{w=S[y]=En({},y==C?q_:O1,I),w.key=y;let D=w.time,W=w.range,Z=As(W);if((y!=C||r==2&&!D)&&(Z&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?q0:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?q0:{mode:1,hard:W[1],soft:W[1]}},Z=!1),!Z&&uu(W))){let ae=W;W=(de,be,Ne)=>be==null?oa:su(be,Ne,ae)}w.range=bt(W||(D?Z1:y==C?w.distr==3?j1:w.distr==4?Q1:tv:w.distr==3?nv:w.distr==4?iv:J1)),w.auto=bt(Z?!1:w.auto),w.clamp=bt(w.clamp||F1),w._min=w._max=null,w.valToPct=k(w)}}}N("x"),N("y"),r==1&&b.forEach(y=>{N(y.scale)}),A.forEach(y=>{N(y.scale)});for(let y in n.scales)N(y);let L=S[C],B=L.distr,z,U;L.ori==0?(wi(c,cw),z=s,U=o):(wi(c,uw),z=o,U=s);let H={};for(let y in S){let w=S[y];(w.min!=null||w.max!=null)&&(H[y]={min:w.min,max:w.max},w.min=w.max=null)}let Y=n.tzDate||(y=>new Date(Ln(y/g))),G=n.fmtDate||op,le=g==1?c1(Y):f1(Y),J=n_(Y,t_(g==1?l1:h1,G)),Q=r_(Y,i_(p1,G)),re=[],fe=i.legend=En({},_1,n.legend),he=i.cursor=En({},M1,{drag:{y:r==2}},n.cursor),ee=fe.show,ge=he.show,ye=fe.markers;fe.idxs=re,ye.width=bt(ye.width),ye.dash=bt(ye.dash),ye.stroke=bt(ye.stroke),ye.fill=bt(ye.fill);let Ce,Me,qe,ot=[],He=[],dt,ut=!1,rt={};if(fe.live){let y=b[1]?b[1].values:null;ut=y!=null,dt=ut?y(i,1,0):{_:0};for(let w in dt)rt[w]=ep}if(ee)if(Ce=nr("table",xw,c),qe=nr("tbody",null,Ce),fe.mount(i,Ce),ut){Me=nr("thead",null,Ce,qe);let y=nr("tr",null,Me);nr("th",null,y);for(var en in dt)nr("th",L0,y).textContent=en}else wi(Ce,Sw),fe.live&&wi(Ce,bw);let Xt={show:!0},yn={show:!1};function Vt(y,w){if(w==0&&(ut||!fe.live||r==2))return oa;let I=[],D=nr("tr",Mw,qe,qe.childNodes[w]);wi(D,y.class),y.show||wi(D,co);let W=nr("th",null,D);if(ye.show){let de=Vi(ww,W);if(w>0){let be=ye.width(i,w);be&&(de.style.border=be+"px "+ye.dash(i,w)+" "+ye.stroke(i,w)),de.style.background=ye.fill(i,w)}}let Z=Vi(L0,W);y.label instanceof HTMLElement?Z.appendChild(y.label):Z.textContent=y.label,w>0&&(ye.show||(Z.style.color=y.width>0?ye.stroke(i,w):ye.fill(i,w)),Tt("click",W,de=>{if(he._lock)return;Je(de);let be=b.indexOf(y);if((de.ctrlKey||de.metaKey)!=fe.isolate){let Ne=b.some((Ue,Oe)=>Oe>0&&Oe!=be&&Ue.show);b.forEach((Ue,Oe)=>{Oe>0&&xr(Oe,Ne?Oe==be?Xt:yn:Xt,!0,wn.setSeries)})}else xr(be,{show:!y.show},!0,wn.setSeries)},!1),je&&Tt(F0,W,de=>{he._lock||(Je(de),xr(b.indexOf(y),Xo,!0,wn.setSeries))},!1));for(var ae in dt){let de=nr("td",Tw,D);de.textContent="--",I.push(de)}return[D,I]}let kn=new Map;function Tt(y,w,I,D=!0){let W=kn.get(w)||{},Z=he.bind[y](i,w,I,D);Z&&(uo(y,w,W[y]=Z),kn.set(w,W))}function Cn(y,w,I){let D=kn.get(w)||{};for(let W in D)(y==null||W==y)&&(Xd(W,w,D[W]),delete D[W]);y==null&&kn.delete(w)}let hn=0,xn=0,O=0,Pe=0,Ke=0,at=0,we=Ke,Ht=at,Ge=O,$e=Pe,R=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,ve=!1,xe=!1,te=!1,ie=!1,me=!1;function F(y,w,I){(I||y!=i.width||w!=i.height)&&se(y,w),ht(!1),xe=!0,ve=!0,Kn()}function se(y,w){i.width=hn=O=y,i.height=xn=Pe=w,Ke=at=0,Se(),We();let I=i.bbox;R=I.left=ao(Ke*Dt,.5),M=I.top=ao(at*Dt,.5),q=I.width=ao(O*Dt,.5),ue=I.height=ao(Pe*Dt,.5)}let ne=3;function Te(){let y=!1,w=0;for(;!y;){w++;let I=zo(w),D=yr(w);y=w==ne||I&&D,y||(se(i.width,i.height),ve=!0)}}function _e({width:y,height:w}){F(y,w)}i.setSize=_e;function Se(){let y=!1,w=!1,I=!1,D=!1;A.forEach((W,Z)=>{if(W.show&&W._show){let{side:ae,_size:de}=W,be=ae%2,Ne=W.label!=null?W.labelSize:0,Ue=de+Ne;Ue>0&&(be?(O-=Ue,ae==3?(Ke+=Ue,D=!0):I=!0):(Pe-=Ue,ae==0?(at+=Ue,y=!0):w=!0))}}),_r[0]=y,_r[1]=I,_r[2]=w,_r[3]=D,O-=Zi[1]+Zi[3],Ke+=Zi[3],Pe-=Zi[2]+Zi[0],at+=Zi[0]}function We(){let y=Ke+O,w=at+Pe,I=Ke,D=at;function W(Z,ae){switch(Z){case 1:return y+=ae,y-ae;case 2:return w+=ae,w-ae;case 3:return I-=ae,I+ae;case 0:return D-=ae,D+ae}}A.forEach((Z,ae)=>{if(Z.show&&Z._show){let de=Z.side;Z._pos=W(de,Z._size),Z.label!=null&&(Z._lpos=W(de,Z.labelSize))}})}if(he.dataIdx==null){let y=he.hover,w=y.skip=new Set(y.skip??[]);w.add(void 0);let I=y.prox=bt(y.prox),D=y.bias??=0;he.dataIdx=(W,Z,ae,de)=>{if(Z==0)return ae;let be=ae,Ne=I(W,Z,ae,de)??Wt,Ue=Ne>=0&&Ne<Wt,Oe=L.ori==0?O:Pe,st=he.left,It=e[0],At=e[Z];if(w.has(At[ae])){be=null;let vt=null,Ze=null,Xe;if(D==0||D==-1)for(Xe=ae;vt==null&&Xe-- >0;)w.has(At[Xe])||(vt=Xe);if(D==0||D==1)for(Xe=ae;Ze==null&&Xe++<At.length;)w.has(At[Xe])||(Ze=Xe);if(vt!=null||Ze!=null)if(Ue){let Zt=vt==null?-1/0:z(It[vt],L,Oe,0),pn=Ze==null?1/0:z(It[Ze],L,Oe,0),Gn=st-Zt,Gt=pn-st;Gn<=Gt?Gn<=Ne&&(be=vt):Gt<=Ne&&(be=Ze)}else be=Ze==null?vt:vt==null?Ze:ae-vt<=Ze-ae?vt:Ze}else Ue&&Dn(st-z(It[ae],L,Oe,0))>Ne&&(be=null);return be}}let Je=y=>{he.event=y};he.idxs=re,he._lock=!1;let ce=he.points;ce.show=bt(ce.show),ce.size=bt(ce.size),ce.stroke=bt(ce.stroke),ce.width=bt(ce.width),ce.fill=bt(ce.fill);let ke=i.focus=En({},n.focus||{alpha:.3},he.focus),je=ke.prox>=0,Re=je&&ce.one,ct=[],$t=[],ti=[];function cl(y,w){let I=ce.show(i,w);if(I instanceof HTMLElement)return wi(I,yw),wi(I,y.class),Cr(I,-10,-10,O,Pe),m.insertBefore(I,ct[w]),I}function Oo(y,w){if(r==1||w>0){let I=r==1&&S[y.scale].time,D=y.value;y.value=I?J0(D)?r_(Y,i_(D,G)):D||Q:D||D1,y.label=y.label||(I?T1:w1)}if(Re||w>0){y.width=y.width==null?1:y.width,y.paths=y.paths||$1||Ow,y.fillTo=bt(y.fillTo||k1),y.pxAlign=+Rt(y.pxAlign,x),y.pxRound=d_(y.pxAlign),y.stroke=bt(y.stroke||null),y.fill=bt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let I=N1(ai(1,y.width),1),D=y.points=En({},{size:I,width:ai(1,I*.2),stroke:y.stroke,space:I*2,paths:Y1,_stroke:null,_fill:null},y.points);D.show=bt(D.show),D.filter=bt(D.filter),D.fill=bt(D.fill),D.stroke=bt(D.stroke),D.paths=bt(D.paths),D.pxAlign=y.pxAlign}if(ee){let I=Vt(y,w);ot.splice(w,0,I[0]),He.splice(w,0,I[1]),fe.values.push(null)}if(ge){re.splice(w,0,null);let I=null;Re?w==0&&(I=cl(y,w)):w>0&&(I=cl(y,w)),ct.splice(w,0,I),$t.splice(w,0,0),ti.splice(w,0,0)}Vn("addSeries",w)}function ld(y,w){w=w??b.length,y=r==1?jd(y,w,o_,h_):jd(y,w,{},u_),b.splice(w,0,y),Oo(b[w],w)}i.addSeries=ld;function Uc(y){if(b.splice(y,1),ee){fe.values.splice(y,1),He.splice(y,1);let w=ot.splice(y,1)[0];Cn(null,w.firstChild),w.remove()}ge&&(re.splice(y,1),ct.splice(y,1)[0].remove(),$t.splice(y,1),ti.splice(y,1)),Vn("delSeries",y)}i.delSeries=Uc;let _r=[!1,!1,!1,!1];function Hr(y,w){if(y._show=y.show,y.show){let I=y.side%2,D=S[y.scale];D==null&&(y.scale=I?b[1].scale:C,D=S[y.scale]);let W=D.time;y.size=bt(y.size),y.space=bt(y.space),y.rotate=bt(y.rotate),As(y.incrs)&&y.incrs.forEach(ae=>{!Cs.has(ae)&&Cs.set(ae,E_(ae))}),y.incrs=bt(y.incrs||(D.distr==2?s1:W?g==1?a1:u1:lo)),y.splits=bt(y.splits||(W&&D.distr==1?le:D.distr==3?Yd:D.distr==4?C1:A1)),y.stroke=bt(y.stroke),y.grid.stroke=bt(y.grid.stroke),y.ticks.stroke=bt(y.ticks.stroke),y.border.stroke=bt(y.border.stroke);let Z=y.values;y.values=As(Z)&&!As(Z[0])?bt(Z):W?As(Z)?n_(Y,t_(Z,G)):J0(Z)?d1(Y,Z):Z||J:Z||E1,y.filter=bt(y.filter||(D.distr>=3&&D.log==10?I1:D.distr==3&&D.log==2?L1:w_)),y.font=__(y.font),y.labelFont=__(y.labelFont),y._size=y.size(i,null,w,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(_r[w]=!0,y._el=Vi(mw,f))}}function Wr(y,w,I,D){let[W,Z,ae,de]=I,be=w%2,Ne=0;return be==0&&(de||Z)&&(Ne=w==0&&!W||w==2&&!ae?Ln(s_.size/3):0),be==1&&(W||ae)&&(Ne=w==1&&!Z||w==3&&!de?Ln(l_.size/2):0),Ne}let ul=i.padding=(n.padding||[Wr,Wr,Wr,Wr]).map(y=>bt(Rt(y,Wr))),Zi=i._padding=ul.map((y,w)=>y(i,w,_r,0)),fn,gn=null,_n=null,vr=r==1?b[0].idxs:null,xi=null,gs=!1;function hl(y,w){if(e=y??[],i.data=i._data=e,r==2){fn=0;for(let I=1;I<b.length;I++)fn+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),xi=e[0],fn=xi.length;let I=e;if(B==2){I=e.slice();let D=I[0]=Array(fn);for(let W=0;W<fn;W++)D[W]=W}i._data=e=I}if(ht(!0),Vn("setData"),B==2&&(xe=!0),w!==!1){let I=L;I.auto(i,gs)?fl():ys(C,I.min,I.max),te=te||he.left>=0,me=!0,Kn()}}i.setData=hl;function fl(){gs=!0;let y,w;r==1&&(fn>0?(gn=vr[0]=0,_n=vr[1]=fn-1,y=e[0][gn],w=e[0][_n],B==2?(y=gn,w=_n):y==w&&(B==3?[y,w]=lu(y,y,L.log,!1):B==4?[y,w]=np(y,y,L.log,!1):L.time?w=y+Ln(86400/g):[y,w]=su(y,w,ip,!0))):(gn=vr[0]=y=null,_n=vr[1]=w=null)),ys(C,y,w)}let ko,_s,Bo,T,V,j,X,$,Ee,Ie;function Ae(y,w,I,D,W,Z){y??=N0,I??=sp,D??="butt",W??=N0,Z??="round",y!=ko&&(d.strokeStyle=ko=y),W!=_s&&(d.fillStyle=_s=W),w!=Bo&&(d.lineWidth=Bo=w),Z!=V&&(d.lineJoin=V=Z),D!=j&&(d.lineCap=j=D),I!=T&&d.setLineDash(T=I)}function Le(y,w,I,D){w!=_s&&(d.fillStyle=_s=w),y!=X&&(d.font=X=y),I!=$&&(d.textAlign=$=I),D!=Ee&&(d.textBaseline=Ee=D)}function Ve(y,w,I,D,W=0){if(D.length>0&&y.auto(i,gs)&&(w==null||w.min==null)){let Z=Rt(gn,0),ae=Rt(_n,D.length-1),de=I.min==null?Iw(D,Z,ae,W,y.distr==3):[I.min,I.max];y.min=rr(y.min,I.min=de[0]),y.max=ai(y.max,I.max=de[1])}}let Qe={min:null,max:null};function pt(){for(let D in S){let W=S[D];H[D]==null&&(W.min==null||H[C]!=null&&W.auto(i,gs))&&(H[D]=Qe)}for(let D in S){let W=S[D];H[D]==null&&W.from!=null&&H[W.from]!=null&&(H[D]=Qe)}H[C]!=null&&ht(!0);let y={};for(let D in H){let W=H[D];if(W!=null){let Z=y[D]=aa(S[D],zw);if(W.min!=null)En(Z,W);else if(D!=C||r==2)if(fn==0&&Z.from==null){let ae=Z.range(i,null,null,D);Z.min=ae[0],Z.max=ae[1]}else Z.min=Wt,Z.max=-Wt}}if(fn>0){b.forEach((D,W)=>{if(r==1){let Z=D.scale,ae=H[Z];if(ae==null)return;let de=y[Z];if(W==0){let be=de.range(i,de.min,de.max,Z);de.min=be[0],de.max=be[1],gn=ir(de.min,e[0]),_n=ir(de.max,e[0]),_n-gn>1&&(e[0][gn]<de.min&&gn++,e[0][_n]>de.max&&_n--),D.min=xi[gn],D.max=xi[_n]}else D.show&&D.auto&&Ve(de,ae,D,e[W],D.sorted);D.idxs[0]=gn,D.idxs[1]=_n}else if(W>0&&D.show&&D.auto){let[Z,ae]=D.facets,de=Z.scale,be=ae.scale,[Ne,Ue]=e[W],Oe=y[de],st=y[be];Oe!=null&&Ve(Oe,H[de],Z,Ne,Z.sorted),st!=null&&Ve(st,H[be],ae,Ue,ae.sorted),D.min=ae.min,D.max=ae.max}});for(let D in y){let W=y[D],Z=H[D];if(W.from==null&&(Z==null||Z.min==null)){let ae=W.range(i,W.min==Wt?null:W.min,W.max==-Wt?null:W.max,D);W.min=ae[0],W.max=ae[1]}}}for(let D in y){let W=y[D];if(W.from!=null){let Z=y[W.from];if(Z.min==null)W.min=W.max=null;else{let ae=W.range(i,Z.min,Z.max,D);W.min=ae[0],W.max=ae[1]}}}let w={},I=!1;for(let D in y){let W=y[D],Z=S[D];if(Z.min!=W.min||Z.max!=W.max){Z.min=W.min,Z.max=W.max;let ae=Z.distr;Z._min=ae==3?Kr(Z.min):ae==4?Bd(Z.min,Z.asinh):ae==100?Z.fwd(Z.min):Z.min,Z._max=ae==3?Kr(Z.max):ae==4?Bd(Z.max,Z.asinh):ae==100?Z.fwd(Z.max):Z.max,w[D]=I=!0}}if(I){b.forEach((D,W)=>{r==2?W>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)xe=!0,Vn("setScale",D);ge&&he.left>=0&&(te=me=!0)}for(let D in H)H[D]=null}function Be(y){let w=$d(gn-1,0,fn-1),I=$d(_n+1,0,fn-1);for(;y[w]==null&&w>0;)w--;for(;y[I]==null&&I<fn-1;)I++;return[w,I]}function mt(){if(fn>0){let y=b.some(w=>w._focus)&&Ie!=ke.alpha;y&&(d.globalAlpha=Ie=ke.alpha),b.forEach((w,I)=>{if(I>0&&w.show&&(sn(I,!1),sn(I,!0),w._paths==null)){let D=Ie;Ie!=w.alpha&&(d.globalAlpha=Ie=w.alpha);let W=r==2?[0,e[I][0].length-1]:Be(e[I]);w._paths=w.paths(i,I,W[0],W[1]),Ie!=D&&(d.globalAlpha=Ie=D)}}),b.forEach((w,I)=>{if(I>0&&w.show){let D=Ie;Ie!=w.alpha&&(d.globalAlpha=Ie=w.alpha),w._paths!=null&&kt(I,!1);{let W=w._paths!=null?w._paths.gaps:null,Z=w.points.show(i,I,gn,_n,W),ae=w.points.filter(i,I,Z,W);(Z||ae)&&(w.points._paths=w.points.paths(i,I,gn,_n,ae),kt(I,!0))}Ie!=D&&(d.globalAlpha=Ie=D),Vn("drawSeries",I)}}),y&&(d.globalAlpha=Ie=1)}}function sn(y,w){let I=w?b[y].points:b[y];I._stroke=I.stroke(i,y),I._fill=I.fill(i,y)}function kt(y,w){let I=w?b[y].points:b[y],{stroke:D,fill:W,clip:Z,flags:ae,_stroke:de=I._stroke,_fill:be=I._fill,_width:Ne=I.width}=I._paths;Ne=qt(Ne*Dt,3);let Ue=null,Oe=Ne%2/2;w&&be==null&&(be=Ne>0?"#fff":de);let st=I.pxAlign==1&&Oe>0;if(st&&d.translate(Oe,Oe),!w){let It=R-Ne/2,At=M-Ne/2,vt=q+Ne,Ze=ue+Ne;Ue=new Path2D,Ue.rect(It,At,vt,Ze)}w?Fe(de,Ne,I.dash,I.cap,be,D,W,ae,Z):Bt(y,de,Ne,I.dash,I.cap,be,D,W,ae,Ue,Z),st&&d.translate(-Oe,-Oe)}function Bt(y,w,I,D,W,Z,ae,de,be,Ne,Ue){let Oe=!1;be!=0&&P.forEach((st,It)=>{if(st.series[0]==y){let At=b[st.series[1]],vt=e[st.series[1]],Ze=(At._paths||Dl).band;As(Ze)&&(Ze=st.dir==1?Ze[0]:Ze[1]);let Xe,Zt=null;At.show&&Ze&&Dw(vt,gn,_n)?(Zt=st.fill(i,It)||Z,Xe=At._paths.clip):Ze=null,Fe(w,I,D,W,Zt,ae,de,be,Ne,Ue,Xe,Ze),Oe=!0}}),Oe||Fe(w,I,D,W,Z,ae,de,be,Ne,Ue)}let Rn=la|Zd;function Fe(y,w,I,D,W,Z,ae,de,be,Ne,Ue,Oe){Ae(y,w,I,D,W),(be||Ne||Oe)&&(d.save(),be&&d.clip(be),Ne&&d.clip(Ne)),Oe?(de&Rn)==Rn?(d.clip(Oe),Ue&&d.clip(Ue),yt(W,ae),bn(y,Z,w)):de&Zd?(yt(W,ae),d.clip(Oe),bn(y,Z,w)):de&la&&(d.save(),d.clip(Oe),Ue&&d.clip(Ue),yt(W,ae),d.restore(),bn(y,Z,w)):(yt(W,ae),bn(y,Z,w)),(be||Ne||Oe)&&d.restore()}function bn(y,w,I){I>0&&(w instanceof Map?w.forEach((D,W)=>{d.strokeStyle=ko=W,d.stroke(D)}):w!=null&&y&&d.stroke(w))}function yt(y,w){w instanceof Map?w.forEach((I,D)=>{d.fillStyle=_s=D,d.fill(I)}):w!=null&&y&&d.fill(w)}function qr(y,w,I,D){let W=A[y],Z;if(D<=0)Z=[0,0];else{let ae=W._space=W.space(i,y,w,I,D),de=W._incrs=W.incrs(i,y,w,I,D,ae);Z=eT(w,I,de,D,ae)}return W._found=Z}function Sn(y,w,I,D,W,Z,ae,de,be,Ne){let Ue=ae%2/2;x==1&&d.translate(Ue,Ue),Ae(de,ae,be,Ne,de),d.beginPath();let Oe,st,It,At,vt=W+(D==0||D==3?-Z:Z);I==0?(st=W,At=vt):(Oe=W,It=vt);for(let Ze=0;Ze<y.length;Ze++)w[Ze]!=null&&(I==0?Oe=It=y[Ze]:st=At=y[Ze],d.moveTo(Oe,st),d.lineTo(It,At));d.stroke(),x==1&&d.translate(-Ue,-Ue)}function zo(y){let w=!0;return A.forEach((I,D)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,ht(!1));return}else I._show||(w=!1,I._show=!0,ht(!1));let Z=I.side,ae=Z%2,{min:de,max:be}=W,[Ne,Ue]=qr(D,de,be,ae==0?O:Pe);if(Ue==0)return;let Oe=W.distr==2,st=I._splits=I.splits(i,D,de,be,Ne,Ue,Oe),It=W.distr==2?st.map(Xe=>xi[Xe]):st,At=W.distr==2?xi[st[1]]-xi[st[0]]:Ne,vt=I._values=I.values(i,I.filter(i,It,D,Ue,At),D,Ue,At);I._rotate=Z==2?I.rotate(i,vt,D,Ue):0;let Ze=I._size;I._size=Gi(I.size(i,vt,D,y)),Ze!=null&&I._size!=Ze&&(w=!1)}),w}function yr(y){let w=!0;return ul.forEach((I,D)=>{let W=I(i,D,_r,y);W!=Zi[D]&&(w=!1),Zi[D]=W}),w}function Xr(){for(let y=0;y<A.length;y++){let w=A[y];if(!w.show||!w._show)continue;let I=w.side,D=I%2,W,Z,ae=w.stroke(i,y),de=I==0||I==3?-1:1,[be,Ne]=w._found;if(w.label!=null){let ri=w.labelGap*de,Mi=Ln((w._lpos+ri)*Dt);Le(w.labelFont[0],ae,"center",I==2?"top":D0),d.save(),D==1?(W=Z=0,d.translate(Mi,Ln(M+ue/2)),d.rotate((I==3?-iu:iu)/2)):(W=Ln(R+q/2),Z=Mi);let no=S_(w.label)?w.label(i,y,be,Ne):w.label;d.fillText(no,W,Z),d.restore()}if(Ne==0)continue;let Ue=S[w.scale],Oe=D==0?q:ue,st=D==0?R:M,It=w._splits,At=Ue.distr==2?It.map(ri=>xi[ri]):It,vt=Ue.distr==2?xi[It[1]]-xi[It[0]]:be,Ze=w.ticks,Xe=w.border,Zt=Ze.show?Ze.size:0,pn=Ln(Zt*Dt),Gn=Ln((w.alignTo==2?w._size-Zt-w.gap:w.gap)*Dt),Gt=w._rotate*-iu/180,mn=_(w._pos*Dt),bi=(pn+Gn)*de,ii=mn+bi;Z=D==0?ii:0,W=D==1?ii:0;let Bi=w.font[0],Ji=w.align==1?na:w.align==2?Fd:Gt>0?na:Gt<0?Fd:D==0?"center":I==3?Fd:na,Sr=Gt||D==1?"middle":I==2?"top":D0;Le(Bi,ae,Ji,Sr);let Si=w.font[1]*w.lineGap,zi=It.map(ri=>_(a(ri,Ue,Oe,st))),ji=w._values;for(let ri=0;ri<ji.length;ri++){let Mi=ji[ri];if(Mi!=null){D==0?W=zi[ri]:Z=zi[ri],Mi=""+Mi;let no=Mi.indexOf(`
`)==-1?[Mi]:Mi.split(/\n/gm);for(let si=0;si<no.length;si++){let Kg=no[si];Gt?(d.save(),d.translate(W,Z+si*Si),d.rotate(Gt),d.fillText(Kg,0,0),d.restore()):d.fillText(Kg,W,Z+si*Si)}}}Ze.show&&Sn(zi,Ze.filter(i,At,y,Ne,vt),D,I,mn,pn,qt(Ze.width*Dt,3),Ze.stroke(i,y),Ze.dash,Ze.cap);let Mr=w.grid;Mr.show&&Sn(zi,Mr.filter(i,At,y,Ne,vt),D,D==0?2:1,D==0?M:R,D==0?ue:q,qt(Mr.width*Dt,3),Mr.stroke(i,y),Mr.dash,Mr.cap),Xe.show&&Sn([mn],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:q,qt(Xe.width*Dt,3),Xe.stroke(i,y),Xe.dash,Xe.cap)}Vn("drawAxes")}function ht(y){b.forEach((w,I)=>{I>0&&(w._paths=null,y&&(r==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let dn=!1,ni=!1,zt=[];function Mn(){ni=!1;for(let y=0;y<zt.length;y++)Vn(...zt[y]);zt.length=0}function Kn(){dn||($w(Ig),dn=!0)}function Fc(y,w=!1){dn=!0,ni=w,y(i),Ig(),w&&zt.length>0&&queueMicrotask(Mn)}i.batch=Fc;function Ig(){if(oe&&(pt(),oe=!1),xe&&(Te(),xe=!1),ve){if(Jt(p,na,Ke),Jt(p,"top",at),Jt(p,Rl,O),Jt(p,Pl,Pe),Jt(m,na,Ke),Jt(m,"top",at),Jt(m,Rl,O),Jt(m,Pl,Pe),Jt(f,Rl,hn),Jt(f,Pl,xn),u.width=Ln(hn*Dt),u.height=Ln(xn*Dt),A.forEach(({_el:y,_show:w,_size:I,_pos:D,side:W})=>{if(y!=null)if(w){let Z=W===3||W===0?I:0,ae=W%2==1;Jt(y,ae?"left":"top",D-Z),Jt(y,ae?"width":"height",I),Jt(y,ae?"top":"left",ae?at:Ke),Jt(y,ae?"height":"width",ae?Pe:O),qd(y,co)}else wi(y,co)}),ko=_s=Bo=V=j=X=$=Ee=T=null,Ie=1,ml(!0),Ke!=we||at!=Ht||O!=Ge||Pe!=$e){ht(!1);let y=O/Ge,w=Pe/$e;if(ge&&!te&&he.left>=0){he.left*=y,he.top*=w,Vo&&Cr(Vo,Ln(he.left),0,O,Pe),Go&&Cr(Go,0,Ln(he.top),O,Pe);for(let I=0;I<ct.length;I++){let D=ct[I];D!=null&&($t[I]*=y,ti[I]*=w,Cr(D,Gi($t[I]),Gi(ti[I]),O,Pe))}}if(Kt.show&&!ie&&Kt.left>=0&&Kt.width>0){Kt.left*=y,Kt.width*=y,Kt.top*=w,Kt.height*=w;for(let I in pd)Jt(qo,I,Kt[I])}we=Ke,Ht=at,Ge=O,$e=Pe}Vn("setSize"),ve=!1}hn>0&&xn>0&&(d.clearRect(0,0,u.width,u.height),Vn("drawClear"),E.forEach(y=>y()),Vn("draw")),Kt.show&&ie&&(Oc(Kt),ie=!1),ge&&te&&(to(null,!0,!1),te=!1),fe.show&&fe.live&&me&&(fd(),me=!1),l||(l=!0,i.status=1,Vn("ready")),gs=!1,dn=!1}i.redraw=(y,w)=>{xe=w||!1,y!==!1?ys(C,L.min,L.max):Kn()};function cd(y,w){let I=S[y];if(I.from==null){if(fn==0){let D=I.range(i,w.min,w.max,y);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(fn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;y==C&&I.distr==2&&fn>0&&(w.min=ir(w.min,e[0]),w.max=ir(w.max,e[0]),w.min==w.max&&w.max++),H[y]=w,oe=!0,Kn()}}i.setScale=cd;let ud,hd,Vo,Go,Lg,Dg,Ho,Wo,Ng,Ug,Yt,tn,vs=!1,Xn=he.drag,Bn=Xn.x,zn=Xn.y;ge&&(he.x&&(ud=Vi(_w,m)),he.y&&(hd=Vi(vw,m)),L.ori==0?(Vo=ud,Go=hd):(Vo=hd,Go=ud),Yt=he.left,tn=he.top);let Kt=i.select=En({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),qo=Kt.show?Vi(gw,Kt.over?m:p):null;function Oc(y,w){if(Kt.show){for(let I in y)Kt[I]=y[I],I in pd&&Jt(qo,I,y[I]);w!==!1&&Vn("setSelect")}}i.setSelect=Oc;function pM(y){if(b[y].show)ee&&qd(ot[y],co);else if(ee&&wi(ot[y],co),ge){let I=Re?ct[0]:ct[y];I!=null&&Cr(I,-10,-10,O,Pe)}}function ys(y,w,I){cd(y,{min:w,max:I})}function xr(y,w,I,D){w.focus!=null&&yM(y),w.show!=null&&b.forEach((W,Z)=>{Z>0&&(y==Z||y==null)&&(W.show=w.show,pM(Z),r==2?(ys(W.facets[0].scale,null,null),ys(W.facets[1].scale,null,null)):ys(W.scale,null,null),Kn())}),I!==!1&&Vn("setSeries",y,w),D&&gl("setSeries",i,y,w)}i.setSeries=xr;function mM(y,w){En(P[y],w)}function gM(y,w){y.fill=bt(y.fill||null),y.dir=Rt(y.dir,-1),w=w??P.length,P.splice(w,0,y)}function _M(y){y==null?P.length=0:P.splice(y,1)}i.addBand=gM,i.setBand=mM,i.delBand=_M;function vM(y,w){b[y].alpha=w,ge&&ct[y]!=null&&(ct[y].style.opacity=w),ee&&ot[y]&&(ot[y].style.opacity=w)}let $r,xs,eo,Xo={focus:!0};function yM(y){if(y!=eo){let w=y==null,I=ke.alpha!=1;b.forEach((D,W)=>{if(r==1||W>0){let Z=w||W==0||W==y;D._focus=w?null:Z,I&&vM(W,Z?1:ke.alpha)}}),eo=y,I&&Kn()}}ee&&je&&Tt(O0,Ce,y=>{he._lock||(Je(y),eo!=null&&xr(null,Xo,!0,wn.setSeries))});function br(y,w,I){let D=S[w];I&&(y=y/Dt-(D.ori==1?at:Ke));let W=O;D.ori==1&&(W=Pe,y=W-y),D.dir==-1&&(y=W-y);let Z=D._min,ae=D._max,de=y/W,be=Z+(ae-Z)*de,Ne=D.distr;return Ne==3?sa(10,be):Ne==4?Uw(be,D.asinh):Ne==100?D.bwd(be):be}function xM(y,w){let I=br(y,C,w);return ir(I,e[0],gn,_n)}i.valToIdx=y=>ir(y,e[0]),i.posToIdx=xM,i.posToVal=br,i.valToPos=(y,w,I)=>S[w].ori==0?s(y,S[w],I?q:O,I?R:0):o(y,S[w],I?ue:Pe,I?M:0),i.setCursor=(y,w,I)=>{Yt=y.left,tn=y.top,to(null,w,I)};function Fg(y,w){Jt(qo,na,Kt.left=y),Jt(qo,Rl,Kt.width=w)}function Og(y,w){Jt(qo,"top",Kt.top=y),Jt(qo,Pl,Kt.height=w)}let dl=L.ori==0?Fg:Og,pl=L.ori==1?Fg:Og;function bM(){if(ee&&fe.live)for(let y=r==2?1:0;y<b.length;y++){if(y==0&&ut)continue;let w=fe.values[y],I=0;for(let D in w)He[y][I++].firstChild.nodeValue=w[D]}}function fd(y,w){if(y!=null&&(y.idxs?y.idxs.forEach((I,D)=>{re[D]=I}):Bw(y.idx)||re.fill(y.idx),fe.idx=re[0]),ee&&fe.live){for(let I=0;I<b.length;I++)(I>0||r==1&&!ut)&&SM(I,re[I]);bM()}me=!1,w!==!1&&Vn("setLegend")}i.setLegend=fd;function SM(y,w){let I=b[y],D=y==0&&B==2?xi:e[y],W;ut?W=I.values(i,y,w)??rt:(W=I.value(i,w==null?null:D[w],y,w),W=W==null?rt:{_:W}),fe.values[y]=W}function to(y,w,I){Ng=Yt,Ug=tn,[Yt,tn]=he.move(i,Yt,tn),he.left=Yt,he.top=tn,ge&&(Vo&&Cr(Vo,Ln(Yt),0,O,Pe),Go&&Cr(Go,0,Ln(tn),O,Pe));let D,W=gn>_n;$r=Wt,xs=null;let Z=L.ori==0?O:Pe,ae=L.ori==1?O:Pe;if(Yt<0||fn==0||W){D=he.idx=null;for(let de=0;de<b.length;de++){let be=ct[de];be!=null&&Cr(be,-10,-10,O,Pe)}je&&xr(null,Xo,!0,y==null&&wn.setSeries),fe.live&&(re.fill(D),me=!0)}else{let de,be,Ne;r==1&&(de=L.ori==0?Yt:tn,be=br(de,C),D=he.idx=ir(be,e[0],gn,_n),Ne=z(e[0][D],L,Z,0));let Ue=-10,Oe=-10,st=0,It=0,At=!0,vt="",Ze="";for(let Xe=r==2?1:0;Xe<b.length;Xe++){let Zt=b[Xe],pn=re[Xe],Gn=pn==null?null:r==1?e[Xe][pn]:e[Xe][1][pn],Gt=he.dataIdx(i,Xe,D,be),mn=Gt==null?null:r==1?e[Xe][Gt]:e[Xe][1][Gt];if(me=me||mn!=Gn||Gt!=pn,re[Xe]=Gt,Xe>0&&Zt.show){let bi=Gt==null?-10:Gt==D?Ne:z(r==1?e[0][Gt]:e[Xe][0][Gt],L,Z,0),ii=mn==null?-10:U(mn,r==1?S[Zt.scale]:S[Zt.facets[1].scale],ae,0);if(je&&mn!=null){let Bi=L.ori==1?Yt:tn,Ji=Dn(ke.dist(i,Xe,Gt,ii,Bi));if(Ji<$r){let Sr=ke.bias;if(Sr!=0){let Si=br(Bi,Zt.scale),zi=mn>=0?1:-1,ji=Si>=0?1:-1;ji==zi&&(ji==1?Sr==1?mn>=Si:mn<=Si:Sr==1?mn<=Si:mn>=Si)&&($r=Ji,xs=Xe)}else $r=Ji,xs=Xe}}if(me||Re){let Bi,Ji;L.ori==0?(Bi=bi,Ji=ii):(Bi=ii,Ji=bi);let Sr,Si,zi,ji,Mr,ri,Mi=!0,no=ce.bbox;if(no!=null){Mi=!1;let si=no(i,Xe);zi=si.left,ji=si.top,Sr=si.width,Si=si.height}else zi=Bi,ji=Ji,Sr=Si=ce.size(i,Xe);if(ri=ce.fill(i,Xe),Mr=ce.stroke(i,Xe),Re)Xe==xs&&$r<=ke.prox&&(Ue=zi,Oe=ji,st=Sr,It=Si,At=Mi,vt=ri,Ze=Mr);else{let si=ct[Xe];si!=null&&($t[Xe]=zi,ti[Xe]=ji,W0(si,Sr,Si,Mi),G0(si,ri,Mr),Cr(si,Gi(zi),Gi(ji),O,Pe))}}}}if(Re){let Xe=ke.prox,Zt=eo==null?$r<=Xe:$r>Xe||xs!=eo;if(me||Zt){let pn=ct[0];pn!=null&&($t[0]=Ue,ti[0]=Oe,W0(pn,st,It,At),G0(pn,vt,Ze),Cr(pn,Gi(Ue),Gi(Oe),O,Pe))}}}if(Kt.show&&vs)if(y!=null){let[de,be]=wn.scales,[Ne,Ue]=wn.match,[Oe,st]=y.cursor.sync.scales,It=y.cursor.drag;if(Bn=It._x,zn=It._y,Bn||zn){let{left:At,top:vt,width:Ze,height:Xe}=y.select,Zt=y.scales[Oe].ori,pn=y.posToVal,Gn,Gt,mn,bi,ii,Bi=de!=null&&Ne(de,Oe),Ji=be!=null&&Ue(be,st);Bi&&Bn?(Zt==0?(Gn=At,Gt=Ze):(Gn=vt,Gt=Xe),mn=S[de],bi=z(pn(Gn,Oe),mn,Z,0),ii=z(pn(Gn+Gt,Oe),mn,Z,0),dl(rr(bi,ii),Dn(ii-bi))):dl(0,Z),Ji&&zn?(Zt==1?(Gn=At,Gt=Ze):(Gn=vt,Gt=Xe),mn=S[be],bi=U(pn(Gn,st),mn,ae,0),ii=U(pn(Gn+Gt,st),mn,ae,0),pl(rr(bi,ii),Dn(ii-bi))):pl(0,ae)}else md()}else{let de=Dn(Ng-Lg),be=Dn(Ug-Dg);if(L.ori==1){let st=de;de=be,be=st}Bn=Xn.x&&de>=Xn.dist,zn=Xn.y&&be>=Xn.dist;let Ne=Xn.uni;Ne!=null?Bn&&zn&&(Bn=de>=Ne,zn=be>=Ne,!Bn&&!zn&&(be>de?zn=!0:Bn=!0)):Xn.x&&Xn.y&&(Bn||zn)&&(Bn=zn=!0);let Ue,Oe;Bn&&(L.ori==0?(Ue=Ho,Oe=Yt):(Ue=Wo,Oe=tn),dl(rr(Ue,Oe),Dn(Oe-Ue)),zn||pl(0,ae)),zn&&(L.ori==1?(Ue=Ho,Oe=Yt):(Ue=Wo,Oe=tn),pl(rr(Ue,Oe),Dn(Oe-Ue)),Bn||dl(0,Z)),!Bn&&!zn&&(dl(0,0),pl(0,0))}if(Xn._x=Bn,Xn._y=zn,y==null){if(I){if(Yg!=null){let[de,be]=wn.scales;wn.values[0]=de!=null?br(L.ori==0?Yt:tn,de):null,wn.values[1]=be!=null?br(L.ori==1?Yt:tn,be):null}gl(Od,i,Yt,tn,O,Pe,D)}if(je){let de=I&&wn.setSeries,be=ke.prox;eo==null?$r<=be&&xr(xs,Xo,!0,de):$r>be?xr(null,Xo,!0,de):xs!=eo&&xr(xs,Xo,!0,de)}}me&&(fe.idx=D,fd()),w!==!1&&Vn("setCursor")}let bs=null;Object.defineProperty(i,"rect",{get(){return bs==null&&ml(!1),bs}});function ml(y=!1){y?bs=null:(bs=m.getBoundingClientRect(),Vn("syncRect",bs))}function kg(y,w,I,D,W,Z,ae){he._lock||vs&&y!=null&&y.movementX==0&&y.movementY==0||(dd(y,w,I,D,W,Z,ae,!1,y!=null),y!=null?to(null,!0,!0):to(w,!0,!1))}function dd(y,w,I,D,W,Z,ae,de,be){if(bs==null&&ml(!1),Je(y),y!=null)I=y.clientX-bs.left,D=y.clientY-bs.top;else{if(I<0||D<0){Yt=-10,tn=-10;return}let[Ne,Ue]=wn.scales,Oe=w.cursor.sync,[st,It]=Oe.values,[At,vt]=Oe.scales,[Ze,Xe]=wn.match,Zt=w.axes[0].side%2==1,pn=L.ori==0?O:Pe,Gn=L.ori==1?O:Pe,Gt=Zt?Z:W,mn=Zt?W:Z,bi=Zt?D:I,ii=Zt?I:D;if(At!=null?I=Ze(Ne,At)?a(st,S[Ne],pn,0):-10:I=pn*(bi/Gt),vt!=null?D=Xe(Ue,vt)?a(It,S[Ue],Gn,0):-10:D=Gn*(ii/mn),L.ori==1){let Bi=I;I=D,D=Bi}}be&&(w==null||w.cursor.event.type==Od)&&((I<=1||I>=O-1)&&(I=ao(I,O)),(D<=1||D>=Pe-1)&&(D=ao(D,Pe))),de?(Lg=I,Dg=D,[Ho,Wo]=he.move(i,I,D)):(Yt=I,tn=D)}let pd={width:0,height:0,left:0,top:0};function md(){Oc(pd,!1)}let Bg,zg,Vg,Gg;function Hg(y,w,I,D,W,Z,ae){vs=!0,Bn=zn=Xn._x=Xn._y=!1,dd(y,w,I,D,W,Z,ae,!0,!1),y!=null&&(Tt(kd,Hd,Wg,!1),gl(U0,i,Ho,Wo,O,Pe,null));let{left:de,top:be,width:Ne,height:Ue}=Kt;Bg=de,zg=be,Vg=Ne,Gg=Ue}function Wg(y,w,I,D,W,Z,ae){vs=Xn._x=Xn._y=!1,dd(y,w,I,D,W,Z,ae,!1,!0);let{left:de,top:be,width:Ne,height:Ue}=Kt,Oe=Ne>0||Ue>0,st=Bg!=de||zg!=be||Vg!=Ne||Gg!=Ue;if(Oe&&st&&Oc(Kt),Xn.setScale&&Oe&&st){let It=de,At=Ne,vt=be,Ze=Ue;if(L.ori==1&&(It=be,At=Ue,vt=de,Ze=Ne),Bn&&ys(C,br(It,C),br(It+At,C)),zn)for(let Xe in S){let Zt=S[Xe];Xe!=C&&Zt.from==null&&Zt.min!=Wt&&ys(Xe,br(vt+Ze,Xe),br(vt,Xe))}md()}else he.lock&&(he._lock=!he._lock,to(w,!0,y!=null));y!=null&&(Cn(kd,Hd),gl(kd,i,Yt,tn,O,Pe,null))}function MM(y,w,I,D,W,Z,ae){if(he._lock)return;Je(y);let de=vs;if(vs){let be=!0,Ne=!0,Ue=10,Oe,st;L.ori==0?(Oe=Bn,st=zn):(Oe=zn,st=Bn),Oe&&st&&(be=Yt<=Ue||Yt>=O-Ue,Ne=tn<=Ue||tn>=Pe-Ue),Oe&&be&&(Yt=Yt<Ho?0:O),st&&Ne&&(tn=tn<Wo?0:Pe),to(null,!0,!0),vs=!1}Yt=-10,tn=-10,re.fill(null),to(null,!0,!0),de&&(vs=de)}function qg(y,w,I,D,W,Z,ae){he._lock||(Je(y),fl(),md(),y!=null&&gl(k0,i,Yt,tn,O,Pe,null))}function Xg(){A.forEach(tT),F(i.width,i.height,!0)}uo(ru,ra,Xg);let $o={};$o.mousedown=Hg,$o.mousemove=kg,$o.mouseup=Wg,$o.dblclick=qg,$o.setSeries=(y,w,I,D)=>{let W=wn.match[2];I=W(i,w,I),I!=-1&&xr(I,D,!0,!1)},ge&&(Tt(U0,m,Hg),Tt(Od,m,kg),Tt(F0,m,y=>{Je(y),ml(!1)}),Tt(O0,m,MM),Tt(k0,m,qg),Jd.add(i),i.syncRect=ml);let kc=i.hooks=n.hooks||{};function Vn(y,w,I){ni?zt.push([y,w,I]):y in kc&&kc[y].forEach(D=>{D.call(null,i,w,I)})}(n.plugins||[]).forEach(y=>{for(let w in y.hooks)kc[w]=(kc[w]||[]).concat(y.hooks[w])});let $g=(y,w,I)=>I,wn=En({key:null,setSeries:!1,filters:{pub:K0,sub:K0},scales:[C,b[1]?b[1].scale:null],match:[Z0,Z0,$g],values:[null,null]},he.sync);wn.match.length==2&&wn.match.push($g),he.sync=wn;let Yg=wn.key,gd=X_(Yg);function gl(y,w,I,D,W,Z,ae){wn.filters.pub(y,w,I,D,W,Z,ae)&&gd.pub(y,w,I,D,W,Z,ae)}gd.sub(i);function wM(y,w,I,D,W,Z,ae){wn.filters.sub(y,w,I,D,W,Z,ae)&&$o[y](null,w,I,D,W,Z,ae)}i.pub=wM;function TM(){gd.unsub(i),Jd.delete(i),kn.clear(),Xd(ru,ra,Xg),c.remove(),Ce?.remove(),Vn("destroy")}i.destroy=TM;function _d(){Vn("init",n,e),hl(e||n.data,!1),H[C]?cd(C,H[C]):fl(),ie=Kt.show&&(Kt.width>0||Kt.height>0),te=me=!0,F(n.width,n.height)}return b.forEach(Oo),A.forEach(Hr),t?t instanceof HTMLElement?(t.appendChild(c),_d()):t(i,_d):_d(),i}jt.assign=En;jt.fmtNum=rp;jt.rangeNum=su;jt.rangeLog=lu;jt.rangeAsinh=np;jt.orient=fo;jt.pxRatio=Dt;jt.join=Xw;jt.fmtDate=op,jt.tzDate=i1;jt.sync=X_;{jt.addGap=B1,jt.clipGaps=hu;let n=jt.paths={points:j_};n.linear=ev,n.stepped=G1,n.bars=H1,n.spline=q1}function ze(n){let e=document.querySelector(".haptonic")??document.documentElement;return getComputedStyle(e).getPropertyValue(`--${n}`).trim()}function Zn(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}function fa(n,e,t,i=[]){let{ctx:r,bbox:s}=n,o=n.valToPos(e,"x",!0);o<s.left||o>s.left+s.width||pa(r,[o,s.top],[o,s.top+s.height],t,i)}function da(n,e,t,i=[]){let{ctx:r,bbox:s}=n,o=n.valToPos(e,"y",!0);pa(r,[s.left,o],[s.left+s.width,o],t,i)}function pa(n,e,t,i,r=[]){n.save(),n.strokeStyle=ze(i),n.lineWidth=1.5*devicePixelRatio,n.setLineDash(r.map(s=>s*devicePixelRatio)),n.beginPath(),n.moveTo(...e),n.lineTo(...t),n.stroke(),n.restore()}function ma(n,[e,t],i,r=5){n.save(),n.beginPath(),n.arc(e,t,r*devicePixelRatio,0,2*Math.PI),n.fillStyle=ze(i),n.strokeStyle=ze("paper"),n.lineWidth=2*devicePixelRatio,n.fill(),n.stroke(),n.restore()}function mu(n,[e,t],i){let{ctx:r,bbox:s}=n,[o,a]=[n.valToPos(e,"x",!0),n.valToPos(t,"x",!0)];r.fillStyle=ze(i),r.fillRect(o,s.top,a-o,s.height)}var nT=240;function Rr(n){return Math.max(n.clientWidth,nT)}function Pr(n,e,t,i){let r=[...i,Zn(()=>n.redraw(!1,!0))],s=new ResizeObserver(()=>n.setSize(t()));return s.observe(e),()=>{s.disconnect();for(let o of r)o();n.destroy()}}function Rs(n,e){n.over.addEventListener("click",({clientX:t,clientY:i})=>{let r=n.over.getBoundingClientRect();e(t-r.left,i-r.top)})}function Ir({ctx:n,bbox:e},t){n.save(),n.beginPath(),n.rect(e.left,e.top,e.width,e.height),n.clip(),t(),n.restore()}var iT={preview:{colour:"accent",dash:[5,3],width:1.6},certified:{colour:"ink",dash:[],width:1.6},held:{colour:"curve-1",dash:[1.5,3],width:1.5}};function dp(n,e,t,i,r){let{ctx:s}=n,{colour:o,dash:a,width:l}=iT[r],c=Array.from(e.distance,f=>n.valToPos(f,"x",!0)),u=(f,p)=>{let m=(t.frequency[f]??NaN)+p*(t.error[f]??NaN);return n.valToPos(m/i,"y",!0)},d=(f,p,m=!1)=>{for(let x=0;x<e.rows;x++){let _=m?e.rows-1-x:x;s.lineTo(c[_]??0,u(_*e.bands+f,p))}};s.save(),s.fillStyle=s.strokeStyle=ze(o),s.lineWidth=l*devicePixelRatio,s.setLineDash(a.map(f=>f*devicePixelRatio));for(let f=0;f<e.bands;f++)r==="preview"&&(s.globalAlpha=.2,s.beginPath(),d(f,1),d(f,-1,!0),s.fill(),s.globalAlpha=1),s.beginPath(),d(f,0),s.stroke();if(r==="held")for(let f of t.gaps.filter(({complete:p})=>p))for(let p of[f.lower,f.upper]){let m=n.valToPos(p/i,"y",!0);s.beginPath(),s.moveTo(n.bbox.left,m),s.lineTo(n.bbox.left+n.bbox.width,m),s.stroke()}s.restore()}var rT=320,sT=.72,oT=40;function rv({diagram:n,choice:e,newer:t}){let i=lt(null);return Qi(()=>{let r=i.current;if(r!==null)return aT(r,n,e,t)},[n,e,t]),h("div",{class:"curves",ref:i})}function aT(n,e,t,{layer:i,isWaiting:r}){let s=()=>t.unit.peek().factor,o=e.branches(),a=()=>[Array.from(e.distance),...o.map(p=>p.map(m=>m===null?null:m/s()))],l=()=>{let p=Rr(n);return{width:p,height:Math.max(rT,Math.min(sT*p,.7*innerHeight))}},c=e.corners.map(({row:p})=>e.distance[p]??0),u={stroke:()=>ze("ink"),ticks:{stroke:()=>ze("rule")},grid:{}},d=new jt({...l(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(p,m,x)=>[m,x]},y:{range:(p,m,x)=>m===null?[0,1]:[m<.2*x?0:m,x]}},axes:[{...u,splits:()=>c,values:()=>e.corners.map(({label:p})=>p),font:"15px system-ui, sans-serif",grid:{stroke:()=>ze("rule"),width:1}},{...u,size:48,font:"13px system-ui, sans-serif",grid:{show:!1},label:"frequency",labelFont:"14px system-ui, sans-serif",labelSize:24,values:(p,m)=>m.map(x=>`${Number(x.toPrecision(6))}`)}],series:[{},...o.map(()=>({stroke:()=>i.peek()!==null?"transparent":ze(r.peek()?"rule":"ink"),width:1.6,points:{show:!1}}))],hooks:{drawClear:[p=>Ir(p,()=>{let m=t.held.peek(),x=r.peek()?[]:(i.peek()??e).gaps;cT(p,x,e.carrier,s()),m!==null&&dp(p,e,m.layer,s(),"held")})],draw:[p=>{let m=i.peek();m!==null&&Ir(p,()=>dp(p,e,m,s(),m.isPreview?"preview":"certified")),hT(p,e,t,m)}]}},a(),n),f=()=>d.setScale("y",{min:0,max:e.top/s()});return f(),Rs(d,(p,m)=>{let x=lT(d,e,s(),p,m);x!==void 0&&(t.point.value=x)}),Pr(d,n,l,[et(()=>{let p=d.axes[1];p!==void 0&&(p.label=In("frequency",t.unit.value)),d.setData(a(),!0),f()}),et(()=>{let p=e.at(t.point.value)/s();i.value,r.value,t.held.value,p>(d.scales.y?.max??1/0)?d.setScale("y",{min:0,max:1.03*p}):d.redraw(!1,!1)})])}function lT(n,e,t,i,r){let[s,o]=[void 0,oT];for(let a=0;a<e.rows;a++){let l=n.valToPos(e.distance[a]??0,"x")-i;if(!(Math.abs(l)>o))for(let c=0;c<e.bands;c++){let u=Math.hypot(l,n.valToPos(e.at({row:a,band:c})/t,"y")-r);u<o&&([s,o]=[{row:a,band:c},u])}}return s}function cT(n,e,t,i){let{ctx:r,bbox:s}=n;for(let o of e){let a=n.valToPos(o.upper/i,"y",!0),l=n.valToPos(o.lower/i,"y",!0)-a;o.complete?(r.fillStyle=ze("gap"),r.fillRect(s.left,a,s.width,l)):o.waves!=="all"&&uT(r,s.left,a,s.width,l)}t!==void 0&&da(n,t/i,"carrier",[7,5])}function uT(n,e,t,i,r){let s=12*devicePixelRatio;n.save(),n.beginPath(),n.rect(e,t,i,r),n.clip(),n.beginPath();for(let o=e-r;o<e+i;o+=s)n.moveTo(o,t+r),n.lineTo(o+r,t);n.strokeStyle=ze("gap"),n.lineWidth=2*devicePixelRatio,n.stroke(),n.restore()}function hT(n,e,t,i){let r=t.point.peek(),s=n.valToPos(e.distance[r.row]??0,"x",!0),o=i?.frequency[r.row*e.bands+r.band]??e.at(r),a=n.valToPos(o/t.unit.peek().factor,"y",!0);ma(n.ctx,[s,a],"accent",6)}var gu=class{constructor(e){this.data=e;this.distance=e.values("distance"),this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),[this.rows=0,this.bands=0]=e.shape("frequency"),this.names=e.parsed("character_names");let t=e.parsed("path_labels"),i=e.parsed("path_corners");this.corners=t.map((s,o)=>({label:s,row:i[o]??0}));let r=e.header.attrs.carrier_hz;this.carrier=typeof r=="number"?r:void 0,this.top=Number(e.header.extra.top),this.units=Ts(e),this.gaps=pp(e)}data;distance;frequency;error;rows;bands;gaps;corners;carrier;top;units;names;branches(){let e=this.data.values("branch"),t=new Map;return e.forEach((i,r)=>{let s=t.get(i)??Array(this.rows).fill(null);s[Math.floor(r/this.bands)]=this.frequency[r]??null,t.set(i,s)}),[...t.values()]}at({row:e,band:t}){return this.frequency[e*this.bands+t]??NaN}errorAt({row:e,band:t}){return this.error[e*this.bands+t]??NaN}nature({row:e,band:t}){return this.names[this.data.values("character")[e*this.bands+t]??-1]??""}parity({row:e,band:t}){let i=e*this.bands+t,r=[["even","odd"][sv(this.data.values("parity")[i])],["symmetric","antisymmetric"][sv(this.data.values("middle_parity")[i])]],[s,o]=r;return[s&&`${s} under the mirror of the path`,o&&`${o} about the plate's middle plane`].filter(Boolean).join(", ")}velocity({row:e,band:t}){let i=this.data.values("group_velocity"),r=2*(e*this.bands+t),[s,o]=[i[r]??NaN,i[r+1]??NaN];return Number.isFinite(s)&&Number.isFinite(o)?[s,o]:void 0}phases(e){let t=this.data.values("kappa");return[t[2*e]??0,t[2*e+1]??0]}place(e){let t=this.corners.find(a=>a.row===e);if(t!==void 0)return t.label;let i=this.corners.findIndex(a=>a.row>e),[r,s]=[this.corners[i-1],this.corners[i]];if(r===void 0||s===void 0)return"";let o=(e-r.row)/(s.row-r.row);return`${Number(o.toFixed(3))} of ${r.label}-${s.label}`}belowGap(e){let t=e.below-1,i=0;for(let r=1;r<this.rows;r++)this.at({row:r,band:t})>this.at({row:i,band:t})&&(i=r);return{row:i,band:t}}};function pp(n){if(!n.has("gap_below"))return[];let e=t=>n.values(t);return Array.from(e("gap_below"),(t,i)=>({below:t,lower:e("gap_lower")[i]??NaN,upper:e("gap_upper")[i]??NaN,lowerError:e("gap_lower_error")[i]??NaN,upperError:e("gap_upper_error")[i]??NaN,complete:e("gap_complete")[i]===1,direction:n.texts("gap_direction")[i]??"",waves:n.texts("gap_waves")[i]??""}))}function sv(n){return n===1?0:n===-1?1:-1}function ov(n,e){let t=i=>e===void 0?i.upper-i.lower:av(i,e).room;return n.filter(({complete:i})=>i).sort((i,r)=>t(r)-t(i))[0]}function av(n,e){let[t,i]=[e-n.lower,n.upper-e];return t<i?{room:t,error:n.lowerError}:{room:i,error:n.upperError}}function lv(n,e,t){let i=ov(n,e),{factor:r}=t,s=(l,c)=>Hn(l/r,c/r),o=(l,c)=>oi(s(l,c),t);if(i===void 0)return{gap:"none complete below the last band"};let a=e===void 0?void 0:av(i,e);return{gap:oi(`${s(i.lower,i.lowerError)} to ${s(i.upper,i.upperError)}`,t),width:o(i.upper-i.lower,i.lowerError+i.upperError),...a&&e!==void 0?{[`margin at ${oi(Ar(e/r),t)}`]:o(a.room,a.error)}:{}}}function cv({gaps:n,carrier:e,unit:t}){let i=ov(n,e),r=i!==void 0&&i.upper-i.lower>i.lowerError+i.upperError;return h("dl",{class:"edges",children:[Object.entries(lv(n,e,t)).map(([s,o])=>h("div",{children:[h("dt",{children:s}),h("dd",{children:o})]})),i!==void 0&&!r&&h("div",{children:[h("dt",{children:"narrower than its errors"}),h("dd",{children:"may be closed"})]})]})}function uv({held:n,now:e,unit:t,isPreview:i,drop:r}){let s=({gaps:l,carrier:c})=>lv(l,c,t),a=[...Object.keys(e.design).filter(l=>e.design[l]!==n.design[l]).map(l=>[l,n.design[l]??"",e.design[l]??""]),...[...new Set([...Object.keys(s(n)),...Object.keys(s(e))])].map(l=>[l,s(n)[l]??"",s(e)[l]??""])];return h("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Held design and this one",children:[h("table",{children:[h("caption",{children:"Held design and this one"}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"quantity"}),h("th",{scope:"col",children:"held"}),h("th",{scope:"col",children:i?"preview":"this design"})]})}),h("tbody",{children:a.map(([l,c,u])=>h("tr",{children:[h("th",{scope:"row",children:l}),h("td",{children:c}),h("td",{children:u})]}))})]}),h("button",{type:"button",onClick:r,children:"Let go of the held design"})]})}function ga(){return matchMedia("(prefers-reduced-motion: reduce)").matches}var Ps=class{constructor({playing:e,pace:t},i){this.draw=i;let r=0,s=o=>{r>0&&(this.moment=(this.moment+(o-r)/1e3*t.peek())%1),r=o,document.hidden||i(),this.frame=requestAnimationFrame(s)};this.stop=et(()=>{cancelAnimationFrame(this.frame),r=0,e.value&&(this.frame=requestAnimationFrame(s))})}draw;moment=0;frame=0;stop;at(e){this.moment=e,this.draw()}end(){cancelAnimationFrame(this.frame),this.stop()}};var _u=6,vu=.5;function hv(n){let e=n.gaps[0];return{point:pe(e?n.belowGap(e):{row:n.corners[1]?.row??0,band:0}),playing:pe(!ga()),swing:pe(.15),pace:pe(.7),copies:pe([2,2]),unit:pe(Es(n.units,Math.max(...n.frequency))),listing:pe("none"),held:pe(null)}}function fv(n,{row:e,band:t},i,r){return{row:Math.min(Math.max(e+i,0),n.rows-1),band:Math.min(Math.max(t+r,0),n.bands-1)}}function dv(n,{band:e}){let t=[...n.gaps].filter(r=>r.waves==="all").sort((r,s)=>r.below-s.below),i=t.find(r=>r.below-1>e)??t[0];return i&&n.belowGap(i)}var fT=10,pv=.05;function mv(n,e,t){let i=(o,a)=>e.point.value=fv(n,e.point.value,o,a),r=o=>e.swing.value=Math.min(Math.max(e.swing.value+o,0),vu),s=o=>o.shiftKey?fT:1;return[{keys:"← →",effect:"previous or next wavevector; ten with Shift",actions:{ArrowLeft:o=>i(-s(o),0),ArrowRight:o=>i(s(o),0)}},{keys:"↑ ↓",effect:"next higher or lower band",actions:{ArrowUp:()=>i(0,1),ArrowDown:()=>i(0,-1)}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},{keys:"+ −",effect:"larger or smaller displacement",actions:{"+":()=>r(pv),"-":()=>r(-pv)}},{keys:"g",effect:"lower edge of the next gap",actions:{g:()=>e.point.value=dv(n,e.point.value)??e.point.value}},...t?[{keys:"h",effect:"hold this design, or let it go",actions:{h:t}}]:[],...Tr(e.listing)]}var dT=.2,pT=.1;function mT({data:n,at:e}){if(n===null)return null;if(e!==null)return gT(n,e);let[t,i]=[n.values("frequency"),n.values("frequency_error")];return{isPreview:!1,frequency:t,error:i,gaps:pp(n)}}function gv(n){let e=xt(()=>n?.value?mT(n.value):null);return{layer:e,isWaiting:xt(()=>!!n?.value&&e.value===null)}}var _v=({frequency:n,error:e,gaps:t})=>({isPreview:!1,frequency:n,error:e,gaps:t});function gT(n,e){let t=n.values("value"),i=t.length-1;if(e<(t[0]??NaN)*(1-1e-9)||e>(t[i]??NaN)*(1+1e-9))return null;let r=Math.max(1,t.findIndex(g=>g>=e)),[s,o]=[t[r-1]??0,t[r]??1],a=o-s,l=Math.min(Math.max((e-s)/a,0),1),c=g=>{let b=n.values(g).length/t.length,A=B=>{let z=n.values(B);return[z.subarray((r-1)*b,r*b),z.subarray(r*b,(r+1)*b)]},[[S,P],[C,v],[E,k]]=[A(g),A(`${g}_error`),A(`${g}_bend`)],N=(B,z,U)=>(1-l)*(B[U]??NaN)+l*(z[U]??NaN),L=a*l*(1-l);return[Float64Array.from(S,(B,z)=>N(S,P,z)),Float64Array.from(S,(B,z)=>N(C,v,z)+L*((E[z]??NaN)+(k[z]??NaN)))]},[u,d]=c("frequency"),f=pT*Math.max(...u);if(u.some((g,b)=>!((d[b]??NaN)<=dT*Math.max(g,f))))return null;let[p,m]=c("edge"),x=p.length/2,_=Array.from({length:x},(g,b)=>({below:b+1,lower:p[b]??NaN,upper:p[x+b]??NaN,lowerError:m[b]??NaN,upperError:m[x+b]??NaN,complete:!0,direction:"all",waves:"all"}));return{isPreview:!0,frequency:u,error:d,gaps:_.filter(({lower:g,upper:b})=>b>g)}}var _a=DM(Pv(),1);function Su(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),6e4)}var Mu=40,wu=40,yp="video/webm",kT=6,Iv=new WeakMap;function va(n,e){Iv.set(n,e)}function ya({canvas:n,name:e,caption:t}){let[i,r]=Lt(""),s=typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported(yp),o=(a,l)=>async()=>{if(n.current!==null){r(`The ${a} is made.`),await new Promise(c=>setTimeout(c,wu));try{Su(await l(new xp(n.current,t)),`${e}.${a.toLowerCase()}`),r("")}catch(c){r(`The ${a} cannot be made: ${String(c)}`)}}};return h("p",{class:"sides film",children:[h("span",{children:"Save the motion"}),h("button",{type:"button",onClick:()=>{o("GIF",BT)()},children:"GIF"}),s&&h("button",{type:"button",onClick:()=>{o("WebM",zT)()},children:"WebM"}),h("span",{role:"status",children:i})]})}var xp=class{constructor(e,t){this.canvas=e;this.caption=t;let i=Iv.get(e),r=this.copy.getContext("2d",{willReadFrequently:!0});if(i===void 0||r===null)throw new Error("the canvas does not move");[this.draw,this.context]=[i,r],[this.copy.width,this.copy.height]=[e.width,e.height]}canvas;caption;copy=document.createElement("canvas");context;draw;show(e){let{context:t,copy:i}=this;this.draw(e),t.fillStyle=ze("panel"),t.fillRect(0,0,i.width,i.height),t.drawImage(this.canvas,0,0),t.font=`${13*devicePixelRatio}px system-ui, sans-serif`,t.fillStyle=ze("ink");let r=kT*devicePixelRatio;return t.fillText(this.caption,r,i.height-r,i.width-2*r),t}};async function BT(n){let{width:e,height:t}=n.copy,i=(0,_a.GIFEncoder)(),r;for(let s=0;s<Mu;s++){let{data:o}=n.show(s/Mu).getImageData(0,0,e,t);r??=(0,_a.quantize)(o,256),i.writeFrame((0,_a.applyPalette)(o,r),e,t,s===0?{palette:r,delay:wu}:{delay:wu}),s%5===4&&await new Promise(a=>setTimeout(a))}return i.finish(),new Blob([i.bytes()],{type:"image/gif"})}async function zT(n){n.show(0);let e=n.copy.captureStream(),t=new MediaRecorder(e,{mimeType:yp,videoBitsPerSecond:8e6}),i=[];t.ondataavailable=({data:s})=>i.push(s);let r=new Promise(s=>t.onstop=s);t.start();for(let s=0;s<Mu;s++)n.show(s/Mu),await new Promise(o=>setTimeout(o,wu));t.stop(),await r;for(let s of e.getTracks())s.stop();return new Blob(i,{type:yp})}var Hs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ws={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},ry=0,$p=1,sy=2;var lc=1,oy=2,Wa=3,qs=0,ui=1,Xi=2,Mo=0,qa=1,Yp=2,Kp=3,Zp=4,ay=5;var wo=100,ly=101,cy=102,uy=103,hy=104,fy=200,dy=201,py=202,my=203,Jp=204,jp=205,gy=206,_y=207,vy=208,yy=209,xy=210,by=211,Sy=212,My=213,wy=214,Ku=0,Zu=1,Ju=2,Na=3,ju=4,Qu=5,eh=6,th=7,Qp=0,Ty=1,Ey=2,Fr=0,em=1,tm=2,nm=3,im=4,rm=5,sm=6,om=7;var am=300,To=301,Xa=302,Rh=303,Ph=304,nh=1e3,Dr=1001,ih=1002,qn=1003,Ay=1004;var cc=1005;var $n=1006,Ih=1007;var os=1008;var Fi=1009,lm=1010,cm=1011,$a=1012,Lh=1013,cr=1014,ur=1015,hr=1016,Dh=1017,Nh=1018,Eo=1020,um=35902,hm=35899,fm=1021,dm=1022,fr=1023,is=1026,as=1027,pm=1028,Uh=1029,Xs=1030,Fh=1031;var Oh=1033,uc=33776,hc=33777,fc=33778,dc=33779,kh=35840,Bh=35841,zh=35842,Vh=35843,Gh=36196,Hh=37492,Wh=37496,qh=37488,Xh=37489,pc=37490,$h=37491,Yh=37808,Kh=37809,Zh=37810,Jh=37811,jh=37812,Qh=37813,ef=37814,tf=37815,nf=37816,rf=37817,sf=37818,of=37819,af=37820,lf=37821,cf=36492,uf=36494,hf=36495,ff=36283,df=36284,mc=36285,pf=36286;var Wl=2300,rh=2301,$u=2302,Vp=2303,Gp=2400,Hp=2401,Wp=2402;var Cy=3200;var mm=0,Ry=1,ls="",Ri="srgb",ql="srgb-linear",Xl="linear",Ot="srgb";var Yu=7680;var Py=519,Iy=512,Ly=513,Dy=514,gm=515,Ny=516,Uy=517,_m=518,vm=519,Fy=35044;var ym="300 es",Wi=2e3,$l=2001;function VT(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function GT(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Yl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Oy(){let n=Yl("canvas");return n.style.display="block",n}var Lv={},Ua=null;function xm(...n){let e="THREE."+n.shift();Ua?Ua("log",e,...n):console.log(e,...n)}function ky(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ye(...n){n=ky(n);let e="THREE."+n.shift();if(Ua)Ua("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function tt(...n){n=ky(n);let e="THREE."+n.shift();if(Ua)Ua("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Vl(...n){let e=n.join(" ");e in Lv||(Lv[e]=!0,Ye(...n))}function By(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var zy={[Ku]:Ku,[Ju]:eh,[ju]:ju,[Na]:Qu,[Zu]:Zu,[eh]:Ju,[th]:th,[Qu]:Na},lr=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},Jn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Dv=1234567,Gl=Math.PI/180,Fa=180/Math.PI;function Ya(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Jn[n&255]+Jn[n>>8&255]+Jn[n>>16&255]+Jn[n>>24&255]+"-"+Jn[e&255]+Jn[e>>8&255]+"-"+Jn[e>>16&15|64]+Jn[e>>24&255]+"-"+Jn[t&63|128]+Jn[t>>8&255]+"-"+Jn[t>>16&255]+Jn[t>>24&255]+Jn[i&255]+Jn[i>>8&255]+Jn[i>>16&255]+Jn[i>>24&255]).toLowerCase()}function _t(n,e,t){return Math.max(e,Math.min(t,n))}function bm(n,e){return(n%e+e)%e}function HT(n,e,t,i,r){return i+(n-e)*(r-i)/(t-e)}function WT(n,e,t){return n!==e?(t-n)/(e-n):0}function Hl(n,e,t){return(1-t)*n+t*e}function qT(n,e,t,i){return Hl(n,e,1-Math.exp(-t*i))}function XT(n,e=1){return e-Math.abs(bm(n,e*2)-e)}function $T(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function YT(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function KT(n,e){return n+Math.floor(Math.random()*(e-n+1))}function ZT(n,e){return n+Math.random()*(e-n)}function JT(n){return n*(.5-Math.random())}function jT(n){n!==void 0&&(Dv=n);let e=Dv+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function QT(n){return n*Gl}function eE(n){return n*Fa}function tE(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function nE(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Sm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function iE(n,e,t,i,r){let s=Math.cos,o=Math.sin,a=s(t/2),l=o(t/2),c=s((e+i)/2),u=o((e+i)/2),d=s((e-i)/2),f=o((e-i)/2),p=s((i-e)/2),m=o((i-e)/2);switch(r){case"XYX":n.set(a*u,l*d,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*m,l*p,a*c);break;case"YXY":n.set(l*p,a*u,l*m,a*c);break;case"ZYZ":n.set(l*m,l*p,a*u,a*c);break;default:Ye("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function Mm(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Vy(n,e){if(e.constructor===Float32Array)return n;let t=Mm(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Gy(n,e){if(e.constructor===Float32Array)return n;let t=Mm(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var wm={DEG2RAD:Gl,RAD2DEG:Fa,generateUUID:Ya,clamp:_t,euclideanModulo:bm,mapLinear:HT,inverseLerp:WT,lerp:Hl,damp:qT,pingpong:XT,smoothstep:$T,smootherstep:YT,randInt:KT,randFloat:ZT,randFloatSpread:JT,seededRandom:jT,degToRad:QT,radToDeg:eE,isPowerOfTwo:tE,ceilPowerOfTwo:nE,floorPowerOfTwo:Sm,setQuaternionFromProperEuler:iE,normalize:Gy,denormalize:Vy},nt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ii=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],u=i[r+2],d=i[r+3],f=s[o+0],p=s[o+1],m=s[o+2],x=s[o+3];if(d!==x||l!==f||c!==p||u!==m){let _=l*f+c*p+u*m+d*x;_<0&&(f=-f,p=-p,m=-m,x=-x,_=-_);let g=1-a;if(_<.9995){let b=Math.acos(_),A=Math.sin(b);g=Math.sin(g*b)/A,a=Math.sin(a*b)/A,l=l*g+f*a,c=c*g+p*a,u=u*g+m*a,d=d*g+x*a}else{l=l*g+f*a,c=c*g+p*a,u=u*g+m*a,d=d*g+x*a;let b=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=b,c*=b,u*=b,d*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],u=i[r+3],d=s[o],f=s[o+1],p=s[o+2],m=s[o+3];return e[t]=a*m+u*d+l*p-c*f,e[t+1]=l*m+u*f+c*d-a*p,e[t+2]=c*m+u*p+a*f-l*d,e[t+3]=u*m-a*d-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(r/2),d=a(s/2),f=l(i/2),p=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*u*d+c*p*m,this._y=c*p*d-f*u*m,this._z=c*u*m+f*p*d,this._w=c*u*d-f*p*m;break;case"YXZ":this._x=f*u*d+c*p*m,this._y=c*p*d-f*u*m,this._z=c*u*m-f*p*d,this._w=c*u*d+f*p*m;break;case"ZXY":this._x=f*u*d-c*p*m,this._y=c*p*d+f*u*m,this._z=c*u*m+f*p*d,this._w=c*u*d-f*p*m;break;case"ZYX":this._x=f*u*d-c*p*m,this._y=c*p*d+f*u*m,this._z=c*u*m-f*p*d,this._w=c*u*d+f*p*m;break;case"YZX":this._x=f*u*d+c*p*m,this._y=c*p*d+f*u*m,this._z=c*u*m-f*p*d,this._w=c*u*d-f*p*m;break;case"XZY":this._x=f*u*d-c*p*m,this._y=c*p*d-f*u*m,this._z=c*u*m+f*p*d,this._w=c*u*d+f*p*m;break;default:Ye("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],f=i+a+d;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(s-c)*p,this._z=(o-r)*p}else if(i>a&&i>d){let p=2*Math.sqrt(1+i-a-d);this._w=(u-l)/p,this._x=.25*p,this._y=(r+o)/p,this._z=(s+c)/p}else if(a>d){let p=2*Math.sqrt(1+a-i-d);this._w=(s-c)/p,this._x=(r+o)/p,this._y=.25*p,this._z=(l+u)/p}else{let p=2*Math.sqrt(1+d-i-a);this._w=(o-r)/p,this._x=(s+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-i*c,this._z=s*u+o*c+i*l-r*a,this._w=o*u-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Nv.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Nv.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),u=2*(a*t-s*r),d=2*(s*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-s*d,this.z=r+l*d+s*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return bp.copy(this).projectOnVector(e),this.sub(bp)}reflect(e){return this.sub(bp.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(_t(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},bp=new K,Nv=new Ii,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=r,u[2]=a,u[3]=t,u[4]=s,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],f=i[2],p=i[5],m=i[8],x=r[0],_=r[3],g=r[6],b=r[1],A=r[4],S=r[7],P=r[2],C=r[5],v=r[8];return s[0]=o*x+a*b+l*P,s[3]=o*_+a*A+l*C,s[6]=o*g+a*S+l*v,s[1]=c*x+u*b+d*P,s[4]=c*_+u*A+d*C,s[7]=c*g+u*S+d*v,s[2]=f*x+p*b+m*P,s[5]=f*_+p*A+m*C,s[8]=f*g+p*S+m*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*s*u+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,f=a*l-u*s,p=c*s-o*l,m=t*d+i*f+r*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return e[0]=d*x,e[1]=(r*c-u*i)*x,e[2]=(a*i-r*o)*x,e[3]=f*x,e[4]=(u*t-r*l)*x,e[5]=(r*s-a*t)*x,e[6]=p*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*s)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Vl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Sp.makeScale(e,t)),this}rotate(e){return Vl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Sp.makeRotation(-e)),this}translate(e,t){return Vl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Sp.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Sp=new it,Uv=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Fv=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function rE(){let n={enabled:!0,workingColorSpace:ql,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Ot&&(r.r=ns(r.r),r.g=ns(r.g),r.b=ns(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ot&&(r.r=Da(r.r),r.g=Da(r.g),r.b=Da(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===ls?Xl:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[ql]:{primaries:e,whitePoint:i,transfer:Xl,toXYZ:Uv,fromXYZ:Fv,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ri},outputColorSpaceConfig:{drawingBufferColorSpace:Ri}},[Ri]:{primaries:e,whitePoint:i,transfer:Ot,toXYZ:Uv,fromXYZ:Fv,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ri}}}),n}var St=rE();function ns(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Da(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var xa,sh=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{xa===void 0&&(xa=Yl("canvas")),xa.width=e.width,xa.height=e.height;let r=xa.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=xa}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Yl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=ns(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(ns(t[i]/255)*255):t[i]=ns(t[i]);return{data:t,width:e.width,height:e.height}}else return Ye("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},sE=0,Oa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:sE++}),this.uuid=Ya(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Mp(r[o].image)):s.push(Mp(r[o]))}else s=Mp(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function Mp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?sh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ye("Texture: Unable to serialize Texture."),{})}var oE=0,wp=new K,gi=class n extends lr{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Dr,r=Dr,s=$n,o=os,a=fr,l=Fi,c=n.DEFAULT_ANISOTROPY,u=ls){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:oE++}),this.uuid=Ya(),this.name="",this.source=new Oa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new nt(0,0),this.repeat=new nt(1,1),this.center=new nt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(wp).x}get height(){return this.source.getSize(wp).y}get depth(){return this.source.getSize(wp).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ye(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ye(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==am)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case nh:e.x=e.x-Math.floor(e.x);break;case Dr:e.x=e.x<0?0:1;break;case ih:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case nh:e.y=e.y-Math.floor(e.y);break;case Dr:e.y=e.y<0?0:1;break;case ih:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};gi.DEFAULT_IMAGE=null;gi.DEFAULT_MAPPING=am;gi.DEFAULT_ANISOTROPY=1;var an=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],u=l[4],d=l[8],f=l[1],p=l[5],m=l[9],x=l[2],_=l[6],g=l[10];if(Math.abs(u-f)<.01&&Math.abs(d-x)<.01&&Math.abs(m-_)<.01){if(Math.abs(u+f)<.1&&Math.abs(d+x)<.1&&Math.abs(m+_)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(p+1)/2,P=(g+1)/2,C=(u+f)/4,v=(d+x)/4,E=(m+_)/4;return A>S&&A>P?A<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(A),r=C/i,s=v/i):S>P?S<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(S),i=C/r,s=E/r):P<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(P),i=v/s,r=E/s),this.set(i,r,s,t),this}let b=Math.sqrt((_-m)*(_-m)+(d-x)*(d-x)+(f-u)*(f-u));return Math.abs(b)<.001&&(b=1),this.x=(_-m)/b,this.y=(d-x)/b,this.z=(f-u)/b,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(_t(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},oh=class extends lr{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:$n,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new an(0,0,e,t),this.scissorTest=!1,this.viewport=new an(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new gi({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:$n,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new Oa(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Li=class extends oh{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Kl=class extends gi{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=qn,this.minFilter=qn,this.wrapR=Dr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ah=class extends gi{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=qn,this.minFilter=qn,this.wrapR=Dr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var on=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,u,d,f,p,m,x,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,u,d,f,p,m,x,_)}set(e,t,i,r,s,o,a,l,c,u,d,f,p,m,x,_){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=r,g[1]=s,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=d,g[14]=f,g[3]=p,g[7]=m,g[11]=x,g[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/ba.setFromMatrixColumn(e,0).length(),s=1/ba.setFromMatrixColumn(e,1).length(),o=1/ba.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),d=Math.sin(s);if(e.order==="XYZ"){let f=o*u,p=o*d,m=a*u,x=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=p+m*c,t[5]=f-x*c,t[9]=-a*l,t[2]=x-f*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,p=l*d,m=c*u,x=c*d;t[0]=f+x*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=p*a-m,t[6]=x+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,p=l*d,m=c*u,x=c*d;t[0]=f-x*a,t[4]=-o*d,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*u,t[9]=x-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,p=o*d,m=a*u,x=a*d;t[0]=l*u,t[4]=m*c-p,t[8]=f*c+x,t[1]=l*d,t[5]=x*c+f,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=x-f*d,t[8]=m*d+p,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=p*d+m,t[10]=f-x*d}else if(e.order==="XZY"){let f=o*l,p=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=f*d+x,t[5]=o*u,t[9]=p*d-m,t[2]=m*d-p,t[6]=a*u,t[10]=x*d+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(aE,e,lE)}lookAt(e,t,i){let r=this.elements;return Ai.subVectors(e,t),Ai.lengthSq()===0&&(Ai.z=1),Ai.normalize(),Ls.crossVectors(i,Ai),Ls.lengthSq()===0&&(Math.abs(i.z)===1?Ai.x+=1e-4:Ai.z+=1e-4,Ai.normalize(),Ls.crossVectors(i,Ai)),Ls.normalize(),Tu.crossVectors(Ai,Ls),r[0]=Ls.x,r[4]=Tu.x,r[8]=Ai.x,r[1]=Ls.y,r[5]=Tu.y,r[9]=Ai.y,r[2]=Ls.z,r[6]=Tu.z,r[10]=Ai.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],f=i[9],p=i[13],m=i[2],x=i[6],_=i[10],g=i[14],b=i[3],A=i[7],S=i[11],P=i[15],C=r[0],v=r[4],E=r[8],k=r[12],N=r[1],L=r[5],B=r[9],z=r[13],U=r[2],H=r[6],Y=r[10],G=r[14],le=r[3],J=r[7],Q=r[11],re=r[15];return s[0]=o*C+a*N+l*U+c*le,s[4]=o*v+a*L+l*H+c*J,s[8]=o*E+a*B+l*Y+c*Q,s[12]=o*k+a*z+l*G+c*re,s[1]=u*C+d*N+f*U+p*le,s[5]=u*v+d*L+f*H+p*J,s[9]=u*E+d*B+f*Y+p*Q,s[13]=u*k+d*z+f*G+p*re,s[2]=m*C+x*N+_*U+g*le,s[6]=m*v+x*L+_*H+g*J,s[10]=m*E+x*B+_*Y+g*Q,s[14]=m*k+x*z+_*G+g*re,s[3]=b*C+A*N+S*U+P*le,s[7]=b*v+A*L+S*H+P*J,s[11]=b*E+A*B+S*Y+P*Q,s[15]=b*k+A*z+S*G+P*re,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],f=e[10],p=e[14],m=e[3],x=e[7],_=e[11],g=e[15],b=l*p-c*f,A=a*p-c*d,S=a*f-l*d,P=o*p-c*u,C=o*f-l*u,v=o*d-a*u;return t*(x*b-_*A+g*S)-i*(m*b-_*P+g*C)+r*(m*A-x*P+g*v)-s*(m*S-x*C+_*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(s*u-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],f=e[10],p=e[11],m=e[12],x=e[13],_=e[14],g=e[15],b=t*a-i*o,A=t*l-r*o,S=t*c-s*o,P=i*l-r*a,C=i*c-s*a,v=r*c-s*l,E=u*x-d*m,k=u*_-f*m,N=u*g-p*m,L=d*_-f*x,B=d*g-p*x,z=f*g-p*_,U=b*z-A*B+S*L+P*N-C*k+v*E;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/U;return e[0]=(a*z-l*B+c*L)*H,e[1]=(r*B-i*z-s*L)*H,e[2]=(x*v-_*C+g*P)*H,e[3]=(f*C-d*v-p*P)*H,e[4]=(l*N-o*z-c*k)*H,e[5]=(t*z-r*N+s*k)*H,e[6]=(_*S-m*v-g*A)*H,e[7]=(u*v-f*S+p*A)*H,e[8]=(o*B-a*N+c*E)*H,e[9]=(i*N-t*B-s*E)*H,e[10]=(m*C-x*S+g*b)*H,e[11]=(d*S-u*C-p*b)*H,e[12]=(a*k-o*L-l*E)*H,e[13]=(t*L-i*k+r*E)*H,e[14]=(x*A-m*P-_*b)*H,e[15]=(u*P-d*A+f*b)*H,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,u=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+i,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,u=o+o,d=a+a,f=s*c,p=s*u,m=s*d,x=o*u,_=o*d,g=a*d,b=l*c,A=l*u,S=l*d,P=i.x,C=i.y,v=i.z;return r[0]=(1-(x+g))*P,r[1]=(p+S)*P,r[2]=(m-A)*P,r[3]=0,r[4]=(p-S)*C,r[5]=(1-(f+g))*C,r[6]=(_+b)*C,r[7]=0,r[8]=(m+A)*v,r[9]=(_-b)*v,r[10]=(1-(f+x))*v,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=ba.set(r[0],r[1],r[2]).length(),a=ba.set(r[4],r[5],r[6]).length(),l=ba.set(r[8],r[9],r[10]).length();s<0&&(o=-o),sr.copy(this);let c=1/o,u=1/a,d=1/l;return sr.elements[0]*=c,sr.elements[1]*=c,sr.elements[2]*=c,sr.elements[4]*=u,sr.elements[5]*=u,sr.elements[6]*=u,sr.elements[8]*=d,sr.elements[9]*=d,sr.elements[10]*=d,t.setFromRotationMatrix(sr),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=Wi,l=!1){let c=this.elements,u=2*s/(t-e),d=2*s/(i-r),f=(t+e)/(t-e),p=(i+r)/(i-r),m,x;if(l)m=s/(o-s),x=o*s/(o-s);else if(a===Wi)m=-(o+s)/(o-s),x=-2*o*s/(o-s);else if(a===$l)m=-o/(o-s),x=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Wi,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-r),f=-(t+e)/(t-e),p=-(i+r)/(i-r),m,x;if(l)m=1/(o-s),x=o/(o-s);else if(a===Wi)m=-2/(o-s),x=-(o+s)/(o-s);else if(a===$l)m=-1/(o-s),x=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ba=new K,sr=new on,aE=new K(0,0,0),lE=new K(1,1,1),Ls=new K,Tu=new K,Ai=new K,Ov=new on,kv=new Ii,ks=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],d=r[2],f=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,s),this._z=0);break;case"ZXY":this._x=Math.asin(_t(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-_t(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,s)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,p),this._y=0);break;default:Ye("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Ov.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Ov,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return kv.setFromEuler(this),this.setFromQuaternion(kv,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ks.DEFAULT_ORDER="XYZ";var Zl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},cE=0,Bv=new K,Sa=new Ii,Jr=new on,Eu=new K,Fl=new K,uE=new K,hE=new Ii,zv=new K(1,0,0),Vv=new K(0,1,0),Gv=new K(0,0,1),Hv={type:"added"},fE={type:"removed"},Ma={type:"childadded",child:null},Tp={type:"childremoved",child:null},Di=class n extends lr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:cE++}),this.uuid=Ya(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new K,t=new ks,i=new Ii,r=new K(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new on},normalMatrix:{value:new it}}),this.matrix=new on,this.matrixWorld=new on,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Zl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Sa.setFromAxisAngle(e,t),this.quaternion.multiply(Sa),this}rotateOnWorldAxis(e,t){return Sa.setFromAxisAngle(e,t),this.quaternion.premultiply(Sa),this}rotateX(e){return this.rotateOnAxis(zv,e)}rotateY(e){return this.rotateOnAxis(Vv,e)}rotateZ(e){return this.rotateOnAxis(Gv,e)}translateOnAxis(e,t){return Bv.copy(e).applyQuaternion(this.quaternion),this.position.add(Bv.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(zv,e)}translateY(e){return this.translateOnAxis(Vv,e)}translateZ(e){return this.translateOnAxis(Gv,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Jr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Eu.copy(e):Eu.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),Fl.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Jr.lookAt(Fl,Eu,this.up):Jr.lookAt(Eu,Fl,this.up),this.quaternion.setFromRotationMatrix(Jr),r&&(Jr.extractRotation(r.matrixWorld),Sa.setFromRotationMatrix(Jr),this.quaternion.premultiply(Sa.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Hv),Ma.child=e,this.dispatchEvent(Ma),Ma.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(fE),Tp.child=e,this.dispatchEvent(Tp),Tp.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Jr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Jr.multiply(e.parent.matrixWorld)),e.applyMatrix4(Jr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Hv),Ma.child=e,this.dispatchEvent(Ma),Ma.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fl,e,uE),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Fl,hE,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];s(e.shapes,d)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),f=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Di.DEFAULT_UP=new K(0,1,0);Di.DEFAULT_MATRIX_AUTO_UPDATE=!0;Di.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var yo=class extends Di{constructor(){super(),this.isGroup=!0,this.type="Group"}},dE={type:"move"},ka=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new yo,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new yo,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new yo,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let _=t.getJointPose(x,i),g=this._getHandJoint(c,x);_!==null&&(g.matrix.fromArray(_.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=_.radius),g.visible=_!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],f=u.position.distanceTo(d.position),p=.02,m=.005;c.inputState.pinching&&f>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(dE)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new yo;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Hy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ds={h:0,s:0,l:0},Au={h:0,s:0,l:0};function Ep(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Mt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ri){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,St.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=St.workingColorSpace){return this.r=e,this.g=t,this.b=i,St.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=St.workingColorSpace){if(e=bm(e,1),t=_t(t,0,1),i=_t(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=Ep(o,s,e+1/3),this.g=Ep(o,s,e),this.b=Ep(o,s,e-1/3)}return St.colorSpaceToWorking(this,r),this}setStyle(e,t=Ri){function i(s){s!==void 0&&parseFloat(s)<1&&Ye("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:Ye("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);Ye("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ri){let i=Hy[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ye("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ns(e.r),this.g=ns(e.g),this.b=ns(e.b),this}copyLinearToSRGB(e){return this.r=Da(e.r),this.g=Da(e.g),this.b=Da(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ri){return St.workingToColorSpace(jn.copy(this),e),Math.round(_t(jn.r*255,0,255))*65536+Math.round(_t(jn.g*255,0,255))*256+Math.round(_t(jn.b*255,0,255))}getHexString(e=Ri){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=St.workingColorSpace){St.workingToColorSpace(jn.copy(this),t);let i=jn.r,r=jn.g,s=jn.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(r-s)/d+(r<s?6:0);break;case r:l=(s-i)/d+2;break;case s:l=(i-r)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=St.workingColorSpace){return St.workingToColorSpace(jn.copy(this),t),e.r=jn.r,e.g=jn.g,e.b=jn.b,e}getStyle(e=Ri){St.workingToColorSpace(jn.copy(this),e);let t=jn.r,i=jn.g,r=jn.b;return e!==Ri?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(Ds),this.setHSL(Ds.h+e,Ds.s+t,Ds.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Ds),e.getHSL(Au);let i=Hl(Ds.h,Au.h,t),r=Hl(Ds.s,Au.s,t),s=Hl(Ds.l,Au.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},jn=new Mt;Mt.NAMES=Hy;var Jl=class extends Di{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ks,this.environmentIntensity=1,this.environmentRotation=new ks,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},or=new K,jr=new K,Ap=new K,Qr=new K,wa=new K,Ta=new K,Wv=new K,Cp=new K,Rp=new K,Pp=new K,Ip=new an,Lp=new an,Dp=new an,Os=class n{constructor(e=new K,t=new K,i=new K){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),or.subVectors(e,t),r.cross(or);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){or.subVectors(r,t),jr.subVectors(i,t),Ap.subVectors(e,t);let o=or.dot(or),a=or.dot(jr),l=or.dot(Ap),c=jr.dot(jr),u=jr.dot(Ap),d=o*c-a*a;if(d===0)return s.set(0,0,0),null;let f=1/d,p=(c*l-a*u)*f,m=(o*u-a*l)*f;return s.set(1-p-m,m,p)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Qr)===null?!1:Qr.x>=0&&Qr.y>=0&&Qr.x+Qr.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,Qr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Qr.x),l.addScaledVector(o,Qr.y),l.addScaledVector(a,Qr.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return Ip.setScalar(0),Lp.setScalar(0),Dp.setScalar(0),Ip.fromBufferAttribute(e,t),Lp.fromBufferAttribute(e,i),Dp.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Ip,s.x),o.addScaledVector(Lp,s.y),o.addScaledVector(Dp,s.z),o}static isFrontFacing(e,t,i,r){return or.subVectors(i,t),jr.subVectors(e,t),or.cross(jr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return or.subVectors(this.c,this.b),jr.subVectors(this.a,this.b),or.cross(jr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;wa.subVectors(r,i),Ta.subVectors(s,i),Cp.subVectors(e,i);let l=wa.dot(Cp),c=Ta.dot(Cp);if(l<=0&&c<=0)return t.copy(i);Rp.subVectors(e,r);let u=wa.dot(Rp),d=Ta.dot(Rp);if(u>=0&&d<=u)return t.copy(r);let f=l*d-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(wa,o);Pp.subVectors(e,s);let p=wa.dot(Pp),m=Ta.dot(Pp);if(m>=0&&p<=m)return t.copy(s);let x=p*c-l*m;if(x<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Ta,a);let _=u*m-p*d;if(_<=0&&d-u>=0&&p-m>=0)return Wv.subVectors(s,r),a=(d-u)/(d-u+(p-m)),t.copy(r).addScaledVector(Wv,a);let g=1/(_+x+f);return o=x*g,a=f*g,t.copy(i).addScaledVector(wa,o).addScaledVector(Ta,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Nr=class{constructor(e=new K(1/0,1/0,1/0),t=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(ar.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(ar.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=ar.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ar):ar.fromBufferAttribute(s,o),ar.applyMatrix4(e.matrixWorld),this.expandByPoint(ar);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Cu.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Cu.copy(i.boundingBox)),Cu.applyMatrix4(e.matrixWorld),this.union(Cu)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ar),ar.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ol),Ru.subVectors(this.max,Ol),Ea.subVectors(e.a,Ol),Aa.subVectors(e.b,Ol),Ca.subVectors(e.c,Ol),Ns.subVectors(Aa,Ea),Us.subVectors(Ca,Aa),mo.subVectors(Ea,Ca);let t=[0,-Ns.z,Ns.y,0,-Us.z,Us.y,0,-mo.z,mo.y,Ns.z,0,-Ns.x,Us.z,0,-Us.x,mo.z,0,-mo.x,-Ns.y,Ns.x,0,-Us.y,Us.x,0,-mo.y,mo.x,0];return!Np(t,Ea,Aa,Ca,Ru)||(t=[1,0,0,0,1,0,0,0,1],!Np(t,Ea,Aa,Ca,Ru))?!1:(Pu.crossVectors(Ns,Us),t=[Pu.x,Pu.y,Pu.z],Np(t,Ea,Aa,Ca,Ru))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ar).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ar).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(es[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),es[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),es[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),es[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),es[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),es[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),es[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),es[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(es),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},es=[new K,new K,new K,new K,new K,new K,new K,new K],ar=new K,Cu=new Nr,Ea=new K,Aa=new K,Ca=new K,Ns=new K,Us=new K,mo=new K,Ol=new K,Ru=new K,Pu=new K,go=new K;function Np(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){go.fromArray(n,s);let a=r.x*Math.abs(go.x)+r.y*Math.abs(go.y)+r.z*Math.abs(go.z),l=e.dot(go),c=t.dot(go),u=i.dot(go);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var An=new K,Iu=new nt,pE=0,ci=class extends lr{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:pE++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Fy,this.updateRanges=[],this.gpuType=ur,this.version=0,this._normalizationScale=e!==void 0?Mm(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Iu.fromBufferAttribute(this,t),Iu.applyMatrix3(e),this.setXY(t,Iu.x,Iu.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)An.fromBufferAttribute(this,t),An.applyMatrix3(e),this.setXYZ(t,An.x,An.y,An.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)An.fromBufferAttribute(this,t),An.applyMatrix4(e),this.setXYZ(t,An.x,An.y,An.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)An.fromBufferAttribute(this,t),An.applyNormalMatrix(e),this.setXYZ(t,An.x,An.y,An.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)An.fromBufferAttribute(this,t),An.transformDirection(e),this.setXYZ(t,An.x,An.y,An.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Vy(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Gy(e,this.array)}};var jl=class extends ci{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Ql=class extends ci{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var mi=class extends ci{constructor(e,t,i){super(new Float32Array(e),t,i)}},mE=new Nr,kl=new K,Up=new K,rs=class{constructor(e=new K,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):mE.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;kl.subVectors(e,this.center);let t=kl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(kl,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Up.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(kl.copy(e.center).add(Up)),this.expandByPoint(kl.copy(e.center).sub(Up))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},gE=0,Hi=new on,Fp=new Di,Ra=new K,Ci=new Nr,Bl=new Nr,Wn=new K,Ur=class n extends lr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:gE++}),this.uuid=Ya(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(VT(e)?Ql:jl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new it().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Hi.makeRotationFromQuaternion(e),this.applyMatrix4(Hi),this}rotateX(e){return Hi.makeRotationX(e),this.applyMatrix4(Hi),this}rotateY(e){return Hi.makeRotationY(e),this.applyMatrix4(Hi),this}rotateZ(e){return Hi.makeRotationZ(e),this.applyMatrix4(Hi),this}translate(e,t,i){return Hi.makeTranslation(e,t,i),this.applyMatrix4(Hi),this}scale(e,t,i){return Hi.makeScale(e,t,i),this.applyMatrix4(Hi),this}lookAt(e){return Fp.lookAt(e),Fp.updateMatrix(),this.applyMatrix4(Fp.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ra).negate(),this.translate(Ra.x,Ra.y,Ra.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new mi(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&Ye("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Nr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];Ci.setFromBufferAttribute(s),this.morphTargetsRelative?(Wn.addVectors(this.boundingBox.min,Ci.min),this.boundingBox.expandByPoint(Wn),Wn.addVectors(this.boundingBox.max,Ci.max),this.boundingBox.expandByPoint(Wn)):(this.boundingBox.expandByPoint(Ci.min),this.boundingBox.expandByPoint(Ci.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new rs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(e){let i=this.boundingSphere.center;if(Ci.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];Bl.setFromBufferAttribute(a),this.morphTargetsRelative?(Wn.addVectors(Ci.min,Bl.min),Ci.expandByPoint(Wn),Wn.addVectors(Ci.max,Bl.max),Ci.expandByPoint(Wn)):(Ci.expandByPoint(Bl.min),Ci.expandByPoint(Bl.max))}Ci.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Wn.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Wn));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Wn.fromBufferAttribute(a,c),l&&(Ra.fromBufferAttribute(e,c),Wn.add(Ra)),r=Math.max(r,i.distanceToSquared(Wn))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ci(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new K,l[k]=new K;let u=new K,d=new K,f=new K,p=new nt,m=new nt,x=new nt,_=new K,g=new K;function b(k,N,L){c[k]=c[N]=c[L]=1,u.fromBufferAttribute(i,k),d.fromBufferAttribute(i,N),f.fromBufferAttribute(i,L),p.fromBufferAttribute(s,k),m.fromBufferAttribute(s,N),x.fromBufferAttribute(s,L),d.sub(u),f.sub(u),m.sub(p),x.sub(p);let B=1/(m.x*x.y-x.x*m.y);isFinite(B)&&(_.copy(d).multiplyScalar(x.y).addScaledVector(f,-m.y).multiplyScalar(B),g.copy(f).multiplyScalar(m.x).addScaledVector(d,-x.x).multiplyScalar(B),a[k].add(_),a[N].add(_),a[L].add(_),l[k].add(g),l[N].add(g),l[L].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let k=0,N=A.length;k<N;++k){let L=A[k],B=L.start,z=L.count;for(let U=B,H=B+z;U<H;U+=3)b(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let S=new K,P=new K,C=new K,v=new K;function E(k){C.fromBufferAttribute(r,k),v.copy(C);let N=a[k];S.copy(N),S.sub(C.multiplyScalar(C.dot(N))).normalize(),P.crossVectors(v,N);let B=P.dot(l[k])<0?-1:1;o.setXYZW(k,S.x,S.y,S.z,B)}for(let k=0,N=i.count;k<N;++k)c[k]&&E(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ci(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let r=new K,s=new K,o=new K,a=new K,l=new K,c=new K,u=new K,d=new K;if(e)for(let f=0,p=e.count;f<p;f+=3){let m=e.getX(f+0),x=e.getX(f+1),_=e.getX(f+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,x),o.fromBufferAttribute(t,_),u.subVectors(o,s),d.subVectors(r,s),u.cross(d),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,_),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(_,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)r.fromBufferAttribute(t,f+0),s.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,s),d.subVectors(r,s),u.cross(d),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Wn.fromBufferAttribute(e,t),Wn.normalize(),e.setXYZ(t,Wn.x,Wn.y,Wn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,f=new c.constructor(l.length*u),p=0,m=0;for(let x=0,_=l.length;x<_;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*u;for(let g=0;g<u;g++)f[m++]=c[p++]}return new ci(f,u,d)}if(this.index===null)return Ye("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,d=c.length;u<d;u++){let f=c[u],p=e(f,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,f=c.length;d<f;d++){let p=c[d];u.push(p.toJSON(e.data))}u.length>0&&(r[l]=u,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(t))}let s=e.morphAttributes;for(let c in s){let u=[],d=s[c];for(let f=0,p=d.length;f<p;f++)u.push(d[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Op=new K,_E=new K,vE=new it,Pi=class{constructor(e=new K(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Op.subVectors(i,t).cross(_E.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Op),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||vE.getNormalMatrix(e),r=this.coplanarPoint(Op).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},yE=0,Bs=class extends lr{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:yE++}),this.uuid=Ya(),this.name="",this.type="Material",this.blending=qa,this.side=qs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Jp,this.blendDst=jp,this.blendEquation=wo,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Mt(0,0,0),this.blendAlpha=0,this.depthFunc=Na,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Py,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Yu,this.stencilZFail=Yu,this.stencilZPass=Yu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ye(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){Ye(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Mt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Pi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new nt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new nt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ts=new K,kp=new K,Lu=new K,Du=new K,xo=class{constructor(e=new K,t=new K(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ts)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ts.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ts.copy(this.origin).addScaledVector(this.direction,t),ts.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){kp.copy(e).add(t).multiplyScalar(.5),Lu.copy(t).sub(e).normalize(),Du.copy(this.origin).sub(kp);let s=e.distanceTo(t)*.5,o=-this.direction.dot(Lu),a=Du.dot(this.direction),l=-Du.dot(Lu),c=Du.lengthSq(),u=Math.abs(1-o*o),d,f,p,m;if(u>0)if(d=o*l-a,f=o*a-l,m=s*u,d>=0)if(f>=-m)if(f<=m){let x=1/u;d*=x,f*=x,p=d*(d+o*f+2*a)+f*(o*d+f+2*l)+c}else f=s,d=Math.max(0,-(o*f+a)),p=-d*d+f*(f+2*l)+c;else f=-s,d=Math.max(0,-(o*f+a)),p=-d*d+f*(f+2*l)+c;else f<=-m?(d=Math.max(0,-(-o*s+a)),f=d>0?-s:Math.min(Math.max(-s,-l),s),p=-d*d+f*(f+2*l)+c):f<=m?(d=0,f=Math.min(Math.max(-s,-l),s),p=f*(f+2*l)+c):(d=Math.max(0,-(o*s+a)),f=d>0?s:Math.min(Math.max(-s,-l),s),p=-d*d+f*(f+2*l)+c);else f=o>0?-s:s,d=Math.max(0,-(o*f+a)),p=-d*d+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),r&&r.copy(kp).addScaledVector(Lu,f),p}intersectSphere(e,t){if(e.radius<0)return null;ts.subVectors(e.center,this.origin);let i=ts.dot(this.direction),r=ts.dot(ts)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,r=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,r=(e.min.x-f.x)*c),u>=0?(s=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(s=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),d>=0?(a=(e.min.z-f.z)*d,l=(e.max.z-f.z)*d):(a=(e.max.z-f.z)*d,l=(e.min.z-f.z)*d),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,ts)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=e.x-o.x,f=e.y-o.y,p=e.z-o.z,m=t.x-o.x,x=t.y-o.y,_=t.z-o.z,g=i.x-o.x,b=i.y-o.y,A=i.z-o.z,S=Math.abs(l),P=Math.abs(c),C=Math.abs(u),v,E,k,N,L,B,z,U,H,Y,G,le;if(S>=P&&S>=C?(k=l,B=d,H=m,le=g,l>=0?(v=c,E=u,N=f,L=p,z=x,U=_,Y=b,G=A):(v=u,E=c,N=p,L=f,z=_,U=x,Y=A,G=b)):P>=C?(k=c,B=f,H=x,le=b,c>=0?(v=u,E=l,N=p,L=d,z=_,U=m,Y=A,G=g):(v=l,E=u,N=d,L=p,z=m,U=_,Y=g,G=A)):(k=u,B=p,H=_,le=A,u>=0?(v=l,E=c,N=d,L=f,z=m,U=x,Y=g,G=b):(v=c,E=l,N=f,L=d,z=x,U=m,Y=b,G=g)),k===0)return null;let J=v/k,Q=E/k,re=1/k,fe=N-J*B,he=L-Q*B,ee=z-J*H,ge=U-Q*H,ye=Y-J*le,Ce=G-Q*le,Me=ye*ge-Ce*ee,qe=fe*Ce-he*ye,ot=ee*he-ge*fe;if(r){if(Me<0||qe<0||ot<0)return null}else if((Me<0||qe<0||ot<0)&&(Me>0||qe>0||ot>0))return null;let He=Me+qe+ot;if(He===0)return null;let dt=re*(Me*B+qe*H+ot*le);return(He>0?dt<0:dt>0)?null:this.at(dt/He,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},lh=class extends Bs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Mt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.combine=Qp,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},qv=new on,_o=new xo,Nu=new rs,Xv=new K,Uu=new K,Fu=new K,Ou=new K,Bp=new K,ku=new K,$v=new K,Bu=new K,qi=class extends Di{constructor(e=new Ur,t=new lh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){ku.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],d=s[l];u!==0&&(Bp.fromBufferAttribute(d,e),o?ku.addScaledVector(Bp,u):ku.addScaledVector(Bp.sub(t),u))}t.add(ku)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Nu.copy(i.boundingSphere),Nu.applyMatrix4(s),_o.copy(e.ray).recast(e.near),!(Nu.containsPoint(_o.origin)===!1&&(_o.intersectSphere(Nu,Xv)===null||_o.origin.distanceToSquared(Xv)>(e.far-e.near)**2))&&(qv.copy(s).invert(),_o.copy(e.ray).applyMatrix4(qv),!(i.boundingBox!==null&&_o.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,_o)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,d=s.attributes.normal,f=s.groups,p=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=f.length;m<x;m++){let _=f[m],g=o[_.materialIndex],b=Math.max(_.start,p.start),A=Math.min(a.count,Math.min(_.start+_.count,p.start+p.count));for(let S=b,P=A;S<P;S+=3){let C=a.getX(S),v=a.getX(S+1),E=a.getX(S+2);r=zu(this,g,e,i,c,u,d,C,v,E),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=_.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let _=m,g=x;_<g;_+=3){let b=a.getX(_),A=a.getX(_+1),S=a.getX(_+2);r=zu(this,o,e,i,c,u,d,b,A,S),r&&(r.faceIndex=Math.floor(_/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,x=f.length;m<x;m++){let _=f[m],g=o[_.materialIndex],b=Math.max(_.start,p.start),A=Math.min(l.count,Math.min(_.start+_.count,p.start+p.count));for(let S=b,P=A;S<P;S+=3){let C=S,v=S+1,E=S+2;r=zu(this,g,e,i,c,u,d,C,v,E),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=_.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let _=m,g=x;_<g;_+=3){let b=_,A=_+1,S=_+2;r=zu(this,o,e,i,c,u,d,b,A,S),r&&(r.faceIndex=Math.floor(_/3),t.push(r))}}}};function xE(n,e,t,i,r,s,o,a){let l;if(e.side===ui?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===qs,a),l===null)return null;Bu.copy(a),Bu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Bu);return c<t.near||c>t.far?null:{distance:c,point:Bu.clone(),object:n}}function zu(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,Uu),n.getVertexPosition(l,Fu),n.getVertexPosition(c,Ou);let u=xE(n,e,t,i,Uu,Fu,Ou,$v);if(u){let d=new K;Os.getBarycoord($v,Uu,Fu,Ou,d),r&&(u.uv=Os.getInterpolatedAttribute(r,a,l,c,d,new nt)),s&&(u.uv1=Os.getInterpolatedAttribute(s,a,l,c,d,new nt)),o&&(u.normal=Os.getInterpolatedAttribute(o,a,l,c,d,new K),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new K,materialIndex:0};Os.getNormal(Uu,Fu,Ou,f.normal),u.face=f,u.barycoord=d}return u}var bo=class extends gi{constructor(e=null,t=1,i=1,r,s,o,a,l,c=qn,u=qn,d,f){super(null,o,a,l,c,u,r,s,d,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ba=class extends ci{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var vo=new rs,bE=new nt(.5,.5),Vu=new K,So=class{constructor(e=new Pi,t=new Pi,i=new Pi,r=new Pi,s=new Pi,o=new Pi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Wi,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],d=s[5],f=s[6],p=s[7],m=s[8],x=s[9],_=s[10],g=s[11],b=s[12],A=s[13],S=s[14],P=s[15];if(r[0].setComponents(c-o,p-u,g-m,P-b).normalize(),r[1].setComponents(c+o,p+u,g+m,P+b).normalize(),r[2].setComponents(c+a,p+d,g+x,P+A).normalize(),r[3].setComponents(c-a,p-d,g-x,P-A).normalize(),i)r[4].setComponents(l,f,_,S).normalize(),r[5].setComponents(c-l,p-f,g-_,P-S).normalize();else if(r[4].setComponents(c-l,p-f,g-_,P-S).normalize(),t===Wi)r[5].setComponents(c+l,p+f,g+_,P+S).normalize();else if(t===$l)r[5].setComponents(l,f,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),vo.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),vo.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(vo)}intersectsSprite(e){vo.center.set(0,0,0);let t=bE.distanceTo(e.center);return vo.radius=.7071067811865476+t,vo.applyMatrix4(e.matrixWorld),this.intersectsSphere(vo)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(Vu.x=r.normal.x>0?e.max.x:e.min.x,Vu.y=r.normal.y>0?e.max.y:e.min.y,Vu.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Vu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Yv=new on,ch=class n{constructor(){this.coordinateSystem=Wi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];Yv.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new So),i[r].setFromProjectionMatrix(Yv,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new So),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var uh=class extends Bs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Mt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},hh=new K,fh=new K,Kv=new on,zl=new xo,Gu=new rs,zp=new K,Zv=new K,dh=class extends Di{constructor(e=new Ur,t=new uh){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let r=1,s=t.count;r<s;r++)hh.fromBufferAttribute(t,r-1),fh.fromBufferAttribute(t,r),i[r]=i[r-1],i[r]+=hh.distanceTo(fh);e.setAttribute("lineDistance",new mi(i,1))}else Ye("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.matrixWorld,s=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Gu.copy(i.boundingSphere),Gu.applyMatrix4(r),Gu.radius+=s,e.ray.intersectsSphere(Gu)===!1)return;Kv.copy(r).invert(),zl.copy(e.ray).applyMatrix4(Kv);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let p=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let x=p,_=m-1;x<_;x+=c){let g=u.getX(x),b=u.getX(x+1),A=Hu(this,e,zl,l,g,b,x);A&&t.push(A)}if(this.isLineLoop){let x=u.getX(m-1),_=u.getX(p),g=Hu(this,e,zl,l,x,_,m-1);g&&t.push(g)}}else{let p=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let x=p,_=m-1;x<_;x+=c){let g=Hu(this,e,zl,l,x,x+1,x);g&&t.push(g)}if(this.isLineLoop){let x=Hu(this,e,zl,l,m-1,p,m-1);x&&t.push(x)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function Hu(n,e,t,i,r,s,o){let a=n.geometry.attributes.position;if(hh.fromBufferAttribute(a,r),fh.fromBufferAttribute(a,s),t.distanceSqToSegment(hh,fh,zp,Zv)>i)return;zp.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(zp);if(!(c<e.near||c>e.far))return{distance:c,point:Zv.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Jv=new K,jv=new K,ec=class extends dh{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let r=0,s=t.count;r<s;r+=2)Jv.fromBufferAttribute(t,r),jv.fromBufferAttribute(t,r+1),i[r]=r===0?0:i[r-1],i[r+1]=i[r]+Jv.distanceTo(jv);e.setAttribute("lineDistance",new mi(i,1))}else Ye("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var tc=class extends gi{constructor(e=[],t=To,i,r,s,o,a,l,c,u){super(e,t,i,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ss=class extends gi{constructor(e,t,i=cr,r,s,o,a=qn,l=qn,c,u=is,d=1){if(u!==is&&u!==as)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:d};super(f,r,s,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Oa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},nc=class extends ss{constructor(e,t=cr,i=To,r,s,o=qn,a=qn,l,c=is){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,r,s,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ic=class extends gi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},za=class n extends Ur{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],d=[],f=0,p=0;m("z","y","x",-1,-1,i,t,e,o,s,0),m("z","y","x",1,-1,i,t,-e,o,s,1),m("x","z","y",1,1,e,i,t,r,o,2),m("x","z","y",1,-1,e,i,-t,r,o,3),m("x","y","z",1,-1,e,t,i,r,s,4),m("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new mi(c,3)),this.setAttribute("normal",new mi(u,3)),this.setAttribute("uv",new mi(d,2));function m(x,_,g,b,A,S,P,C,v,E,k){let N=S/v,L=P/E,B=S/2,z=P/2,U=C/2,H=v+1,Y=E+1,G=0,le=0,J=new K;for(let Q=0;Q<Y;Q++){let re=Q*L-z;for(let fe=0;fe<H;fe++){let he=fe*N-B;J[x]=he*b,J[_]=re*A,J[g]=U,c.push(J.x,J.y,J.z),J[x]=0,J[_]=0,J[g]=C>0?1:-1,u.push(J.x,J.y,J.z),d.push(fe/v),d.push(1-Q/E),G+=1}}for(let Q=0;Q<E;Q++)for(let re=0;re<v;re++){let fe=f+re+H*Q,he=f+re+H*(Q+1),ee=f+(re+1)+H*(Q+1),ge=f+(re+1)+H*Q;l.push(fe,he,ge),l.push(he,ee,ge),le+=6}a.addGroup(p,le,k),p+=le,f+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var rc=class n extends Ur{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,u=l+1,d=e/a,f=t/l,p=[],m=[],x=[],_=[];for(let g=0;g<u;g++){let b=g*f-o;for(let A=0;A<c;A++){let S=A*d-s;m.push(S,-b,0),x.push(0,0,1),_.push(A/a),_.push(1-g/l)}}for(let g=0;g<l;g++)for(let b=0;b<a;b++){let A=b+c*g,S=b+c*(g+1),P=b+1+c*(g+1),C=b+1+c*g;p.push(A,S,C),p.push(S,P,C)}this.setIndex(p),this.setAttribute("position",new mi(m,3)),this.setAttribute("normal",new mi(x,3)),this.setAttribute("uv",new mi(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function Ao(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(Qv(r))r.isRenderTargetTexture?(Ye("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(Qv(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function Qn(n){let e={};for(let t=0;t<n.length;t++){let i=Ao(n[t]);for(let r in i)e[r]=i[r]}return e}function Qv(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function SE(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Tm(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:St.workingColorSpace}var Wy={clone:Ao,merge:Qn},ME=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,wE=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ni=class extends Bs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ME,this.fragmentShader=wE,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ao(e.uniforms),this.uniformsGroups=SE(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new Mt().setHex(r.value);break;case"v2":this.uniforms[i].value=new nt().fromArray(r.value);break;case"v3":this.uniforms[i].value=new K().fromArray(r.value);break;case"v4":this.uniforms[i].value=new an().fromArray(r.value);break;case"m3":this.uniforms[i].value=new it().fromArray(r.value);break;case"m4":this.uniforms[i].value=new on().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},ph=class extends Ni{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var mh=class extends Bs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Cy,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},gh=class extends Bs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Pa(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Wu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var zs=class{constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],s=t[i-1];e:{t:{let o;n:{i:if(!(e<r)){for(let a=i+2;;){if(r===void 0){if(e<s)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(s=r,r=t[++i],e<r)break t}o=t.length;break n}if(!(e>=s)){let a=t[1];e<a&&(i=2,s=a);for(let l=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(r=s,s=t[--i-1],e>=s)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(r=t[i],s=t[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=i[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},_h=class extends zs{constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Gp,endingEnd:Gp}}intervalChanged_(e,t,i){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case Hp:s=e,a=2*t-i;break;case Wp:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Hp:o=e,l=2*i-t;break;case Wp:o=1,l=i+r[1]-r[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,f=this._weightPrev,p=this._weightNext,m=(i-t)/(r-t),x=m*m,_=x*m,g=-f*_+2*f*x-f*m,b=(1+f)*_+(-1.5-2*f)*x+(-.5+f)*m+1,A=(-1-p)*_+(1.5+p)*x+.5*m,S=p*_-p*x;for(let P=0;P!==a;++P)s[P]=g*o[u+P]+b*o[c+P]+A*o[l+P]+S*o[d+P];return s}},vh=class extends zs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(r-t),d=1-u;for(let f=0;f!==a;++f)s[f]=o[c+f]*d+o[l+f]*u;return s}},yh=class extends zs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},xh=class extends zs{interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let m=(i-t)/(r-t),x=1-m;for(let _=0;_!==a;++_)s[_]=o[c+_]*x+o[l+_]*m;return s}let f=a*2,p=e-1;for(let m=0;m!==a;++m){let x=o[c+m],_=o[l+m],g=p*f+m*2,b=d[g],A=d[g+1],S=e*f+m*2,P=u[S],C=u[S+1],v=EE(i,t,b,P,r);s[m]=qy(v,x,A,C,_)}return s}};function qy(n,e,t,i,r){let s=1-n;return s*s*s*e+3*s*s*n*t+3*s*n*n*i+n*n*n*r}function TE(n,e,t,i,r){let s=1-n;return 3*s*s*(t-e)+6*s*n*(i-t)+3*n*n*(r-i)}function EE(n,e,t,i,r){let s=(n-e)/(r-e);for(let o=0;o<8;o++){let a=qy(s,e,t,i,r)-n;if(Math.abs(a)<1e-10)break;let l=TE(s,e,t,i,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var Ui=class{constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Pa(t,this.TimeBufferType),this.values=Pa(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Pa(e.times,Array),values:Pa(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),Wu(e.settings)&&(i.settings={inTangents:Pa(e.settings.inTangents,Array),outTangents:Pa(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new yh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new vh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new _h(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new xh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Wl:t=this.InterpolantFactoryMethodDiscrete;break;case rh:t=this.InterpolantFactoryMethodLinear;break;case $u:t=this.InterpolantFactoryMethodSmooth;break;case Vp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ye("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Wl;case this.InterpolantFactoryMethodLinear:return rh;case this.InterpolantFactoryMethodSmooth:return $u;case this.InterpolantFactoryMethodBezier:return Vp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;Wu(this.settings)&&(ey(this.settings.inTangents,e),ey(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;Wu(this.settings)&&(ty(this.settings.inTangents,e),ty(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<e;)++s;for(;o!==-1&&i[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,s=i.length;s===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&GT(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===$u,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(r)l=!0;else{let d=a*i,f=d-i,p=d+i;for(let m=0;m!==i;++m){let x=t[d+m];if(x!==t[f+m]||x!==t[p+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,f=o*i;for(let p=0;p!==i;++p)t[f+p]=t[d+p]}++o}}if(s>0){e[o]=e[s];for(let a=s*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,Wu(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function ey(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function ty(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ui.prototype.ValueTypeName="";Ui.prototype.TimeBufferType=Float32Array;Ui.prototype.ValueBufferType=Float32Array;Ui.prototype.DefaultInterpolation=rh;var Vs=class extends Ui{constructor(e,t,i){super(e,t,i)}};Vs.prototype.ValueTypeName="bool";Vs.prototype.ValueBufferType=Array;Vs.prototype.DefaultInterpolation=Wl;Vs.prototype.InterpolantFactoryMethodLinear=void 0;Vs.prototype.InterpolantFactoryMethodSmooth=void 0;var bh=class extends Ui{constructor(e,t,i,r){super(e,t,i,r)}};bh.prototype.ValueTypeName="color";var Sh=class extends Ui{constructor(e,t,i,r){super(e,t,i,r)}};Sh.prototype.ValueTypeName="number";var Mh=class extends zs{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(r-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ii.slerpFlat(s,0,o,c-a,o,c,l);return s}},sc=class extends Ui{constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new Mh(this.times,this.values,this.getValueSize(),e)}};sc.prototype.ValueTypeName="quaternion";sc.prototype.InterpolantFactoryMethodSmooth=void 0;var Gs=class extends Ui{constructor(e,t,i){super(e,t,i)}};Gs.prototype.ValueTypeName="string";Gs.prototype.ValueBufferType=Array;Gs.prototype.DefaultInterpolation=Wl;Gs.prototype.InterpolantFactoryMethodLinear=void 0;Gs.prototype.InterpolantFactoryMethodSmooth=void 0;var wh=class extends Ui{constructor(e,t,i,r){super(e,t,i,r)}};wh.prototype.ValueTypeName="vector";var Th=class{constructor(e,t,i){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,f=c.length;d<f;d+=2){let p=c[d],m=c[d+1];if(p.global&&(p.lastIndex=0),p.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Xy=new Th,Eh=class{constructor(e){this.manager=e!==void 0?e:Xy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,s){i.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Eh.DEFAULT_MATERIAL_NAME="__DEFAULT";var qu=new K,Xu=new Ii,Lr=new K,oc=class extends Di{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new on,this.projectionMatrix=new on,this.projectionMatrixInverse=new on,this.coordinateSystem=Wi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(qu,Xu,Lr),Lr.x===1&&Lr.y===1&&Lr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qu,Xu,Lr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(qu,Xu,Lr),Lr.x===1&&Lr.y===1&&Lr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(qu,Xu,Lr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Fs=new K,ny=new nt,iy=new nt,li=class extends oc{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Fa*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Gl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Fa*2*Math.atan(Math.tan(Gl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Fs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Fs.x,Fs.y).multiplyScalar(-e/Fs.z),Fs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Fs.x,Fs.y).multiplyScalar(-e/Fs.z)}getViewSize(e,t){return this.getViewBounds(e,ny,iy),t.subVectors(iy,ny)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Gl*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ah=class extends oc{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Va=class extends Ur{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ia=-90,La=1,Ga=class extends Di{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new li(Ia,La,e,t);r.layers=this.layers,this.add(r);let s=new li(Ia,La,e,t);s.layers=this.layers,this.add(s);let o=new li(Ia,La,e,t);o.layers=this.layers,this.add(o);let a=new li(Ia,La,e,t);a.layers=this.layers,this.add(a);let l=new li(Ia,La,e,t);l.layers=this.layers,this.add(l);let c=new li(Ia,La,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===Wi)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===$l)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,d=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,r),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,f,p),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Ch=class extends li{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Em="\\[\\]\\.:\\/",AE=new RegExp("["+Em+"]","g"),Am="[^"+Em+"]",CE="[^"+Em.replace("\\.","")+"]",RE=/((?:WC+[\/:])*)/.source.replace("WC",Am),PE=/(WCOD+)?/.source.replace("WCOD",CE),IE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Am),LE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Am),DE=new RegExp("^"+RE+PE+IE+LE+"$"),NE=["material","materials","bones","map"],qp=class{constructor(e,t,i){let r=i||Qt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Qt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(AE,"")}static parseTrackName(e){let t=DE.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);NE.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},r=i(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)e[t++]=i[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ye("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Qt.Composite=qp;Qt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Qt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Qt.prototype.GetterByBindingType=[Qt.prototype._getValue_direct,Qt.prototype._getValue_array,Qt.prototype._getValue_arrayElement,Qt.prototype._getValue_toArray];Qt.prototype.SetterByBindingTypeAndVersioning=[[Qt.prototype._setValue_direct,Qt.prototype._setValue_direct_setNeedsUpdate,Qt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_array,Qt.prototype._setValue_array_setNeedsUpdate,Qt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_arrayElement,Qt.prototype._setValue_arrayElement_setNeedsUpdate,Qt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Qt.prototype._setValue_fromArray,Qt.prototype._setValue_fromArray_setNeedsUpdate,Qt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var mN=new Float32Array(1);var Ha=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=_t(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(_t(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Xp=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=r,this}};var ac=class extends lr{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Cm(n,e,t,i){let r=UE(i);switch(t){case fm:return n*e;case pm:return n*e/r.components*r.byteLength;case Uh:return n*e/r.components*r.byteLength;case Xs:return n*e*2/r.components*r.byteLength;case Fh:return n*e*2/r.components*r.byteLength;case dm:return n*e*3/r.components*r.byteLength;case fr:return n*e*4/r.components*r.byteLength;case Oh:return n*e*4/r.components*r.byteLength;case uc:case hc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case fc:case dc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Bh:case Vh:return Math.max(n,16)*Math.max(e,8)/4;case kh:case zh:return Math.max(n,8)*Math.max(e,8)/2;case Gh:case Hh:case qh:case Xh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Wh:case pc:case $h:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Yh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Kh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Zh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Jh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case jh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Qh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ef:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case tf:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case nf:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case rf:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case sf:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case of:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case af:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case lf:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case cf:case uf:case hf:return Math.ceil(n/4)*Math.ceil(e/4)*16;case ff:case df:return Math.ceil(n/4)*Math.ceil(e/4)*8;case mc:case pf:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function UE(n){switch(n){case Fi:case lm:return{byteLength:1,components:1};case $a:case cm:case hr:return{byteLength:2,components:1};case Dh:case Nh:return{byteLength:2,components:4};case cr:case Lh:case ur:return{byteLength:4,components:1};case um:case hm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ye("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function px(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function OE(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((p,m)=>p.start-m.start);let f=0;for(let p=1;p<d.length;p++){let m=d[f],x=d[p];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++f,d[f]=x)}d.length=f+1;for(let p=0,m=d.length;p<m;p++){let x=d[p];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var kE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,BE=`#ifdef USE_ALPHAHASH
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
#endif`,zE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,VE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,GE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,HE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,WE=`#ifdef USE_AOMAP
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
#endif`,qE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,XE=`#ifdef USE_BATCHING
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
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,$E=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,YE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,KE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ZE=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,JE=`#ifdef USE_IRIDESCENCE
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
#endif`,jE=`#ifdef USE_BUMPMAP
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
#endif`,QE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,eA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,tA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,nA=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,iA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,rA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,sA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,oA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,aA=`#define PI 3.141592653589793
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
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
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
} // validated`,lA=`vec3 transformedNormal = objectNormal;
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
#endif`,cA=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,uA=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,hA=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,fA=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,dA="gl_FragColor = linearToOutputTexel( gl_FragColor );",pA=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,mA=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,gA=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,_A=`#ifdef USE_ENVMAP
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
#endif`,vA=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,yA=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,xA=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,bA=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,SA=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,MA=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,wA=`#ifdef USE_GRADIENTMAP
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
}`,TA=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,EA=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,AA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,CA=`uniform bool receiveShadow;
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
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
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
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
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
#endif
#include <lightprobes_pars_fragment>`,RA=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,PA=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,IA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,LA=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,DA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,NA=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
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
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
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
#endif`,UA=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
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
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
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
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
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
		return 0.5 / max( gv + gl, EPSILON );
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
		float roughness = max( material.clearcoatRoughness, 0.045 );
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
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
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
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
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
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
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
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
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
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,FA=`
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
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
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
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,OA=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,kA=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,BA=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,zA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,VA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,GA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,HA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,WA=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,qA=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,XA=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,$A=`#if defined( USE_POINTS_UV )
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
#endif`,YA=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,KA=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ZA=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,JA=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,jA=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,QA=`#ifdef USE_MORPHTARGETS
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
#endif`,eC=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,tC=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#ifdef DOUBLE_SIDED
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
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,nC=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,iC=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,rC=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,sC=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,oC=`#ifdef USE_NORMALMAP
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
#endif`,aC=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,lC=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,cC=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,uC=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,hC=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,fC=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,dC=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,pC=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,mC=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,gC=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,_C=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,vC=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,yC=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
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
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
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
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,xC=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
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
#endif`,bC=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
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
#endif`,SC=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
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
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
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
}`,MC=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,wC=`#ifdef USE_SKINNING
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
#endif`,TC=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,EC=`#ifdef USE_SKINNING
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
#endif`,AC=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,CC=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,RC=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,PC=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,IC=`#ifdef USE_TRANSMISSION
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
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,LC=`#ifdef USE_TRANSMISSION
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
#endif`,DC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,NC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
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
#endif`,UC=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
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
#endif`,FC=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,OC=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,kC=`uniform sampler2D t2D;
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
}`,BC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,zC=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VC=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,GC=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,HC=`#include <common>
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
}`,WC=`#if DEPTH_PACKING == 3200
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
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,qC=`#define DISTANCE
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
}`,XC=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,$C=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,YC=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,KC=`uniform float scale;
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
}`,ZC=`uniform vec3 diffuse;
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
}`,JC=`#include <common>
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
}`,jC=`uniform vec3 diffuse;
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
}`,QC=`#define LAMBERT
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
}`,eR=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,tR=`#define MATCAP
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
}`,nR=`#define MATCAP
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
}`,iR=`#define NORMAL
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
}`,rR=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
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
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,sR=`#define PHONG
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
}`,oR=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
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
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
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
}`,aR=`#define STANDARD
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
}`,lR=`#define STANDARD
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
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
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
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
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
}`,cR=`#define TOON
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
}`,uR=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
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
}`,hR=`uniform float size;
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
}`,fR=`uniform vec3 diffuse;
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
}`,dR=`#include <common>
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
}`,pR=`uniform vec3 color;
uniform float opacity;
#include <common>
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
	#include <premultiplied_alpha_fragment>
}`,mR=`uniform float rotation;
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
}`,gR=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:kE,alphahash_pars_fragment:BE,alphamap_fragment:zE,alphamap_pars_fragment:VE,alphatest_fragment:GE,alphatest_pars_fragment:HE,aomap_fragment:WE,aomap_pars_fragment:qE,batching_pars_vertex:XE,batching_vertex:$E,begin_vertex:YE,beginnormal_vertex:KE,bsdfs:ZE,iridescence_fragment:JE,bumpmap_pars_fragment:jE,clipping_planes_fragment:QE,clipping_planes_pars_fragment:eA,clipping_planes_pars_vertex:tA,clipping_planes_vertex:nA,color_fragment:iA,color_pars_fragment:rA,color_pars_vertex:sA,color_vertex:oA,common:aA,defaultnormal_vertex:lA,displacementmap_pars_vertex:cA,displacementmap_vertex:uA,emissivemap_fragment:hA,emissivemap_pars_fragment:fA,colorspace_fragment:dA,colorspace_pars_fragment:pA,envmap_fragment:mA,envmap_common_pars_fragment:gA,envmap_pars_fragment:_A,envmap_pars_vertex:vA,envmap_physical_pars_fragment:RA,envmap_vertex:yA,fog_vertex:xA,fog_pars_vertex:bA,fog_fragment:SA,fog_pars_fragment:MA,gradientmap_pars_fragment:wA,lightmap_pars_fragment:TA,lights_lambert_fragment:EA,lights_lambert_pars_fragment:AA,lights_pars_begin:CA,lights_toon_fragment:PA,lights_toon_pars_fragment:IA,lights_phong_fragment:LA,lights_phong_pars_fragment:DA,lights_physical_fragment:NA,lights_physical_pars_fragment:UA,lights_fragment_begin:FA,lights_fragment_maps:OA,lights_fragment_end:kA,lightprobes_pars_fragment:BA,logdepthbuf_fragment:zA,logdepthbuf_pars_fragment:VA,logdepthbuf_pars_vertex:GA,logdepthbuf_vertex:HA,map_fragment:WA,map_pars_fragment:qA,map_particle_fragment:XA,map_particle_pars_fragment:$A,metalnessmap_fragment:YA,metalnessmap_pars_fragment:KA,morphinstance_vertex:ZA,morphcolor_vertex:JA,morphnormal_vertex:jA,morphtarget_pars_vertex:QA,morphtarget_vertex:eC,normal_fragment_begin:tC,normal_fragment_maps:nC,normal_pars_fragment:iC,normal_pars_vertex:rC,normal_vertex:sC,normalmap_pars_fragment:oC,clearcoat_normal_fragment_begin:aC,clearcoat_normal_fragment_maps:lC,clearcoat_pars_fragment:cC,iridescence_pars_fragment:uC,opaque_fragment:hC,packing:fC,premultiplied_alpha_fragment:dC,project_vertex:pC,dithering_fragment:mC,dithering_pars_fragment:gC,roughnessmap_fragment:_C,roughnessmap_pars_fragment:vC,shadowmap_pars_fragment:yC,shadowmap_pars_vertex:xC,shadowmap_vertex:bC,shadowmask_pars_fragment:SC,skinbase_vertex:MC,skinning_pars_vertex:wC,skinning_vertex:TC,skinnormal_vertex:EC,specularmap_fragment:AC,specularmap_pars_fragment:CC,tonemapping_fragment:RC,tonemapping_pars_fragment:PC,transmission_fragment:IC,transmission_pars_fragment:LC,uv_pars_fragment:DC,uv_pars_vertex:NC,uv_vertex:UC,worldpos_vertex:FC,background_vert:OC,background_frag:kC,backgroundCube_vert:BC,backgroundCube_frag:zC,cube_vert:VC,cube_frag:GC,depth_vert:HC,depth_frag:WC,distance_vert:qC,distance_frag:XC,equirect_vert:$C,equirect_frag:YC,linedashed_vert:KC,linedashed_frag:ZC,meshbasic_vert:JC,meshbasic_frag:jC,meshlambert_vert:QC,meshlambert_frag:eR,meshmatcap_vert:tR,meshmatcap_frag:nR,meshnormal_vert:iR,meshnormal_frag:rR,meshphong_vert:sR,meshphong_frag:oR,meshphysical_vert:aR,meshphysical_frag:lR,meshtoon_vert:cR,meshtoon_frag:uR,points_vert:hR,points_frag:fR,shadow_vert:dR,shadow_frag:pR,sprite_vert:mR,sprite_frag:gR},De={common:{diffuse:{value:new Mt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new nt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Mt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Mt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new Mt(16777215)},opacity:{value:1},center:{value:new nt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},kr={basic:{uniforms:Qn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:Qn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Mt(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:Qn([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Mt(0)},specular:{value:new Mt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:Qn([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new Mt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:Qn([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new Mt(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:Qn([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:Qn([De.points,De.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:Qn([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:Qn([De.common,De.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:Qn([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:Qn([De.sprite,De.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:Qn([De.common,De.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:Qn([De.lights,De.fog,{color:{value:new Mt(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};kr.physical={uniforms:Qn([kr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new nt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new Mt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new nt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new Mt(0)},specularColor:{value:new Mt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new nt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var mf={r:0,b:0,g:0},_R=new on,mx=new it;mx.set(-1,0,0,0,1,0,0,0,1);function vR(n,e,t,i,r,s){let o=new Mt(0),a=r===!0?0:1,l,c,u=null,d=0,f=null;function p(b){let A=b.isScene===!0?b.background:null;if(A&&A.isTexture){let S=b.backgroundBlurriness>0;A=e.get(A,S)}return A}function m(b){let A=!1,S=p(b);S===null?_(o,a):S&&S.isColor&&(_(S,1),A=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,s):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(b,A){let S=p(A);S&&S.isCubeTexture?(c===void 0&&(c=new qi(new za(1,1,1),new Ni({name:"BackgroundCubeMaterial",uniforms:Ao(kr.backgroundCube.uniforms),vertexShader:kr.backgroundCube.vertexShader,fragmentShader:kr.backgroundCube.fragmentShader,side:ui,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(_R.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(mx),c.material.toneMapped=St.getTransfer(S.colorSpace)!==Ot,(u!==S||d!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,d=S.version,f=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new qi(new rc(2,2),new Ni({name:"BackgroundMaterial",uniforms:Ao(kr.background.uniforms),vertexShader:kr.background.vertexShader,fragmentShader:kr.background.fragmentShader,side:qs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=St.getTransfer(S.colorSpace)!==Ot,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||d!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,d=S.version,f=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function _(b,A){b.getRGB(mf,Tm(n)),t.buffers.color.setClear(mf.r,mf.g,mf.b,A,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,A=1){o.set(b),a=A,_(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,_(o,a)},render:m,addToRenderList:x,dispose:g}}function yR(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=f(null),s=r,o=!1;function a(L,B,z,U,H){let Y=!1,G=d(L,U,z,B);s!==G&&(s=G,c(s.object)),Y=p(L,U,z,H),Y&&m(L,U,z,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(L,B,z,U),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function d(L,B,z,U){let H=U.wireframe===!0,Y=i[B.id];Y===void 0&&(Y={},i[B.id]=Y);let G=L.isInstancedMesh===!0?L.id:0,le=Y[G];le===void 0&&(le={},Y[G]=le);let J=le[z.id];J===void 0&&(J={},le[z.id]=J);let Q=J[H];return Q===void 0&&(Q=f(l()),J[H]=Q),Q}function f(L){let B=[],z=[],U=[];for(let H=0;H<t;H++)B[H]=0,z[H]=0,U[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:z,attributeDivisors:U,object:L,attributes:{},index:null}}function p(L,B,z,U){let H=s.attributes,Y=B.attributes,G=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let re=H[J],fe=Y[J];if(fe===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),re===void 0||re.attribute!==fe||fe&&re.data!==fe.data)return!0;G++}return s.attributesNum!==G||s.index!==U}function m(L,B,z,U){let H={},Y=B.attributes,G=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let re=Y[J];re===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(re=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(re=L.instanceColor));let fe={};fe.attribute=re,re&&re.data&&(fe.data=re.data),H[J]=fe,G++}s.attributes=H,s.attributesNum=G,s.index=U}function x(){let L=s.newAttributes;for(let B=0,z=L.length;B<z;B++)L[B]=0}function _(L){g(L,0)}function g(L,B){let z=s.newAttributes,U=s.enabledAttributes,H=s.attributeDivisors;z[L]=1,U[L]===0&&(n.enableVertexAttribArray(L),U[L]=1),H[L]!==B&&(n.vertexAttribDivisor(L,B),H[L]=B)}function b(){let L=s.newAttributes,B=s.enabledAttributes;for(let z=0,U=B.length;z<U;z++)B[z]!==L[z]&&(n.disableVertexAttribArray(z),B[z]=0)}function A(L,B,z,U,H,Y,G){G===!0?n.vertexAttribIPointer(L,B,z,H,Y):n.vertexAttribPointer(L,B,z,U,H,Y)}function S(L,B,z,U){x();let H=U.attributes,Y=z.getAttributes(),G=B.defaultAttributeValues;for(let le in Y){let J=Y[le];if(J.location>=0){let Q=H[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let re=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,ge=he.type,ye=he.bytesPerElement,Ce=ge===n.INT||ge===n.UNSIGNED_INT||Q.gpuType===Lh;if(Q.isInterleavedBufferAttribute){let Me=Q.data,qe=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,ot=Q.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let He=0;He<J.locationSize;He++)g(J.location+He,Me.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let He=0;He<J.locationSize;He++)_(J.location+He);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let He=0;He<J.locationSize;He++)A(J.location+He,fe/J.locationSize,ge,re,qe*ye,(ot+fe/J.locationSize*He)*ye,Ce)}else{if(Q.isInstancedBufferAttribute){for(let Me=0;Me<J.locationSize;Me++)g(J.location+Me,Q.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Me=0;Me<J.locationSize;Me++)_(J.location+Me);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Me=0;Me<J.locationSize;Me++)A(J.location+Me,fe/J.locationSize,ge,re,fe*ye,fe/J.locationSize*Me*ye,Ce)}}else if(G!==void 0){let re=G[le];if(re!==void 0)switch(re.length){case 2:n.vertexAttrib2fv(J.location,re);break;case 3:n.vertexAttrib3fv(J.location,re);break;case 4:n.vertexAttrib4fv(J.location,re);break;default:n.vertexAttrib1fv(J.location,re)}}}}b()}function P(){k();for(let L in i){let B=i[L];for(let z in B){let U=B[z];for(let H in U){let Y=U[H];for(let G in Y)u(Y[G].object),delete Y[G];delete U[H]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let B=i[L.id];for(let z in B){let U=B[z];for(let H in U){let Y=U[H];for(let G in Y)u(Y[G].object),delete Y[G];delete U[H]}}delete i[L.id]}function v(L){for(let B in i){let z=i[B];for(let U in z){let H=z[U];if(H[L.id]===void 0)continue;let Y=H[L.id];for(let G in Y)u(Y[G].object),delete Y[G];delete H[L.id]}}}function E(L){for(let B in i){let z=i[B],U=L.isInstancedMesh===!0?L.id:0,H=z[U];if(H!==void 0){for(let Y in H){let G=H[Y];for(let le in G)u(G[le].object),delete G[le];delete H[Y]}delete z[U],Object.keys(z).length===0&&delete i[B]}}}function k(){N(),o=!0,s!==r&&(s=r,c(s.object))}function N(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:k,resetDefaultState:N,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:x,enableAttribute:_,disableUnusedAttributes:b}}function xR(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let p=0;p<u;p++)f+=c[p];t.update(f,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function bR(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(v){return!(v!==fr&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===hr&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Fi&&v!==ur&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ye("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ye("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ye("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),_=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:_,maxAttributes:g,maxVertexUniforms:b,maxVaryings:A,maxFragmentUniforms:S,maxSamples:P,samples:C}}function SR(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Pi,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,f){let p=d.length!==0||f||i!==0||r;return r=f,i=d.length,p},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(d,f){t=u(d,f,0)},this.setState=function(d,f,p){let m=d.clippingPlanes,x=d.clipIntersection,_=d.clipShadows,g=n.get(d);if(!r||m===null||m.length===0||s&&!_)s?u(null):c();else{let b=s?0:i,A=b*4,S=g.clippingState||null;l.value=S,S=u(m,f,A,p);for(let P=0;P!==A;++P)S[P]=t[P];g.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,f,p,m){let x=d!==null?d.length:0,_=null;if(x!==0){if(_=l.value,m!==!0||_===null){let g=p+x*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(_===null||_.length<g)&&(_=new Float32Array(g));for(let A=0,S=p;A!==x;++A,S+=4)o.copy(d[A]).applyMatrix4(b,a),o.normal.toArray(_,S),_[S+3]=o.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,_}}var vc=class extends Li{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new tc(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new za(5,5,5),s=new Ni({name:"CubemapFromEquirect",uniforms:Ao(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ui,blending:Mo});s.uniforms.tEquirect.value=t;let o=new qi(r,s),a=t.minFilter;return t.minFilter===os&&(t.minFilter=$n),new Ga(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}},$y=256,MR=3,wR=20,gx=256,_x=16,TR=3,ER=new K,AR=new Mt,_f=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ga(1,10,null),this._boxMesh=new qi(new za(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=ER}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(AR));let _=new Ga(i,r,u);return _.position.copy(a),_.update(l,e),l.autoClear=d,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=m,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Zy(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Ky(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max($y,Sm(e))}_fromTexture(e,t){e.mapping===To||e.mapping===Xa?this._setSize(e.image.length===0?$y:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Yy(e,!1,!1),i=Math.log2(e)-MR;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Yy(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===To||e.mapping===Xa?(this._cubemapMaterial===null&&(this._cubemapMaterial=Zy()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Ky()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=CR(),this._integrationMaterial=RR());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/_x);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-TR)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(gx*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=PR());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function Yy(n,e,t){return new vc(n,{minFilter:os,generateMipmaps:e,type:hr,colorSpace:ql,depthBuffer:t})}function yc(n,e,t){return new Ni({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:ui,blending:Mo,depthTest:!1,depthWrite:!1})}function CR(){return yc("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${gx}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function RR(){return yc("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:_x}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function PR(){return yc("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${wR}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Ky(){return yc("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Zy(){return yc("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function IR(n){let e=new WeakMap,t=new WeakMap,i=null;function r(f,p=!1){return f==null?null:p?o(f):s(f)}function s(f){if(f&&f.isTexture){let p=f.mapping;if(p===Rh||p===Ph)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let x=new vc(m.height);return x.fromEquirectangularTexture(n,f),e.set(f,x),f.addEventListener("dispose",c),a(x.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,m=p===Rh||p===Ph,x=p===To||p===Xa;if(m||x){let _=t.get(f),g=_!==void 0?_.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return i===null&&(i=new _f(n)),_=m?i.fromEquirectangular(f,_):i.fromCubemap(f,_),_.texture.pmremVersion=f.pmremVersion,t.set(f,_),_.texture;if(_!==void 0)return _.texture;{let b=f.image;return m&&b&&b.height>0||x&&b&&l(b)?(i===null&&(i=new _f(n)),_=m?i.fromEquirectangular(f):i.fromCubemap(f),_.texture.pmremVersion=f.pmremVersion,t.set(f,_),f.addEventListener("dispose",u),_.texture):null}}}return f}function a(f,p){return p===Rh?f.mapping=To:p===Ph&&(f.mapping=Xa),f}function l(f){let p=0,m=6;for(let x=0;x<m;x++)f[x]!==void 0&&p++;return p===m}function c(f){let p=f.target;p.removeEventListener("dispose",c);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function u(f){let p=f.target;p.removeEventListener("dispose",u);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:d}}function LR(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&Vl("WebGLRenderer: "+i+" extension not supported."),r}}}function DR(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let _ in m.attributes)e.remove(m.attributes[_]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let x=s.get(m);x&&(e.remove(x),s.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,x){return r[x.id]!==void 0||(x.addEventListener("dispose",a),r[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(m){let x=m.attributes;for(let _ in x)e.update(x[_],n.ARRAY_BUFFER)}function d(m){let x=m.index,_=m.attributes.position,g=0;if(_===void 0)return;let b=x!==null?x.array.length:_.array.length/3-1,A=_.count>=65535?Ql:jl,S=new A(Math.ceil(b/3)*6,1),P=S.array;if(x!==null){let v=x.array;g=x.version;for(let E=0,k=0;E<b;E+=3){let N=v[E+0],L=v[E+1],B=v[E+2];P[k++]=N,P[k++]=L,P[k++]=L,P[k++]=B,P[k++]=B,P[k++]=N}}else{g=_.version;for(let v=0,E=0;v<b;v+=3){let k=v+0,N=v+1,L=v+2;P[E++]=k,P[E++]=N,P[E++]=N,P[E++]=L,P[E++]=L,P[E++]=k}}S.version=g;let C=s.get(m);C&&e.remove(C),s.set(m,S)}function f(m){let x=s.get(m);if(x){let _=m.index;_!==null&&x.version<_.version&&d(m)}else d(m);return s.get(m)}function p(){for(let m in r){let x=r[m].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:f,dispose:p}}function NR(n,e,t){let i;function r(d){i=d}let s,o;function a(d){s=d.type,o=d.bytesPerElement}function l(d,f){n.drawElements(i,f,s,d*o),t.update(f,i,1)}function c(d,f,p){p!==0&&(n.drawElementsInstanced(i,f,s,d*o,p),t.update(f,i,p))}function u(d,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,s,d,0,p);let x=0;for(let _=0;_<p;_++)x+=f[_];t.update(x,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function UR(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function FR(n,e,t){let i=new WeakMap,r=new an;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==d){let k=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",k)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],A=0;p===!0&&(A=1),m===!0&&(A=2),x===!0&&(A=3);let S=a.attributes.position.count*A,P=1;S>e.maxTextureSize&&(P=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*P*4*d),v=new Kl(C,S,P,d);v.type=ur,v.needsUpdate=!0;let E=A*4;for(let N=0;N<d;N++){let L=_[N],B=g[N],z=b[N],U=S*P*4*N;for(let H=0;H<L.count;H++){let Y=H*E;p===!0&&(r.fromBufferAttribute(L,H),C[U+Y+0]=r.x,C[U+Y+1]=r.y,C[U+Y+2]=r.z,C[U+Y+3]=0),m===!0&&(r.fromBufferAttribute(B,H),C[U+Y+4]=r.x,C[U+Y+5]=r.y,C[U+Y+6]=r.z,C[U+Y+7]=0),x===!0&&(r.fromBufferAttribute(z,H),C[U+Y+8]=r.x,C[U+Y+9]=r.y,C[U+Y+10]=r.z,C[U+Y+11]=z.itemSize===4?r.w:1)}}f={count:d,texture:v,size:new nt(S,P)},i.set(a,f),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:s}}function OR(n,e,t,i,r){let s=new WeakMap;function o(c){let u=r.render.frame,d=c.geometry,f=e.get(c,d);if(s.get(f)!==u&&(e.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==u&&(p.update(),s.set(p,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var kR={[em]:"LINEAR_TONE_MAPPING",[tm]:"REINHARD_TONE_MAPPING",[nm]:"CINEON_TONE_MAPPING",[im]:"ACES_FILMIC_TONE_MAPPING",[sm]:"AGX_TONE_MAPPING",[om]:"NEUTRAL_TONE_MAPPING",[rm]:"CUSTOM_TONE_MAPPING"};function BR(n,e,t,i,r,s){let o=new Li(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Ur;u.setAttribute("position",new mi([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new mi([0,2,0,0,2,0],2));let d=new ph({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new qi(u,d),p=new Ah(-1,1,1,-1,0,1),m=null,x=null,_=!1,g,b=null,A=[],S=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let v=0;v<A.length;v++){let E=A[v];E.setSize&&E.setSize(P,C)}},this.setEffects=function(P){A=P,S=A.length>0&&A[0].isRenderPass===!0;let C=o.width,v=o.height;A.length>0&&a===null&&(a=new Li(C,v,{type:hr,depthBuffer:!1,stencilBuffer:!1}),l=new Li(C,v,{type:hr,depthBuffer:!1,stencilBuffer:!1}));let E=r===!0&&A.some(k=>k.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new ss(C,v),s===!0&&(c.format=as,c.type=Eo)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let k=0;k<A.length;k++){let N=A[k];N.setSize&&N.setSize(C,v),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(P,C){if(_||P.toneMapping===Fr&&A.length===0)return!1;if(b=C,C!==null){let v=C.width,E=C.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return S===!1&&P.setRenderTarget(o),g=P.toneMapping,P.toneMapping=Fr,!0},this.hasRenderPass=function(){return S},this.end=function(P,C){P.toneMapping=g,_=!0;let v=o,E=a;for(let k=0;k<A.length;k++){let N=A[k];N.enabled!==!1&&(N.render(P,E,v,C),N.needsSwap!==!1&&(v=E,E=E===a?l:a))}if(m!==P.outputColorSpace||x!==P.toneMapping){m=P.outputColorSpace,x=P.toneMapping,d.defines={},St.getTransfer(m)===Ot&&(d.defines.SRGB_TRANSFER="");let k=kR[x];k&&(d.defines[k]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=v.texture,P.setRenderTarget(b),P.render(f,p),b=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var vx=new gi,yx=new ss(1,1),xx=new nc(1),bx=new Kl,Sx=new ah,Mx=new tc,Jy=[],jy=[],Qy=new Float32Array(16),ex=new Float32Array(9),tx=new Float32Array(4);function Za(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=Jy[r];if(s===void 0&&(s=new Float32Array(r),Jy[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Nn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Un(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function yf(n,e){let t=jy[e];t===void 0&&(t=new Int32Array(e),jy[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function zR(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function VR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nn(t,e))return;n.uniform2fv(this.addr,e),Un(t,e)}}function GR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Nn(t,e))return;n.uniform3fv(this.addr,e),Un(t,e)}}function HR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nn(t,e))return;n.uniform4fv(this.addr,e),Un(t,e)}}function WR(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Un(t,e)}else{if(Nn(t,i))return;tx.set(i),n.uniformMatrix2fv(this.addr,!1,tx),Un(t,i)}}function qR(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Un(t,e)}else{if(Nn(t,i))return;ex.set(i),n.uniformMatrix3fv(this.addr,!1,ex),Un(t,i)}}function XR(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Un(t,e)}else{if(Nn(t,i))return;Qy.set(i),n.uniformMatrix4fv(this.addr,!1,Qy),Un(t,i)}}function $R(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function YR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nn(t,e))return;n.uniform2iv(this.addr,e),Un(t,e)}}function KR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Nn(t,e))return;n.uniform3iv(this.addr,e),Un(t,e)}}function ZR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nn(t,e))return;n.uniform4iv(this.addr,e),Un(t,e)}}function JR(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function jR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nn(t,e))return;n.uniform2uiv(this.addr,e),Un(t,e)}}function QR(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Nn(t,e))return;n.uniform3uiv(this.addr,e),Un(t,e)}}function eP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nn(t,e))return;n.uniform4uiv(this.addr,e),Un(t,e)}}function xf(n){return n.version===0&&(n.compareFunction=vm,n.needsUpdate=!0),n}function tP(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=xf(yx):s=vx,t.setTexture2D(e||s,r)}function nP(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||Sx,r)}function iP(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=xf(xx):s=Mx,t.setTextureCube(e||s,r)}function rP(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||bx,r)}function sP(n){switch(n){case 5126:return zR;case 35664:return VR;case 35665:return GR;case 35666:return HR;case 35674:return WR;case 35675:return qR;case 35676:return XR;case 5124:case 35670:return $R;case 35667:case 35671:return YR;case 35668:case 35672:return KR;case 35669:case 35673:return ZR;case 5125:return JR;case 36294:return jR;case 36295:return QR;case 36296:return eP;case 35678:case 36198:case 36298:case 36306:case 35682:return tP;case 35679:case 36299:case 36307:return nP;case 35680:case 36300:case 36308:case 36293:return iP;case 36289:case 36303:case 36311:case 36292:return rP}}function oP(n,e){n.uniform1fv(this.addr,e)}function aP(n,e){let t=Za(e,this.size,2);n.uniform2fv(this.addr,t)}function lP(n,e){let t=Za(e,this.size,3);n.uniform3fv(this.addr,t)}function cP(n,e){let t=Za(e,this.size,4);n.uniform4fv(this.addr,t)}function uP(n,e){let t=Za(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function hP(n,e){let t=Za(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function fP(n,e){let t=Za(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function dP(n,e){n.uniform1iv(this.addr,e)}function pP(n,e){n.uniform2iv(this.addr,e)}function mP(n,e){n.uniform3iv(this.addr,e)}function gP(n,e){n.uniform4iv(this.addr,e)}function _P(n,e){n.uniform1uiv(this.addr,e)}function vP(n,e){n.uniform2uiv(this.addr,e)}function yP(n,e){n.uniform3uiv(this.addr,e)}function xP(n,e){n.uniform4uiv(this.addr,e)}function bP(n,e,t){let i=this.cache,r=e.length,s=yf(t,r);Nn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=xf(yx):o=vx;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function SP(n,e,t){let i=this.cache,r=e.length,s=yf(t,r);Nn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||Sx,s[o])}function MP(n,e,t){let i=this.cache,r=e.length,s=yf(t,r);Nn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=xf(xx):o=Mx;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function wP(n,e,t){let i=this.cache,r=e.length,s=yf(t,r);Nn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||bx,s[o])}function TP(n){switch(n){case 5126:return oP;case 35664:return aP;case 35665:return lP;case 35666:return cP;case 35674:return uP;case 35675:return hP;case 35676:return fP;case 5124:case 35670:return dP;case 35667:case 35671:return pP;case 35668:case 35672:return mP;case 35669:case 35673:return gP;case 5125:return _P;case 36294:return vP;case 36295:return yP;case 36296:return xP;case 35678:case 36198:case 36298:case 36306:case 35682:return bP;case 35679:case 36299:case 36307:return SP;case 35680:case 36300:case 36308:case 36293:return MP;case 36289:case 36303:case 36311:case 36292:return wP}}var Im=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=sP(t.type)}},Lm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=TP(t.type)}},Dm=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},Rm=/(\w+)(\])?(\[|\.)?/g;function nx(n,e){n.seq.push(e),n.map[e.id]=e}function EP(n,e,t){let i=n.name,r=i.length;for(Rm.lastIndex=0;;){let s=Rm.exec(i),o=Rm.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){nx(t,c===void 0?new Im(a,n,e):new Lm(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new Dm(a),nx(t,d)),t=d}}}var Ka=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);EP(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function ix(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var AP=37297,CP=0;function RP(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var rx=new it;function PP(n){St._getMatrix(rx,St.workingColorSpace,n);let e=`mat3( ${rx.elements.map(t=>t.toFixed(4))} )`;switch(St.getTransfer(n)){case Xl:return[e,"LinearTransferOETF"];case Ot:return[e,"sRGBTransferOETF"];default:return Ye("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function sx(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+RP(n.getShaderSource(e),a)}else return s}function IP(n,e){let t=PP(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var LP={[em]:"Linear",[tm]:"Reinhard",[nm]:"Cineon",[im]:"ACESFilmic",[sm]:"AgX",[om]:"Neutral",[rm]:"Custom"};function DP(n,e){let t=LP[e];return t===void 0?(Ye("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var gf=new K;function NP(){St.getLuminanceCoefficients(gf);let n=gf.x.toFixed(4),e=gf.y.toFixed(4),t=gf.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function UP(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(_c).join(`
`)}function FP(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function OP(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function _c(n){return n!==""}function ox(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function ax(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var kP=/^[ \t]*#include +<([\w\d./]+)>/gm;function Nm(n){return n.replace(kP,BP)}function BP(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Nm(t)}var zP=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function lx(n){return n.replace(zP,VP)}function VP(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function cx(n){let e=`precision ${n.precision} float;
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
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var GP={[lc]:"SHADOWMAP_TYPE_PCF",[Wa]:"SHADOWMAP_TYPE_VSM"};function HP(n){return GP[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var WP={[Xa]:"ENVMAP_MODE_REFRACTION"};function qP(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":WP[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var XP={[Qp]:"ENVMAP_BLENDING_MULTIPLY",[Ty]:"ENVMAP_BLENDING_MIX",[Ey]:"ENVMAP_BLENDING_ADD"};function $P(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":XP[n.combine]||"ENVMAP_BLENDING_NONE"}function YP(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=HP(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=qP(t),d=$P(t),f=UP(t),p=FP(s),m=r.createProgram(),x,_,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(_c).join(`
`),x.length>0&&(x+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(_c).join(`
`),_.length>0&&(_+=`
`)):(x=[cx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(_c).join(`
`),_=[cx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Fr?"#define TONE_MAPPING":"",t.toneMapping!==Fr?ft.tonemapping_pars_fragment:"",t.toneMapping!==Fr?DP("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,IP("linearToOutputTexel",t.outputColorSpace),NP(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(_c).join(`
`)),o=Nm(o),o=ox(o,t),o=ax(o,t),a=Nm(a),a=ox(a,t),a=ax(a,t),o=lx(o),a=lx(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,_=["#define varying in",t.glslVersion===ym?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ym?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let b=g+x+o,A=g+_+a,S=ix(r,r.VERTEX_SHADER,b),P=ix(r,r.FRAGMENT_SHADER,A);r.attachShader(m,S),r.attachShader(m,P),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function C(N){if(n.debug.checkShaderErrors){let L=r.getProgramInfoLog(m)||"",B=r.getShaderInfoLog(S)||"",z=r.getShaderInfoLog(P)||"",U=L.trim(),H=B.trim(),Y=z.trim(),G=!0,le=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,m,S,P);else{let J=sx(r,S,"vertex"),Q=sx(r,P,"fragment");tt("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+U+`
`+J+`
`+Q)}else U!==""?Ye("WebGLProgram: Program Info Log:",U):(H===""||Y==="")&&(le=!1);le&&(N.diagnostics={runnable:G,programLog:U,vertexShader:{log:H,prefix:x},fragmentShader:{log:Y,prefix:_}})}r.deleteShader(S),r.deleteShader(P),v=new Ka(r,m),E=OP(r,m)}let v;this.getUniforms=function(){return v===void 0&&C(this),v};let E;this.getAttributes=function(){return E===void 0&&C(this),E};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=r.getProgramParameter(m,AP)),k},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=CP++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=P,this}var KP=0,Um=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Fm(e),t.set(e,i)),i}},Fm=class{constructor(e){this.id=KP++,this.code=e,this.usedTimes=0}};function ZP(n){return n===Xs||n===pc||n===mc}function JP(n,e,t,i,r,s){let o=new Zl,a=new Um,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(v){return l.add(v),v===0?"uv":`uv${v}`}function m(v,E,k,N,L,B){let z=N.fog,U=L.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?N.environment:null,Y=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||H,Y),le=f[v.type],J=i.precision;v.precision!==null&&(J=i.getMaxPrecision(v.precision),J!==v.precision&&Ye("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,re=Q!==void 0?Q.length:0,fe=0;U.morphAttributes.position!==void 0&&(fe=1),U.morphAttributes.normal!==void 0&&(fe=2),U.morphAttributes.color!==void 0&&(fe=3);let he,ee,ge,ye;if(le){let Re=kr[le];he=Re.vertexShader,ee=Re.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Re=a.getVertexShaderStage(v),ct=a.getFragmentShaderStage(v);a.update(v,Re,ct),ge=Re.id,ye=ct.id}let Ce=n.getRenderTarget(),Me=n.state.buffers.depth.getReversed(),qe=L.isInstancedMesh===!0,ot=L.isBatchedMesh===!0,He=!!v.map,dt=!!v.matcap,ut=!!G,rt=ut&&G.isPMREMTexture===!0,en=!!v.aoMap,Xt=!!v.lightMap,yn=!!v.bumpMap&&v.wireframe===!1,Vt=!!v.normalMap,kn=!!v.displacementMap,Tt=!!v.emissiveMap,Cn=!!v.metalnessMap,hn=!!v.roughnessMap,xn=v.anisotropy>0,O=v.clearcoat>0,Pe=v.diffuseRoughness>0,Ke=v.dispersion>0,at=v.retroreflectivity>0,we=v.iridescence>0,Ht=v.sheen>0,Ge=v.transmission>0,$e=xn&&!!v.anisotropyMap,R=O&&!!v.clearcoatMap,M=O&&!!v.clearcoatNormalMap,q=O&&!!v.clearcoatRoughnessMap,ue=Pe&&!!v.diffuseRoughnessMap,oe=we&&!!v.iridescenceMap,ve=we&&!!v.iridescenceThicknessMap,xe=Ht&&!!v.sheenColorMap,te=Ht&&!!v.sheenRoughnessMap,ie=!!v.specularMap,me=!!v.specularColorMap,F=!!v.specularIntensityMap,se=Ge&&!!v.transmissionMap,ne=Ge&&!!v.thicknessMap,Te=!!v.gradientMap,_e=!!v.alphaMap,Se=v.alphaTest>0,We=!!v.alphaHash,Je=!!v.extensions,ce=Fr;v.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=rt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,je={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:ot,batchingColor:ot&&L._colorsTexture!==null,instancing:qe,instancingColor:qe&&L.instanceColor!==null,instancingMorph:qe&&L.morphTexture!==null,outputColorSpace:Ce===null?n.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:St.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:He,matcap:dt,envMap:ut,envMapMode:ut&&G.mapping,envMapPMREM:rt,envMapMaxLod:rt?ke.length-1:null,envMapSize:rt?ke[0].width:null,aoMap:en,lightMap:Xt,bumpMap:yn,normalMap:Vt,displacementMap:kn,emissiveMap:Tt,normalMapObjectSpace:Vt&&v.normalMapType===Ry,normalMapTangentSpace:Vt&&v.normalMapType===mm,packedNormalMap:Vt&&v.normalMapType===mm&&ZP(v.normalMap.format),metalnessMap:Cn,roughnessMap:hn,anisotropy:xn,anisotropyMap:$e,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Pe,diffuseRoughnessMap:ue,dispersion:Ke,retroreflection:at,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:ve,sheen:Ht,sheenColorMap:xe,sheenRoughnessMap:te,specularMap:ie,specularColorMap:me,specularIntensityMap:F,transmission:Ge,transmissionMap:se,thicknessMap:ne,gradientMap:Te,opaque:v.transparent===!1&&v.blending===qa&&v.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:We,combine:v.combine,mapUv:He&&p(v.map.channel),aoMapUv:en&&p(v.aoMap.channel),lightMapUv:Xt&&p(v.lightMap.channel),bumpMapUv:yn&&p(v.bumpMap.channel),normalMapUv:Vt&&p(v.normalMap.channel),displacementMapUv:kn&&p(v.displacementMap.channel),emissiveMapUv:Tt&&p(v.emissiveMap.channel),metalnessMapUv:Cn&&p(v.metalnessMap.channel),roughnessMapUv:hn&&p(v.roughnessMap.channel),anisotropyMapUv:$e&&p(v.anisotropyMap.channel),clearcoatMapUv:R&&p(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&p(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&p(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&p(v.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&p(v.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&p(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(v.sheenRoughnessMap.channel),specularMapUv:ie&&p(v.specularMap.channel),specularColorMapUv:me&&p(v.specularColorMap.channel),specularIntensityMapUv:F&&p(v.specularIntensityMap.channel),transmissionMapUv:se&&p(v.transmissionMap.channel),thicknessMapUv:ne&&p(v.thicknessMap.channel),alphaMapUv:_e&&p(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Vt||xn),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(He||_e),fog:!!z,useFog:v.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&Vt===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:Me,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:re,morphTextureStride:fe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:B.filter(Re=>Re.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:He&&v.map.isVideoTexture===!0&&St.getTransfer(v.map.colorSpace)===Ot,decodeVideoTextureEmissive:Tt&&v.emissiveMap.isVideoTexture===!0&&St.getTransfer(v.emissiveMap.colorSpace)===Ot,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Xi,flipSided:v.side===ui,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&v.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function x(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let k in v.defines)E.push(k),E.push(v.defines[k]);return v.isRawShaderMaterial===!1&&(_(E,v),g(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function _(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function g(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let E=f[v.type],k;if(E){let N=kr[E];k=Wy.clone(N.uniforms)}else k=v.uniforms;return k}function A(v,E){let k=u.get(E);return k!==void 0?++k.usedTimes:(k=new YP(n,E,v,r),c.push(k),u.set(E,k)),k}function S(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function P(v){a.remove(v)}function C(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:b,acquireProgram:A,releaseProgram:S,releaseShaderCache:P,programs:c,dispose:C}}function jP(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function QP(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function ux(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function hx(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,m,x,_,g){let b=n[e];return b===void 0?(b={id:f.id,object:f,geometry:p,material:m,materialVariant:o(f),groupOrder:x,renderOrder:f.renderOrder,z:_,group:g},n[e]=b):(b.id=f.id,b.object=f,b.geometry=p,b.material=m,b.materialVariant=o(f),b.groupOrder=x,b.renderOrder=f.renderOrder,b.z=_,b.group=g),e++,b}function l(f,p,m,x,_,g,b){b.reversedDepth===!0&&(_=-_);let A=a(f,p,m,x,_,g);m.transmission>0?i.push(A):m.transparent===!0?r.push(A):t.push(A)}function c(f,p,m,x,_,g){let b=a(f,p,m,x,_,g);m.transmission>0?i.unshift(b):m.transparent===!0?r.unshift(b):t.unshift(b)}function u(f,p){t.length>1&&t.sort(f||QP),i.length>1&&i.sort(p||ux),r.length>1&&r.sort(p||ux)}function d(){for(let f=e,p=n.length;f<p;f++){let m=n[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:d,sort:u}}function eI(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new hx,n.set(i,[o])):r>=s.length?(o=new hx,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function tI(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new K,color:new Mt};break;case"SpotLight":t={position:new K,direction:new K,color:new Mt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new K,color:new Mt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new K,skyColor:new Mt,groundColor:new Mt};break;case"RectAreaLight":t={color:new Mt,position:new K,halfWidth:new K,halfHeight:new K};break}return n[e.id]=t,t}}}function nI(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new nt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new nt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new nt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var iI=0;function rI(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function sI(n){let e=new tI,t=nI(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new K);let r=new K,s=new on,o=new on;function a(c){let u=0,d=0,f=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let p=0,m=0,x=0,_=0,g=0,b=0,A=0,S=0,P=0,C=0,v=0,E=0,k=0,N=0;c.sort(rI);for(let B=0,z=c.length;B<z;B++){let U=c[B],H=U.color,Y=U.intensity,G=U.distance,le=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Xs?le=U.shadow.map.texture:le=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)u+=H.r*Y,d+=H.g*Y,f+=H.b*Y;else if(U.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(U.sh.coefficients[J],Y);N++}else if(U.isSunLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,re=t.get(U);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=re,i.sunShadowMap[m]=le;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[x+he]=Q.getMatrix(he),i.sunShadowCascade[x+he]=Q._cascadeData[he];x+=fe,m++}i.sun[p]=J,p++}else if(U.isDirectionalLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,re=t.get(U);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize=Q.mapSize,i.directionalShadow[_]=re,i.directionalShadowMap[_]=le,i.directionalShadowMatrix[_]=U.shadow.matrix,P++}i.directional[_]=J,_++}else if(U.isSpotLight){let J=e.get(U);J.position.setFromMatrixPosition(U.matrixWorld),J.color.copy(H).multiplyScalar(Y),J.distance=G,J.coneCos=Math.cos(U.angle),J.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),J.decay=U.decay,i.spot[b]=J;let Q=U.shadow;if(U.map&&(i.spotLightMap[E]=U.map,E++,Q.updateMatrices(U),U.castShadow&&k++),i.spotLightMatrix[b]=Q.matrix,U.castShadow){let re=t.get(U);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize=Q.mapSize,i.spotShadow[b]=re,i.spotShadowMap[b]=le,v++}b++}else if(U.isRectAreaLight){let J=e.get(U);J.color.copy(H).multiplyScalar(Y),J.halfWidth.set(U.width*.5,0,0),J.halfHeight.set(0,U.height*.5,0),i.rectArea[A]=J,A++}else if(U.isPointLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),J.distance=U.distance,J.decay=U.decay,U.castShadow){let Q=U.shadow,re=t.get(U);re.shadowIntensity=Q.intensity,re.shadowBias=Q.bias,re.shadowNormalBias=Q.normalBias,re.shadowRadius=Q.radius,re.shadowMapSize=Q.mapSize,re.shadowCameraNear=Q.camera.near,re.shadowCameraFar=Q.camera.far,i.pointShadow[g]=re,i.pointShadowMap[g]=le,i.pointShadowMatrix[g]=U.shadow.matrix,C++}i.point[g]=J,g++}else if(U.isHemisphereLight){let J=e.get(U);J.skyColor.copy(U.color).multiplyScalar(Y),J.groundColor.copy(U.groundColor).multiplyScalar(Y),i.hemi[S]=J,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=f;let L=i.hash;(L.sunLength!==p||L.directionalLength!==_||L.pointLength!==g||L.spotLength!==b||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==m||L.numDirectionalShadows!==P||L.numPointShadows!==C||L.numSpotShadows!==v||L.numSpotMaps!==E||L.numLightProbes!==N)&&(i.sun.length=p,i.directional.length=_,i.spot.length=b,i.rectArea.length=A,i.point.length=g,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-k,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=N,L.sunLength=p,L.directionalLength=_,L.pointLength=g,L.spotLength=b,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=m,L.numDirectionalShadows=P,L.numPointShadows=C,L.numSpotShadows=v,L.numSpotMaps=E,L.numLightProbes=N,i.version=iI++)}function l(c,u){let d=0,f=0,p=0,m=0,x=0,_=0,g=u.matrixWorldInverse;for(let b=0,A=c.length;b<A;b++){let S=c[b];if(S.isSunLight){let P=i.sun[d];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),d++}else if(S.isDirectionalLight){let P=i.directional[f];P.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(r),P.direction.transformDirection(g),f++}else if(S.isSpotLight){let P=i.spot[m];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),P.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(r),P.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let P=i.rectArea[x];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),o.identity(),s.copy(S.matrixWorld),s.premultiply(g),o.extractRotation(s),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),x++}else if(S.isPointLight){let P=i.point[p];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),p++}else if(S.isHemisphereLight){let P=i.hemi[_];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),_++}}}return{setup:a,setupView:l,state:i}}function fx(n){let e=new sI(n),t=[],i=[],r=[];function s(d){u.camera=d,t.length=0,i.length=0,r.length=0}function o(d){d.isLightProbeGrid?r.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),r.sort((d,f)=>d.priority-f.priority||d.id-f.id)}function c(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function oI(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new fx(n),e.set(r,[a])):s>=o.length?(a=new fx(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var aI=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,lI=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,cI=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],uI=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],dx=new on,gc=new K,Pm=new K;function hI(n,e,t){let i=new So,r=new nt,s=new nt,o=new an,a=new mh,l=new gh,c={},u=t.maxTextureSize,d={[qs]:ui,[ui]:qs,[Xi]:Xi},f=new Ni({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new nt},radius:{value:4}},vertexShader:aI,fragmentShader:lI}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new Ur;m.setAttribute("position",new ci(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new qi(m,f),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=lc;let g=this.type;this.render=function(C,v,E){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||C.length===0)return;this.type===oy&&(Ye("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=lc);let k=n.getRenderTarget(),N=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),B=n.state;B.setBlending(Mo),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let z=g!==this.type;z&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(H=>H.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,H=C.length;U<H;U++){let Y=C[U],G=Y.shadow;if(G===void 0){Ye("WebGLShadowMap:",Y,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;r.copy(G.mapSize);let le=G.getFrameExtents();r.multiply(le),s.copy(G.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/le.x),r.x=s.x*le.x,G.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/le.y),r.y=s.y*le.y,G.mapSize.y=s.y));let J=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=J,G.map===null||z===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Wa){if(Y.isPointLight){Ye("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Li(r.x,r.y,{format:Xs,type:hr,minFilter:$n,magFilter:$n,generateMipmaps:!1}),G.map.texture.name=Y.name+".shadowMap",G.map.depthTexture=new ss(r.x,r.y,ur),G.map.depthTexture.name=Y.name+".shadowMapDepth",G.map.depthTexture.format=is,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=qn,G.map.depthTexture.magFilter=qn}else Y.isPointLight?(G.map=new vc(r.x),G.map.depthTexture=new nc(r.x,cr)):(G.map=new Li(r.x,r.y),G.map.depthTexture=new ss(r.x,r.y,cr)),G.map.depthTexture.name=Y.name+".shadowMap",G.map.depthTexture.format=is,this.type===lc?(G.map.depthTexture.compareFunction=J?_m:gm,G.map.depthTexture.minFilter=$n,G.map.depthTexture.magFilter=$n):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=qn,G.map.depthTexture.magFilter=qn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==r.x||G.map.height!==r.y)&&G.map.setSize(r.x,r.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();Y.isPointLight!==!0&&G.updateMatrices(Y,E);let re=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:E.layers;for(let fe=0;fe<Q;fe++){let he=G.getCamera(fe);if(Y.isPointLight){let ee=G.camera,ge=G.matrix,ye=Y.distance||ee.far;ye!==ee.far&&(ee.far=ye,ee.updateProjectionMatrix()),gc.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(gc),Pm.copy(ee.position),Pm.add(cI[fe]),ee.up.copy(uI[fe]),ee.lookAt(Pm),ee.updateMatrixWorld(),ge.makeTranslation(-gc.x,-gc.y,-gc.z),dx.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(dx,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(fe);o.set(s.x*ee.x,s.y*ee.y,s.x*ee.z,s.y*ee.w),B.viewport(o)}i=G.getFrustum(fe),S(v,E,he,Y,re,this.type)}G.isPointLightShadow!==!0&&this.type===Wa&&b(G,E),G.needsUpdate=!1}g=this.type,_.needsUpdate=!1,n.setRenderTarget(k,N,L)};function b(C,v){let E=e.update(x);f.defines.VSM_SAMPLES!==C.blurSamples&&(f.defines.VSM_SAMPLES=C.blurSamples,p.defines.VSM_SAMPLES=C.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),C.mapPass===null?C.mapPass=new Li(r.x,r.y,{format:Xs,type:hr}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),f.uniforms.shadow_pass.value=C.map.depthTexture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(v,null,E,f,x,null),p.uniforms.shadow_pass.value=C.mapPass.texture,p.uniforms.resolution.value.set(C.map.width,C.map.height),p.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(v,null,E,p,x,null)}function A(C,v,E,k){let N=null,L=E.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)N=L;else if(N=E.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let B=N.uuid,z=v.uuid,U=c[B];U===void 0&&(U={},c[B]=U);let H=U[z];H===void 0&&(H=N.clone(),U[z]=H,v.addEventListener("dispose",P)),N=H}if(N.visible=v.visible,N.wireframe=v.wireframe,k===Wa?N.side=v.shadowSide!==null?v.shadowSide:v.side:N.side=v.shadowSide!==null?v.shadowSide:d[v.side],N.alphaMap=v.alphaMap,N.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,N.map=v.map,N.clipShadows=v.clipShadows,N.clippingPlanes=v.clippingPlanes,N.clipIntersection=v.clipIntersection,N.displacementMap=v.displacementMap,N.displacementScale=v.displacementScale,N.displacementBias=v.displacementBias,N.wireframeLinewidth=v.wireframeLinewidth,N.linewidth=v.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let B=n.properties.get(N);B.light=E}return N}function S(C,v,E,k,N,L){if(C.visible===!1)return;if(C.layers.test(N)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===Wa)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,C.matrixWorld);let U=e.update(C),H=C.material;if(Array.isArray(H)){let Y=U.groups;for(let G=0,le=Y.length;G<le;G++){let J=Y[G],Q=H[J.materialIndex];if(Q&&Q.visible){let re=A(C,Q,k,L);C.onBeforeShadow(n,C,v,E,U,re,J),n.renderBufferDirect(E,null,U,re,C,J),C.onAfterShadow(n,C,v,E,U,re,J)}}}else if(H.visible){let Y=A(C,H,k,L);C.onBeforeShadow(n,C,v,E,U,Y,null),n.renderBufferDirect(E,null,U,Y,C,null),C.onAfterShadow(n,C,v,E,U,Y,null)}}let z=C.children;for(let U=0,H=z.length;U<H;U++)S(z[U],v,E,k,N,L)}function P(C){C.target.removeEventListener("dispose",P);for(let E in c){let k=c[E],N=C.target.uuid;N in k&&(k[N].dispose(),delete k[N])}}}function fI(n,e){function t(){let F=!1,se=new an,ne=null,Te=new an(0,0,0,0);return{setMask:function(_e){ne!==_e&&!F&&(n.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){F=_e},setClear:function(_e,Se,We,Je,ce){ce===!0&&(_e*=Je,Se*=Je,We*=Je),se.set(_e,Se,We,Je),Te.equals(se)===!1&&(n.clearColor(_e,Se,We,Je),Te.copy(se))},reset:function(){F=!1,ne=null,Te.set(-1,0,0,0)}}}function i(){let F=!1,se=!1,ne=null,Te=null,_e=null;return{setReversed:function(Se){if(se!==Se){let We=e.get("EXT_clip_control");Se?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let Je=_e;_e=null,this.setClear(Je)}},getReversed:function(){return se},setTest:function(Se){Se?Me(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!F&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(se&&(Se=zy[Se]),Te!==Se){switch(Se){case Ku:n.depthFunc(n.NEVER);break;case Zu:n.depthFunc(n.ALWAYS);break;case Ju:n.depthFunc(n.LESS);break;case Na:n.depthFunc(n.LEQUAL);break;case ju:n.depthFunc(n.EQUAL);break;case Qu:n.depthFunc(n.GEQUAL);break;case eh:n.depthFunc(n.GREATER);break;case th:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Se}},setLocked:function(Se){F=Se},setClear:function(Se){_e!==Se&&(_e=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){F=!1,ne=null,Te=null,_e=null,se=!1}}}function r(){let F=!1,se=null,ne=null,Te=null,_e=null,Se=null,We=null,Je=null,ce=null;return{setTest:function(ke){F||(ke?Me(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(ke){se!==ke&&!F&&(n.stencilMask(ke),se=ke)},setFunc:function(ke,je,Re){(ne!==ke||Te!==je||_e!==Re)&&(n.stencilFunc(ke,je,Re),ne=ke,Te=je,_e=Re)},setOp:function(ke,je,Re){(Se!==ke||We!==je||Je!==Re)&&(n.stencilOp(ke,je,Re),Se=ke,We=je,Je=Re)},setLocked:function(ke){F=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){F=!1,se=null,ne=null,Te=null,_e=null,Se=null,We=null,Je=null,ce=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,u={},d={},f={},p=new WeakMap,m=[],x=null,_=!1,g=null,b=null,A=null,S=null,P=null,C=null,v=null,E=new Mt(0,0,0),k=0,N=!1,L=null,B=null,z=null,U=null,H=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),G=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),G=le>=2);let Q=null,re={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new an().fromArray(fe),ge=new an().fromArray(he);function ye(F,se,ne,Te){let _e=new Uint8Array(4),Se=n.createTexture();n.bindTexture(F,Se),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<ne;We++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(se+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Se}let Ce={};Ce[n.TEXTURE_2D]=ye(n.TEXTURE_2D,n.TEXTURE_2D,1),Ce[n.TEXTURE_CUBE_MAP]=ye(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[n.TEXTURE_2D_ARRAY]=ye(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ce[n.TEXTURE_3D]=ye(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(n.DEPTH_TEST),o.setFunc(Na),yn(!1),Vt($p),Me(n.CULL_FACE),en(Mo);function Me(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function qe(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function ot(F,se){return f[F]!==se?(n.bindFramebuffer(F,se),f[F]=se,F===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=se),F===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=se),!0):!1}function He(F,se){let ne=m,Te=!1;if(F){ne=p.get(se),ne===void 0&&(ne=[],p.set(se,ne));let _e=F.textures;if(ne.length!==_e.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,We=_e.length;Se<We;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=_e.length,Te=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ne)}function dt(F){return x!==F?(n.useProgram(F),x=F,!0):!1}let ut={[wo]:n.FUNC_ADD,[ly]:n.FUNC_SUBTRACT,[cy]:n.FUNC_REVERSE_SUBTRACT};ut[uy]=n.MIN,ut[hy]=n.MAX;let rt={[fy]:n.ZERO,[dy]:n.ONE,[py]:n.SRC_COLOR,[Jp]:n.SRC_ALPHA,[xy]:n.SRC_ALPHA_SATURATE,[vy]:n.DST_COLOR,[gy]:n.DST_ALPHA,[my]:n.ONE_MINUS_SRC_COLOR,[jp]:n.ONE_MINUS_SRC_ALPHA,[yy]:n.ONE_MINUS_DST_COLOR,[_y]:n.ONE_MINUS_DST_ALPHA,[by]:n.CONSTANT_COLOR,[Sy]:n.ONE_MINUS_CONSTANT_COLOR,[My]:n.CONSTANT_ALPHA,[wy]:n.ONE_MINUS_CONSTANT_ALPHA};function en(F,se,ne,Te,_e,Se,We,Je,ce,ke){if(F===Mo){_===!0&&(qe(n.BLEND),_=!1);return}if(_===!1&&(Me(n.BLEND),_=!0),F!==ay){if(F!==g||ke!==N){if((b!==wo||P!==wo)&&(n.blendEquation(n.FUNC_ADD),b=wo,P=wo),ke)switch(F){case qa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Yp:n.blendFunc(n.ONE,n.ONE);break;case Kp:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Zp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:tt("WebGLState: Invalid blending: ",F);break}else switch(F){case qa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Yp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Kp:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Zp:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",F);break}A=null,S=null,C=null,v=null,E.set(0,0,0),k=0,g=F,N=ke}return}_e=_e||se,Se=Se||ne,We=We||Te,(se!==b||_e!==P)&&(n.blendEquationSeparate(ut[se],ut[_e]),b=se,P=_e),(ne!==A||Te!==S||Se!==C||We!==v)&&(n.blendFuncSeparate(rt[ne],rt[Te],rt[Se],rt[We]),A=ne,S=Te,C=Se,v=We),(Je.equals(E)===!1||ce!==k)&&(n.blendColor(Je.r,Je.g,Je.b,ce),E.copy(Je),k=ce),g=F,N=!1}function Xt(F,se){F.side===Xi?qe(n.CULL_FACE):Me(n.CULL_FACE);let ne=F.side===ui;se&&(ne=!ne),yn(ne),F.blending===qa&&F.transparent===!1?en(Mo):en(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),s.setMask(F.colorWrite);let Te=F.stencilWrite;a.setTest(Te),Te&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Tt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Me(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function yn(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function Vt(F){F!==ry?(Me(n.CULL_FACE),F!==B&&(F===$p?n.cullFace(n.BACK):F===sy?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),B=F}function kn(F){F!==z&&(G&&n.lineWidth(F),z=F)}function Tt(F,se,ne){F?(Me(n.POLYGON_OFFSET_FILL),(U!==se||H!==ne)&&(U=se,H=ne,o.getReversed()&&(se=-se,ne=-ne),n.polygonOffset(se,ne))):qe(n.POLYGON_OFFSET_FILL)}function Cn(F){F?Me(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function hn(F){F===void 0&&(F=n.TEXTURE0+Y-1),Q!==F&&(n.activeTexture(F),Q=F)}function xn(F,se,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+Y-1:ne=Q);let Te=re[ne];Te===void 0&&(Te={type:void 0,texture:void 0},re[ne]=Te),(Te.type!==F||Te.texture!==se)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(F,se||Ce[F]),Te.type=F,Te.texture=se)}function O(){let F=re[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(F){tt("WebGLState:",F)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(F){tt("WebGLState:",F)}}function at(){try{n.texSubImage2D(...arguments)}catch(F){tt("WebGLState:",F)}}function we(){try{n.texSubImage3D(...arguments)}catch(F){tt("WebGLState:",F)}}function Ht(){try{n.compressedTexSubImage2D(...arguments)}catch(F){tt("WebGLState:",F)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(F){tt("WebGLState:",F)}}function $e(){try{n.texStorage2D(...arguments)}catch(F){tt("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){tt("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){tt("WebGLState:",F)}}function q(){try{n.texImage3D(...arguments)}catch(F){tt("WebGLState:",F)}}function ue(F){return d[F]!==void 0?d[F]:n.getParameter(F)}function oe(F,se){d[F]!==se&&(n.pixelStorei(F,se),d[F]=se)}function ve(F){ee.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function xe(F){ge.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),ge.copy(F))}function te(F,se){let ne=c.get(se);ne===void 0&&(ne=new WeakMap,c.set(se,ne));let Te=ne.get(F);Te===void 0&&(Te=n.getUniformBlockIndex(se,F.name),n.uniformBlockBinding(se,Te,Te),ne.set(F,Te))}function ie(F,se,ne){let _e=c.get(se).get(F);l[_e]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},Q=null,re={},f={},l={},p=new WeakMap,m=[],x=null,_=!1,g=null,b=null,A=null,S=null,P=null,C=null,v=null,E=new Mt(0,0,0),k=0,N=!1,L=null,B=null,z=null,U=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:Me,disable:qe,bindFramebuffer:ot,drawBuffers:He,useProgram:dt,setBlending:en,setMaterial:Xt,setFlipSided:yn,setCullFace:Vt,setLineWidth:kn,setPolygonOffset:Tt,setScissorTest:Cn,activeTexture:hn,bindTexture:xn,unbindTexture:O,compressedTexImage2D:Pe,compressedTexImage3D:Ke,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:$e,texStorage3D:R,texSubImage2D:at,texSubImage3D:we,compressedTexSubImage2D:Ht,compressedTexSubImage3D:Ge,scissor:ve,viewport:xe,reset:me}}function dI(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new nt,u=new WeakMap,d=new Set,f,p=new WeakMap,m=new Set,x=new FinalizationRegistry(R=>m.delete(R)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,M){return _?new OffscreenCanvas(R,M):Yl("canvas")}function b(R,M,q){let ue=1,oe=$e(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ve=Math.floor(ue*oe.width),xe=Math.floor(ue*oe.height);f===void 0&&(f=g(ve,xe));let te=M?g(ve,xe):f;return te.width=ve,te.height=xe,te.getContext("2d").drawImage(R,0,0,ve,xe),Ye("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ve+"x"+xe+")."),te}else return"data"in R&&Ye("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function P(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,M,q,ue,oe,ve=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ye("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let xe;ue&&(xe=e.get("EXT_texture_norm16"),xe||Ye("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.R16_EXT),q===n.SHORT&&xe&&(te=xe.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RG16_EXT),q===n.SHORT&&xe&&(te=xe.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGB16_EXT),q===n.SHORT&&xe&&(te=xe.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let ie=ve?Xl:St.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Ot?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGBA16_EXT),q===n.SHORT&&xe&&(te=xe.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(R,M){let q;return R?M===null||M===cr||M===Eo?q=n.DEPTH24_STENCIL8:M===ur?q=n.DEPTH32F_STENCIL8:M===$a&&(q=n.DEPTH24_STENCIL8,Ye("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===cr||M===Eo?q=n.DEPTH_COMPONENT24:M===ur?q=n.DEPTH_COMPONENT32F:M===$a&&(q=n.DEPTH_COMPONENT16),q}function E(R,M){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==qn&&R.minFilter!==$n?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function k(R){let M=new WeakRef(R);i.get(R).__ref=M,m.add(M),x.register(R,M,M)}function N(R){let M=i.get(R).__ref;M!==void 0&&(m.delete(M),x.unregister(M))}function L(R){z(R.target)}function B(R){U(R.target)}function z(R){R.removeEventListener("dispose",L),N(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&d.delete(R)}function U(R){R.removeEventListener("dispose",B),N(R),le(R)}function H(){for(let R of m){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?U(M):z(M))}m.clear(),d.clear()}function Y(R){let M=i.get(R);if(M.__webglInit===void 0)return;let q=R.source,ue=p.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(R),Object.keys(ue).length===0&&p.delete(q)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let q=R.source,ue=p.get(q);delete ue[M.__cacheKey],o.memory.textures--}function le(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&z(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let ve=0;ve<M.__webglFramebuffer[oe].length;ve++)n.deleteFramebuffer(M.__webglFramebuffer[oe][ve]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,ve=ue.length;oe<ve;oe++){let xe=i.get(ue[oe]);xe.__webglTexture&&(n.deleteTexture(xe.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let J=0;function Q(){J=0}function re(){return J}function fe(R){J=R}function he(){let R=J;return R>=r.maxTextures&&Ye("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),J+=1,R}function ee(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function ge(R,M){let q=i.get(R);if(R.isVideoTexture&&Ht(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Ye("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ye("WebGLRenderer: Texture marked for update but image is incomplete");else{Xt(q,R,M);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ye(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Xt(q,R,M);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ce(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Xt(q,R,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Me(R,M){let q=i.get(R);if(R.version>0&&q.__version!==R.version){yn(q,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let qe={[nh]:n.REPEAT,[Dr]:n.CLAMP_TO_EDGE,[ih]:n.MIRRORED_REPEAT},ot={[qn]:n.NEAREST,[Ay]:n.NEAREST_MIPMAP_NEAREST,[cc]:n.NEAREST_MIPMAP_LINEAR,[$n]:n.LINEAR,[Ih]:n.LINEAR_MIPMAP_NEAREST,[os]:n.LINEAR_MIPMAP_LINEAR},He={[Iy]:n.NEVER,[vm]:n.ALWAYS,[Ly]:n.LESS,[gm]:n.LEQUAL,[Dy]:n.EQUAL,[_m]:n.GEQUAL,[Ny]:n.GREATER,[Uy]:n.NOTEQUAL};function dt(R,M){if(M.type===ur&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===$n||M.magFilter===Ih||M.magFilter===cc||M.magFilter===os||M.minFilter===$n||M.minFilter===Ih||M.minFilter===cc||M.minFilter===os)&&Ye("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,qe[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,qe[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,qe[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ot[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ot[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,He[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===qn||M.minFilter!==cc&&M.minFilter!==os||M.type===ur&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,r.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ut(R,M){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),k(M));let ue=M.source,oe=p.get(ue);oe===void 0&&(oe={},p.set(ue,oe));let ve=ee(M);if(ve!==R.__cacheKey){oe[ve]===void 0&&(oe[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[ve].usedTimes++;let xe=oe[R.__cacheKey];xe!==void 0&&(oe[R.__cacheKey].usedTimes--,xe.usedTimes===0&&G(M)),R.__cacheKey=ve,R.__webglTexture=oe[ve].texture}return q}function rt(R,M,q){return Math.floor(Math.floor(R/q)/M)}function en(R,M,q,ue){let ve=R.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{ve.sort((F,se)=>F.start-se.start);let xe=0;for(let F=1;F<ve.length;F++){let se=ve[xe],ne=ve[F],Te=se.start+se.count,_e=rt(ne.start,M.width,4),Se=rt(se.start,M.width,4);ne.start<=Te+1&&_e===Se&&rt(ne.start+ne.count-1,M.width,4)===_e?se.count=Math.max(se.count,ne.start+ne.count-se.start):(++xe,ve[xe]=ne)}ve.length=xe+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,se=ve.length;F<se;F++){let ne=ve[F],Te=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=Te%M.width,We=Math.floor(Te/M.width),Je=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Se,We,Je,ce,q,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Xt(R,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ut(R,M),ve=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let xe=i.get(ve);if(ve.version!==xe.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=St.getPrimaries(St.workingColorSpace),ke=M.colorSpace===ls?null:St.getPrimaries(M.colorSpace),je=M.colorSpace===ls||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=b(M.image,!1,r.maxTextureSize);ie=Ge(M,ie);let me=s.convert(M.format,M.colorSpace),F=s.convert(M.type),se=C(M.internalFormat,me,F,M.normalized,M.colorSpace,M.isVideoTexture);dt(ue,M);let ne,Te=M.mipmaps,_e=M.isVideoTexture!==!0,Se=xe.__version===void 0||oe===!0,We=ve.dataReady,Je=E(M,ie);if(M.isDepthTexture)se=v(M.format===as,M.type),Se&&(_e?t.texStorage2D(n.TEXTURE_2D,1,se,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,me,F,null));else if(M.isDataTexture)if(Te.length>0){_e&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,se,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)ne=Te[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,se,ne.width,ne.height,0,me,F,ne.data);M.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(n.TEXTURE_2D,Je,se,ie.width,ie.height),We&&en(M,ie,me,F)):t.texImage2D(n.TEXTURE_2D,0,se,ie.width,ie.height,0,me,F,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,se,Te[0].width,Te[0].height,ie.depth);for(let ce=0,ke=Te.length;ce<ke;ce++)if(ne=Te[ce],M.format!==fr)if(me!==null)if(_e){if(We)if(M.layerUpdates.size>0){let je=Cm(ne.width,ne.height,M.format,M.type);for(let Re of M.layerUpdates){let ct=ne.data.subarray(Re*je/ne.data.BYTES_PER_ELEMENT,(Re+1)*je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Re,ne.width,ne.height,1,me,ct)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,me,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,se,ne.width,ne.height,ie.depth,0,ne.data,0,0);else Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,me,F,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,se,ne.width,ne.height,ie.depth,0,me,F,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(n.TEXTURE_2D,Je,se,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)ne=Te[ce],M.format!==fr?me!==null?_e?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,se,ne.width,ne.height,0,ne.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,se,ne.width,ne.height,0,me,F,ne.data)}else if(M.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,se,ie.width,ie.height,ie.depth),We)if(M.layerUpdates.size>0){let ce=Cm(ie.width,ie.height,M.format,M.type);for(let ke of M.layerUpdates){let je=ie.data.subarray(ke*ce/ie.data.BYTES_PER_ELEMENT,(ke+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,ie.width,ie.height,1,me,F,je)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(M.isData3DTexture)_e?(Se&&t.texStorage3D(n.TEXTURE_3D,Je,se,ie.width,ie.height,ie.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,se,ie.width,ie.height,ie.depth,0,me,F,ie.data);else if(M.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(n.TEXTURE_2D,Je,se,ie.width,ie.height);else{let ce=ie.width,ke=ie.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,se,ce,ke,0,me,F,null),ce>>=1,ke>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),d.add(M),ce.onpaint=ke=>{let je=ke.changedElements;for(let Re of d)je.includes(Re.image)&&(Re.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let je=n.RGBA,Re=n.RGBA,ct=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Re,ct,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(_e&&Se){let ce=$e(Te[0]);t.texStorage2D(n.TEXTURE_2D,Je,se,ce.width,ce.height)}for(let ce=0,ke=Te.length;ce<ke;ce++)ne=Te[ce],_e?We&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,F,ne):t.texImage2D(n.TEXTURE_2D,ce,se,me,F,ne);M.generateMipmaps=!1}else if(_e){if(Se){let ce=$e(ie);t.texStorage2D(n.TEXTURE_2D,Je,se,ce.width,ce.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,se,me,F,ie);A(M)&&M.mipmapsAutoUpdate===!0&&S(ue),xe.__version=ve.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function yn(R,M,q){if(M.image.length!==6)return;let ue=ut(R,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let ve=i.get(oe);if(oe.version!==ve.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let xe=St.getPrimaries(St.workingColorSpace),te=M.colorSpace===ls?null:St.getPrimaries(M.colorSpace),ie=M.colorSpace===ls||xe===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,se=[];for(let Re=0;Re<6;Re++)!me&&!F?se[Re]=b(M.image[Re],!0,r.maxCubemapSize):se[Re]=F?M.image[Re].image:M.image[Re],se[Re]=Ge(M,se[Re]);let ne=se[0],Te=s.convert(M.format,M.colorSpace),_e=s.convert(M.type),Se=C(M.internalFormat,Te,_e,M.normalized,M.colorSpace),We=M.isVideoTexture!==!0,Je=ve.__version===void 0||ue===!0,ce=oe.dataReady,ke=E(M,ne);dt(n.TEXTURE_CUBE_MAP,M);let je;if(M.isDepthTexture){if(Se=v(M.format===as,M.type),Je)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Re=0;Re<6;Re++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,ne.width,ne.height,0,Te,_e,null)}else if(me){We&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,ne.width,ne.height);for(let Re=0;Re<6;Re++){je=se[Re].mipmaps;for(let ct=0;ct<je.length;ct++){let $t=je[ct];M.format!==fr?Te!==null?We?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct,0,0,$t.width,$t.height,Te,$t.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct,Se,$t.width,$t.height,0,$t.data):Ye("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct,0,0,$t.width,$t.height,Te,_e,$t.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct,Se,$t.width,$t.height,0,Te,_e,$t.data)}}}else{if(je=M.mipmaps,We&&Je){je.length>0&&ke++;let Re=$e(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(F){We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,se[Re].width,se[Re].height,Te,_e,se[Re].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,se[Re].width,se[Re].height,0,Te,_e,se[Re].data);for(let ct=0;ct<je.length;ct++){let ti=je[ct].image[Re].image;We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct+1,0,0,ti.width,ti.height,Te,_e,ti.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct+1,Se,ti.width,ti.height,0,Te,_e,ti.data)}}else{We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,Te,_e,se[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,Se,Te,_e,se[Re]);for(let ct=0;ct<je.length;ct++){let $t=je[ct];We?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct+1,0,0,Te,_e,$t.image[Re]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Re,ct+1,Se,Te,_e,$t.image[Re])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),ve.__version=oe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Vt(R,M,q,ue,oe,ve){let xe=s.convert(q.format,q.colorSpace),te=s.convert(q.type),ie=C(q.internalFormat,xe,te,q.normalized,q.colorSpace),me=i.get(M),F=i.get(q);if(F.__renderTarget=M,!me.__hasExternalTextures){let se=Math.max(1,M.width>>ve),ne=Math.max(1,M.height>>ve);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ve,ie,se,ne,M.depth,0,xe,te,null):t.texImage2D(oe,ve,ie,se,ne,0,xe,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,F.__webglTexture,0,at(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,F.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function kn(R,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,ve=v(M.stencilBuffer,oe),xe=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),ve,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),ve,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ve,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,xe,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let ve=ue[oe],xe=s.convert(ve.format,ve.colorSpace),te=s.convert(ve.type),ie=C(ve.internalFormat,xe,te,ve.normalized,ve.colorSpace);we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),ie,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Tt(R,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let ve=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||ve.width!==M.width||ve.height!==M.height)&&(ve.width=M.width,ve.height=M.height,M.depthTexture.needsUpdate=!0),ue?Me(M.depthTexture,0):ge(M.depthTexture,0);let xe=oe.__webglTexture,te=at(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,me=M.depthTexture.format===as?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===is)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,xe,0);else if(M.depthTexture.format===as)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,xe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Cn(R){let M=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)Tt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?Tt(M.__webglFramebuffer[0],R,0):Tt(M.__webglFramebuffer,R,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),kn(M.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ve)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),kn(M.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function hn(R,M,q){let ue=i.get(R);M!==void 0&&Vt(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Cn(R)}function xn(R){let M=R.texture,q=i.get(R),ue=i.get(M);R.addEventListener("dispose",B),k(R);let oe=R.textures,ve=R.isWebGLCubeRenderTarget===!0,xe=oe.length>1;if(xe||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),ve){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(xe)for(let te=0,ie=oe.length;te<ie;te++){let me=i.get(oe[te]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=s.convert(ie.format,ie.colorSpace),F=s.convert(ie.type),se=C(ie.internalFormat,me,F,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=at(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,se,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),kn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),dt(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Vt(q.__webglFramebuffer[te][ie],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Vt(q.__webglFramebuffer[te],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(xe){for(let te=0,ie=oe.length;te<ie;te++){let me=oe[te],F=i.get(me),se=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,F.__webglTexture),dt(se,me),Vt(q.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+te,se,0),A(me)&&S(se)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),dt(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Vt(q.__webglFramebuffer[ie],R,M,n.COLOR_ATTACHMENT0,te,ie);else Vt(q.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,te,0);A(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Cn(R)}function O(R){let M=R.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let ve=P(R),xe=i.get(oe).__webglTexture;t.bindTexture(ve,xe),S(ve),t.unbindTexture()}}}let Pe=[];function Ke(R){if(R.samples>0){if(we(R)===!1){let M=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,ve=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=i.get(R),te=M.length>1;if(te)for(let me=0;me<M.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,xe.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let me=0;me<M.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,xe.__webglColorRenderbuffer[me]);let F=i.get(M[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Pe.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<M.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,xe.__webglColorRenderbuffer[me]);let F=i.get(M[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function at(R){return Math.min(r.maxSamples,R.samples)}function we(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ht(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function Ge(R,M){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==ql&&q!==ls&&(St.getTransfer(q)===Ot?(ue!==fr||oe!==Fi)&&Ye("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",q)),M}function $e(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=re,this.setTextureUnits=fe,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Ce,this.setTextureCube=Me,this.rebindTextures=hn,this.setupRenderTarget=xn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=Cn,this.setupFrameBufferTexture=Vt,this.useMultisampledRTT=we,this.dispose=H}function pI(n,e){function t(i,r=ls){let s,o=St.getTransfer(r);if(i===Fi)return n.UNSIGNED_BYTE;if(i===Dh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Nh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===um)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===hm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===lm)return n.BYTE;if(i===cm)return n.SHORT;if(i===$a)return n.UNSIGNED_SHORT;if(i===Lh)return n.INT;if(i===cr)return n.UNSIGNED_INT;if(i===ur)return n.FLOAT;if(i===hr)return n.HALF_FLOAT;if(i===fm)return n.ALPHA;if(i===dm)return n.RGB;if(i===fr)return n.RGBA;if(i===is)return n.DEPTH_COMPONENT;if(i===as)return n.DEPTH_STENCIL;if(i===pm)return n.RED;if(i===Uh)return n.RED_INTEGER;if(i===Xs)return n.RG;if(i===Fh)return n.RG_INTEGER;if(i===Oh)return n.RGBA_INTEGER;if(i===uc||i===hc||i===fc||i===dc)if(o===Ot)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===uc)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===hc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===fc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===dc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===uc)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===hc)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===fc)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===dc)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===kh||i===Bh||i===zh||i===Vh)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===kh)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Bh)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===zh)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Vh)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Gh||i===Hh||i===Wh||i===qh||i===Xh||i===pc||i===$h)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Gh||i===Hh)return o===Ot?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Wh)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===qh)return s.COMPRESSED_R11_EAC;if(i===Xh)return s.COMPRESSED_SIGNED_R11_EAC;if(i===pc)return s.COMPRESSED_RG11_EAC;if(i===$h)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Yh||i===Kh||i===Zh||i===Jh||i===jh||i===Qh||i===ef||i===tf||i===nf||i===rf||i===sf||i===of||i===af||i===lf)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Yh)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Kh)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Zh)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Jh)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===jh)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Qh)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ef)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===tf)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===nf)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===rf)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===sf)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===of)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===af)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===lf)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===cf||i===uf||i===hf)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===cf)return o===Ot?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===uf)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===hf)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ff||i===df||i===mc||i===pf)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===ff)return s.COMPRESSED_RED_RGTC1_EXT;if(i===df)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===mc)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===pf)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Eo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var mI=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,gI=`
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

}`,Om=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ic(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Ni({vertexShader:mI,fragmentShader:gI,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new qi(new rc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},km=class extends lr{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,f=null,p=null,m=null,x=typeof XRWebGLBinding<"u",_=new Om,g={},b=t.getContextAttributes(),A=null,S=null,P=[],C=[],v=new nt,E=null,k=null,N=new li;N.viewport=new an;let L=new li;L.viewport=new an;let B=[N,L],z=new Ch,U=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=P[ee];return ge===void 0&&(ge=new ka,P[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=P[ee];return ge===void 0&&(ge=new ka,P[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=P[ee];return ge===void 0&&(ge=new ka,P[ee]=ge),ge.getHandSpace()};function Y(ee){let ge=C.indexOf(ee.inputSource);if(ge===-1)return;let ye=P[ge];ye!==void 0&&(ye.update(ee.inputSource,ee.frame,c||o),ye.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){r.removeEventListener("select",Y),r.removeEventListener("selectstart",Y),r.removeEventListener("selectend",Y),r.removeEventListener("squeeze",Y),r.removeEventListener("squeezestart",Y),r.removeEventListener("squeezeend",Y),r.removeEventListener("end",G),r.removeEventListener("inputsourceschange",le);for(let ee=0;ee<P.length;ee++){let ge=C[ee];ge!==null&&(C[ee]=null,P[ee].disconnect(ge))}U=null,H=null,_.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(A),p=null,f=null,d=null,r=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),k!==null){let ee=k.camera;ee.fov=k.fov,ee.zoom=k.zoom,ee.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){s=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Ye("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return d===null&&x&&(d=new XRWebGLBinding(r,t)),d},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(ee){if(r=ee,r!==null){if(A=e.getRenderTarget(),r.addEventListener("select",Y),r.addEventListener("selectstart",Y),r.addEventListener("selectend",Y),r.addEventListener("squeeze",Y),r.addEventListener("squeezestart",Y),r.addEventListener("squeezeend",Y),r.addEventListener("end",G),r.addEventListener("inputsourceschange",le),b.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Ce=null,Me=null;b.depth&&(Me=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=b.stencil?as:is,Ce=b.stencil?Eo:cr);let qe={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:s};d=this.getBinding(),f=d.createProjectionLayer(qe),r.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new Li(f.textureWidth,f.textureHeight,{format:fr,type:Fi,depthTexture:new ss(f.textureWidth,f.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ye={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,ye),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new Li(p.framebufferWidth,p.framebufferHeight,{format:fr,type:Fi,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),he.setContext(r),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function le(ee){for(let ge=0;ge<ee.removed.length;ge++){let ye=ee.removed[ge],Ce=C.indexOf(ye);Ce>=0&&(C[Ce]=null,P[Ce].disconnect(ye))}for(let ge=0;ge<ee.added.length;ge++){let ye=ee.added[ge],Ce=C.indexOf(ye);if(Ce===-1){for(let qe=0;qe<P.length;qe++)if(qe>=C.length){C.push(ye),Ce=qe;break}else if(C[qe]===null){C[qe]=ye,Ce=qe;break}if(Ce===-1)break}let Me=P[Ce];Me&&Me.connect(ye)}}function J(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(r===null)return;let ge=ee.near,ye=ee.far;_.texture!==null&&(_.depthNear>0&&(ge=_.depthNear),_.depthFar>0&&(ye=_.depthFar)),z.near=L.near=N.near=ge,z.far=L.far=N.far=ye,(U!==z.near||H!==z.far)&&(r.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,H=z.far),z.layers.mask=ee.layers.mask|6,N.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Ce=ee.parent,Me=z.cameras;J(z,Ce);for(let qe=0;qe<Me.length;qe++)J(Me[qe],Ce);z.projectionMatrix.copy(N.projectionMatrix),z.projectionMatrixInverse.copy(N.projectionMatrixInverse),k===null&&ee.isPerspectiveCamera&&(k={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Ce)};function Q(ee,ge,ye){ye===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(ye.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Fa*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ee)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(z)},this.getCameraTexture=function(ee){return g[ee]};let re=null;function fe(ee,ge){if(u=ge.getViewerPose(c||o),m=ge,u!==null){let ye=u.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Ce=!1;ye.length!==z.cameras.length&&(z.cameras.length=0,Ce=!0);for(let He=0;He<ye.length;He++){let dt=ye[He],ut=null;if(p!==null)ut=p.getViewport(dt);else{let en=d.getViewSubImage(f,dt);ut=en.viewport,He===0&&(e.setRenderTargetTextures(S,en.colorTexture,en.depthStencilTexture),e.setRenderTarget(S))}let rt=B[He];rt===void 0&&(rt=new li,rt.layers.enable(He),rt.viewport=new an,B[He]=rt),rt.matrix.fromArray(dt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(dt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ut.x,ut.y,ut.width,ut.height),He===0&&(z.matrix.copy(rt.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Ce===!0&&z.cameras.push(rt)}let Me=r.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&x){d=i.getBinding();let He=d.getDepthInformation(ye[0]);He&&He.isValid&&He.texture&&_.init(He,r.renderState)}if(Me&&Me.includes("camera-access")&&x){e.state.unbindTexture(),d=i.getBinding();for(let He=0;He<ye.length;He++){let dt=ye[He].camera;if(dt){let ut=g[dt];ut||(ut=new ic,g[dt]=ut);let rt=d.getCameraImage(dt);ut.sourceTexture=rt}}}}for(let ye=0;ye<P.length;ye++){let Ce=C[ye],Me=P[ye];Ce!==null&&Me!==void 0&&Me.update(Ce,ge,c||o)}re&&re(ee,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),m=null}let he=new px;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){re=ee},this.dispose=function(){}}},_I=new on,wx=new it;wx.set(-1,0,0,0,1,0,0,0,1);function vI(n,e){function t(_,g){_.matrixAutoUpdate===!0&&_.updateMatrix(),g.value.copy(_.matrix)}function i(_,g){g.color.getRGB(_.fogColor.value,Tm(n)),g.isFog?(_.fogNear.value=g.near,_.fogFar.value=g.far):g.isFogExp2&&(_.fogDensity.value=g.density)}function r(_,g,b,A,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(_,g):g.isMeshLambertMaterial?(s(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(_,g),d(_,g)):g.isMeshPhongMaterial?(s(_,g),u(_,g),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(_,g),f(_,g),g.isMeshPhysicalMaterial&&p(_,g,S)):g.isMeshMatcapMaterial?(s(_,g),m(_,g)):g.isMeshDepthMaterial?s(_,g):g.isMeshDistanceMaterial?(s(_,g),x(_,g)):g.isMeshNormalMaterial?s(_,g):g.isLineBasicMaterial?(o(_,g),g.isLineDashedMaterial&&a(_,g)):g.isPointsMaterial?l(_,g,b,A):g.isSpriteMaterial?c(_,g):g.isShadowMaterial?(_.color.value.copy(g.color),_.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(_,g){_.opacity.value=g.opacity,g.color&&_.diffuse.value.copy(g.color),g.emissive&&_.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.bumpMap&&(_.bumpMap.value=g.bumpMap,t(g.bumpMap,_.bumpMapTransform),_.bumpScale.value=g.bumpScale,g.side===ui&&(_.bumpScale.value*=-1)),g.normalMap&&(_.normalMap.value=g.normalMap,t(g.normalMap,_.normalMapTransform),_.normalScale.value.copy(g.normalScale),g.side===ui&&_.normalScale.value.negate()),g.displacementMap&&(_.displacementMap.value=g.displacementMap,t(g.displacementMap,_.displacementMapTransform),_.displacementScale.value=g.displacementScale,_.displacementBias.value=g.displacementBias),g.emissiveMap&&(_.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,_.emissiveMapTransform)),g.specularMap&&(_.specularMap.value=g.specularMap,t(g.specularMap,_.specularMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest);let b=e.get(g),A=b.envMap,S=b.envMapRotation;A&&(_.envMap.value=A,_.envMapRotation.value.setFromMatrix4(_I.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(wx),_.reflectivity.value=g.reflectivity,_.ior.value=g.ior,_.refractionRatio.value=g.refractionRatio),g.lightMap&&(_.lightMap.value=g.lightMap,_.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,_.lightMapTransform)),g.aoMap&&(_.aoMap.value=g.aoMap,_.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,_.aoMapTransform))}function o(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform))}function a(_,g){_.dashSize.value=g.dashSize,_.totalSize.value=g.dashSize+g.gapSize,_.scale.value=g.scale}function l(_,g,b,A){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.size.value=g.size*b,_.scale.value=A*.5,g.map&&(_.map.value=g.map,t(g.map,_.uvTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function c(_,g){_.diffuse.value.copy(g.color),_.opacity.value=g.opacity,_.rotation.value=g.rotation,g.map&&(_.map.value=g.map,t(g.map,_.mapTransform)),g.alphaMap&&(_.alphaMap.value=g.alphaMap,t(g.alphaMap,_.alphaMapTransform)),g.alphaTest>0&&(_.alphaTest.value=g.alphaTest)}function u(_,g){_.specular.value.copy(g.specular),_.shininess.value=Math.max(g.shininess,1e-4)}function d(_,g){g.gradientMap&&(_.gradientMap.value=g.gradientMap)}function f(_,g){_.metalness.value=g.metalness,g.metalnessMap&&(_.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,_.metalnessMapTransform)),_.roughness.value=g.roughness,g.roughnessMap&&(_.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,_.roughnessMapTransform)),g.envMap&&(_.envMapIntensity.value=g.envMapIntensity)}function p(_,g,b){_.ior.value=g.ior,g.diffuseRoughness>0&&(_.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),g.sheen>0&&(_.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),_.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(_.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,_.sheenColorMapTransform)),g.sheenRoughnessMap&&(_.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,_.sheenRoughnessMapTransform))),g.clearcoat>0&&(_.clearcoat.value=g.clearcoat,_.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(_.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,_.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(_.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===ui&&_.clearcoatNormalScale.value.negate())),g.dispersion>0&&(_.dispersion.value=g.dispersion),g.retroreflectivity>0&&(_.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(_.iridescence.value=g.iridescence,_.iridescenceIOR.value=g.iridescenceIOR,_.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(_.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,_.iridescenceMapTransform)),g.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),g.transmission>0&&(_.transmission.value=g.transmission,_.transmissionSamplerMap.value=b.texture,_.transmissionSamplerSize.value.set(b.width,b.height),g.transmissionMap&&(_.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,_.transmissionMapTransform)),_.thickness.value=g.thickness,g.thicknessMap&&(_.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=g.attenuationDistance,_.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(_.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(_.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=g.specularIntensity,_.specularColor.value.copy(g.specularColor),g.specularColorMap&&(_.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,_.specularColorMapTransform)),g.specularIntensityMap&&(_.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,_.specularIntensityMapTransform))}function m(_,g){g.matcap&&(_.matcap.value=g.matcap)}function x(_,g){let b=e.get(g).light;_.referencePosition.value.setFromMatrixPosition(b.matrixWorld),_.nearDistance.value=b.shadow.camera.near,_.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function yI(n,e,t,i){let r={},s={};function o(b,A){let S=A.program;i.uniformBlockBinding(b,S,r[b.id])}function a(b,A){let S=r[b.id];S===void 0&&(m(b),S=l(b),r[b.id]=S,b.addEventListener("dispose",_));let P=A.program;i.updateUBOMapping(b,P);let C=e.render.frame;s[b.id]!==C&&(c(b),s[b.id]=C)}function l(b){let A=n.createBuffer(),S=b.__size,P=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,P),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(b){let A=r[b.id],S=b.uniforms,P=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let C=0,v=S.length;C<v;C++){let E=S[C];if(Array.isArray(E))for(let k=0,N=E.length;k<N;k++)u(E[k],C,k,P);else u(E,C,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(b,A,S,P){if(f(b,A,S,P)===!0){let C=b.__offset,v=b.value;if(Array.isArray(v)){let E=0;for(let k=0;k<v.length;k++){let N=v[k],L=x(N,!0);d(N,b.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(v,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,b.__data)}}function d(b,A,S){typeof b=="number"||typeof b=="boolean"?A[S]=b:b.isMatrix3?(A[S]=b.elements[0],A[S+1]=b.elements[1],A[S+2]=b.elements[2],A[S+3]=0,A[S+4]=b.elements[3],A[S+5]=b.elements[4],A[S+6]=b.elements[5],A[S+7]=0,A[S+8]=b.elements[6],A[S+9]=b.elements[7],A[S+10]=b.elements[8],A[S+11]=0):ArrayBuffer.isView(b)?A.set(b.subarray(0,A.length-S),S):b.toArray(A,S)}function f(b,A,S,P){let C=b.value,v=A+"_"+S;if(Array.isArray(C)){P[v]===void 0&&(P[v]=[]);let E=P[v],k=!1;for(let N=0;N<C.length;N++)p(C[N],E,N)===!0&&(k=!0);return k}return p(C,P,v)}function p(b,A,S){if(A[S]===void 0)return typeof b=="number"||typeof b=="boolean"?A[S]=b:ArrayBuffer.isView(b)?A[S]=b.slice():A[S]=b.clone(),!0;{let P=A[S];if(typeof b=="number"||typeof b=="boolean"){if(P!==b)return A[S]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(P.equals(b)===!1)return P.copy(b),!0}}return!1}function m(b){let A=b.uniforms,S=0,P=16;for(let v=0,E=A.length;v<E;v++){let k=Array.isArray(A[v])?A[v]:[A[v]];for(let N=0,L=k.length;N<L;N++){let B=k[N],z=Array.isArray(B.value)?B.value:[B.value],U=Array.isArray(A[v])||Array.isArray(B.value),H=S;for(let G=0,le=z.length;G<le;G++){let J=z[G],Q=x(J,U),re=S%P,fe=re%Q.boundary,he=re+fe;S+=fe,he!==0&&P-he<Q.storage&&(S+=P-he),G===0&&(H=S),S+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((S-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}let C=S%P;return C>0&&(S+=P-C),b.__size=S,b.__cache={},this}function x(b,A){let S={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(S.boundary=4,S.storage=4):b.isVector2?(S.boundary=8,S.storage=8):b.isVector3||b.isColor?(S.boundary=16,S.storage=12):b.isVector4?(S.boundary=16,S.storage=16):b.isMatrix3?(S.boundary=16,S.storage=48):b.isMatrix4?(S.boundary=16,S.storage=64):b.isTexture?Ye("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(S.boundary=16,S.storage=b.byteLength):Ye("WebGLRenderer: Unsupported uniform value type.",b),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function _(b){let A=b.target;A.removeEventListener("dispose",_),n.deleteBuffer(r[A.id]),delete r[A.id],delete s[A.id]}function g(){for(let b in r)n.deleteBuffer(r[b]);r={},s={}}return{bind:o,update:a,dispose:g}}var xI=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Or=null;function bI(){return Or===null&&(Or=new bo(xI,16,16,Xs,hr),Or.name="DFG_LUT",Or.minFilter=$n,Or.magFilter=$n,Or.wrapS=Dr,Or.wrapT=Dr,Or.generateMipmaps=!1,Or.needsUpdate=!0),Or}var vf=class{constructor(e={}){let{canvas:t=Oy(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:f=!1,outputBufferType:p=Fi}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let x=p,_=new Set([Oh,Fh,Uh]),g=new Set([Fi,cr,$a,Eo,Dh,Nh]),b=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,C=null,v=[],E=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Fr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,B=null,z=null,U=null,H=null;this._outputColorSpace=Ri;let Y=0,G=0,le=null,J=-1,Q=null,re=new an,fe=new an,he=null,ee=new Mt(0),ge=0,ye=t.width,Ce=t.height,Me=1,qe=null,ot=null,He=new an(0,0,ye,Ce),dt=new an(0,0,ye,Ce),ut=!1,rt=new So,en=new ch,Xt=!1,yn=!1,Vt=new on,kn=new K,Tt=new an,Cn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},hn=!1;function xn(){return le===null?Me:1}let O=i;function Pe(T,V){return t.getContext(T,V)}let Ke,at,we,Ht,Ge,$e,R,M,q,ue,oe,ve,xe,te,ie,me,F,se,ne,Te,_e,Se,We;try{let T={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Re,!1),O===null){let V="webgl2";if(O=Pe(V,T),O===null)throw Pe(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(T){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),tt("WebGLRenderer: "+T.message),T}function Je(){Ke=new LR(O),Ke.init(),_e=new pI(O,Ke),at=new bR(O,Ke,e,_e),we=new fI(O,Ke),at.reversedDepthBuffer&&f&&we.buffers.depth.setReversed(!0),z=O.createFramebuffer(),U=O.createFramebuffer(),H=O.createFramebuffer(),Ht=new UR(O),Ge=new jP,$e=new dI(O,Ke,we,Ge,at,_e,Ht),R=new IR(N),M=new OE(O),Se=new yR(O,M),q=new DR(O,M,Ht,Se),ue=new OR(O,q,M,Se,Ht),se=new FR(O,at,$e),ie=new SR(Ge),oe=new JP(N,R,Ke,at,Se,ie),ve=new vI(N,Ge),xe=new eI,te=new oI(Ke),F=new vR(N,R,we,ue,m,l),me=new hI(N,ue,at),We=new yI(O,Ht,at,we),ne=new xR(O,Ke,Ht),Te=new NR(O,Ke,Ht),Ht.programs=oe.programs,N.capabilities=at,N.extensions=Ke,N.properties=Ge,N.renderLists=xe,N.shadowMap=me,N.state=we,N.info=Ht}x!==Fi&&(k=new BR(x,t.width,t.height,a,r,s));let ce=new km(N,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let T=Ke.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ke.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(T){T!==void 0&&(Me=T,this.setSize(ye,Ce,!1))},this.getSize=function(T){return T.set(ye,Ce)},this.setSize=function(T,V,j=!0){if(ce.isPresenting){Ye("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=T,Ce=V,t.width=Math.floor(T*Me),t.height=Math.floor(V*Me),j===!0&&(t.style.width=T+"px",t.style.height=V+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,T,V)},this.getDrawingBufferSize=function(T){return T.set(ye*Me,Ce*Me).floor()},this.setDrawingBufferSize=function(T,V,j){ye=T,Ce=V,Me=j,t.width=Math.floor(T*j),t.height=Math.floor(V*j),this.setViewport(0,0,T,V)},this.setEffects=function(T){if(x===Fi){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let V=0;V<T.length;V++)if(T[V].isOutputPass===!0){Ye("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(re)},this.getViewport=function(T){return T.copy(He)},this.setViewport=function(T,V,j,X){T.isVector4?He.set(T.x,T.y,T.z,T.w):He.set(T,V,j,X),we.viewport(re.copy(He).multiplyScalar(xn()).round())},this.getScissor=function(T){return T.copy(dt)},this.setScissor=function(T,V,j,X){T.isVector4?dt.set(T.x,T.y,T.z,T.w):dt.set(T,V,j,X),we.scissor(fe.copy(dt).multiplyScalar(xn()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(T){we.setScissorTest(ut=T)},this.setOpaqueSort=function(T){qe=T},this.setTransparentSort=function(T){ot=T},this.getClearColor=function(T){return T.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(T=!0,V=!0,j=!0){let X=0;if(T){let $=!1;if(le!==null){let Ee=le.texture.format;$=_.has(Ee)}if($){let Ee=le.texture.type,Ie=g.has(Ee),Ae=F.getClearColor(),Le=F.getClearAlpha(),Ve=Ae.r,Qe=Ae.g,pt=Ae.b;Ie?(b[0]=Ve,b[1]=Qe,b[2]=pt,b[3]=Le,O.clearBufferuiv(O.COLOR,0,b)):(A[0]=Ve,A[1]=Qe,A[2]=pt,A[3]=Le,O.clearBufferiv(O.COLOR,0,A))}else X|=O.COLOR_BUFFER_BIT}V&&(X|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(X|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),X!==0&&O.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),B=T},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),F.dispose(),xe.dispose(),te.dispose(),$e.dispose(),Ge.dispose(),R.dispose(),ue.dispose(),q.dispose(),Se.dispose(),We.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Uc),ce.removeEventListener("sessionend",_r),Hr.stop()};function ke(T){T.preventDefault(),xm("WebGLRenderer: Context Lost."),L=!0}function je(){xm("WebGLRenderer: Context Restored."),L=!1;let T=Ht.autoReset,V=me.enabled,j=me.autoUpdate,X=me.needsUpdate,$=me.type;Je(),Ht.autoReset=T,me.enabled=V,me.autoUpdate=j,me.needsUpdate=X,me.type=$}function Re(T){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ct(T){let V=T.target;V.removeEventListener("dispose",ct),$t(V)}function $t(T){ti(T),Ge.remove(T)}function ti(T){let V=Ge.get(T).programs;V!==void 0&&(V.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,V,j,X,$,Ee){V===null&&(V=Cn);let Ie=$.isMesh&&$.matrixWorld.determinantAffine()<0,Ae=fl(T,V,j,X,$);we.setMaterial(X,Ie);let Le=j.index,Ve=1;if(X.wireframe===!0){if(Le=q.getWireframeAttribute(j),Le===void 0)return;Ve=2}let Qe=j.drawRange,pt=j.attributes.position,Be=Qe.start*Ve,mt=(Qe.start+Qe.count)*Ve;Ee!==null&&(Be=Math.max(Be,Ee.start*Ve),mt=Math.min(mt,(Ee.start+Ee.count)*Ve)),Le!==null?(Be=Math.max(Be,0),mt=Math.min(mt,Le.count)):pt!=null&&(Be=Math.max(Be,0),mt=Math.min(mt,pt.count));let sn=mt-Be;if(sn<0||sn===1/0)return;Se.setup($,X,Ae,j,Le);let kt,Bt=ne;if(Le!==null&&(kt=M.get(Le),Bt=Te,Bt.setIndex(kt)),$.isMesh)X.wireframe===!0?(we.setLineWidth(X.wireframeLinewidth*xn()),Bt.setMode(O.LINES)):Bt.setMode(O.TRIANGLES);else if($.isLine){let Rn=X.linewidth;Rn===void 0&&(Rn=1),we.setLineWidth(Rn*xn()),$.isLineSegments?Bt.setMode(O.LINES):$.isLineLoop?Bt.setMode(O.LINE_LOOP):Bt.setMode(O.LINE_STRIP)}else $.isPoints?Bt.setMode(O.POINTS):$.isSprite&&Bt.setMode(O.TRIANGLES);if($.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Bt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let Rn=$._multiDrawStarts,Fe=$._multiDrawCounts,bn=$._multiDrawCount,yt=Le?M.get(Le).bytesPerElement:1,qr=Ge.get(X).currentProgram.getUniforms();for(let Sn=0;Sn<bn;Sn++)qr.setValue(O,"_gl_DrawID",Sn),Bt.render(Rn[Sn]/yt,Fe[Sn])}else if($.isInstancedMesh)Bt.renderInstances(Be,sn,$.count);else if(j.isInstancedBufferGeometry){let Rn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,Rn);Bt.renderInstances(Be,sn,Fe)}else Bt.render(Be,sn)};function cl(T,V,j,X){B!==null&&T.isNodeMaterial&&B.setObject(X,T),Xt===!0&&ie.setState(T,j,!1),T.transparent===!0&&T.side===Xi&&T.forceSinglePass===!1?(T.side=ui,T.needsUpdate=!0,vr(T,V,X),T.side=qs,T.needsUpdate=!0,vr(T,V,X),T.side=Xi):vr(T,V,X)}this.compile=function(T,V,j=null){j===null&&(j=T),B!==null&&B.renderStart(T,V,j),C=te.get(j),C.init(V),E.push(C),j.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),T!==j&&T.traverseVisible(function($){$.isLight&&$.layers.test(V.layers)&&(C.pushLight($),$.castShadow&&C.pushShadow($))}),C.setupLights(),B!==null&&B.updateLights(C.state.lightsArray),yn=this.localClippingEnabled,Xt=ie.init(this.clippingPlanes,yn),Xt===!0&&ie.setGlobalState(this.clippingPlanes,V),B!==null&&me.render(C.state.shadowsArray,j,V);let X=new Set;return T.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Ee=$.material;if(Ee)if(Array.isArray(Ee))for(let Ie=0;Ie<Ee.length;Ie++){let Ae=Ee[Ie];cl(Ae,j,V,$),X.add(Ae)}else cl(Ee,j,V,$),X.add(Ee)}),C=E.pop(),B!==null&&B.renderEnd(),X},this.compileAsync=function(T,V,j=null){let X=this.compile(T,V,j);return new Promise($=>{function Ee(){if(X.forEach(function(Ie){let Le=Ge.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&X.delete(Ie)}),X.size===0){$(T);return}setTimeout(Ee,10)}Ke.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Oo=null;function ld(T){Oo&&Oo(T)}function Uc(){Hr.stop()}function _r(){Hr.start()}let Hr=new px;Hr.setAnimationLoop(ld),typeof self<"u"&&Hr.setContext(self),this.setAnimationLoop=function(T){Oo=T,ce.setAnimationLoop(T),T===null?Hr.stop():Hr.start()},ce.addEventListener("sessionstart",Uc),ce.addEventListener("sessionend",_r),this.render=function(T,V){if(V!==void 0&&V.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;B!==null&&B.renderStart(T,V);let j=ce.enabled===!0&&ce.isPresenting===!0,X=k!==null&&(le===null||j)&&k.begin(N,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(N,T,V,le),C=te.get(T,E.length),C.init(V),C.state.textureUnits=$e.getTextureUnits(),E.push(C),Vt.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?en.setFromArrayCamera(V):rt.setFromProjectionMatrix(Vt,Wi,V.reversedDepth),yn=this.localClippingEnabled,Xt=ie.init(this.clippingPlanes,yn),P=xe.get(T,v.length),P.init(),v.push(P),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=N.xr.getDepthSensingMesh();Ie!==null&&Wr(Ie,V,-1/0,N.sortObjects)}Wr(T,V,0,N.sortObjects),P.finish(),B!==null&&B.updateLights(C.state.lightsArray),N.sortObjects===!0&&P.sort(qe,ot),hn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,hn&&F.addToRenderList(P,T),this.info.autoReset===!0&&this.info.reset(),Xt===!0&&ie.beginShadows();let $=C.state.shadowsArray;if(me.render($,T,V),Xt===!0&&ie.endShadows(),(X&&k.hasRenderPass())===!1){let Ie=P.opaque,Ae=P.transmissive;if(C.setupLights(),V.isArrayCamera){let Le=V.cameras;if(Ae.length>0)for(let Ve=0,Qe=Le.length;Ve<Qe;Ve++){let pt=Le[Ve];Zi(Ie,Ae,T,pt)}hn&&F.render(T);for(let Ve=0,Qe=Le.length;Ve<Qe;Ve++){let pt=Le[Ve];ul(P,T,pt,pt.viewport)}}else Ae.length>0&&Zi(Ie,Ae,T,V),hn&&F.render(T),ul(P,T,V)}le!==null&&G===0&&($e.updateMultisampleRenderTarget(le),$e.updateRenderTargetMipmap(le)),X&&k.end(N),T.isScene===!0&&T.onAfterRender(N,T,V),Se.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(C=E[E.length-1],$e.setTextureUnits(C.state.textureUnits),Xt===!0&&ie.setGlobalState(N.clippingPlanes,C.state.camera)):C=null,v.pop(),v.length>0?P=v[v.length-1]:P=null,B!==null&&B.renderEnd()};function Wr(T,V,j,X){if(T.visible===!1)return;if(T.layers.test(V.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(V);else if(T.isLight)C.pushLight(T),T.castShadow&&C.pushShadow(T);else if(T.isSprite){let Ie=V.isArrayCamera?en:rt;if(!T.frustumCulled||T.intersectsFrustum(Ie)){X&&Tt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Vt);let Ae=ue.update(T),Le=T.material;Le.visible&&P.push(T,Ae,Le,j,Tt.z,null,V)}}else if(T.isMesh||T.isLine||T.isPoints){let Ie=V.isArrayCamera?en:rt;if(!T.frustumCulled||T.intersectsFrustum(Ie)){let Ae=ue.update(T),Le=T.material;if(X&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),Tt.copy(T.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),Tt.copy(Ae.boundingSphere.center)),Tt.applyMatrix4(T.matrixWorld).applyMatrix4(Vt)),Array.isArray(Le)){let Ve=Ae.groups;for(let Qe=0,pt=Ve.length;Qe<pt;Qe++){let Be=Ve[Qe],mt=Le[Be.materialIndex];mt&&mt.visible&&P.push(T,Ae,mt,j,Tt.z,Be,V)}}else Le.visible&&P.push(T,Ae,Le,j,Tt.z,null,V)}}}let Ee=T.children;for(let Ie=0,Ae=Ee.length;Ie<Ae;Ie++)Wr(Ee[Ie],V,j,X)}function ul(T,V,j,X){let{opaque:$,transmissive:Ee,transparent:Ie}=T;C.setupLightsView(j),Xt===!0&&ie.setGlobalState(N.clippingPlanes,j),X&&we.viewport(re.copy(X)),$.length>0&&fn($,V,j),Ee.length>0&&fn(Ee,V,j),Ie.length>0&&fn(Ie,V,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Zi(T,V,j,X){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[X.id]===void 0){let Be=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[X.id]=new Li(1,1,{generateMipmaps:!0,type:Be?hr:Fi,minFilter:os,samples:Math.max(4,at.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:St.workingColorSpace})}let Ee=C.state.transmissionRenderTarget[X.id],Ie=X.viewport||re;Ee.setSize(Ie.z*N.transmissionResolutionScale,Ie.w*N.transmissionResolutionScale);let Ae=N.getRenderTarget(),Le=N.getActiveCubeFace(),Ve=N.getActiveMipmapLevel();N.setRenderTarget(Ee),N.getClearColor(ee),ge=N.getClearAlpha(),ge<1&&N.setClearColor(16777215,.5),N.clear(),hn&&F.render(j);let Qe=N.toneMapping;N.toneMapping=Fr;let pt=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),C.setupLightsView(X),Xt===!0&&ie.setGlobalState(N.clippingPlanes,X),fn(T,j,X),$e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let mt=0,sn=V.length;mt<sn;mt++){let kt=V[mt],{object:Bt,geometry:Rn,material:Fe,group:bn}=kt;if(Fe.side===Xi&&Bt.layers.test(X.layers)){let yt=Fe.side;Fe.side=ui,Fe.needsUpdate=!0,gn(Bt,j,X,Rn,Fe,bn),Fe.side=yt,Fe.needsUpdate=!0,Be=!0}}Be===!0&&($e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee))}N.setRenderTarget(Ae,Le,Ve),N.setClearColor(ee,ge),pt!==void 0&&(X.viewport=pt),N.toneMapping=Qe}function fn(T,V,j){let X=V.isScene===!0?V.overrideMaterial:null;for(let $=0,Ee=T.length;$<Ee;$++){let Ie=T[$],{object:Ae,geometry:Le,group:Ve}=Ie,Qe=Ie.material;Qe.allowOverride===!0&&X!==null&&(Qe=X),Ae.layers.test(j.layers)&&gn(Ae,V,j,Le,Qe,Ve)}}function gn(T,V,j,X,$,Ee){B!==null&&$.isNodeMaterial&&B.setObject(T,$),T.onBeforeRender(N,V,j,X,$,Ee),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),$.onBeforeRender(N,V,j,X,T,Ee),$.transparent===!0&&$.side===Xi&&$.forceSinglePass===!1?($.side=ui,$.needsUpdate=!0,N.renderBufferDirect(j,V,X,$,T,Ee),$.side=qs,$.needsUpdate=!0,N.renderBufferDirect(j,V,X,$,T,Ee),$.side=Xi):N.renderBufferDirect(j,V,X,$,T,Ee),T.onAfterRender(N,V,j,X,$,Ee)}function _n(T){let V=0;for(let j of T)j.texture!==null&&V++;return V}function vr(T,V,j){V.isScene!==!0&&(V=Cn);let X=Ge.get(T),$=C.state.lights,Ee=C.state.shadowsArray,Ie=$.state.version,Ae=oe.getParameters(T,$.state,Ee,V,j,C.state.lightProbeGridArray),Le=oe.getProgramCacheKey(Ae),Ve=X.programs;X.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?V.environment:null,X.fog=V.fog;let Qe=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;X.envMap=R.get(T.envMap||X.environment,Qe),X.envMapRotation=X.environment!==null&&T.envMap===null?V.environmentRotation:T.envMapRotation,Ve===void 0&&(T.addEventListener("dispose",ct),Ve=new Map,X.programs=Ve,X.programVariants=new Map);let pt=Ve.get(Le);if(pt!==void 0){if(X.currentProgram===pt&&X.lightsStateVersion===Ie)return hl(T,Ae),pt}else Ae.uniforms=oe.getUniforms(T),B!==null&&T.isNodeMaterial&&B.build(T,j,Ae),T.onBeforeCompile(Ae,N),pt=oe.acquireProgram(Ae,Le),Ve.set(Le,pt),X.uniforms=Ae.uniforms;let Be=X.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Be.clippingPlanes=ie.uniform),hl(T,Ae),X.needsLights=_s(T),X.lightsStateVersion=Ie,X.needsLights&&(Be.ambientLightColor.value=$.state.ambient,Be.lightProbe.value=$.state.probe,Be.sunLights.value=$.state.sun,Be.sunLightShadows.value=$.state.sunShadow,Be.directionalLights.value=$.state.directional,Be.directionalLightShadows.value=$.state.directionalShadow,Be.spotLights.value=$.state.spot,Be.spotLightShadows.value=$.state.spotShadow,Be.rectAreaLights.value=$.state.rectArea,Be.ltc_1.value=$.state.rectAreaLTC1,Be.ltc_2.value=$.state.rectAreaLTC2,Be.pointLights.value=$.state.point,Be.pointLightShadows.value=$.state.pointShadow,Be.hemisphereLights.value=$.state.hemi,Be.sunShadowMatrix.value=$.state.sunShadowMatrix,Be.sunShadowCascade.value=$.state.sunShadowCascade,Be.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Be.spotLightMatrix.value=$.state.spotLightMatrix,Be.spotLightMap.value=$.state.spotLightMap,Be.pointShadowMatrix.value=$.state.pointShadowMatrix),X.numLightProbeGrids=_n(C.state.lightProbeGridArray),X.currentProgram=pt,X.uniformsList=null,pt}function xi(T,V,j,X,$){let Ee=Ge.get(T),Ie=Ee.currentProgram.id+","+X+","+$,Ae=Ee.programVariants.get(Ie);return Ae===void 0?(Ae=vr(T,V,j),Ee.programVariants.set(Ie,Ae)):(Ee.currentProgram=Ae,Ee.uniformsList=null,Ee.outputColorSpace=X,Ee.toneMapping=$),Ae}function gs(T){if(T.uniformsList===null){let V=T.currentProgram.getUniforms();T.uniformsList=Ka.seqWithValue(V.seq,T.uniforms)}return T.uniformsList}function hl(T,V){let j=Ge.get(T);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function fl(T,V,j,X,$){V.isScene!==!0&&(V=Cn),$e.resetTextureUnits();let Ee=V.fog,Ie=X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial?V.environment:null,Ae=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:St.workingColorSpace,Le=X.isMeshStandardMaterial||X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,Ve=R.get(X.envMap||Ie,Le),Qe=X.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,pt=!!j.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Be=!!j.morphAttributes.position,mt=!!j.morphAttributes.normal,sn=!!j.morphAttributes.color,kt=Fr;X.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(kt=N.toneMapping);let Bt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Rn=Bt!==void 0?Bt.length:0,Fe=Ge.get(X),bn=C.state.lights;if(Xt===!0&&(yn===!0||T!==Q)){let zt=T===Q&&X.id===J;ie.setState(X,T,zt)}let yt=!1,qr=!1;X.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==bn.state.version||$.isBatchedMesh&&Fe.batching===!1||!$.isBatchedMesh&&Fe.batching===!0||$.isBatchedMesh&&Fe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Fe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Fe.instancing===!1||!$.isInstancedMesh&&Fe.instancing===!0||$.isSkinnedMesh&&Fe.skinning===!1||!$.isSkinnedMesh&&Fe.skinning===!0||$.isInstancedMesh&&Fe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Fe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Fe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Fe.instancingMorph===!1&&$.morphTexture!==null||Fe.envMap!==Ve||X.fog===!0&&Fe.fog!==Ee||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ie.numPlanes||Fe.numIntersection!==ie.numIntersection)||Fe.vertexAlphas!==Qe||Fe.vertexTangents!==pt||Fe.morphTargets!==Be||Fe.morphNormals!==mt||Fe.morphColors!==sn||Fe.morphTargetsCount!==Rn||Fe.numLightProbeGrids!==_n(C.state.lightProbeGridArray)?yt=!0:(Fe.outputColorSpace!==Ae||Fe.toneMapping!==kt)&&(qr=!0):(yt=!0,Fe.__version=X.version);let Sn=Fe.currentProgram;(yt===!0||qr===!0)&&(Sn=qr===!0?xi(X,V,$,Ae,kt):vr(X,V,$),B&&X.isNodeMaterial&&B.onUpdateProgram(X,Sn,Fe));let zo=!1,yr=!1,Xr=!1,ht=Sn.getUniforms(),dn=Fe.uniforms;if(we.useProgram(Sn.program)&&(zo=!0,yr=!0,Xr=!0),X.id!==J&&(J=X.id,yr=!0),zo||Q!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ht.setValue(O,"projectionMatrix",T.projectionMatrix),ht.setValue(O,"viewMatrix",T.matrixWorldInverse);let Mn=ht.map.cameraPosition;Mn!==void 0&&Mn.setValue(O,kn.setFromMatrixPosition(T.matrixWorld)),at.logarithmicDepthBuffer&&ht.setValue(O,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&ht.setValue(O,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,yr=!0,Xr=!0)}if(Fe.needsLights&&(bn.state.sunShadowMap.length>0&&ht.setValue(O,"sunShadowMap",bn.state.sunShadowMap,$e),bn.state.directionalShadowMap.length>0&&ht.setValue(O,"directionalShadowMap",bn.state.directionalShadowMap,$e),bn.state.spotShadowMap.length>0&&ht.setValue(O,"spotShadowMap",bn.state.spotShadowMap,$e),bn.state.pointShadowMap.length>0&&ht.setValue(O,"pointShadowMap",bn.state.pointShadowMap,$e)),$.isSkinnedMesh){ht.setOptional(O,$,"bindMatrix"),ht.setOptional(O,$,"bindMatrixInverse");let zt=$.skeleton;zt&&(zt.boneTexture===null&&zt.computeBoneTexture(),ht.setValue(O,"boneTexture",zt.boneTexture,$e))}$.isBatchedMesh&&(ht.setOptional(O,$,"batchingTexture"),ht.setValue(O,"batchingTexture",$._matricesTexture,$e),ht.setOptional(O,$,"batchingIdTexture"),ht.setValue(O,"batchingIdTexture",$._indirectTexture,$e),ht.setOptional(O,$,"batchingColorTexture"),$._colorsTexture!==null&&ht.setValue(O,"batchingColorTexture",$._colorsTexture,$e));let ni=j.morphAttributes;if((ni.position!==void 0||ni.normal!==void 0||ni.color!==void 0)&&se.update($,j,Sn),(yr||Fe.receiveShadow!==$.receiveShadow)&&(Fe.receiveShadow=$.receiveShadow,ht.setValue(O,"receiveShadow",$.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&V.environment!==null&&(dn.envMapIntensity.value=V.environmentIntensity),dn.dfgLUT!==void 0&&(dn.dfgLUT.value=bI()),yr){if(ht.setValue(O,"toneMappingExposure",N.toneMappingExposure),Fe.needsLights&&ko(dn,Xr),Ee&&X.fog===!0&&ve.refreshFogUniforms(dn,Ee),ve.refreshMaterialUniforms(dn,X,Me,Ce,C.state.transmissionRenderTarget[T.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let zt=S,Mn=0;for(let Kn of C.state.lightProbeGridArray)Kn.texture!==null&&(zt.textures[Mn]=Kn.texture,zt.min[Mn]=Kn.boundingBox.min,zt.max[Mn]=Kn.boundingBox.max,zt.resolution[Mn]=Kn.resolution,Mn++);for(let Kn in zt)zt[Kn].length=Mn;dn.probesSH.value=zt.textures,dn.probesMin.value=zt.min,dn.probesMax.value=zt.max,dn.probesResolution.value=zt.resolution}Ka.upload(O,gs(Fe),dn,$e)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(Ka.upload(O,gs(Fe),dn,$e),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&ht.setValue(O,"center",$.center),ht.setValue(O,"modelViewMatrix",$.modelViewMatrix),ht.setValue(O,"normalMatrix",$.normalMatrix),ht.setValue(O,"modelMatrix",$.matrixWorld),X.uniformsGroups!==void 0){let zt=X.uniformsGroups;for(let Mn=0,Kn=zt.length;Mn<Kn;Mn++){let Fc=zt[Mn];We.update(Fc,Sn),We.bind(Fc,Sn)}}return Sn}function ko(T,V){T.ambientLightColor.needsUpdate=V,T.lightProbe.needsUpdate=V,T.sunLights.needsUpdate=V,T.sunLightShadows.needsUpdate=V,T.directionalLights.needsUpdate=V,T.directionalLightShadows.needsUpdate=V,T.pointLights.needsUpdate=V,T.pointLightShadows.needsUpdate=V,T.spotLights.needsUpdate=V,T.spotLightShadows.needsUpdate=V,T.rectAreaLights.needsUpdate=V,T.hemisphereLights.needsUpdate=V}function _s(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,V,j){let X=Ge.get(T);X.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),Ge.get(T.texture).__webglTexture=V,Ge.get(T.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?void 0:j,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,V){let j=Ge.get(T);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(T,V=0,j=0){le=T,Y=V,G=j;let X=null,$=!1,Ee=!1;if(T){let Ae=Ge.get(T);if(Ae.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(O.FRAMEBUFFER,Ae.__webglFramebuffer),re.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest,we.viewport(re),we.scissor(fe),we.setScissorTest(he),J=-1;return}else if(Ae.__webglFramebuffer===void 0)$e.setupRenderTarget(T);else if(Ae.__hasExternalTextures)$e.rebindTextures(T,Ge.get(T.texture).__webglTexture,Ge.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let Qe=T.depthTexture;if(Ae.__boundDepthTexture!==Qe){if(Qe!==null&&Ge.has(Qe)&&(T.width!==Qe.image.width||T.height!==Qe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(T)}}let Le=T.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ee=!0);let Ve=Ge.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ve[V])?X=Ve[V][j]:X=Ve[V],$=!0):T.samples>0&&$e.useMultisampledRTT(T)===!1?X=Ge.get(T).__webglMultisampledFramebuffer:Array.isArray(Ve)?X=Ve[j]:X=Ve,re.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest}else re.copy(He).multiplyScalar(Me).floor(),fe.copy(dt).multiplyScalar(Me).floor(),he=ut;if(j!==0&&(X=z),we.bindFramebuffer(O.FRAMEBUFFER,X)&&we.drawBuffers(T,X),we.viewport(re),we.scissor(fe),we.setScissorTest(he),$){let Ae=Ge.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+V,Ae.__webglTexture,j)}else if(Ee){let Ae=V;for(let Le=0;Le<T.textures.length;Le++){let Ve=Ge.get(T.textures[Le]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Le,Ve.__webglTexture,j,Ae)}}else if(T!==null&&j!==0){let Ae=Ge.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ae.__webglTexture,j)}J=-1};function Bo(T){let V=Ge.get(T);return(V.__readFormat!==T.format||V.__readType!==T.type)&&(V.__readFormat=T.format,V.__readType=T.type,V.__formatReadable=at.textureFormatReadable(T.format),V.__typeReadable=at.textureTypeReadable(T.type)),V}this.readRenderTargetPixels=function(T,V,j,X,$,Ee,Ie,Ae=0){if(!(T&&T.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){we.bindFramebuffer(O.FRAMEBUFFER,Le);try{let Ve=T.textures[Ae],Qe=Ve.format,pt=Ve.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ae);let Be=Bo(Ve);if(Be.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=T.width-X&&j>=0&&j<=T.height-$&&O.readPixels(V,j,X,$,_e.convert(Qe),_e.convert(pt),Ee)}finally{let Ve=le!==null?Ge.get(le).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(T,V,j,X,$,Ee,Ie,Ae=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ge.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(V>=0&&V<=T.width-X&&j>=0&&j<=T.height-$){we.bindFramebuffer(O.FRAMEBUFFER,Le);let Ve=T.textures[Ae],Qe=Ve.format,pt=Ve.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ae);let Be=Bo(Ve);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let mt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,mt),O.bufferData(O.PIXEL_PACK_BUFFER,Ee.byteLength,O.STREAM_READ),O.readPixels(V,j,X,$,_e.convert(Qe),_e.convert(pt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let sn=le!==null?Ge.get(le).__webglFramebuffer:null;we.bindFramebuffer(O.FRAMEBUFFER,sn);let kt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await By(O,kt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,mt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Ee),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(mt),O.deleteSync(kt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,V=null,j=0){let X=Math.pow(2,-j),$=Math.floor(T.image.width*X),Ee=Math.floor(T.image.height*X),Ie=V!==null?V.x:0,Ae=V!==null?V.y:0;$e.setTexture2D(T,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Ie,Ae,$,Ee),we.unbindTexture()},this.copyTextureToTexture=function(T,V,j=null,X=null,$=0,Ee=0){let Ie,Ae,Le,Ve,Qe,pt,Be,mt,sn,kt=T.isCompressedTexture?T.mipmaps[Ee]:T.image;if(j!==null)Ie=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,Ve=j.min.x,Qe=j.min.y,pt=j.isBox3?j.min.z:0;else{let ht=Math.pow(2,-$);Ie=Math.floor(kt.width*ht),Ae=Math.floor(kt.height*ht),T.isDataArrayTexture?Le=kt.depth:T.isData3DTexture?Le=Math.floor(kt.depth*ht):Le=1,Ve=0,Qe=0,pt=0}X!==null?(Be=X.x,mt=X.y,sn=X.z):(Be=0,mt=0,sn=0);let Bt=_e.convert(V.format),Rn=_e.convert(V.type),Fe;V.isData3DTexture?($e.setTexture3D(V,0),Fe=O.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?($e.setTexture2DArray(V,0),Fe=O.TEXTURE_2D_ARRAY):($e.setTexture2D(V,0),Fe=O.TEXTURE_2D),we.activeTexture(O.TEXTURE0),we.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,V.flipY),we.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),we.pixelStorei(O.UNPACK_ALIGNMENT,V.unpackAlignment);let bn=we.getParameter(O.UNPACK_ROW_LENGTH),yt=we.getParameter(O.UNPACK_IMAGE_HEIGHT),qr=we.getParameter(O.UNPACK_SKIP_PIXELS),Sn=we.getParameter(O.UNPACK_SKIP_ROWS),zo=we.getParameter(O.UNPACK_SKIP_IMAGES);we.pixelStorei(O.UNPACK_ROW_LENGTH,kt.width),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,kt.height),we.pixelStorei(O.UNPACK_SKIP_PIXELS,Ve),we.pixelStorei(O.UNPACK_SKIP_ROWS,Qe),we.pixelStorei(O.UNPACK_SKIP_IMAGES,pt);let yr=T.isDataArrayTexture||T.isData3DTexture,Xr=V.isDataArrayTexture||V.isData3DTexture;if(T.isDepthTexture){let ht=Ge.get(T),dn=Ge.get(V),ni=Ge.get(ht.__renderTarget),zt=Ge.get(dn.__renderTarget);we.bindFramebuffer(O.READ_FRAMEBUFFER,ni.__webglFramebuffer),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,zt.__webglFramebuffer);for(let Mn=0;Mn<Le;Mn++)yr&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ge.get(T).__webglTexture,$,pt+Mn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ge.get(V).__webglTexture,Ee,sn+Mn)),O.blitFramebuffer(Ve,Qe,Ve+Ie,Qe+Ae,Be,mt,Be+Ie,mt+Ae,O.DEPTH_BUFFER_BIT,O.NEAREST);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if($!==0||T.isRenderTargetTexture||Ge.has(T)){let ht=Ge.get(T),dn=Ge.get(V);we.bindFramebuffer(O.READ_FRAMEBUFFER,U),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let ni=0;ni<Le;ni++)yr?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ht.__webglTexture,$,pt+ni):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ht.__webglTexture,$),Xr?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,dn.__webglTexture,Ee,sn+ni):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,dn.__webglTexture,Ee),$!==0?O.blitFramebuffer(Ve,Qe,Ve+Ie,Qe+Ae,Be,mt,Be+Ie,mt+Ae,O.COLOR_BUFFER_BIT,O.NEAREST):Xr?O.copyTexSubImage3D(Fe,Ee,Be,mt,sn+ni,Ve,Qe,Ie,Ae):O.copyTexSubImage2D(Fe,Ee,Be,mt,Ve,Qe,Ie,Ae);we.bindFramebuffer(O.READ_FRAMEBUFFER,null),we.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Xr?T.isDataTexture||T.isData3DTexture?O.texSubImage3D(Fe,Ee,Be,mt,sn,Ie,Ae,Le,Bt,Rn,kt.data):V.isCompressedArrayTexture?O.compressedTexSubImage3D(Fe,Ee,Be,mt,sn,Ie,Ae,Le,Bt,kt.data):O.texSubImage3D(Fe,Ee,Be,mt,sn,Ie,Ae,Le,Bt,Rn,kt):T.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Ee,Be,mt,Ie,Ae,Bt,Rn,kt.data):T.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Ee,Be,mt,kt.width,kt.height,Bt,kt.data):O.texSubImage2D(O.TEXTURE_2D,Ee,Be,mt,Ie,Ae,Bt,Rn,kt);we.pixelStorei(O.UNPACK_ROW_LENGTH,bn),we.pixelStorei(O.UNPACK_IMAGE_HEIGHT,yt),we.pixelStorei(O.UNPACK_SKIP_PIXELS,qr),we.pixelStorei(O.UNPACK_SKIP_ROWS,Sn),we.pixelStorei(O.UNPACK_SKIP_IMAGES,zo),Ee===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&O.generateMipmap(Fe),we.unbindTexture()},this.initRenderTarget=function(T){Ge.get(T).__webglFramebuffer===void 0&&$e.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?$e.setTextureCube(T,0):T.isData3DTexture?$e.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?$e.setTexture2DArray(T,0):$e.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){Y=0,G=0,le=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Wi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=St._getDrawingBufferColorSpace(e),t.unpackColorSpace=St._getUnpackColorSpace()}};var Tx={type:"change"},zm={type:"start"},Ax={type:"end"},bf=new xo,Ex=new Pi,MI=Math.cos(70*wm.DEG2RAD),Fn=new K,_i=2*Math.PI,Nt={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Bm=1e-6,Sf=class extends ac{constructor(e,t=null){super(e,t),this.state=Nt.NONE,this.target=new K,this.cursor=new K,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hs.ROTATE,MIDDLE:Hs.DOLLY,RIGHT:Hs.PAN},this.touches={ONE:Ws.ROTATE,TWO:Ws.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new K,this._lastQuaternion=new Ii,this._lastTargetPosition=new K,this._quat=new Ii().setFromUnitVectors(e.up,new K(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ha,this._sphericalDelta=new Ha,this._scale=1,this._panOffset=new K,this._rotateStart=new nt,this._rotateEnd=new nt,this._rotateDelta=new nt,this._panStart=new nt,this._panEnd=new nt,this._panDelta=new nt,this._dollyStart=new nt,this._dollyEnd=new nt,this._dollyDelta=new nt,this._dollyDirection=new K,this._mouse=new nt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=TI.bind(this),this._onPointerDown=wI.bind(this),this._onPointerUp=EI.bind(this),this._onContextMenu=DI.bind(this),this._onMouseWheel=RI.bind(this),this._onKeyDown=PI.bind(this),this._onTouchStart=II.bind(this),this._onTouchMove=LI.bind(this),this._onMouseDown=AI.bind(this),this._onMouseMove=CI.bind(this),this._interceptControlDown=NI.bind(this),this._interceptControlUp=UI.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Nt.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Tx),this.update(),this.state=Nt.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Fn.copy(t).sub(this.target),Fn.applyQuaternion(this._quat),this._spherical.setFromVector3(Fn),this.autoRotate&&this.state===Nt.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(i)&&isFinite(r)&&(i<-Math.PI?i+=_i:i>Math.PI&&(i-=_i),r<-Math.PI?r+=_i:r>Math.PI&&(r-=_i),i<=r?this._spherical.theta=Math.max(i,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+r)/2?Math.max(i,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=o!=this._spherical.radius}if(Fn.setFromSpherical(this._spherical),Fn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Fn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Fn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),s=!!l}else if(this.object.isOrthographicCamera){let a=new K(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=l!==this.object.zoom;let c=new K(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Fn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(bf.origin.copy(this.object.position),bf.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(bf.direction))<MI?this.object.lookAt(this.target):(Ex.setFromNormalAndCoplanarPoint(this.object.up,this.target),bf.intersectPlane(Ex,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>Bm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Bm||this._lastTargetPosition.distanceToSquared(this.target)>Bm?(this.dispatchEvent(Tx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?_i/60*this.autoRotateSpeed*e:_i/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Fn.setFromMatrixColumn(t,0),Fn.multiplyScalar(-e),this._panOffset.add(Fn)}_panUp(e,t){this.screenSpacePanning===!0?Fn.setFromMatrixColumn(t,1):(Fn.setFromMatrixColumn(t,0),Fn.crossVectors(this.object.up,Fn)),Fn.multiplyScalar(e),this._panOffset.add(Fn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;Fn.copy(r).sub(this.target);let s=Fn.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*s/i.clientHeight,this.object.matrix),this._panUp(2*t*s/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),r=e-i.left,s=t-i.top,o=i.width,a=i.height;this._mouse.x=r/o*2-1,this._mouse.y=-(s/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(_i*this._rotateDelta.x/t.clientHeight),this._rotateUp(_i*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(_i*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-_i*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(_i*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-_i*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(i,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(i,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,r=e.pageY-t.y,s=Math.sqrt(i*i+r*r);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),r=.5*(e.pageX+i.x),s=.5*(e.pageY+i.y);this._rotateEnd.set(r,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(_i*this._rotateDelta.x/t.clientHeight),this._rotateUp(_i*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(i,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,r=e.pageY-t.y,s=Math.sqrt(i*i+r*r);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new nt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function wI(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function TI(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function EI(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Ax),this.state=Nt.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function AI(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Hs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Nt.DOLLY;break;case Hs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Nt.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Nt.ROTATE}break;case Hs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Nt.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Nt.PAN}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(zm)}function CI(n){switch(this.state){case Nt.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Nt.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Nt.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function RI(n){this.enabled===!1||this.enableZoom===!1||this.state!==Nt.NONE||(n.preventDefault(),this.dispatchEvent(zm),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Ax))}function PI(n){this.enabled!==!1&&this._handleKeyDown(n)}function II(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ws.ROTATE:if(this.enableRotate===!1){this.state=Nt.NONE;break}this._handleTouchStartRotate(n),this.state=Nt.TOUCH_ROTATE;break;case Ws.PAN:if(this.enablePan===!1){this.state=Nt.NONE;break}this._handleTouchStartPan(n),this.state=Nt.TOUCH_PAN;break;default:this.state=Nt.NONE}break;case 2:switch(this.touches.TWO){case Ws.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Nt.TOUCH_DOLLY_PAN;break;case Ws.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Nt.TOUCH_DOLLY_ROTATE;break;default:this.state=Nt.NONE}break;default:this.state=Nt.NONE}this.state!==Nt.NONE&&this.dispatchEvent(zm)}function LI(n){switch(this._trackPointer(n),this.state){case Nt.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Nt.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Nt.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Nt.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Nt.NONE}}function DI(n){this.enabled!==!1&&n.preventDefault()}function NI(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function UI(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var FI=`
attribute vec3 real;
attribute vec3 imag;
attribute vec3 origin;
attribute vec2 turn;
uniform vec2 phase;
uniform float swing;
varying vec3 seen;
varying float amount;
void main() {
  vec3 first = real * turn.x - imag * turn.y;
  vec3 second = real * turn.y + imag * turn.x;
  amount = sqrt(dot(real, real) + dot(imag, imag));
  vec3 moved = position + origin + swing * (first * phase.x - second * phase.y);
  vec4 place = modelViewMatrix * vec4(moved, 1.0);
  seen = place.xyz;
  gl_Position = projectionMatrix * place;
}`,OI=`
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`,kI=`
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`,BI={oblique:[.45,-.8,.45],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},Mf=class{constructor(e,t,i){this.data=e;this.canvas=t;this.renderer=new vf({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),this.vectors=e.header.extra.lattice_vectors,this.period=Math.hypot(...this.vectors[0]);let r=Float32Array.from(e.values("skin_position"),u=>u/this.period),s={position:new ci(r,3),real:new ci(new Float32Array(r.length),3),imag:new ci(new Float32Array(r.length),3)};for(let u of[this.surface,this.edges])for(let[d,f]of Object.entries(s))u.setAttribute(d,f);this.surface.setIndex(VI(e.values("skin_face"))),this.edges.setIndex(Array.from(e.values("skin_edge"))),this.box.setFromBufferAttribute(s.position);let o=new bo(Uint8Array.from(i.flatMap(([u=0,d=0,f=0])=>[u,d,f,255])),i.length,1);o.minFilter=o.magFilter=$n,o.needsUpdate=!0,this.uniforms.scale.value=o;let a={uniforms:this.uniforms,vertexShader:FI},l=new qi(this.surface,new Ni({...a,fragmentShader:OI,side:Xi,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),c=new ec(this.edges,new Ni({...a,fragmentShader:kI}));for(let u of[l,c])u.frustumCulled=!1,this.scene.add(u);this.camera.up.set(0,0,1),this.controls=new Sf(this.camera,t),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.colourLines()}data;canvas;renderer;scene=new Jl;camera=new li(28,1,.01,100);controls;uniforms={phase:{value:new nt(1,0)},swing:{value:.15},scale:{value:new bo(new Uint8Array(4),1,1)},ink:{value:new Mt(0,0,0)}};surface=new Va;edges=new Va;period;vectors;box=new Nr;copies=[1,1];kappa=[0,0];frames=0;turns=[];show({row:e,band:t},i){let[,r=0,s=0]=this.data.shape("path_mode_real"),o=(e*r+t)*s,a=this.data.values("path_shape");for(let l of["real","imag"]){let c=`path_mode_${l}`,u=this.data.values(c).subarray(o,o+s),d=this.data.scale(c)*this.data.scale("path_shape"),f=this.surface.getAttribute(l);zI(f.array,a,u,d),f.needsUpdate=!0}this.kappa=i,this.place()}repeat(e){this.copies=e,this.place(),this.look("oblique")}set swing(e){this.uniforms.swing.value=e}turn(e){this.uniforms.phase.value.set(Math.cos(2*Math.PI*e),Math.sin(2*Math.PI*e)),this.draw()}draw(){this.frames++,this.renderer.render(this.scene,this.camera)}look(e){let[t,i]=this.copies,r=this.box.clone();for(let[c,u]of[[t-1,0],[0,i-1],[t-1,i-1]])r.union(this.box.clone().translate(this.shift(c,u)));let s=r.getBoundingSphere(new rs),o=this.camera.fov*Math.PI/360,a=Math.atan(Math.tan(o)*Math.min(1,this.camera.aspect)),l=1.08*s.radius/Math.sin(a);this.controls.target.copy(s.center),this.camera.position.set(...BI[e]).normalize().multiplyScalar(l).add(s.center),this.camera.near=.01*l,this.camera.far=10*l,this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}resize(e,t){this.renderer.setPixelRatio(devicePixelRatio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix()}colourLines(){this.uniforms.ink.value.set(ze("ink"))}dispose(){this.controls.dispose(),this.surface.dispose(),this.edges.dispose(),this.uniforms.scale.value.dispose(),this.renderer.dispose()}shift(e,t){let[[i,r],[s,o]]=this.vectors;return new K((e*i+t*s)/this.period,(e*r+t*o)/this.period,0)}place(){let[e,t]=this.copies,i=[],r=[];for(let s=0;s<e;s++)for(let o=0;o<t;o++){let a=s*this.kappa[0]+o*this.kappa[1];i.push(...this.shift(s,o).toArray()),r.push(Math.cos(a),Math.sin(a))}this.turns=r;for(let s of[this.surface,this.edges])s.instanceCount=e*t,s.setAttribute("origin",new Ba(Float32Array.from(i),3)),s.setAttribute("turn",new Ba(Float32Array.from(r),2))}};function zI(n,e,t,i){n.fill(0);for(let r=0;r<t.length;r++){let s=(t[r]??0)*i;if(s===0)continue;let o=r*n.length;for(let a=0;a<n.length;a++)n[a]+=s*e[o+a]}}function VI(n){let e=[];for(let t=0;t<n.length;t+=4){let[i,r,s,o]=n.subarray(t,t+4);e.push(i,r,s,i,s,o)}return e}var GI=[["oblique","oblique"],["x","along x"],["y","along y"],["z","from above"]];function Cx({diagram:n,choice:e}){let t=lt(null),i=lt(null),[r,s]=Lt("");return Ut(()=>{if(t.current===null)return;let o;try{o=new Mf(n.data,t.current,Rx(n))}catch{s("The mode cannot be drawn, because this browser has no WebGL.");return}return i.current=o,Object.assign(t.current,{moving:o}),WI(o,n,e)},[n,e]),h("div",{class:"mode",children:[r?h("p",{role:"alert",children:r}):h("canvas",{ref:t,role:"img","aria-label":"The cell moving in the selected mode"}),h("p",{class:"scale",children:[h("span",{children:"0"}),h("span",{class:"bar",style:{background:HI(n)}}),h("span",{children:"1"})," displacement, relative to the largest"]}),h("p",{class:"sides",children:[h("span",{id:"seen",children:"Seen"}),GI.map(([o,a])=>h("button",{type:"button",onClick:()=>i.current?.look(o),"aria-describedby":"seen",children:a}))]}),h(ya,{canvas:t,name:"mode",caption:`${n.data.header.title}, ${oo(n.data)}`})]})}function Rx(n){return n.data.header.extra.colours}function HI(n){return`linear-gradient(to right, ${Rx(n).map(e=>`rgb(${e.join(" ")})`).join(", ")})`}function WI(n,e,t){let{canvas:i}=n,r=()=>n.turn(s.moment),s=new Ps(t,r);va(i,l=>s.at(l));let o=new ResizeObserver(()=>{n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1)),n.look("oblique")});n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1));let a=[et(()=>n.repeat(t.copies.value)),et(()=>{let l=t.point.value;n.show(l,e.phases(l.row)),i.dataset.shown=`${l.row},${l.band}`,r()}),et(()=>{n.swing=t.swing.value,r()}),Zn(()=>{n.colourLines(),n.draw()})];return o.observe(i),()=>{s.end(),o.disconnect();for(let l of a)l();n.dispose()}}function Px({diagram:n,unit:e}){let{factor:t}=e;return n.gaps.length===0?h("p",{children:"The computed bands have no gap."}):h("div",{class:"wide",children:h("table",{children:[h("caption",{children:"Gaps"}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"bands"}),h("th",{scope:"col",children:"where"}),h("th",{scope:"col",children:In("lower",e)}),h("th",{scope:"col",children:In("upper",e)})]})}),h("tbody",{children:n.gaps.map(i=>h("tr",{children:[h("td",{children:[i.waves==="all"?"":`${i.waves} `,i.below,"-",i.below+1]}),h("td",{children:i.complete?"everywhere (complete)":i.waves==="all"?`${i.direction} only`:"everywhere, these waves only"}),h("td",{children:Hn(i.lower/t,i.lowerError/t)}),h("td",{children:Hn(i.upper/t,i.upperError/t)})]}))})]})})}function Ix({diagram:n,choice:e}){let{row:t,band:i}=e.point.value,r=e.unit.value,{factor:s}=r,o=Array.from({length:n.bands},(a,l)=>({row:t,band:l}));return h("div",{class:"wide",children:h("table",{children:[h("caption",{children:["Modes at ",n.place(t)]}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"band"}),h("th",{scope:"col",children:In("frequency",r)}),h("th",{scope:"col",children:"motion"}),h("th",{scope:"col",children:"symmetry"}),h("th",{scope:"col",children:"show"})]})}),h("tbody",{children:o.map(a=>h("tr",{"aria-current":a.band===i?"true":void 0,children:[h("td",{children:a.band+1}),h("td",{children:Hn(n.at(a)/s,n.errorAt(a)/s)}),h("td",{children:n.nature(a)}),h("td",{children:n.parity(a)}),h("td",{children:h("button",{type:"button",onClick:()=>e.point.value=a,children:["band ",a.band+1]})})]}))})]})})}var qI=[1,2,5,10],XI=.7,wf=class{constructor(e){this.data=e;this.places=e.values("zone_wavevector"),this.samples=e.values("zone_sample"),this.frequency=e.values("zone_frequency"),this.error=e.values("zone_error"),[,this.bands=0]=e.shape("zone_frequency");let t=Array.from(e.values("zone_mesh"));this.triangles=Array.from({length:t.length/3},(i,r)=>t.slice(3*r,3*r+3)),this.corners=e.header.extra.zone,this.colours=e.header.extra.colours,this.reach=Math.max(...Array.from(this.places,Math.abs))}data;bands;triangles;corners;colours;reach;places;samples;frequency;error;wavevector(e){return[this.places[2*e]??NaN,this.places[2*e+1]??NaN]}sample(e){return this.samples[e]??0}phases(e){let t=this.data.values("zone_kappa");return[t[2*e]??NaN,t[2*e+1]??NaN]}at(e,t){return this.frequency[e*this.bands+t]??NaN}errorAt(e,t){return this.error[e*this.bands+t]??NaN}mean(e,t){return e.reduce((i,r)=>i+this.at(this.sample(r),t),0)/3}range(e){let t=Array.from({length:this.frequency.length/this.bands},(i,r)=>this.at(r,e));return[Math.min(...t),Math.max(...t)]}highest(e){return this.all.reduce((t,i)=>this.at(this.sample(i),e)>this.at(this.sample(t),e)?i:t,0)}nearest([e,t]){let i=r=>Math.hypot(this.wavevector(r)[0]-e,this.wavevector(r)[1]-t);return this.all.reduce((r,s)=>i(s)<i(r)?s:r,0)}next(e,t,i){let[r,s]=this.wavevector(e),[o,a]=[e,1/0];for(let l of this.all){let[c,u]=[this.wavevector(l)[0]-r,this.wavevector(l)[1]-s],d=Math.hypot(c,u),f=(c*t+u*i)/d;d>1e-9*this.reach&&f>XI&&d/f**2<a&&([o,a]=[l,d/f**2])}return o}contour(e,t){let i=[];for(let r of this.triangles){let s=[];r.forEach((o,a)=>{let l=r[(a+1)%3]??0,[c,u]=[this.at(this.sample(o),e),this.at(this.sample(l),e)];if(c<t==u<t)return;let d=(t-c)/(u-c),[f,p]=[this.wavevector(o),this.wavevector(l)];s.push([f[0]+d*(p[0]-f[0]),f[1]+d*(p[1]-f[1])])}),s[0]&&s[1]&&i.push([s[0],s[1]])}return i}get all(){return Array.from(this.samples,(e,t)=>t)}};function Vm(n,e,t){if(!(e>n))return[];let i=10**Math.floor(Math.log10((e-n)/t)),r=i*(qI.find(o=>o*i*t>=e-n)??10),s=Math.ceil(n/r);return Array.from({length:Math.floor(e/r)-s+1},(o,a)=>(s+a)*r)}var Lx=440,$I=26,Dx=8;function Nx({diagram:n,choice:e}){return n.data.has("zone_wavevector")?h(YI,{diagram:n,choice:e}):null}function YI({diagram:n,choice:e}){let t=gt(()=>new wf(n.data),[n]),i=gt(()=>Qc(Number(n.data.header.attrs.pitch_m)),[n]),r=gt(()=>({image:pe(t.highest(e.point.peek().band)),wavevectorUnit:pe(i[1])}),[t,i,e]),s=gt(()=>KI(t,r),[t,r]),{band:o}=e.point.value;return h("section",{"aria-label":"Brillouin zone",class:"pair",children:[h("div",{children:[h(pi,{label:"Brillouin zone. Arrow keys move the wavevector.",describedBy:"zone-point",onKeyDown:a=>{wr(a,s),a.defaultPrevented&&a.stopPropagation()},children:h(ZI,{zone:t,band:o,own:r})}),h("p",{class:"axes",children:[h("label",{children:["Band"," ",h("select",{value:o+1,onChange:({currentTarget:a})=>e.point.value={...e.point.value,band:a.selectedIndex},children:Array.from({length:n.bands},(a,l)=>h("option",{children:l+1}))})]}),h(er,{title:"Wavevectors in",units:i,unit:r.wavevectorUnit})]}),h(QI,{zone:t,diagram:n,band:o,unit:e.unit.value})]}),h(eL,{zone:t,own:r,band:o,unit:e.unit.value})]})}function KI(n,e){let t=(i,r)=>()=>e.image.value=n.next(e.image.value,i,r);return[{keys:"arrows",effect:"next wavevector",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}}]}function ZI({zone:n,band:e,own:t}){let i=lt(null),r=t.image.value,s=()=>{i.current!==null&&JI(i.current,n,e,r)};Qi(s),Ut(()=>{let a=i.current?.parentElement;if(!a)return;let l=new ResizeObserver(()=>o.current());l.observe(a);let c=Zn(()=>o.current());return()=>{l.disconnect(),c()}},[]);let o=lt(s);return o.current=s,h("div",{class:"map zone",children:h("canvas",{ref:i,role:"img","aria-label":`Frequency of band ${e+1} over the zone`,onClick:({offsetX:a,offsetY:l,currentTarget:c})=>{let{toWavevector:u}=Ux(c,n);t.image.value=n.nearest(u(a,l))}})})}function Ux(n,e){let t=n.clientWidth,i=(t-2*$I)/(2*e.reach);return{toPixel:([r,s])=>[t/2+i*r,t/2-i*s],toWavevector:(r,s)=>[(r-t/2)/i,(t/2-s)/i]}}function JI(n,e,t,i){let r=Math.min(n.parentElement?.clientWidth??Lx,Lx);n.style.width=n.style.height=`${r}px`,n.width=n.height=Math.round(r*devicePixelRatio);let s=n.getContext("2d");if(s===null)return;s.scale(devicePixelRatio,devicePixelRatio);let{toPixel:o}=Ux(n,e),[a,l]=e.range(t);for(let c of e.triangles){let u=e.colours[Math.round((e.mean(c,t)-a)/(l-a||1)*(e.colours.length-1))];s.fillStyle=s.strokeStyle=`rgb(${(u??[]).join(" ")})`,s.beginPath();for(let d of c)s.lineTo(...o(e.wavevector(d)));s.closePath(),s.fill(),s.stroke()}s.strokeStyle="#ffffff",s.lineWidth=1,s.beginPath();for(let c of Vm(a,l,Dx))for(let[u,d]of e.contour(t,c))s.moveTo(...o(u)),s.lineTo(...o(d));s.stroke(),jI(s,e,o),s.beginPath(),s.arc(...o(e.wavevector(i)),5,0,2*Math.PI),s.fillStyle=ze("accent"),s.strokeStyle="#ffffff",s.lineWidth=2,s.fill(),s.stroke(),n.dataset.shown=`${i},${t}`,Object.assign(n,{zone:e})}function jI(n,e,t){n.strokeStyle=ze("carrier"),n.setLineDash([5,4]),n.lineWidth=1.5,n.beginPath();for(let s of Object.values(e.corners))n.lineTo(...t(s));n.closePath(),n.stroke(),n.setLineDash([]),n.font="15px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.lineWidth=3,n.strokeStyle=ze("paper"),n.fillStyle=ze("ink");let i=Object.values(e.corners),r=[0,1].map(s=>i.reduce((o,a)=>o+(a[s]??0),0)/i.length);for(let[s,o]of Object.entries(e.corners)){let[a,l]=t(o),[c,u]=[Math.sign(o[0]-(r[0]??0)),Math.sign(o[1]-(r[1]??0))];n.strokeText(s,a+13*c,l-13*u),n.fillText(s,a+13*c,l-13*u)}}function QI({zone:n,diagram:e,band:t,unit:i}){let[r,s]=n.range(t).map(u=>Ar(Number((u/i.factor).toPrecision(4)))),a=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(u=>`rgb(${(n.colours[u]??[]).join(" ")})`),l=Vm(...n.range(t),Dx),c=((l[1]??0)-(l[0]??0))/i.factor;return h("p",{class:"scale",children:[h("span",{children:r}),h("span",{class:"bar",style:{background:`linear-gradient(to right, ${a.join(", ")})`}}),h("span",{children:s})," ",In("frequency",i)," of band ",t+1," of ",e.bands,l.length>1&&`; contours every ${Number(c.toPrecision(4))}`]})}function eL({zone:n,own:e,band:t,unit:i}){let[r,s]=[e.image.value,e.wavevectorUnit.value],[o,a]=n.wavevector(r).map(f=>Number((f/s.factor).toFixed(3))),l=n.sample(r),c=f=>Hn(n.at(l,f)/i.factor,n.errorAt(l,f)/i.factor),[u,d]=n.phases(l).map(f=>Number((f/Math.PI).toFixed(4)));return h("div",{class:"facts",children:[h("p",{id:"zone-point","aria-live":"polite",children:["Band ",t+1," at (",o,", ",a,") ",s.name,": ",h("b",{children:oi(c(t),i)})]}),h("div",{class:"wide",children:h("table",{children:[h("caption",{children:"Frequencies at this wavevector"}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"band"}),h("th",{scope:"col",children:In("frequency",i)})]})}),h("tbody",{children:Array.from({length:n.bands},(f,p)=>h("tr",{"aria-current":p===t?"true":void 0,children:[h("td",{children:p+1}),h("td",{children:c(p)})]}))})]})}),h("p",{class:"again",children:["Its modes as a picture: ",h("code",{children:['haptonic bands STUDY --modes-at "',u,", ",d,'"']})]})]})}function Ox(n,e){return h(nL,{data:n,host:e})}var tL="Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of the model.";function nL({data:n,host:e}){let t=gt(()=>new gu(n),[n]),i=gt(()=>hv(t),[t.rows,t.bands]),r=gt(()=>gv(e?.turned),[e]),s=()=>{let m=r.layer.peek()??_v(t);i.held.value!==null?i.held.value=null:!m.isPreview&&!r.isWaiting.peek()&&(i.held.value={layer:m,gaps:m.gaps,carrier:t.carrier,design:e?.design()??{}})},o=gt(()=>mv(t,i,e&&s),[t,i,e]),a=r.layer.value,l=r.isWaiting.value?"earlier design":a?.isPreview?"preview":"certified",c=r.isWaiting.value||a!==null,u=i.held.value,{carrier:d}=t,f=t.units.find(({name:m})=>m===i.unit.value.name)??i.unit.value,p=(a??t).gaps;return h(tr,{name:"bands",data:n,keys:o,foot:tL,isOld:c,children:[h("div",{class:"insight",children:[e?.controls,h("span",{class:`kind ${l}`,children:l}),e&&h("button",{type:"button",class:"minor","aria-label":"Hold this design","aria-pressed":u!==null,disabled:l!=="certified"&&u===null,onClick:s,children:"Hold"}),l==="earlier design"?h("p",{children:[e?.turned.value?.data?"Too far for a preview.":"No preview yet."," Certified curves follow."]}):h(cv,{gaps:p,carrier:d,unit:f})]}),h("div",{class:"pair",children:[h("section",{"aria-label":"Band diagram",children:[h(pi,{label:"Band diagram. Arrow keys move along the path and between bands.",children:h(rv,{diagram:t,choice:i,newer:r})}),h("p",{class:"axes",children:[h(er,{title:"Frequencies in",units:t.units,unit:i.unit}),h(iL,{diagram:t,isPreview:l==="preview",isHeld:u!==null})]}),u!==null&&e&&l!=="earlier design"&&h(uv,{held:u,now:{gaps:p,carrier:d,design:e.design()},unit:f,isPreview:l==="preview",drop:s})]}),h("section",{"aria-label":"Mode",children:[h(Cx,{diagram:t,choice:i}),h(rL,{diagram:t,choice:i,isOld:c}),h(sL,{choice:i})]})]}),h(Nx,{diagram:t,choice:i}),h(Er,{listing:i.listing,keys:o,children:[h(Px,{diagram:t,unit:i.unit.value}),h(Ix,{diagram:t,choice:i})]})]})}function iL({diagram:n,isPreview:e,isHeld:t}){return h("span",{class:"legend",children:[n.gaps.some(i=>i.complete)&&h("span",{class:"of-gap",children:"complete gap"}),n.gaps.some(i=>i.waves!=="all")&&h("span",{class:"of-parity",children:"gap of one parity"}),n.carrier!==void 0&&h("span",{class:"of-carrier",children:"carrier"}),e&&h("span",{class:"of-preview",children:"preview with its error"}),t&&h("span",{class:"of-held",children:"held design"})]})}function rL({diagram:n,choice:e,isOld:t}){let i=e.point.value,r=e.unit.value,s=n.velocity(i),o=[["motion",n.nature(i)],["symmetry",n.parity(i)],["group velocity",s?`${Math.hypot(...s).toPrecision(3)} m/s`:"not defined"]],a=n.place(i.row);return h("div",{class:"facts",children:[h("p",{id:"point","aria-live":"polite",children:["Band ",i.band+1," at ",a,t&&", earlier design",": ",h("b",{children:oi(Hn(n.at(i)/r.factor,n.errorAt(i)/r.factor),r)})]}),h(ws,{facts:o}),h("p",{class:"again",children:["The same mode as a picture: ",h("code",{children:['haptonic bands STUDY --modes-at "',a,'"']})," or, in Python,"," ",h("code",{children:['study.bands(modes_at="',a,'").plot("modes")']})]})]})}function sL({choice:n}){let[e,t]=n.copies.value;return h("div",{class:"controls",children:[h(ea,{playing:n.playing}),h("label",{children:["largest displacement, share of the period: ",n.swing.value.toFixed(2),h("input",{type:"range",min:"0",max:vu,step:"0.01",value:n.swing.value,onInput:i=>n.swing.value=Number(i.currentTarget.value)})]}),h(ta,{pace:n.pace}),h("label",{children:["cells along a1",h("input",{type:"number",min:"1",max:_u,value:e,onChange:i=>n.copies.value=[Fx(i.currentTarget.value),t]})]}),h("label",{children:["cells along a2",h("input",{type:"number",min:"1",max:_u,value:t,onChange:i=>n.copies.value=[e,Fx(i.currentTarget.value)]})]})]})}function Fx(n){let e=Math.round(Number(n));return Number.isFinite(e)?Math.min(Math.max(e,1),_u):1}var oL=250,kx=1e6,aL=["low","high","value"];function Bx({data:n,finger:e}){let t=lt(null);return Qi(()=>{if(t.current!==null)return lL(t.current,n,e)},[n,e]),h(Ct,{children:[h("div",{class:"curves",ref:t}),h("p",{class:"legend",children:[h("span",{class:"of-curve",children:[h("svg",{width:"34",height:"8","aria-hidden":"true",children:h("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:"var(--curve-0)"})})," ","model"]}),h("span",{class:"of-gap",children:"its interval"}),h("span",{class:"of-carrier",children:"people notice less than this"})]})]})}function lL(n,e,t){let i=Array.from(e.amplitudes,c=>c*kx),r=()=>[i,...aL.map(c=>Array.from(t.law.value[c]))],s={stroke:()=>ze("ink"),ticks:{stroke:()=>ze("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},o=()=>({width:Rr(n),height:oL}),a={width:0,points:{show:!1}},l=new jt({...o(),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,distr:3},y:{range:[0,1.02]}},bands:[{series:[2,1],fill:()=>ze("gap")}],axes:[{...s,label:`${e.data.title("table")} / µm`,labelSize:22,size:34,values:(c,u)=>u.map(d=>Number.isInteger(Math.round(1e6*Math.log10(d))/1e6)?String(d):"")},{...s,label:e.data.title("load_sharing"),labelSize:24,size:50}],series:[{},a,a,{stroke:()=>ze("curve-0"),width:2,points:{show:!1}}],hooks:{draw:[c=>cL(c,e,t)]}},r(),n);return Pr(l,n,o,[et(()=>l.setData(r())),et(()=>{t.below.value,l.redraw(!1,!1)})])}function cL(n,e,t){let{ctx:i,bbox:r,valToPos:s}=n,{amplitude:o,friction:a}=t.below.peek(),[l,c]=[s(Math.max(o.value*kx,.001),"x",!0),s(a.value,"y",!0)];da(n,1-e.extra.weber,"carrier",[7,5]),pa(i,[l,r.top],[l,r.top+r.height],"accent"),i.save(),i.fillStyle=ze("accent"),i.beginPath(),i.arc(l,c,5*devicePixelRatio,0,2*Math.PI),i.fill(),i.restore()}var zx=["value","low","high"],Tf=class{constructor(e){this.data=e;this.extra=e.header.extra,this.forces=e.values("force"),this.speeds=e.values("speed"),this.amplitudes=e.values("table"),this.x=e.values("x"),this.y=e.values("y"),this.columns=[...new Set(this.x)].sort((r,s)=>r-s),this.rows=[...new Set(this.y)].sort((r,s)=>r-s),this.cells=new Int32Array(this.columns.length*this.rows.length).fill(-1);let[t,i]=[this.columns,this.rows].map(r=>new Map(r.map((s,o)=>[s,o])));this.x.forEach((r,s)=>{this.cells[(i?.get(this.y[s]??0)??0)*this.columns.length+(t?.get(r)??0)]=s})}data;extra;forces;speeds;amplitudes;x;y;columns;rows;cells;get count(){return this.x.length}placeIn(e,t){if(t<0||t>=this.columns.length)return null;let i=this.cells[e*this.columns.length+t]??-1;return i<0?null:i}nearest([e,t]){let[i,r]=[0,1/0];for(let s=0;s<this.count;s++){let o=((this.x[s]??0)-e)**2+((this.y[s]??0)-t)**2;o<r&&([i,r]=[s,o])}return i}beside(e,t,i){let[r,s]=[this.rows.indexOf(this.y[e]??0),this.columns.indexOf(this.x[e]??0)];return this.placeIn(r+i,s+t)??e}region(e){return this.data.texts("region")[e]||"a lattice"}amplitude(e,t,i){let r=this.data.texts("load").indexOf(t);return i*(this.data.values("amplitude")[r*this.count+e]??0)}law(e,t){let i=this.amplitudes.length,r=this.data.texts("end"),s=(c,u)=>{let d=this.data.values(c);return f=>{let p=(u*r.length+r.indexOf(f))*i;return d.subarray(p,p+i)}},[o,a]=[s("load_sharing",e),s("intermittent",t)],l=(c,u)=>{let[d,f]=[o(c),a(c)];return Float64Array.from(d,(p,m)=>Number.isNaN(p)?f[m]??NaN:u(p,f[m]??NaN))};return{value:l("value",c=>c),low:l("low",Math.min),high:l("high",Math.max)}}friction(e,t){let[i=1,r=1]=[this.amplitudes[0],this.amplitudes.at(-1)],s=e.length-1,o=Math.log(Math.max(t,i)/i)/Math.log(r/i)*s,a=Math.min(Math.floor(o),s-1),l=Math.min(o-a,1);return(e[a]??NaN)*(1-l)+(e[a+1]??NaN)*l}};function Vx(n,e){return n.low>e?"noticed, also at the lower limit":n.value>e?"probably noticed; the lower limit is below the threshold":n.high>e?"probably not noticed; the upper limit is above the threshold":"not noticed, even at the upper limit"}var xc="#1c2126",Gx={ink:xc,rim:"#ffffff"};function Ef(n,e,t,i=()=>!0){n.beginPath();for(let{outline:r,places:s}of e)for(let o of s)i(o)&&bc(n,r.map(([a,l])=>[o[0]+a,o[1]+l]),t)}function Af(n,e,t){n.save(),n.strokeStyle=ze("carrier"),n.lineWidth=4*devicePixelRatio;for(let{hold:i,ends:r}of e)n.setLineDash(i==="clamped"?[]:[5*devicePixelRatio,3*devicePixelRatio]),n.beginPath(),bc(n,r,t),n.stroke();n.restore()}function bc(n,e,t){e.forEach((i,r)=>r===0?n.moveTo(...t(i)):n.lineTo(...t(i))),n.closePath()}function Br(n,e,t){n.beginPath(),bc(n,e,t),n.stroke()}function $s([n,e],[t,i]){let[r,s]=[t/2,i/2];return[[n-r,e-s],[n+r,e-s],[n+r,e+s],[n-r,e+s]]}function Ja(n,e,t,i,r=Gx){let o=t.flatMap(f=>f.map((p,m)=>[i(p),i(f[(m+1)%f.length]??p)])).filter(([f,p])=>Math.abs(f[1]-p[1])<1),a=Math.min(...o.map(([f])=>f[1])),l=([f,p])=>Math.abs(f[0]-p[0]),[c]=o.filter(([f])=>f[1]<a+1).sort((f,p)=>l(p)-l(f));if(c===void 0)return;let[u,d]=c;Gm(n,e,[(u[0]+d[0])/2,a+17*devicePixelRatio],r)}function Gm(n,e,[t,i],r=Gx){n.save(),n.font=`${13*devicePixelRatio}px system-ui, sans-serif`,n.textAlign="center",n.lineWidth=3*devicePixelRatio,n.strokeStyle=r.rim,n.fillStyle=r.ink;let s=n.measureText(e).width/2,o=Math.min(Math.max(t,s),n.canvas.width-s);n.strokeText(e,o,i),n.fillText(e,o,i),n.restore()}var Ys=class n{constructor(e,t,i,r){this.canvas=e;this.context=t;this.small=i;this.inner=r;this.image=new ImageData(i.width,i.height)}canvas;context;small;inner;image;static on(e,t,i){let r=new OffscreenCanvas(t,i),[s,o]=[e.getContext("2d"),r.getContext("2d")];return s===null||o===null?null:new n(e,s,r,o)}show(e){let{canvas:t,context:i}=this;this.inner.putImageData(this.image,0,0),i.clearRect(0,0,t.width,t.height),i.imageSmoothingEnabled=e,i.imageSmoothingQuality="high",i.drawImage(this.small,0,0,t.width,t.height)}follow(e,t){let{canvas:i}=this,r=()=>{let o=Math.min(i.parentElement?.clientWidth??300,.62*innerHeight/e);i.style.width=`${o}px`,i.style.height=`${o*e}px`,i.width=Math.round(o*devicePixelRatio),i.height=Math.round(o*e*devicePixelRatio),t()},s=new ResizeObserver(r);return i.parentElement!==null&&s.observe(i.parentElement),()=>s.disconnect()}};function Hx({data:n,finger:e}){let t=lt(null);Ut(()=>{if(t.current!==null)return uL(t.current,n,e)},[n,e]);let{colours:i}=n.extra,r=[0,.25,.5,.75,1].map(s=>`rgb(${(i[Math.round(s*(i.length-1))]??[]).join(" ")})`);return h("div",{class:"map",children:[h("canvas",{ref:t,role:"img","aria-label":"Map of the reduction of friction"}),h("p",{class:"scale",children:[h("span",{children:"0"}),h("span",{class:"bar",style:{background:`linear-gradient(to right, ${r.join(", ")})`}}),h("span",{children:"100 %"})," less friction below a finger with its middle there, model"]})]})}function uL(n,e,t){let[i,r]=[e.columns,e.rows],s=Ys.on(n,i.length,r.length);if(s===null)return()=>{};let{image:o,context:a}=s,[l,c]=[i,r].map(m=>hL(m)),u=([m,x])=>[n.width*(m-l[0])/(l[1]-l[0]),n.height*(c[1]-x)/(c[1]-c[0])],d=()=>{let{colours:m}=e.extra,[x,_]=[t.law.peek(),t.drive.peek()];r.forEach((g,b)=>i.forEach((A,S)=>{let P=e.placeIn(b,S),C=4*((r.length-1-b)*i.length+S);if(o.data[C+3]=P===null?0:255,P===null)return;let v=1-e.friction(x.value,e.amplitude(P,"value",_));(m[Math.round(Math.min(Math.max(v,0),1)*(m.length-1))]??[]).forEach((k,N)=>o.data[C+N]=k)}))},f=()=>{s.show(!1),fL(a,e,u),dL(a,e,t.place.peek(),u),n.dataset.shown=String(t.place.peek())},p=[s.follow((c[1]-c[0])/(l[1]-l[0]),f),et(()=>{t.law.value,t.drive.value,d(),f()}),et(()=>{t.place.value,f()}),Zn(f),pL(n,([m,x])=>{let _=[l[0]+m*(l[1]-l[0]),c[1]-x*(c[1]-c[0])];t.place.value=e.nearest(_)})];return()=>{for(let m of p)m()}}function hL(n){let[e=0,t=e+.001]=n,i=(t-e)/2;return[e-i,(n.at(-1)??0)+i]}function fL(n,{extra:e},t){n.lineWidth=1.2*devicePixelRatio,n.strokeStyle="#ffffff";for(let i of Object.values(e.regions).flat())Br(n,i,t);n.strokeStyle=ze("quiet");for(let i of e.plate)Br(n,i,t);n.strokeStyle="#ffffff",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[i,r,s,o]of Object.values(e.patches))Br(n,$s([i,r],[s,o]),t);n.setLineDash([]);for(let[i,r]of Object.entries(e.regions))Ja(n,i,r,t)}function dL(n,e,t,i){let r=[e.x[t]??0,e.y[t]??0],[s,o]=i(r),a=i([r[0]+e.extra.diameter/2,r[1]])[0]-s;for(let[l,c]of[["#ffffff",5],[xc,2]])n.strokeStyle=l,n.lineWidth=c*devicePixelRatio,n.beginPath(),n.arc(s,o,a,0,2*Math.PI),n.moveTo(s-4*devicePixelRatio,o),n.lineTo(s+4*devicePixelRatio,o),n.moveTo(s,o-4*devicePixelRatio),n.lineTo(s,o+4*devicePixelRatio),n.stroke()}function pL(n,e){let t=i=>{if(i.type==="pointerdown")n.setPointerCapture(i.pointerId);else if(i.buttons===0)return;let r=n.getBoundingClientRect();e([(i.clientX-r.left)/r.width,(i.clientY-r.top)/r.height])};return n.addEventListener("pointerdown",t),n.addEventListener("pointermove",t),()=>{n.removeEventListener("pointerdown",t),n.removeEventListener("pointermove",t)}}var mL=5,Wx=1.05;function qx(n){let{drive:e,force:t,speed:i}=n.extra,r=pe(gL(n)),s={drive:pe(e.value),force:pe(n.forces.indexOf(t)),speed:pe(n.speeds.indexOf(i))};s.force.peek()<0&&(s.force.value=0);let o=xt(()=>n.law(s.force.value,s.speed.value)),a=xt(()=>_L(n,o.value,r.value,s.drive.value));return{place:r,...s,listing:pe("none"),law:o,below:a}}function gL(n){let e=n.extra.diameter/2,t=(s,o)=>s-e>=(o[0]??0)&&s+e<=(o.at(-1)??0),[i,r]=[0,-1];for(let s=0;s<n.count;s++){let o=n.amplitude(s,"value",1),a=t(n.x[s]??0,n.columns)&&t(n.y[s]??0,n.rows);o>r&&a&&([i,r]=[s,o])}return i}function _L(n,e,t,i){let r=a=>Object.fromEntries(zx.map(l=>[l,a(l)])),s=r(a=>n.amplitude(t,a,i)),o=r(a=>n.friction(e[a],s[a]));return{amplitude:s,free:n.amplitude(t,"free",i),friction:o,reduction:{value:1-o.value,low:1-o.high,high:1-o.low}}}function Xx(n,e){let t=(c,u)=>d=>{for(let f=0;f<(d.shiftKey?mL:1);f++)e.place.value=n.beside(e.place.peek(),c,u)},{low:i,high:r}=n.extra.drive,s=c=>()=>e.drive.value=Math.min(Math.max(e.drive.peek()*c,i),r),o=(c,u,d)=>()=>c.value=Math.min(Math.max(c.peek()+u,0),d-1),[a,l]=[n.forces.length,n.speeds.length];return[{keys:"← → ↑ ↓",effect:"move the finger; five places with Shift",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}},{keys:"+ −",effect:"5 % more or less drive",actions:{"+":s(Wx),"-":s(1/Wx)}},{keys:"f F",effect:"more or less force",actions:{f:o(e.force,1,a),F:o(e.force,-1,a)}},{keys:"s S",effect:"faster or slower",actions:{s:o(e.speed,1,l),S:o(e.speed,-1,l)}},...Tr(e.listing)]}function $x({plate:n,choice:e}){let t=lt(null);Ut(()=>{if(t.current!==null)return vL(t.current,n,e)},[n,e]);let r=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(s=>`rgb(${(n.colours[s]??[]).join(" ")})`);return h("div",{class:"map",children:[h("canvas",{ref:t,role:"img","aria-label":"Map of the moving plate"}),h("p",{class:"scale",children:[h("span",{children:`−${Co(n.largest(e.line.value))}`}),h("span",{class:"bar",style:{background:`linear-gradient(to right, ${r.join(", ")})`}}),h("span",{children:Co(n.largest(e.line.value))})," normal displacement",n.drive]}),h(ya,{canvas:t,name:"map",caption:`${n.data.header.title}, ${oo(n.data)}`})]})}function Co(n){let[e,t]=n>=1e-6?["µm",1e6]:n>=1e-9?["nm",1e9]:["pm",1e12];return`${Number((n*Number(t)).toPrecision(3))} ${e}`}function vL(n,e,t){let{left:i,right:r,bottom:s,top:o}=e.extent,a=Ys.on(n,e.columns,e.rows);if(a===null)return()=>{};let l={frames:0},c=()=>{let f=t.line.peek();l.frames++,e.paint(a.image,f,e.outermost(f)+u.moment),a.show(!0);let p=([m,x])=>[n.width*(m-i)/(r-i),n.height*(o-x)/(o-s)];yL(a.context,e,p,t.plan.peek()),n.dataset.shown=String(f)},u=new Ps(t,c);va(n,f=>u.at(f)),Object.assign(n,{counted:l});let d=[a.follow((o-s)/(r-i),c),et(()=>{t.line.value,t.plan.value,c()}),Zn(c)];return()=>{u.end();for(let f of d)f()}}function yL(n,e,t,i){let{plate:r,regions:s,patches:o,features:a,held:l}=e.parts;n.strokeStyle=xc,n.lineWidth=1.2*devicePixelRatio;for(let c of Object.values(s).flat())Br(n,c,t);i&&(n.lineWidth=.8*devicePixelRatio,Ef(n,a,t),n.stroke(),Af(n,l,t)),n.lineWidth=1.2*devicePixelRatio,n.strokeStyle=ze("quiet");for(let c of r)Br(n,c,t);n.strokeStyle="#855a12",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[c,u,d,f]of Object.values(o))Br(n,$s([c,u],[d,f]),t);n.setLineDash([]);for(let[c,u]of Object.entries(s))Ja(n,c,u,t)}var xL="All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, at the nearest computed place.",bL=500;function Zx(n){return h(SL,{dataset:n})}function SL({dataset:n}){let e=gt(()=>new Tf(n),[n]),t=gt(()=>qx(e),[e]),i=gt(()=>Xx(e,t),[e,t]);return h(tr,{name:"finger",data:n,keys:i,foot:xL,children:[h("div",{class:"pair",children:[h("section",{"aria-label":"Map",children:h(pi,{label:"Finger on the plate. Arrow keys move it.",describedBy:"felt",children:h(Hx,{data:e,finger:t})})}),h("section",{"aria-label":"Friction",children:[h(ML,{data:e,finger:t}),h(Bx,{data:e,finger:t}),h(wL,{data:e,finger:t})]})]}),h(Er,{listing:t.listing,keys:i,children:h(TL,{data:e})})]})}function cs(n,e){let t=Math.abs(n),[i,r]=t>=1||t===0?["",1]:t>=.001?["m",1e3]:["µ",1e6];return`${Number((n*Number(r)).toPrecision(3))} ${i}${e}`}var Yx=n=>`${(100*n).toFixed(0)} %`;function ML({data:n,finger:e}){let{amplitude:t,free:i,friction:r,reduction:s}=e.below.value,o=e.place.value,{weber:a,frequency:l,drive:c,diameter:u}=n.extra,d=(p,m,[x,_])=>`${m(p.value)} (${m(p[x])} to ${m(p[_])})`,f=p=>p.toFixed(2);return h("div",{class:"facts",children:[h("p",{id:"felt","aria-live":"polite",children:[h("b",{children:n.region(o)}),", x = ",cs(n.x[o]??0,"m"),", y = ",cs(n.y[o]??0,"m"),":"," ",h("b",{children:Vx(s,a)})]}),h(ws,{facts:[["mu / mu0, model",d(r,f,["low","high"])],["less friction",d(s,Yx,["low","high"])],["amplitude below the finger",d(t,Co,["high","low"])],["without a finger",Co(i)]]}),h("p",{class:"again",children:["People notice reductions above ",Yx(a),". The finger covers ",cs(u,"m"),";"," ",Number((l/1e3).toFixed(3))," kHz. The same in the study:"," ",h("code",{children:["touch = ","{",' force = "',cs(n.forces[e.force.value]??0,"N"),'", speed = "',cs(n.speeds[e.speed.value]??0,"m/s"),'"',c.unit==="V"?`, voltage = "${cs(e.drive.value,"V")}"`:""," ","}"]})]})]})}function wL({data:n,finger:e}){let{low:t,high:i,title:r,unit:s}=n.extra.drive;return h("div",{class:"controls",children:[h("label",{class:"long",children:["Drive, ",r.toLowerCase(),": ",cs(e.drive.value,s),h("input",{type:"range",min:t,max:i,step:(i-t)/bL||1,value:e.drive.value,"aria-valuetext":cs(e.drive.value,s),onInput:o=>e.drive.value=Number(o.currentTarget.value)})]}),h(Kx,{title:n.data.title("force"),unit:"N",values:n.forces,chosen:e.force}),h(Kx,{title:n.data.title("speed"),unit:"m/s",values:n.speeds,chosen:e.speed})]})}function Kx({title:n,unit:e,values:t,chosen:i}){let r=cs(t[i.value]??0,e);return h("label",{class:"long",children:[n,": ",r,h("input",{type:"range",min:"0",max:t.length-1,step:"1",value:i.value,"aria-valuetext":r,onInput:s=>i.value=Number(s.currentTarget.value)})]})}function TL({data:n}){return h("div",{class:"wide",children:[h("table",{children:[h("caption",{children:"Numbers of the models"}),h("thead",{children:h("tr",{children:["number","value","plausible","origin","source"].map(e=>h("th",{scope:"col",children:e}))})}),h("tbody",{children:n.extra.parameters.map(({title:e,value:t,plausible:i,mark:r,source:s})=>h("tr",{children:[e,t,i,r,s].map(o=>h("td",{children:o}))}))})]}),h("dl",{children:Object.entries(n.extra.models).map(([e,t])=>h("div",{children:[h("dt",{children:["Model of ",e]}),h("dd",{children:t})]}))})]})}var EL={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"};function ja(n){let{x:e,curves:t,titles:i,height:r,limits:s,whole:o}=n,a=lt(null),l=lt(n);l.current=n;let c=lt(null);return Qi(()=>{let u=a.current;if(u===null)return;let d={...EL,stroke:()=>ze("ink"),ticks:{stroke:()=>ze("rule")},grid:{show:!1}},f=()=>({width:Rr(u),height:r}),p=new jt({...f(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(m,x,_)=>x===null?s?.x??[0,1]:[x,_]},y:{range:(m,x,_)=>x===null?s?.y??[0,1]:[x,_]}},axes:[{...d,label:i[0],labelSize:22,size:34,...o?{incrs:[1,2,5,10]}:{}},{...d,label:i[1],labelSize:24,size:52}],series:[{},...t.map(({colour:m,dash:x,width:_,points:g})=>({stroke:()=>ze(m),fill:()=>"transparent",dash:x??[],width:g?0:_??1.4,points:g?{show:!0,size:4,fill:()=>ze(m),width:0}:{show:!1}}))],hooks:{drawClear:[m=>Ir(m,()=>l.current.below?.(m))],draw:[m=>Ir(m,()=>l.current.above?.(m))]}},[e,...t.map(({values:m})=>m)],u);return s?.x&&p.setScale("x",{min:s.x[0],max:s.x[1]}),s?.y&&p.setScale("y",{min:s.y[0],max:s.y[1]}),Rs(p,(m,x)=>l.current.pick?.(p.posToVal(m,"x"),p.posToVal(x,"y"),p)),c.current=p,Pr(p,u,f,[])},[e,t,i[0],i[1]]),Qi(()=>c.current?.redraw(!1,!1)),h("div",{class:"curves",ref:a})}var Cf=class{constructor(e){this.data=e;this.frequency=e.values("frequency"),this.rows=e.values("rows"),this.kinds=e.texts("incident"),this.incident=this.kinds.filter(t=>this.losses(t).flat().some(Number.isFinite)),[this.waves=0]=e.shape("decay"),this.carrier=Number(e.header.extra.carrier),this.gap=e.header.extra.gap,this.units=Ts(e)}data;frequency;rows;incident;waves;carrier;gap;units;kinds;nearest(e){let t=Array.from(this.frequency,i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}losses(e,t="loss"){let i=this.kinds.indexOf(e)*this.rows.length;return Array.from(this.rows,(r,s)=>this.curve(t,i+s))}ofWaves(e){return Array.from({length:this.waves},(t,i)=>this.curve(e,i))}curve(e,t){let i=this.frequency.length;return Array.from(this.data.values(e).subarray(t*i,(t+1)*i))}};function Rf(n){return n.map(e=>Number.isFinite(e)?e:null)}var AL="Errors are the change of a value if all frequencies of the lattice move by the bound of their relative error, and this share of the value. Waves of the lattice are shown at normal incidence.",CL=10,jx=1.05,RL=60;function Qx(n){return h(PL,{data:n})}function PL({data:n}){let e=gt(()=>new Cf(n),[n]),t=gt(()=>({line:pe(e.nearest(e.carrier)),rows:pe(e.rows.length-1),incident:pe(e.incident[0]??""),unit:pe(Es(e.units,Math.max(...e.frequency))),listing:pe("none")}),[e]),i=gt(()=>IL(e,t),[e,t]);return h(tr,{name:"mirror",data:n,keys:i,foot:AL,children:[h("div",{class:"pair",children:[h("section",{"aria-label":"Insertion loss",children:[h(pi,{label:"Insertion loss. Arrow keys change the frequency and the number of rows.",children:h(LL,{mirror:e,choice:t})}),h("p",{class:"axes",children:[h("label",{children:["Incident wave"," ",h("select",{value:t.incident.value,onChange:r=>t.incident.value=r.currentTarget.value,children:e.incident.map(r=>h("option",{children:r}))})]}),h(er,{title:"Frequencies in",units:e.units,unit:t.unit}),h("span",{class:"legend",children:[e.gap&&h("span",{class:"of-gap",children:"gap"}),h("span",{class:"of-carrier",children:"carrier"})]})]}),h(NL,{mirror:e,choice:t}),h(DL,{mirror:e,choice:t})]}),h("section",{"aria-label":"Waves of the lattice",children:[h(Jx,{mirror:e,choice:t,name:"decay"}),h(Jx,{mirror:e,choice:t,name:"phase"})]})]}),h(Er,{listing:t.listing,keys:i,children:[h(UL,{mirror:e,choice:t}),h(FL,{mirror:e,choice:t})]})]})}function IL(n,e){let t=(o,a)=>Math.min(Math.max(o,0),a-1),i=o=>e.line.value=t(e.line.value+o,n.frequency.length),r=o=>e.rows.value=t(e.rows.value+o,n.rows.length),s=o=>o.shiftKey?CL:1;return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:o=>i(-s(o)),ArrowRight:o=>i(s(o))}},{keys:"↑ ↓",effect:"one more or one less row",actions:{ArrowUp:()=>r(1),ArrowDown:()=>r(-1)}},{keys:"i",effect:"next incident wave",actions:{i:()=>{let o=(n.incident.indexOf(e.incident.value)+1)%n.incident.length;e.incident.value=n.incident[o]??""}}},{keys:"c",effect:"carrier",actions:{c:()=>e.line.value=n.nearest(n.carrier)}},...Tr(e.listing)]}function eb({mirror:n,choice:e}){let{factor:t}=e.unit.value,i=(n.frequency[e.line.value]??0)/t;return{below:r=>{n.gap&&mu(r,[n.gap[0]/t,n.gap[1]/t],"gap")},above:r=>{fa(r,n.carrier/t,"carrier",[7,5]),fa(r,i,"accent")},pick:r=>e.line.value=n.nearest(r*t)}}function tb({mirror:n,choice:e}){let{factor:t}=e.unit.value;return gt(()=>Array.from(n.frequency,i=>i/t),[n,t])}function LL({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.rows.value],r=gt(()=>n.losses(t).map((s,o)=>({values:Rf(s),colour:o===i?"accent":"quiet",width:o===i?2.6:1})),[n,t,i]);return h(ja,{x:tb({mirror:n,choice:e}),curves:r,titles:[In("frequency",e.unit.value),`${n.data.title("loss")} / dB`],height:300,...eb({mirror:n,choice:e})})}function DL({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.line.value],[r,s]=["loss","loss_error"].map(c=>n.losses(t,c).map(u=>u[i]??NaN)),o=gt(()=>Array.from(n.rows),[n]),a=gt(()=>[{values:Rf(r??[]),colour:"quiet",dash:[2,4]}],[n,t,i]),l=Math.max(1,...o.map((c,u)=>(r?.[u]??NaN)+(s?.[u]??NaN)).filter(Number.isFinite));return h(ja,{x:o,curves:a,titles:["rows",`${n.data.title("loss")} / dB`],height:200,whole:!0,limits:{x:[.5,o.length+.5],y:[Math.min(0,...(r??[]).filter(Number.isFinite)),jx*l]},above:c=>o.forEach((u,d)=>{let[f=NaN,p=NaN]=[r?.[d],s?.[d]];if(!Number.isFinite(f))return;let m=x=>[c.valToPos(u,"x",!0),c.valToPos(x,"y",!0)];pa(c.ctx,m(f-p),m(f+p),"ink"),ma(c.ctx,m(f),d===e.rows.value?"accent":"quiet")}),pick:c=>e.rows.value=Math.min(Math.max(Math.round(c)-1,0),o.length-1)},`${t} ${i}`)}function Jx({mirror:n,choice:e,name:t}){let i=gt(()=>n.ofWaves(t).map(s=>({values:Rf(s),colour:"curve-0",points:!0})),[n,t]),r=Math.min(RL,jx*Math.max(...i.flatMap(({values:s})=>s.map(o=>o??0))));return h(ja,{x:tb({mirror:n,choice:e}),curves:i,titles:[In("frequency",e.unit.value),`${n.data.title(t)} / ${t==="decay"?"(dB/row)":"π"}`],height:t==="decay"?300:200,limits:{y:t==="decay"?[0,r]:[0,1]},...eb({mirror:n,choice:e})})}function Hm({mirror:n,choice:e}){let t=e.unit.value;return oi(Ar((n.frequency[e.line.value]??0)/t.factor),t)}function nb(n,e){return Number.isFinite(n)?`${Hn(n??NaN,e??NaN)} dB`:"does not propagate"}function NL({mirror:n,choice:e}){let[t,i,r]=[e.incident.value,e.line.value,e.rows.value],[s,o]=["loss","loss_error"].map(l=>n.losses(t,l)[r]?.[i]),a=n.rows[r]??0;return h("div",{class:"facts",children:[h("p",{id:"point","aria-live":"polite",children:[t," at ",h("b",{children:Hm({mirror:n,choice:e})}),", ",a," row",a===1?"":"s",": ",h("b",{children:nb(s,o)})]}),h("p",{class:"again",children:["The same as a picture, in Python: ",h("code",{children:['study.layers().plot("layers", incident="',t,'")']})]})]})}function UL({mirror:n,choice:e}){let t=e.line.value;return h("div",{class:"wide",children:h("table",{children:[h("caption",{children:["Insertion loss at ",Hm({mirror:n,choice:e})]}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"rows"}),n.incident.map(i=>h("th",{scope:"col",children:["incident ",i]}))]})}),h("tbody",{children:Array.from(n.rows,(i,r)=>h("tr",{"aria-current":r===e.rows.value?"true":void 0,children:[h("td",{children:i}),n.incident.map(s=>h("td",{children:nb(n.losses(s)[r]?.[t],n.losses(s,"loss_error")[r]?.[t])}))]}))})]})})}function FL({mirror:n,choice:e}){let t=e.line.value,i=["decay","decay_error","phase","phase_error"].map(r=>n.ofWaves(r));return h("div",{class:"wide",children:h("table",{children:[h("caption",{children:["Waves of the lattice at ",Hm({mirror:n,choice:e})]}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"decay / (dB/row)"}),h("th",{scope:"col",children:"phase per row / π"})]})}),h("tbody",{children:Array.from({length:n.waves},(r,s)=>{let[o=NaN,a=NaN,l=NaN,c=NaN]=i.map(u=>u[s]?.[t]);return h("tr",{children:[h("td",{children:Hn(o,a)}),h("td",{children:Number.isFinite(l)?Hn(l,c):"decays"})]})})})]})})}var Pf=class{constructor(e){this.data=e;let{extra:t}=e.header;this.frequency=e.values("frequency"),[,this.rows=0,this.columns=0]=e.shape("shape_real"),this.real=e.values("shape_real"),this.imag=e.values("shape_imag"),this.step=e.values("shape_step"),this.present=e.values("present"),this.gap=t.gap,this.carrier=Number(t.carrier),this.drive=String(t.drive),this.parts=t,this.colours=t.colours,this.units=Ts(e);let[i,r]=[e.values("mode_frequency"),e.values("mode_quality")];this.modes=Array.from(i,(s,o)=>({frequency:s,name:e.texts("mode_name")[o]??"",quality:r[o]??NaN}))}data;frequency;columns;rows;gap;carrier;drive;parts;modes;colours;units;real;imag;step;present;nearest(e){let t=0;return this.frequency.forEach((i,r)=>{Math.abs(i-e)<Math.abs((this.frequency[t]??0)-e)&&(t=r)}),t}get first(){return this.nearest(Number(this.data.header.extra.first))}largest(e){return(this.step[e]??0)*(this.colours.length-1)*.5}get extent(){let[e,t]=[this.data.values("x"),this.data.values("y")],[i,r]=[ib(e),ib(t)];return{left:(e[0]??0)-i,right:(e[e.length-1]??0)+i,bottom:(t[0]??0)-r,top:(t[t.length-1]??0)+r}}paint(e,t,i){let[r,s]=[Math.cos(2*Math.PI*i),Math.sin(2*Math.PI*i)],o=(this.colours.length-1)/2,a=t*this.rows*this.columns;for(let l=0;l<this.rows;l++)for(let c=0;c<this.columns;c++){let u=l*this.columns+c,d=(this.real[a+u]??0)*r-(this.imag[a+u]??0)*s,f=Math.min(Math.max(Math.round(o+d),0),2*o),[p=0,m=0,x=0]=this.colours[f]??[],_=4*((this.rows-1-l)*this.columns+c);e.data[_]=p,e.data[_+1]=m,e.data[_+2]=x,e.data[_+3]=this.present[u]===0?0:255}}outermost(e){let t=e*this.rows*this.columns,[i,r]=[0,-1];for(let s=t;s<t+this.rows*this.columns;s++){let o=Math.hypot(this.real[s]??0,this.imag[s]??0);o>r&&([i,r]=[s,o])}return-Math.atan2(this.imag[i]??0,this.real[i]??0)/(2*Math.PI)}has(e){return this.data.has(e)}curves(e){if(!this.data.has(e))return[];let t=this.data.values(e),i=this.data.texts(e==="level"?"region":"pair"),r=this.frequency.length;return i.map((s,o)=>({name:s,values:Array.from(t.subarray(o*r,(o+1)*r),a=>Number.isFinite(a)&&(e==="contrast"||a>0)?a:null)}))}};function ib(n){return n.length>1?.5*((n[1]??0)-(n[0]??0)):5e-4}var Sc=[[],[8,4],[2,3],[10,3,2,3]],Wm=4,OL=300;function rb({plate:n,choice:e}){let t=lt(null),i=e.shown.value;return Qi(()=>{if(t.current!==null)return kL(t.current,n,e)},[n,e,i]),h("div",{class:"curves",ref:t})}function kL(n,e,t){let i=t.shown.peek(),r=e.curves(i),s=e.data.unit(i),o={stroke:()=>ze("ink"),ticks:{stroke:()=>ze("rule")}},a={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},l=()=>t.unit.peek().factor,c=()=>[Array.from(e.frequency,f=>f/l()),...r.map(({values:f})=>f)],u=()=>({width:Rr(n),height:OL}),d=new jt({...u(),legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},scales:{x:{time:!1},y:{distr:i==="level"?3:1}},axes:[{...o,...a,label:"frequency",labelSize:22,size:34,grid:{show:!1}},{...o,...a,label:`${e.data.title(i)} / ${s}`,labelSize:24,size:58,grid:{show:!1},values:(f,p)=>p.map(m=>m===null?"":BL(m,i==="level"))}],series:[{},...r.map((f,p)=>({stroke:()=>ze(`curve-${p%Wm}`),dash:Sc[p%Sc.length]??[],width:1.4,points:{show:!1}}))],hooks:{drawClear:[f=>Ir(f,()=>zL(f,e,l()))],draw:[f=>VL(f,e,t)]}},c(),n);return Rs(d,f=>t.line.value=e.nearest(l()*d.posToVal(f,"x"))),Pr(d,n,u,[et(()=>{let f=d.axes[0];f!==void 0&&(f.label=In("frequency",t.unit.value)),d.setData(c(),!0)}),et(()=>{t.line.value,d.redraw(!1,!1)})])}function BL(n,e){if(!e)return`${Number(n.toPrecision(4))}`.replace("-","−");let t=Math.log10(n);return Math.abs(t-Math.round(t))<1e-9?`1e${Math.round(t)}`.replace("-","−"):""}function zL(n,e,t){e.gap!==null&&mu(n,[e.gap[0]/t,e.gap[1]/t],"gap")}function VL(n,e,t){let{factor:i}=t.unit.peek();fa(n,e.carrier/i,"carrier",[7,5]),fa(n,(e.frequency[t.line.peek()]??0)/i,"accent")}var GL=10;function sb(n){return{line:pe(n.first),shown:pe(n.has("level")?"level":"contrast"),plan:pe(!1),unit:pe(Es(n.units,Math.max(...n.frequency))),playing:pe(!ga()),pace:pe(.7),listing:pe("none")}}function ob(n,e){let t=n.frequency.length-1,i=a=>e.line.value=Math.min(Math.max(e.line.value+a,0),t),r=a=>a.shiftKey?GL:1,s=n.modes.map(({frequency:a})=>n.nearest(a)).sort((a,l)=>a-l),o=a=>{a!==void 0&&(e.line.value=a)};return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:a=>i(-r(a)),ArrowRight:a=>i(r(a))}},{keys:"p n",effect:"previous or next mode near the carrier",actions:{p:()=>o(s.filter(a=>a<e.line.value).pop()),n:()=>o(s.find(a=>a>e.line.value))}},{keys:"c",effect:"carrier",actions:{c:()=>o(n.nearest(n.carrier))}},{keys:"g",effect:"resonance in the gap",actions:{g:()=>o(n.first)}},{keys:"l",effect:"pillars and supports",actions:{l:()=>e.plan.value=!e.plan.value}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},...Tr(e.listing)]}var HL="The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.",ab=["level","contrast"];function lb(n){return h(WL,{data:n})}function WL({data:n}){let e=gt(()=>new Pf(n),[n]),t=gt(()=>sb(e),[e]),i=gt(()=>ob(e,t),[e,t]),r=ab.filter(s=>e.has(s));return h(tr,{name:"plate",data:n,keys:i,foot:HL,children:[h("div",{class:"pair",children:[h("section",{"aria-label":"Spectra",children:[r.length>0&&e.frequency.length>1&&h(Ct,{children:[h(pi,{label:"Spectra. Arrow keys change the frequency.",children:h(rb,{plate:e,choice:t})}),h(qL,{plate:e,choice:t}),h("p",{class:"axes",children:[h("label",{children:["Curves"," ",h("select",{value:t.shown.value,onChange:s=>t.shown.value=s.currentTarget.value,children:r.map(s=>h("option",{value:s,children:e.data.title(s)}))})]}),h(er,{title:"Frequencies in",units:e.units,unit:t.unit})]})]}),h(XL,{plate:e,choice:t})]}),h("section",{"aria-label":"Map",children:[h($x,{plate:e,choice:t}),h("div",{class:"controls",children:[h(ea,{playing:t.playing}),h($L,{plate:e,choice:t}),h(ta,{pace:t.pace}),h("label",{class:"check",children:[h("input",{type:"checkbox",checked:t.plan.value,onChange:s=>t.plan.value=s.currentTarget.checked}),"pillars and supports"]})]})]})]}),h(Er,{listing:t.listing,keys:i,children:[h(YL,{plate:e,choice:t}),h(KL,{plate:e,choice:t})]})]})}function qL({plate:n,choice:e}){return h("p",{class:"legend",children:[n.curves(e.shown.value).map(({name:t},i)=>h("span",{class:"of-curve",children:[h("svg",{width:"34",height:"8","aria-hidden":"true",children:h("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${i%Wm})`,"stroke-dasharray":(Sc[i%Sc.length]??[]).join(" ")})})," ",t]})),n.gap!==null&&h("span",{class:"of-gap",children:"gap"}),h("span",{class:"of-carrier",children:"carrier"})]})}function Qa(n,e){return oi(Ar(n/e.factor),e)}function XL({plate:n,choice:e}){let t=e.line.value,i=n.frequency[t]??0,r=n.curves("contrast");return h("div",{class:"facts",children:[h("p",{id:"point","aria-live":"polite",children:[h("b",{children:Qa(i,e.unit.value)}),": up to ",Co(n.largest(t)),n.drive,r.map(({name:s,values:o})=>`; ${s} ${o[t]?.toFixed(1)??"-"} dB`).join("")]}),h("p",{class:"again",children:["The same map as a picture, in Python: ",h("code",{children:['study.plate().plot("maps", frequency=',Number(i.toFixed(3)),")"]})]})]})}function $L({plate:n,choice:e}){let t=n.frequency.length-1,i=e.line.value;return h("label",{class:"long",children:["frequency: ",Qa(n.frequency[i]??0,e.unit.value),h("input",{type:"range",min:"0",max:t,step:"1",value:i,disabled:t===0,"aria-valuetext":Qa(n.frequency[i]??0,e.unit.value),onInput:r=>e.line.value=Number(r.currentTarget.value)})]})}function YL({plate:n,choice:e}){let t=e.line.value,i=ab.flatMap(r=>n.curves(r).map(({name:s,values:o})=>[n.data.title(r),s,`${o[t]?.toPrecision(3)??"-"} ${n.data.unit(r)}`]));return h("div",{class:"wide",children:h("table",{children:[h("caption",{children:["Regions at ",Qa(n.frequency[t]??0,e.unit.value)]}),h("tbody",{children:i.map(r=>h("tr",{children:r.map(s=>h("td",{children:s}))}))})]})})}function KL({plate:n,choice:e}){return n.modes.length===0?null:h("div",{class:"wide",children:h("table",{children:[h("caption",{children:"Modes near the carrier"}),h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"frequency"}),h("th",{scope:"col",children:"nodal lines"}),h("th",{scope:"col",children:"Q"}),h("th",{scope:"col",children:"show"})]})}),h("tbody",{children:n.modes.map(({frequency:t,name:i,quality:r})=>h("tr",{children:[h("td",{children:Qa(t,e.unit.value)}),h("td",{children:i}),h("td",{children:r.toFixed(0)}),h("td",{children:h("button",{type:"button",onClick:()=>e.line.value=n.nearest(t),children:Qa(n.frequency[n.nearest(t)]??0,e.unit.value)})})]}))})]})})}var ZL=40,JL=.42;function cb({ribbon:n,choice:e}){let[t,i]=[e.unit.value,e.wavevectorUnit.value],r=e.mode.value,s=gt(()=>Array.from(n.phases,l=>l/n.period/i.factor),[n,i]),o=gt(()=>{let[l,c]=n.range;return{x:[0,Math.PI/n.period/i.factor],y:[l/t.factor,c/t.factor]}},[n,i,t]),a=(l,c,u=!1)=>[l.valToPos(n.wavevector(c)/i.factor,"x",u),l.valToPos(n.at(c)/t.factor,"y",u)];return h(ja,{x:s,curves:jL,titles:[In("wavevector along the ribbon",i),In("frequency",t)],height:420,limits:o,below:l=>QL(l,n,s,t.factor),above:l=>{e2(l,n,t.factor,i.factor),n.carrier!==null&&da(l,n.carrier/t.factor,"carrier",[7,5]),ma(l.ctx,a(l,r,!0),"accent")},pick:(l,c,u)=>{let[d,f]=[u.valToPos(l,"x"),u.valToPos(c,"y")],p=x=>Math.hypot(a(u,x)[0]-d,a(u,x)[1]-f),m=n.all.reduce((x,_)=>p(_)<p(x)?_:x,0);p(m)<ZL&&(e.mode.value=m)}})}var jL=[];function QL(n,e,t,i){let{ctx:r}=n;r.save(),r.globalAlpha=.4;for(let{crystal:s,lower:o,upper:a}of e.bulk()){r.fillStyle=ze(s===0?"rule":`curve-${s}`),r.beginPath();let l=(c,u)=>r.lineTo(n.valToPos(t[u]??0,"x",!0),n.valToPos((c[u]??0)/i,"y",!0));t.forEach((c,u)=>l(a,u)),t.forEach((c,u)=>l(o,t.length-1-u)),r.fill()}r.restore()}function e2(n,e,t,i){let{ctx:r}=n,s=e.phases.length>1?(e.phases[1]??0)-(e.phases[0]??0):.1,o=JL*s/e.period;r.save();for(let a of e.all){let l=(e.velocity[a]??0)*o/(2*Math.PI),c=d=>[n.valToPos((e.wavevector(a)+d*o)/i,"x",!0),n.valToPos((e.at(a)+d*l)/t,"y",!0)],u=e.share[a]??0;r.strokeStyle=qm(e.shares,u),r.lineWidth=(e.isGuided(a)?3:1.4)*devicePixelRatio,r.beginPath(),r.moveTo(...c(-1)),r.lineTo(...c(1)),r.stroke()}r.restore()}function qm(n,e){let t=matchMedia("(prefers-color-scheme: dark)").matches?e:1-e;return`rgb(${(n[Math.round(Math.min(Math.max(t,0),1)*(n.length-1))]??[]).join(" ")})`}var t2=1.6,n2=30;function ub({ribbon:n,choice:e}){let t=lt(null);return Ut(()=>t.current===null?void 0:i2(t.current,n,e),[n,e]),h("div",{class:"map",children:[h("canvas",{ref:t,role:"img","aria-label":"Field of the mode"}),h(ya,{canvas:t,name:"ribbon",caption:`${n.data.header.title}, ${oo(n.data)}`})]})}function i2(n,e,t){let i=new Xm(e),r=Ys.on(n,i.columns,i.rows);if(r===null)return()=>{};let s={frames:0,painter:i},o=()=>{let c=t.mode.peek();s.frames++,i.paint(r.image,c,a.moment),r.show(!0),n.dataset.shown=String(c)},a=new Ps(t,o);va(n,c=>a.at(c)),Object.assign(n,{counted:s});let l=[r.follow(i.width/i.length,o),et(()=>{t.mode.value,o()}),Zn(o)];return()=>{a.end();for(let c of l)c()}}var Xm=class{constructor(e){this.ribbon=e;let[,t=0,i=0]=e.data.shape("mode_real"),r=e.data.values("across");this.width=((r[1]??0)-(r[0]??0))*t;let s=Math.min(n2,Math.max(2,Math.round(t2*this.width/e.period)));this.length=s*e.period,this.columns=s*i,this.rows=t,this.along=i}ribbon;columns;rows;width;length;along;paint(e,t,i){let{data:r,colours:s,phase:o}=this.ribbon,[a,l,c]=[r.values("mode_real"),r.values("mode_imag"),r.values("present")],u=(s.length-1)/2,d=t*this.rows*this.along;for(let f=0;f<this.columns;f++){let p=Math.floor(f/this.along),m=2*Math.PI*i+p*(o[t]??0),[x,_]=[Math.cos(m),Math.sin(m)];for(let g=0;g<this.rows;g++){let b=g*this.along+f%this.along,A=(a[d+b]??0)*x-(l[d+b]??0)*_,S=Math.min(Math.max(Math.round(u+A),0),2*u),[P=0,C=0,v=0]=s[S]??[],E=4*((this.rows-1-g)*this.columns+f);e.data.set([P,C,v,c[b]===0?0:255],E)}}}};var r2=["across the ribbon","along the ribbon","normal to the plate"],If=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),this.phase=e.values("phase"),this.velocity=e.values("group_velocity"),this.share=e.values("guide_share"),this.phases=e.values("wavevector_phase"),this.period=Number(i.period),this.range=t.range,this.carrier=t.carrier,this.place=i.kind==="strip"?"the outermost columns":`the ${i.kind}`,this.units=Ts(e),this.wavevectorUnits=Qc(this.period),this.colours=t.colours,this.shares=t.shares,this.atPhase=Array.from(this.phases,r=>this.all.filter(s=>this.phase[s]===r).sort((s,o)=>this.at(s)-this.at(o)))}data;frequency;error;phase;velocity;share;phases;period;range;carrier;place;units;wavevectorUnits;colours;shares;atPhase;get all(){return Array.from(this.frequency,(e,t)=>t)}get hasFields(){return this.data.has("mode_real")}at(e){return this.frequency[e]??NaN}wavevector(e){return(this.phase[e]??0)/this.period}isGuided(e){return this.data.values("guided")[e]===1}decay(e){return this.data.values("decay")[e]??NaN}direction(e){return r2[this.data.values("mode_component")[e]??2]??""}get first(){let[e,t]=this.range,i=this.carrier!==null&&this.carrier>e&&this.carrier<t?this.carrier:(e+t)/2,r=this.all.filter(s=>this.isGuided(s));return hb(r.length>0?r:this.all,s=>this.at(s),i)}beside(e){return this.atPhase[this.row(e)]??[]}moved(e,t,i){let r=this.beside(e);if(i!==0)return r[Math.min(Math.max(r.indexOf(e)+i,0),r.length-1)]??e;let s=this.atPhase.map((a,l)=>l).filter(a=>(this.atPhase[a]??[]).length>0),o=Math.min(Math.max(s.indexOf(this.row(e))+t,0),s.length-1);return hb(this.atPhase[s[o]??0]??[],a=>this.at(a),this.at(e))}get guided(){return this.atPhase.flat().filter(e=>this.isGuided(e))}bulk(){let[e=0,t=0,i=0]=this.data.shape("bulk_lower"),[r,s]=[this.data.values("bulk_lower"),this.data.values("bulk_upper")];return Array.from({length:e*i},(o,a)=>{let[l,c]=[Math.floor(a/i),a%i],u=d=>Array.from({length:t},(f,p)=>d[(l*t+p)*i+c]??NaN);return{crystal:l,lower:u(r),upper:u(s)}})}row(e){return Array.from(this.phases).indexOf(this.phase[e]??NaN)}};function hb(n,e,t){return n.reduce((i,r)=>Math.abs(e(r)-t)<Math.abs(e(i)-t)?r:i,n[0]??0)}var fb="Each error bounds the distance to the exact frequency of the model. The field is that of the strongest component on the flat face, relative to its largest displacement.",s2="Fields of the modes are computed with the option --html.";function db(n){return h(o2,{data:n})}function o2({data:n}){let e=gt(()=>new If(n),[n]),t=gt(()=>({mode:pe(e.first),unit:pe(Es(e.units,e.range[1])),wavevectorUnit:pe(e.wavevectorUnits[1]),playing:pe(!ga()),pace:pe(.7),listing:pe("none")}),[e]),i=gt(()=>a2(e,t),[e,t]);return e.all.length===0?h(tr,{name:"ribbon",data:n,keys:[],foot:fb,children:null}):h(tr,{name:"ribbon",data:n,keys:i,foot:fb,children:[h("div",{class:"pair",children:[h("section",{"aria-label":"Projected bands",children:[h(pi,{label:"Projected bands. Arrow keys move between wavevectors and modes.",children:h(cb,{ribbon:e,choice:t})}),h("p",{class:"axes",children:[h(er,{title:"Frequencies in",units:e.units,unit:t.unit}),h(er,{title:"Wavevectors in",units:e.wavevectorUnits,unit:t.wavevectorUnit})]}),h(l2,{ribbon:e})]}),h("section",{"aria-label":"Mode",children:[e.hasFields?h(ub,{ribbon:e,choice:t}):h("p",{children:s2}),h(c2,{ribbon:e,choice:t}),e.hasFields&&h("div",{class:"controls",children:[h(ea,{playing:t.playing}),h(ta,{pace:t.pace})]})]})]}),h(Er,{listing:t.listing,keys:i,children:h(u2,{ribbon:e,choice:t})})]})}function a2(n,e){let t=(r,s)=>e.mode.value=n.moved(e.mode.value,r,s),i=r=>{let{guided:s}=n;if(s.length===0)return;let o=s.indexOf(e.mode.value);e.mode.value=s[(o+r+s.length)%s.length]??e.mode.value};return[{keys:"← →",effect:"mode of about this frequency at the previous or next wavevector",actions:{ArrowLeft:()=>t(-1,0),ArrowRight:()=>t(1,0)}},{keys:"↑ ↓",effect:"next higher or lower mode at this wavevector",actions:{ArrowUp:()=>t(0,1),ArrowDown:()=>t(0,-1)}},{keys:"p n",effect:"previous or next guided mode",actions:{p:()=>i(-1),n:()=>i(1)}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},...Tr(e.listing)]}function l2({ribbon:n}){let[,e]=Lt(0);Ut(()=>Zn(()=>e(i=>i+1)),[]);let t=[0,.25,.5,.75,1].map(i=>qm(n.shares,i));return h("p",{class:"scale legend",children:["0 %",h("span",{class:"bar",style:{background:`linear-gradient(to right, ${t.join(", ")})`}}),"100 % of the energy in ",n.place,"; guided modes are thick",n.carrier!==null&&h("span",{class:"of-carrier",children:"carrier"})]})}function pb(n,e,{factor:t,name:i}){return`${Number((n.wavevector(e)/t).toPrecision(4))} ${i}`}function mb(n){return`${(100*(n??NaN)).toFixed(1)} %`}function gb(n,e,{factor:t}){return Hn(n.at(e)/t,(n.error[e]??NaN)/t)}function c2({ribbon:n,choice:e}){let[t,i,r]=[e.mode.value,e.unit.value,e.wavevectorUnit.value],s=n.decay(t),o=[["group velocity",`${(n.velocity[t]??0).toFixed(0)} m/s`],[`energy in ${n.place}`,mb(n.share[t])],["decay",Number.isFinite(s)?`${s.toFixed(1)} dB per row`:""],["shown displacement",n.hasFields?n.direction(t):""]];return h("div",{class:"facts",children:[h("p",{id:"point","aria-live":"polite",children:[n.isGuided(t)?"Guided mode":"Mode"," at ",pb(n,t,r),":"," ",h("b",{children:oi(gb(n,t,i),i)})]}),h(ws,{facts:o})]})}function u2({ribbon:n,choice:e}){let[t,i,r]=[e.mode.value,e.unit.value,e.wavevectorUnit.value];return h("div",{class:"wide",children:h("table",{children:[h("caption",{children:["Modes at ",pb(n,t,r)]}),h("thead",{children:h("tr",{children:[In("frequency",i),"guided",`energy in ${n.place}`,"decay / (dB/row)","show"].map(s=>h("th",{scope:"col",children:s}))})}),h("tbody",{children:n.beside(t).map(s=>h("tr",{"aria-current":s===t?"true":void 0,children:[h("td",{children:gb(n,s,i)}),h("td",{children:n.isGuided(s)?"yes":"no"}),h("td",{children:mb(n.share[s])}),h("td",{children:Number.isFinite(n.decay(s))?n.decay(s).toFixed(1):"-"}),h("td",{children:h("button",{type:"button",onClick:()=>e.mode.value=s,children:oi(Ar(n.at(s)/i.factor),i)})})]}))})]})})}var _b='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var vb=`& {
  --paper: #ffffff;
  --panel: #f5f6f7;
  --ink: #1c2126;
  --quiet: #4d565e;
  --rule: #c9ced3;
  --accent: #0a5ea8;
  --gap: #f3d9a4;
  --carrier: #b3123f;
  --curve-0: #0072b2;
  --curve-1: #b34e00;
  --curve-2: #007a59;
  --curve-3: #a0447c;
  color-scheme: light dark;
  background: var(--paper);
  color: var(--ink);
  font: 1rem/1.45 system-ui, sans-serif;
}
@media (prefers-color-scheme: dark) {
  & {
    --paper: #15181b;
    --panel: #1f2428;
    --ink: #e8eaec;
    --quiet: #b3bac0;
    --rule: #4a5258;
    --accent: #6db3f2;
    --gap: #5c4714;
    --carrier: #ff7d9c;
    --curve-0: #6db3f2;
    --curve-1: #ffb066;
    --curve-2: #4fd1a5;
    --curve-3: #f0a3cf;
  }
}
body { margin: 0; }
.view { container-type: inline-size; }
#view { max-width: 84rem; margin: 0 auto; padding: 0.75rem 1rem 2rem; }
h1 { font-size: 1.3rem; margin: 0; display: inline-block; }
.origin {
  display: inline-block; margin: 0 0 0 0.75rem; padding: 0 0.5rem;
  border: 1px solid var(--rule); border-radius: 0.75rem; color: var(--quiet); font-size: 0.85rem;
}
header p { margin: 0.25rem 0; max-width: 60rem; }
.pair { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr); margin-top: 0.75rem; }
@container (min-width: 52rem) { .pair { grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr); } }
.walk:focus-visible, button:focus-visible, input:focus-visible, select:focus-visible, canvas:focus-visible {
  outline: 3px solid var(--accent); outline-offset: 2px;
}
.curves { width: 100%; overflow: hidden; }
.mode canvas {
  display: block; width: 100%; height: clamp(17rem, 46vh, 30rem); background: var(--panel);
  border-radius: 0.4rem; touch-action: none;
}
.map canvas { display: block; max-width: 100%; background: var(--panel); }
.finger .map canvas { touch-action: none; cursor: pointer; }
.finger .map .bar { flex: 0 1 8rem; }
.axes label { max-width: 100%; }
.opened { display: flex; gap: 0.4rem; }
.legend .of-curve::before { display: none; }
.legend .of-curve { margin-right: 1rem; }
.legend > span { display: inline-block; }
.axes, .sides, .controls { display: flex; flex-wrap: wrap; gap: 0.4rem 1rem; align-items: center; margin: 0.5rem 0; }
.sides { gap: 0.4rem; font-size: 0.9rem; }
.scale { display: flex; flex-wrap: wrap; gap: 0.4rem; align-items: center; margin: 0.4rem 0; font-size: 0.85rem; }
.scale .bar { width: 8rem; height: 0.8rem; border: 1px solid var(--rule); }
.legend span::before { content: ""; display: inline-block; width: 1.4em; height: 0.8em; margin: 0 0.35em 0 0.9em; }
.legend .of-gap::before { background: var(--gap); border: 1px solid var(--rule); }
.legend .of-parity::before { background: repeating-linear-gradient(-45deg, var(--gap) 0 2px, transparent 2px 6px); border: 1px solid var(--rule); }
.legend .of-carrier::before { height: 0; border-top: 2px dashed var(--carrier); vertical-align: 0.25em; }
.legend .of-preview::before { height: 0; border-top: 2px dashed var(--accent); vertical-align: 0.25em; }
.legend .of-held::before { height: 0; border-top: 2px dotted var(--curve-1); vertical-align: 0.25em; }
/* the slider and the edges of the gap stay in sight above the curves */
.insight {
  position: sticky; top: 0; z-index: 2; display: flex; flex-wrap: wrap; gap: 0.2rem 1rem; align-items: center;
  background: var(--paper); border-bottom: 1px solid var(--rule); padding: 0.3rem 0;
}
.edges { display: flex; flex-wrap: wrap; gap: 0 1rem; margin: 0; font-variant-numeric: tabular-nums; }
.edges div { display: flex; gap: 0.4rem; align-items: baseline; }
.edges dt { color: var(--quiet); font-size: 0.85rem; }
.edges dd { margin: 0; }
.kind { color: var(--paper); background: var(--quiet); border-radius: 0.3rem; padding: 0 0.4rem; min-width: 4rem; text-align: center; font-size: 0.85rem; }
.kind.earlier { background: var(--carrier); }
.insight p { margin: 0; }
.kind.preview { background: var(--accent); }
.old { visibility: hidden; }
button.minor { padding: 0 0.45rem; min-height: 1.6rem; font-size: 0.85rem; }
button.minor[aria-pressed="true"] { border: 2px solid var(--accent); font-weight: 600; }
.turning { flex: 1 1 26rem; display: flex; flex-wrap: wrap; gap: 0.2rem 0.75rem; align-items: center; }
.turning input[type="range"] { flex: 1 1 12rem; }
/* of fixed widths, so that the slider does not change under the hand */
.turning output { flex: 0 0 7rem; font-variant-numeric: tabular-nums; }
.turning .state { font-size: 0.85rem; }
.facts p { margin: 0.4rem 0; }
.facts dl { display: flex; flex-wrap: wrap; gap: 0.2rem 1.5rem; margin: 0.4rem 0; }
.facts dt { color: var(--quiet); font-size: 0.85rem; }
.facts dd { margin: 0; }
.again { color: var(--quiet); font-size: 0.9rem; }
code { font: 0.95em ui-monospace, monospace; overflow-wrap: anywhere; }
.controls label { display: flex; flex-direction: column; font-size: 0.85rem; color: var(--quiet); }
.controls label.check { flex-direction: row; gap: 0.4rem; align-items: center; }
button, select, input[type="number"] {
  font: inherit; color: var(--ink); background: var(--panel); border: 1px solid var(--quiet);
  border-radius: 0.35rem; padding: 0.2rem 0.6rem; min-height: 1.9rem;
}
select { max-width: 100%; }
button { cursor: pointer; }
a { color: var(--accent); }
input[type="range"] { accent-color: var(--accent); min-width: 10rem; }
.controls .long { flex: 1 1 100%; }
.wide { overflow-x: auto; position: relative; }
table { border-collapse: collapse; margin: 0.5rem 0 1rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; font-weight: 600; padding: 0.3rem 0; }
th, td { text-align: left; padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid var(--rule); font-weight: normal; }
thead th { color: var(--quiet); }
tr[aria-current] td { font-weight: 600; }
footer { color: var(--quiet); font-size: 0.85rem; }
`;var d2={bands:Ox,layers:Qx,plate:lb,finger:Zx,ribbon:db};function yb(n,e,t){let i=d2[n.header.kind];if(i===void 0)throw new Error(`this version has no view "${n.header.kind}"`);return $m(),e.classList.add("haptonic","view"),yl(i(n,t),e),()=>yl(null,e)}function $m(){if(document.getElementById("haptonic-style")!==null)return;let n=document.createElement("style");n.id="haptonic-style",n.textContent=`${_b}:where(.haptonic) { ${vb} }`,document.head.append(n)}var Lf=/^\s*\[\[?\s*([^\]]+?)\s*\]\]?/,p2=["quantity","number","integer","quantities","entries"];function xb(n,e,t,i){let r=n.lastIndexOf(`
`,e-1)+1,s=n.slice(r,e),o=n.slice(0,r).split(`
`),a=new Map(t.map(f=>[f.path,f])),l=s.indexOf("="),c=/^\s*\[+\s*([\w.-]*)$/.exec(s);if(c!==null)return v2(c[1]??"",e-s.trimStart().length,t);let u=m2(o,a);if(l<0){let f=g2(n.split(`
`),o.length-1);return y2(/[\w-]*$/.exec(s)?.[0]??"",e,{keys:t,table:u,given:f})}let d=a.get(Sb(u,bb(s.slice(0,l).trim(),a,u)))??a.get(u);return d===void 0?{from:e,list:[]}:x2(s.slice(l+1),e,d,d.path===i?[]:_2(n,i))}function m2(n,e){return bb(n.flatMap(t=>Lf.exec(t)?.[1]??[]).at(-1)??"",e,"")}function bb(n,e,t){return n.split(".").reduce((i,r)=>{let s=i?`${i}.${r.trim()}`:r.trim();return e.get(Sb(t,s))?.kind==="tables"?`${s}[]`:s},"")}var Sb=(n,e)=>n&&e?`${n}.${e}`:n||e;function g2(n,e){let t=n.map(o=>Lf.test(o)),i=t.lastIndexOf(!0,e)+1,r=t.indexOf(!0,e+1),s=n.filter((o,a)=>a>=i&&(r<0||a<r)&&a!==e);return new Set(s.map(o=>/^\s*([\w-]+)\s*=/.exec(o)?.[1]??""))}function _2(n,e){let t=n.split(`
`),i=t.findIndex(s=>Lf.exec(s)?.[1]===e)+1;if(i===0)return[];let r=t.slice(i).findIndex(s=>Lf.test(s));return t.slice(i,r<0?t.length:i+r).flatMap(s=>{let[,o,a]=/^\s*([A-Za-z_]\w*)\s*=\s*(.*)/.exec(s)??[];return o===void 0?[]:[[o,a??""]]})}function Ym(n,e){let t=e.toLowerCase();return n.filter(({label:i})=>i.replace(/^[["]+/,"").toLowerCase().startsWith(t)).slice(0,50)}function v2(n,e,t){let i=t.filter(({kind:r})=>["table","tables","entries"].includes(r)).map(({path:r,kind:s,title:o})=>{let a=r.replaceAll("[]",""),l=s==="tables"?`[[${a}]]`:`[${a}]`;return{insert:l,label:l,detail:o}});return{from:e,list:Ym(i,n)}}function y2(n,e,{keys:t,table:i,given:r}){let s=t.filter(({path:o,kind:a})=>o.slice(0,o.lastIndexOf(".")+1)===(i&&`${i}.`)&&!["table","tables","entries"].includes(a)).map(o=>({name:o.path.slice(o.path.lastIndexOf(".")+1),key:o})).filter(({name:o})=>!r.has(o)).map(({name:o,key:a})=>({insert:`${o} = `,label:o,detail:a.title+(a.required?", required":a.default?`, default ${a.default}`:"")}));return{from:e-n.length,list:Ym(s,n)}}function x2(n,e,t,i){let r=n.trimStart().startsWith('"'),s=/[\w.-]*$/.exec(n)?.[0]??"",o=f=>r?f:`"${f}"`,a=[...t.names,...t.numbers].map(f=>({insert:o(f),label:f,detail:t.title})),l=t.kind==="boolean"?["true","false"].map(f=>({insert:f,label:f,detail:t.title})):[],u=(p2.includes(t.kind)?i:[]).map(([f,p])=>({insert:o(f),label:f,detail:`parameter, ${p}`})),d=n.trim()===""&&t.example&&!t.closed?[{insert:t.kind==="quantity"?`"${t.example}"`:t.example,label:t.example,detail:`${t.title}, an example`}]:[];return{from:e-s.length,list:Ym([...l,...a,...u,...d],s)}}var Ks=class extends Error{constructor(t,i){super(t);this.problem=i}problem};async function wb(n){let e;try{e=await n}catch{throw new Ks("The server does not answer; is `haptonic studio` still running?")}if(e.ok)return e;if(e.status===422){let{error:t}=await e.json();throw new Ks(`${t.argument}: ${t.cause}`,t)}throw e.status===403?new Ks("The server was started again; open its new link."):new Ks(e.headers.get("content-type")?.startsWith("text/plain")?await e.text():`Error ${e.status} of the server.`)}var Mc=async n=>await(await wb(n)).json();async function Mb(n){let e=await wb(n);return{name:/filename="([^"]*)"/.exec(e.headers.get("content-disposition")??"")?.[1]??"file",content:await e.blob()}}function Tb(n,e){let t={"content-type":"application/json"};return fetch(`api/${n}`,{method:"POST",headers:t,body:JSON.stringify(e)})}var Oi=(n,e)=>Mc(Tb(n,e)),Pt={start:()=>Mc(fetch("api/start")),check:n=>Oi("check",{text:n}),change:(n,e)=>Oi("change",{text:n,changes:e}),forecast:n=>Oi("forecast",{text:n}),open:n=>Oi("open",{name:n}),template:n=>Oi("template",{name:n}),save:(n,e,t)=>Oi("save",{name:n,text:e,known:t}),run:(n,e,t,i)=>Oi("run",{analysis:n,options:e,text:t,file:i}),cancel:n=>Oi("cancel",{number:n}),compare:(n,e)=>Oi("differences",{first:n,second:e}),export:(n,e)=>Mb(Tb("product",{number:n,...e})),page:n=>Mb(fetch(`api/jobs/${n}/page`)),remove:n=>Oi("remove",{number:n}),design:(n,e)=>Oi("opened",{number:n,point:e}),points:(n,e)=>Mc(fetch(`api/jobs/${n}/points/${e}`)),job:n=>Mc(fetch(`api/jobs/${n}`)),view:async n=>(await fetch(`api/jobs/${n}/view`)).arrayBuffer(),turn:(n,e,t,i,r)=>Oi("run",{analysis:n.analysis,options:n.options,text:e,file:r,steps:t,value:i}),wish:n=>Oi("wish",{path:n}),knobs:n=>Mc(fetch(`api/jobs/${n}/knobs`)),part:async(n,e)=>{let t=await fetch(`api/jobs/${n}/${e}`);return t.ok?Qo.read(await t.arrayBuffer()):null},picture:(n,e)=>`api/jobs/${n}/pictures/${encodeURIComponent(e)}`},b2=2e3;function Km(n,e){let t=new WebSocket(`ws://${location.host}/api/live`);t.onopen=()=>e(!1),t.onmessage=i=>n(JSON.parse(String(i.data)).jobs),t.onclose=()=>{e(!0),setTimeout(()=>Km(n,e),b2)}}var S2=250,M2=800,w2=300,wt=pe(""),$i=pe({}),zr=pe(!1),Df=pe(null),Yn=pe([]),us=pe([]),vi=pe(null),nl=pe([]),Vr=pe(null),tl=pe(null),el=pe([]),Nf=pe([]),Ro=xt(()=>wt.value!==(tl.value??"")),Ab=xt(()=>el.value.length>0),Cb=xt(()=>Nf.value.length>0),Zm=0,Uf="",Jm=0,jm=-1/0,Eb=Promise.resolve();function wc(n){Zm+=1,Uf=n.text,zr.value=n.values===null&&wt.peek().trim()!=="",zr.value||($i.value=n.values??{}),Df.value=n.plate,Yn.value=n.problems,us.value=n.remarks}async function ln(n){Vr.value=null;try{await n()}catch(e){if(!(e instanceof Ks))throw e;Vr.value=e.problem??e.message}}var Rb=()=>({text:wt.peek(),values:Uf===wt.peek()&&!zr.peek()?$i.peek():null});function il(n,e=!1){if(n===wt.peek())return;let t=performance.now();!(el.peek().length===0&&wt.peek()==="")&&!(e&&t-jm<M2)&&(el.value=[...el.peek(),Rb()].slice(-w2)),jm=e?t:-1/0,Nf.value=[],wt.value=n}function Qm(n=S2){clearTimeout(Jm),Jm=window.setTimeout(()=>{ln(Pb)},n)}async function Pb(){let n=Zm+=1,e=wt.peek(),t=await Pt.check(e);n===Zm&&wc({...t,text:e})}function Ff(n){il(n,!0),Qm()}function eg(n){il(n),Qm(0)}var ki=(n,e,t=!1)=>{rl(()=>[{steps:n,value:e}],t)};function rl(n,e=!1){return Eb=Eb.then(()=>ln(async()=>{for(;;){Uf!==wt.peek()&&await Pb();let[t,i]=[wt.peek(),n()];if(i.length===0)return;let r=await Pt.change(t,i);if(wt.peek()===t){il(r.text,e),clearTimeout(Jm),wc(r);return}}}))}function Ib(n,e){let t=n.peek().at(-1);t!==void 0&&(n.value=n.peek().slice(0,-1),e.value=[...e.peek(),Rb()],jm=-1/0,wt.value=t.text,t.values!==null&&([$i.value,Uf]=[t.values,t.text]),Qm(0))}var sl=()=>Ib(el,Nf),ol=()=>Ib(Nf,el),Of=n=>ln(async()=>{let e=await Pt.open(n);il(e.text),vi.value=e.name,tl.value=e.text,wc(e)}),Lb=n=>ln(async()=>{let e=await Pt.template(n);il(e.text),vi.value=null,tl.value=null,wc(e)});function Db(n){eg(n),vi.value=tl.value=null}var Nb=(n,e)=>ln(async()=>{let t=await Pt.design(n,e);il(t.text),wc(t)}),Ub=n=>ln(async()=>{let e=wt.peek(),t=await Pt.save(n,e,n===vi.peek()?tl.peek():null);vi.value=t.name,tl.value=e,nl.value=t.files});function On(n){return n.reduce((e,t)=>typeof t=="number"?`${e}[${t+1}]`:e?`${e}.${t}`:t,"")}var kf="completions",T2=14,Gr=pe(null),Zs=pe(0),Fb=pe([]),Ob=pe(""),Bf=xt(()=>Gr.value===null?{from:0,list:[]}:xb(wt.value,Gr.value,Fb.value,Ob.value));function kb(n,e){[Fb.value,Ob.value]=[n,e]}var zf=()=>Gr.value=null;function tg(n){Gr.peek()!==null&&(Gr.value=n.selectionStart,Zs.value=0)}function Bb(n,e){let{list:t}=Bf.peek();if(n.key===" "&&n.ctrlKey)[Gr.value,Zs.value]=[e.selectionStart,0];else{if(Gr.peek()===null||t.length===0)return!1;if(n.key==="ArrowDown"||n.key==="ArrowUp")Zs.value=(Zs.peek()+(n.key==="ArrowDown"?1:t.length-1))%t.length;else if(n.key==="Enter"||n.key==="Tab")zb(e,Zs.peek());else if(n.key==="Escape")zf();else return!1}return n.preventDefault(),!0}function zb(n,e){let{from:t,list:i}=Bf.peek(),r=i[e];r===void 0||Gr.peek()===null||(n.setRangeText(r.insert,t,Gr.peek(),"end"),zf(),Ff(n.value),n.focus())}function Vb(){return{"aria-autocomplete":"list",...Bf.value.list.length>0?{"aria-controls":kf,"aria-activedescendant":`${kf}-${Zs.value}`}:{}}}function Gb({area:n}){let{from:e,list:t}=Bf.value,i=n.current;if(Gr.value===null||i===null)return null;let r=wt.value.slice(0,e).split(`
`),s=i.scrollHeight/wt.value.split(`
`).length,o=i.offsetTop+r.length*s-i.scrollTop+6,a=parseFloat(getComputedStyle(document.documentElement).fontSize),c=i.getBoundingClientRect().top-i.offsetTop+o+T2*a<innerHeight?{top:`${o}px`}:{top:`${o-s-6}px`,transform:"translateY(-100%)"},u=`min(calc(${i.offsetLeft}px + ${(r.at(-1)??"").length}ch), max(0px, 100% - 22rem))`;return h("ul",{id:kf,role:"listbox",tabIndex:0,"aria-label":"Completions",class:"completions",style:{...c,left:u},children:[t.length===0&&h("li",{role:"option","aria-selected":"false",class:"quiet",children:"Nothing fits here."}),t.map(({label:d,detail:f},p)=>h("li",{id:`${kf}-${p}`,role:"option","aria-selected":p===Zs.value,ref:m=>{p===Zs.value&&m?.scrollIntoView({block:"nearest"})},onMouseDown:m=>{m.preventDefault(),zb(i,p)},children:[h("code",{children:d})," ",h("span",{class:"quiet",children:f})]}))]})}var Hb=[{keys:"Ctrl+Space",effect:"list of keys and values that fit at the cursor",actions:{}},{keys:"Ctrl+Z",effect:"undo",actions:{}},{keys:"Ctrl+Shift+Z",effect:"redo",actions:{}}];function Wb(){let n=lt(null),e=lt(null),t=new Set(Yn.value.map(({line:o})=>o)),i=new Set(us.value.map(({line:o})=>o)),r=wt.value.split(`
`).length,s=o=>{n.current!==null&&o!==null&&E2(n.current,o)};return h("div",{class:"editor",children:[h("div",{class:"page",children:[h("ol",{ref:e,"aria-hidden":"true",children:Array.from({length:r},(o,a)=>h("li",{class:t.has(a+1)?"wrong":i.has(a+1)?"doubtful":"",children:a+1}))}),h("textarea",{ref:n,"aria-label":"Text of the study file, TOML","aria-invalid":Yn.value.length>0,value:wt.value,wrap:"off",spellcheck:!1,autocapitalize:"off",autocomplete:"off",...Vb(),onInput:o=>{Ff(o.currentTarget.value),tg(o.currentTarget)},onSelect:o=>tg(o.currentTarget),onBlur:zf,onScroll:o=>{e.current!==null&&(e.current.scrollTop=o.currentTarget.scrollTop)},onKeyDown:o=>{if(Bb(o,o.currentTarget)||!(o.ctrlKey||o.metaKey)||o.altKey)return;let a=o.key.toLowerCase(),l=a==="y"||a==="z"&&o.shiftKey?ol:a==="z"?sl:null;l!==null&&(o.preventDefault(),l())}})]}),h(Gb,{area:n}),h("section",{"aria-label":"Problems","aria-live":"polite",class:"problems",children:[Yn.value.length>0&&h("ul",{children:Yn.value.map(o=>h("li",{children:h(Tc,{problem:o,go:s})}))}),us.value.map(o=>h("p",{class:"doubt",children:[h(qb,{path:o.path,line:o.line,go:s}),": ",o.text]})),Yn.value.length===0&&us.value.length===0&&wt.value!==""&&h("p",{class:"quiet",children:"The study has no problem."}),wt.value===""&&h("p",{children:"Choose a template or open a study above, or write here."})]})]})}function qb({path:n,line:e,go:t}){let i=e===null?n:`line ${e}${n?`, ${n}`:""}`;return e===null?h("b",{children:i}):h("button",{type:"button",class:"minor",onClick:()=>t(e),children:i})}function Tc({problem:n,go:e=()=>{}}){return h("div",{class:"parts",children:[h("p",{children:[h(qb,{path:n.path||n.argument,line:n.line,go:e}),": got ",n.given]}),h("dl",{children:[h("dt",{children:"allowed"}),h("dd",{children:n.allowed}),h("dt",{children:"likely cause"}),h("dd",{children:n.cause}),h("dt",{children:"next step"}),h("dd",{children:n.next_step})]})]})}function E2(n,e){let t=n.value.split(`
`),i=t.slice(0,e-1).join(`
`).length+(e>1?1:0);n.focus(),n.setSelectionRange(i,i+(t[e-1]?.length??0));let r=n.scrollHeight/Math.max(t.length,1);n.scrollTop=Math.max(0,(e-4)*r)}var hi=pe([]),ng=pe(!1),rn=pe(null),fi=pe(null),Vf=pe(!0),Xb=xt(()=>hi.value.find(({number:n})=>n===fi.value?.number)),Gf={job:0},$b=pe(0),Yb=()=>hi.value.find(n=>n.state==="running"),Kb=(n,e)=>n.seconds+Math.max(0,e-$b.value)/1e3;function Zb(){Km(n=>{let e=n.at(-1);e&&rn.peek()===null&&(rn.value=e.number),$b.value=performance.now(),hi.value=n},n=>ng.value=n),et(()=>{rn.value!==null&&(Vf.value=!1)}),et(()=>{let n=hi.value.find(t=>t.number===rn.value);if(n===void 0||n.state==="running")return;let e=fi.peek();e?.number===n.number&&e.state===n.state||ln(async()=>{let t=await Pt.job(n.number);rn.peek()===t.number&&(fi.value=t)})})}var Jb=(n,e)=>ln(async()=>{let{number:t}=await Pt.run(n,e,wt.peek(),vi.peek());rn.value=Gf.job=t}),jb=n=>ln(async()=>{rn.peek()===n&&(rn.value=fi.value=null),await Pt.remove(n)}),Qb=n=>ln(async()=>{await Pt.cancel(n)});var A2=150,fs=pe([]),tS=pe(""),dr=pe(null),Po=pe({}),sg=pe(null),Io=xt(()=>fs.value.find(({path:n})=>n===tS.value)??fs.value[0]),og=xt(()=>Po.value[Io.value?.path??""]!==void 0),Ec=xt(()=>dr.value!==null||wt.value===fi.value?.text),nS=xt(()=>{let[n,e]=[dr.value,Io.value];return n===null||e===void 0?null:sg.value?.at===n?{data:sg.value.data,at:null}:{data:Po.value[e.path]?.data??null,at:n*e.scale}}),Ac=({unit:n},e)=>`${Number(e.toPrecision(9))} ${n}`.trim(),iS=(n,e)=>n.unit?Ac(n,e):Number(e.toPrecision(9)),eS=0,Hf=null,ig=!1,hs={job:0,path:"",at:0};function rS(n){tS.value=n,ln(async()=>{await Pt.wish(n)})}function sS(n,e){dr.value=e,clearTimeout(eS),eS=window.setTimeout(()=>{Hf={of:n,value:e},ln(C2)},A2)}var oS=(n,e)=>ki(n.steps,iS(n,e),!0);async function C2(){if(!ig){ig=!0;try{for(;Hf!==null;){let[{of:n,value:e},t]=[Hf,fi.peek()];if(Hf=null,t===null)return;let{number:i}=await Pt.turn(t,wt.peek(),n.steps,iS(n,e),vi.peek());hs={job:i,path:n.path,at:e},rn.value=i}}catch(n){throw dr.value=null,n}finally{ig=!1}}}var rg=0,aS=n=>n.turned&&rg>0?rg:rg=n.number;function lS(n){(n!==hs.job||dr.peek()===hs.at)&&(dr.value=null)}function cS(){let n=new Set,e=(t,i)=>{n.has(t)||(n.add(t),ln(i))};et(()=>{let t=fi.value;if(t===null)return;let i=t.number===hs.job;e(`end ${t.number}`,async()=>{Po.value=i?Object.fromEntries(Object.entries(Po.peek()).filter(([r])=>r===hs.path)):{},fs.value=t.view?fs.peek().map(r=>i&&r.path===hs.path?{...r,value:hs.at}:r):[],t.view||(dr.value=null)})}),et(()=>{let t=hi.value.find(({number:a})=>a===hs.job);t?.first&&t.state==="running"&&e(`first ${t.number}`,async()=>{let{job:a,at:l}=hs,c=await Pt.part(t.number,"first");c!==null&&a===t.number&&(sg.value={at:l,data:c})});let i=hi.value.find(({number:a})=>a===fi.value?.number);if(!i?.turns)return;e(`knobs ${i.number}`,async()=>{let a=await Pt.knobs(i.number);fi.peek()?.number===i.number&&(fs.value=a)});let r=fs.value.findIndex(a=>a===Io.value),s=Io.value?.path??"",o=i.previews[s]??0;o>0&&n.has(`knobs ${i.number}`)&&e(`preview ${i.number} ${o} ${s}`,async()=>{let a=await Pt.part(i.number,`previews/${r}`),l=Po.peek()[s],c=l!==void 0&&l.job===i.number&&l.count>=o;a!==null&&fi.peek()?.number===i.number&&!c&&(Po.value={...Po.peek(),[s]:{job:i.number,count:o,data:a}})})})}var uS={turned:nS,controls:h(R2,{}),design:()=>Object.fromEntries(fs.value.map(n=>[n.title,Ac(n,n===Io.value?dr.value??n.value:n.value)]))};function R2(){let n=Io.value;if(n===void 0)return h("p",{class:"quiet",children:Xb.value?.archived?"Compute this again to turn its numbers.":"Sliders for its numbers follow in a moment."});let e=dr.value??n.value;return h("div",{class:"turning","data-prepared":og.value,children:[h("label",{children:["Turn"," ",h("select",{value:n.path,disabled:dr.value!==null,onChange:t=>rS(t.currentTarget.value),children:fs.value.map(({path:t,title:i})=>h("option",{value:t,children:i}))})]}),h("input",{type:"range","aria-label":n.unit?`${n.title}, ${n.unit}`:n.title,"aria-valuetext":Ac(n,e),min:n.low,max:n.high,step:n.step,value:e,disabled:!Ec.value,onInput:t=>sS(n,Number(t.currentTarget.value)),onChange:t=>oS(n,Number(t.currentTarget.value))}),h("output",{children:Ac(n,e)}),Ec.value?!og.value&&h("span",{class:"quiet state",children:"Its preview follows in a moment."}):h("span",{class:"quiet state",children:"The study has changed: compute it first."})]})}function Wf({table:n}){let e=n.count-n.rows.length;return h("div",{class:"wide",tabIndex:0,role:"group","aria-label":n.title,children:[h("table",{children:[h("caption",{children:n.title}),h("thead",{children:h("tr",{children:n.head.map(t=>h("th",{scope:"col",children:t}))})}),h("tbody",{children:[n.rows.length===0&&h("tr",{children:h("td",{colSpan:n.head.length,children:"none"})}),n.rows.map((t,i)=>h("tr",{class:n.strong.includes(i)?"strong":"",children:t.map((r,s)=>h("td",{class:n.numeric[s]?"number":"",children:r}))}))]})]}),e>0&&h("p",{class:"quiet",children:["and ",e," more rows, in the files of the command"]})]})}var hS="folder ",P2="page ";function fS({job:n,answer:e,exports:t}){let[i,r]=Lt(hS),[s,o]=Lt(""),[a,l]=Lt(Object.keys(t.looks)[0]??""),[c,u]=Lt(!1),[d,f]=[i.slice(0,i.indexOf(" ")),i.slice(i.indexOf(" ")+1)],p=d==="picture"?t.pictures:d==="table"?t.tables:[],m=p.includes(s)?s:p[0]??"",x=()=>ln(async()=>{u(!0);try{let g={kind:d,name:f,form:m,...d==="picture"?{style:a}:{}},b=await(d==="page"?Pt.page(n.number):Pt.export(n.number,g));Su(b.content,b.name)}finally{u(!1)}}),_=(g,b,A)=>A.length>0&&h("optgroup",{label:g,children:A.map(S=>h("option",{value:`${b} ${S}`,children:S}))});return h("div",{class:"row",role:"group","aria-label":"Save the result",children:[h("label",{children:["Save",h("select",{value:i,onChange:g=>r(g.currentTarget.value),children:[h("option",{value:hS,children:"everything, as one zip"}),n.view&&h("option",{value:P2,children:"the interactive page, as one HTML file"}),_("Pictures","picture",e.pictures.map(g=>g.name)),_("Tables","table",e.tables.map(g=>g.title)),_("Files","file",e.files)]})]}),p.length>0&&h("label",{children:["Format",h("select",{value:m,onChange:g=>o(g.currentTarget.value),children:p.map(g=>h("option",{children:g}))})]}),d==="picture"&&h("label",{children:["Style",h("select",{value:a,onChange:g=>l(g.currentTarget.value),children:Object.entries(t.looks).map(([g,b])=>h("option",{value:g,children:b}))})]}),h("button",{type:"button",disabled:c,onClick:()=>{x()},children:c?"The file is made":"Save file"})]})}function dS({exports:n}){let e=fi.value,t=lt(null);return Ut(()=>{e===null||e.number!==Gf.job||(Gf.job=0,t.current?.scrollIntoView())},[e?.number]),e===null?null:h("section",{ref:t,id:"result",class:"result","aria-label":`Result of ${e.analysis}`,children:[!Ec.value&&h("p",{class:"notice",children:["This result belongs to another version of the study."," ",h("button",{type:"button",onClick:()=>eg(e.text),children:"Show that version"})]}),e.state==="cancelled"&&h("p",{children:["The computation of ",e.analysis," was cancelled."]}),e.error!==null&&h(Ct,{children:[h("h2",{children:["No result of ",e.analysis]}),h(Tc,{problem:{...e.error,path:e.error.argument,line:null}})]}),e.answer!==null&&h(I2,{job:e,answer:e.answer,exports:n},aS(e))]})}function I2({job:n,answer:e,exports:t}){return h(Ct,{children:[n.view?h(D2,{number:n.number}):h(L2,{answer:e}),e.remarks.map(i=>h("p",{class:"doubt",children:i})),h(fS,{job:n,answer:e,exports:t}),h("dl",{class:"repeat",children:[h("dt",{children:"The same as a command"}),h("dd",{children:h("code",{children:n.command})}),h("dt",{children:"in Python"}),h("dd",{children:h("code",{children:n.python})})]}),e.tables.length>0&&h("details",{class:"section",open:!n.view,children:[h("summary",{children:"Tables"}),e.tables.map(i=>h(Wf,{table:i}))]}),h(N2,{job:n,answer:e})]})}function L2({answer:n}){return h("header",{children:[h("h2",{children:n.title}),h("p",{class:"origin",children:n.origin}),n.summary.map(e=>h("p",{children:e}))]})}function D2({number:n}){let e=lt(null),[t,i]=Lt(""),r=lt(()=>{});return Ut(()=>()=>r.current(),[]),Ut(()=>{let s=!1;return Pt.view(n).then(o=>{s||e.current===null||(r.current=yb(Qo.read(o),e.current,uS),lS(n))},()=>i("The view cannot be loaded: the server does not answer.")),()=>{s=!0}},[n]),h(Ct,{children:[t&&h("p",{role:"alert",children:t}),h("div",{ref:e})]})}function N2({job:n,answer:e}){let t=hi.value.find(({number:r})=>r===n.number)??n;if(e.pictures.length===0)return null;let i=e.pictures.filter(({name:r})=>t.pictures.includes(r));return h("details",{class:"section",open:!n.view,children:[h("summary",{children:"Pictures"}),h("div",{class:"pictures",children:i.map(({name:r,caption:s})=>h("figure",{children:[h("img",{src:Pt.picture(n.number,r),alt:s||r,loading:"lazy"}),h("figcaption",{children:s})]},r))}),i.length<e.pictures.length&&h("p",{class:"quiet",children:t.drawn?`${e.pictures.length-i.length} pictures were left out, because another computation began.`:"Pictures are drawn."})]})}var Lo=pe(null),qf=pe(null);function pS(){et(()=>{let[n,e]=[Lo.value,rn.value],t=i=>hi.value.some(r=>r.number===i&&r.state==="done");if(t(n)||(Lo.value=null),n===e||!t(n)||!t(e)){qf.value=null;return}ln(async()=>{let i=await Pt.compare(n,e);Lo.peek()===n&&rn.peek()===e&&(qf.value=i)})})}function mS(){if(qf.value===null)return null;let{runs:n,tables:e}=qf.value;return h("section",{class:"section","aria-labelledby":"comparison-title",children:[h("h2",{id:"comparison-title",children:n.map(({name:t})=>t).join(" and ")}),h("div",{class:"sides-by-side",children:n.map(({name:t,title:i,summary:r})=>h("div",{children:[h("h3",{children:[t," ",h("span",{class:"quiet",children:i})]}),r.map(s=>h("p",{children:s}))]}))}),e.map(t=>h(Wf,{table:t})),h("p",{class:"quiet",children:"Bold differences exceed the sum of both errors. Equal numbers are left out."}),h("button",{type:"button",onClick:()=>Lo.value=null,children:"Close the comparison"})]})}var ag={running:"is computed",done:"",failed:"failed",cancelled:"cancelled"};function gS(){let n=[...hi.value].reverse();return h(Ct,{children:[h("p",{class:"hidden",role:"status",children:n[0]===void 0?"":`${n[0].analysis} ${ag[n[0].state]||"is finished"}`}),n.length>0&&h("details",{class:"section",children:[h("summary",{children:["Runs ",h("span",{class:"quiet",children:[n.length," in this folder"]})]}),h("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Runs",children:h("table",{children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"run"}),h("th",{scope:"col",children:"study"}),h("th",{scope:"col",children:"file"}),h("th",{scope:"col",children:"begun"}),h("th",{scope:"col",children:"took"}),h("th",{scope:"col",colSpan:2,children:h("span",{class:"hidden",children:"compare and remove"})})]})}),h("tbody",{children:n.map(e=>h(U2,{job:e},e.number))})]})})]})]})}function U2({job:n}){let e=`${n.number}. ${n.analysis}`;return h("tr",{children:[h("td",{children:h("button",{type:"button",class:"minor","aria-pressed":rn.value===n.number,onClick:()=>rn.value=n.number,children:[e," ",ag[n.state]&&`(${ag[n.state]})`]})}),h("td",{class:"study-title",children:n.title||"-"}),h("td",{children:n.file}),h("td",{class:"number",children:F2(n.started)}),h("td",{class:"number",children:n.state==="running"?"":`${Math.round(n.seconds)} s`}),h("td",{children:n.state==="done"&&n.number!==rn.value&&h("button",{type:"button",class:"minor","aria-pressed":Lo.value===n.number,onClick:()=>Lo.value=n.number,"aria-label":`Compare the shown run with ${e}`,children:"Compare"})}),h("td",{children:n.state!=="running"&&h("button",{type:"button",class:"minor",onClick:()=>{jb(n.number)},"aria-label":`Remove ${e}`,children:"Remove"})})]})}var F2=n=>new Date(1e3*n).toLocaleString([],{dateStyle:"short",timeStyle:"short"});function _S({analyses:n}){let[e,t]=Lt(n.find(({interactive:u})=>u)?.name??n[0]?.name??""),[i,r]=Lt({}),s=n.find(u=>u.name===e),o=Yb();if(s===void 0)return null;let a=Yn.value.length>0||zr.value||wt.value.trim()==="",l=i[e]??{},c=(u,d)=>r({...i,[e]:{...l,[u]:d}});return h("section",{class:"compute","aria-labelledby":"compute-title",children:[h("h2",{id:"compute-title",children:"Compute"}),h("div",{class:"row",children:[h("label",{children:["Analysis",h("select",{value:e,onChange:u=>t(u.currentTarget.value),children:n.map(u=>h("option",{children:u.name}))})]}),h("button",{type:"button",class:"main",disabled:a,onClick:()=>{Jb(e,l)},children:["Compute ",e]}),o!==void 0&&h("button",{type:"button",onClick:()=>{Qb(o.number)},children:"Cancel"}),fi.value!==null&&h("a",{href:"#result",children:"Go to the result"}),a&&h("span",{class:"quiet",children:"The study has problems, or is empty."})]}),h("p",{class:"quiet",children:s.help}),s.options.length>0&&h("div",{class:"fields",children:s.options.map(u=>h(O2,{option:u,value:l[u.name],set:d=>c(u.name,d)},`${e}-${u.name}`))}),o!==void 0&&!o.turned&&h(B2,{job:o}),h(gS,{})]})}function O2({option:n,value:e,set:t}){let i=`option-${n.name}`,r=n.name.replaceAll("_"," "),s={id:i,"aria-describedby":`${i}-help`},o=e??n.default??"";return h("div",{class:"field given",children:[n.form==="bool"?h("label",{class:"check",children:[h("input",{...s,type:"checkbox",checked:o===!0,onChange:a=>t(a.currentTarget.checked)}),r]}):h(Ct,{children:[h("label",{for:i,children:[r,n.unit&&h("span",{class:"quiet",children:[" with unit, such as 1 ",n.unit]})]}),n.form==="choice"?h("select",{...s,value:String(o),onChange:a=>t(a.currentTarget.value),children:n.choices.map(a=>h("option",{children:a}))}):h("input",{...s,type:"text",inputMode:n.form==="int"||n.form==="float"?"decimal":"text",value:String(o),onChange:({currentTarget:{value:a}})=>t(n.form==="int"||n.form==="float"?k2(a):a)})]}),h("p",{id:`${i}-help`,class:"help",children:n.help})]})}var k2=n=>n.trim()===""||Number.isNaN(Number(n))?n:Number(n);function B2({job:n}){let[e,t]=Lt(performance.now());Ut(()=>{let a=setInterval(()=>t(performance.now()),1e3);return()=>clearInterval(a)},[]);let[i,r,s]=n.progress,o=r>0?{value:i,max:r}:{};return h("div",{class:"running",children:[h("progress",{...o,"aria-label":`Computing ${n.analysis}`}),h("p",{children:[`Computing ${n.analysis}${r>0?`: ${i} of ${r}`:""}${s&&` (${s})`}, `,Math.floor(Kb(n,e))," s."," ",h("span",{class:"quiet",children:n.cost})]})]})}function yS(n){let e=[],t=new Map;for(let i of n){let r=i.path.lastIndexOf("."),s={key:i,name:i.path.slice(r+1),inside:[]};t.set(i.path,s),((r<0?void 0:t.get(i.path.slice(0,r).replace(/\[\]$/,"")))?.inside??e).push(s)}return e}var Xf=({key:n})=>["table","tables","entries"].includes(n.kind),vS=/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;function Cc(n,e){let t=e.trim().replace(/^"([^"]*)"$/,"$1");if(t==="")return null;switch(n.kind){case"integer":return Number.isSafeInteger(Number(t))&&/^[+-]?\d+$/.test(t)?Number(t):t;case"number":case"entries":return vS.test(t)&&!n.unit?Number(t):t;case"quantities":return t.split(",").map(i=>n.unit||!vS.test(i.trim())?i.trim():Number(i));case"text":return e;default:return t}}function pr(n){return n===void 0?"":Array.isArray(n)?n.map(pr).join(", "):typeof n=="object"?"":String(n)}function xS(n){return[n.help,n.kind==="quantities"?"Commas between the values.":"",n.example?`For example ${n.example}.`:"",n.bounds?`${n.bounds[0]?.toUpperCase()}${n.bounds.slice(1)}.`:"",n.typical?`Usual: ${n.typical}.`:""].filter(Boolean).join(" ")}function bS(){let n=lt(null),e=()=>{n.current?.open||n.current?.showModal()};return Ut(()=>{let t=[{keys:"?",effect:"this list",actions:{"?":e}}],i=r=>wr(r,t);return document.addEventListener("keydown",i),()=>document.removeEventListener("keydown",i)},[]),h(Ct,{children:[h("button",{type:"button",onClick:e,"aria-keyshortcuts":"?",children:"Keys"}),h("dialog",{ref:n,"aria-label":"Keys of the page",children:[jo.value.map(({title:t,keys:i})=>h(Al,{title:t,keys:i})),h("p",{class:"quiet",children:"Keys of a part work while it has the focus."}),h("button",{type:"button",onClick:()=>n.current?.close(),children:"Close"})]})]})}var lg="#study=",cg=1e5,SS=1e6;async function z2(n){let e=new Blob([n]).stream().pipeThrough(new CompressionStream("deflate-raw")),t=new Uint8Array(await new Response(e).arrayBuffer()),i="";for(let s of t)i+=String.fromCharCode(s);let r=btoa(i).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}${lg}${r}`}async function V2(n){if(n.length>cg)throw new Error(`it has more than ${cg} letters`);let e=Uint8Array.from(atob(n.replaceAll("-","+").replaceAll("_","/")),o=>o.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader(),i=new TextDecoder("utf-8",{fatal:!0}),[r,s]=["",0];for(;;){let{done:o,value:a}=await t.read();if(o)return r+i.decode();if(s+=a.length,s>SS)throw await t.cancel(),new Error(`the study in it has more than ${SS} bytes`);r+=i.decode(a,{stream:!0})}}async function ug(){if(!location.hash.startsWith(lg))return;let n=location.hash.slice(lg.length);history.replaceState(null,"",location.pathname);try{let e=await V2(n);if(e===wt.peek()||Ro.peek()&&!confirm("The link has another study. Leave the text that is not saved? Undo brings it back."))return;Db(e)}catch(e){Vr.value=G2(`${n.slice(0,40)}${n.length>40?"...":""}`,e)}}function G2(n,e){return{code:"malformed",argument:"link",given:n,allowed:'a link that "Copy link" has made',cause:e instanceof Error&&e.constructor===Error?e.message:"the link is damaged or incomplete",next_step:"copy the link again, or open the file of the study",path:"",line:null}}async function MS(){let n=await z2(wt.peek());if(n.length>cg)return"The study is too long for a link. Send its file.";try{return await navigator.clipboard.writeText(n),"The link is copied. It contains the whole study."}catch{return prompt("Copy this link. It contains the whole study.",n),""}}var hg=".toml";function wS({start:n}){let[e,t]=Lt(null),[i,r]=Lt(""),s=e??vi.value??"",o=()=>!Ro.peek()||confirm("The study has changes that are not saved. Leave them? Undo brings them back.");return h("header",{class:"bar",children:[h("div",{class:"row",children:[h("h1",{children:"haptonic studio"}),h("label",{children:["New, from a template",h("select",{value:"",onChange:a=>{let l=a.currentTarget.value;a.currentTarget.value="",t(null),l&&o()&&Lb(l)},children:[h("option",{value:"",children:"choose"}),Object.entries(n.templates).map(([a,l])=>h("option",{value:a,title:l,children:a}))]})]}),h("label",{children:["Open, in ",n.folder,h("select",{value:vi.value??"",onChange:a=>{let l=a.currentTarget.value;a.currentTarget.value=vi.peek()??"",t(null),l&&o()&&Of(l)},children:[h("option",{value:"",children:nl.value.length>0?"choose":"no study yet"}),nl.value.map(a=>h("option",{children:a}))]})]}),h("form",{class:"row",onSubmit:a=>{a.preventDefault();let l=s.trim();l!==""&&(Ub(l.endsWith(hg)?l:`${l}${hg}`),t(null))},children:[h("label",{children:["File name",h("input",{value:s,placeholder:`my${hg}`,spellcheck:!1,autocomplete:"off",onInput:a=>t(a.currentTarget.value)})]}),h("button",{type:"submit",disabled:s.trim()==="",children:"Save"})]}),h("button",{type:"button",disabled:!Ab.value,onClick:sl,children:"Undo"}),h("button",{type:"button",disabled:!Cb.value,onClick:ol,children:"Redo"}),h("button",{type:"button",disabled:wt.value==="",onClick:()=>{MS().then(r)},children:"Copy link"}),h(bS,{}),h("span",{class:"quiet",role:"status",children:i}),h("span",{class:"quiet",role:"status",children:Ro.value?"not saved":vi.value===null?"":"saved"})]}),Vr.value!==null&&h("div",{class:"notice",role:"alert",children:[typeof Vr.value=="string"?h("p",{children:Vr.value}):h(Tc,{problem:Vr.value}),h("button",{type:"button",class:"minor",onClick:()=>Vr.value=null,children:"Close"})]})]})}function TS({branch:{key:n},steps:e,value:t}){let i=On(e),r=Yn.value.filter(c=>c.path===i||c.path.startsWith(`${i}[`)),s=us.value.filter(c=>c.path===i||c.path.startsWith(`${i}[`)),o=`key-${i}`,a={id:o,"aria-describedby":`${o}-about`,"aria-invalid":r.length>0,"aria-required":n.required},l=c=>{c!==pr(t)&&ki(e,Cc(n,c))};return h("div",{class:`field${r.length>0?" wrong":""}${t!==void 0?" given":""}`,children:[h("label",{for:o,children:[n.title,n.unit&&n.kind!=="quantities"&&h("span",{class:"quiet",children:" with unit"}),n.required&&t===void 0&&h("span",{class:"quiet",children:" (required)"})]}),n.kind==="boolean"?h("select",{...a,value:pr(t),onChange:c=>ki(e,W2(c.currentTarget.value)),children:[h("option",{value:"",children:[n.default," (default)"]}),h("option",{children:"true"}),h("option",{children:"false"})]}):n.closed?h("select",{...a,value:pr(t),onChange:c=>l(c.currentTarget.value),children:[h("option",{value:"",children:n.default?`${n.default} (default)`:"not given"}),n.names.map(c=>h("option",{children:c})),t!==void 0&&!n.names.includes(pr(t))&&h("option",{children:pr(t)})]}):h(q2,{...a,value:pr(t),lines:H2(t),set:l,placeholder:n.default,names:[...n.names,...n.numbers]}),h("div",{id:`${o}-about`,children:[r.map(c=>h("p",{class:"problem",children:[c.cause,"; ",c.next_step]})),s.map(c=>h("p",{class:"doubt",children:c.text})),h("p",{class:"help",children:[xS(n)," ",h("code",{children:i})]})]})]})}var H2=n=>typeof n=="string"&&n.includes(`
`)?Math.min(n.split(`
`).length+1,30):0,W2=n=>n===""?null:n==="true";function q2({value:n,lines:e,set:t,names:i,...r}){let[s,o]=Lt(null),a={...r,value:s??n,spellcheck:!1,autocomplete:"off",onInput:l=>o(l.currentTarget.value),onBlur:()=>{s!==null&&t(s),o(null)}};return e>0?h("textarea",{...a,rows:e,wrap:"off"}):h(Ct,{children:[h("input",{...a,type:"text",list:i.length>0?`${r.id}-names`:void 0,onKeyDown:l=>{l.key==="Enter"&&s!==null&&t(s),l.key==="Escape"&&o(null)}}),i.length>0&&h("datalist",{id:`${r.id}-names`,children:i.map(l=>h("option",{value:l}))})]})}function ES({tree:n}){return h("div",{class:"form",children:[zr.value&&h("p",{class:"problem",role:"status",children:"The text has a mistake in its syntax. The form shows the last values until it is corrected."}),h("fieldset",{disabled:zr.value,children:[h("legend",{class:"hidden",children:"Keys of the study"}),h(fg,{branches:n,steps:[],given:$i.value})]})]})}function fg({branches:n,steps:e,given:t}){let i=n.filter(a=>!Xf(a)),r=({name:a,key:l})=>e.length===0&&!l.required&&t[a]===void 0,s=n.filter(a=>Xf(a)&&r(a)),o=a=>h(X2,{branch:a,steps:[...e,a.name],value:t[a.name]},a.key.path);return h(Ct,{children:[i.length>0&&h("div",{class:"fields",children:i.map(a=>h(TS,{branch:a,steps:[...e,a.name],value:t[a.name]},a.key.path))}),n.filter(a=>Xf(a)&&!r(a)).map(o),s.length>0&&h("details",{class:"further",children:[h("summary",{children:["Further tables ",h("span",{class:"quiet",children:"that the study does not have"})]}),s.map(o)]})]})}function X2({branch:n,steps:e,value:t}){let{key:i}=n,r=On(e),s=Yn.value.filter(u=>u.path===r||u.path.startsWith(`${r}.`)||u.path.startsWith(`${r}[`)),o=s.filter(u=>u.path===r),[a,l]=Lt(null),c=a??(i.required||e.length>1&&t!==void 0);return h("details",{class:"section",open:c,onToggle:({currentTarget:u})=>{u.open!==c&&l(u.open)},children:[h("summary",{children:[i.title,h("span",{class:"quiet",children:[" ",Z2(t)]}),s.length>0&&h("span",{class:"problem",children:[" ",s.length," problem",s.length>1?"s":""]})]}),c&&h("div",{class:"inside",children:[h("p",{class:"quiet",children:[i.help," ",h("code",{children:i.kind==="tables"?`[[${r}]]`:`[${r}]`})]}),o.map(u=>h("p",{class:"problem",children:[u.cause,"; ",u.next_step]})),i.kind==="tables"?h(Y2,{branch:n,steps:e,items:Array.isArray(t)?t:[]}):i.kind==="entries"?h(K2,{branch:n,steps:e,given:pg(t)}):h($2,{branch:n,steps:e,value:t})]})]})}function $2({branch:n,steps:e,value:t}){let{key:i}=n,r=`key-${On(e)}`,s=i.names.length>0,o=s&&(t===void 0||typeof t=="string");return h(Ct,{children:[s&&h("div",{class:"field",children:[h("label",{for:r,children:[i.title,", by name"]}),h("select",{id:r,value:o?pr(t):`
`,onChange:a=>{let l=a.currentTarget.value;ki(e,l===""?null:l===`
`?{}:l)},children:[h("option",{value:"",children:"not given"}),i.names.map(a=>h("option",{children:a})),typeof t=="string"&&!i.names.includes(t)&&h("option",{children:t}),h("option",{value:`
`,children:"other, by its constants"})]})]}),!o&&h(fg,{branches:n.inside,steps:e,given:pg(t)}),t!==void 0&&!i.required&&h(dg,{steps:e,children:["Remove ",i.title.toLowerCase()]})]})}function Y2({branch:n,steps:e,items:t}){let i=n.key.title.toLowerCase();return h(Ct,{children:[t.map((r,s)=>h("fieldset",{class:"item",children:[h("legend",{children:[n.key.title," ",s+1]}),h(fg,{branches:n.inside,steps:[...e,s],given:pg(r)}),h(dg,{steps:[...e,s],children:["Remove ",i," ",s+1]})]},s)),h("button",{type:"button",onClick:()=>ki([...e,t.length],{}),children:["Add to ",i]})]})}function K2({branch:{key:n},steps:e,given:t}){let[i,r]=Lt(""),[s,o]=Lt(""),a=On(e);return h(Ct,{children:[h("ul",{class:"entries",children:Object.entries(t).map(([l,c])=>h("li",{children:[h("label",{for:`key-${a}.${l}`,children:l}),h("input",{id:`key-${a}.${l}`,value:pr(c),onChange:u=>ki([...e,l],Cc(n,u.currentTarget.value))}),h(dg,{steps:[...e,l],children:["Remove ",l]})]},l))}),h("div",{class:"row",children:[h("label",{children:["Name",h("input",{value:i,onInput:l=>r(l.currentTarget.value)})]}),h("label",{children:["Value",h("input",{value:s,onInput:l=>o(l.currentTarget.value)})]}),h("button",{type:"button",disabled:i===""||s==="",onClick:()=>{ki([...e,i],Cc(n,s)),r(""),o("")},children:"Add a line"})]})]})}function dg({steps:n,children:e}){return h("button",{type:"button",class:"minor",onClick:()=>ki(n,null),children:e})}function Z2(n){return n===void 0?"":typeof n=="string"?n:Array.isArray(n)?`${n.length} in the study`:"in the study"}function pg(n){return typeof n=="object"&&!Array.isArray(n)?n:{}}var J2=["plate","map"],j2=["plate","rows"];function AS(n){let{map:e,rows:t}=n;if(typeof e!="string")return null;let i=e.trim().split(/\r?\n/).map(s=>Array.from(s.trim())),r=i[0]?.length??0;return r===0||i.some(s=>s.length!==r)?null:typeof t!="number"||t%i.length!==0||t<=0||t*r>1e5?i:Array.from({length:t},(s,o)=>i[o%i.length]??[])}function CS(n,e){let t=e.rows!==void 0,i=n.map(a=>a.join("")),r=t?Q2(i):i.length,s=`${i.slice(0,r).join(`
`)}
`,o=r<i.length?i.length:null;return[...s.trim()===String(e.map).trim()?[]:[{steps:J2,value:s}],...t&&e.rows!==o?[{steps:j2,value:o}]:[]]}function Q2(n){for(let e=1;e<=n.length/2;e++)if(n.length%e===0&&n.every((t,i)=>t===n[i%e]))return e;return n.length}function RS(n,e,t){let i=new Map;for(let[r,s]of e){let o=i.get(r)??n[r]?.slice();o===void 0||s<0||s>=o.length||(o[s]=t,i.set(r,o))}return n.map((r,s)=>i.get(s)??r)}function mg([n,e],[t,i]){let r=Math.max(Math.abs(t-n),Math.abs(i-e));return Array.from({length:r+1},(s,o)=>{let a=r===0?0:o/r;return[Math.round(n+a*(t-n)),Math.round(e+a*(i-e))]})}function PS([n,e],[t,i]){let r=[];for(let s=Math.min(n,t);s<=Math.max(n,t);s++)for(let o=Math.min(e,i);o<=Math.max(e,i);o++)r.push([s,o]);return r}function gg(n,e){let t=n[e[0]]?.[e[1]],i=n.map(s=>s.map(()=>!1)),r=[];for(let s=[e];;){let o=s.pop();if(o===void 0)return r;let[a,l]=o,c=i[a];c===void 0||c[l]!==!1||n[a]?.[l]!==t||(c[l]=!0,r.push(o),s.push([a-1,l],[a+1,l],[a,l-1],[a,l+1]))}}function IS(n,e,t,i){let[r,s]=[n.length-1,(n[0]?.length??0)-1],o=t?[...e,...e.map(([a,l])=>[a,s-l])]:e;return i?[...o,...o.map(([a,l])=>[r-a,l])]:o}function LS(n,e,t){if(e==="above"||e==="below"){let i=e==="above";if(!t)return n.length===1?n:i?n.slice(1):n.slice(0,-1);let r=(i?n[0]:n.at(-1))??[];return i?[r,...n]:[...n,r]}return n.map(i=>{let r=e==="left";if(!t)return i.length===1?i:r?i.slice(1):i.slice(0,-1);let s=(r?i[0]:i.at(-1))??".";return r?[s,...i]:[...i,s]})}function _g(n,e){let t=e.length>1?(e.at(-1)??1)/(e.length-1):1;return e.length===n+1?e:Array.from({length:n+1},(i,r)=>r*t)}var DS={m:1,cm:.01,mm:.001,um:1e-6,µm:1e-6,nm:1e-9},NS="mm",eD=50;function FS(n){let e=n/eD,t=10**Math.floor(Math.log10(e)+1e-9);return([5,2].find(i=>i*t<=e*(1+1e-9))??1)*t}function Rc(n,e,t,i,r){let s=Math.round(n/i)*i,o=r,a=t.flatMap((l,c)=>[l,(l+(t[c+1]??l))/2]);for(let l of e>0?[0,-e,e]:[0])for(let c of a){let u=Math.abs(n+l-c);u<o&&([s,o]=[c-l,u])}return s}function $f(n,e){let t=/^\s*[-+.\deE]+\s*([a-zµ]+)\s*$/.exec(String(e??""))?.[1]??NS,[i,r]=t in DS?[t,DS[t]??.001]:[NS,.001];return`${Number((n/r).toPrecision(9))} ${i}`}function tD(n,e){let t=n;for(let i of e)t=Array.isArray(t)?t[Number(i)]:t?.[String(i)];return t??{}}var US=n=>Array.isArray(n)?n:[];function OS(n,e,t){let i=tD(t,n.steps),[r,s]=[US(i.centre),US(i.size)],o=e.centre.map((c,u)=>$f(c-n.corner[u],r[u])),a=e.size.map((c,u)=>u<2?$f(c,s[u]):s[u]??""),l=(c,u)=>c.some((d,f)=>d!==u[f]);return[...l(o,r)?[{steps:[...n.steps,"centre"],value:o}]:[],...e.size.length>0&&l(a,s)?[{steps:[...n.steps,"size"],value:a}]:[]]}var js="plate.clamp.corners",cn=pe("brush"),Do=pe(""),vg=pe(!1),yg=pe(!1),mr=pe([0,0]),gr=pe(null),ds=pe([]),di=pe(""),Pc=pe({}),Ic=pe(null),Yf=pe(null),Kf=pe([]),Js=xt(()=>{let n=$i.value.plate;return typeof n=="object"&&!Array.isArray(n)?n:null}),Yi=pe(null);et(()=>{(Df.value!==null||Js.value===null)&&(Yi.value=Df.value)});var BS=n=>typeof n=="object"&&!Array.isArray(n)?Object.entries(n):[],yi=xt(()=>{let n=BS(Js.value?.tiles).map(([i,r])=>({letter:i,name:String(r),isNew:!1})),e=new Set(n.map(({letter:i})=>i)),t=Kf.value.filter(({letter:i})=>!e.has(i)).map(i=>({...i,isNew:!0}));return[...n,...t,{letter:".",name:"no plate",isNew:!1}]}),xg=xt(()=>Js.value===null?null:AS(Js.value)),ei=xt(()=>{let n=Yf.value??xg.value;return n===null||ds.value.length===0?n:RS(n,IS(n,ds.value,vg.value,yg.value),bg())}),ps=xt(()=>(Yi.value?.parts??[]).map(n=>({...n,...Pc.value[On(n.steps)]}))),ms=xt(()=>Ic.value??Yi.value?.clamp??null),zS=xt(()=>Yf.value!==null),bg=()=>yi.value.some(({letter:n})=>n===Do.value)?Do.value:yi.value[0]?.letter??".";et(()=>{Yi.value,Pc.value={},Ic.value=null});var kS=0;function Lc(n){if(ds.value=[],n===null)return;let e=kS+=1;Yf.value=n;let t=new Set(n.flat());rl(()=>[...Kf.peek().filter(({letter:i})=>t.has(i)&&!nD(i)).map(({letter:i,name:r})=>({steps:["plate","tiles",i],value:r})),...CS(n,Js.peek()??{})]).then(()=>{e===kS&&(Yf.value=null)})}var nD=n=>BS(Js.peek()?.tiles).some(([e])=>e===n);function Dc(n){ds.value=n,Lc(ei.peek())}var iD="123456789abcdefghijklmnpqrstuvwxyzABCDEFGHIJKLMNPQRSTUVWXYZ";function VS(n){let e=new Set(yi.peek().map(({letter:i})=>i)),t=Array.from(iD).find(i=>!e.has(i));t!==void 0&&(Kf.value=[...Kf.peek(),{letter:t,name:n}],Do.value=t)}function Zf(n,e){Pc.value={...Pc.peek(),[On(n.steps)]:e}}function Jf(n){let e=Pc.peek()[On(n.steps)];e!==void 0&&rl(()=>OS(n,e,$i.peek()))}var Uo=12,jf=5,rD=5,sD=4,oD=.6,HS=()=>({ink:ze("ink"),rim:ze("paper")});function WS(n,e){let t=Yi.peek(),i=_g(n[0]?.length??1,t?.x??[]),r=_g(n.length,t?.y??[]),[s,o]=[i.at(-1)??1,r.at(-1)??1],a=Math.max(e-2*Uo,50);return{x:i,y:r,scale:Math.min(a/s,oD*innerHeight/o)}}var qS=({x:n,y:e,scale:t})=>[(n.at(-1)??0)*t+2*Uo,(e.at(-1)??0)*t+2*Uo],XS=({y:n,scale:e},[t,i])=>[(t-Uo)/e,(n.at(-1)??0)-(i-Uo)/e];function Qf({x:n,y:e},[t,i]){let r=n.findIndex(o=>o>t)-1,s=e.findIndex(o=>o>i)-1;return r<0||s<0?null:[e.length-2-s,r]}function Sg(n){let e=Yi.value?.lattices??[],i=yi.value.filter(({letter:r,name:s})=>r!=="."&&s!==e[0]).findIndex(r=>r.letter===n);return i<0?"rule":`curve-${i%sD}`}function Mg({x:n,y:e},t){let[i,r]=[n.at(-1)??0,e.at(-1)??0],s=o=>[t,o-t];return[0,r].flatMap(o=>s(i).map(a=>[a,o])).concat([0,i].flatMap(o=>s(r).map(a=>[o,a])))}function $S(n,e,t){let[i,r,s]=[n.getContext("2d"),ei.peek(),Yi.peek()];if(i===null||r===null)return;let o=devicePixelRatio,a=e.y.at(-1)??0,l=([u,d])=>[o*(Uo+u*e.scale),o*(Uo+(a-d)*e.scale)];i.clearRect(0,0,n.width,n.height),aD(i,r,e,l),s!==null&&lD(i,s,r,e,l),cD(i,e,l);let c=[[t&&cn.peek()!=="move"?mr.peek():null,"accent",[]],[gr.peek(),"carrier",[3,3]]];for(let[u,d,f]of c)u!==null&&uD(i,u,e,l,d,f)}function YS([n,e],{x:t,y:i}){let r=i.length-2-n;return[[t[e]??0,i[r+1]??0],[t[e+1]??0,i[r]??0]]}function aD(n,e,t,i){let r=new Map(yi.peek().map(({letter:c})=>[c,ze(Sg(c))]));n.save(),n.globalAlpha=.34,e.forEach((c,u)=>c.forEach((d,f)=>{if(d===".")return;let[[p,m],[x,_]]=YS([u,f],t).map(i);n.fillStyle=r.get(d)??ze("carrier"),n.fillRect(p,m,x-p,_-m)}));let[s,o]=[t.x.length-1,t.y.length-1],[a,l]=[t.x.at(-1)??0,t.y.at(-1)??0];if(a/s*t.scale>=rD){n.globalAlpha=1,n.strokeStyle=ze("rule"),n.lineWidth=1,n.beginPath();let c=[...t.x.map(u=>[[u,0],[u,l]]),...t.y.map(u=>[[0,u],[a,u]])];for(let[u,d]of c)n.moveTo(...i(u)),n.lineTo(...i(d));n.stroke()}n.restore(),n.canvas.dataset.tiles=`${s} x ${o}`}function lD(n,e,t,i,r){let s=xg.peek();if(e.x.length!==i.x.length||e.y.length!==i.y.length)return;let o=a=>{let l=Qf(i,a);return l!==null&&t[l[0]]?.[l[1]]===s?.[l[0]]?.[l[1]]};n.strokeStyle=n.fillStyle=ze("quiet"),n.lineWidth=devicePixelRatio,Ef(n,e.features,r,o),n.stroke(),n.strokeStyle=ze("ink");for(let a of e.plate)Br(n,a,r);Af(n,e.held,r);for(let[a,l]of Object.entries(e.regions))Ja(n,a,l,r,HS())}function cD(n,e,t){let i=cn.peek()==="move";n.lineWidth=1.5*devicePixelRatio;for(let s of ps.peek()){let[o=0,a=0]=s.diameter===null?s.size:[s.diameter,s.diameter],l=$s(s.centre,[o,a]);if(n.save(),n.strokeStyle=ze("ink"),n.fillStyle=ze("gap"),n.beginPath(),s.diameter!==null||o===0){let f=Math.max((s.diameter??0)/2*e.scale,jf)*devicePixelRatio;n.arc(...t(s.centre),f,0,2*Math.PI)}else bc(n,l,t);n.globalAlpha=s.diameter===null?.85:.3,n.fill(),n.globalAlpha=1,n.stroke(),n.restore();let[c,u]=t([s.centre[0],s.centre[1]]),d=o===0?-10:4;Gm(n,s.name,[c,u+d*devicePixelRatio],HS()),i&&On(s.steps)===di.peek()&&GS(n,s.size.length>0?l:[s.centre],t)}let r=ms.peek();i&&r!==null&&di.peek()===js&&GS(n,Mg(e,r),t)}function GS(n,e,t){let i=jf*devicePixelRatio;n.fillStyle=ze("paper"),n.strokeStyle=ze("accent");for(let r of e){let[s,o]=t(r);n.fillRect(s-i,o-i,2*i,2*i),n.strokeRect(s-i,o-i,2*i,2*i)}}function uD(n,e,t,i,r,s){let[[o,a],[l,c]]=YS(e,t).map(i);n.save(),n.strokeStyle=ze(r),n.lineWidth=2.5*devicePixelRatio,n.setLineDash(s.map(u=>u*devicePixelRatio)),n.strokeRect(o,a,l-o,c-a),n.restore()}var hD=800,wg=n=>String(Number(n.toPrecision(3)));function KS(){let[n,e]=[ei.value,Yi.value];if(n===null)return null;let t=new Map;for(let o of n.flat())t.set(o,(t.get(o)??0)+1);let i=e!==null&&e.x.length===(n[0]?.length??0)+1&&e.y.length===n.length+1,r=zS.value||Yn.value.length>0,s=[...yi.value.filter(({letter:o})=>o!==".").map(({letter:o,name:a})=>[a,`${t.get(o)??0} tiles`]),["map",`${n[0]?.length} x ${n.length} tiles`]];return e!==null&&i&&(s.push(["size",`${wg(1e3*(e.x.at(-1)??0))} x ${wg(1e3*(e.y.at(-1)??0))} mm`]),s.push(["contents",e.contents]),e.mass!==null&&s.push(["mass without patches",`${wg(1e3*e.mass)} g`])),h("div",{class:"facts",children:[h(ws,{facts:s}),r&&h("p",{class:"quiet",children:"Size, contents and mass are those of the last map that could be built."}),!r&&e?.remarks.map(o=>h("p",{class:"doubt",children:o}))]})}function ZS(){let[n,e]=Lt(null),t=lt(null),i=lt(!1),r=wt.value;Ut(()=>{let o=setTimeout(async()=>{if(t.current=r,!i.current){for(i.current=!0;t.current!==null;){let a=t.current;t.current=null;try{e({of:a,...await Pt.forecast(a)})}catch{}}i.current=!1}},hD);return()=>clearTimeout(o)},[r]);let s=n===null||n.of!==r;return h("details",{open:!0,children:[h("summary",{children:["Estimated costs ",h("span",{class:"quiet",children:"as orders of magnitude"})]}),s?h("p",{class:"quiet",children:"Estimated again after a moment without changes."}):n.costs.length===0?h("p",{class:"quiet",children:"Not estimated, because the study has a problem."}):h("table",{children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"command"}),h("th",{scope:"col",children:"processor time"}),h("th",{scope:"col",children:"memory"})]})}),h("tbody",{children:n.costs.map(({command:o,time:a,memory:l,refusal:c})=>h("tr",{children:[h("td",{children:["haptonic ",o]}),h("td",{children:c?`refused: ${c}`:a}),h("td",{children:c?"":l})]}))})]})]})}var QS=6,Tg={b:"brush",l:"line",r:"rectangle",f:"fill",v:"move"},fD=10;function eM(n,e){return cn.peek()==="rectangle"?PS(n,e):mg(n,e)}function ed({x:n}){return FS((n.at(-1)??1)/Math.max(n.length-1,1))}function tM(n,e){let t=null,i=()=>{},r=u=>{let d=n.getBoundingClientRect();return XS(e(),[u.clientX-d.left,u.clientY-d.top])},c={pointerdown:u=>{if(u.button!==0)return;let d=r(u);cn.peek()==="move"?[t,i]=pD(e(),d):[t,i]=dD(e(),d),t!==null&&n.setPointerCapture(u.pointerId)},pointermove:u=>t?.(r(u)),pointerup:()=>{t!==null&&i(),t=null},pointercancel:()=>{t=null,ds.value=[]}};for(let[u,d]of Object.entries(c))n.addEventListener(u,d);return()=>{for(let[u,d]of Object.entries(c))n.removeEventListener(u,d)}}var Eg=[null,()=>{}];function dD(n,e){let[t,i]=[Qf(n,e),ei.peek()];if(t===null||i===null)return Eg;if(mr.value=t,gr.value=null,cn.peek()==="fill")return Dc(gg(i,t)),Eg;let r=t;return ds.value=[t],[o=>{let a=Qf(n,o);a===null||a[0]===r[0]&&a[1]===r[1]||(ds.value=cn.peek()==="brush"?[...ds.peek(),...mg(r,a)]:eM(t,a),mr.value=r=a)},()=>Lc(ei.peek())]}function pD(n,e){let t=2*jf/n.scale,i=([d,f])=>Math.hypot(e[0]-d,e[1]-f)<t,r=ps.peek(),s=r.find(d=>On(d.steps)===di.peek());if(s!==void 0&&s.size.length>0){let[d=0,f=0]=s.size,p=$s(s.centre,[d,f]),m=p.findIndex(i),x=p[(m+2)%4];if(m>=0&&x!==void 0)return[_=>Zf(s,gD(s,x,_,n)),()=>Jf(s)]}let o=ms.peek();if(o!==null&&Mg(n,o).some(i))return di.value=js,[d=>nM(_D(d,n),n),iM];let a=[...r].reverse().find(({centre:d,size:f,diameter:p})=>{let[m=0,x=0]=p===null?f:[p,p],[_,g]=[Math.abs(e[0]-d[0]),Math.abs(e[1]-d[1])];return _<Math.max(m/2,t)&&g<Math.max(x/2,t)});if(di.value=a===void 0?"":On(a.steps),a===void 0)return Eg;let[l,c]=[e[0]-a.centre[0],e[1]-a.centre[1]];return[([d,f])=>Zf(a,mD(a,[d-l,f-c],n)),()=>Jf(a)]}function mD(n,[e,t],i){let[r=0,s=0]=n.diameter===null?n.size:[n.diameter,n.diameter],[o,a]=[ed(i),QS/i.scale],l=[Rc(e,r/2,i.x,o,a),Rc(t,s/2,i.y,o,a)];return{...n,centre:l}}function gD(n,[e,t],[i,r],s){let[o,a]=[ed(s),QS/s.scale],[l,c]=[Rc(i,0,s.x,o,a),Rc(r,0,s.y,o,a)],u=[Math.max(Math.abs(l-e),o),Math.max(Math.abs(c-t),o)];return{...n,centre:[(e+l)/2,(t+c)/2],size:[...u,...n.size.slice(2)]}}function _D([n,e],t){let[i,r]=[t.x.at(-1)??0,t.y.at(-1)??0],[s,o]=[Math.min(n,i-n),Math.min(e,r-e)];return Math.max(s,o)}function nM(n,e){let t=ed(e);Ic.value=Math.max(Math.round(n/t)*t,t)}function iM(){let n=Ic.peek();if(n===null)return;let e=["plate","clamp","corners"];rl(()=>{let t=$i.peek().plate;return[{steps:e,value:$f(n,t.clamp?.corners)}]})}function JS(n,[e,t],i){let r=ed(n);if(di.peek()===js){nM((ms.peek()??r)+(e+t)*r,n),iM();return}let s=ps.peek().find(({steps:d})=>On(d)===di.peek());if(s===void 0)return;let[o,a]=s.centre,[l=0,c=0,...u]=s.size;i&&s.size.length===0||(Zf(s,i?{...s,size:[Math.max(l+e*r,r),Math.max(c+t*r,r),...u]}:{...s,centre:[o+e*r,a+t*r]}),Jf(s))}function vD(n,e){let t=ei.peek();if(t===null)return;let[i,r]=mr.peek(),s=(o,a)=>Math.min(Math.max(o,0),a-1);mr.value=[s(i-e,t.length),s(r+n,t[0]?.length??1)]}function yD(){let[n,e,t]=[ei.peek(),mr.peek(),gr.peek()];n===null||cn.peek()==="move"||(cn.peek()==="fill"?Dc(gg(n,e)):cn.peek()==="brush"?Dc([e]):t===null?gr.value=e:(gr.value=null,Dc(eM(t,e))))}function jS(n){let e=[...ps.peek().map(({steps:r})=>On(r)),...Yi.peek()?.clamp?[js]:[]],t=e.length,i=e.indexOf(di.peek())+n;di.value=e[(i%t+t)%t]??"",cn.value="move"}function rM(n){let e=(r,s)=>o=>{let a=o.shiftKey?fD:1;cn.peek()!=="move"?vD(r*a,s*a):JS(n(),[r*a,s*a],!1)},t=r=>()=>{let s=yi.peek()[r];s!==void 0&&(Do.value=s.letter)},i=(r,s)=>()=>{cn.peek()==="move"&&JS(n(),[r,s],!0)};return[{keys:"← → ↑ ↓",effect:"move the cursor, or the selected part; ten steps with Shift",actions:{ArrowLeft:e(-1,0),ArrowRight:e(1,0),ArrowUp:e(0,1),ArrowDown:e(0,-1)}},{keys:"space",effect:"paint; of a line or rectangle first one end, then the other",actions:{" ":yD}},{keys:"1 … 9",effect:"choose a tile, in the order of the palette",actions:Object.fromEntries(Array.from({length:9},(r,s)=>[String(s+1),t(s)]))},{keys:Object.keys(Tg).join(" "),effect:Object.values(Tg).join(", "),actions:Object.fromEntries(Object.entries(Tg).map(([r,s])=>[r,()=>cn.value=s]))},{keys:"n p",effect:"select the next or the previous part",actions:{n:()=>jS(1),p:()=>jS(-1)}},{keys:"+ − > <",effect:"make the selected patch wider, narrower, higher or lower",actions:{"+":i(1,0),"-":i(-1,0),">":i(0,1),"<":i(0,-1)}},{keys:"Esc",effect:"forget the first end",actions:{Escape:()=>gr.value=null}}]}var xD={brush:"Brush",line:"Line",rectangle:"Rectangle",fill:"Fill",move:"Move parts"},bD=["left","right","above","below"],SD={x:[0,1],y:[0,1],scale:1};function sM({first:n}){return Object.keys($i.value).length===0?null:Js.value===null?h("p",{class:"paint",children:[h("button",{type:"button",class:"minor",disabled:zr.value,onClick:()=>ki(["plate"],n),children:"Begin a plate"})," ",h("span",{class:"quiet",children:"of this cell, and paint its map"})]}):h("details",{class:"section paint",open:Vf.value,onToggle:e=>Vf.value=e.currentTarget.open,children:[h("summary",{children:["Map of the plate ",h("span",{class:"quiet",children:"painted with tiles; parts are dragged"})]}),ei.value===null?h("p",{class:"problem",children:"The map can be painted when it has letters, and all its lines are equally long."}):h(MD,{})]})}function MD(){let n=lt(null),e=lt(SD),[t]=Lt(()=>rM(()=>e.current));return Ut(()=>{let i=n.current;if(i===null)return;let r=()=>{let a=ei.peek();if(a===null)return;e.current=WS(a,i.parentElement?.clientWidth??300);let[l,c]=qS(e.current),[u,d]=[l,c].map(f=>Math.round(f*devicePixelRatio));(i.width!==u||i.height!==d)&&([i.width,i.height]=[u??0,d??0],[i.style.width,i.style.height]=[`${l}px`,`${c}px`]),$S(i,e.current,document.activeElement===i)},s=new ResizeObserver(r);i.parentElement!==null&&s.observe(i.parentElement),i.addEventListener("focus",r),i.addEventListener("blur",r);let o=[tM(i,()=>e.current),Zn(r),et(()=>{ei.value,ps.value,cn.value,mr.value,gr.value,di.value,ms.value,yi.value,r()})];return()=>{s.disconnect();for(let a of o)a()}},[]),h("div",{class:"inside",children:[h(wD,{}),h(TD,{}),h("div",{class:"board",children:[h("canvas",{ref:n,tabIndex:0,role:"application","aria-label":"Map of the plate. Arrow keys move, the space bar paints, digits choose a tile.","aria-describedby":"paint-place",onKeyDown:i=>{(i.ctrlKey||i.metaKey)&&i.key.toLowerCase()==="z"?(i.preventDefault(),(i.shiftKey?ol:sl)()):wr(i,t)}}),h("div",{class:"beside",children:[h(ED,{}),h(KS,{}),h(AD,{}),h(CD,{}),h(ZS,{})]})]}),h("details",{children:[h("summary",{children:"Keys on the map"}),h(Al,{keys:t})]})]})}function wD(){let[n,e]=Lt("");return h("div",{class:"row palette",role:"group","aria-label":"Tiles",children:[yi.value.map(({letter:t,name:i})=>h("button",{type:"button",class:"minor","aria-pressed":t===bg()&&cn.value!=="move",onClick:()=>{Do.value=t,cn.peek()==="move"&&(cn.value="brush")},children:[h("span",{class:"swatch",style:{background:t==="."?"none":`var(--${Sg(t)})`},"aria-hidden":"true"}),h("code",{children:t})," ",i]})),h("form",{class:"row",onSubmit:t=>{t.preventDefault(),VS(n.trim()),e("")},children:[h("input",{"aria-label":"Name of a new region or lattice",placeholder:"new tile",size:9,value:n,onInput:t=>e(t.currentTarget.value)}),h("button",{type:"submit",class:"minor",disabled:n.trim()==="",children:"Add"})]})]})}function TD(){let n=[{signal:vg,words:"mirror left and right"},{signal:yg,words:"mirror top and bottom"}];return h("div",{class:"row",role:"group","aria-label":"Tools",children:[Object.entries(xD).map(([e,t])=>h("button",{type:"button",class:"minor","aria-pressed":cn.value===e,onClick:()=>cn.value=e,children:t})),n.map(({signal:e,words:t})=>h("label",{class:"check",children:[h("input",{type:"checkbox",checked:e.value,onChange:i=>e.value=i.currentTarget.checked}),t]}))]})}function ED(){let n=ps.value.find(({steps:l})=>On(l)===di.value),e=l=>Number((1e3*l).toPrecision(6)),[t,i]=mr.value,r=ei.value?.[t]?.[i],s=yi.value.find(l=>l.letter===r)?.name??"",o=n!==void 0&&n.size.length>0?`, ${n.size.slice(0,2).map(e).join(" x ")} mm`:"",a=cn.value!=="move"?`Row ${t+1} from above, column ${i+1}: ${r??""} ${s}${gr.value===null?"":"; the first end is chosen"}`:n!==void 0?`${n.name}: centre at ${n.centre.map(e).join(" and ")} mm on the plate${o}`:di.value===js&&ms.value!==null?`Corners supported over ${e(ms.value)} mm`:"Select a part in the drawing, or with the key n.";return h("p",{id:"paint-place",class:"small","aria-live":"polite",children:a})}function AD(){let n=(e,t)=>{let i=ei.peek();i!==null&&Lc(LS(i,e,t))};return h("div",{class:"row",role:"group","aria-label":"Size of the map",children:bD.map(e=>h("span",{children:[e," ",h("button",{type:"button",class:"minor","aria-label":`Add a line ${e}`,onClick:()=>n(e,!0),children:"+"})," ",h("button",{type:"button",class:"minor","aria-label":`Remove a line ${e}`,onClick:()=>n(e,!1),children:"−"})]}))})}function CD(){let n=({path:e})=>e==="plate"||e.startsWith("plate.");return h("div",{"aria-live":"polite",children:[Yn.value.filter(n).map(({path:e,cause:t,next_step:i})=>h("p",{class:"problem",children:[h("code",{children:e}),": ",t,"; ",i]})),us.value.filter(n).map(({path:e,text:t})=>h("p",{class:"doubt",children:[h("code",{children:e}),": ",t]}))]})}var oM=`.paint .inside { padding-bottom: 0.6rem; }
.paint .row { align-items: center; }
.paint .row label.check { flex-direction: row; align-items: center; gap: 0.4rem; }
.paint .board { display: flex; flex-wrap: wrap; gap: 0.5rem 1rem; margin: 0.5rem 0; }
.paint .beside { flex: 1 1 9rem; min-width: 0; }
.paint table { font-size: 0.85rem; }
.paint th, .paint td { padding-right: 0.5rem; }
.paint .beside p { margin: 0 0 0.4rem; }
.paint canvas { display: block; max-width: 100%; touch-action: none; background: var(--paper); cursor: crosshair; }
.paint .swatch {
  display: inline-block; width: 0.9em; height: 0.9em; border: 1px solid var(--quiet); opacity: 0.6; vertical-align: -0.08em;
}
.paint details > summary { cursor: pointer; padding: 0.2rem 0; }
.paint .inside > details > summary { font-weight: normal; }
.paint .problem, .paint .doubt { margin: 0.3rem 0; overflow-wrap: anywhere; }
.palette button { max-width: 100%; overflow-wrap: anywhere; }
.palette form.row { margin: 0; }
`;var Fo="order of computation",aM="",un=pe([]),al=pe(aM),id=pe(null),Ki=pe(null),Ag=null,td=!1,Qs=xt(()=>un.value.map((n,e)=>e).filter(n=>!al.value||un.value[n]?.group===al.value)),rd=xt(()=>[...new Set(un.value.map(n=>n.group))]),nd=xt(()=>{let n=Qs.value.map(e=>(un.value[e]?.varied??[]).map(({title:t})=>t));return[...new Set(n[0])].filter(e=>n.every(t=>t.includes(e)))}),ll=xt(()=>{let n=id.value;return n!==null&&(n===Fo||nd.value.includes(n))?n:nd.value[0]??Fo});function lM(){et(()=>{let n=hi.value.find(({number:e})=>e===rn.value);rn.value!==Ag&&(Ag=rn.value,un.value=[],Ki.value=id.value=null,al.value=aM),n!==void 0&&n.points>un.value.length&&PD(n.number)})}async function PD(n){td||(td=!0,await ln(async()=>{let e=un.peek().length,t=await Pt.points(n,e);td=!1,n===Ag&&e===un.peek().length&&(un.value=[...un.peek(),...t])}),td=!1)}var Nc=(n,e,t)=>t===Fo?e+1:n.varied.find(i=>i.title===t)?.value??NaN,ID=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"]],LD=["Hz","m","Pa"];function sd(n,e){let t=Math.max(...n.map(Math.abs),0);if(e==="rad")return{factor:180/Math.PI,unit:"deg"};let[i,r]=ID.find(([s])=>LD.includes(e)&&t>=s)??[1,""];return{factor:1/i,unit:r+e}}function od({value:n,unit:e,error:t},i){let r=sd([n],e),s=n*r.factor;return`${i&&t!==null?Hn(s,t*r.factor):String(Number(s.toPrecision(i?4:6)))} ${r.unit}`.trim()+(i&&t===null?" (preview)":"")}var DD=280,ND=3.5,UD=20,FD=4;function ad(){let n=Qs.value,e=ll.value,t=n.flatMap(u=>un.value[u]?.results??[]),i=t[0]?.unit??"",r=[...new Set(t.filter(u=>u.unit===i).map(u=>u.title))],s=n.map(u=>Nc(un.value[u],u,e)),o=un.value[n[0]??0]?.varied.find(u=>u.title===e)?.unit??"",a=e===Fo?{factor:1,unit:""}:sd(s,o),l=sd(t.filter(u=>u.unit===i).map(({value:u})=>u),i);return{list:n.flatMap((u,d)=>(un.value[u]?.results??[]).filter(f=>f.unit===i).map(f=>({place:u,x:s[d]*a.factor,y:f.value*l.factor,error:f.error===null?null:f.error*l.factor,series:r.indexOf(f.title)}))),titles:r,x:a,y:l}}function cM(n){let[e,t]=[Math.min(...n),Math.max(...n)];if(!Number.isFinite(e))return[0,1];let i=.06*(t-e)||Math.abs(t)*.05||1;return[e-i,t+i]}function uM(n){let e=ad(),t=()=>({width:Rr(n),height:DD}),i={stroke:()=>ze("ink"),ticks:{stroke:()=>ze("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},r=(a,{unit:l})=>l?`${a} / ${l}`:a,s=()=>({x:cM(e.list.map(a=>a.x)),y:cM(e.list.flatMap(a=>[a.y-(a.error??0),a.y+(a.error??0)]))}),o=new jt({...t(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!1,y:!1}},scales:{x:{time:!1,range:()=>s().x},y:{range:()=>s().y}},axes:[{...i,label:" ",labelSize:22,size:34},{...i,label:" ",labelSize:24,size:58}],series:[{},{show:!0,stroke:"transparent",points:{show:!1}}],hooks:{draw:[a=>Ir(a,()=>OD(a,e))]}},[[0,1],[0,1]],n);return Rs(o,(a,l)=>{let c=({x:d,y:f})=>Math.hypot(o.valToPos(d,"x")-a,o.valToPos(f,"y")-l),u=e.list.reduce((d,f)=>d&&c(d)<=c(f)?d:f,null);u!==null&&c(u)<UD&&(Ki.value=u.place)}),Pr(o,n,t,[et(()=>{e=ad(),Ki.value,o.axes[0].label=r(ll.value,e.x),o.axes[1].label=r(e.titles.join(", "),e.y);let{x:a,y:l}=s();o.setData([a,l]),n.dataset.marks=String(e.list.length)})])}function OD(n,{list:e}){let{ctx:t}=n,i=ND*devicePixelRatio;t.lineWidth=1.5*devicePixelRatio;for(let{place:r,x:s,y:o,error:a,series:l}of e){let[c,u]=[n.valToPos(s,"x",!0),n.valToPos(o,"y",!0)];t.strokeStyle=t.fillStyle=ze(`curve-${l%FD}`),t.beginPath(),l%2?t.rect(c-i,u-i,2*i,2*i):t.arc(c,u,i,0,2*Math.PI),a===null||(t.fill(),t.beginPath(),t.moveTo(c,n.valToPos(o-a,"y",!0)),t.lineTo(c,n.valToPos(o+a,"y",!0))),t.stroke(),r===Ki.peek()&&(t.strokeStyle=ze("ink"),t.beginPath(),t.arc(c,u,2.4*i,0,2*Math.PI),t.stroke())}}var Cg=500;function hM(n){let e=ll.peek(),t=[...Qs.peek()].sort((r,s)=>Nc(un.peek()[r],r,e)-Nc(un.peek()[s],s,e)),i=Ki.peek()===null?-1:t.indexOf(Ki.peek());Ki.value=t[Math.min(Math.max(i+n,0),t.length-1)]??null}var Rg=n=>{n!==null&&rn.peek()!==null&&Nb(rn.peek(),n)},Pg=[{keys:"← →",effect:"previous or next design",actions:{ArrowLeft:()=>hM(-1),ArrowRight:()=>hM(1)}},{keys:"Enter",effect:"open the design in the text",actions:{Enter:()=>Rg(Ki.peek())}}];function fM(){let n=un.value.length;return n===0?null:h("details",{class:"section",open:!0,children:[h("summary",{children:["Computed designs ",h("span",{class:"quiet",children:n})]}),h("div",{class:"row",children:[rd.value.length>1&&h("label",{children:["Part",h("select",{value:al.value,onChange:e=>al.value=e.currentTarget.value,children:[h("option",{value:"",children:"all"}),rd.value.map(e=>h("option",{children:e}))]})]}),h("label",{children:["Horizontal axis",h("select",{value:ll.value,onChange:e=>id.value=e.currentTarget.value,children:[...nd.value,Fo].map(e=>h("option",{children:e}))})]}),h(BD,{})]}),h(pi,{label:"Computed designs. Arrow keys select a design, Enter opens it.",describedBy:"selected-design",onKeyDown:e=>wr(e,Pg),children:h(kD,{})}),h(zD,{}),h("details",{class:"further",children:[h("summary",{children:"Designs as a table"}),h(VD,{})]})]})}function kD(){let n=lt(null);return Ut(()=>n.current===null?void 0:uM(n.current),[]),h("div",{class:"curves",ref:n})}function BD(){let{list:n,titles:e}=ad();return h("span",{class:"quiet legend",children:[e.map((t,i)=>h("span",{class:"of-mark",style:{"--mark":`var(--curve-${i%4})`,"--round":i%2?"0":"50%"},children:t})),n.some(({error:t})=>t===null)&&h("span",{class:"of-hollow",children:"hollow: preview, without an error"})]})}function zD(){let n=Ki.value,e=n===null?void 0:un.value[n];if(e===void 0)return h("p",{id:"selected-design",class:"quiet",children:"Select a design with a click or the arrow keys."});let t=[...e.varied.map(i=>[i.title,od(i,!1)]),...e.results.map(i=>[i.title,od(i,!0)])];return h("div",{class:"facts",children:h("p",{id:"selected-design","aria-live":"polite",children:["Design ",n+1,rd.value.length>1&&`, ${e.group}`,": ",t.map(([i,r])=>`${i} ${r}`).join(", "),e.results.length===0&&", no result","."," ",h("button",{type:"button",onClick:()=>Rg(n),children:"Open as a design"})]})})}function VD(){let n=Qs.value.slice(0,Cg),e=s=>[...new Set(n.flatMap(o=>un.value[o][s].map(({title:a})=>a)))],[t,i]=[e("varied"),e("results")],r=(s,o,a)=>{let l=un.value[s][o].find(c=>c.title===a);return h("td",{class:"number",children:l===void 0?"-":od(l,o==="results")})};return h("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Computed designs",children:[h("table",{children:[h("thead",{children:h("tr",{children:[h("th",{scope:"col",children:"design"}),h("th",{scope:"col",children:"part"}),[...t,...i].map(s=>h("th",{scope:"col",children:s}))]})}),h("tbody",{children:n.map(s=>h("tr",{"aria-current":Ki.value===s?"true":void 0,children:[h("td",{children:h("button",{type:"button",class:"minor",onClick:()=>Rg(s),children:["Open ",s+1]})}),h("td",{children:un.value[s].group}),t.map(o=>r(s,"varied",o)),i.map(o=>r(s,"results",o))]}))})]}),Qs.value.length>Cg&&h("p",{class:"quiet",children:["and ",Qs.value.length-Cg," more"]})]})}var dM=`#studio { padding: 0.75rem 1rem; }
#studio h2 { font-size: 1.15rem; margin: 0 0 0.4rem; }
.quiet { color: var(--quiet); }
.help { font-size: 0.85rem; }
.hidden { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
.row { display: flex; flex-wrap: wrap; gap: 0.5rem 0.75rem; align-items: end; margin: 0.4rem 0; }
.row label { display: flex; flex-direction: column; min-width: 0; max-width: 100%; font-size: 0.85rem; color: var(--quiet); }
.row > .quiet { padding-bottom: 0.25rem; }
.bar { border-bottom: 1px solid var(--rule); padding-bottom: 0.5rem; }
.bar .row { margin: 0; }
.bar h1 { margin-right: 0.75rem; }
.bar form.row { margin: 0; }
.notice {
  border: 1px solid var(--carrier); border-radius: 0.4rem; padding: 0.5rem 0.75rem; margin: 0.5rem 0;
  overflow-wrap: anywhere;
}
.workbench { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr); margin-top: 0.75rem; }
.results { container-type: inline-size; }
/* on a wide screen the study and the results scroll beside each other, and nothing scrolls away from the other */
@media (min-width: 60rem) {
  #studio { display: flex; flex-direction: column; height: 100vh; box-sizing: border-box; padding-block: 0.5rem; }
  .workbench { flex: 1; min-height: 0; grid-template: minmax(0, 1fr) / minmax(22rem, 30rem) minmax(0, 1fr); }
  .study { display: flex; flex-direction: column; gap: 0.75rem; min-height: 0; }
  #form { flex: none; height: 55%; min-height: 8rem; max-height: calc(100% - 8rem); overflow: auto; resize: vertical; border-bottom: 1px solid var(--rule); }
  #text { flex: 1; min-height: 0; display: flex; flex-direction: column; }
  #form, .results { padding: 0 0.5rem 4px 4px; }
  .results { overflow: auto; overflow-anchor: none; }
}
#studio fieldset { border: 0; margin: 0; padding: 0; min-width: 0; }
#studio fieldset.item { border: 1px solid var(--rule); border-radius: 0.4rem; padding: 0.25rem 0.75rem 0.6rem; margin: 0.5rem 0; }
.fields { display: grid; gap: 0.6rem 1rem; grid-template-columns: repeat(auto-fill, minmax(min(13rem, 100%), 1fr)); margin: 0.4rem 0; align-items: start; }
.field label { display: block; font-size: 0.9rem; overflow-wrap: anywhere; }
.field.given > label { font-weight: 600; }
.field.given > label .quiet { font-weight: normal; }
.field input:not([type="checkbox"]), .field select, .field textarea { width: 100%; box-sizing: border-box; }
.field textarea { font: 0.9rem/1.3 ui-monospace, monospace; }
.field:has(textarea) { grid-column: 1 / -1; }
.field.wrong :is(input, select, textarea) { border: 2px solid var(--carrier); }
.field p { margin: 0.2rem 0; overflow-wrap: anywhere; }
.field .help { display: none; color: var(--quiet); }
.field:focus-within .help { display: block; }
label.check { display: flex; gap: 0.4rem; align-items: center; }
#studio input:not([type="checkbox"]), #studio textarea {
  font: inherit; color: var(--ink); background: var(--panel); border: 1px solid var(--quiet); border-radius: 0.35rem;
  padding: 0.2rem 0.5rem; min-height: 1.9rem; box-sizing: border-box; max-width: 100%;
}
#studio select { max-width: 100%; min-height: 1.9rem; box-sizing: border-box; }
#studio :disabled { opacity: 0.6; cursor: default; }
#studio ::placeholder { color: var(--quiet); opacity: 1; }
#studio :is(textarea, summary, .wide, #form, .results):focus-visible { outline: 3px solid var(--accent); outline-offset: 2px; }
button.main { background: var(--accent); color: var(--paper); border-color: var(--accent); }
.section { border: 1px solid var(--rule); border-radius: 0.4rem; margin: 0.5rem 0; padding: 0 0.75rem; }
.section summary { cursor: pointer; padding: 0.4rem 0; font-weight: 600; }
.section summary .quiet { font-weight: normal; }
.section .inside { padding-bottom: 0.6rem; }
.section .inside > p { margin: 0 0 0.3rem; font-size: 0.9rem; }
.further { margin: 0.75rem 0; }
.further > summary { cursor: pointer; padding: 0.4rem 0; }
.problem { color: var(--carrier); }
.doubt { color: var(--ink); border-left: 4px solid var(--gap); padding-left: 0.5rem; }
.entries { list-style: none; margin: 0; padding: 0; }
.entries li { display: grid; grid-template-columns: minmax(0, 1fr) minmax(0, 2fr) auto; gap: 0.5rem; align-items: center; margin: 0.25rem 0; }
.entries label { overflow-wrap: anywhere; }
.editor .page {
  display: grid; grid-template-columns: auto minmax(0, 1fr); height: 20rem;
  border: 1px solid var(--quiet); border-radius: 0.4rem; overflow: hidden; font: 0.9rem/1.45 ui-monospace, monospace;
}
.editor ol { list-style: none; margin: 0; padding: 0.4rem 0; overflow: hidden; background: var(--panel); color: var(--quiet); text-align: right; }
.editor li { padding: 0 0.5rem; }
.editor ol .wrong { background: var(--carrier); color: var(--paper); font-weight: 700; }
.editor ol .doubtful { background: var(--gap); color: var(--ink); }
#studio .editor textarea {
  font: inherit; border: 0; border-radius: 0; background: var(--paper); padding: 0.4rem 0.6rem; resize: none; height: 100%;
  white-space: pre; overflow: auto;
}
#studio .editor textarea:focus-visible { outline-offset: -3px; }
@media (min-width: 60rem) {
  .editor { display: flex; flex-direction: column; min-height: 0; flex: 1; }
  .editor .page { flex: 1; min-height: 4rem; height: auto; }
  .problems { max-height: 40%; overflow: auto; flex: none; }
}
.problems ul { list-style: none; padding: 0; margin: 0.5rem 0; }
.problems li { border-left: 4px solid var(--carrier); padding-left: 0.6rem; margin: 0.5rem 0; }
.parts { overflow-wrap: anywhere; }
.parts p { margin: 0; }
.parts dl { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 0 0.75rem; margin: 0.2rem 0; font-size: 0.9rem; }
.parts dt { color: var(--quiet); }
.parts dd { margin: 0; }
.compute { border: 1px solid var(--rule); border-radius: 0.4rem; padding: 0.6rem 0.75rem; background: var(--panel); }
.compute :is(select, button, input) { background: var(--paper); }
.compute button.main { background: var(--accent); }
.compute > p { margin: 0.3rem 0; }
.running progress { width: 100%; accent-color: var(--accent); }
.running p { margin: 0.2rem 0; }
.result { margin-top: 1rem; min-height: 90vh; } /* so that it can scroll into view before its view is drawn */
.repeat { display: grid; grid-template-columns: max-content minmax(0, 1fr); gap: 0.1rem 0.75rem; font-size: 0.9rem; }
.repeat dt { color: var(--quiet); }
.repeat dd { margin: 0; overflow-wrap: anywhere; }
@media (max-width: 30rem) { .repeat, .parts dl { grid-template-columns: minmax(0, 1fr); } }
.pictures { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fill, minmax(min(28rem, 100%), 1fr)); }
.pictures figure { margin: 0; }
.pictures img { width: 100%; background: #ffffff; border-radius: 0.3rem; }
.pictures figcaption { color: var(--quiet); font-size: 0.85rem; }
tr.strong td { font-weight: 600; }
td.number { white-space: nowrap; }
td.study-title { min-width: 8rem; overflow-wrap: anywhere; }
.legend .of-mark::before { width: 0.7em; height: 0.7em; background: var(--mark); border-radius: var(--round); }
.legend .of-hollow::before { width: 0.6em; height: 0.6em; border: 2px solid var(--quiet); border-radius: 50%; }
.sides-by-side { display: grid; gap: 0.5rem 1.5rem; grid-template-columns: repeat(auto-fit, minmax(min(18rem, 100%), 1fr)); }
#studio h3 { font-size: 1rem; margin: 0.4rem 0 0; }
.sides-by-side p { margin: 0.2rem 0; }
section.section { padding-block: 0.5rem; }
.editor { position: relative; }
.completions {
  position: absolute; z-index: 2; margin: 0; padding: 0.2rem; list-style: none; max-height: 13rem; overflow: auto;
  min-width: min(14rem, 100%); max-width: min(32rem, 100%); box-sizing: border-box; background: var(--paper);
  border: 1px solid var(--quiet); border-radius: 0.35rem; font: 0.9rem/1.45 ui-monospace, monospace;
}
.completions .quiet { font-family: system-ui, sans-serif; }
.completions li { padding: 0.15rem 0.4rem; cursor: pointer; border: 1px solid transparent; border-radius: 0.25rem; }
.completions li[aria-selected="true"] { border-color: var(--accent); background: var(--panel); }
dialog { color: var(--ink); background: var(--paper); border: 1px solid var(--quiet); border-radius: 0.4rem; max-width: 40rem; }
`;function HD({start:n}){let e=yS(n.form);return h(Ct,{children:[h(wS,{start:n}),h(WD,{}),h("main",{class:"workbench",children:[h("div",{class:"study",children:[h("section",{id:"form","aria-label":"Form",tabIndex:0,children:h(ES,{tree:e})}),h("section",{id:"text","aria-label":"Text",children:h(Wb,{})})]}),h("div",{class:"results",tabIndex:0,role:"group","aria-label":"Analyses and result",children:[h(_S,{analyses:n.analyses}),h(sM,{first:n.plate}),h(mS,{}),h(fM,{}),h(dS,{exports:n.exports}),h("footer",{children:h("p",{children:["haptonic ",n.version]})})]})]})]})}function WD(){return ng.value?h("p",{class:"notice",role:"alert",children:["The server of the studio does not answer. If it has ended, run ",h("code",{children:"haptonic studio"})," again and open its new link; copy a text that is not saved first."]}):null}async function qD(){$m();let n=document.createElement("style");n.textContent=dM+oM,document.head.append(n);let e=document.getElementById("studio");if(e===null)throw new Error("the page has no place for the studio");await ln(async()=>{let t=await Pt.start();nl.value=t.files,kb(t.form,t.expressions),El("Text of the study",Hb),El("Computed designs",Pg),yl(h(HD,{start:t}),e),t.opened!==null&&await Of(t.opened),await ug(),Zb(),lM(),pS(),cS()}),addEventListener("hashchange",()=>{ug()}),addEventListener("beforeunload",t=>{Ro.peek()&&t.preventDefault()})}qD().catch(n=>{let e=document.createElement("p");e.textContent=`The studio cannot be shown: ${n instanceof Error?n.message:String(n)}`,document.body.replaceChildren(e)});
