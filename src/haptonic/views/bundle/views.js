var Qy=Object.create;var Kp=Object.defineProperty;var ex=Object.getOwnPropertyDescriptor;var tx=Object.getOwnPropertyNames;var nx=Object.getPrototypeOf,ix=Object.prototype.hasOwnProperty;var sx=(n,e)=>()=>{try{return e||n((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var rx=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of tx(e))!ix.call(n,s)&&s!==t&&Kp(n,s,{get:()=>e[s],enumerable:!(i=ex(e,s))||i.enumerable});return n};var ox=(n,e,t)=>(t=n!=null?Qy(nx(n)):{},rx(e||!n||!n.__esModule?Kp(t,"default",{value:n,enumerable:!0}):t,n));var N_=sx(Jf=>{var T_=Object.defineProperty,JS=n=>T_(n,"__esModule",{value:!0}),jS=(n,e)=>{for(var t in e)T_(n,t,{get:e[t],enumerable:!0})};JS(Jf);jS(Jf,{GIFEncoder:()=>L_,applyPalette:()=>aM,default:()=>_M,nearestColor:()=>hM,nearestColorIndex:()=>P_,nearestColorIndexWithDistance:()=>I_,prequantize:()=>oM,quantize:()=>sM,snapColorsToPalette:()=>uM});var QS={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};function E_(n=256){let e=0,t=new Uint8Array(n);return{get buffer(){return t.buffer},reset(){e=0},bytesView(){return t.subarray(0,e)},bytes(){return t.slice(0,e)},writeByte(s){i(e+1),t[e]=s,e++},writeBytes(s,r=0,o=s.length){i(e+o);for(let a=0;a<o;a++)t[e++]=s[a+r]},writeBytesView(s,r=0,o=s.byteLength){i(e+o),t.set(s.subarray(r,r+o),e),e+=o}};function i(s){var r=t.length;if(r>=s)return;var o=1024*1024;s=Math.max(s,r*(r<o?2:1.125)>>>0),r!=0&&(s=Math.max(s,256));let a=t;t=new Uint8Array(s),e>0&&t.set(a.subarray(0,e),0)}}var $f=12,S_=5003,eM=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function tM(n,e,t,i,s=E_(512),r=new Uint8Array(256),o=new Int32Array(S_),a=new Int32Array(S_)){let l=o.length,c=Math.max(2,i);r.fill(0),a.fill(0),o.fill(-1);let u=0,h=0,f=c+1,d=f,p=!1,y=d,_=(1<<y)-1,m=1<<f-1,b=m+1,A=m+2,S=0,R=t[0],C=0;for(let F=l;F<65536;F*=2)++C;C=8-C,s.writeByte(c),T(m);let v=t.length;for(let F=1;F<v;F++)e:{let D=t[F],L=(D<<$f)+R,k=D<<C^R;if(o[k]===L){R=a[k];break e}let G=k===0?1:l-k;for(;o[k]>=0;)if(k-=G,k<0&&(k+=l),o[k]===L){R=a[k];break e}T(R),R=D,A<1<<$f?(a[k]=A++,o[k]=L):(o.fill(-1),A=m+2,p=!0,T(m))}return T(R),T(b),s.writeByte(0),s.bytesView();function T(F){for(u&=eM[h],h>0?u|=F<<h:u=F,h+=y;h>=8;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,h-=8;if((A>_||p)&&(p?(y=d,_=(1<<y)-1,p=!1):(++y,_=y===$f?1<<y:(1<<y)-1)),F==b){for(;h>0;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,h-=8;S>0&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0)}}}var nM=tM;function A_(n,e,t){return n<<8&63488|e<<2&992|t>>3}function C_(n,e,t,i){return n>>4|e&240|(t&240)<<4|(i&240)<<8}function R_(n,e,t){return n>>4<<8|e&240|t>>4}function yc(n,e,t){return n<e?e:n>t?t:n}function Ha(n){return n*n}function M_(n,e,t){var i=0,s=1e100;let r=n[e],o=r.cnt,a=r.ac,l=r.rc,c=r.gc,u=r.bc;for(var h=r.fw;h!=0;h=n[h].fw){let d=n[h],p=d.cnt,y=o*p/(o+p);if(!(y>=s)){var f=0;t&&(f+=y*Ha(d.ac-a),f>=s)||(f+=y*Ha(d.rc-l),!(f>=s)&&(f+=y*Ha(d.gc-c),!(f>=s)&&(f+=y*Ha(d.bc-u),!(f>=s)&&(s=f,i=h))))}}r.err=s,r.nn=i}function Zf(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function iM(n,e){let t=e==="rgb444"?4096:65536,i=new Array(t),s=n.length;if(e==="rgba4444")for(let r=0;r<s;++r){let o=n[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255,h=C_(u,c,l,a),f=h in i?i[h]:i[h]=Zf();f.rc+=u,f.gc+=c,f.bc+=l,f.ac+=a,f.cnt++}else if(e==="rgb444")for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=R_(c,l,a),h=u in i?i[u]:i[u]=Zf();h.rc+=c,h.gc+=l,h.bc+=a,h.cnt++}else for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=A_(c,l,a),h=u in i?i[u]:i[u]=Zf();h.rc+=c,h.gc+=l,h.bc+=a,h.cnt++}return i}function sM(n,e,t={}){let{format:i="rgb565",clearAlpha:s=!0,clearAlphaColor:r=0,clearAlphaThreshold:o=0,oneBitAlpha:a=!1}=t;if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(n.buffer),c=t.useSqrt!==!1,u=i==="rgba4444",h=iM(l,i),f=h.length,d=f-1,p=new Uint32Array(f+1);for(var y=0,m=0;m<f;++m){let H=h[m];if(H!=null){var _=1/H.cnt;u&&(H.ac*=_),H.rc*=_,H.gc*=_,H.bc*=_,h[y++]=H}}Ha(e)/y<.022&&(c=!1);for(var m=0;m<y-1;++m)h[m].fw=m+1,h[m+1].bk=m,c&&(h[m].cnt=Math.sqrt(h[m].cnt));c&&(h[m].cnt=Math.sqrt(h[m].cnt));var b,A,S;for(m=0;m<y;++m){M_(h,m,!1);var R=h[m].err;for(A=++p[0];A>1&&(S=A>>1,!(h[b=p[S]].err<=R));A=S)p[A]=b;p[A]=m}var C=y-e;for(m=0;m<C;){for(var v;;){var T=p[1];if(v=h[T],v.tm>=v.mtm&&h[v.nn].mtm<=v.tm)break;v.mtm==d?T=p[1]=p[p[0]--]:(M_(h,T,!1),v.tm=m);var R=h[T].err;for(A=1;(S=A+A)<=p[0]&&(S<p[0]&&h[p[S]].err>h[p[S+1]].err&&S++,!(R<=h[b=p[S]].err));A=S)p[A]=b;p[A]=T}var F=h[v.nn],D=v.cnt,L=F.cnt,_=1/(D+L);u&&(v.ac=_*(D*v.ac+L*F.ac)),v.rc=_*(D*v.rc+L*F.rc),v.gc=_*(D*v.gc+L*F.gc),v.bc=_*(D*v.bc+L*F.bc),v.cnt+=F.cnt,v.mtm=++m,h[F.bk].fw=F.fw,h[F.fw].bk=F.bk,F.mtm=d}let k=[];var G=0;for(m=0;;++G){let U=yc(Math.round(h[m].rc),0,255),H=yc(Math.round(h[m].gc),0,255),$=yc(Math.round(h[m].bc),0,255),V=255;u&&(V=yc(Math.round(h[m].ac),0,255),a&&(V=V<=(typeof a=="number"?a:127)?0:255),s&&V<=o&&(U=H=$=r,V=0));let ae=u?[U,H,$,V]:[U,H,$];if(rM(k,ae)||k.push(ae),(m=h[m].fw)==0)break}return k}function rM(n,e){for(let t=0;t<n.length;t++){let i=n[t],s=i[0]===e[0]&&i[1]===e[1]&&i[2]===e[2],r=i.length>=4&&e.length>=4?i[3]===e[3]:!0;if(s&&r)return!0}return!1}function bc(n,e){var t=0,i;for(i=0;i<n.length;i++){let s=n[i]-e[i];t+=s*s}return t}function xc(n,e){return e>1?Math.round(n/e)*e:n}function oM(n,{roundRGB:e=5,roundAlpha:t=10,oneBitAlpha:i=null}={}){let s=new Uint32Array(n.buffer);for(let r=0;r<s.length;r++){let o=s[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255;a=xc(a,t),i&&(a=a<=(typeof i=="number"?i:127)?0:255),u=xc(u,e),c=xc(c,e),l=xc(l,e),s[r]=a<<24|l<<16|c<<8|u<<0}}function aM(n,e,t="rgb565"){if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let i=new Uint32Array(n.buffer),s=i.length,r=t==="rgb444"?4096:65536,o=new Uint8Array(s),a=new Array(r),l=t==="rgba4444";if(t==="rgba4444")for(let c=0;c<s;c++){let u=i[c],h=u>>24&255,f=u>>16&255,d=u>>8&255,p=u&255,y=C_(p,d,f,h),_=y in a?a[y]:a[y]=lM(p,d,f,h,e);o[c]=_}else{let c=t==="rgb444"?R_:A_;for(let u=0;u<s;u++){let h=i[u],f=h>>16&255,d=h>>8&255,p=h&255,y=c(p,d,f),_=y in a?a[y]:a[y]=cM(p,d,f,e);o[u]=_}}return o}function lM(n,e,t,i,s){let r=0,o=1e100;for(let a=0;a<s.length;a++){let l=s[a],c=l[3],u=Vr(c-i);if(u>o)continue;let h=l[0];if(u+=Vr(h-n),u>o)continue;let f=l[1];if(u+=Vr(f-e),u>o)continue;let d=l[2];u+=Vr(d-t),!(u>o)&&(o=u,r=a)}return r}function cM(n,e,t,i){let s=0,r=1e100;for(let o=0;o<i.length;o++){let a=i[o],l=a[0],c=Vr(l-n);if(c>r)continue;let u=a[1];if(c+=Vr(u-e),c>r)continue;let h=a[2];c+=Vr(h-t),!(c>r)&&(r=c,s=o)}return s}function uM(n,e,t=5){if(!n.length||!e.length)return;let i=n.map(o=>o.slice(0,3)),s=t*t,r=n[0].length;for(let o=0;o<e.length;o++){let a=e[o];a.length<r?a=[a[0],a[1],a[2],255]:a.length>r?a=a.slice(0,3):a=a.slice();let l=I_(i,a.slice(0,3),bc),c=l[0],u=l[1];u>0&&u<=s&&(n[c]=a)}}function Vr(n){return n*n}function P_(n,e,t=bc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return s}function I_(n,e,t=bc){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return[s,i]}function hM(n,e,t=bc){return n[P_(n,e,t)]}function L_(n={}){let{initialCapacity:e=4096,auto:t=!0}=n,i=E_(e),s=5003,r=new Uint8Array(256),o=new Int32Array(s),a=new Int32Array(s),l=!1;return{reset(){i.reset(),l=!1},finish(){i.writeByte(QS.trailer)},bytes(){return i.bytes()},bytesView(){return i.bytesView()},get buffer(){return i.buffer},get stream(){return i},writeHeader:c,writeFrame(u,h,f,d={}){let{transparent:p=!1,transparentIndex:y=0,delay:_=0,palette:m=null,repeat:b=0,colorDepth:A=8,dispose:S=-1}=d,R=!1;if(t?l||(R=!0,c(),l=!0):R=!!d.first,h=Math.max(0,Math.floor(h)),f=Math.max(0,Math.floor(f)),R){if(!m)throw new Error("First frame must include a { palette } option");dM(i,h,f,m,A),w_(i,m),b>=0&&pM(i,b)}let C=Math.round(_/10);fM(i,S,C,p,y);let v=!!m&&!R;mM(i,h,f,v?m:null),v&&w_(i,m),gM(i,u,h,f,A,r,o,a)}};function c(){D_(i,"GIF89a")}}function fM(n,e,t,i,s){n.writeByte(33),n.writeByte(249),n.writeByte(4),s<0&&(s=0,i=!1);var r,o;i?(r=1,o=2):(r=0,o=0),e>=0&&(o=e&7),o<<=2,n.writeByte(0|o|0|r),lr(n,t),n.writeByte(s||0),n.writeByte(0)}function dM(n,e,t,i,s=8){let a=Kf(i.length)-1,l=128|s-1<<4|0|a,c=0,u=0;lr(n,e),lr(n,t),n.writeBytes([l,c,u])}function pM(n,e){n.writeByte(33),n.writeByte(255),n.writeByte(11),D_(n,"NETSCAPE2.0"),n.writeByte(3),n.writeByte(1),lr(n,e),n.writeByte(0)}function w_(n,e){let t=1<<Kf(e.length);for(let i=0;i<t;i++){let s=[0,0,0];i<e.length&&(s=e[i]),n.writeByte(s[0]),n.writeByte(s[1]),n.writeByte(s[2])}}function mM(n,e,t,i){if(n.writeByte(44),lr(n,0),lr(n,0),lr(n,e),lr(n,t),i){let o=Kf(i.length)-1;n.writeByte(128|o)}else n.writeByte(0)}function gM(n,e,t,i,s=8,r,o,a){nM(t,i,e,s,n,r,o,a)}function lr(n,e){n.writeByte(e&255),n.writeByte(e>>8&255)}function D_(n,e){for(var t=0;t<e.length;t++)n.writeByte(e.charCodeAt(t))}function Kf(n){return Math.max(Math.ceil(Math.log2(n)),1)}var _M=L_});async function Xh(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Response(e).arrayBuffer()}var Jp=8,ax={"<f8":Float64Array,"<f4":Float32Array,"<i4":Int32Array,"<i2":Int16Array,"|i1":Int8Array},Ta=class n{constructor(e,t,i){this.header=e;this.content=t;this.front=i}header;content;front;static read(e){let t=new DataView(e).getUint32(0,!0),i=new TextDecoder().decode(new Uint8Array(e,4,t)),s=Math.ceil((4+t)/Jp)*Jp;return new n(JSON.parse(i),e,s)}has(e){return e in this.header.variables}values(e){let{type:t,start:i,shape:s}=this.described(e);if(t===void 0||i===void 0)throw new Error(`${e} has no numbers`);let r=s.reduce((o,a)=>o*a,1);return new ax[t](this.content,this.front+i,r)}scale(e){return this.described(e).scale??1}texts(e){return this.described(e).texts??[]}shape(e){return this.described(e).shape}unit(e){return this.described(e).attrs.units??""}title(e){return this.described(e).attrs.long_name??e}parsed(e){return JSON.parse(String(this.header.attrs[e]))}described(e){let t=this.header.variables[e];if(t===void 0)throw new Error(`the dataset has no variable ${e}`);return t}};var St,em,Zh,Ks,Yh,Ol,tm,Ul,nm,Kh,$h,lx,Aa=Symbol.for("pv"),Bl={},kl=[],cx=/^m(i|n|o|s|text|space)$/,Jh=Array.isArray,jh=kl.slice,Lr=Object.assign;function Ir(n){n&&n.parentNode&&n.remove()}function im(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?jh.call(arguments,2):t),Ea(n,o,i,s,null)}function Ea(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Aa,__v:s||++em,__i:-1,__u:0};return!s&&St.vnode&&St.vnode(r),r}function ln(n){return n.children}function mo(n,e){this.props=n,this.context=e,this.__g=0}function Js(n,e){if(e==null)return n.__&&Js(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Js(n)}function ux(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Lr({constructor:Aa},t)).__v=t.__v+1,St.vnode&&St.vnode(e),Qh(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Js(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,cm(s,e,r),t.__=t.__e=null,e.__e!=i&&sm(e))}function sm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),sm(n)}function jp(n){(8&n.__g||(n.__g|=8,Ks.push(n),Ol++))&&Yh==St.debounceRendering||((Yh=St.debounceRendering)||queueMicrotask)(rm)}function rm(){try{for(var n,e=1;Ks.length;)Ks.length>e&&Ks.sort(tm),n=Ks.shift(),e=Ks.length,8&n.__g&&ux(n)}finally{(Ol=Ks.length)&&(Yh||queueMicrotask)(rm)}}function om(n,e,t,i,s,r,o,a,l,c,u){var h,f,d,p,y,_,m=i.__k||kl,b=e.length;for(l=hx(t,e,m,l,b),h=0;h<b;h++)(d=t.__k[h])!=null&&(f=~d.__i&&m[d.__i]||Bl,d.__i=h,_=Qh(n,d,f,s,r,o,a,l,c,u),p=d.__e,(f.ref!=d.ref||8&f.__u)&&(f.ref&&ef(f.ref,null,d,f),d.ref&&u.push(d.ref,d.__c||p,d)),y=y||p,4&d.__u?(l=am(d,l,n,!f.__v),f.__e&&(f.__e=null)):typeof d.type=="function"&&_!==void 0?l=_:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=y,l}function hx(n,e,t,i,s){var r,o,a,l,c,u,h,f,d,p=t.length,y=p,_=0,m=0,b=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=b[r]=Ea(null,o):Jh(o)?o=b[r]=Ea(ln,{children:o}):o.constructor===Aa&&o.__b?o=b[r]=Ea(o.type,o.props,o.key,o.ref,o.__v):b[r]=o,l=r+_,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=fx(o,t,l,y))&&(y--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?_--:c==l+1?_++:c!=l&&(c>l?_--:_++,m=1)):(~c||(s>p?_--:s<p&&_++),typeof o.type!="function"&&(o.__u|=4))):b[r]=null;if(m){for(u=[],h=[],r=0;r<s;r++)if((o=b[r])&&16&o.__u){for(_=0,f=u.length;_<f;)u[d=_+f>>1]<o.__i?_=d+1:f=d;u[_]=o.__i,h[r]=_+1}for(_=u.length;r--;)h[r]&&(h[r]==_?_--:b[r].__u|=4)}if(y)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Js(a)),tf(a,a));return i}function am(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=am(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Js(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function fx(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Qp(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Nl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Qp(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Qp(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=$h[e]||($h[e]=dx(e)),(n.__a||(n.__a={}))[e]=Kh,r=e!=(e=e.replace(nm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function dx(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Ul]==null)e[Ul]=Kh++;else if(e[Ul]<this.__a[n])return;return t(St.event?St.event(e):e)}}}function Qh(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,p,y,_,m,b,A,S,R,C,v,T,F,D,L,k=e.type;if(e.constructor!==Aa)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,h=r=[],u.nodeType==8?a=Fl(u,r):r.push(u),a=r[0]||a),(u=St.__b)&&u(e);e:if(typeof k=="function"){f=o.length;try{if(m=e.props,b=(u=k.prototype)&&u.render,A=(u=k.contextType)&&i[u.__c],S=u?A?A.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(b?e.__c=d=new k(m,S):(e.__c=d=new mo(m,S),d.constructor=k,d.render=mx),A&&A.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),b&&(d.__s||(d.__s=d.state),k.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Lr({},d.__s)),Lr(d.__s,k.getDerivedStateFromProps(m,d.__s)))),p=d.props,y=d.state,d.__v=e,t.__c){if(m!==p&&b&&!k.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(m,S),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(m,d.__s,S)===!1){e.__v!=t.__v&&(d.props=m,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(G){G&&(G.__=e)}),kl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=Js(t);break e}d.componentWillUpdate&&d.componentWillUpdate(m,d.__s,S),b&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,y,_)})}else b&&!k.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),b&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=S,d.props=m,d.__P=n,d.__g&=-5,R=St.__r,C=b?25:0;do d.__g&=-9,R&&R(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++C<25);b&&(kl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Lr({},i,d.getChildContext())),b&&t.__c&&d.getSnapshotBeforeUpdate&&(_=d.getSnapshotBeforeUpdate(p,y)),v=u&&u.type===ln&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(G){G&&tf(G,G)}),t.__k=null),a=t.__k?Js(t,0):null),a=om(n,Jh(v)?v:[v],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,h&&h.some(Ir),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(G){if(o.length=f,e.__v=null,l||r)if(G&&G.then){if(e.__u|=128|l,r){for(~(D=r.indexOf(a||void 0))||(D=r.length);(L=r[D-1])&&L.nodeType==8;)D--;for(;D<r.length;D++)if(L=r[D])if(r[D]=null,T){if(L==F)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(F=Fl(T=L))}}if(!T){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;T=a}(u=Fl(T=e.__c.__z||(e.__c.__z=T)))?(e.__e=T,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Ir);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),G&&G.then||lm(e),St.__e(G,e,t)}}else a=e.__e=px(t.__e,e,t,i,s,r,o,l,c,n);return(u=St.diffed)&&u(e),a}function Fl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function lm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(lm))}function cm(n,e,t){for(var i=0;i<t.length;)ef(t[i++],t[i++],t[i++]);St.__c&&St.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){St.__e(r,s.__v)}})}function px(n,e,t,i,s,r,o,a,l,c){var u,h,f,d,p,y,_,m,b=t.props||Bl,A=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(S?p.localName==S:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!S)return m.createTextNode(A);n=m.createElementNS(s,S,A.is?A:c),a&&(St.__m&&St.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&A.defaultValue!=null?null:r&&jh.call(c.childNodes),!a&&r)for(b={},u=0;u<n.attributes.length;u++)b[(p=n.attributes[u]).name]=p.value;for(u in b)p=b[u],u=="dangerouslySetInnerHTML"?f=p:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||Nl(n,u,null,p,s);for(u in A)p=A[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?h=p:u=="value"?y=p:u=="checked"?_=p:a&&typeof p!="function"||b[u]===p||Nl(n,u,p,b[u],s);h?(a||f&&(h.__html==f.__html||h.__html==n.innerHTML)||(n.innerHTML=h.__html),e.__k=[]):(f&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&cx.test(S))&&(s="http://www.w3.org/1999/xhtml"),om(c,Jh(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&Js(t,0),a,l),r&&r.some(Ir)),a&&S!="textarea"||(u="value",S=="progress"&&y==null?n.removeAttribute(u):y==null||y===n[u]&&(S!="progress"||y)||Nl(n,u,y,b[u],s),u="checked",_!=null&&_!=n[u]&&Nl(n,u,_,b[u],s))}else b===A||a&&n.data==A||(n.data=A);return n}function ef(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){St.__e(s,t)}}function tf(n,e,t){var i,s,r,o;if(St.unmount&&St.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||ef(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){St.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&tf(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Fl(i,r=[]))&&(i==n.__e&&r.some(Ir),Ir(s),Ir(i)),t||Ir(n.__e),n.__e=n.__c=n.__=null}function mx(n,e,t){return this.constructor(n,t)}function nf(n,e){var t,i,s,r;St.__&&St.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Ea(ln,{children:[n]}),s=[],r=[],Qh(e,e.__k,i||Bl,Bl,e.namespaceURI,i?null:e.firstChild?jh.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),cm(s,e.__k,r),e.__k.props.children=null}St={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Ol=0,n}},em=0,Zh=function(n){return n!=null&&n.constructor===Aa},mo.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Lr({},this.state)),typeof n=="function"&&(n=n(Lr({},t),this.props)),n&&(Lr(t,n),this.__v&&(e&&this.__k.push(e),jp(this)))},mo.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),jp(this))},mo.prototype.render=ln,Ks=[],Ol=0,tm=function(n,e){return n.__v.__b-e.__v.__b},Ul=Symbol(),nm=/(PointerCapture)$|Capture$/i,Kh=0,$h={},lx=0;var go,yn,sf,um,rf=Object.is,zl=0,ym=[],of=[],hn=St,hm=hn.__b,fm=hn.__r,dm=hn.diffed,pm=hn.__c,mm=hn.unmount,gm=hn.__;function Gl(n,e){hn.__h&&hn.__h(yn,n,zl||e),zl=0;var t=yn.__H||(yn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function js(n){return zl=1,gx(xm,n)}function gx(n,e,t){var i=Gl(go++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):xm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);rf(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=yn,!yn.__f)){yn.__f=!0;var s=yn.shouldComponentUpdate;yn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(f){f.__N&&(c=!0,rf(f.__[0],f.__N[0])||(u=!0))}),s){var h=s.call(this,r,o,a);return c?h||u:h}return!c||u}}return i.__}function fn(n,e){var t=Gl(go++,3);!hn.__s&&lf(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,yn.__H.__h.push(t))}function Gi(n,e){var t=Gl(go++,4);!hn.__s&&lf(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,yn.__h.push(t))}function Nt(n){return zl=5,Ge(function(){return{current:n}},[])}function Ge(n,e){var t=Gl(go++,7);return lf(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function _x(){var n;do{for(;n=of.shift();)try{Ca(n)}catch(t){hn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=ym.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ca),e.__h.some(af),e.__h=[]}catch(t){e.__h=[],hn.__e(t,n.__v)}}}while(of.length)}hn.__b=function(n){yn=null,hm&&hm(n)},hn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),gm&&gm(n,e)},hn.__r=function(n){fm&&fm(n),go=0;var e=(yn=n.__c).__H;e&&(sf==yn?yn.__h=[]:(e.__h.some(Ca),e.__h.some(af),go=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),sf=yn},hn.diffed=function(n){dm&&dm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&vm(ym.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),sf=yn=null},hn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ca),t.__h=t.__h.filter(function(i){return!i.__||af(i)})}catch(i){t.__h=[function(){throw i}]}}),pm&&pm(n,e)},hn.unmount=function(n){mm&&mm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,vm(of.push(s))}else Ca(s)}catch(r){e=r}}),i.__H=void 0,e&&hn.__e(e,i.__v))};var _m=typeof requestAnimationFrame=="function";function vx(n){var e,t=function(){clearTimeout(i),_m&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);_m&&(e=requestAnimationFrame(t))}function vm(n){n!=1&&um==hn.requestAnimationFrame||((um=hn.requestAnimationFrame)||vx)(_x)}function Ca(n){var e=yn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),yn=e}function af(n){var e=yn;n.__c=n.__(),yn=e}function lf(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!rf(t,n[i])})}function xm(n,e){return typeof e=="function"?e(n):e}var yx=Symbol.for("preact-signals");function ql(){if(Ts>1)Ts--;else{var n,e=!1;for((function(){var s=Hl;for(Hl=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();Pa!==void 0;){var t=Pa;for(Pa=void 0,Vl++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&Sm(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(Vl=0,Ts--,e)throw n}}function Xl(n){if(Ts>0)return n();cf=++xx,Ts++;try{return n()}finally{ql()}}var Ra,Jt=void 0;function Ia(n){var e=Jt,t=Ra;Jt=void 0,Ra=void 0;try{return n()}finally{Jt=e,Ra=t}}var Pa=void 0,Ts=0,Vl=0,xx=0,cf=0,Hl=void 0,Wl=0;function bm(n){if(Jt!==void 0){var e=n.n;if(e===void 0||e.t!==Jt)return e={i:0,S:n,p:Jt.s,n:void 0,t:Jt,e:void 0,x:void 0,r:e},Jt.s!==void 0&&(Jt.s.n=e),Jt.s=e,n.n=e,32&Jt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=Jt.s,e.n=void 0,Jt.s.n=e,Jt.s=e),e}}function Tn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Tn.prototype.brand=yx;Tn.prototype.h=function(){return!0};Tn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:Ia(function(){var i;(i=e.W)==null||i.call(e)}))};Tn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&Ia(function(){var s;(s=e.Z)==null||s.call(e)}))}};Tn.prototype.subscribe=function(n){var e=this;return Et(function(){var t=e.value;Ia(function(){return n(t)})},{name:"sub"})};Tn.prototype.valueOf=function(){return this.value};Tn.prototype.toString=function(){return this.value+""};Tn.prototype.toJSON=function(){return this.value};Tn.prototype.peek=function(){var n=this;return Ia(function(){return n.value})};Object.defineProperty(Tn.prototype,"value",{get:function(){var n=bm(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Vl>100)throw new Error("Cycle detected");(function(t){Ts!==0&&Vl===0&&t.l!==cf&&(t.l=cf,Hl={S:t,v:t.v,i:t.i,o:Hl})})(this),this.v=n,this.i++,Wl++,Ts++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{ql()}}}});function Xe(n,e){return new Tn(n,e)}function Sm(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function Mm(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function wm(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function Dr(n,e){Tn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Wl-1,this.f=4}Dr.prototype=new Tn;Dr.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Wl))return!0;if(this.g=Wl,this.f|=1,this.i>0&&!Sm(this))return this.f&=-2,!0;var n=Jt;try{Mm(this),Jt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return Jt=n,wm(this),this.f&=-2,!0};Dr.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Tn.prototype.S.call(this,n)};Dr.prototype.U=function(n){if(this.t!==void 0&&(Tn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};Dr.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(Dr.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=bm(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function xn(n,e){return new Dr(n,e)}function Tm(n){var e=n.j;if(n.j=void 0,typeof e=="function"){Ts++;var t=Jt;Jt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,uf(n),i}finally{Jt=t,ql()}}}function uf(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,Tm(n)}function bx(n){if(Jt!==this)throw new Error("Out-of-order effect");wm(this),Jt=n,this.f&=-2;try{8&this.f&&uf(this)}finally{ql()}}function _o(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,Ra&&Ra.push(this)}_o.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};_o.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,Tm(this),Mm(this),Ts++;var n=Jt;return Jt=this,bx.bind(this,n)};_o.prototype.N=function(){2&this.f||(this.f|=2,this.u=Pa,Pa=this)};_o.prototype.d=function(){this.f|=8,1&this.f||uf(this)};_o.prototype.dispose=function(){this.d()};function Et(n,e){var t=new _o(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var hf,Da,Yl,Sx=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,Em=[],Am=[];Et(function(){hf=this.N})();function vo(n,e){St[n]=e.bind(null,St[n]||function(){})}function La(n){if(Yl){var e=Yl;Yl=void 0,e()}Yl=n&&n.S()}function Cm(n){var e=this,t=n.data,i=wx(t);i.name="ReactiveDom",i.value=t;var s=Ge(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=xn(function(){var d=i.value.value;return d===0?0:d===!0?"":d||""}),u=xn(function(){return!Array.isArray(c.value)&&!Zh(c.value)}),h=Et(function(){if(this.N=Rm,u.value){var d=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=d)}}),f=e.__$u.d;return e.__$u.d=function(){h(),f.call(this)},[u,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}Cm.displayName="ReactiveTextNode";Object.defineProperties(Tn.prototype,{constructor:{configurable:!0,value:im(ln,null).constructor},type:{configurable:!0,value:Cm},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});vo("__b",function(n,e){if(La(),Da=void 0,typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Tn&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});vo("__r",function(n,e){if(n(e),e.type!==ln){La();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return Et(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;Sx&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),Da=i,La(t)}});vo("__e",function(n,e,t,i){La(),Da=void 0,n(e,t,i)});vo("diffed",function(n,e){La(),Da=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=Mx(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function Mx(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=Xe(t);return{o:function(o,a){r.value=o,i=a},d:Et(function(){this.N=Rm;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}vo("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});vo("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});mo.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function wx(n,e){return Ge(function(){return Xe(n,e)},[])}var Tx=typeof requestAnimationFrame>"u"?setTimeout:function(n){var e=function(){clearTimeout(t),cancelAnimationFrame(i),n()},t=setTimeout(e,35),i=requestAnimationFrame(e)},Ex=function(n){queueMicrotask(function(){queueMicrotask(n)})};function Ax(){Xl(function(){for(var n;n=Em.shift();)hf.call(n)})}function Cx(){Em.push(this)===1&&(St.requestAnimationFrame||Tx)(Ax)}function Rx(){Xl(function(){for(var n;n=Am.shift();)hf.call(n)})}function Rm(){Am.push(this)===1&&(St.requestAnimationFrame||Ex)(Rx)}function Pm(n,e){var t=Nt(n);t.current=n;var i=Da;fn(function(){return Et(function(){if(this.N=Cx,!(i&&8&i.__$f))return t.current()},e)},[])}var Im=[{name:"Hz",factor:1},{name:"kHz",factor:1e3},{name:"MHz",factor:1e6}],Px=1e4,Na=Xe({});function Ci(n){let{pitch_m:e,shear_speed_m_per_s:t}=n.header.attrs;return typeof e!="number"||typeof t!="number"?Im:[...Im,{name:"ωa/(2πcₜ)",factor:t/e,relative:!0}]}function Ri(n,e){return n.find(({factor:i,relative:s})=>!s&&e<Px*i)??n[0]}function yo(n){return[{name:"rad/m",factor:1},{name:"π/a",factor:Math.PI/n},{name:"2π/a",factor:2*Math.PI/n}]}var Ix=/^[mN](?=$|\/)/,Lx=[["",1],["m",.001],["µ",1e-6],["n",1e-9]];function Lm(n,e){let t=Lx.find(([,r])=>Ix.test(n)&&e>=r),[i,s]=t??["",1];return{name:i+n,factor:s}}function kn(n,{name:e,relative:t}){return t?`${e} = ${n}`:`${n} ${e}`}function Gt(n,{name:e,relative:t}){return t?e:`${n} / ${e.includes("/")?`(${e})`:e}`}function cs(n){return`${Number(n.toPrecision(6))}`}var Dx=Symbol.for("pv"),Nx=0;function g(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Dx,__v:--Nx,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),St.vnode&&St.vnode(c),c}function Pi({title:n,units:e,unit:t}){let{value:i}=t,s=e[0]?.name??"";return fn(()=>{Na.value={...Na.peek(),[s]:i}},[s,i]),fn(()=>()=>{let{[s]:r,...o}=Na.peek();Na.value=o},[s]),g("label",{children:[n," ",g("select",{value:i.name,onChange:({currentTarget:r})=>t.value=e[r.selectedIndex]??t.value,children:e.map(({name:r})=>g("option",{children:r}))})]})}function Nr({playing:n}){return g("button",{type:"button",onClick:()=>n.value=!n.value,children:n.value?"Stop":"Move"})}function xo({playing:n,pace:e}){return g("div",{class:"controls",children:[g(Nr,{playing:n}),g(Ua,{pace:e})]})}function Ua({pace:n}){return g("label",{children:["pace, cycles per second: ",n.value.toFixed(1),g("input",{type:"range",min:"0.1",max:"3",step:"0.1",value:n.value,onInput:e=>n.value=Number(e.currentTarget.value)})]})}function Ii({facts:n}){return g("dl",{children:n.filter(([,e])=>e).map(([e,t])=>g("div",{children:[g("dt",{children:e}),g("dd",{children:t})]}))})}var Ux="⁰¹²³⁴⁵⁶⁷⁸⁹";function $l(n){let e=n.replace(/(?<=\d)e([+-]?\d+)\b/g,(t,i)=>`×${Zl(Number(i))}`);return Vi(e)}function Vi(n){return n.replace(/(?<![\w.)])-(?=\.?\d)/g,"−")}function Zl(n){let e=Array.from(String(Math.abs(n)),t=>Ux[Number(t)]);return`10${n<0?"⁻":""}${e.join("")}`}function bo(n){let[e="",t]=String(Number(n.toPrecision(12))).split("e");return Vi(e)+(t===void 0?"":`×${Zl(Number(t))}`)}function Vt(n,e){if(!(Number.isFinite(e)&&e>0))return Vi(n.toFixed(3));e=Math.max(e,10**-6);let t=Math.floor(Math.log10(e)+1e-9);e<2*10**t&&(t-=1);let i=Math.ceil(e/10**t-1e-9);i===10&&([i,t]=[1,t+1]);let s=Math.min(Math.max(-t,0),6),r=10**Math.max(t,0),o=r>1?Math.round(n/r)*r:n;return`${Vi(o.toFixed(s))} ± ${(i*10**t).toFixed(s)}`}var Kl=Xe([]);function Dm(n,e){let t={title:n,keys:e};return Kl.value=[...Kl.peek(),t],()=>Kl.value=Kl.peek().filter(i=>i!==t)}var us=({playing:n})=>({keys:"space",effect:"move or stop",actions:{" ":()=>n.value=!n.value}}),Fx="input, textarea, select",Ox="button, summary, a";function Jl(n,e){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return;let t=n.target;if(t.closest(Fx)!==null||n.key===" "&&t.closest(Ox)!==null)return;let i=e.map(s=>s.actions[n.key]).find(s=>s!==void 0);i!==void 0&&(n.preventDefault(),i(n))}var Hi=n=>String(n.header.attrs.origin??"simulated");function Jn({name:n,data:e,keys:t,foot:i,isOld:s=!1,children:r}){fn(()=>Dm(e.header.title,t),[e,t]);let o=e.header.extra.summary??[];return g("div",{class:n,tabIndex:-1,onKeyDown:a=>Jl(a,t),children:[g("header",{children:[g("h1",{children:e.header.title}),g("p",{class:"origin",children:Hi(e)}),g("div",{class:s?"old":"",children:o.map(a=>g("p",{children:$l(a)}))})]}),r,g("footer",{children:g("p",{children:["haptonic ",String(e.header.attrs.haptonic_version??""),". ",i]})})]})}function ni(n){return[{keys:"t",effect:"tables",actions:{t:()=>ff(n,"table")}},{keys:"?",effect:"this list",actions:{"?":()=>ff(n,"keys")}}]}function ff(n,e){n.value=n.value===e?"none":e}function ii({listing:n,keys:e,children:t}){let i=Nt(null);return Pm(()=>{n.value!=="none"&&i.current?.focus()}),g("section",{"aria-label":"Tables and keys",children:[g("p",{class:"opened",children:[["table","Tables"],["keys","Keys"]].map(([r,o])=>g("button",{type:"button","aria-expanded":n.value===r,onClick:()=>ff(n,r),children:o}))}),g("div",{ref:i,tabIndex:-1,children:[n.value==="table"&&t,n.value==="keys"&&g(Bx,{title:"Keys",keys:e})]})]})}function Bx({title:n,keys:e}){return g("table",{children:[n&&g("caption",{children:n}),g("tbody",{children:e.map(({keys:t,effect:i})=>g("tr",{children:[g("th",{scope:"row",children:g("kbd",{children:t})}),g("td",{children:i})]}))})]})}function jl([n,e],t){let i=Math.hypot(n,e);if(t===void 0)return`${i.toPrecision(3)} m/s`;let s=i>t?` at ${Vi(String(Math.round(Math.atan2(e,n)*180/Math.PI)||0))}° from x`:"";return`${Vt(i,t)} m/s${s}`}function Vn({label:n,describedBy:e="point",onKeyDown:t,children:i}){return g("div",{class:"walk",tabIndex:0,role:"application","aria-label":n,"aria-describedby":e,onKeyDown:t,children:i})}var kx="uplot",zx="u-hz",Gx="u-vt",Vx="u-title",Hx="u-wrap",Wx="u-under",qx="u-over",Xx="u-axis",Or="u-off",Yx="u-select",$x="u-cursor-x",Zx="u-cursor-y",Kx="u-cursor-pt",Jx="u-legend",jx="u-live",Qx="u-inline",eb="u-series",tb="u-marker",Nm="u-label",nb="u-value",Oa="width",Ba="height";var Um="bottom",So="left",df="right",Pf="#000",Fm=Pf+"0",pf="mousemove",Om="mousedown",mf="mouseup",Bm="mouseenter",km="mouseleave",zm="dblclick",ib="resize",sb="scroll",Gm="change",ic="dppxchange",If="--",Ro=typeof window<"u",xf=Ro?document:null,wo=Ro?window:null,rb=Ro?navigator:null,At,Ql;function bf(){let n=devicePixelRatio;At!=n&&(At=n,Ql&&Mf(Gm,Ql,bf),Ql=matchMedia(`(min-resolution: ${At-.001}dppx) and (max-resolution: ${At+.001}dppx)`),Br(Gm,Ql,bf),wo.dispatchEvent(new CustomEvent(ic)))}function di(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Sf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Wi(n,e,t,i){let s=xf.createElement(n);return e!=null&&di(s,e),t?.insertBefore(s,i),s}function Li(n,e){return Wi("div",n,e)}var Vm=new WeakMap;function hs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Vm.get(n);r!=o&&(n.style.transform=r,Vm.set(n,r),e<0||t<0||e>i||t>s?di(n,Or):Sf(n,Or))}var Hm=new WeakMap;function Wm(n,e,t){let i=e+t,s=Hm.get(n);i!=s&&(Hm.set(n,i),n.style.background=e,n.style.borderColor=t)}var qm=new WeakMap;function Xm(n,e,t,i){let s=e+""+t,r=qm.get(n);s!=r&&(qm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Lf={passive:!0},ob={...Lf,capture:!0};function Br(n,e,t,i){e.addEventListener(n,t,i?ob:Lf)}function Mf(n,e,t,i){e.removeEventListener(n,t,Lf)}Ro&&bf();function qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:pi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function xg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var bg=n=>n!=null,Sg=n=>n!=null&&n>0,oc=xg(bg),ab=xg(Sg);function lb(n,e,t,i=0,s=!1){let r=s?ab:oc,o=s?Sg:bg;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function ac(n,e,t,i){let s=Zm(n),r=Zm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Es:Mg,a=s==1?pi:Di,l=r==1?Di:pi,c=a(o(An(n))),u=l(o(An(e))),h=To(t,c),f=To(t,u);return t==10&&(c<0&&(h=kt(h,-c)),u<0&&(f=kt(f,-u))),i||t==2?(n=h*s,e=f*r):(n=Ag(n,h),e=lc(e,f)),[n,e]}function Df(n,e,t,i){let s=ac(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Nf=.1,Ym={mode:3,pad:Nf},za={pad:0,soft:null,mode:0},cb={min:za,max:za};function sc(n,e,t,i){return cc(t)?$m(n,e,t):(za.pad=t,za.soft=i?0:null,za.mode=i?3:0,$m(n,e,cb))}function wt(n,e){return n??e}function ub(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function $m(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Bt),l=wt(s.hard,Bt),c=wt(i.soft,Bt),u=wt(s.soft,-Bt),h=wt(i.mode,0),f=wt(s.mode,0),d=e-n,p=Es(d),y=jn(An(n),An(e)),_=Es(y),m=An(_-p);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,h==2&&c!=Bt&&(r=0),f==2&&u!=-Bt&&(o=0)));let b=d||y||1e3,A=Es(b),S=To(10,pi(A)),R=b*(d==0?n==0?.1:1:r),C=kt(Ag(n-R,S/10),24),v=n>=c&&(h==1||h==3&&C<=c||h==2&&C>=c)?c:Bt,T=jn(a,C<v&&n>=v?v:Xi(v,C)),F=b*(d==0?e==0?.1:1:o),D=kt(lc(e+F,S/10),24),L=e<=u&&(f==1||f==3&&D>=u||f==2&&D<=u)?u:-Bt,k=Xi(l,D>L&&e<=L?L:jn(L,D));return T==k&&T==0&&(k=100),[T,k]}var hb=new Intl.NumberFormat(Ro?rb.language:"en-US"),Uf=n=>hb.format(n),mi=Math,nc=mi.PI,An=mi.abs,pi=mi.floor,En=mi.round,Di=mi.ceil,Xi=mi.min,jn=mi.max,To=mi.pow,Zm=mi.sign,Es=mi.log10,Mg=mi.log2,fb=(n,e=1)=>mi.sinh(n)*e,gf=(n,e=1)=>mi.asinh(n/e),Bt=1/0;function Km(n){return(Es((n^n>>31)-(n>>31))|0)+1}function wf(n,e,t){return Xi(jn(n,e),t)}function wg(n){return typeof n=="function"}function vt(n){return wg(n)?n:()=>n}var db=()=>{},Tg=n=>n,Eg=(n,e)=>e,pb=n=>null,Jm=n=>!0,jm=(n,e)=>n==e,mb=/\.\d*?(?=9{6,}|0{6,})/gm,kr=n=>{if(Rg(n)||er.has(n))return n;let e=`${n}`,t=e.match(mb);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${kr(s)}e${r}`}return kt(n,i)};function Ur(n,e){return kr(kt(kr(n/e))*e)}function lc(n,e){return kr(Di(kr(n/e))*e)}function Ag(n,e){return kr(pi(kr(n/e))*e)}function kt(n,e=0){if(Rg(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return En(i)/t}var er=new Map;function Cg(n){return((""+n).split(".")[1]||"").length}function Va(n,e,t,i){let s=[],r=i.map(Cg);for(let o=e;o<t;o++){let a=An(o),l=kt(To(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?u:kt(u,h);s.push(f),er.set(f,h)}}return s}var Ga={},Ff=[],Eo=[null,null],Qs=Array.isArray,Rg=Number.isInteger,gb=n=>n===void 0;function Qm(n){return typeof n=="string"}function cc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function _b(n){return n!=null&&typeof n=="object"}var vb=Object.getPrototypeOf(Uint8Array),Pg="__proto__";function Ao(n,e=cc){let t;if(Qs(n)){let i=n.find(s=>s!=null);if(Qs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Ao(n[s],e)}else t=n.slice()}else if(n instanceof vb)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Pg&&(t[i]=Ao(n[i],e))}else t=n;return t}function bn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Pg&&(cc(n[s])?bn(n[s],Ao(i[s])):n[s]=Ao(i[s]))}return n}var yb=0,xb=1,bb=2;function Sb(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Mb(n,e){if(Eb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Ab(o[0])||(o=Tb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=e?e[o][c]:xb,d=[];for(let p=0;p<u.length;p++){let y=u[p],_=r.get(l[p]);y===null?f!=yb&&(h[_]=y,f==bb&&d.push(_)):h[_]=y}Sb(h,d,s),i.push(h)}}return i}var wb=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Tb(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Eb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Ab(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=jn(1,pi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Ig=["January","February","March","April","May","June","July","August","September","October","November","December"],Lg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Dg(n){return n.slice(0,3)}var Cb=Lg.map(Dg),Rb=Ig.map(Dg),Pb={MMMM:Ig,MMM:Rb,WWWW:Lg,WWW:Cb};function Fa(n){return(n<10?"0":"")+n}function Ib(n){return(n<10?"00":n<100?"0":"")+n}var Lb={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Fa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Fa(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Fa(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Fa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Fa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Ib(n.getMilliseconds())};function Of(n,e){e=e||Pb;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Lb[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Db=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Nb(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Db?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Ng=n=>n%1==0,rc=[1,2,2.5,5],Ub=Va(10,-32,0,rc),Ug=Va(10,0,32,rc),Fb=Ug.filter(Ng),Fr=Ub.concat(Ug),Bf=`
`,Fg="{YYYY}",eg=Bf+Fg,Og="{M}/{D}",ka=Bf+Og,ec=ka+"/{YY}",Bg="{aa}",Ob="{h}:{mm}",Mo=Ob+Bg,tg=Bf+Mo,ng=":{ss}",Rt=null;function kg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Va(10,0,3,rc).filter(Ng):Va(10,-3,0,rc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Fg,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",eg,Rt,Rt,Rt,Rt,Rt,1],[s,Og,eg,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+Bg,ec,Rt,ka,Rt,Rt,Rt,1],[t,Mo,ec,Rt,ka,Rt,Rt,Rt,1],[e,ng,ec+" "+Mo,Rt,ka+" "+Mo,Rt,tg,Rt,1],[n,ng+".{fff}",ec+" "+Mo,Rt,ka+" "+Mo,Rt,tg,Rt,1]];function u(h){return(f,d,p,y,_,m)=>{let b=[],A=_>=o,S=_>=r&&_<o,R=h(p),C=kt(R*n,3),v=_f(R.getFullYear(),A?0:R.getMonth(),S||A?1:R.getDate()),T=kt(v*n,3);if(S||A){let F=S?_/r:0,D=A?_/o:0,L=C==T?C:kt(_f(v.getFullYear()+D,v.getMonth()+F,1)*n,3),k=new Date(En(L/n)),G=k.getFullYear(),U=k.getMonth();for(let H=0;L<=y;H++){let $=_f(G+D*H,U+F*H,1),V=$-h(kt($*n,3));L=kt((+$+V)*n,3),L<=y&&b.push(L)}}else{let F=_>=s?s:_,D=pi(p)-pi(C),L=T+D+lc(C-T,F);b.push(L);let k=h(L),G=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,U=_/i,H=f.axes[d]._space,$=m/H;for(;L=kt(L+_,n==1?0:3),!(L>y);)if(U>1){let V=pi(kt(G+U,6))%24,Q=h(L).getHours()-V;Q>1&&(Q=-1),L-=Q*i,G=(G+U)%24;let se=b[b.length-1];kt((L-se)/_,3)*$>=.7&&b.push(L)}else b.push(L)}return b}}return[l,c,u]}var[Bb,kb,zb]=kg(1),[Gb,Vb,Hb]=kg(.001);Va(2,-53,53,[1]);function ig(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function sg(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,h,f,d;return i.map(p=>{let y=n(p),_=y.getFullYear(),m=y.getMonth(),b=y.getDate(),A=y.getHours(),S=y.getMinutes(),R=y.getSeconds(),C=_!=l&&a[2]||m!=c&&a[3]||b!=u&&a[4]||A!=h&&a[5]||S!=f&&a[6]||R!=d&&a[7]||a[1];return l=_,c=m,u=b,h=A,f=S,d=R,C(y)})}}function Wb(n,e){let t=Of(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function _f(n,e,t){return new Date(n,e,t)}function rg(n,e){return e(n)}var qb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function og(n,e){return(t,i,s,r)=>r==null?If:e(n(i))}function Xb(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function Yb(n,e){return n.series[e].fill(n,e)}var $b={show:!0,live:!0,isolate:!1,mount:db,markers:{show:!0,width:2,stroke:Xb,fill:Yb,dash:"solid"},idx:null,idxs:null,values:[]};function Zb(n,e){let t=n.cursor.points,i=Li(),s=t.size(n,e);Yt(i,Oa,s),Yt(i,Ba,s);let r=s/-2;Yt(i,"marginLeft",r),Yt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Yt(i,"borderWidth",o),i}function Kb(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Jb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function jb(n,e){return n.series[e].points.size}var vf=[0,0];function Qb(n,e,t){return vf[0]=e,vf[1]=t,vf}function tc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function yf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var eS={show:!0,x:!0,y:!0,lock:!1,move:Qb,points:{one:!1,show:Zb,size:jb,width:0,stroke:Jb,fill:Kb},bind:{mousedown:tc,mouseup:tc,click:tc,dblclick:tc,mousemove:yf,mouseleave:yf,mouseenter:yf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},zg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},kf=bn({},zg,{filter:Eg}),Gg=bn({},kf,{size:10}),Vg=bn({},zg,{show:!1}),zf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Hg="bold "+zf,Wg=1.5,ag={show:!0,scale:"x",stroke:Pf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Hg,side:2,grid:kf,ticks:Gg,border:Vg,font:zf,lineGap:Wg,rotate:0},tS="Value",nS="Time",lg={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function iS(n,e,t,i,s){return e.map(r=>r==null?"":Uf(r))}function sS(n,e,t,i,s,r,o){let a=[],l=er.get(s)||0;t=o?t:kt(lc(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Tf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Es:Mg,u=pi(c(t));s=To(l,u),l==10&&(s=Fr[qi(s,Fr)]);let h=t,f=s*l;l==10&&(f=Fr[qi(f,Fr)]);do a.push(h),h=h+s,l==10&&!er.has(h)&&(h=kt(h,er.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Fr[qi(f,Fr)]));while(h<=i);return a}function rS(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Tf(n,e,jn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Tf(n,e,jn(l,-i),-t,s):[l]).reverse().map(f=>-f).concat(u,c)}var qg=/./,oS=/[12357]/,aS=/[125]/,cg=/1/,Ef=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function lS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?qg:l(7,o)-u>=c?oS:l(5,o)-u>=c?aS:cg;if(h==cg){let f=An(l(1,o)-u);if(f<c)return Ef(e.slice().reverse(),a.distr,h,Di(c/f)).reverse()}return Ef(e,a.distr,h,1)}function cS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=An(l(1,o)-l(2,o));return c<a?Ef(e.slice().reverse(),3,qg,Di(a/c)).reverse():e}function uS(n,e,t,i){return i==null?If:e==null?"":Uf(e)}var ug={show:!0,scale:"y",stroke:Pf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Hg,side:3,grid:kf,ticks:Gg,border:Vg,font:zf,lineGap:Wg,rotate:0};function hS(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function fS(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=An(o-r),l=n.series[e],c=a/(l.points.space*At);return i[1]-i[0]<=c}var hg={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},Xg=(n,e,t,i,s)=>s,fg={show:!0,auto:!0,sorted:0,gaps:Xg,alpha:1,facets:[bn({},hg,{scale:"x"}),bn({},hg,{scale:"y"})]},dg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Xg,alpha:1,points:{show:fS,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function dS(n,e,t,i,s){return t/10}var Yg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},pS=bn({},Yg,{time:!1,ori:1}),pg={};function $g(n,e){let t=pg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(pg[n]=t)),t}var Co=1,Af=2;function zr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],h=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,p=a.width,y=a.height,_=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,h,_,m,f,d,p,y,hc,Po,dc,Kg,jg):t(s,l,c,u,h,m,_,d,f,y,p,fc,Io,Hf,Jg,Qg)}function Gf(n,e){let t=0,i=0,s=wt(n.bands,Ff);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function mS(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function As(n,e,t,i,s,r){return zr(n,e,(o,a,l,c,u,h,f,d,p,y,_)=>{let m=o.pxRound,b=c.dir*(c.ori==0?1:-1),A=c.ori==0?Po:Io,S,R;b==1?(S=t,R=i):(S=i,R=t);let C=m(h(a[S],c,y,d)),v=m(f(l[S],u,_,p)),T=m(h(a[R],c,y,d)),F=m(f(r==1?u.max:u.min,u,_,p)),D=new Path2D(s);return A(D,T,F),A(D,C,F),A(D,C,v),D})}function uc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?dc:Hf,l=t;for(let h=0;h<n.length;h++){let f=n[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function gS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Vf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let h=c,f=c;if(s==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=r(n[h]),p=f==h?d:r(n[f]),y=h-s;d=o<=0&&y>=0&&y<l?r(n[y]):d;let m=f+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=d&&a.push([d,p])}return a}function mg(n){return n==0?Tg:n==1?En:e=>Ur(e,n)}function Zg(n){let e=n==0?hc:fc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Xi(c,a/2,l/2),u=Xi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var hc=(n,e,t)=>{n.moveTo(e,t)},fc=(n,e,t)=>{n.moveTo(t,e)},Po=(n,e,t)=>{n.lineTo(e,t)},Io=(n,e,t)=>{n.lineTo(t,e)},dc=Zg(0),Hf=Zg(1),Kg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Jg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},jg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Qg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function e_(n){return(e,t,i,s,r)=>zr(e,t,(o,a,l,c,u,h,f,d,p,y,_)=>{let{pxRound:m,points:b}=o,A,S;c.ori==0?(A=hc,S=Kg):(A=fc,S=Jg);let R=kt(b.width*At,3),C=(b.size-b.width)/2*At,v=kt(C*2,3),T=new Path2D,F=new Path2D,{left:D,top:L,width:k,height:G}=e.bbox;dc(F,D-v,L-v,k+v*2,G+v*2);let U=H=>{if(l[H]!=null){let $=m(h(a[H],c,y,d)),V=m(f(l[H],u,_,p));A(T,$+C,V),S(T,$,V,C,0,nc*2)}};if(r)r.forEach(U);else for(let H=i;H<=s;H++)U(H);return{stroke:R>0?T:null,fill:T,clip:F,flags:Co|Af}})}function t_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var _S=t_(Po),vS=t_(Io);function n_(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>zr(t,i,(o,a,l,c,u,h,f,d,p,y,_)=>{[s,r]=oc(l,s,r);let m=o.pxRound,b=G=>m(h(G,c,y,d)),A=G=>m(f(G,u,_,p)),S,R;c.ori==0?(S=Po,R=_S):(S=Io,R=vS);let C=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Co},T=v.stroke,F=!1;if(r-s>=y*4){let G=he=>t.posToVal(he,c.key,!0),U=null,H=null,$,V,ae,X=b(a[C==1?s:r]),Q=b(a[s]),se=b(a[r]),fe=G(C==1?Q+1:se-1);for(let he=C==1?s:r;he>=s&&he<=r;he+=C){let ee=a[he],ve=(C==1?ee<fe:ee>fe)?X:b(ee),Ae=l[he];ve==X?Ae!=null?(V=Ae,U==null?(S(T,ve,A(V)),$=U=H=V):V<U?U=V:V>H&&(H=V)):Ae===null&&(F=!0):(U!=null&&R(T,X,A(U),A(H),A($),A(V)),Ae!=null?(V=Ae,S(T,ve,A(V)),U=H=$=V):(U=H=null,Ae===null&&(F=!0)),X=ve,fe=G(X+C))}U!=null&&U!=H&&ae!=X&&R(T,X,A(U),A(H),A($),A(V))}else for(let G=C==1?s:r;G>=s&&G<=r;G+=C){let U=l[G];U===null?F=!0:U!=null&&S(T,b(a[G]),A(U))}let[L,k]=Gf(t,i);if(o.fill!=null||L!=0){let G=v.fill=new Path2D(T),U=o.fillTo(t,i,o.min,o.max,L),H=A(U),$=b(a[s]),V=b(a[r]);C==-1&&([V,$]=[$,V]),S(G,V,H),S(G,$,H)}if(!o.spanGaps){let G=[];F&&G.push(...Vf(a,l,s,r,C,b,e)),v.gaps=G=o.gaps(t,i,s,r,G),v.clip=uc(G,c.ori,d,p,y,_)}return k!=0&&(v.band=k==2?[As(t,i,s,r,T,-1),As(t,i,s,r,T,1)]:As(t,i,s,r,T,k)),v})}function yS(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>zr(r,o,(c,u,h,f,d,p,y,_,m,b,A)=>{[a,l]=oc(h,a,l);let S=c.pxRound,{left:R,width:C}=r.bbox,v=Q=>S(p(Q,f,b,_)),T=Q=>S(y(Q,d,A,m)),F=f.ori==0?Po:Io,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Co},L=D.stroke,k=f.dir*(f.ori==0?1:-1),G=T(h[k==1?a:l]),U=v(u[k==1?a:l]),H=U,$=U;s&&e==-1&&($=R,F(L,$,G)),F(L,U,G);for(let Q=k==1?a:l;Q>=a&&Q<=l;Q+=k){let se=h[Q];if(se==null)continue;let fe=v(u[Q]),he=T(se);e==1?F(L,fe,G):F(L,H,he),F(L,fe,he),G=he,H=fe}let V=H;s&&e==1&&(V=R+C,F(L,V,G));let[ae,X]=Gf(r,o);if(c.fill!=null||ae!=0){let Q=D.fill=new Path2D(L),se=c.fillTo(r,o,c.min,c.max,ae),fe=T(se);F(Q,V,fe),F(Q,$,fe)}if(!c.spanGaps){let Q=[];Q.push(...Vf(u,h,a,l,k,v,i));let se=c.width*At/2,fe=t||e==1?se:-se,he=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),D.gaps=Q=c.gaps(r,o,a,l,Q),D.clip=uc(Q,f.ori,_,m,b,A)}return X!=0&&(D.band=X==2?[As(r,o,a,l,L,-1),As(r,o,a,l,L,1)]:As(r,o,a,l,L,X)),D})}function gg(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=An(n[l]-n[a]);u<c&&(c=u,o=An(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function xS(n){n=n||Ga;let e=wt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(n.disp,Ga),u=wt(n.each,d=>{}),{fill:h,stroke:f}=c;return(d,p,y,_)=>zr(d,p,(m,b,A,S,R,C,v,T,F,D,L)=>{let k=m.pxRound,G=t,U=i*At,H=a*At,$=l*At,V,ae;S.ori==0?[V,ae]=r(d,p):[ae,V]=r(d,p);let X=S.dir*(S.ori==0?1:-1),Q=S.ori==0?dc:Hf,se=S.ori==0?u:(Re,Ze,ot,Me,Ot,ze,Ye)=>{u(Re,Ze,ot,Ot,Me,Ye,ze)},fe=wt(d.bands,Ff).find(Re=>Re.series[0]==p),he=fe!=null?fe.dir:0,ee=m.fillTo(d,p,m.min,m.max,he),me=k(v(ee,R,L,F)),ve,Ae,Se,We=D,rt=k(m.width*At),Ve=!1,ft=null,ct=null,it=null,Zt=null;h!=null&&(rt==0||f!=null)&&(Ve=!0,ft=h.values(d,p,y,_),ct=new Map,new Set(ft).forEach(Re=>{Re!=null&&ct.set(Re,new Path2D)}),rt>0&&(it=f.values(d,p,y,_),Zt=new Map,new Set(it).forEach(Re=>{Re!=null&&Zt.set(Re,new Path2D)})));let{x0:zt,size:dn}=c;if(zt!=null&&dn!=null){G=1,b=zt.values(d,p,y,_),zt.unit==2&&(b=b.map(ot=>d.posToVal(T+ot*D,S.key,!0)));let Re=dn.values(d,p,y,_);dn.unit==2?Ae=Re[0]*D:Ae=C(Re[0],S,D,T)-C(0,S,D,T),We=gg(b,A,C,S,D,T,We),Se=We-Ae+U}else We=gg(b,A,C,S,D,T,We),Se=We*o+U,Ae=We-Se;Se<1&&(Se=0),rt>=Ae/2&&(rt=0),Se<5&&(k=Tg);let Ut=Se>0,In=We-Se-(Ut?rt:0);Ae=k(wf(In,$,H)),ve=(G==0?Ae/2:G==X?0:Ae)-G*X*((G==0?U/2:0)+(Ut?rt/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Mn=Ve?null:new Path2D,nn=null;if(fe!=null)nn=d.data[fe.series[1]];else{let{y0:Re,y1:Ze}=c;Re!=null&&Ze!=null&&(A=Ze.values(d,p,y,_),nn=Re.values(d,p,y,_))}let pn=V*Ae,B=ae*Ae;for(let Re=X==1?y:_;Re>=y&&Re<=_;Re+=X){let Ze=A[Re];if(Ze==null)continue;if(nn!=null){let q=nn[Re]??0;if(Ze-q==0)continue;me=v(q,R,L,F)}let ot=S.distr!=2||c!=null?b[Re]:Re,Me=C(ot,S,D,T),Ot=v(wt(Ze,ee),R,L,F),ze=k(Me-ve),Ye=k(jn(Ot,me)),P=k(Xi(Ot,me)),M=Ye-P;if(Ze!=null){let q=Ze<0?B:pn,ue=Ze<0?pn:B;Ve?(rt>0&&it[Re]!=null&&Q(Zt.get(it[Re]),ze,P+pi(rt/2),Ae,jn(0,M-rt),q,ue),ft[Re]!=null&&Q(ct.get(ft[Re]),ze,P+pi(rt/2),Ae,jn(0,M-rt),q,ue)):Q(Mn,ze,P+pi(rt/2),Ae,jn(0,M-rt),q,ue),se(d,p,Re,ze-rt/2,P,Ae+rt,M)}}return rt>0?bt.stroke=Ve?Zt:Mn:Ve||(bt._fill=m.width==0?m._fill:m._stroke??m._fill,bt.width=0),bt.fill=Ve?ct:Mn,bt})}function bS(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>zr(i,s,(a,l,c,u,h,f,d,p,y,_,m)=>{[r,o]=oc(c,r,o);let b=a.pxRound,A=V=>b(f(V,u,_,p)),S=V=>b(d(V,h,m,y)),R,C,v;u.ori==0?(R=hc,v=Po,C=jg):(R=fc,v=Io,C=Qg);let T=u.dir*(u.ori==0?1:-1),F=A(l[T==1?r:o]),D=F,L=[],k=[];for(let V=T==1?r:o;V>=r&&V<=o;V+=T)if(c[V]!=null){let X=l[V],Q=A(X);L.push(D=Q),k.push(S(c[V]))}let G={stroke:n(L,k,R,v,C,b),fill:null,clip:null,band:null,gaps:null,flags:Co},U=G.stroke,[H,$]=Gf(i,s);if(a.fill!=null||H!=0){let V=G.fill=new Path2D(U),ae=a.fillTo(i,s,a.min,a.max,H),X=S(ae);v(V,D,X),v(V,F,X)}if(!a.spanGaps){let V=[];V.push(...Vf(l,c,r,o,T,A,t)),G.gaps=V=a.gaps(i,s,r,o,V),G.clip=uc(V,u.ori,p,y,_,m)}return $!=0&&(G.band=$==2?[As(i,s,r,o,U,-1),As(i,s,r,o,U,1)]:As(i,s,r,o,U,$)),G})}function SS(n){return bS(MS,n)}function MS(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=n[f+1]-n[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+h[f]/3,e[f]+l[f]*h[f]/3,n[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,n[f+1],e[f+1])}return a}var Cf=new Set;function _g(){for(let n of Cf)n.syncRect(!0)}Ro&&(Br(ib,wo,_g),Br(sb,wo,_g,!0),Br(ic,wo,()=>{Qt.pxRatio=At}));var wS=n_(),TS=e_();function vg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Rf(r,o,e,t))}function ES(n,e){return n.map((t,i)=>i==0?{}:bn({},e,t))}function Rf(n,e,t,i){return bn({},e==0?t:i,n)}function i_(n,e,t){return e==null?Eo:[e,t]}var AS=i_;function CS(n,e,t){return e==null?Eo:sc(e,t,Nf,!0)}function s_(n,e,t,i){return e==null?Eo:ac(e,t,n.scales[i].log,!1)}var RS=s_;function r_(n,e,t,i){return e==null?Eo:Df(e,t,n.scales[i].log,!1)}var PS=r_;function IS(n,e,t,i,s){let r=jn(Km(n),Km(e)),o=e-n,a=qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?er.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function yg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=En((t=+s)*At))+"px"),[n,e,t]}function LS(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*At,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Qt(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(x,w,I,N){let W=w.valToPct(x);return N+I*(w.dir==-1?1-W:W)}function o(x,w,I,N){let W=w.valToPct(x);return N+I*(w.dir==-1?W:1-W)}function a(x,w,I,N){return w.ori==0?r(x,w,I,N):o(x,w,I,N)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Li(kx);if(n.id!=null&&(c.id=n.id),di(c,n.class),n.title){let x=Li(Vx,c);x.textContent=n.title}let u=Wi("canvas"),h=i.ctx=u.getContext("2d"),f=Li(Hx,c);Br("click",f,x=>{x.target===p&&(Wt!=co||Kt!=uo)&&Bn.click(i,x)},!0);let d=i.under=Li(Wx,f);f.appendChild(u);let p=i.over=Li(qx,f);n=Ao(n);let y=+wt(n.pxAlign,1),_=mg(y);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let m=n.ms||.001,b=i.series=s==1?vg(n.series||[],lg,dg,!1):ES(n.series||[null],fg),A=i.axes=vg(n.axes||[],ag,ug,!0),S=i.scales={},R=i.bands=n.bands||[];R.forEach(x=>{x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1)});let C=s==2?b[1].facets[0].scale:b[0].scale,v={axes:Ms,series:pt},T=(n.drawOrder||["axes","series"]).map(x=>v[x]);function F(x){let w=x.distr==3?I=>Es(I>0?I:x.clamp(i,I,x.min,x.max,x.key)):x.distr==4?I=>gf(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let N=w(I),{_min:W,_max:J}=x,le=J-W;return(N-W)/le}}function D(x){let w=S[x];if(w==null){let I=(n.scales||Ga)[x]||Ga;if(I.from!=null){D(I.from);let N=bn({},S[I.from],I,{key:x});N.valToPct=F(N),S[x]=N}else{w=S[x]=bn({},x==C?Yg:pS,I),w.key=x;let N=w.time,W=w.range,J=Qs(W);if((x!=C||s==2&&!N)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Ym:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Ym:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&cc(W))){let le=W;W=(de,xe,De)=>xe==null?Eo:sc(xe,De,le)}w.range=vt(W||(N?AS:x==C?w.distr==3?RS:w.distr==4?PS:i_:w.distr==3?s_:w.distr==4?r_:CS)),w.auto=vt(J?!1:w.auto),w.clamp=vt(w.clamp||dS),w._min=w._max=null,w.valToPct=F(w)}}}D("x"),D("y"),s==1&&b.forEach(x=>{D(x.scale)}),A.forEach(x=>{D(x.scale)});for(let x in n.scales)D(x);let L=S[C],k=L.distr,G,U;L.ori==0?(di(c,zx),G=r,U=o):(di(c,Gx),G=o,U=r);let H={};for(let x in S){let w=S[x];(w.min!=null||w.max!=null)&&(H[x]={min:w.min,max:w.max},w.min=w.max=null)}let $=n.tzDate||(x=>new Date(En(x/m))),V=n.fmtDate||Of,ae=m==1?zb($):Hb($),X=sg($,ig(m==1?kb:Vb,V)),Q=og($,rg(qb,V)),se=[],fe=i.legend=bn({},$b,n.legend),he=i.cursor=bn({},eS,{drag:{y:s==2}},n.cursor),ee=fe.show,me=he.show,ve=fe.markers;fe.idxs=se,ve.width=vt(ve.width),ve.dash=vt(ve.dash),ve.stroke=vt(ve.stroke),ve.fill=vt(ve.fill);let Ae,Se,We,rt=[],Ve=[],ft,ct=!1,it={};if(fe.live){let x=b[1]?b[1].values:null;ct=x!=null,ft=ct?x(i,1,0):{_:0};for(let w in ft)it[w]=If}if(ee)if(Ae=Wi("table",Jx,c),We=Wi("tbody",null,Ae),fe.mount(i,Ae),ct){Se=Wi("thead",null,Ae,We);let x=Wi("tr",null,Se);Wi("th",null,x);for(var Zt in ft)Wi("th",Nm,x).textContent=Zt}else di(Ae,Qx),fe.live&&di(Ae,jx);let zt={show:!0},dn={show:!1};function Ut(x,w){if(w==0&&(ct||!fe.live||s==2))return Eo;let I=[],N=Wi("tr",eb,We,We.childNodes[w]);di(N,x.class),x.show||di(N,Or);let W=Wi("th",null,N);if(ve.show){let de=Li(tb,W);if(w>0){let xe=ve.width(i,w);xe&&(de.style.border=xe+"px "+ve.dash(i,w)+" "+ve.stroke(i,w)),de.style.background=ve.fill(i,w)}}let J=Li(Nm,W);x.label instanceof HTMLElement?J.appendChild(x.label):J.textContent=x.label,w>0&&(ve.show||(J.style.color=x.width>0?ve.stroke(i,w):ve.fill(i,w)),bt("click",W,de=>{if(he._lock)return;Je(de);let xe=b.indexOf(x);if((de.ctrlKey||de.metaKey)!=fe.isolate){let De=b.some((Ne,Fe)=>Fe>0&&Fe!=xe&&Ne.show);b.forEach((Ne,Fe)=>{Fe>0&&rs(Fe,De?Fe==xe?zt:dn:zt,!0,vn.setSeries)})}else rs(xe,{show:!x.show},!0,vn.setSeries)},!1),je&&bt(Bm,W,de=>{he._lock||(Je(de),rs(b.indexOf(x),fo,!0,vn.setSeries))},!1));for(var le in ft){let de=Wi("td",nb,N);de.textContent="--",I.push(de)}return[N,I]}let In=new Map;function bt(x,w,I,N=!0){let W=In.get(w)||{},J=he.bind[x](i,w,I,N);J&&(Br(x,w,W[x]=J),In.set(w,W))}function Mn(x,w,I){let N=In.get(w)||{};for(let W in N)(x==null||W==x)&&(Mf(W,w,N[W]),delete N[W]);x==null&&In.delete(w)}let nn=0,pn=0,B=0,Re=0,Ze=0,ot=0,Me=Ze,Ot=ot,ze=B,Ye=Re,P=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,_e=!1,ye=!1,te=!1,ie=!1,pe=!1;function O(x,w,I){(I||x!=i.width||w!=i.height)&&re(x,w),ut(!1),ye=!0,_e=!0,Gn()}function re(x,w){i.width=nn=B=x,i.height=pn=Re=w,Ze=ot=0,be(),He();let I=i.bbox;P=I.left=Ur(Ze*At,.5),M=I.top=Ur(ot*At,.5),q=I.width=Ur(B*At,.5),ue=I.height=Ur(Re*At,.5)}let ne=3;function we(){let x=!1,w=0;for(;!x;){w++;let I=oo(w),N=ss(w);x=w==ne||I&&N,x||(re(i.width,i.height),_e=!0)}}function ge({width:x,height:w}){O(x,w)}i.setSize=ge;function be(){let x=!1,w=!1,I=!1,N=!1;A.forEach((W,J)=>{if(W.show&&W._show){let{side:le,_size:de}=W,xe=le%2,De=W.label!=null?W.labelSize:0,Ne=de+De;Ne>0&&(xe?(B-=Ne,le==3?(Ze+=Ne,N=!0):I=!0):(Re-=Ne,le==0?(ot+=Ne,x=!0):w=!0))}}),ns[0]=x,ns[1]=I,ns[2]=w,ns[3]=N,B-=Bi[1]+Bi[3],Ze+=Bi[3],Re-=Bi[2]+Bi[0],ot+=Bi[0]}function He(){let x=Ze+B,w=ot+Re,I=Ze,N=ot;function W(J,le){switch(J){case 1:return x+=le,x-le;case 2:return w+=le,w-le;case 3:return I-=le,I+le;case 0:return N-=le,N+le}}A.forEach((J,le)=>{if(J.show&&J._show){let de=J.side;J._pos=W(de,J._size),J.label!=null&&(J._lpos=W(de,J.labelSize))}})}if(he.dataIdx==null){let x=he.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let I=x.prox=vt(x.prox),N=x.bias??=0;he.dataIdx=(W,J,le,de)=>{if(J==0)return le;let xe=le,De=I(W,J,le,de)??Bt,Ne=De>=0&&De<Bt,Fe=L.ori==0?B:Re,st=he.left,Tt=e[0],Mt=e[J];if(w.has(Mt[le])){xe=null;let gt=null,Ke=null,qe;if(N==0||N==-1)for(qe=le;gt==null&&qe-- >0;)w.has(Mt[qe])||(gt=qe);if(N==0||N==1)for(qe=le;Ke==null&&qe++<Mt.length;)w.has(Mt[qe])||(Ke=qe);if(gt!=null||Ke!=null)if(Ne){let Xt=gt==null?-1/0:G(Tt[gt],L,Fe,0),on=Ke==null?1/0:G(Tt[Ke],L,Fe,0),Un=st-Xt,Ft=on-st;Un<=Ft?Un<=De&&(xe=gt):Ft<=De&&(xe=Ke)}else xe=Ke==null?gt:gt==null?Ke:le-gt<=Ke-le?gt:Ke}else Ne&&An(st-G(Tt[le],L,Fe,0))>De&&(xe=null);return xe}}let Je=x=>{he.event=x};he.idxs=se,he._lock=!1;let ce=he.points;ce.show=vt(ce.show),ce.size=vt(ce.size),ce.stroke=vt(ce.stroke),ce.width=vt(ce.width),ce.fill=vt(ce.fill);let Oe=i.focus=bn({},n.focus||{alpha:.3},he.focus),je=Oe.prox>=0,Ce=je&&ce.one,lt=[],Ht=[],Xn=[];function _a(x,w){let I=ce.show(i,w);if(I instanceof HTMLElement)return di(I,Kx),di(I,x.class),hs(I,-10,-10,B,Re),p.insertBefore(I,lt[w]),I}function io(x,w){if(s==1||w>0){let I=s==1&&S[x.scale].time,N=x.value;x.value=I?Qm(N)?og($,rg(N,V)):N||Q:N||uS,x.label=x.label||(I?nS:tS)}if(Ce||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||wS||pb,x.fillTo=vt(x.fillTo||mS),x.pxAlign=+wt(x.pxAlign,y),x.pxRound=mg(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=hS(jn(1,x.width),1),N=x.points=bn({},{size:I,width:jn(1,I*.2),stroke:x.stroke,space:I*2,paths:TS,_stroke:null,_fill:null},x.points);N.show=vt(N.show),N.filter=vt(N.filter),N.fill=vt(N.fill),N.stroke=vt(N.stroke),N.paths=vt(N.paths),N.pxAlign=x.pxAlign}if(ee){let I=Ut(x,w);rt.splice(w,0,I[0]),Ve.splice(w,0,I[1]),fe.values.push(null)}if(me){se.splice(w,0,null);let I=null;Ce?w==0&&(I=_a(x,w)):w>0&&(I=_a(x,w)),lt.splice(w,0,I),Ht.splice(w,0,0),Xn.splice(w,0,0)}Nn("addSeries",w)}function Fh(x,w){w=w??b.length,x=s==1?Rf(x,w,lg,dg):Rf(x,w,{},fg),b.splice(w,0,x),io(b[w],w)}i.addSeries=Fh;function Pl(x){if(b.splice(x,1),ee){fe.values.splice(x,1),Ve.splice(x,1);let w=rt.splice(x,1)[0];Mn(null,w.firstChild),w.remove()}me&&(se.splice(x,1),lt.splice(x,1)[0].remove(),Ht.splice(x,1),Xn.splice(x,1)),Nn("delSeries",x)}i.delSeries=Pl;let ns=[!1,!1,!1,!1];function xs(x,w){if(x._show=x.show,x.show){let I=x.side%2,N=S[x.scale];N==null&&(x.scale=I?b[1].scale:C,N=S[x.scale]);let W=N.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),Qs(x.incrs)&&x.incrs.forEach(le=>{!er.has(le)&&er.set(le,Cg(le))}),x.incrs=vt(x.incrs||(N.distr==2?Fb:W?m==1?Bb:Gb:Fr)),x.splits=vt(x.splits||(W&&N.distr==1?ae:N.distr==3?Tf:N.distr==4?rS:sS)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let J=x.values;x.values=Qs(J)&&!Qs(J[0])?vt(J):W?Qs(J)?sg($,ig(J,V)):Qm(J)?Wb($,J):J||X:J||iS,x.filter=vt(x.filter||(N.distr>=3&&N.log==10?lS:N.distr==3&&N.log==2?cS:Eg)),x.font=yg(x.font),x.labelFont=yg(x.labelFont),x._size=x.size(i,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(ns[w]=!0,x._el=Li(Xx,f))}}function bs(x,w,I,N){let[W,J,le,de]=I,xe=w%2,De=0;return xe==0&&(de||J)&&(De=w==0&&!W||w==2&&!le?En(ag.size/3):0),xe==1&&(W||le)&&(De=w==1&&!J||w==3&&!de?En(ug.size/2):0),De}let va=i.padding=(n.padding||[bs,bs,bs,bs]).map(x=>vt(wt(x,bs))),Bi=i._padding=va.map((x,w)=>x(i,w,ns,0)),sn,cn=null,un=null,is=s==1?b[0].idxs:null,ci=null,Ws=!1;function ya(x,w){if(e=x??[],i.data=i._data=e,s==2){sn=0;for(let I=1;I<b.length;I++)sn+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),ci=e[0],sn=ci.length;let I=e;if(k==2){I=e.slice();let N=I[0]=Array(sn);for(let W=0;W<sn;W++)N[W]=W}i._data=e=I}if(ut(!0),Nn("setData"),k==2&&(ye=!0),w!==!1){let I=L;I.auto(i,Ws)?xa():Ys(C,I.min,I.max),te=te||he.left>=0,pe=!0,Gn()}}i.setData=ya;function xa(){Ws=!0;let x,w;s==1&&(sn>0?(cn=is[0]=0,un=is[1]=sn-1,x=e[0][cn],w=e[0][un],k==2?(x=cn,w=un):x==w&&(k==3?[x,w]=ac(x,x,L.log,!1):k==4?[x,w]=Df(x,x,L.log,!1):L.time?w=x+En(86400/m):[x,w]=sc(x,w,Nf,!0))):(cn=is[0]=x=null,un=is[1]=w=null)),Ys(C,x,w)}let so,qs,ro,E,z,j,Y,Z,Te,Pe;function Ee(x,w,I,N,W,J){x??=Fm,I??=Ff,N??="butt",W??=Fm,J??="round",x!=so&&(h.strokeStyle=so=x),W!=qs&&(h.fillStyle=qs=W),w!=ro&&(h.lineWidth=ro=w),J!=z&&(h.lineJoin=z=J),N!=j&&(h.lineCap=j=N),I!=E&&h.setLineDash(E=I)}function Ie(x,w,I,N){w!=qs&&(h.fillStyle=qs=w),x!=Y&&(h.font=Y=x),I!=Z&&(h.textAlign=Z=I),N!=Te&&(h.textBaseline=Te=N)}function ke(x,w,I,N,W=0){if(N.length>0&&x.auto(i,Ws)&&(w==null||w.min==null)){let J=wt(cn,0),le=wt(un,N.length-1),de=I.min==null?lb(N,J,le,W,x.distr==3):[I.min,I.max];x.min=Xi(x.min,I.min=de[0]),x.max=jn(x.max,I.max=de[1])}}let et={min:null,max:null};function dt(){for(let N in S){let W=S[N];H[N]==null&&(W.min==null||H[C]!=null&&W.auto(i,Ws))&&(H[N]=et)}for(let N in S){let W=S[N];H[N]==null&&W.from!=null&&H[W.from]!=null&&(H[N]=et)}H[C]!=null&&ut(!0);let x={};for(let N in H){let W=H[N];if(W!=null){let J=x[N]=Ao(S[N],_b);if(W.min!=null)bn(J,W);else if(N!=C||s==2)if(sn==0&&J.from==null){let le=J.range(i,null,null,N);J.min=le[0],J.max=le[1]}else J.min=Bt,J.max=-Bt}}if(sn>0){b.forEach((N,W)=>{if(s==1){let J=N.scale,le=H[J];if(le==null)return;let de=x[J];if(W==0){let xe=de.range(i,de.min,de.max,J);de.min=xe[0],de.max=xe[1],cn=qi(de.min,e[0]),un=qi(de.max,e[0]),un-cn>1&&(e[0][cn]<de.min&&cn++,e[0][un]>de.max&&un--),N.min=ci[cn],N.max=ci[un]}else N.show&&N.auto&&ke(de,le,N,e[W],N.sorted);N.idxs[0]=cn,N.idxs[1]=un}else if(W>0&&N.show&&N.auto){let[J,le]=N.facets,de=J.scale,xe=le.scale,[De,Ne]=e[W],Fe=x[de],st=x[xe];Fe!=null&&ke(Fe,H[de],J,De,J.sorted),st!=null&&ke(st,H[xe],le,Ne,le.sorted),N.min=le.min,N.max=le.max}});for(let N in x){let W=x[N],J=H[N];if(W.from==null&&(J==null||J.min==null)){let le=W.range(i,W.min==Bt?null:W.min,W.max==-Bt?null:W.max,N);W.min=le[0],W.max=le[1]}}}for(let N in x){let W=x[N];if(W.from!=null){let J=x[W.from];if(J.min==null)W.min=W.max=null;else{let le=W.range(i,J.min,J.max,N);W.min=le[0],W.max=le[1]}}}let w={},I=!1;for(let N in x){let W=x[N],J=S[N];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let le=J.distr;J._min=le==3?Es(J.min):le==4?gf(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?Es(J.max):le==4?gf(J.max,J.asinh):le==100?J.fwd(J.max):J.max,w[N]=I=!0}}if(I){b.forEach((N,W)=>{s==2?W>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)ye=!0,Nn("setScale",N);me&&he.left>=0&&(te=pe=!0)}for(let N in H)H[N]=null}function Be(x){let w=wf(cn-1,0,sn-1),I=wf(un+1,0,sn-1);for(;x[w]==null&&w>0;)w--;for(;x[I]==null&&I<sn-1;)I++;return[w,I]}function pt(){if(sn>0){let x=b.some(w=>w._focus)&&Pe!=Oe.alpha;x&&(h.globalAlpha=Pe=Oe.alpha),b.forEach((w,I)=>{if(I>0&&w.show&&(jt(I,!1),jt(I,!0),w._paths==null)){let N=Pe;Pe!=w.alpha&&(h.globalAlpha=Pe=w.alpha);let W=s==2?[0,e[I][0].length-1]:Be(e[I]);w._paths=w.paths(i,I,W[0],W[1]),Pe!=N&&(h.globalAlpha=Pe=N)}}),b.forEach((w,I)=>{if(I>0&&w.show){let N=Pe;Pe!=w.alpha&&(h.globalAlpha=Pe=w.alpha),w._paths!=null&&It(I,!1);{let W=w._paths!=null?w._paths.gaps:null,J=w.points.show(i,I,cn,un,W),le=w.points.filter(i,I,J,W);(J||le)&&(w.points._paths=w.points.paths(i,I,cn,un,le),It(I,!0))}Pe!=N&&(h.globalAlpha=Pe=N),Nn("drawSeries",I)}}),x&&(h.globalAlpha=Pe=1)}}function jt(x,w){let I=w?b[x].points:b[x];I._stroke=I.stroke(i,x),I._fill=I.fill(i,x)}function It(x,w){let I=w?b[x].points:b[x],{stroke:N,fill:W,clip:J,flags:le,_stroke:de=I._stroke,_fill:xe=I._fill,_width:De=I.width}=I._paths;De=kt(De*At,3);let Ne=null,Fe=De%2/2;w&&xe==null&&(xe=De>0?"#fff":de);let st=I.pxAlign==1&&Fe>0;if(st&&h.translate(Fe,Fe),!w){let Tt=P-De/2,Mt=M-De/2,gt=q+De,Ke=ue+De;Ne=new Path2D,Ne.rect(Tt,Mt,gt,Ke)}w?Ue(de,De,I.dash,I.cap,xe,N,W,le,J):Lt(x,de,De,I.dash,I.cap,xe,N,W,le,Ne,J),st&&h.translate(-Fe,-Fe)}function Lt(x,w,I,N,W,J,le,de,xe,De,Ne){let Fe=!1;xe!=0&&R.forEach((st,Tt)=>{if(st.series[0]==x){let Mt=b[st.series[1]],gt=e[st.series[1]],Ke=(Mt._paths||Ga).band;Qs(Ke)&&(Ke=st.dir==1?Ke[0]:Ke[1]);let qe,Xt=null;Mt.show&&Ke&&ub(gt,cn,un)?(Xt=st.fill(i,Tt)||J,qe=Mt._paths.clip):Ke=null,Ue(w,I,N,W,Xt,le,de,xe,De,Ne,qe,Ke),Fe=!0}}),Fe||Ue(w,I,N,W,J,le,de,xe,De,Ne)}let wn=Co|Af;function Ue(x,w,I,N,W,J,le,de,xe,De,Ne,Fe){Ee(x,w,I,N,W),(xe||De||Fe)&&(h.save(),xe&&h.clip(xe),De&&h.clip(De)),Fe?(de&wn)==wn?(h.clip(Fe),Ne&&h.clip(Ne),_t(W,le),mn(x,J,w)):de&Af?(_t(W,le),h.clip(Fe),mn(x,J,w)):de&Co&&(h.save(),h.clip(Fe),Ne&&h.clip(Ne),_t(W,le),h.restore(),mn(x,J,w)):(_t(W,le),mn(x,J,w)),(xe||De||Fe)&&h.restore()}function mn(x,w,I){I>0&&(w instanceof Map?w.forEach((N,W)=>{h.strokeStyle=so=W,h.stroke(N)}):w!=null&&x&&h.stroke(w))}function _t(x,w){w instanceof Map?w.forEach((I,N)=>{h.fillStyle=qs=N,h.fill(I)}):w!=null&&x&&h.fill(w)}function Ss(x,w,I,N){let W=A[x],J;if(N<=0)J=[0,0];else{let le=W._space=W.space(i,x,w,I,N),de=W._incrs=W.incrs(i,x,w,I,N,le);J=IS(w,I,de,N,le)}return W._found=J}function gn(x,w,I,N,W,J,le,de,xe,De){let Ne=le%2/2;y==1&&h.translate(Ne,Ne),Ee(de,le,xe,De,de),h.beginPath();let Fe,st,Tt,Mt,gt=W+(N==0||N==3?-J:J);I==0?(st=W,Mt=gt):(Fe=W,Tt=gt);for(let Ke=0;Ke<x.length;Ke++)w[Ke]!=null&&(I==0?Fe=Tt=x[Ke]:st=Mt=x[Ke],h.moveTo(Fe,st),h.lineTo(Tt,Mt));h.stroke(),y==1&&h.translate(-Ne,-Ne)}function oo(x){let w=!0;return A.forEach((I,N)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,ut(!1));return}else I._show||(w=!1,I._show=!0,ut(!1));let J=I.side,le=J%2,{min:de,max:xe}=W,[De,Ne]=Ss(N,de,xe,le==0?B:Re);if(Ne==0)return;let Fe=W.distr==2,st=I._splits=I.splits(i,N,de,xe,De,Ne,Fe),Tt=W.distr==2?st.map(qe=>ci[qe]):st,Mt=W.distr==2?ci[st[1]]-ci[st[0]]:De,gt=I._values=I.values(i,I.filter(i,Tt,N,Ne,Mt),N,Ne,Mt);I._rotate=J==2?I.rotate(i,gt,N,Ne):0;let Ke=I._size;I._size=Di(I.size(i,gt,N,x)),Ke!=null&&I._size!=Ke&&(w=!1)}),w}function ss(x){let w=!0;return va.forEach((I,N)=>{let W=I(i,N,ns,x);W!=Bi[N]&&(w=!1),Bi[N]=W}),w}function Ms(){for(let x=0;x<A.length;x++){let w=A[x];if(!w.show||!w._show)continue;let I=w.side,N=I%2,W,J,le=w.stroke(i,x),de=I==0||I==3?-1:1,[xe,De]=w._found;if(w.label!=null){let Zn=w.labelGap*de,fi=En((w._lpos+Zn)*At);Ie(w.labelFont[0],le,"center",I==2?"top":Um),h.save(),N==1?(W=J=0,h.translate(fi,En(M+ue/2)),h.rotate((I==3?-nc:nc)/2)):(W=En(P+q/2),J=fi);let Pr=wg(w.label)?w.label(i,x,xe,De):w.label;h.fillText(Pr,W,J),h.restore()}if(De==0)continue;let Ne=S[w.scale],Fe=N==0?q:ue,st=N==0?P:M,Tt=w._splits,Mt=Ne.distr==2?Tt.map(Zn=>ci[Zn]):Tt,gt=Ne.distr==2?ci[Tt[1]]-ci[Tt[0]]:xe,Ke=w.ticks,qe=w.border,Xt=Ke.show?Ke.size:0,on=En(Xt*At),Un=En((w.alignTo==2?w._size-Xt-w.gap:w.gap)*At),Ft=w._rotate*-nc/180,an=_(w._pos*At),ui=(on+Un)*de,$n=an+ui;J=N==0?$n:0,W=N==1?$n:0;let Ei=w.font[0],ki=w.align==1?So:w.align==2?df:Ft>0?So:Ft<0?df:N==0?"center":I==3?df:So,as=Ft||N==1?"middle":I==2?"top":Um;Ie(Ei,le,ki,as);let hi=w.font[1]*w.lineGap,Ai=Tt.map(Zn=>_(a(Zn,Ne,Fe,st))),zi=w._values;for(let Zn=0;Zn<zi.length;Zn++){let fi=zi[Zn];if(fi!=null){N==0?W=Ai[Zn]:J=Ai[Zn],fi=""+fi;let Pr=fi.indexOf(`
`)==-1?[fi]:fi.split(/\n/gm);for(let Kn=0;Kn<Pr.length;Kn++){let Zp=Pr[Kn];Ft?(h.save(),h.translate(W,J+Kn*hi),h.rotate(Ft),h.fillText(Zp,0,0),h.restore()):h.fillText(Zp,W,J+Kn*hi)}}}Ke.show&&gn(Ai,Ke.filter(i,Mt,x,De,gt),N,I,an,on,kt(Ke.width*At,3),Ke.stroke(i,x),Ke.dash,Ke.cap);let ls=w.grid;ls.show&&gn(Ai,ls.filter(i,Mt,x,De,gt),N,N==0?2:1,N==0?M:P,N==0?ue:q,kt(ls.width*At,3),ls.stroke(i,x),ls.dash,ls.cap),qe.show&&gn([an],[1],N==0?1:0,N==0?1:2,N==1?M:P,N==1?ue:q,kt(qe.width*At,3),qe.stroke(i,x),qe.dash,qe.cap)}Nn("drawAxes")}function ut(x){b.forEach((w,I)=>{I>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let rn=!1,Yn=!1,Dt=[];function _n(){Yn=!1;for(let x=0;x<Dt.length;x++)Nn(...Dt[x]);Dt.length=0}function Gn(){rn||(wb(Ip),rn=!0)}function Il(x,w=!1){rn=!0,Yn=w,x(i),Ip(),w&&Dt.length>0&&queueMicrotask(_n)}i.batch=Il;function Ip(){if(oe&&(dt(),oe=!1),ye&&(we(),ye=!1),_e){if(Yt(d,So,Ze),Yt(d,"top",ot),Yt(d,Oa,B),Yt(d,Ba,Re),Yt(p,So,Ze),Yt(p,"top",ot),Yt(p,Oa,B),Yt(p,Ba,Re),Yt(f,Oa,nn),Yt(f,Ba,pn),u.width=En(nn*At),u.height=En(pn*At),A.forEach(({_el:x,_show:w,_size:I,_pos:N,side:W})=>{if(x!=null)if(w){let J=W===3||W===0?I:0,le=W%2==1;Yt(x,le?"left":"top",N-J),Yt(x,le?"width":"height",I),Yt(x,le?"top":"left",le?ot:Ze),Yt(x,le?"height":"width",le?Re:B),Sf(x,Or)}else di(x,Or)}),so=qs=ro=z=j=Y=Z=Te=E=null,Pe=1,Ma(!0),Ze!=Me||ot!=Ot||B!=ze||Re!=Ye){ut(!1);let x=B/ze,w=Re/Ye;if(me&&!te&&he.left>=0){he.left*=x,he.top*=w,ao&&hs(ao,En(he.left),0,B,Re),lo&&hs(lo,0,En(he.top),B,Re);for(let I=0;I<lt.length;I++){let N=lt[I];N!=null&&(Ht[I]*=x,Xn[I]*=w,hs(N,Di(Ht[I]),Di(Xn[I]),B,Re))}}if(qt.show&&!ie&&qt.left>=0&&qt.width>0){qt.left*=x,qt.width*=x,qt.top*=w,qt.height*=w;for(let I in Vh)Yt(ho,I,qt[I])}Me=Ze,Ot=ot,ze=B,Ye=Re}Nn("setSize"),_e=!1}nn>0&&pn>0&&(h.clearRect(0,0,u.width,u.height),Nn("drawClear"),T.forEach(x=>x()),Nn("draw")),qt.show&&ie&&(Ll(qt),ie=!1),me&&te&&(Rr(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(zh(),pe=!1),l||(l=!0,i.status=1,Nn("ready")),Ws=!1,rn=!1}i.redraw=(x,w)=>{ye=w||!1,x!==!1?Ys(C,L.min,L.max):Gn()};function Oh(x,w){let I=S[x];if(I.from==null){if(sn==0){let N=I.range(i,w.min,w.max,x);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(sn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==C&&I.distr==2&&sn>0&&(w.min=qi(w.min,e[0]),w.max=qi(w.max,e[0]),w.min==w.max&&w.max++),H[x]=w,oe=!0,Gn()}}i.setScale=Oh;let Bh,kh,ao,lo,Lp,Dp,co,uo,Np,Up,Wt,Kt,Xs=!1,Bn=he.drag,Ln=Bn.x,Dn=Bn.y;me&&(he.x&&(Bh=Li($x,p)),he.y&&(kh=Li(Zx,p)),L.ori==0?(ao=Bh,lo=kh):(ao=kh,lo=Bh),Wt=he.left,Kt=he.top);let qt=i.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ho=qt.show?Li(Yx,qt.over?p:d):null;function Ll(x,w){if(qt.show){for(let I in x)qt[I]=x[I],I in Vh&&Yt(ho,I,x[I]);w!==!1&&Nn("setSelect")}}i.setSelect=Ll;function Gy(x){if(b[x].show)ee&&Sf(rt[x],Or);else if(ee&&di(rt[x],Or),me){let I=Ce?lt[0]:lt[x];I!=null&&hs(I,-10,-10,B,Re)}}function Ys(x,w,I){Oh(x,{min:w,max:I})}function rs(x,w,I,N){w.focus!=null&&Xy(x),w.show!=null&&b.forEach((W,J)=>{J>0&&(x==J||x==null)&&(W.show=w.show,Gy(J),s==2?(Ys(W.facets[0].scale,null,null),Ys(W.facets[1].scale,null,null)):Ys(W.scale,null,null),Gn())}),I!==!1&&Nn("setSeries",x,w),N&&wa("setSeries",i,x,w)}i.setSeries=rs;function Vy(x,w){bn(R[x],w)}function Hy(x,w){x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1),w=w??R.length,R.splice(w,0,x)}function Wy(x){x==null?R.length=0:R.splice(x,1)}i.addBand=Hy,i.setBand=Vy,i.delBand=Wy;function qy(x,w){b[x].alpha=w,me&&lt[x]!=null&&(lt[x].style.opacity=w),ee&&rt[x]&&(rt[x].style.opacity=w)}let ws,$s,Cr,fo={focus:!0};function Xy(x){if(x!=Cr){let w=x==null,I=Oe.alpha!=1;b.forEach((N,W)=>{if(s==1||W>0){let J=w||W==0||W==x;N._focus=w?null:J,I&&qy(W,J?1:Oe.alpha)}}),Cr=x,I&&Gn()}}ee&&je&&bt(km,Ae,x=>{he._lock||(Je(x),Cr!=null&&rs(null,fo,!0,vn.setSeries))});function os(x,w,I){let N=S[w];I&&(x=x/At-(N.ori==1?ot:Ze));let W=B;N.ori==1&&(W=Re,x=W-x),N.dir==-1&&(x=W-x);let J=N._min,le=N._max,de=x/W,xe=J+(le-J)*de,De=N.distr;return De==3?To(10,xe):De==4?fb(xe,N.asinh):De==100?N.bwd(xe):xe}function Yy(x,w){let I=os(x,C,w);return qi(I,e[0],cn,un)}i.valToIdx=x=>qi(x,e[0]),i.posToIdx=Yy,i.posToVal=os,i.valToPos=(x,w,I)=>S[w].ori==0?r(x,S[w],I?q:B,I?P:0):o(x,S[w],I?ue:Re,I?M:0),i.setCursor=(x,w,I)=>{Wt=x.left,Kt=x.top,Rr(null,w,I)};function Fp(x,w){Yt(ho,So,qt.left=x),Yt(ho,Oa,qt.width=w)}function Op(x,w){Yt(ho,"top",qt.top=x),Yt(ho,Ba,qt.height=w)}let ba=L.ori==0?Fp:Op,Sa=L.ori==1?Fp:Op;function $y(){if(ee&&fe.live)for(let x=s==2?1:0;x<b.length;x++){if(x==0&&ct)continue;let w=fe.values[x],I=0;for(let N in w)Ve[x][I++].firstChild.nodeValue=w[N]}}function zh(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((I,N)=>{se[N]=I}):gb(x.idx)||se.fill(x.idx),fe.idx=se[0]),ee&&fe.live){for(let I=0;I<b.length;I++)(I>0||s==1&&!ct)&&Zy(I,se[I]);$y()}pe=!1,w!==!1&&Nn("setLegend")}i.setLegend=zh;function Zy(x,w){let I=b[x],N=x==0&&k==2?ci:e[x],W;ct?W=I.values(i,x,w)??it:(W=I.value(i,w==null?null:N[w],x,w),W=W==null?it:{_:W}),fe.values[x]=W}function Rr(x,w,I){Np=Wt,Up=Kt,[Wt,Kt]=he.move(i,Wt,Kt),he.left=Wt,he.top=Kt,me&&(ao&&hs(ao,En(Wt),0,B,Re),lo&&hs(lo,0,En(Kt),B,Re));let N,W=cn>un;ws=Bt,$s=null;let J=L.ori==0?B:Re,le=L.ori==1?B:Re;if(Wt<0||sn==0||W){N=he.idx=null;for(let de=0;de<b.length;de++){let xe=lt[de];xe!=null&&hs(xe,-10,-10,B,Re)}je&&rs(null,fo,!0,x==null&&vn.setSeries),fe.live&&(se.fill(N),pe=!0)}else{let de,xe,De;s==1&&(de=L.ori==0?Wt:Kt,xe=os(de,C),N=he.idx=qi(xe,e[0],cn,un),De=G(e[0][N],L,J,0));let Ne=-10,Fe=-10,st=0,Tt=0,Mt=!0,gt="",Ke="";for(let qe=s==2?1:0;qe<b.length;qe++){let Xt=b[qe],on=se[qe],Un=on==null?null:s==1?e[qe][on]:e[qe][1][on],Ft=he.dataIdx(i,qe,N,xe),an=Ft==null?null:s==1?e[qe][Ft]:e[qe][1][Ft];if(pe=pe||an!=Un||Ft!=on,se[qe]=Ft,qe>0&&Xt.show){let ui=Ft==null?-10:Ft==N?De:G(s==1?e[0][Ft]:e[qe][0][Ft],L,J,0),$n=an==null?-10:U(an,s==1?S[Xt.scale]:S[Xt.facets[1].scale],le,0);if(je&&an!=null){let Ei=L.ori==1?Wt:Kt,ki=An(Oe.dist(i,qe,Ft,$n,Ei));if(ki<ws){let as=Oe.bias;if(as!=0){let hi=os(Ei,Xt.scale),Ai=an>=0?1:-1,zi=hi>=0?1:-1;zi==Ai&&(zi==1?as==1?an>=hi:an<=hi:as==1?an<=hi:an>=hi)&&(ws=ki,$s=qe)}else ws=ki,$s=qe}}if(pe||Ce){let Ei,ki;L.ori==0?(Ei=ui,ki=$n):(Ei=$n,ki=ui);let as,hi,Ai,zi,ls,Zn,fi=!0,Pr=ce.bbox;if(Pr!=null){fi=!1;let Kn=Pr(i,qe);Ai=Kn.left,zi=Kn.top,as=Kn.width,hi=Kn.height}else Ai=Ei,zi=ki,as=hi=ce.size(i,qe);if(Zn=ce.fill(i,qe),ls=ce.stroke(i,qe),Ce)qe==$s&&ws<=Oe.prox&&(Ne=Ai,Fe=zi,st=as,Tt=hi,Mt=fi,gt=Zn,Ke=ls);else{let Kn=lt[qe];Kn!=null&&(Ht[qe]=Ai,Xn[qe]=zi,Xm(Kn,as,hi,fi),Wm(Kn,Zn,ls),hs(Kn,Di(Ai),Di(zi),B,Re))}}}}if(Ce){let qe=Oe.prox,Xt=Cr==null?ws<=qe:ws>qe||$s!=Cr;if(pe||Xt){let on=lt[0];on!=null&&(Ht[0]=Ne,Xn[0]=Fe,Xm(on,st,Tt,Mt),Wm(on,gt,Ke),hs(on,Di(Ne),Di(Fe),B,Re))}}}if(qt.show&&Xs)if(x!=null){let[de,xe]=vn.scales,[De,Ne]=vn.match,[Fe,st]=x.cursor.sync.scales,Tt=x.cursor.drag;if(Ln=Tt._x,Dn=Tt._y,Ln||Dn){let{left:Mt,top:gt,width:Ke,height:qe}=x.select,Xt=x.scales[Fe].ori,on=x.posToVal,Un,Ft,an,ui,$n,Ei=de!=null&&De(de,Fe),ki=xe!=null&&Ne(xe,st);Ei&&Ln?(Xt==0?(Un=Mt,Ft=Ke):(Un=gt,Ft=qe),an=S[de],ui=G(on(Un,Fe),an,J,0),$n=G(on(Un+Ft,Fe),an,J,0),ba(Xi(ui,$n),An($n-ui))):ba(0,J),ki&&Dn?(Xt==1?(Un=Mt,Ft=Ke):(Un=gt,Ft=qe),an=S[xe],ui=U(on(Un,st),an,le,0),$n=U(on(Un+Ft,st),an,le,0),Sa(Xi(ui,$n),An($n-ui))):Sa(0,le)}else Hh()}else{let de=An(Np-Lp),xe=An(Up-Dp);if(L.ori==1){let st=de;de=xe,xe=st}Ln=Bn.x&&de>=Bn.dist,Dn=Bn.y&&xe>=Bn.dist;let De=Bn.uni;De!=null?Ln&&Dn&&(Ln=de>=De,Dn=xe>=De,!Ln&&!Dn&&(xe>de?Dn=!0:Ln=!0)):Bn.x&&Bn.y&&(Ln||Dn)&&(Ln=Dn=!0);let Ne,Fe;Ln&&(L.ori==0?(Ne=co,Fe=Wt):(Ne=uo,Fe=Kt),ba(Xi(Ne,Fe),An(Fe-Ne)),Dn||Sa(0,le)),Dn&&(L.ori==1?(Ne=co,Fe=Wt):(Ne=uo,Fe=Kt),Sa(Xi(Ne,Fe),An(Fe-Ne)),Ln||ba(0,J)),!Ln&&!Dn&&(ba(0,0),Sa(0,0))}if(Bn._x=Ln,Bn._y=Dn,x==null){if(I){if($p!=null){let[de,xe]=vn.scales;vn.values[0]=de!=null?os(L.ori==0?Wt:Kt,de):null,vn.values[1]=xe!=null?os(L.ori==1?Wt:Kt,xe):null}wa(pf,i,Wt,Kt,B,Re,N)}if(je){let de=I&&vn.setSeries,xe=Oe.prox;Cr==null?ws<=xe&&rs($s,fo,!0,de):ws>xe?rs(null,fo,!0,de):$s!=Cr&&rs($s,fo,!0,de)}}pe&&(fe.idx=N,zh()),w!==!1&&Nn("setCursor")}let Zs=null;Object.defineProperty(i,"rect",{get(){return Zs==null&&Ma(!1),Zs}});function Ma(x=!1){x?Zs=null:(Zs=p.getBoundingClientRect(),Nn("syncRect",Zs))}function Bp(x,w,I,N,W,J,le){he._lock||Xs&&x!=null&&x.movementX==0&&x.movementY==0||(Gh(x,w,I,N,W,J,le,!1,x!=null),x!=null?Rr(null,!0,!0):Rr(w,!0,!1))}function Gh(x,w,I,N,W,J,le,de,xe){if(Zs==null&&Ma(!1),Je(x),x!=null)I=x.clientX-Zs.left,N=x.clientY-Zs.top;else{if(I<0||N<0){Wt=-10,Kt=-10;return}let[De,Ne]=vn.scales,Fe=w.cursor.sync,[st,Tt]=Fe.values,[Mt,gt]=Fe.scales,[Ke,qe]=vn.match,Xt=w.axes[0].side%2==1,on=L.ori==0?B:Re,Un=L.ori==1?B:Re,Ft=Xt?J:W,an=Xt?W:J,ui=Xt?N:I,$n=Xt?I:N;if(Mt!=null?I=Ke(De,Mt)?a(st,S[De],on,0):-10:I=on*(ui/Ft),gt!=null?N=qe(Ne,gt)?a(Tt,S[Ne],Un,0):-10:N=Un*($n/an),L.ori==1){let Ei=I;I=N,N=Ei}}xe&&(w==null||w.cursor.event.type==pf)&&((I<=1||I>=B-1)&&(I=Ur(I,B)),(N<=1||N>=Re-1)&&(N=Ur(N,Re))),de?(Lp=I,Dp=N,[co,uo]=he.move(i,I,N)):(Wt=I,Kt=N)}let Vh={width:0,height:0,left:0,top:0};function Hh(){Ll(Vh,!1)}let kp,zp,Gp,Vp;function Hp(x,w,I,N,W,J,le){Xs=!0,Ln=Dn=Bn._x=Bn._y=!1,Gh(x,w,I,N,W,J,le,!0,!1),x!=null&&(bt(mf,xf,Wp,!1),wa(Om,i,co,uo,B,Re,null));let{left:de,top:xe,width:De,height:Ne}=qt;kp=de,zp=xe,Gp=De,Vp=Ne}function Wp(x,w,I,N,W,J,le){Xs=Bn._x=Bn._y=!1,Gh(x,w,I,N,W,J,le,!1,!0);let{left:de,top:xe,width:De,height:Ne}=qt,Fe=De>0||Ne>0,st=kp!=de||zp!=xe||Gp!=De||Vp!=Ne;if(Fe&&st&&Ll(qt),Bn.setScale&&Fe&&st){let Tt=de,Mt=De,gt=xe,Ke=Ne;if(L.ori==1&&(Tt=xe,Mt=Ne,gt=de,Ke=De),Ln&&Ys(C,os(Tt,C),os(Tt+Mt,C)),Dn)for(let qe in S){let Xt=S[qe];qe!=C&&Xt.from==null&&Xt.min!=Bt&&Ys(qe,os(gt+Ke,qe),os(gt,qe))}Hh()}else he.lock&&(he._lock=!he._lock,Rr(w,!0,x!=null));x!=null&&(Mn(mf,xf),wa(mf,i,Wt,Kt,B,Re,null))}function Ky(x,w,I,N,W,J,le){if(he._lock)return;Je(x);let de=Xs;if(Xs){let xe=!0,De=!0,Ne=10,Fe,st;L.ori==0?(Fe=Ln,st=Dn):(Fe=Dn,st=Ln),Fe&&st&&(xe=Wt<=Ne||Wt>=B-Ne,De=Kt<=Ne||Kt>=Re-Ne),Fe&&xe&&(Wt=Wt<co?0:B),st&&De&&(Kt=Kt<uo?0:Re),Rr(null,!0,!0),Xs=!1}Wt=-10,Kt=-10,se.fill(null),Rr(null,!0,!0),de&&(Xs=de)}function qp(x,w,I,N,W,J,le){he._lock||(Je(x),xa(),Hh(),x!=null&&wa(zm,i,Wt,Kt,B,Re,null))}function Xp(){A.forEach(LS),O(i.width,i.height,!0)}Br(ic,wo,Xp);let po={};po.mousedown=Hp,po.mousemove=Bp,po.mouseup=Wp,po.dblclick=qp,po.setSeries=(x,w,I,N)=>{let W=vn.match[2];I=W(i,w,I),I!=-1&&rs(I,N,!0,!1)},me&&(bt(Om,p,Hp),bt(pf,p,Bp),bt(Bm,p,x=>{Je(x),Ma(!1)}),bt(km,p,Ky),bt(zm,p,qp),Cf.add(i),i.syncRect=Ma);let Dl=i.hooks=n.hooks||{};function Nn(x,w,I){Yn?Dt.push([x,w,I]):x in Dl&&Dl[x].forEach(N=>{N.call(null,i,w,I)})}(n.plugins||[]).forEach(x=>{for(let w in x.hooks)Dl[w]=(Dl[w]||[]).concat(x.hooks[w])});let Yp=(x,w,I)=>I,vn=bn({key:null,setSeries:!1,filters:{pub:Jm,sub:Jm},scales:[C,b[1]?b[1].scale:null],match:[jm,jm,Yp],values:[null,null]},he.sync);vn.match.length==2&&vn.match.push(Yp),he.sync=vn;let $p=vn.key,Wh=$g($p);function wa(x,w,I,N,W,J,le){vn.filters.pub(x,w,I,N,W,J,le)&&Wh.pub(x,w,I,N,W,J,le)}Wh.sub(i);function Jy(x,w,I,N,W,J,le){vn.filters.sub(x,w,I,N,W,J,le)&&po[x](null,w,I,N,W,J,le)}i.pub=Jy;function jy(){Wh.unsub(i),Cf.delete(i),In.clear(),Mf(ic,wo,Xp),c.remove(),Ae?.remove(),Nn("destroy")}i.destroy=jy;function qh(){Nn("init",n,e),ya(e||n.data,!1),H[C]?Oh(C,H[C]):xa(),ie=qt.show&&(qt.width>0||qt.height>0),te=pe=!0,O(n.width,n.height)}return b.forEach(io),A.forEach(xs),t?t instanceof HTMLElement?(t.appendChild(c),qh()):t(i,qh):qh(),i}Qt.assign=bn;Qt.fmtNum=Uf;Qt.rangeNum=sc;Qt.rangeLog=ac;Qt.rangeAsinh=Df;Qt.orient=zr;Qt.pxRatio=At;Qt.join=Mb;Qt.fmtDate=Of,Qt.tzDate=Nb;Qt.sync=$g;{Qt.addGap=gS,Qt.clipGaps=uc;let n=Qt.paths={points:e_};n.linear=n_,n.stepped=yS,n.bars=xS,n.spline=SS}function at(n){let e=document.querySelector(".haptonic")??document.documentElement;return getComputedStyle(e).getPropertyValue(`--${n}`).trim()}function si(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}function tr(n,e,t,i=[]){let{ctx:s,bbox:r}=n,o=n.valToPos(e,"x",!0);o<r.left||o>r.left+r.width||nr(s,[o,r.top],[o,r.top+r.height],t,i)}function Lo(n,e,t,i=[]){let{ctx:s,bbox:r}=n,o=n.valToPos(e,"y",!0);nr(s,[r.left,o],[r.left+r.width,o],t,i)}function nr(n,e,t,i,s=[]){n.save(),n.strokeStyle=at(i),n.lineWidth=1.5*devicePixelRatio,n.setLineDash(s.map(r=>r*devicePixelRatio)),n.beginPath(),n.moveTo(...e),n.lineTo(...t),n.stroke(),n.restore()}function Cs(n,[e,t],i,s=5){n.save(),n.setLineDash([]),n.beginPath(),n.arc(e,t,s*devicePixelRatio,0,2*Math.PI),n.fillStyle=at(i),n.strokeStyle=at("paper"),n.lineWidth=2*devicePixelRatio,n.fill(),n.stroke(),n.restore()}function Gr(n,[e,t],i){let{ctx:s,bbox:r}=n,[o,a]=[n.valToPos(e,"x",!0),n.valToPos(t,"x",!0)];s.fillStyle=at(i),s.fillRect(o,r.top,a-o,r.height)}var DS=240,o_="13px system-ui, sans-serif",a_=10,l_=5,NS=6,Rs=()=>({stroke:()=>at("ink"),ticks:{stroke:()=>at("rule"),size:a_},gap:l_,grid:{show:!1},font:o_,labelFont:"14px system-ui, sans-serif",values:(n,e)=>e.map(t=>t===null?"":bo(t))}),ir=()=>({...Rs(),labelSize:24,size:US});function US({ctx:n},e){n.save(),n.font=o_;let t=(e??[]).map(i=>n.measureText(i).width);return n.restore(),Math.ceil(a_+l_+Math.max(0,...t)+NS)}var Ps={pxAlign:0};function sr(n){return Math.max(n.clientWidth,DS)}function rr(n,e,t,i){let s=[...i,si(()=>n.redraw(!1,!0))],r=new ResizeObserver(()=>n.setSize(t()));return r.observe(e),()=>{r.disconnect();for(let o of s)o();n.destroy()}}function Do(n,e){n.over.addEventListener("click",({clientX:t,clientY:i})=>{let s=n.over.getBoundingClientRect();e(t-s.left,i-s.top)})}function or({ctx:n,bbox:e},t){n.save(),n.beginPath(),n.rect(e.left,e.top,e.width,e.height),n.clip(),t(),n.restore()}var pc=class{constructor(e){this.data=e;this.distance=e.values("distance"),this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),[this.rows=0,this.bands=0]=e.shape("frequency"),this.names=e.parsed("character_names");let t=e.parsed("path_labels"),i=e.parsed("path_corners");this.corners=t.map((r,o)=>({label:r,row:i[o]??0}));let s=e.header.attrs.carrier_hz;this.carrier=typeof s=="number"?s:void 0,this.top=Number(e.header.extra.top),this.units=Ci(e),this.pitch=Wf(e),this.wavevectorUnits=yo(this.pitch),this.gaps=qf(e)}data;distance;frequency;error;rows;bands;gaps;corners;carrier;top;units;pitch;wavevectorUnits;names;branches(){let e=this.data.values("branch"),t=new Map;return e.forEach((i,s)=>{let r=t.get(i)??Array(this.rows).fill(null);r[Math.floor(s/this.bands)]=this.frequency[s]??null,t.set(i,r)}),[...t.values()]}at({row:e,band:t}){return this.frequency[e*this.bands+t]??NaN}errorAt({row:e,band:t}){return this.error[e*this.bands+t]??NaN}nature({row:e,band:t}){return this.motion(this.data.values("character")[e*this.bands+t])}motion(e){return this.names[e??-1]??""}parity({row:e,band:t}){let i=e*this.bands+t;return Xf(this.data.values("parity")[i],"the mirror of the path",this.data.values("middle_parity")[i])}velocity({row:e,band:t}){let i=this.data.values("group_velocity"),s=2*(e*this.bands+t),[r,o]=[i[s]??NaN,i[s+1]??NaN];return Number.isFinite(r)&&Number.isFinite(o)?[r,o]:void 0}velocityError({row:e,band:t}){return this.data.has("group_velocity_error")?this.data.values("group_velocity_error")[e*this.bands+t]:void 0}phases(e){let t=this.data.values("kappa");return[t[2*e]??0,t[2*e+1]??0]}place(e){let t=this.corners.find(a=>a.row===e);if(t!==void 0)return t.label;let i=this.corners.findIndex(a=>a.row>e),[s,r]=[this.corners[i-1],this.corners[i]];if(s===void 0||r===void 0)return"";let o=(e-s.row)/(r.row-s.row);return`${Number(o.toFixed(3))} of ${s.label}-${r.label}`}belowGap(e){let t=e.below-1,i=0;for(let s=1;s<this.rows;s++)this.at({row:s,band:t})>this.at({row:i,band:t})&&(i=s);return{row:i,band:t}}},Wf=n=>Number(n.header.attrs.pitch_m);function qf(n){if(!n.has("gap_below"))return[];let e=t=>n.values(t);return Array.from(e("gap_below"),(t,i)=>({below:t,lower:e("gap_lower")[i]??NaN,upper:e("gap_upper")[i]??NaN,lowerError:e("gap_lower_error")[i]??NaN,upperError:e("gap_upper_error")[i]??NaN,complete:e("gap_complete")[i]===1,direction:n.texts("gap_direction")[i]??"",waves:n.texts("gap_waves")[i]??""}))}function Xf(n,e,t){let i=["even","odd"][c_(n)],s=["symmetric","antisymmetric"][c_(t)];return[i&&`${i} under ${e}`,s&&`${s} about the plate's middle plane`].filter(Boolean).join(", ")}function c_(n){return n===1?0:n===-1?1:-1}var FS=.2,OS=.1;function BS({certified:n,preview:e,at:t}){let i=e&&kS(e,t);if(n===null)return i;let s=n.has("gap_lower");return!s&&i===null?null:{isPreview:!1,areGapsPreview:!s,distance:n.values("distance"),pitch:Wf(n),frequency:n.values("frequency"),error:n.values("frequency_error"),gaps:s?qf(n):i?.gaps??[]}}function u_(n){let e=xn(()=>n?.value?BS(n.value):null);return{layer:e,isWaiting:xn(()=>!!n?.value&&e.value===null)}}var mc=({distance:n,pitch:e,frequency:t,error:i,gaps:s})=>({isPreview:!1,areGapsPreview:!1,distance:n,pitch:e,frequency:t,error:i,gaps:s});function kS(n,e){let t=n.values("value"),i=t.length-1;if(e<(t[0]??NaN)*(1-1e-9)||e>(t[i]??NaN)*(1+1e-9))return null;let s=Math.max(1,t.findIndex(v=>v>=e)),[r,o]=[t[s-1]??0,t[s]??1],a=o-r,l=Math.min(Math.max((e-r)/a,0),1),c=v=>{let T=n.values(v).length/t.length,F=ae=>{let X=n.values(ae);return[X.subarray((s-1)*T,s*T),X.subarray(s*T,(s+1)*T)]},[[D,L],[k,G],[U,H]]=[F(v),F(`${v}_error`),F(`${v}_bend`)],$=(ae,X,Q)=>(1-l)*(ae[Q]??NaN)+l*(X[Q]??NaN),V=a*l*(1-l);return[Float64Array.from(D,(ae,X)=>$(D,L,X)),Float64Array.from(D,(ae,X)=>$(k,G,X)+V*((U[X]??NaN)+(H[X]??NaN)))]},[u,h]=c("frequency"),f=OS*Math.max(...u);if(u.some((v,T)=>!((h[T]??NaN)<=FS*Math.max(v,f))))return null;let[d,p]=c("edge"),y=d.length/2,_=Array.from({length:y},(v,T)=>({below:T+1,lower:d[T]??NaN,upper:d[y+T]??NaN,lowerError:p[T]??NaN,upperError:p[y+T]??NaN,complete:!0,direction:"all",waves:"all"})),m=(v,T)=>{let F=n.values(v),D=F.length/t.length;return[F[(s-1)*D+T]??NaN,F[s*D+T]??NaN]},b=Float64Array.from({length:n.values("distance").length/t.length},(v,T)=>{let[F,D]=m("distance",T);return F===0?0:1/((1-l)/F+l/D)}),[A,S]=m("pitch",0),R=(1-l)*A+l*S,C=_.filter(({lower:v,upper:T})=>T>v);return{isPreview:!0,areGapsPreview:!0,distance:b,pitch:R,frequency:u,error:h,gaps:C}}var zS={preview:{colour:"accent",dash:[5,3],width:1.6},certified:{colour:"ink",dash:[],width:1.6},held:{colour:"curve-1",dash:[1.5,3],width:1.5}};function Yf(n,e,t,i,s,r){let{ctx:o}=n,{colour:a,dash:l,width:c}=zS[r],u=Array.from(t.distance,d=>n.valToPos(d/s,"x",!0)),h=(d,p)=>{let y=(t.frequency[d]??NaN)+p*(t.error[d]??NaN);return n.valToPos(y/i,"y",!0)},f=(d,p,y=!1)=>{for(let _=0;_<e.rows;_++){let m=y?e.rows-1-_:_;o.lineTo(u[m]??0,h(m*e.bands+d,p))}};o.save(),o.fillStyle=o.strokeStyle=at(a),o.lineWidth=c*devicePixelRatio,o.setLineDash(l.map(d=>d*devicePixelRatio));for(let d=0;d<e.bands;d++)r==="preview"&&(o.globalAlpha=.2,o.beginPath(),f(d,1),f(d,-1,!0),o.fill(),o.globalAlpha=1),o.beginPath(),f(d,0),o.stroke();if(r==="held")for(let d of t.gaps.filter(({complete:p})=>p))for(let p of[d.lower,d.upper]){let y=n.valToPos(p/i,"y",!0);o.beginPath(),o.moveTo(n.bbox.left,y),o.lineTo(n.bbox.left+n.bbox.width,y),o.stroke()}o.restore()}var GS=340,VS=.72,HS=40;function h_({diagram:n,choice:e,newer:t}){let i=Nt(null);return Gi(()=>{let s=i.current;if(s!==null)return WS(s,n,e,t)},[n,e,t]),g("div",{class:"curves",ref:i})}function WS(n,e,t,{layer:i,isWaiting:s}){let r=()=>t.unit.peek().factor,o=mc(e),a=()=>i.peek()??o,l=m=>f_(t,m).factor,c=m=>(m.distance[e.rows-1]??1)/l(m),u=e.branches(),h=()=>[Array.from(e.distance,m=>m/l(o)),...u.map(m=>m.map(b=>b===null?null:b/r()))],f=()=>{let m=sr(n);return{width:m,height:Math.max(GS,Math.min(VS*m,.7*innerHeight))}},d=()=>{let m=a();return e.corners.map(({row:b})=>(m.distance[b]??0)/l(m))},p=new Qt({...f(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(m,b,A)=>[b,A]},y:{range:(m,b,A)=>b===null?[0,1]:[b<.2*A?0:b,A]}},axes:[{...Rs(),splits:d,values:()=>d().map((m,b)=>`${e.corners[b]?.label}
${Number(m.toPrecision(3))}`),font:"14px system-ui, sans-serif",size:56,label:"wavevector",labelSize:22,grid:{stroke:()=>at("rule"),width:1}},{...ir(),label:"frequency"}],series:[{},...u.map(()=>({...Ps,stroke:()=>i.peek()!==null?"transparent":at(s.peek()?"rule":"ink"),width:1.6,points:{show:!1}}))],hooks:{drawClear:[m=>or(m,()=>{let b=t.held.peek(),A=s.peek()?[]:(i.peek()??e).gaps;XS(m,A,e.carrier,r()),b!==null&&Yf(m,e,b.layer,r(),l(b.layer),"held")})],draw:[m=>{let b=i.peek();b!==null&&or(m,()=>Yf(m,e,b,r(),l(b),b.isPreview?"preview":"certified")),$S(m,e,t,a())}]}},h(),n),y=()=>p.setScale("y",{min:0,max:e.top/r()}),_=()=>{let m=t.held.peek();p.setScale("x",{min:0,max:Math.max(c(a()),m===null?0:c(m.layer))})};return y(),Do(p,(m,b)=>{let A=qS(p,e,r(),l(o),m,b);A!==void 0&&(t.point.value=A)}),Object.assign(n,{plot:p}),rr(p,n,f,[Et(()=>{let[m,b]=p.axes;m!==void 0&&(m.label=Gt("length of the path",t.wavevectorUnit.value)),b!==void 0&&(b.label=Gt("frequency",t.unit.value)),p.setData(h(),!0),y(),_()}),Et(()=>{i.value,t.held.value,_()}),Et(()=>{let m=e.at(t.point.value)/r();i.value,s.value,t.held.value,m>(p.scales.y?.max??1/0)?p.setScale("y",{min:0,max:1.03*m}):p.redraw(!1,!1)})])}function f_(n,{pitch:e}){let t=n.wavevectorUnit.peek();return yo(e).find(({name:i})=>i===t.name)??t}function qS(n,e,t,i,s,r){let[o,a]=[void 0,HS];for(let l=0;l<e.rows;l++){let c=n.valToPos((e.distance[l]??0)/i,"x")-s;if(!(Math.abs(c)>a))for(let u=0;u<e.bands;u++){let h=Math.hypot(c,n.valToPos(e.at({row:l,band:u})/t,"y")-r);h<a&&([o,a]=[{row:l,band:u},h])}}return o}function XS(n,e,t,i){let{ctx:s,bbox:r}=n;for(let o of e){let a=n.valToPos(o.upper/i,"y",!0),l=n.valToPos(o.lower/i,"y",!0)-a;o.complete?(s.fillStyle=at("gap"),s.fillRect(r.left,a,r.width,l)):o.waves!=="all"&&YS(s,r.left,a,r.width,l)}t!==void 0&&Lo(n,t/i,"carrier",[7,5])}function YS(n,e,t,i,s){let r=12*devicePixelRatio;n.save(),n.beginPath(),n.rect(e,t,i,s),n.clip(),n.beginPath();for(let o=e-s;o<e+i;o+=r)n.moveTo(o,t+s),n.lineTo(o+s,t);n.strokeStyle=at("gap"),n.lineWidth=2*devicePixelRatio,n.stroke(),n.restore()}function $S(n,e,t,i){let s=t.point.peek(),r=n.valToPos((i.distance[s.row]??0)/f_(t,i).factor,"x",!0),o=i.frequency[s.row*e.bands+s.band]??NaN,a=n.valToPos(o/t.unit.peek().factor,"y",!0);Cs(n.ctx,[r,a],"accent",6)}function d_(n,e){let t=i=>e===void 0?i.upper-i.lower:p_(i,e).room;return n.filter(({complete:i})=>i).sort((i,s)=>t(s)-t(i))[0]}function p_(n,e){let[t,i]=[e-n.lower,n.upper-e];return t<i?{room:t,error:n.lowerError}:{room:i,error:n.upperError}}function m_(n,e,t){let i=d_(n,e),{factor:s}=t,r=(l,c)=>Vt(l/s,c/s),o=(l,c)=>kn(r(l,c),t);if(i===void 0)return{gap:"none complete below the last band"};let a=e===void 0?void 0:p_(i,e);return{gap:kn(`${r(i.lower,i.lowerError)} to ${r(i.upper,i.upperError)}`,t),width:o(i.upper-i.lower,i.lowerError+i.upperError),...a&&e!==void 0?{[`margin at ${kn(cs(e/s),t)}`]:o(a.room,a.error)}:{}}}function g_({gaps:n,carrier:e,unit:t}){let i=d_(n,e),s=i!==void 0&&i.upper-i.lower>i.lowerError+i.upperError;return g("dl",{class:"edges",children:[Object.entries(m_(n,e,t)).map(([r,o])=>g("div",{children:[g("dt",{children:r}),g("dd",{children:o})]})),i!==void 0&&!s&&g("div",{children:[g("dt",{children:"narrower than its errors"}),g("dd",{children:"may be closed"})]})]})}function __({held:n,now:e,unit:t,isPreview:i,drop:s}){let r=({gaps:l,carrier:c})=>m_(l,c,t),a=[...Object.keys(e.design).filter(l=>e.design[l]!==n.design[l]).map(l=>[l,n.design[l]??"",e.design[l]??""]),...[...new Set([...Object.keys(r(n)),...Object.keys(r(e))])].map(l=>[l,r(n)[l]??"",r(e)[l]??""])];return g("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Held design and this one",children:[g("table",{children:[g("caption",{children:"Held design and this one"}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"quantity"}),g("th",{scope:"col",children:"held"}),g("th",{scope:"col",children:i?"preview":"this design"})]})}),g("tbody",{children:a.map(([l,c,u])=>g("tr",{children:[g("th",{scope:"row",children:l}),g("td",{children:c}),g("td",{children:u})]}))})]}),g("button",{type:"button",onClick:s,children:"Let go of the held design"})]})}function ZS(){return matchMedia("(prefers-reduced-motion: reduce)").matches}var fs=()=>({playing:Xe(!ZS()),pace:Xe(.7)}),ar=class{constructor({playing:e,pace:t},i,...s){this.draw=i;for(let a of s)this.seen.observe(a);let r=0,o=a=>{r>0&&(this.moment=(this.moment+(a-r)/1e3*t.peek())%1),r=a,!document.hidden&&this.hidden.size<s.length&&i(),this.frame=requestAnimationFrame(o)};this.stop=Et(()=>{cancelAnimationFrame(this.frame),r=0,e.value&&(this.frame=requestAnimationFrame(o))})}draw;moment=0;frame=0;stop;hidden=new Set;seen=new IntersectionObserver(e=>{for(let{target:t,isIntersecting:i}of e)i?this.hidden.delete(t):this.hidden.add(t)});at(e){this.moment=e,this.draw()}end(){cancelAnimationFrame(this.frame),this.seen.disconnect(),this.stop()}};var gc=6,_c=.5;function v_(n){let e=n.gaps[0];return{point:Xe(e?n.belowGap(e):{row:n.corners[1]?.row??0,band:0}),...fs(),swing:Xe(.15),copies:Xe([2,2]),unit:Xe(Ri(n.units,Math.max(...n.frequency))),wavevectorUnit:Xe(n.wavevectorUnits[1]),listing:Xe("none"),held:Xe(null)}}function vc(n,{row:e,band:t},i,s){return{row:Math.min(Math.max(e+i,0),n.rows-1),band:Math.min(Math.max(t+s,0),n.bands-1)}}function y_(n,{band:e}){let t=[...n.gaps].filter(s=>s.waves==="all").sort((s,r)=>s.below-r.below),i=t.find(s=>s.below-1>e)??t[0];return i&&n.belowGap(i)}var KS=10,x_=.05;function b_(n,e,t){let i=(o,a)=>e.point.value=vc(n,e.point.value,o,a),s=o=>e.swing.value=Math.min(Math.max(e.swing.value+o,0),_c),r=o=>o.shiftKey?KS:1;return[{keys:"← →",effect:"previous or next wavevector; ten with Shift",actions:{ArrowLeft:o=>i(-r(o),0),ArrowRight:o=>i(r(o),0)}},{keys:"↑ ↓",effect:"next higher or lower band",actions:{ArrowUp:()=>i(0,1),ArrowDown:()=>i(0,-1)}},us(e),{keys:"+ −",effect:"larger or smaller displacement",actions:{"+":()=>s(x_),"-":()=>s(-x_)}},{keys:"g",effect:"lower edge of the next gap",actions:{g:()=>e.point.value=y_(n,e.point.value)??e.point.value}},...t?[{keys:"h",effect:"hold this design, or let it go",actions:{h:t}}]:[],...ni(e.listing)]}var No=ox(N_(),1);function U_(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),6e4)}var Sc=40,Mc=40,jf="video/webm",vM=6,F_=new WeakMap;function Uo(n,e){F_.set(n,e)}function Fo({canvas:n,name:e,caption:t}){let[i,s]=js(""),r=typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported(jf),o=(a,l)=>async()=>{if(n.current!==null){s(`The ${a} is made.`),await new Promise(c=>setTimeout(c,Mc));try{U_(await l(new Qf(n.current,t)),`${e}.${a.toLowerCase()}`),s("")}catch(c){s(`The ${a} cannot be made: ${String(c)}`)}}};return g("p",{class:"sides film",children:[g("span",{children:"Save the motion"}),g("button",{type:"button",onClick:()=>{o("GIF",yM)()},children:"GIF"}),r&&g("button",{type:"button",onClick:()=>{o("WebM",xM)()},children:"WebM"}),g("span",{role:"status",children:i})]})}var Qf=class{constructor(e,t){this.canvas=e;this.caption=t;let i=F_.get(e),s=this.copy.getContext("2d",{willReadFrequently:!0});if(i===void 0||s===null)throw new Error("the canvas does not move");[this.draw,this.context]=[i,s],[this.copy.width,this.copy.height]=[e.width,e.height]}canvas;caption;copy=document.createElement("canvas");context;draw;show(e){let{context:t,copy:i}=this;this.draw(e),t.fillStyle=at("panel"),t.fillRect(0,0,i.width,i.height),t.drawImage(this.canvas,0,0),t.font=`${13*devicePixelRatio}px system-ui, sans-serif`,t.fillStyle=at("ink");let s=vM*devicePixelRatio;return t.fillText(this.caption,s,i.height-s,i.width-2*s),t}};async function yM(n){let{width:e,height:t}=n.copy,i=(0,No.GIFEncoder)(),s;for(let r=0;r<Sc;r++){let{data:o}=n.show(r/Sc).getImageData(0,0,e,t);s??=(0,No.quantize)(o,256),i.writeFrame((0,No.applyPalette)(o,s),e,t,r===0?{palette:s,delay:Mc}:{delay:Mc}),r%5===4&&await new Promise(a=>setTimeout(a))}return i.finish(),new Blob([i.bytes()],{type:"image/gif"})}async function xM(n){n.show(0);let e=n.copy.captureStream(),t=new MediaRecorder(e,{mimeType:jf,videoBitsPerSecond:8e6}),i=[];t.ondataavailable=({data:o})=>i.push(o);let s=new Promise(o=>t.onstop=o);t.start();let r=performance.now();for(let o=0;o<Sc;o++){n.show(o/Sc);let a=r+(o+1)*Mc-performance.now();await new Promise(l=>setTimeout(l,a))}t.stop(),await s;for(let o of e.getTracks())o.stop();return new Blob(i,{type:jf})}var xr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},br={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},c0=0,Ed=1,u0=2;var gl=1,h0=2,aa=3,Sr=0,ti=1,Oi=2,Jr=0,la=1,Ad=2,Cd=3,Rd=4,f0=5;var jr=100,d0=101,p0=102,m0=103,g0=104,_0=200,v0=201,y0=202,x0=203,Pd=204,Id=205,b0=206,S0=207,M0=208,w0=209,T0=210,E0=211,A0=212,C0=213,R0=214,$c=0,Zc=1,Kc=2,Jo=3,Jc=4,jc=5,Qc=6,eu=7,Ld=0,P0=1,I0=2,_s=0,Dd=1,Nd=2,Ud=3,Fd=4,Od=5,Bd=6,kd=7;var zd=300,Qr=301,ca=302,Cu=303,Ru=304,tu=1e3,ps=1001,nu=1002,On=1003,L0=1004;var _l=1005;var zn=1006,Pu=1007;var zs=1008;var Ti=1009,Gd=1010,Vd=1011,ua=1012,Iu=1013,Ji=1014,ji=1015,Qi=1016,Lu=1017,Du=1018,eo=1020,Hd=35902,Wd=35899,qd=1021,Xd=1022,es=1023,Os=1026,Gs=1027,Yd=1028,Nu=1029,Mr=1030,Uu=1031;var Fu=1033,vl=33776,yl=33777,xl=33778,bl=33779,Ou=35840,Bu=35841,ku=35842,zu=35843,Gu=36196,Vu=37492,Hu=37496,Wu=37488,qu=37489,Sl=37490,Xu=37491,Yu=37808,$u=37809,Zu=37810,Ku=37811,Ju=37812,ju=37813,Qu=37814,eh=37815,th=37816,nh=37817,ih=37818,sh=37819,rh=37820,oh=37821,ah=36492,lh=36494,ch=36495,uh=36283,hh=36284,Ml=36285,fh=36286;var ja=2300,iu=2301,Xc=2302,xd=2303,bd=2400,Sd=2401,Md=2402;var D0=3200;var $d=0,N0=1,Vs="",vi="srgb",Qa="srgb-linear",el="linear",Pt="srgb";var Yc=7680;var U0=519,F0=512,O0=513,B0=514,Zd=515,k0=516,z0=517,Kd=518,Jd=519,G0=35044;var jd="300 es",Ui=2e3,tl=2001;function bM(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function SM(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function nl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function V0(){let n=nl("canvas");return n.style.display="block",n}var O_={},jo=null;function Qd(...n){let e="THREE."+n.shift();jo?jo("log",e,...n):console.log(e,...n)}function H0(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $e(...n){n=H0(n);let e="THREE."+n.shift();if(jo)jo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function tt(...n){n=H0(n);let e="THREE."+n.shift();if(jo)jo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Za(...n){let e=n.join(" ");e in O_||(O_[e]=!0,$e(...n))}function W0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var q0={[$c]:$c,[Kc]:Qc,[Jc]:Jc,[Jo]:jc,[Zc]:Zc,[Qc]:Kc,[eu]:eu,[jc]:Jo},Ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Hn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],B_=1234567,Ka=Math.PI/180,Qo=180/Math.PI;function ha(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Hn[n&255]+Hn[n>>8&255]+Hn[n>>16&255]+Hn[n>>24&255]+"-"+Hn[e&255]+Hn[e>>8&255]+"-"+Hn[e>>16&15|64]+Hn[e>>24&255]+"-"+Hn[t&63|128]+Hn[t>>8&255]+"-"+Hn[t>>16&255]+Hn[t>>24&255]+Hn[i&255]+Hn[i>>8&255]+Hn[i>>16&255]+Hn[i>>24&255]).toLowerCase()}function mt(n,e,t){return Math.max(e,Math.min(t,n))}function ep(n,e){return(n%e+e)%e}function MM(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function wM(n,e,t){return n!==e?(t-n)/(e-n):0}function Ja(n,e,t){return(1-t)*n+t*e}function TM(n,e,t,i){return Ja(n,e,1-Math.exp(-t*i))}function EM(n,e=1){return e-Math.abs(ep(n,e*2)-e)}function AM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function CM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function RM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function PM(n,e){return n+Math.random()*(e-n)}function IM(n){return n*(.5-Math.random())}function LM(n){n!==void 0&&(B_=n);let e=B_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function DM(n){return n*Ka}function NM(n){return n*Qo}function UM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function FM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function tp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function OM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),h=r((e-i)/2),f=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*h,l*f,a*c);break;case"YZY":n.set(l*f,a*u,l*h,a*c);break;case"ZXZ":n.set(l*h,l*f,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function np(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function X0(n,e){if(e.constructor===Float32Array)return n;let t=np(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Y0(n,e){if(e.constructor===Float32Array)return n;let t=np(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var ip={DEG2RAD:Ka,RAD2DEG:Qo,generateUUID:ha,clamp:mt,euclideanModulo:ep,mapLinear:MM,inverseLerp:wM,lerp:Ja,damp:TM,pingpong:EM,smoothstep:AM,smootherstep:CM,randInt:RM,randFloat:PM,randFloatSpread:IM,seededRandom:LM,degToRad:DM,radToDeg:NM,isPowerOfTwo:UM,ceilPowerOfTwo:FM,floorPowerOfTwo:tp,setQuaternionFromProperEuler:OM,normalize:Y0,denormalize:X0},nt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},xi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],h=i[s+3],f=r[o+0],d=r[o+1],p=r[o+2],y=r[o+3];if(h!==y||l!==f||c!==d||u!==p){let _=l*f+c*d+u*p+h*y;_<0&&(f=-f,d=-d,p=-p,y=-y,_=-_);let m=1-a;if(_<.9995){let b=Math.acos(_),A=Math.sin(b);m=Math.sin(m*b)/A,a=Math.sin(a*b)/A,l=l*m+f*a,c=c*m+d*a,u=u*m+p*a,h=h*m+y*a}else{l=l*m+f*a,c=c*m+d*a,u=u*m+p*a,h=h*m+y*a;let b=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=b,c*=b,u*=b,h*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],h=r[o],f=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*h+l*d-c*f,e[t+1]=l*p+u*f+c*h-a*d,e[t+2]=c*p+u*d+a*f-l*h,e[t+3]=u*p-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),h=a(r/2),f=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*p,this._y=c*d*h-f*u*p,this._z=c*u*p+f*d*h,this._w=c*u*h-f*d*p;break;case"YXZ":this._x=f*u*h+c*d*p,this._y=c*d*h-f*u*p,this._z=c*u*p-f*d*h,this._w=c*u*h+f*d*p;break;case"ZXY":this._x=f*u*h-c*d*p,this._y=c*d*h+f*u*p,this._z=c*u*p+f*d*h,this._w=c*u*h-f*d*p;break;case"ZYX":this._x=f*u*h-c*d*p,this._y=c*d*h+f*u*p,this._z=c*u*p-f*d*h,this._w=c*u*h+f*d*p;break;case"YZX":this._x=f*u*h+c*d*p,this._y=c*d*h+f*u*p,this._z=c*u*p-f*d*h,this._w=c*u*h-f*d*p;break;case"XZY":this._x=f*u*h-c*d*p,this._y=c*d*h-f*u*p,this._z=c*u*p+f*d*h,this._w=c*u*h+f*d*p;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=i+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>h){let d=2*Math.sqrt(1+i-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-i-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},K=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(k_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(k_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),h=2*(r*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return ed.copy(this).projectOnVector(e),this.sub(ed)}reflect(e){return this.sub(ed.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},ed=new K,k_=new xi,Qe=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],f=i[2],d=i[5],p=i[8],y=s[0],_=s[3],m=s[6],b=s[1],A=s[4],S=s[7],R=s[2],C=s[5],v=s[8];return r[0]=o*y+a*b+l*R,r[3]=o*_+a*A+l*C,r[6]=o*m+a*S+l*v,r[1]=c*y+u*b+h*R,r[4]=c*_+u*A+h*C,r[7]=c*m+u*S+h*v,r[2]=f*y+d*b+p*R,r[5]=f*_+d*A+p*C,r[8]=f*m+d*S+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,p=t*h+i*f+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return e[0]=h*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=f*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=d*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Za("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(td.makeScale(e,t)),this}rotate(e){return Za("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(td.makeRotation(-e)),this}translate(e,t){return Za("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(td.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},td=new Qe,z_=new Qe().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),G_=new Qe().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function BM(){let n={enabled:!0,workingColorSpace:Qa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=Fs(s.r),s.g=Fs(s.g),s.b=Fs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=Ko(s.r),s.g=Ko(s.g),s.b=Ko(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Vs?el:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Qa]:{primaries:e,whitePoint:i,transfer:el,toXYZ:z_,fromXYZ:G_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:vi},outputColorSpaceConfig:{drawingBufferColorSpace:vi}},[vi]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:z_,fromXYZ:G_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:vi}}}),n}var yt=BM();function Fs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ko(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Oo,su=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Oo===void 0&&(Oo=nl("canvas")),Oo.width=e.width,Oo.height=e.height;let s=Oo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Oo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=nl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Fs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Fs(t[i]/255)*255):t[i]=Fs(t[i]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},kM=0,ea=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:kM++}),this.uuid=ha(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(nd(s[o].image)):r.push(nd(s[o]))}else r=nd(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function nd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?su.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var zM=0,id=new K,oi=class n extends Ki{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ps,s=ps,r=zn,o=zs,a=es,l=Ti,c=n.DEFAULT_ANISOTROPY,u=Vs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:zM++}),this.uuid=ha(),this.name="",this.source=new ea(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new nt(0,0),this.repeat=new nt(1,1),this.center=new nt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Qe,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(id).x}get height(){return this.source.getSize(id).y}get depth(){return this.source.getSize(id).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==zd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case tu:e.x=e.x-Math.floor(e.x);break;case ps:e.x=e.x<0?0:1;break;case nu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case tu:e.y=e.y-Math.floor(e.y);break;case ps:e.y=e.y<0?0:1;break;case nu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};oi.DEFAULT_IMAGE=null;oi.DEFAULT_MAPPING=zd;oi.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],p=l[9],y=l[2],_=l[6],m=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-y)<.01&&Math.abs(p-_)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+y)<.1&&Math.abs(p+_)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(d+1)/2,R=(m+1)/2,C=(u+f)/4,v=(h+y)/4,T=(p+_)/4;return A>S&&A>R?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=C/i,r=v/i):S>R?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=C/s,r=T/s):R<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),i=v/r,s=T/r),this.set(i,s,r,t),this}let b=Math.sqrt((_-p)*(_-p)+(h-y)*(h-y)+(f-u)*(f-u));return Math.abs(b)<.001&&(b=1),this.x=(_-p)/b,this.y=(h-y)/b,this.z=(f-u)/b,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ru=class extends Ki{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new oi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:zn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ea(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bi=class extends ru{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},il=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ou=class extends oi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var en=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,h,f,d,p,y,_){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,h,f,d,p,y,_)}set(e,t,i,s,r,o,a,l,c,u,h,f,d,p,y,_){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=h,m[14]=f,m[3]=d,m[7]=p,m[11]=y,m[15]=_,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Bo.setFromMatrixColumn(e,0).length(),r=1/Bo.setFromMatrixColumn(e,1).length(),o=1/Bo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let f=o*u,d=o*h,p=a*u,y=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+p*c,t[5]=f-y*c,t[9]=-a*l,t[2]=y-f*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,p=c*u,y=c*h;t[0]=f+y*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=y+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,p=c*u,y=c*h;t[0]=f-y*a,t[4]=-o*h,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=y-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,p=a*u,y=a*h;t[0]=l*u,t[4]=p*c-d,t[8]=f*c+y,t[1]=l*h,t[5]=y*c+f,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=y-f*h,t[8]=p*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+p,t[10]=f-y*h}else if(e.order==="XZY"){let f=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+y,t[5]=o*u,t[9]=d*h-p,t[2]=p*h-d,t[6]=a*u,t[10]=y*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(GM,e,VM)}lookAt(e,t,i){let s=this.elements;return gi.subVectors(e,t),gi.lengthSq()===0&&(gi.z=1),gi.normalize(),cr.crossVectors(i,gi),cr.lengthSq()===0&&(Math.abs(i.z)===1?gi.x+=1e-4:gi.z+=1e-4,gi.normalize(),cr.crossVectors(i,gi)),cr.normalize(),wc.crossVectors(gi,cr),s[0]=cr.x,s[4]=wc.x,s[8]=gi.x,s[1]=cr.y,s[5]=wc.y,s[9]=gi.y,s[2]=cr.z,s[6]=wc.z,s[10]=gi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],f=i[9],d=i[13],p=i[2],y=i[6],_=i[10],m=i[14],b=i[3],A=i[7],S=i[11],R=i[15],C=s[0],v=s[4],T=s[8],F=s[12],D=s[1],L=s[5],k=s[9],G=s[13],U=s[2],H=s[6],$=s[10],V=s[14],ae=s[3],X=s[7],Q=s[11],se=s[15];return r[0]=o*C+a*D+l*U+c*ae,r[4]=o*v+a*L+l*H+c*X,r[8]=o*T+a*k+l*$+c*Q,r[12]=o*F+a*G+l*V+c*se,r[1]=u*C+h*D+f*U+d*ae,r[5]=u*v+h*L+f*H+d*X,r[9]=u*T+h*k+f*$+d*Q,r[13]=u*F+h*G+f*V+d*se,r[2]=p*C+y*D+_*U+m*ae,r[6]=p*v+y*L+_*H+m*X,r[10]=p*T+y*k+_*$+m*Q,r[14]=p*F+y*G+_*V+m*se,r[3]=b*C+A*D+S*U+R*ae,r[7]=b*v+A*L+S*H+R*X,r[11]=b*T+A*k+S*$+R*Q,r[15]=b*F+A*G+S*V+R*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],p=e[3],y=e[7],_=e[11],m=e[15],b=l*d-c*f,A=a*d-c*h,S=a*f-l*h,R=o*d-c*u,C=o*f-l*u,v=o*h-a*u;return t*(y*b-_*A+m*S)-i*(p*b-_*R+m*C)+s*(p*A-y*R+m*v)-r*(p*S-y*C+_*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],p=e[12],y=e[13],_=e[14],m=e[15],b=t*a-i*o,A=t*l-s*o,S=t*c-r*o,R=i*l-s*a,C=i*c-r*a,v=s*c-r*l,T=u*y-h*p,F=u*_-f*p,D=u*m-d*p,L=h*_-f*y,k=h*m-d*y,G=f*m-d*_,U=b*G-A*k+S*L+R*D-C*F+v*T;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/U;return e[0]=(a*G-l*k+c*L)*H,e[1]=(s*k-i*G-r*L)*H,e[2]=(y*v-_*C+m*R)*H,e[3]=(f*C-h*v-d*R)*H,e[4]=(l*D-o*G-c*F)*H,e[5]=(t*G-s*D+r*F)*H,e[6]=(_*S-p*v-m*A)*H,e[7]=(u*v-f*S+d*A)*H,e[8]=(o*k-a*D+c*T)*H,e[9]=(i*D-t*k-r*T)*H,e[10]=(p*C-y*S+m*b)*H,e[11]=(h*S-u*C-d*b)*H,e[12]=(a*F-o*L-l*T)*H,e[13]=(t*L-i*F+s*T)*H,e[14]=(y*A-p*R-_*b)*H,e[15]=(u*R-h*A+f*b)*H,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,p=r*h,y=o*u,_=o*h,m=a*h,b=l*c,A=l*u,S=l*h,R=i.x,C=i.y,v=i.z;return s[0]=(1-(y+m))*R,s[1]=(d+S)*R,s[2]=(p-A)*R,s[3]=0,s[4]=(d-S)*C,s[5]=(1-(f+m))*C,s[6]=(_+b)*C,s[7]=0,s[8]=(p+A)*v,s[9]=(_-b)*v,s[10]=(1-(f+y))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Bo.set(s[0],s[1],s[2]).length(),a=Bo.set(s[4],s[5],s[6]).length(),l=Bo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Yi.copy(this);let c=1/o,u=1/a,h=1/l;return Yi.elements[0]*=c,Yi.elements[1]*=c,Yi.elements[2]*=c,Yi.elements[4]*=u,Yi.elements[5]*=u,Yi.elements[6]*=u,Yi.elements[8]*=h,Yi.elements[9]*=h,Yi.elements[10]*=h,t.setFromRotationMatrix(Yi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ui,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(i-s),f=(t+e)/(t-e),d=(i+s)/(i-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===Ui)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===tl)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ui,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-s),f=-(t+e)/(t-e),d=-(i+s)/(i-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===Ui)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===tl)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Bo=new K,Yi=new en,GM=new K(0,0,0),VM=new K(1,1,1),cr=new K,wc=new K,gi=new K,V_=new en,H_=new xi,mr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return V_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(V_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return H_.setFromEuler(this),this.setFromQuaternion(H_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};mr.DEFAULT_ORDER="XYZ";var sl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},HM=0,W_=new K,ko=new xi,Is=new en,Tc=new K,Wa=new K,WM=new K,qM=new xi,q_=new K(1,0,0),X_=new K(0,1,0),Y_=new K(0,0,1),$_={type:"added"},XM={type:"removed"},zo={type:"childadded",child:null},sd={type:"childremoved",child:null},Si=class n extends Ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:HM++}),this.uuid=ha(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new K,t=new mr,i=new xi,s=new K(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new en},normalMatrix:{value:new Qe}}),this.matrix=new en,this.matrixWorld=new en,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new sl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ko.setFromAxisAngle(e,t),this.quaternion.multiply(ko),this}rotateOnWorldAxis(e,t){return ko.setFromAxisAngle(e,t),this.quaternion.premultiply(ko),this}rotateX(e){return this.rotateOnAxis(q_,e)}rotateY(e){return this.rotateOnAxis(X_,e)}rotateZ(e){return this.rotateOnAxis(Y_,e)}translateOnAxis(e,t){return W_.copy(e).applyQuaternion(this.quaternion),this.position.add(W_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(q_,e)}translateY(e){return this.translateOnAxis(X_,e)}translateZ(e){return this.translateOnAxis(Y_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Is.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Tc.copy(e):Tc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Wa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Is.lookAt(Wa,Tc,this.up):Is.lookAt(Tc,Wa,this.up),this.quaternion.setFromRotationMatrix(Is),s&&(Is.extractRotation(s.matrixWorld),ko.setFromRotationMatrix(Is),this.quaternion.premultiply(ko.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(tt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent($_),zo.child=e,this.dispatchEvent(zo),zo.child=null):tt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(XM),sd.child=e,this.dispatchEvent(sd),sd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Is.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Is.multiply(e.parent.matrixWorld)),e.applyMatrix4(Is),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent($_),zo.child=e,this.dispatchEvent(zo),zo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wa,e,WM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Wa,qM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Si.DEFAULT_UP=new K(0,1,0);Si.DEFAULT_MATRIX_AUTO_UPDATE=!0;Si.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Yr=class extends Si{constructor(){super(),this.isGroup=!0,this.type="Group"}},YM={type:"move"},ta=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Yr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Yr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new K,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new K),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Yr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new K,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new K,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let _=t.getJointPose(y,i),m=this._getHandJoint(c,y);_!==null&&(m.matrix.fromArray(_.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=_.radius),m.visible=_!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,p=.005;c.inputState.pinching&&f>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(YM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Yr;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},$0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ur={h:0,s:0,l:0},Ec={h:0,s:0,l:0};function rd(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var xt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=vi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=i,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=yt.workingColorSpace){if(e=ep(e,1),t=mt(t,0,1),i=mt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=rd(o,r,e+1/3),this.g=rd(o,r,e),this.b=rd(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=vi){function i(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=vi){let i=$0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Fs(e.r),this.g=Fs(e.g),this.b=Fs(e.b),this}copyLinearToSRGB(e){return this.r=Ko(e.r),this.g=Ko(e.g),this.b=Ko(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=vi){return yt.workingToColorSpace(Wn.copy(this),e),Math.round(mt(Wn.r*255,0,255))*65536+Math.round(mt(Wn.g*255,0,255))*256+Math.round(mt(Wn.b*255,0,255))}getHexString(e=vi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace(Wn.copy(this),t);let i=Wn.r,s=Wn.g,r=Wn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-i)/h+2;break;case r:l=(i-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace(Wn.copy(this),t),e.r=Wn.r,e.g=Wn.g,e.b=Wn.b,e}getStyle(e=vi){yt.workingToColorSpace(Wn.copy(this),e);let t=Wn.r,i=Wn.g,s=Wn.b;return e!==vi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(ur),this.setHSL(ur.h+e,ur.s+t,ur.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(ur),e.getHSL(Ec);let i=Ja(ur.h,Ec.h,t),s=Ja(ur.s,Ec.s,t),r=Ja(ur.l,Ec.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Wn=new xt;xt.NAMES=$0;var rl=class extends Si{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new mr,this.environmentIntensity=1,this.environmentRotation=new mr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},$i=new K,Ls=new K,od=new K,Ds=new K,Go=new K,Vo=new K,Z_=new K,ad=new K,ld=new K,cd=new K,ud=new tn,hd=new tn,fd=new tn,pr=class n{constructor(e=new K,t=new K,i=new K){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),$i.subVectors(e,t),s.cross($i);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){$i.subVectors(s,t),Ls.subVectors(i,t),od.subVectors(e,t);let o=$i.dot($i),a=$i.dot(Ls),l=$i.dot(od),c=Ls.dot(Ls),u=Ls.dot(od),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,p=(o*u-a*l)*f;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ds)===null?!1:Ds.x>=0&&Ds.y>=0&&Ds.x+Ds.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ds)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ds.x),l.addScaledVector(o,Ds.y),l.addScaledVector(a,Ds.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return ud.setScalar(0),hd.setScalar(0),fd.setScalar(0),ud.fromBufferAttribute(e,t),hd.fromBufferAttribute(e,i),fd.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(ud,r.x),o.addScaledVector(hd,r.y),o.addScaledVector(fd,r.z),o}static isFrontFacing(e,t,i,s){return $i.subVectors(i,t),Ls.subVectors(e,t),$i.cross(Ls).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return $i.subVectors(this.c,this.b),Ls.subVectors(this.a,this.b),$i.cross(Ls).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Go.subVectors(s,i),Vo.subVectors(r,i),ad.subVectors(e,i);let l=Go.dot(ad),c=Vo.dot(ad);if(l<=0&&c<=0)return t.copy(i);ld.subVectors(e,s);let u=Go.dot(ld),h=Vo.dot(ld);if(u>=0&&h<=u)return t.copy(s);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Go,o);cd.subVectors(e,r);let d=Go.dot(cd),p=Vo.dot(cd);if(p>=0&&d<=p)return t.copy(r);let y=d*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Vo,a);let _=u*p-d*h;if(_<=0&&h-u>=0&&d-p>=0)return Z_.subVectors(r,s),a=(h-u)/(h-u+(d-p)),t.copy(s).addScaledVector(Z_,a);let m=1/(_+y+f);return o=y*m,a=f*m,t.copy(i).addScaledVector(Go,o).addScaledVector(Vo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ms=class{constructor(e=new K(1/0,1/0,1/0),t=new K(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Zi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Zi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Zi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Zi):Zi.fromBufferAttribute(r,o),Zi.applyMatrix4(e.matrixWorld),this.expandByPoint(Zi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ac.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Ac.copy(i.boundingBox)),Ac.applyMatrix4(e.matrixWorld),this.union(Ac)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Zi),Zi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(qa),Cc.subVectors(this.max,qa),Ho.subVectors(e.a,qa),Wo.subVectors(e.b,qa),qo.subVectors(e.c,qa),hr.subVectors(Wo,Ho),fr.subVectors(qo,Wo),Hr.subVectors(Ho,qo);let t=[0,-hr.z,hr.y,0,-fr.z,fr.y,0,-Hr.z,Hr.y,hr.z,0,-hr.x,fr.z,0,-fr.x,Hr.z,0,-Hr.x,-hr.y,hr.x,0,-fr.y,fr.x,0,-Hr.y,Hr.x,0];return!dd(t,Ho,Wo,qo,Cc)||(t=[1,0,0,0,1,0,0,0,1],!dd(t,Ho,Wo,qo,Cc))?!1:(Rc.crossVectors(hr,fr),t=[Rc.x,Rc.y,Rc.z],dd(t,Ho,Wo,qo,Cc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Zi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Zi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ns[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ns[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ns[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ns[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ns[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ns[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ns[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ns[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ns),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ns=[new K,new K,new K,new K,new K,new K,new K,new K],Zi=new K,Ac=new ms,Ho=new K,Wo=new K,qo=new K,hr=new K,fr=new K,Hr=new K,qa=new K,Cc=new K,Rc=new K,Wr=new K;function dd(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Wr.fromArray(n,r);let a=s.x*Math.abs(Wr.x)+s.y*Math.abs(Wr.y)+s.z*Math.abs(Wr.z),l=e.dot(Wr),c=t.dot(Wr),u=i.dot(Wr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Sn=new K,Pc=new nt,$M=0,ei=class extends Ki{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$M++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=G0,this.updateRanges=[],this.gpuType=ji,this.version=0,this._normalizationScale=e!==void 0?np(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Pc.fromBufferAttribute(this,t),Pc.applyMatrix3(e),this.setXY(t,Pc.x,Pc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.applyMatrix3(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.applyMatrix4(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.applyNormalMatrix(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Sn.fromBufferAttribute(this,t),Sn.transformDirection(e),this.setXYZ(t,Sn.x,Sn.y,Sn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):X0(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Y0(e,this.array)}};var ol=class extends ei{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var al=class extends ei{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var ri=class extends ei{constructor(e,t,i){super(new Float32Array(e),t,i)}},ZM=new ms,Xa=new K,pd=new K,Bs=class{constructor(e=new K,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):ZM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Xa.subVectors(e,this.center);let t=Xa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Xa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(pd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Xa.copy(e.center).add(pd)),this.expandByPoint(Xa.copy(e.center).sub(pd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},KM=0,Ni=new en,md=new Si,Xo=new K,_i=new ms,Ya=new ms,Fn=new K,gs=class n extends Ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:KM++}),this.uuid=ha(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(bM(e)?al:ol)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Qe().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ni.makeRotationFromQuaternion(e),this.applyMatrix4(Ni),this}rotateX(e){return Ni.makeRotationX(e),this.applyMatrix4(Ni),this}rotateY(e){return Ni.makeRotationY(e),this.applyMatrix4(Ni),this}rotateZ(e){return Ni.makeRotationZ(e),this.applyMatrix4(Ni),this}translate(e,t,i){return Ni.makeTranslation(e,t,i),this.applyMatrix4(Ni),this}scale(e,t,i){return Ni.makeScale(e,t,i),this.applyMatrix4(Ni),this}lookAt(e){return md.lookAt(e),md.updateMatrix(),this.applyMatrix4(md.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Xo).negate(),this.translate(Xo.x,Xo.y,Xo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ri(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ms);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new K(-1/0,-1/0,-1/0),new K(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Fn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Fn),Fn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Fn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&tt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){tt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new K,1/0);return}if(e){let i=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ya.setFromBufferAttribute(a),this.morphTargetsRelative?(Fn.addVectors(_i.min,Ya.min),_i.expandByPoint(Fn),Fn.addVectors(_i.max,Ya.max),_i.expandByPoint(Fn)):(_i.expandByPoint(Ya.min),_i.expandByPoint(Ya.max))}_i.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Fn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Fn.fromBufferAttribute(a,c),l&&(Xo.fromBufferAttribute(e,c),Fn.add(Xo)),s=Math.max(s,i.distanceToSquared(Fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&tt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){tt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new ei(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let F=0;F<i.count;F++)a[F]=new K,l[F]=new K;let u=new K,h=new K,f=new K,d=new nt,p=new nt,y=new nt,_=new K,m=new K;function b(F,D,L){c[F]=c[D]=c[L]=1,u.fromBufferAttribute(i,F),h.fromBufferAttribute(i,D),f.fromBufferAttribute(i,L),d.fromBufferAttribute(r,F),p.fromBufferAttribute(r,D),y.fromBufferAttribute(r,L),h.sub(u),f.sub(u),p.sub(d),y.sub(d);let k=1/(p.x*y.y-y.x*p.y);isFinite(k)&&(_.copy(h).multiplyScalar(y.y).addScaledVector(f,-p.y).multiplyScalar(k),m.copy(f).multiplyScalar(p.x).addScaledVector(h,-y.x).multiplyScalar(k),a[F].add(_),a[D].add(_),a[L].add(_),l[F].add(m),l[D].add(m),l[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let F=0,D=A.length;F<D;++F){let L=A[F],k=L.start,G=L.count;for(let U=k,H=k+G;U<H;U+=3)b(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let S=new K,R=new K,C=new K,v=new K;function T(F){C.fromBufferAttribute(s,F),v.copy(C);let D=a[F];S.copy(D),S.sub(C.multiplyScalar(C.dot(D))).normalize(),R.crossVectors(v,D);let k=R.dot(l[F])<0?-1:1;o.setXYZW(F,S.x,S.y,S.z,k)}for(let F=0,D=i.count;F<D;++F)c[F]&&T(F);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new ei(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new K,r=new K,o=new K,a=new K,l=new K,c=new K,u=new K,h=new K;if(e)for(let f=0,d=e.count;f<d;f+=3){let p=e.getX(f+0),y=e.getX(f+1),_=e.getX(f+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,_),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,_),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(_,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)s.fromBufferAttribute(t,f+0),r.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),i.setXYZ(f+0,u.x,u.y,u.z),i.setXYZ(f+1,u.x,u.y,u.z),i.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Fn.fromBufferAttribute(e,t),Fn.normalize(),e.setXYZ(t,Fn.x,Fn.y,Fn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,p=0;for(let y=0,_=l.length;y<_;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let m=0;m<u;m++)f[p++]=c[d++]}return new ei(f,u,h)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var gd=new K,JM=new K,jM=new Qe,yi=class{constructor(e=new K(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=gd.subVectors(i,t).cross(JM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(gd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||jM.getNormalMatrix(e),s=this.coplanarPoint(gd).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},QM=0,gr=class extends Ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:QM++}),this.uuid=ha(),this.name="",this.type="Material",this.blending=la,this.side=Sr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Pd,this.blendDst=Id,this.blendEquation=jr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new xt(0,0,0),this.blendAlpha=0,this.depthFunc=Jo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=U0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Yc,this.stencilZFail=Yc,this.stencilZPass=Yc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new xt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new yi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new nt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new nt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Us=new K,_d=new K,Ic=new K,Lc=new K,$r=class{constructor(e=new K,t=new K(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Us)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Us.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Us.copy(this.origin).addScaledVector(this.direction,t),Us.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){_d.copy(e).add(t).multiplyScalar(.5),Ic.copy(t).sub(e).normalize(),Lc.copy(this.origin).sub(_d);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ic),a=Lc.dot(this.direction),l=-Lc.dot(Ic),c=Lc.lengthSq(),u=Math.abs(1-o*o),h,f,d,p;if(u>0)if(h=o*l-a,f=o*a-l,p=r*u,h>=0)if(f>=-p)if(f<=p){let y=1/u;h*=y,f*=y,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-p?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=p?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(_d).addScaledVector(Ic,f),d}intersectSphere(e,t){if(e.radius<0)return null;Us.subVectors(e.center,this.origin);let i=Us.dot(this.direction),s=Us.dot(Us)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,s=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,s=(e.min.x-f.x)*c),u>=0?(r=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(r=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Us)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,p=t.x-o.x,y=t.y-o.y,_=t.z-o.z,m=i.x-o.x,b=i.y-o.y,A=i.z-o.z,S=Math.abs(l),R=Math.abs(c),C=Math.abs(u),v,T,F,D,L,k,G,U,H,$,V,ae;if(S>=R&&S>=C?(F=l,k=h,H=p,ae=m,l>=0?(v=c,T=u,D=f,L=d,G=y,U=_,$=b,V=A):(v=u,T=c,D=d,L=f,G=_,U=y,$=A,V=b)):R>=C?(F=c,k=f,H=y,ae=b,c>=0?(v=u,T=l,D=d,L=h,G=_,U=p,$=A,V=m):(v=l,T=u,D=h,L=d,G=p,U=_,$=m,V=A)):(F=u,k=d,H=_,ae=A,u>=0?(v=l,T=c,D=h,L=f,G=p,U=y,$=m,V=b):(v=c,T=l,D=f,L=h,G=y,U=p,$=b,V=m)),F===0)return null;let X=v/F,Q=T/F,se=1/F,fe=D-X*k,he=L-Q*k,ee=G-X*H,me=U-Q*H,ve=$-X*ae,Ae=V-Q*ae,Se=ve*me-Ae*ee,We=fe*Ae-he*ve,rt=ee*he-me*fe;if(s){if(Se<0||We<0||rt<0)return null}else if((Se<0||We<0||rt<0)&&(Se>0||We>0||rt>0))return null;let Ve=Se+We+rt;if(Ve===0)return null;let ft=se*(Se*k+We*H+rt*ae);return(Ve>0?ft<0:ft>0)?null:this.at(ft/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},au=class extends gr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new mr,this.combine=Ld,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},K_=new en,qr=new $r,Dc=new Bs,J_=new K,Nc=new K,Uc=new K,Fc=new K,vd=new K,Oc=new K,j_=new K,Bc=new K,Fi=class extends Si{constructor(e=new gs,t=new au){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Oc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(vd.fromBufferAttribute(h,e),o?Oc.addScaledVector(vd,u):Oc.addScaledVector(vd.sub(t),u))}t.add(Oc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Dc.copy(i.boundingSphere),Dc.applyMatrix4(r),qr.copy(e.ray).recast(e.near),!(Dc.containsPoint(qr.origin)===!1&&(qr.intersectSphere(Dc,J_)===null||qr.origin.distanceToSquared(J_)>(e.far-e.near)**2))&&(K_.copy(r).invert(),qr.copy(e.ray).applyMatrix4(K_),!(i.boundingBox!==null&&qr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,qr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=f.length;p<y;p++){let _=f[p],m=o[_.materialIndex],b=Math.max(_.start,d.start),A=Math.min(a.count,Math.min(_.start+_.count,d.start+d.count));for(let S=b,R=A;S<R;S+=3){let C=a.getX(S),v=a.getX(S+1),T=a.getX(S+2);s=kc(this,m,e,i,c,u,h,C,v,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let _=p,m=y;_<m;_+=3){let b=a.getX(_),A=a.getX(_+1),S=a.getX(_+2);s=kc(this,o,e,i,c,u,h,b,A,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=f.length;p<y;p++){let _=f[p],m=o[_.materialIndex],b=Math.max(_.start,d.start),A=Math.min(l.count,Math.min(_.start+_.count,d.start+d.count));for(let S=b,R=A;S<R;S+=3){let C=S,v=S+1,T=S+2;s=kc(this,m,e,i,c,u,h,C,v,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=_.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let _=p,m=y;_<m;_+=3){let b=_,A=_+1,S=_+2;s=kc(this,o,e,i,c,u,h,b,A,S),s&&(s.faceIndex=Math.floor(_/3),t.push(s))}}}};function ew(n,e,t,i,s,r,o,a){let l;if(e.side===ti?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Sr,a),l===null)return null;Bc.copy(a),Bc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Bc);return c<t.near||c>t.far?null:{distance:c,point:Bc.clone(),object:n}}function kc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Nc),n.getVertexPosition(l,Uc),n.getVertexPosition(c,Fc);let u=ew(n,e,t,i,Nc,Uc,Fc,j_);if(u){let h=new K;pr.getBarycoord(j_,Nc,Uc,Fc,h),s&&(u.uv=pr.getInterpolatedAttribute(s,a,l,c,h,new nt)),r&&(u.uv1=pr.getInterpolatedAttribute(r,a,l,c,h,new nt)),o&&(u.normal=pr.getInterpolatedAttribute(o,a,l,c,h,new K),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new K,materialIndex:0};pr.getNormal(Nc,Uc,Fc,f.normal),u.face=f,u.barycoord=h}return u}var Zr=class extends oi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=On,u=On,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var na=class extends ei{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Xr=new Bs,tw=new nt(.5,.5),zc=new K,Kr=class{constructor(e=new yi,t=new yi,i=new yi,s=new yi,r=new yi,o=new yi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ui,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],p=r[8],y=r[9],_=r[10],m=r[11],b=r[12],A=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-o,d-u,m-p,R-b).normalize(),s[1].setComponents(c+o,d+u,m+p,R+b).normalize(),s[2].setComponents(c+a,d+h,m+y,R+A).normalize(),s[3].setComponents(c-a,d-h,m-y,R-A).normalize(),i)s[4].setComponents(l,f,_,S).normalize(),s[5].setComponents(c-l,d-f,m-_,R-S).normalize();else if(s[4].setComponents(c-l,d-f,m-_,R-S).normalize(),t===Ui)s[5].setComponents(c+l,d+f,m+_,R+S).normalize();else if(t===tl)s[5].setComponents(l,f,_,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Xr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Xr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Xr)}intersectsSprite(e){Xr.center.set(0,0,0);let t=tw.distanceTo(e.center);return Xr.radius=.7071067811865476+t,Xr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Xr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(zc.x=s.normal.x>0?e.max.x:e.min.x,zc.y=s.normal.y>0?e.max.y:e.min.y,zc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(zc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Q_=new en,lu=class n{constructor(){this.coordinateSystem=Ui,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Q_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Kr),i[s].setFromProjectionMatrix(Q_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Kr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var cu=class extends gr{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new xt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},uu=new K,hu=new K,e0=new en,$a=new $r,Gc=new Bs,yd=new K,t0=new K,fu=class extends Si{constructor(e=new gs,t=new cu){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)uu.fromBufferAttribute(t,s-1),hu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=uu.distanceTo(hu);e.setAttribute("lineDistance",new ri(i,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Gc.copy(i.boundingSphere),Gc.applyMatrix4(s),Gc.radius+=r,e.ray.intersectsSphere(Gc)===!1)return;e0.copy(s).invert(),$a.copy(e.ray).applyMatrix4(e0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,f=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=d,_=p-1;y<_;y+=c){let m=u.getX(y),b=u.getX(y+1),A=Vc(this,e,$a,l,m,b,y);A&&t.push(A)}if(this.isLineLoop){let y=u.getX(p-1),_=u.getX(d),m=Vc(this,e,$a,l,y,_,p-1);m&&t.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let y=d,_=p-1;y<_;y+=c){let m=Vc(this,e,$a,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Vc(this,e,$a,l,p-1,d,p-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Vc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(uu.fromBufferAttribute(a,s),hu.fromBufferAttribute(a,r),t.distanceSqToSegment(uu,hu,yd,t0)>i)return;yd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(yd);if(!(c<e.near||c>e.far))return{distance:c,point:t0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var n0=new K,i0=new K,ll=class extends fu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)n0.fromBufferAttribute(t,s),i0.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+n0.distanceTo(i0);e.setAttribute("lineDistance",new ri(i,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var cl=class extends oi{constructor(e=[],t=Qr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var ks=class extends oi{constructor(e,t,i=Ji,s,r,o,a=On,l=On,c,u=Os,h=1){if(u!==Os&&u!==Gs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ea(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ul=class extends ks{constructor(e,t=Ji,i=Qr,s,r,o=On,a=On,l,c=Os){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},hl=class extends oi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ia=class n extends gs{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ri(c,3)),this.setAttribute("normal",new ri(u,3)),this.setAttribute("uv",new ri(h,2));function p(y,_,m,b,A,S,R,C,v,T,F){let D=S/v,L=R/T,k=S/2,G=R/2,U=C/2,H=v+1,$=T+1,V=0,ae=0,X=new K;for(let Q=0;Q<$;Q++){let se=Q*L-G;for(let fe=0;fe<H;fe++){let he=fe*D-k;X[y]=he*b,X[_]=se*A,X[m]=U,c.push(X.x,X.y,X.z),X[y]=0,X[_]=0,X[m]=C>0?1:-1,u.push(X.x,X.y,X.z),h.push(fe/v),h.push(1-Q/T),V+=1}}for(let Q=0;Q<T;Q++)for(let se=0;se<v;se++){let fe=f+se+H*Q,he=f+se+H*(Q+1),ee=f+(se+1)+H*(Q+1),me=f+(se+1)+H*Q;l.push(fe,he,me),l.push(he,ee,me),ae+=6}a.addGroup(d,ae,F),d+=ae,f+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var fl=class n extends gs{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,h=e/a,f=t/l,d=[],p=[],y=[],_=[];for(let m=0;m<u;m++){let b=m*f-o;for(let A=0;A<c;A++){let S=A*h-r;p.push(S,-b,0),y.push(0,0,1),_.push(A/a),_.push(1-m/l)}}for(let m=0;m<l;m++)for(let b=0;b<a;b++){let A=b+c*m,S=b+c*(m+1),R=b+1+c*(m+1),C=b+1+c*m;d.push(A,S,C),d.push(S,R,C)}this.setIndex(d),this.setAttribute("position",new ri(p,3)),this.setAttribute("normal",new ri(y,3)),this.setAttribute("uv",new ri(_,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function to(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(s0(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(s0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function qn(n){let e={};for(let t=0;t<n.length;t++){let i=to(n[t]);for(let s in i)e[s]=i[s]}return e}function s0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function nw(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function sp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var Z0={clone:to,merge:qn},iw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,sw=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Mi=class extends gr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=iw,this.fragmentShader=sw,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=to(e.uniforms),this.uniformsGroups=nw(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new xt().setHex(s.value);break;case"v2":this.uniforms[i].value=new nt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new K().fromArray(s.value);break;case"v4":this.uniforms[i].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Qe().fromArray(s.value);break;case"m4":this.uniforms[i].value=new en().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},du=class extends Mi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var pu=class extends gr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=D0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},mu=class extends gr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Yo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Hc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var _r=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},gu=class extends _r{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:bd,endingEnd:bd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Sd:r=e,a=2*t-i;break;case Md:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Sd:o=e,l=2*i-t;break;case Md:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),y=p*p,_=y*p,m=-f*_+2*f*y-f*p,b=(1+f)*_+(-1.5-2*f)*y+(-.5+f)*p+1,A=(-1-d)*_+(1.5+d)*y+.5*p,S=d*_-d*y;for(let R=0;R!==a;++R)r[R]=m*o[u+R]+b*o[c+R]+A*o[l+R]+S*o[h+R];return r}},_u=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),h=1-u;for(let f=0;f!==a;++f)r[f]=o[c+f]*h+o[l+f]*u;return r}},vu=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},yu=class extends _r{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let p=(i-t)/(s-t),y=1-p;for(let _=0;_!==a;++_)r[_]=o[c+_]*y+o[l+_]*p;return r}let f=a*2,d=e-1;for(let p=0;p!==a;++p){let y=o[c+p],_=o[l+p],m=d*f+p*2,b=h[m],A=h[m+1],S=e*f+p*2,R=u[S],C=u[S+1],v=ow(i,t,b,R,s);r[p]=K0(v,y,A,C,_)}return r}};function K0(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function rw(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function ow(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=K0(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=rw(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var wi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Yo(t,this.TimeBufferType),this.values=Yo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Yo(e.times,Array),values:Yo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Hc(e.settings)&&(i.settings={inTangents:Yo(e.settings.inTangents,Array),outTangents:Yo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new vu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new _u(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new gu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new yu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ja:t=this.InterpolantFactoryMethodDiscrete;break;case iu:t=this.InterpolantFactoryMethodLinear;break;case Xc:t=this.InterpolantFactoryMethodSmooth;break;case xd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $e("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ja;case this.InterpolantFactoryMethodLinear:return iu;case this.InterpolantFactoryMethodSmooth:return Xc;case this.InterpolantFactoryMethodBezier:return xd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Hc(this.settings)&&(r0(this.settings.inTangents,e),r0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Hc(this.settings)&&(o0(this.settings.inTangents,e),o0(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(tt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(tt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){tt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){tt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&SM(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){tt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Xc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*i,f=h-i,d=h+i;for(let p=0;p!==i;++p){let y=t[h+p];if(y!==t[f+p]||y!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,f=o*i;for(let d=0;d!==i;++d)t[f+d]=t[h+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Hc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function r0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function o0(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}wi.prototype.ValueTypeName="";wi.prototype.TimeBufferType=Float32Array;wi.prototype.ValueBufferType=Float32Array;wi.prototype.DefaultInterpolation=iu;var vr=class extends wi{constructor(e,t,i){super(e,t,i)}};vr.prototype.ValueTypeName="bool";vr.prototype.ValueBufferType=Array;vr.prototype.DefaultInterpolation=ja;vr.prototype.InterpolantFactoryMethodLinear=void 0;vr.prototype.InterpolantFactoryMethodSmooth=void 0;var xu=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};xu.prototype.ValueTypeName="color";var bu=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};bu.prototype.ValueTypeName="number";var Su=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)xi.slerpFlat(r,0,o,c-a,o,c,l);return r}},dl=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Su(this.times,this.values,this.getValueSize(),e)}};dl.prototype.ValueTypeName="quaternion";dl.prototype.InterpolantFactoryMethodSmooth=void 0;var yr=class extends wi{constructor(e,t,i){super(e,t,i)}};yr.prototype.ValueTypeName="string";yr.prototype.ValueBufferType=Array;yr.prototype.DefaultInterpolation=ja;yr.prototype.InterpolantFactoryMethodLinear=void 0;yr.prototype.InterpolantFactoryMethodSmooth=void 0;var Mu=class extends wi{constructor(e,t,i,s){super(e,t,i,s)}};Mu.prototype.ValueTypeName="vector";var wu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],p=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},J0=new wu,Tu=class{constructor(e){this.manager=e!==void 0?e:J0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Tu.DEFAULT_MATERIAL_NAME="__DEFAULT";var Wc=new K,qc=new xi,ds=new K,pl=class extends Si{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new en,this.projectionMatrix=new en,this.projectionMatrixInverse=new en,this.coordinateSystem=Ui,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Wc,qc,ds),ds.x===1&&ds.y===1&&ds.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Wc,qc,ds.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Wc,qc,ds),ds.x===1&&ds.y===1&&ds.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Wc,qc,ds.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},dr=new K,a0=new nt,l0=new nt,Qn=class extends pl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Qo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ka*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Qo*2*Math.atan(Math.tan(Ka*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){dr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(dr.x,dr.y).multiplyScalar(-e/dr.z),dr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(dr.x,dr.y).multiplyScalar(-e/dr.z)}getViewSize(e,t){return this.getViewBounds(e,a0,l0),t.subVectors(l0,a0)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ka*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Eu=class extends pl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var sa=class extends gs{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var $o=-90,Zo=1,ra=class extends Si{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Qn($o,Zo,e,t);s.layers=this.layers,this.add(s);let r=new Qn($o,Zo,e,t);r.layers=this.layers,this.add(r);let o=new Qn($o,Zo,e,t);o.layers=this.layers,this.add(o);let a=new Qn($o,Zo,e,t);a.layers=this.layers,this.add(a);let l=new Qn($o,Zo,e,t);l.layers=this.layers,this.add(l);let c=new Qn($o,Zo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ui)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===tl)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let _=!1;e.isWebGLRenderer===!0?_=e.state.buffers.depth.getReversed():_=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),_&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Au=class extends Qn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var rp="\\[\\]\\.:\\/",aw=new RegExp("["+rp+"]","g"),op="[^"+rp+"]",lw="[^"+rp.replace("\\.","")+"]",cw=/((?:WC+[\/:])*)/.source.replace("WC",op),uw=/(WCOD+)?/.source.replace("WCOD",lw),hw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",op),fw=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",op),dw=new RegExp("^"+cw+uw+hw+fw+"$"),pw=["material","materials","bones","map"],wd=class{constructor(e,t,i){let s=i||$t.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},$t=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(aw,"")}static parseTrackName(e){let t=dw.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);pw.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){tt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){tt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){tt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){tt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){tt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){tt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;tt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){tt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$t.Composite=wd;$t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$t.prototype.GetterByBindingType=[$t.prototype._getValue_direct,$t.prototype._getValue_array,$t.prototype._getValue_arrayElement,$t.prototype._getValue_toArray];$t.prototype.SetterByBindingTypeAndVersioning=[[$t.prototype._setValue_direct,$t.prototype._setValue_direct_setNeedsUpdate,$t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_array,$t.prototype._setValue_array_setNeedsUpdate,$t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_arrayElement,$t.prototype._setValue_arrayElement_setNeedsUpdate,$t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_fromArray,$t.prototype._setValue_fromArray_setNeedsUpdate,$t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var bL=new Float32Array(1);var oa=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Td=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var ml=class extends Ki{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function ap(n,e,t,i){let s=mw(i);switch(t){case qd:return n*e;case Yd:return n*e/s.components*s.byteLength;case Nu:return n*e/s.components*s.byteLength;case Mr:return n*e*2/s.components*s.byteLength;case Uu:return n*e*2/s.components*s.byteLength;case Xd:return n*e*3/s.components*s.byteLength;case es:return n*e*4/s.components*s.byteLength;case Fu:return n*e*4/s.components*s.byteLength;case vl:case yl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case xl:case bl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Bu:case zu:return Math.max(n,16)*Math.max(e,8)/4;case Ou:case ku:return Math.max(n,8)*Math.max(e,8)/2;case Gu:case Vu:case Wu:case qu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Hu:case Sl:case Xu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Yu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case $u:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Zu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Ku:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ju:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case ju:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Qu:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case eh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case th:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case nh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case ih:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case sh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case rh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case oh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case ah:case lh:case ch:return Math.ceil(n/4)*Math.ceil(e/4)*16;case uh:case hh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ml:case fh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function mw(n){switch(n){case Ti:case Gd:return{byteLength:1,components:1};case ua:case Vd:case Qi:return{byteLength:2,components:1};case Lu:case Du:return{byteLength:2,components:4};case Ji:case Iu:case ji:return{byteLength:4,components:1};case Hd:case Wd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function yv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function _w(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<h.length;d++){let p=h[f],y=h[d];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++f,h[f]=y)}h.length=f+1;for(let d=0,p=h.length;d<p;d++){let y=h[d];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var vw=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,yw=`#ifdef USE_ALPHAHASH
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
#endif`,xw=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,bw=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Sw=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Mw=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ww=`#ifdef USE_AOMAP
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
#endif`,Tw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Ew=`#ifdef USE_BATCHING
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
#endif`,Aw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Cw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Rw=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Pw=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Iw=`#ifdef USE_IRIDESCENCE
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
#endif`,Lw=`#ifdef USE_BUMPMAP
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
#endif`,Dw=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,Nw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Uw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Fw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Ow=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Bw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,kw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,zw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,Gw=`#define PI 3.141592653589793
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
} // validated`,Vw=`vec3 transformedNormal = objectNormal;
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
#endif`,Hw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ww=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,qw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Xw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Yw="gl_FragColor = linearToOutputTexel( gl_FragColor );",$w=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Zw=`#ifdef USE_ENVMAP
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
#endif`,Kw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Jw=`#ifdef USE_ENVMAP
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
#endif`,jw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Qw=`#ifdef USE_ENVMAP
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
#endif`,e1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,t1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,n1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,i1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,s1=`#ifdef USE_GRADIENTMAP
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
}`,r1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,o1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,a1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,l1=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,c1=`#ifdef USE_ENVMAP
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
#endif`,u1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,h1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,f1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,d1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,p1=`PhysicalMaterial material;
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
#endif`,m1=`uniform sampler2D dfgLUT;
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
}`,g1=`
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
#endif`,_1=`#if defined( RE_IndirectDiffuse )
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
#endif`,v1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,y1=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,x1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,b1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,S1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,M1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,w1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,T1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,E1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,A1=`#if defined( USE_POINTS_UV )
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
#endif`,C1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,R1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,P1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,I1=`#if defined( USE_MORPHCOLORS )
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
#endif`,L1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,D1=`#ifdef USE_MORPHTARGETS
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
#endif`,N1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,U1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,F1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,O1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,B1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,k1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,z1=`#ifdef USE_NORMALMAP
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
#endif`,G1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,V1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,H1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,W1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,q1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,X1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Y1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,$1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Z1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,K1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,J1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,j1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Q1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,eT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,tT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,nT=`float getShadowMask() {
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
}`,iT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,sT=`#ifdef USE_SKINNING
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
#endif`,rT=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,oT=`#ifdef USE_SKINNING
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
#endif`,aT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,lT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,cT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,uT=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,hT=`#ifdef USE_TRANSMISSION
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
#endif`,fT=`#ifdef USE_TRANSMISSION
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
#endif`,dT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,gT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,_T=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,vT=`uniform sampler2D t2D;
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
}`,yT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,xT=`uniform float backgroundBlurriness;
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
}`,bT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ST=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,MT=`#include <common>
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
}`,wT=`#if DEPTH_PACKING == 3200
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
}`,TT=`#define DISTANCE
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
}`,ET=`#define DISTANCE
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
}`,AT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,CT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RT=`uniform float scale;
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
}`,PT=`uniform vec3 diffuse;
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
}`,IT=`#include <common>
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
}`,LT=`uniform vec3 diffuse;
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
}`,DT=`#define LAMBERT
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
}`,NT=`#define LAMBERT
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
}`,UT=`#define MATCAP
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
}`,FT=`#define MATCAP
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
}`,OT=`#define NORMAL
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
}`,BT=`#define NORMAL
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
}`,kT=`#define PHONG
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
}`,zT=`#define PHONG
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
}`,GT=`#define STANDARD
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
}`,VT=`#define STANDARD
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
}`,HT=`#define TOON
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
}`,WT=`#define TOON
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
}`,qT=`uniform float size;
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
}`,XT=`uniform vec3 diffuse;
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
}`,YT=`#include <common>
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
}`,$T=`uniform vec3 color;
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
}`,ZT=`uniform float rotation;
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
}`,KT=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:vw,alphahash_pars_fragment:yw,alphamap_fragment:xw,alphamap_pars_fragment:bw,alphatest_fragment:Sw,alphatest_pars_fragment:Mw,aomap_fragment:ww,aomap_pars_fragment:Tw,batching_pars_vertex:Ew,batching_vertex:Aw,begin_vertex:Cw,beginnormal_vertex:Rw,bsdfs:Pw,iridescence_fragment:Iw,bumpmap_pars_fragment:Lw,clipping_planes_fragment:Dw,clipping_planes_pars_fragment:Nw,clipping_planes_pars_vertex:Uw,clipping_planes_vertex:Fw,color_fragment:Ow,color_pars_fragment:Bw,color_pars_vertex:kw,color_vertex:zw,common:Gw,defaultnormal_vertex:Vw,displacementmap_pars_vertex:Hw,displacementmap_vertex:Ww,emissivemap_fragment:qw,emissivemap_pars_fragment:Xw,colorspace_fragment:Yw,colorspace_pars_fragment:$w,envmap_fragment:Zw,envmap_common_pars_fragment:Kw,envmap_pars_fragment:Jw,envmap_pars_vertex:jw,envmap_physical_pars_fragment:c1,envmap_vertex:Qw,fog_vertex:e1,fog_pars_vertex:t1,fog_fragment:n1,fog_pars_fragment:i1,gradientmap_pars_fragment:s1,lightmap_pars_fragment:r1,lights_lambert_fragment:o1,lights_lambert_pars_fragment:a1,lights_pars_begin:l1,lights_toon_fragment:u1,lights_toon_pars_fragment:h1,lights_phong_fragment:f1,lights_phong_pars_fragment:d1,lights_physical_fragment:p1,lights_physical_pars_fragment:m1,lights_fragment_begin:g1,lights_fragment_maps:_1,lights_fragment_end:v1,lightprobes_pars_fragment:y1,logdepthbuf_fragment:x1,logdepthbuf_pars_fragment:b1,logdepthbuf_pars_vertex:S1,logdepthbuf_vertex:M1,map_fragment:w1,map_pars_fragment:T1,map_particle_fragment:E1,map_particle_pars_fragment:A1,metalnessmap_fragment:C1,metalnessmap_pars_fragment:R1,morphinstance_vertex:P1,morphcolor_vertex:I1,morphnormal_vertex:L1,morphtarget_pars_vertex:D1,morphtarget_vertex:N1,normal_fragment_begin:U1,normal_fragment_maps:F1,normal_pars_fragment:O1,normal_pars_vertex:B1,normal_vertex:k1,normalmap_pars_fragment:z1,clearcoat_normal_fragment_begin:G1,clearcoat_normal_fragment_maps:V1,clearcoat_pars_fragment:H1,iridescence_pars_fragment:W1,opaque_fragment:q1,packing:X1,premultiplied_alpha_fragment:Y1,project_vertex:$1,dithering_fragment:Z1,dithering_pars_fragment:K1,roughnessmap_fragment:J1,roughnessmap_pars_fragment:j1,shadowmap_pars_fragment:Q1,shadowmap_pars_vertex:eT,shadowmap_vertex:tT,shadowmask_pars_fragment:nT,skinbase_vertex:iT,skinning_pars_vertex:sT,skinning_vertex:rT,skinnormal_vertex:oT,specularmap_fragment:aT,specularmap_pars_fragment:lT,tonemapping_fragment:cT,tonemapping_pars_fragment:uT,transmission_fragment:hT,transmission_pars_fragment:fT,uv_pars_fragment:dT,uv_pars_vertex:pT,uv_vertex:mT,worldpos_vertex:gT,background_vert:_T,background_frag:vT,backgroundCube_vert:yT,backgroundCube_frag:xT,cube_vert:bT,cube_frag:ST,depth_vert:MT,depth_frag:wT,distance_vert:TT,distance_frag:ET,equirect_vert:AT,equirect_frag:CT,linedashed_vert:RT,linedashed_frag:PT,meshbasic_vert:IT,meshbasic_frag:LT,meshlambert_vert:DT,meshlambert_frag:NT,meshmatcap_vert:UT,meshmatcap_frag:FT,meshnormal_vert:OT,meshnormal_frag:BT,meshphong_vert:kT,meshphong_frag:zT,meshphysical_vert:GT,meshphysical_frag:VT,meshtoon_vert:HT,meshtoon_frag:WT,points_vert:qT,points_frag:XT,shadow_vert:YT,shadow_frag:$T,sprite_vert:ZT,sprite_frag:KT},Le={common:{diffuse:{value:new xt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Qe}},envmap:{envMap:{value:null},envMapRotation:{value:new Qe},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Qe}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Qe}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Qe},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Qe},normalScale:{value:new nt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Qe},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Qe}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Qe}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Qe}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new xt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new xt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0},uvTransform:{value:new Qe}},sprite:{diffuse:{value:new xt(16777215)},opacity:{value:1},center:{value:new nt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Qe},alphaMap:{value:null},alphaMapTransform:{value:new Qe},alphaTest:{value:0}}},ys={basic:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:qn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},specular:{value:new xt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:qn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:qn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new xt(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:qn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:qn([Le.points,Le.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:qn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:qn([Le.common,Le.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:qn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:qn([Le.sprite,Le.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new Qe},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Qe}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:qn([Le.common,Le.displacementmap,{referencePosition:{value:new K},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:qn([Le.lights,Le.fog,{color:{value:new xt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};ys.physical={uniforms:qn([ys.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Qe},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Qe},clearcoatNormalScale:{value:new nt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Qe},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Qe},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Qe},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Qe},sheen:{value:0},sheenColor:{value:new xt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Qe},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Qe},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Qe},transmissionSamplerSize:{value:new nt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Qe},attenuationDistance:{value:0},attenuationColor:{value:new xt(0)},specularColor:{value:new xt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Qe},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Qe},anisotropyVector:{value:new nt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Qe}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var dh={r:0,b:0,g:0},JT=new en,xv=new Qe;xv.set(-1,0,0,0,1,0,0,0,1);function jT(n,e,t,i,s,r){let o=new xt(0),a=s===!0?0:1,l,c,u=null,h=0,f=null;function d(b){let A=b.isScene===!0?b.background:null;if(A&&A.isTexture){let S=b.backgroundBlurriness>0;A=e.get(A,S)}return A}function p(b){let A=!1,S=d(b);S===null?_(o,a):S&&S.isColor&&(_(S,1),A=!0);let R=n.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(b,A){let S=d(A);S&&S.isCubeTexture?(c===void 0&&(c=new Fi(new ia(1,1,1),new Mi({name:"BackgroundCubeMaterial",uniforms:to(ys.backgroundCube.uniforms),vertexShader:ys.backgroundCube.vertexShader,fragmentShader:ys.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,C,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(JT.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(xv),c.material.toneMapped=yt.getTransfer(S.colorSpace)!==Pt,(u!==S||h!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Fi(new fl(2,2),new Mi({name:"BackgroundMaterial",uniforms:to(ys.background.uniforms),vertexShader:ys.background.vertexShader,fragmentShader:ys.background.fragmentShader,side:Sr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=yt.getTransfer(S.colorSpace)!==Pt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||h!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,h=S.version,f=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function _(b,A){b.getRGB(dh,sp(n)),t.buffers.color.setClear(dh.r,dh.g,dh.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,A=1){o.set(b),a=A,_(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,_(o,a)},render:p,addToRenderList:y,dispose:m}}function QT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(L,k,G,U,H){let $=!1,V=h(L,U,G,k);r!==V&&(r=V,c(r.object)),$=d(L,U,G,H),$&&p(L,U,G,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(L,k,G,U),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function h(L,k,G,U){let H=U.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let V=L.isInstancedMesh===!0?L.id:0,ae=$[V];ae===void 0&&(ae={},$[V]=ae);let X=ae[G.id];X===void 0&&(X={},ae[G.id]=X);let Q=X[H];return Q===void 0&&(Q=f(l()),X[H]=Q),Q}function f(L){let k=[],G=[],U=[];for(let H=0;H<t;H++)k[H]=0,G[H]=0,U[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:G,attributeDivisors:U,object:L,attributes:{},index:null}}function d(L,k,G,U){let H=r.attributes,$=k.attributes,V=0,ae=G.getAttributes();for(let X in ae)if(ae[X].location>=0){let se=H[X],fe=$[X];if(fe===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;V++}return r.attributesNum!==V||r.index!==U}function p(L,k,G,U){let H={},$=k.attributes,V=0,ae=G.getAttributes();for(let X in ae)if(ae[X].location>=0){let se=$[X];se===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[X]=fe,V++}r.attributes=H,r.attributesNum=V,r.index=U}function y(){let L=r.newAttributes;for(let k=0,G=L.length;k<G;k++)L[k]=0}function _(L){m(L,0)}function m(L,k){let G=r.newAttributes,U=r.enabledAttributes,H=r.attributeDivisors;G[L]=1,U[L]===0&&(n.enableVertexAttribArray(L),U[L]=1),H[L]!==k&&(n.vertexAttribDivisor(L,k),H[L]=k)}function b(){let L=r.newAttributes,k=r.enabledAttributes;for(let G=0,U=k.length;G<U;G++)k[G]!==L[G]&&(n.disableVertexAttribArray(G),k[G]=0)}function A(L,k,G,U,H,$,V){V===!0?n.vertexAttribIPointer(L,k,G,H,$):n.vertexAttribPointer(L,k,G,U,H,$)}function S(L,k,G,U){y();let H=U.attributes,$=G.getAttributes(),V=k.defaultAttributeValues;for(let ae in $){let X=$[ae];if(X.location>=0){let Q=H[ae];if(Q===void 0&&(ae==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),ae==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let se=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ve=he.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===Iu;if(Q.isInterleavedBufferAttribute){let Se=Q.data,We=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,rt=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Ve=0;Ve<X.locationSize;Ve++)m(X.location+Ve,Se.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Ve=0;Ve<X.locationSize;Ve++)_(X.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ve=0;Ve<X.locationSize;Ve++)A(X.location+Ve,fe/X.locationSize,me,se,We*ve,(rt+fe/X.locationSize*Ve)*ve,Ae)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<X.locationSize;Se++)m(X.location+Se,Q.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<X.locationSize;Se++)_(X.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<X.locationSize;Se++)A(X.location+Se,fe/X.locationSize,me,se,fe*ve,fe/X.locationSize*Se*ve,Ae)}}else if(V!==void 0){let se=V[ae];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(X.location,se);break;case 3:n.vertexAttrib3fv(X.location,se);break;case 4:n.vertexAttrib4fv(X.location,se);break;default:n.vertexAttrib1fv(X.location,se)}}}}b()}function R(){F();for(let L in i){let k=i[L];for(let G in k){let U=k[G];for(let H in U){let $=U[H];for(let V in $)u($[V].object),delete $[V];delete U[H]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let k=i[L.id];for(let G in k){let U=k[G];for(let H in U){let $=U[H];for(let V in $)u($[V].object),delete $[V];delete U[H]}}delete i[L.id]}function v(L){for(let k in i){let G=i[k];for(let U in G){let H=G[U];if(H[L.id]===void 0)continue;let $=H[L.id];for(let V in $)u($[V].object),delete $[V];delete H[L.id]}}}function T(L){for(let k in i){let G=i[k],U=L.isInstancedMesh===!0?L.id:0,H=G[U];if(H!==void 0){for(let $ in H){let V=H[$];for(let ae in V)u(V[ae].object),delete V[ae];delete H[$]}delete G[U],Object.keys(G).length===0&&delete i[k]}}}function F(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:F,resetDefaultState:D,dispose:R,releaseStatesOfGeometry:C,releaseStatesOfObject:T,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:_,disableUnusedAttributes:b}}function eE(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function tE(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==es&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let T=v===Qi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Ti&&v!==ji&&!T&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),_=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),R=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:_,maxAttributes:m,maxVertexUniforms:b,maxVaryings:A,maxFragmentUniforms:S,maxSamples:R,samples:C}}function nE(n){let e=this,t=null,i=0,s=!1,r=!1,o=new yi,a=new Qe,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||i!==0||s;return s=f,i=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let p=h.clippingPlanes,y=h.clipIntersection,_=h.clipShadows,m=n.get(h);if(!s||p===null||p.length===0||r&&!_)r?u(null):c();else{let b=r?0:i,A=b*4,S=m.clippingState||null;l.value=S,S=u(p,f,A,d);for(let R=0;R!==A;++R)S[R]=t[R];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,f,d,p){let y=h!==null?h.length:0,_=null;if(y!==0){if(_=l.value,p!==!0||_===null){let m=d+y*4,b=f.matrixWorldInverse;a.getNormalMatrix(b),(_===null||_.length<m)&&(_=new Float32Array(m));for(let A=0,S=d;A!==y;++A,S+=4)o.copy(h[A]).applyMatrix4(b,a),o.normal.toArray(_,S),_[S+3]=o.constant}l.value=_,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,_}}var El=class extends bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new cl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ia(5,5,5),r=new Mi({name:"CubemapFromEquirect",uniforms:to(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:ti,blending:Jr});r.uniforms.tEquirect.value=t;let o=new Fi(s,r),a=t.minFilter;return t.minFilter===zs&&(t.minFilter=zn),new ra(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},j0=256,iE=3,sE=20,bv=256,Sv=16,rE=3,oE=new K,aE=new xt,mh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ra(1,10,null),this._boxMesh=new Fi(new ia(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=oE}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(aE));let _=new ra(i,s,u);return _.position.copy(a),_.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=p,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=tv(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=ev(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(j0,tp(e))}_fromTexture(e,t){e.mapping===Qr||e.mapping===ca?this._setSize(e.image.length===0?j0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Q0(e,!1,!1),i=Math.log2(e)-iE;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Q0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Qr||e.mapping===ca?(this._cubemapMaterial===null&&(this._cubemapMaterial=tv()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=ev()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=lE(),this._integrationMaterial=cE());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Sv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-rE)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(bv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=uE());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Q0(n,e,t){return new El(n,{minFilter:zs,generateMipmaps:e,type:Qi,colorSpace:Qa,depthBuffer:t})}function Al(n,e,t){return new Mi({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:ti,blending:Jr,depthTest:!1,depthWrite:!1})}function lE(){return Al("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${bv}u

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
	`)}function cE(){return Al("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Sv}},`

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
	`)}function uE(){return Al("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${sE}
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
	`)}function ev(){return Al("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function tv(){return Al("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function hE(n){let e=new WeakMap,t=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===Cu||d===Ru)if(e.has(f)){let p=e.get(f).texture;return a(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let y=new El(p.height);return y.fromEquirectangularTexture(n,f),e.set(f,y),f.addEventListener("dispose",c),a(y.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===Cu||d===Ru,y=d===Qr||d===ca;if(p||y){let _=t.get(f),m=_!==void 0?_.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new mh(n)),_=p?i.fromEquirectangular(f,_):i.fromCubemap(f,_),_.texture.pmremVersion=f.pmremVersion,t.set(f,_),_.texture;if(_!==void 0)return _.texture;{let b=f.image;return p&&b&&b.height>0||y&&b&&l(b)?(i===null&&(i=new mh(n)),_=p?i.fromEquirectangular(f):i.fromCubemap(f),_.texture.pmremVersion=f.pmremVersion,t.set(f,_),f.addEventListener("dispose",u),_.texture):null}}}return f}function a(f,d){return d===Cu?f.mapping=Qr:d===Ru&&(f.mapping=ca),f}function l(f){let d=0,p=6;for(let y=0;y<p;y++)f[y]!==void 0&&d++;return d===p}function c(f){let d=f.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:h}}function fE(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Za("WebGLRenderer: "+i+" extension not supported."),s}}}function dE(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let _ in p.attributes)e.remove(p.attributes[_]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(e.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(p){let y=p.attributes;for(let _ in y)e.update(y[_],n.ARRAY_BUFFER)}function h(p){let y=p.index,_=p.attributes.position,m=0;if(_===void 0)return;let b=y!==null?y.array.length:_.array.length/3-1,A=_.count>=65535?al:ol,S=new A(Math.ceil(b/3)*6,1),R=S.array;if(y!==null){let v=y.array;m=y.version;for(let T=0,F=0;T<b;T+=3){let D=v[T+0],L=v[T+1],k=v[T+2];R[F++]=D,R[F++]=L,R[F++]=L,R[F++]=k,R[F++]=k,R[F++]=D}}else{m=_.version;for(let v=0,T=0;v<b;v+=3){let F=v+0,D=v+1,L=v+2;R[T++]=F,R[T++]=D,R[T++]=D,R[T++]=L,R[T++]=L,R[T++]=F}}S.version=m;let C=r.get(p);C&&e.remove(C),r.set(p,S)}function f(p){let y=r.get(p);if(y){let _=p.index;_!==null&&y.version<_.version&&h(p)}else h(p);return r.get(p)}function d(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function pE(n,e,t){let i;function s(h){i=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,f){n.drawElements(i,f,r,h*o),t.update(f,i,1)}function c(h,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,h*o,d),t.update(f,i,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,h,0,d);let y=0;for(let _=0;_<d;_++)y+=f[_];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function mE(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:tt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function gE(n,e,t){let i=new WeakMap,s=new tn;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=i.get(a);if(f===void 0||f.count!==h){let F=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",F)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,_=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],A=0;d===!0&&(A=1),p===!0&&(A=2),y===!0&&(A=3);let S=a.attributes.position.count*A,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*R*4*h),v=new il(C,S,R,h);v.type=ji,v.needsUpdate=!0;let T=A*4;for(let D=0;D<h;D++){let L=_[D],k=m[D],G=b[D],U=S*R*4*D;for(let H=0;H<L.count;H++){let $=H*T;d===!0&&(s.fromBufferAttribute(L,H),C[U+$+0]=s.x,C[U+$+1]=s.y,C[U+$+2]=s.z,C[U+$+3]=0),p===!0&&(s.fromBufferAttribute(k,H),C[U+$+4]=s.x,C[U+$+5]=s.y,C[U+$+6]=s.z,C[U+$+7]=0),y===!0&&(s.fromBufferAttribute(G,H),C[U+$+8]=s.x,C[U+$+9]=s.y,C[U+$+10]=s.z,C[U+$+11]=G.itemSize===4?s.w:1)}}f={count:h,texture:v,size:new nt(S,R)},i.set(a,f),a.addEventListener("dispose",F)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function _E(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,f=e.get(c,h);if(r.get(f)!==u&&(e.update(f),r.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return f}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var vE={[Dd]:"LINEAR_TONE_MAPPING",[Nd]:"REINHARD_TONE_MAPPING",[Ud]:"CINEON_TONE_MAPPING",[Fd]:"ACES_FILMIC_TONE_MAPPING",[Bd]:"AGX_TONE_MAPPING",[kd]:"NEUTRAL_TONE_MAPPING",[Od]:"CUSTOM_TONE_MAPPING"};function yE(n,e,t,i,s,r){let o=new bi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new gs;u.setAttribute("position",new ri([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ri([0,2,0,0,2,0],2));let h=new du({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Fi(u,h),d=new Eu(-1,1,1,-1,0,1),p=null,y=null,_=!1,m,b=null,A=[],S=!1;this.setSize=function(R,C){o.setSize(R,C),a!==null&&a.setSize(R,C),l!==null&&l.setSize(R,C);for(let v=0;v<A.length;v++){let T=A[v];T.setSize&&T.setSize(R,C)}},this.setEffects=function(R){A=R,S=A.length>0&&A[0].isRenderPass===!0;let C=o.width,v=o.height;A.length>0&&a===null&&(a=new bi(C,v,{type:Qi,depthBuffer:!1,stencilBuffer:!1}),l=new bi(C,v,{type:Qi,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&A.some(F=>F.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new ks(C,v),r===!0&&(c.format=Gs,c.type=eo)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let F=0;F<A.length;F++){let D=A[F];D.setSize&&D.setSize(C,v),T&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(R,C){if(_||R.toneMapping===_s&&A.length===0)return!1;if(b=C,C!==null){let v=C.width,T=C.height;(o.width!==v||o.height!==T)&&this.setSize(v,T)}return S===!1&&R.setRenderTarget(o),m=R.toneMapping,R.toneMapping=_s,!0},this.hasRenderPass=function(){return S},this.end=function(R,C){R.toneMapping=m,_=!0;let v=o,T=a;for(let F=0;F<A.length;F++){let D=A[F];D.enabled!==!1&&(D.render(R,T,v,C),D.needsSwap!==!1&&(v=T,T=T===a?l:a))}if(p!==R.outputColorSpace||y!==R.toneMapping){p=R.outputColorSpace,y=R.toneMapping,h.defines={},yt.getTransfer(p)===Pt&&(h.defines.SRGB_TRANSFER="");let F=vE[y];F&&(h.defines[F]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=v.texture,R.setRenderTarget(b),R.render(f,d),b=null,_=!1},this.isCompositing=function(){return _},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Mv=new oi,wv=new ks(1,1),Tv=new ul(1),Ev=new il,Av=new ou,Cv=new cl,nv=[],iv=[],sv=new Float32Array(16),rv=new Float32Array(9),ov=new Float32Array(4);function da(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=nv[s];if(r===void 0&&(r=new Float32Array(s),nv[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Cn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Rn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function _h(n,e){let t=iv[e];t===void 0&&(t=new Int32Array(e),iv[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function xE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function bE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2fv(this.addr,e),Rn(t,e)}}function SE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;n.uniform3fv(this.addr,e),Rn(t,e)}}function ME(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4fv(this.addr,e),Rn(t,e)}}function wE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;ov.set(i),n.uniformMatrix2fv(this.addr,!1,ov),Rn(t,i)}}function TE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;rv.set(i),n.uniformMatrix3fv(this.addr,!1,rv),Rn(t,i)}}function EE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;sv.set(i),n.uniformMatrix4fv(this.addr,!1,sv),Rn(t,i)}}function AE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function CE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2iv(this.addr,e),Rn(t,e)}}function RE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3iv(this.addr,e),Rn(t,e)}}function PE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4iv(this.addr,e),Rn(t,e)}}function IE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function LE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2uiv(this.addr,e),Rn(t,e)}}function DE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3uiv(this.addr,e),Rn(t,e)}}function NE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4uiv(this.addr,e),Rn(t,e)}}function vh(n){return n.version===0&&(n.compareFunction=Jd,n.needsUpdate=!0),n}function UE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=vh(wv):r=Mv,t.setTexture2D(e||r,s)}function FE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Av,s)}function OE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=vh(Tv):r=Cv,t.setTextureCube(e||r,s)}function BE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Ev,s)}function kE(n){switch(n){case 5126:return xE;case 35664:return bE;case 35665:return SE;case 35666:return ME;case 35674:return wE;case 35675:return TE;case 35676:return EE;case 5124:case 35670:return AE;case 35667:case 35671:return CE;case 35668:case 35672:return RE;case 35669:case 35673:return PE;case 5125:return IE;case 36294:return LE;case 36295:return DE;case 36296:return NE;case 35678:case 36198:case 36298:case 36306:case 35682:return UE;case 35679:case 36299:case 36307:return FE;case 35680:case 36300:case 36308:case 36293:return OE;case 36289:case 36303:case 36311:case 36292:return BE}}function zE(n,e){n.uniform1fv(this.addr,e)}function GE(n,e){let t=da(e,this.size,2);n.uniform2fv(this.addr,t)}function VE(n,e){let t=da(e,this.size,3);n.uniform3fv(this.addr,t)}function HE(n,e){let t=da(e,this.size,4);n.uniform4fv(this.addr,t)}function WE(n,e){let t=da(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function qE(n,e){let t=da(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function XE(n,e){let t=da(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function YE(n,e){n.uniform1iv(this.addr,e)}function $E(n,e){n.uniform2iv(this.addr,e)}function ZE(n,e){n.uniform3iv(this.addr,e)}function KE(n,e){n.uniform4iv(this.addr,e)}function JE(n,e){n.uniform1uiv(this.addr,e)}function jE(n,e){n.uniform2uiv(this.addr,e)}function QE(n,e){n.uniform3uiv(this.addr,e)}function eA(n,e){n.uniform4uiv(this.addr,e)}function tA(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=vh(wv):o=Mv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function nA(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Av,r[o])}function iA(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=vh(Tv):o=Cv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function sA(n,e,t){let i=this.cache,s=e.length,r=_h(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Ev,r[o])}function rA(n){switch(n){case 5126:return zE;case 35664:return GE;case 35665:return VE;case 35666:return HE;case 35674:return WE;case 35675:return qE;case 35676:return XE;case 5124:case 35670:return YE;case 35667:case 35671:return $E;case 35668:case 35672:return ZE;case 35669:case 35673:return KE;case 5125:return JE;case 36294:return jE;case 36295:return QE;case 36296:return eA;case 35678:case 36198:case 36298:case 36306:case 35682:return tA;case 35679:case 36299:case 36307:return nA;case 35680:case 36300:case 36308:case 36293:return iA;case 36289:case 36303:case 36311:case 36292:return sA}}var up=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=kE(t.type)}},hp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=rA(t.type)}},fp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},lp=/(\w+)(\])?(\[|\.)?/g;function av(n,e){n.seq.push(e),n.map[e.id]=e}function oA(n,e,t){let i=n.name,s=i.length;for(lp.lastIndex=0;;){let r=lp.exec(i),o=lp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){av(t,c===void 0?new up(a,n,e):new hp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new fp(a),av(t,h)),t=h}}}var fa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);oA(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function lv(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var aA=37297,lA=0;function cA(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var cv=new Qe;function uA(n){yt._getMatrix(cv,yt.workingColorSpace,n);let e=`mat3( ${cv.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(n)){case el:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function uv(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+cA(n.getShaderSource(e),a)}else return r}function hA(n,e){let t=uA(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var fA={[Dd]:"Linear",[Nd]:"Reinhard",[Ud]:"Cineon",[Fd]:"ACESFilmic",[Bd]:"AgX",[kd]:"Neutral",[Od]:"Custom"};function dA(n,e){let t=fA[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ph=new K;function pA(){yt.getLuminanceCoefficients(ph);let n=ph.x.toFixed(4),e=ph.y.toFixed(4),t=ph.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function mA(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Tl).join(`
`)}function gA(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function _A(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Tl(n){return n!==""}function hv(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function fv(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var vA=/^[ \t]*#include +<([\w\d./]+)>/gm;function dp(n){return n.replace(vA,yA)}function yA(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return dp(t)}var xA=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function dv(n){return n.replace(xA,bA)}function bA(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function pv(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var SA={[gl]:"SHADOWMAP_TYPE_PCF",[aa]:"SHADOWMAP_TYPE_VSM"};function MA(n){return SA[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var wA={[ca]:"ENVMAP_MODE_REFRACTION"};function TA(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":wA[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var EA={[Ld]:"ENVMAP_BLENDING_MULTIPLY",[P0]:"ENVMAP_BLENDING_MIX",[I0]:"ENVMAP_BLENDING_ADD"};function AA(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":EA[n.combine]||"ENVMAP_BLENDING_NONE"}function CA(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=MA(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=TA(t),h=AA(t),f=mA(t),d=gA(r),p=s.createProgram(),y,_,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Tl).join(`
`),y.length>0&&(y+=`
`),_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Tl).join(`
`),_.length>0&&(_+=`
`)):(y=[pv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Tl).join(`
`),_=[pv(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==_s?"#define TONE_MAPPING":"",t.toneMapping!==_s?ht.tonemapping_pars_fragment:"",t.toneMapping!==_s?dA("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,hA("linearToOutputTexel",t.outputColorSpace),pA(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Tl).join(`
`)),o=dp(o),o=hv(o,t),o=fv(o,t),a=dp(a),a=hv(a,t),a=fv(a,t),o=dv(o),a=dv(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,_=["#define varying in",t.glslVersion===jd?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===jd?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+_);let b=m+y+o,A=m+_+a,S=lv(s,s.VERTEX_SHADER,b),R=lv(s,s.FRAGMENT_SHADER,A);s.attachShader(p,S),s.attachShader(p,R),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function C(D){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",k=s.getShaderInfoLog(S)||"",G=s.getShaderInfoLog(R)||"",U=L.trim(),H=k.trim(),$=G.trim(),V=!0,ae=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,R);else{let X=uv(s,S,"vertex"),Q=uv(s,R,"fragment");tt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+U+`
`+X+`
`+Q)}else U!==""?$e("WebGLProgram: Program Info Log:",U):(H===""||$==="")&&(ae=!1);ae&&(D.diagnostics={runnable:V,programLog:U,vertexShader:{log:H,prefix:y},fragmentShader:{log:$,prefix:_}})}s.deleteShader(S),s.deleteShader(R),v=new fa(s,p),T=_A(s,p)}let v;this.getUniforms=function(){return v===void 0&&C(this),v};let T;this.getAttributes=function(){return T===void 0&&C(this),T};let F=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return F===!1&&(F=s.getProgramParameter(p,aA)),F},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=lA++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=R,this}var RA=0,pp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new mp(e),t.set(e,i)),i}},mp=class{constructor(e){this.id=RA++,this.code=e,this.usedTimes=0}};function PA(n){return n===Mr||n===Sl||n===Ml}function IA(n,e,t,i,s,r){let o=new sl,a=new pp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,T,F,D,L,k){let G=D.fog,U=L.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?D.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,V=e.get(v.envMap||H,$),ae=f[v.type],X=i.precision;v.precision!==null&&(X=i.getMaxPrecision(v.precision),X!==v.precision&&$e("WebGLProgram.getParameters:",v.precision,"not supported, using",X,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,se=Q!==void 0?Q.length:0,fe=0;U.morphAttributes.position!==void 0&&(fe=1),U.morphAttributes.normal!==void 0&&(fe=2),U.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ve;if(ae){let Ce=ys[ae];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),lt=a.getFragmentShaderStage(v);a.update(v,Ce,lt),me=Ce.id,ve=lt.id}let Ae=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),We=L.isInstancedMesh===!0,rt=L.isBatchedMesh===!0,Ve=!!v.map,ft=!!v.matcap,ct=!!V,it=ct&&V.isPMREMTexture===!0,Zt=!!v.aoMap,zt=!!v.lightMap,dn=!!v.bumpMap&&v.wireframe===!1,Ut=!!v.normalMap,In=!!v.displacementMap,bt=!!v.emissiveMap,Mn=!!v.metalnessMap,nn=!!v.roughnessMap,pn=v.anisotropy>0,B=v.clearcoat>0,Re=v.diffuseRoughness>0,Ze=v.dispersion>0,ot=v.retroreflectivity>0,Me=v.iridescence>0,Ot=v.sheen>0,ze=v.transmission>0,Ye=pn&&!!v.anisotropyMap,P=B&&!!v.clearcoatMap,M=B&&!!v.clearcoatNormalMap,q=B&&!!v.clearcoatRoughnessMap,ue=Re&&!!v.diffuseRoughnessMap,oe=Me&&!!v.iridescenceMap,_e=Me&&!!v.iridescenceThicknessMap,ye=Ot&&!!v.sheenColorMap,te=Ot&&!!v.sheenRoughnessMap,ie=!!v.specularMap,pe=!!v.specularColorMap,O=!!v.specularIntensityMap,re=ze&&!!v.transmissionMap,ne=ze&&!!v.thicknessMap,we=!!v.gradientMap,ge=!!v.alphaMap,be=v.alphaTest>0,He=!!v.alphaHash,Je=!!v.extensions,ce=_s;v.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Oe=it?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,je={shaderID:ae,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:X,batching:rt,batchingColor:rt&&L._colorsTexture!==null,instancing:We,instancingColor:We&&L.instanceColor!==null,instancingMorph:We&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:yt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ve,matcap:ft,envMap:ct,envMapMode:ct&&V.mapping,envMapPMREM:it,envMapMaxLod:it?Oe.length-1:null,envMapSize:it?Oe[0].width:null,aoMap:Zt,lightMap:zt,bumpMap:dn,normalMap:Ut,displacementMap:In,emissiveMap:bt,normalMapObjectSpace:Ut&&v.normalMapType===N0,normalMapTangentSpace:Ut&&v.normalMapType===$d,packedNormalMap:Ut&&v.normalMapType===$d&&PA(v.normalMap.format),metalnessMap:Mn,roughnessMap:nn,anisotropy:pn,anisotropyMap:Ye,clearcoat:B,clearcoatMap:P,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ze,retroreflection:ot,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:_e,sheen:Ot,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:pe,specularIntensityMap:O,transmission:ze,transmissionMap:re,thicknessMap:ne,gradientMap:we,opaque:v.transparent===!1&&v.blending===la&&v.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:He,combine:v.combine,mapUv:Ve&&d(v.map.channel),aoMapUv:Zt&&d(v.aoMap.channel),lightMapUv:zt&&d(v.lightMap.channel),bumpMapUv:dn&&d(v.bumpMap.channel),normalMapUv:Ut&&d(v.normalMap.channel),displacementMapUv:In&&d(v.displacementMap.channel),emissiveMapUv:bt&&d(v.emissiveMap.channel),metalnessMapUv:Mn&&d(v.metalnessMap.channel),roughnessMapUv:nn&&d(v.roughnessMap.channel),anisotropyMapUv:Ye&&d(v.anisotropyMap.channel),clearcoatMapUv:P&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(v.sheenRoughnessMap.channel),specularMapUv:ie&&d(v.specularMap.channel),specularColorMapUv:pe&&d(v.specularColorMap.channel),specularIntensityMapUv:O&&d(v.specularIntensityMap.channel),transmissionMapUv:re&&d(v.transmissionMap.channel),thicknessMapUv:ne&&d(v.thicknessMap.channel),alphaMapUv:ge&&d(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ut||pn),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(Ve||ge),fog:!!G,useFog:v.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&Ut===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Se,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&F.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ve&&v.map.isVideoTexture===!0&&yt.getTransfer(v.map.colorSpace)===Pt,decodeVideoTextureEmissive:bt&&v.emissiveMap.isVideoTexture===!0&&yt.getTransfer(v.emissiveMap.colorSpace)===Pt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Oi,flipSided:v.side===ti,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Je&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&v.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return je.vertexUv1s=l.has(1),je.vertexUv2s=l.has(2),je.vertexUv3s=l.has(3),l.clear(),je}function y(v){let T=[];if(v.shaderID?T.push(v.shaderID):(T.push(v.customVertexShaderID),T.push(v.customFragmentShaderID)),v.defines!==void 0)for(let F in v.defines)T.push(F),T.push(v.defines[F]);return v.isRawShaderMaterial===!1&&(_(T,v),m(T,v),T.push(n.outputColorSpace)),T.push(v.customProgramCacheKey),T.join()}function _(v,T){v.push(T.precision),v.push(T.outputColorSpace),v.push(T.envMapMode),v.push(T.envMapPMREM),v.push(T.envMapMaxLod),v.push(T.envMapSize),v.push(T.mapUv),v.push(T.alphaMapUv),v.push(T.lightMapUv),v.push(T.aoMapUv),v.push(T.bumpMapUv),v.push(T.normalMapUv),v.push(T.displacementMapUv),v.push(T.emissiveMapUv),v.push(T.metalnessMapUv),v.push(T.roughnessMapUv),v.push(T.anisotropyMapUv),v.push(T.clearcoatMapUv),v.push(T.clearcoatNormalMapUv),v.push(T.clearcoatRoughnessMapUv),v.push(T.diffuseRoughnessMapUv),v.push(T.iridescenceMapUv),v.push(T.iridescenceThicknessMapUv),v.push(T.sheenColorMapUv),v.push(T.sheenRoughnessMapUv),v.push(T.specularMapUv),v.push(T.specularColorMapUv),v.push(T.specularIntensityMapUv),v.push(T.transmissionMapUv),v.push(T.thicknessMapUv),v.push(T.combine),v.push(T.fogExp2),v.push(T.sizeAttenuation),v.push(T.morphTargetsCount),v.push(T.numSunLights),v.push(T.numDirLights),v.push(T.numPointLights),v.push(T.numSpotLights),v.push(T.numSpotLightMaps),v.push(T.numHemiLights),v.push(T.numRectAreaLights),v.push(T.numSunLightShadows),v.push(T.numDirLightShadows),v.push(T.numPointLightShadows),v.push(T.numSpotLightShadows),v.push(T.numSpotLightShadowsWithMaps),v.push(T.numLightProbes),v.push(T.numLightProbeGrids),v.push(T.shadowMapType),v.push(T.toneMapping),v.push(T.numClippingPlanes),v.push(T.numClipIntersection),v.push(T.depthPacking)}function m(v,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let T=f[v.type],F;if(T){let D=ys[T];F=Z0.clone(D.uniforms)}else F=v.uniforms;return F}function A(v,T){let F=u.get(T);return F!==void 0?++F.usedTimes:(F=new CA(n,T,v,s),c.push(F),u.set(T,F)),F}function S(v){if(--v.usedTimes===0){let T=c.indexOf(v);c[T]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function R(v){a.remove(v)}function C(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:b,acquireProgram:A,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:C}}function LA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function DA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function mv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function gv(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,p,y,_,m){let b=n[e];return b===void 0?(b={id:f.id,object:f,geometry:d,material:p,materialVariant:o(f),groupOrder:y,renderOrder:f.renderOrder,z:_,group:m},n[e]=b):(b.id=f.id,b.object=f,b.geometry=d,b.material=p,b.materialVariant=o(f),b.groupOrder=y,b.renderOrder=f.renderOrder,b.z=_,b.group=m),e++,b}function l(f,d,p,y,_,m,b){b.reversedDepth===!0&&(_=-_);let A=a(f,d,p,y,_,m);p.transmission>0?i.push(A):p.transparent===!0?s.push(A):t.push(A)}function c(f,d,p,y,_,m){let b=a(f,d,p,y,_,m);p.transmission>0?i.unshift(b):p.transparent===!0?s.unshift(b):t.unshift(b)}function u(f,d){t.length>1&&t.sort(f||DA),i.length>1&&i.sort(d||mv),s.length>1&&s.sort(d||mv)}function h(){for(let f=e,d=n.length;f<d;f++){let p=n[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function NA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new gv,n.set(i,[o])):s>=r.length?(o=new gv,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function UA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new K,color:new xt};break;case"SpotLight":t={position:new K,direction:new K,color:new xt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new K,color:new xt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new K,skyColor:new xt,groundColor:new xt};break;case"RectAreaLight":t={color:new xt,position:new K,halfWidth:new K,halfHeight:new K};break}return n[e.id]=t,t}}}function FA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new nt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new nt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new nt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var OA=0;function BA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function kA(n){let e=new UA,t=FA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new K);let s=new K,r=new en,o=new en;function a(c){let u=0,h=0,f=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,p=0,y=0,_=0,m=0,b=0,A=0,S=0,R=0,C=0,v=0,T=0,F=0,D=0;c.sort(BA);for(let k=0,G=c.length;k<G;k++){let U=c[k],H=U.color,$=U.intensity,V=U.distance,ae=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Mr?ae=U.shadow.map.texture:ae=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)u+=H.r*$,h+=H.g*$,f+=H.b*$;else if(U.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(U.sh.coefficients[X],$);D++}else if(U.isSunLight){let X=e.get(U);if(X.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=se,i.sunShadowMap[p]=ae;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[y+he]=Q.getMatrix(he),i.sunShadowCascade[y+he]=Q._cascadeData[he];y+=fe,p++}i.sun[d]=X,d++}else if(U.isDirectionalLight){let X=e.get(U);if(X.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[_]=se,i.directionalShadowMap[_]=ae,i.directionalShadowMatrix[_]=U.shadow.matrix,R++}i.directional[_]=X,_++}else if(U.isSpotLight){let X=e.get(U);X.position.setFromMatrixPosition(U.matrixWorld),X.color.copy(H).multiplyScalar($),X.distance=V,X.coneCos=Math.cos(U.angle),X.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),X.decay=U.decay,i.spot[b]=X;let Q=U.shadow;if(U.map&&(i.spotLightMap[T]=U.map,T++,Q.updateMatrices(U),U.castShadow&&F++),i.spotLightMatrix[b]=Q.matrix,U.castShadow){let se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[b]=se,i.spotShadowMap[b]=ae,v++}b++}else if(U.isRectAreaLight){let X=e.get(U);X.color.copy(H).multiplyScalar($),X.halfWidth.set(U.width*.5,0,0),X.halfHeight.set(0,U.height*.5,0),i.rectArea[A]=X,A++}else if(U.isPointLight){let X=e.get(U);if(X.color.copy(U.color).multiplyScalar(U.intensity),X.distance=U.distance,X.decay=U.decay,U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[m]=se,i.pointShadowMap[m]=ae,i.pointShadowMatrix[m]=U.shadow.matrix,C++}i.point[m]=X,m++}else if(U.isHemisphereLight){let X=e.get(U);X.skyColor.copy(U.color).multiplyScalar($),X.groundColor.copy(U.groundColor).multiplyScalar($),i.hemi[S]=X,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=f;let L=i.hash;(L.sunLength!==d||L.directionalLength!==_||L.pointLength!==m||L.spotLength!==b||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==p||L.numDirectionalShadows!==R||L.numPointShadows!==C||L.numSpotShadows!==v||L.numSpotMaps!==T||L.numLightProbes!==D)&&(i.sun.length=d,i.directional.length=_,i.spot.length=b,i.rectArea.length=A,i.point.length=m,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=R,i.directionalShadowMap.length=R,i.directionalShadowMatrix.length=R,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+T-F,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=F,i.numLightProbes=D,L.sunLength=d,L.directionalLength=_,L.pointLength=m,L.spotLength=b,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=p,L.numDirectionalShadows=R,L.numPointShadows=C,L.numSpotShadows=v,L.numSpotMaps=T,L.numLightProbes=D,i.version=OA++)}function l(c,u){let h=0,f=0,d=0,p=0,y=0,_=0,m=u.matrixWorldInverse;for(let b=0,A=c.length;b<A;b++){let S=c[b];if(S.isSunLight){let R=i.sun[h];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),h++}else if(S.isDirectionalLight){let R=i.directional[f];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),f++}else if(S.isSpotLight){let R=i.spot[p];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(m),p++}else if(S.isRectAreaLight){let R=i.rectArea[y];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let R=i.point[d];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){let R=i.hemi[_];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(m),_++}}}return{setup:a,setupView:l,state:i}}function _v(n){let e=new kA(n),t=[],i=[],s=[];function r(h){u.camera=h,t.length=0,i.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),s.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function zA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new _v(n),e.set(s,[a])):r>=o.length?(a=new _v(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var GA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,VA=`uniform sampler2D shadow_pass;
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
}`,HA=[new K(1,0,0),new K(-1,0,0),new K(0,1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1)],WA=[new K(0,-1,0),new K(0,-1,0),new K(0,0,1),new K(0,0,-1),new K(0,-1,0),new K(0,-1,0)],vv=new en,wl=new K,cp=new K;function qA(n,e,t){let i=new Kr,s=new nt,r=new nt,o=new tn,a=new pu,l=new mu,c={},u=t.maxTextureSize,h={[Sr]:ti,[ti]:Sr,[Oi]:Oi},f=new Mi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new nt},radius:{value:4}},vertexShader:GA,fragmentShader:VA}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new gs;p.setAttribute("position",new ei(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Fi(p,f),_=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=gl;let m=this.type;this.render=function(C,v,T){if(_.enabled===!1||_.autoUpdate===!1&&_.needsUpdate===!1||C.length===0)return;this.type===h0&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=gl);let F=n.getRenderTarget(),D=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),k=n.state;k.setBlending(Jr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let G=m!==this.type;G&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(H=>H.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,H=C.length;U<H;U++){let $=C[U],V=$.shadow;if(V===void 0){$e("WebGLShadowMap:",$,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let ae=V.getFrameExtents();s.multiply(ae),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,V.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===aa){if($.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new bi(s.x,s.y,{format:Mr,type:Qi,minFilter:zn,magFilter:zn,generateMipmaps:!1}),V.map.texture.name=$.name+".shadowMap",V.map.depthTexture=new ks(s.x,s.y,ji),V.map.depthTexture.name=$.name+".shadowMapDepth",V.map.depthTexture.format=Os,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=On,V.map.depthTexture.magFilter=On}else $.isPointLight?(V.map=new El(s.x),V.map.depthTexture=new ul(s.x,Ji)):(V.map=new bi(s.x,s.y),V.map.depthTexture=new ks(s.x,s.y,Ji)),V.map.depthTexture.name=$.name+".shadowMap",V.map.depthTexture.format=Os,this.type===gl?(V.map.depthTexture.compareFunction=X?Kd:Zd,V.map.depthTexture.minFilter=zn,V.map.depthTexture.magFilter=zn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=On,V.map.depthTexture.magFilter=On);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();$.isPointLight!==!0&&V.updateMatrices($,T);let se=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:T.layers;for(let fe=0;fe<Q;fe++){let he=V.getCamera(fe);if($.isPointLight){let ee=V.camera,me=V.matrix,ve=$.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),wl.setFromMatrixPosition($.matrixWorld),ee.position.copy(wl),cp.copy(ee.position),cp.add(HA[fe]),ee.up.copy(WA[fe]),ee.lookAt(cp),ee.updateMatrixWorld(),me.makeTranslation(-wl.x,-wl.y,-wl.z),vv.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(vv,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),k.viewport(o)}i=V.getFrustum(fe),S(v,T,he,$,se,this.type)}V.isPointLightShadow!==!0&&this.type===aa&&b(V,T),V.needsUpdate=!1}m=this.type,_.needsUpdate=!1,n.setRenderTarget(F,D,L)};function b(C,v){let T=e.update(y);f.defines.VSM_SAMPLES!==C.blurSamples&&(f.defines.VSM_SAMPLES=C.blurSamples,d.defines.VSM_SAMPLES=C.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),C.mapPass===null?C.mapPass=new bi(s.x,s.y,{format:Mr,type:Qi}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),f.uniforms.shadow_pass.value=C.map.depthTexture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(v,null,T,f,y,null),d.uniforms.shadow_pass.value=C.mapPass.texture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(v,null,T,d,y,null)}function A(C,v,T,F){let D=null,L=T.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)D=L;else if(D=T.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let k=D.uuid,G=v.uuid,U=c[k];U===void 0&&(U={},c[k]=U);let H=U[G];H===void 0&&(H=D.clone(),U[G]=H,v.addEventListener("dispose",R)),D=H}if(D.visible=v.visible,D.wireframe=v.wireframe,F===aa?D.side=v.shadowSide!==null?v.shadowSide:v.side:D.side=v.shadowSide!==null?v.shadowSide:h[v.side],D.alphaMap=v.alphaMap,D.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,D.map=v.map,D.clipShadows=v.clipShadows,D.clippingPlanes=v.clippingPlanes,D.clipIntersection=v.clipIntersection,D.displacementMap=v.displacementMap,D.displacementScale=v.displacementScale,D.displacementBias=v.displacementBias,D.wireframeLinewidth=v.wireframeLinewidth,D.linewidth=v.linewidth,T.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let k=n.properties.get(D);k.light=T}return D}function S(C,v,T,F,D,L){if(C.visible===!1)return;if(C.layers.test(D)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===aa)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,C.matrixWorld);let U=e.update(C),H=C.material;if(Array.isArray(H)){let $=U.groups;for(let V=0,ae=$.length;V<ae;V++){let X=$[V],Q=H[X.materialIndex];if(Q&&Q.visible){let se=A(C,Q,F,L);C.onBeforeShadow(n,C,v,T,U,se,X),n.renderBufferDirect(T,null,U,se,C,X),C.onAfterShadow(n,C,v,T,U,se,X)}}}else if(H.visible){let $=A(C,H,F,L);C.onBeforeShadow(n,C,v,T,U,$,null),n.renderBufferDirect(T,null,U,$,C,null),C.onAfterShadow(n,C,v,T,U,$,null)}}let G=C.children;for(let U=0,H=G.length;U<H;U++)S(G[U],v,T,F,D,L)}function R(C){C.target.removeEventListener("dispose",R);for(let T in c){let F=c[T],D=C.target.uuid;D in F&&(F[D].dispose(),delete F[D])}}}function XA(n,e){function t(){let O=!1,re=new tn,ne=null,we=new tn(0,0,0,0);return{setMask:function(ge){ne!==ge&&!O&&(n.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){O=ge},setClear:function(ge,be,He,Je,ce){ce===!0&&(ge*=Je,be*=Je,He*=Je),re.set(ge,be,He,Je),we.equals(re)===!1&&(n.clearColor(ge,be,He,Je),we.copy(re))},reset:function(){O=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){if(re!==be){let He=e.get("EXT_clip_control");be?He.clipControlEXT(He.LOWER_LEFT_EXT,He.ZERO_TO_ONE_EXT):He.clipControlEXT(He.LOWER_LEFT_EXT,He.NEGATIVE_ONE_TO_ONE_EXT),re=be;let Je=ge;ge=null,this.setClear(Je)}},getReversed:function(){return re},setTest:function(be){be?Se(n.DEPTH_TEST):We(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!O&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=q0[be]),we!==be){switch(be){case $c:n.depthFunc(n.NEVER);break;case Zc:n.depthFunc(n.ALWAYS);break;case Kc:n.depthFunc(n.LESS);break;case Jo:n.depthFunc(n.LEQUAL);break;case Jc:n.depthFunc(n.EQUAL);break;case jc:n.depthFunc(n.GEQUAL);break;case Qc:n.depthFunc(n.GREATER);break;case eu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=be}},setLocked:function(be){O=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){O=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let O=!1,re=null,ne=null,we=null,ge=null,be=null,He=null,Je=null,ce=null;return{setTest:function(Oe){O||(Oe?Se(n.STENCIL_TEST):We(n.STENCIL_TEST))},setMask:function(Oe){re!==Oe&&!O&&(n.stencilMask(Oe),re=Oe)},setFunc:function(Oe,je,Ce){(ne!==Oe||we!==je||ge!==Ce)&&(n.stencilFunc(Oe,je,Ce),ne=Oe,we=je,ge=Ce)},setOp:function(Oe,je,Ce){(be!==Oe||He!==je||Je!==Ce)&&(n.stencilOp(Oe,je,Ce),be=Oe,He=je,Je=Ce)},setLocked:function(Oe){O=Oe},setClear:function(Oe){ce!==Oe&&(n.clearStencil(Oe),ce=Oe)},reset:function(){O=!1,re=null,ne=null,we=null,ge=null,be=null,He=null,Je=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,p=[],y=null,_=!1,m=null,b=null,A=null,S=null,R=null,C=null,v=null,T=new xt(0,0,0),F=0,D=!1,L=null,k=null,G=null,U=null,H=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ae=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=ae>=1):X.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=ae>=2);let Q=null,se={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new tn().fromArray(fe),me=new tn().fromArray(he);function ve(O,re,ne,we){let ge=new Uint8Array(4),be=n.createTexture();n.bindTexture(O,be),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let He=0;He<ne;He++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+He,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return be}let Ae={};Ae[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(Jo),dn(!1),Ut(Ed),Se(n.CULL_FACE),Zt(Jr);function Se(O){u[O]!==!0&&(n.enable(O),u[O]=!0)}function We(O){u[O]!==!1&&(n.disable(O),u[O]=!1)}function rt(O,re){return f[O]!==re?(n.bindFramebuffer(O,re),f[O]=re,O===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ve(O,re){let ne=p,we=!1;if(O){ne=d.get(re),ne===void 0&&(ne=[],d.set(re,ne));let ge=O.textures;if(ne.length!==ge.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,He=ge.length;be<He;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function ft(O){return y!==O?(n.useProgram(O),y=O,!0):!1}let ct={[jr]:n.FUNC_ADD,[d0]:n.FUNC_SUBTRACT,[p0]:n.FUNC_REVERSE_SUBTRACT};ct[m0]=n.MIN,ct[g0]=n.MAX;let it={[_0]:n.ZERO,[v0]:n.ONE,[y0]:n.SRC_COLOR,[Pd]:n.SRC_ALPHA,[T0]:n.SRC_ALPHA_SATURATE,[M0]:n.DST_COLOR,[b0]:n.DST_ALPHA,[x0]:n.ONE_MINUS_SRC_COLOR,[Id]:n.ONE_MINUS_SRC_ALPHA,[w0]:n.ONE_MINUS_DST_COLOR,[S0]:n.ONE_MINUS_DST_ALPHA,[E0]:n.CONSTANT_COLOR,[A0]:n.ONE_MINUS_CONSTANT_COLOR,[C0]:n.CONSTANT_ALPHA,[R0]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(O,re,ne,we,ge,be,He,Je,ce,Oe){if(O===Jr){_===!0&&(We(n.BLEND),_=!1);return}if(_===!1&&(Se(n.BLEND),_=!0),O!==f0){if(O!==m||Oe!==D){if((b!==jr||R!==jr)&&(n.blendEquation(n.FUNC_ADD),b=jr,R=jr),Oe)switch(O){case la:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFunc(n.ONE,n.ONE);break;case Cd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Rd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:tt("WebGLState: Invalid blending: ",O);break}else switch(O){case la:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Ad:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Cd:tt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Rd:tt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:tt("WebGLState: Invalid blending: ",O);break}A=null,S=null,C=null,v=null,T.set(0,0,0),F=0,m=O,D=Oe}return}ge=ge||re,be=be||ne,He=He||we,(re!==b||ge!==R)&&(n.blendEquationSeparate(ct[re],ct[ge]),b=re,R=ge),(ne!==A||we!==S||be!==C||He!==v)&&(n.blendFuncSeparate(it[ne],it[we],it[be],it[He]),A=ne,S=we,C=be,v=He),(Je.equals(T)===!1||ce!==F)&&(n.blendColor(Je.r,Je.g,Je.b,ce),T.copy(Je),F=ce),m=O,D=!1}function zt(O,re){O.side===Oi?We(n.CULL_FACE):Se(n.CULL_FACE);let ne=O.side===ti;re&&(ne=!ne),dn(ne),O.blending===la&&O.transparent===!1?Zt(Jr):Zt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let we=O.stencilWrite;a.setTest(we),we&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),bt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):We(n.SAMPLE_ALPHA_TO_COVERAGE)}function dn(O){L!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),L=O)}function Ut(O){O!==c0?(Se(n.CULL_FACE),O!==k&&(O===Ed?n.cullFace(n.BACK):O===u0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):We(n.CULL_FACE),k=O}function In(O){O!==G&&(V&&n.lineWidth(O),G=O)}function bt(O,re,ne){O?(Se(n.POLYGON_OFFSET_FILL),(U!==re||H!==ne)&&(U=re,H=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):We(n.POLYGON_OFFSET_FILL)}function Mn(O){O?Se(n.SCISSOR_TEST):We(n.SCISSOR_TEST)}function nn(O){O===void 0&&(O=n.TEXTURE0+$-1),Q!==O&&(n.activeTexture(O),Q=O)}function pn(O,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let we=se[ne];we===void 0&&(we={type:void 0,texture:void 0},se[ne]=we),(we.type!==O||we.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(O,re||Ae[O]),we.type=O,we.texture=re)}function B(){let O=se[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function ot(){try{n.texSubImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function Me(){try{n.texSubImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function Ot(){try{n.compressedTexSubImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function Ye(){try{n.texStorage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function P(){try{n.texStorage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function M(){try{n.texImage2D(...arguments)}catch(O){tt("WebGLState:",O)}}function q(){try{n.texImage3D(...arguments)}catch(O){tt("WebGLState:",O)}}function ue(O){return h[O]!==void 0?h[O]:n.getParameter(O)}function oe(O,re){h[O]!==re&&(n.pixelStorei(O,re),h[O]=re)}function _e(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function ye(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function te(O,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(O);we===void 0&&(we=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,we,we),ne.set(O,we))}function ie(O,re,ne){let ge=c.get(re).get(O);l[ge]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},Q=null,se={},f={},l={},d=new WeakMap,p=[],y=null,_=!1,m=null,b=null,A=null,S=null,R=null,C=null,v=null,T=new xt(0,0,0),F=0,D=!1,L=null,k=null,G=null,U=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:We,bindFramebuffer:rt,drawBuffers:Ve,useProgram:ft,setBlending:Zt,setMaterial:zt,setFlipSided:dn,setCullFace:Ut,setLineWidth:In,setPolygonOffset:bt,setScissorTest:Mn,activeTexture:nn,bindTexture:pn,unbindTexture:B,compressedTexImage2D:Re,compressedTexImage3D:Ze,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:Ye,texStorage3D:P,texSubImage2D:ot,texSubImage3D:Me,compressedTexSubImage2D:Ot,compressedTexSubImage3D:ze,scissor:_e,viewport:ye,reset:pe}}function YA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new nt,u=new WeakMap,h=new Set,f,d=new WeakMap,p=new Set,y=new FinalizationRegistry(P=>p.delete(P)),_=!1;try{_=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(P,M){return _?new OffscreenCanvas(P,M):nl("canvas")}function b(P,M,q){let ue=1,oe=Ye(P);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&P instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&P instanceof ImageBitmap||typeof VideoFrame<"u"&&P instanceof VideoFrame){let _e=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);f===void 0&&(f=m(_e,ye));let te=M?m(_e,ye):f;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(P,0,0,_e,ye),$e("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+ye+")."),te}else return"data"in P&&$e("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),P;return P}function A(P){return P.generateMipmaps}function S(P){n.generateMipmap(P)}function R(P){return P.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:P.isWebGL3DRenderTarget?n.TEXTURE_3D:P.isWebGLArrayRenderTarget||P.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(P,M,q,ue,oe,_e=!1){if(P!==null){if(n[P]!==void 0)return n[P];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+P+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let ie=_e?el:yt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Pt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(P,M){let q;return P?M===null||M===Ji||M===eo?q=n.DEPTH24_STENCIL8:M===ji?q=n.DEPTH32F_STENCIL8:M===ua&&(q=n.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Ji||M===eo?q=n.DEPTH_COMPONENT24:M===ji?q=n.DEPTH_COMPONENT32F:M===ua&&(q=n.DEPTH_COMPONENT16),q}function T(P,M){return A(P)===!0||P.isFramebufferTexture&&P.minFilter!==On&&P.minFilter!==zn?Math.log2(Math.max(M.width,M.height))+1:P.mipmaps.length>0?P.mipmaps.length:P.isCompressedTexture&&Array.isArray(P.image)?M.mipmaps.length:1}function F(P){let M=new WeakRef(P);i.get(P).__ref=M,p.add(M),y.register(P,M,M)}function D(P){let M=i.get(P).__ref;M!==void 0&&(p.delete(M),y.unregister(M))}function L(P){G(P.target)}function k(P){U(P.target)}function G(P){P.removeEventListener("dispose",L),D(P),$(P),P.isVideoTexture&&u.delete(P),P.isHTMLTexture&&h.delete(P)}function U(P){P.removeEventListener("dispose",k),D(P),ae(P)}function H(){for(let P of p){let M=P.deref();M!==void 0&&(M.isRenderTarget===!0?U(M):G(M))}p.clear(),h.clear()}function $(P){let M=i.get(P);if(M.__webglInit===void 0)return;let q=P.source,ue=d.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(P),Object.keys(ue).length===0&&d.delete(q)}i.remove(P)}function V(P){let M=i.get(P);n.deleteTexture(M.__webglTexture);let q=P.source,ue=d.get(q);delete ue[M.__cacheKey],o.memory.textures--}function ae(P){let M=i.get(P);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=P.depthTexture;if(q&&q.renderTarget===P&&G(q),P.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let _e=0;_e<M.__webglFramebuffer[oe].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[oe][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=P.textures;for(let oe=0,_e=ue.length;oe<_e;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(P)}let X=0;function Q(){X=0}function se(){return X}function fe(P){X=P}function he(){let P=X;return P>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(P+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,P}function ee(P){let M=[];return M.push(P.wrapS),M.push(P.wrapT),M.push(P.wrapR||0),M.push(P.magFilter),M.push(P.minFilter),M.push(P.anisotropy),M.push(P.internalFormat),M.push(P.format),M.push(P.type),M.push(P.generateMipmaps),M.push(P.mipmapsAutoUpdate),M.push(P.premultiplyAlpha),M.push(P.flipY),M.push(P.unpackAlignment),M.push(P.colorSpace),M.join()}function me(P,M){let q=i.get(P);if(P.isVideoTexture&&Ot(P),P.isRenderTargetTexture===!1&&P.isExternalTexture!==!0&&P.version>0&&q.__version!==P.version){let ue=P.image;if(ue===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{zt(q,P,M);return}}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ve(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){zt(q,P,M);return}else P.isExternalTexture&&(q.__webglTexture=P.sourceTexture?P.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ae(P,M){let q=i.get(P);if(P.isRenderTargetTexture===!1&&P.version>0&&q.__version!==P.version){zt(q,P,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Se(P,M){let q=i.get(P);if(P.version>0&&q.__version!==P.version){dn(q,P,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let We={[tu]:n.REPEAT,[ps]:n.CLAMP_TO_EDGE,[nu]:n.MIRRORED_REPEAT},rt={[On]:n.NEAREST,[L0]:n.NEAREST_MIPMAP_NEAREST,[_l]:n.NEAREST_MIPMAP_LINEAR,[zn]:n.LINEAR,[Pu]:n.LINEAR_MIPMAP_NEAREST,[zs]:n.LINEAR_MIPMAP_LINEAR},Ve={[F0]:n.NEVER,[Jd]:n.ALWAYS,[O0]:n.LESS,[Zd]:n.LEQUAL,[B0]:n.EQUAL,[Kd]:n.GEQUAL,[k0]:n.GREATER,[z0]:n.NOTEQUAL};function ft(P,M){if(M.type===ji&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===zn||M.magFilter===Pu||M.magFilter===_l||M.magFilter===zs||M.minFilter===zn||M.minFilter===Pu||M.minFilter===_l||M.minFilter===zs)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(P,n.TEXTURE_WRAP_S,We[M.wrapS]),n.texParameteri(P,n.TEXTURE_WRAP_T,We[M.wrapT]),(P===n.TEXTURE_3D||P===n.TEXTURE_2D_ARRAY)&&n.texParameteri(P,n.TEXTURE_WRAP_R,We[M.wrapR]),n.texParameteri(P,n.TEXTURE_MAG_FILTER,rt[M.magFilter]),n.texParameteri(P,n.TEXTURE_MIN_FILTER,rt[M.minFilter]),M.compareFunction&&(n.texParameteri(P,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(P,n.TEXTURE_COMPARE_FUNC,Ve[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===On||M.minFilter!==_l&&M.minFilter!==zs||M.type===ji&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(P,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ct(P,M){let q=!1;P.__webglInit===void 0&&(P.__webglInit=!0,M.addEventListener("dispose",L),F(M));let ue=M.source,oe=d.get(ue);oe===void 0&&(oe={},d.set(ue,oe));let _e=ee(M);if(_e!==P.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[_e].usedTimes++;let ye=oe[P.__cacheKey];ye!==void 0&&(oe[P.__cacheKey].usedTimes--,ye.usedTimes===0&&V(M)),P.__cacheKey=_e,P.__webglTexture=oe[_e].texture}return q}function it(P,M,q){return Math.floor(Math.floor(P/q)/M)}function Zt(P,M,q,ue){let _e=P.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{_e.sort((O,re)=>O.start-re.start);let ye=0;for(let O=1;O<_e.length;O++){let re=_e[ye],ne=_e[O],we=re.start+re.count,ge=it(ne.start,M.width,4),be=it(re.start,M.width,4);ne.start<=we+1&&ge===be&&it(ne.start+ne.count-1,M.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let O=0,re=_e.length;O<re;O++){let ne=_e[O],we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%M.width,He=Math.floor(we/M.width),Je=ge,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,He),t.texSubImage2D(n.TEXTURE_2D,0,be,He,Je,ce,q,ue,M.data)}P.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function zt(P,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ct(P,M),_e=M.source;t.bindTexture(ue,P.__webglTexture,n.TEXTURE0+q);let ye=i.get(_e);if(_e.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=yt.getPrimaries(yt.workingColorSpace),Oe=M.colorSpace===Vs?null:yt.getPrimaries(M.colorSpace),je=M.colorSpace===Vs||ce===Oe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,je)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=b(M.image,!1,s.maxTextureSize);ie=ze(M,ie);let pe=r.convert(M.format,M.colorSpace),O=r.convert(M.type),re=C(M.internalFormat,pe,O,M.normalized,M.colorSpace,M.isVideoTexture);ft(ue,M);let ne,we=M.mipmaps,ge=M.isVideoTexture!==!0,be=ye.__version===void 0||oe===!0,He=_e.dataReady,Je=T(M,ie);if(M.isDepthTexture)re=v(M.format===Gs,M.type),be&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,O,null));else if(M.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data);M.generateMipmaps=!1}else ge?(be&&t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height),He&&Zt(M,ie,pe,O)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,O,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,we[0].width,we[0].height,ie.depth);for(let ce=0,Oe=we.length;ce<Oe;ce++)if(ne=we[ce],M.format!==es)if(pe!==null)if(ge){if(He)if(M.layerUpdates.size>0){let je=ap(ne.width,ne.height,M.format,M.type);for(let Ce of M.layerUpdates){let lt=ne.data.subarray(Ce*je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?He&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,O,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,pe,O,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(n.TEXTURE_2D,Je,re,we[0].width,we[0].height);for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],M.format!==es?pe!==null?ge?He&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,O,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,O,ne.data)}else if(M.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Je,re,ie.width,ie.height,ie.depth),He)if(M.layerUpdates.size>0){let ce=ap(ie.width,ie.height,M.format,M.type);for(let Oe of M.layerUpdates){let je=ie.data.subarray(Oe*ce/ie.data.BYTES_PER_ELEMENT,(Oe+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Oe,ie.width,ie.height,1,pe,O,je)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,O,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(M.isData3DTexture)ge?(be&&t.texStorage3D(n.TEXTURE_3D,Je,re,ie.width,ie.height,ie.depth),He&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,O,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,pe,O,ie.data);else if(M.isFramebufferTexture){if(be)if(ge)t.texStorage2D(n.TEXTURE_2D,Je,re,ie.width,ie.height);else{let ce=ie.width,Oe=ie.height;for(let je=0;je<Je;je++)t.texImage2D(n.TEXTURE_2D,je,re,ce,Oe,0,pe,O,null),ce>>=1,Oe>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),h.add(M),ce.onpaint=Oe=>{let je=Oe.changedElements;for(let Ce of h)je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let je=n.RGBA,Ce=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,je,Ce,lt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=Ye(we[0]);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],ge?He&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,O,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,O,ne);M.generateMipmaps=!1}else if(ge){if(be){let ce=Ye(ie);t.texStorage2D(n.TEXTURE_2D,Je,re,ce.width,ce.height)}He&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,O,ie);A(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=_e.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function dn(P,M,q){if(M.image.length!==6)return;let ue=ct(P,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,P.__webglTexture,n.TEXTURE0+q);let _e=i.get(oe);if(oe.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=yt.getPrimaries(yt.workingColorSpace),te=M.colorSpace===Vs?null:yt.getPrimaries(M.colorSpace),ie=M.colorSpace===Vs||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,O=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!O?re[Ce]=b(M.image[Ce],!0,s.maxCubemapSize):re[Ce]=O?M.image[Ce].image:M.image[Ce],re[Ce]=ze(M,re[Ce]);let ne=re[0],we=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=C(M.internalFormat,we,ge,M.normalized,M.colorSpace),He=M.isVideoTexture!==!0,Je=_e.__version===void 0||ue===!0,ce=oe.dataReady,Oe=T(M,ne);ft(n.TEXTURE_CUBE_MAP,M);let je;if(M.isDepthTexture){if(be=v(M.format===Gs,M.type),Je)if(He)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,0,we,ge,null)}else if(pe){He&&Je&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){je=re[Ce].mipmaps;for(let lt=0;lt<je.length;lt++){let Ht=je[lt];M.format!==es?we!==null?He?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Ht.width,Ht.height,we,Ht.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,be,Ht.width,Ht.height,0,Ht.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Ht.width,Ht.height,we,ge,Ht.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,be,Ht.width,Ht.height,0,we,ge,Ht.data)}}}else{if(je=M.mipmaps,He&&Je){je.length>0&&Oe++;let Ce=Ye(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,we,ge,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,re[Ce].width,re[Ce].height,0,we,ge,re[Ce].data);for(let lt=0;lt<je.length;lt++){let Xn=je[lt].image[Ce].image;He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Xn.width,Xn.height,we,ge,Xn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,be,Xn.width,Xn.height,0,we,ge,Xn.data)}}else{He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ge,re[Ce]);for(let lt=0;lt<je.length;lt++){let Ht=je[lt];He?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,we,ge,Ht.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,be,we,ge,Ht.image[Ce])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=oe.version,M.onUpdate&&M.onUpdate(M)}P.__version=M.version}function Ut(P,M,q,ue,oe,_e){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ie=C(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(M),O=i.get(q);if(O.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>_e),ne=Math.max(1,M.height>>_e);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,ie,re,ne,M.depth,0,ye,te,null):t.texImage2D(oe,_e,ie,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,P),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,O.__webglTexture,0,ot(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,O.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function In(P,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,P),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,_e=v(M.stencilBuffer,oe),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),_e,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,P)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let _e=ue[oe],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),ie=C(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ot(M),ie,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ot(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(P,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,P),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):me(M.depthTexture,0);let ye=oe.__webglTexture,te=ot(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===Gs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Os)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else if(M.depthTexture.format===Gs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Mn(P){let M=i.get(P),q=P.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==P.depthTexture){let ue=P.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(P.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)bt(M.__webglFramebuffer[ue],P,ue);else P.texture.mipmaps.length>0?bt(M.__webglFramebuffer[0],P,0):bt(M.__webglFramebuffer,P,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),In(M.__webglDepthbuffer[ue],P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}}else if(P.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),In(M.__webglDepthbuffer,P,!1);else{let oe=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function nn(P,M,q){let ue=i.get(P);M!==void 0&&Ut(ue.__webglFramebuffer,P,P.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Mn(P)}function pn(P){let M=P.texture,q=i.get(P),ue=i.get(M);P.addEventListener("dispose",k),F(P);let oe=P.textures,_e=P.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,ie=oe.length;te<ie;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(P.samples>0&&Me(P)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(ie.format,ie.colorSpace),O=r.convert(ie.type),re=C(ie.internalFormat,pe,O,ie.normalized,ie.colorSpace,P.isXRRenderTarget===!0),ne=ot(P);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,P.width,P.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),P.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),In(q.__webglDepthRenderbuffer,P,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ft(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(q.__webglFramebuffer[te][ie],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Ut(q.__webglFramebuffer[te],P,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=oe.length;te<ie;te++){let pe=oe[te],O=i.get(pe),re=n.TEXTURE_2D;(P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(re=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ft(re,pe),Ut(q.__webglFramebuffer,P,pe,n.COLOR_ATTACHMENT0+te,re,0),A(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((P.isWebGL3DRenderTarget||P.isWebGLArrayRenderTarget)&&(te=P.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ft(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(q.__webglFramebuffer[ie],P,M,n.COLOR_ATTACHMENT0,te,ie);else Ut(q.__webglFramebuffer,P,M,n.COLOR_ATTACHMENT0,te,0);A(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}P.depthBuffer&&Mn(P)}function B(P){let M=P.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let _e=R(P),ye=i.get(oe).__webglTexture;t.bindTexture(_e,ye),S(_e),t.unbindTexture()}}}let Re=[];function Ze(P){if(P.samples>0){if(Me(P)===!1){let M=P.textures,q=P.width,ue=P.height,oe=n.COLOR_BUFFER_BIT,_e=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(P),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),P.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(P.resolveDepthBuffer&&(P.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),P.stencilBuffer&&P.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(P.depthBuffer&&P.storeMultisampledDepthBuffer===!1&&l){let M=P.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ot(P){return Math.min(s.maxSamples,P.samples)}function Me(P){let M=i.get(P);return P.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ot(P){let M=o.render.frame;u.get(P)!==M&&(u.set(P,M),P.update())}function ze(P,M){let q=P.colorSpace,ue=P.format,oe=P.type;return P.isCompressedTexture===!0||P.isVideoTexture===!0||q!==Qa&&q!==Vs&&(yt.getTransfer(q)===Pt?(ue!==es||oe!==Ti)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):tt("WebGLTextures: Unsupported texture color space:",q)),M}function Ye(P){return typeof HTMLImageElement<"u"&&P instanceof HTMLImageElement?(c.width=P.naturalWidth||P.width,c.height=P.naturalHeight||P.height):typeof VideoFrame<"u"&&P instanceof VideoFrame?(c.width=P.displayWidth,c.height=P.displayHeight):(c.width=P.width,c.height=P.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ae,this.setTextureCube=Se,this.rebindTextures=nn,this.setupRenderTarget=pn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Mn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Me,this.dispose=H}function $A(n,e){function t(i,s=Vs){let r,o=yt.getTransfer(s);if(i===Ti)return n.UNSIGNED_BYTE;if(i===Lu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Du)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Hd)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Wd)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Gd)return n.BYTE;if(i===Vd)return n.SHORT;if(i===ua)return n.UNSIGNED_SHORT;if(i===Iu)return n.INT;if(i===Ji)return n.UNSIGNED_INT;if(i===ji)return n.FLOAT;if(i===Qi)return n.HALF_FLOAT;if(i===qd)return n.ALPHA;if(i===Xd)return n.RGB;if(i===es)return n.RGBA;if(i===Os)return n.DEPTH_COMPONENT;if(i===Gs)return n.DEPTH_STENCIL;if(i===Yd)return n.RED;if(i===Nu)return n.RED_INTEGER;if(i===Mr)return n.RG;if(i===Uu)return n.RG_INTEGER;if(i===Fu)return n.RGBA_INTEGER;if(i===vl||i===yl||i===xl||i===bl)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===vl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===bl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===vl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===yl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===bl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ou||i===Bu||i===ku||i===zu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ou)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Bu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===ku)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===zu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Gu||i===Vu||i===Hu||i===Wu||i===qu||i===Sl||i===Xu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Gu||i===Vu)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Hu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Wu)return r.COMPRESSED_R11_EAC;if(i===qu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Sl)return r.COMPRESSED_RG11_EAC;if(i===Xu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Yu||i===$u||i===Zu||i===Ku||i===Ju||i===ju||i===Qu||i===eh||i===th||i===nh||i===ih||i===sh||i===rh||i===oh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Yu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===$u)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Zu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Ku)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ju)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ju)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Qu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===eh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===th)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===nh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ih)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===sh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===rh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===oh)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===ah||i===lh||i===ch)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===ah)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===lh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ch)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===uh||i===hh||i===Ml||i===fh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===uh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===hh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ml)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===fh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===eo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var ZA=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,KA=`
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

}`,gp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new hl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Mi({vertexShader:ZA,fragmentShader:KA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Fi(new fl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},_p=class extends Ki{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,p=null,y=typeof XRWebGLBinding<"u",_=new gp,m={},b=t.getContextAttributes(),A=null,S=null,R=[],C=[],v=new nt,T=null,F=null,D=new Qn;D.viewport=new tn;let L=new Qn;L.viewport=new tn;let k=[D,L],G=new Au,U=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=R[ee];return me===void 0&&(me=new ta,R[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=R[ee];return me===void 0&&(me=new ta,R[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=R[ee];return me===void 0&&(me=new ta,R[ee]=me),me.getHandSpace()};function $(ee){let me=C.indexOf(ee.inputSource);if(me===-1)return;let ve=R[me];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",ae);for(let ee=0;ee<R.length;ee++){let me=C[ee];me!==null&&(C[ee]=null,R[ee].disconnect(me))}U=null,H=null,_.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(A),d=null,f=null,h=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(v.width,v.height,!1),F!==null){let ee=F.camera;ee.fov=F.fov,ee.zoom=F.zoom,ee.updateProjectionMatrix(),F=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&y&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",V),s.addEventListener("inputsourceschange",ae),b.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ae=null,Se=null;b.depth&&(Se=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=b.stencil?Gs:Os,Ae=b.stencil?eo:Ji);let We={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(We),s.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new bi(f.textureWidth,f.textureHeight,{format:es,type:Ti,depthTexture:new ks(f.textureWidth,f.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ve={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new bi(d.framebufferWidth,d.framebufferHeight,{format:es,type:Ti,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return _.getDepthTexture()};function ae(ee){for(let me=0;me<ee.removed.length;me++){let ve=ee.removed[me],Ae=C.indexOf(ve);Ae>=0&&(C[Ae]=null,R[Ae].disconnect(ve))}for(let me=0;me<ee.added.length;me++){let ve=ee.added[me],Ae=C.indexOf(ve);if(Ae===-1){for(let We=0;We<R.length;We++)if(We>=C.length){C.push(ve),Ae=We;break}else if(C[We]===null){C[We]=ve,Ae=We;break}if(Ae===-1)break}let Se=R[Ae];Se&&Se.connect(ve)}}function X(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ve=ee.far;_.texture!==null&&(_.depthNear>0&&(me=_.depthNear),_.depthFar>0&&(ve=_.depthFar)),G.near=L.near=D.near=me,G.far=L.far=D.far=ve,(U!==G.near||H!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),U=G.near,H=G.far),G.layers.mask=ee.layers.mask|6,D.layers.mask=G.layers.mask&-5,L.layers.mask=G.layers.mask&-3;let Ae=ee.parent,Se=G.cameras;X(G,Ae);for(let We=0;We<Se.length;We++)X(Se[We],Ae);G.projectionMatrix.copy(D.projectionMatrix),G.projectionMatrixInverse.copy(D.projectionMatrixInverse),F===null&&ee.isPerspectiveCamera&&(F={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,G,Ae)};function Q(ee,me,ve){ve===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Qo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return _.texture!==null},this.getDepthSensingMesh=function(){return _.getMesh(G)},this.getCameraTexture=function(ee){return m[ee]};let se=null;function fe(ee,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ve=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Ae=!1;ve.length!==G.cameras.length&&(G.cameras.length=0,Ae=!0);for(let Ve=0;Ve<ve.length;Ve++){let ft=ve[Ve],ct=null;if(d!==null)ct=d.getViewport(ft);else{let Zt=h.getViewSubImage(f,ft);ct=Zt.viewport,Ve===0&&(e.setRenderTargetTextures(S,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(S))}let it=k[Ve];it===void 0&&(it=new Qn,it.layers.enable(Ve),it.viewport=new tn,k[Ve]=it),it.matrix.fromArray(ft.transform.matrix),it.matrix.decompose(it.position,it.quaternion,it.scale),it.projectionMatrix.fromArray(ft.projectionMatrix),it.projectionMatrixInverse.copy(it.projectionMatrix).invert(),it.viewport.set(ct.x,ct.y,ct.width,ct.height),Ve===0&&(G.matrix.copy(it.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ae===!0&&G.cameras.push(it)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){h=i.getBinding();let Ve=h.getDepthInformation(ve[0]);Ve&&Ve.isValid&&Ve.texture&&_.init(Ve,s.renderState)}if(Se&&Se.includes("camera-access")&&y){e.state.unbindTexture(),h=i.getBinding();for(let Ve=0;Ve<ve.length;Ve++){let ft=ve[Ve].camera;if(ft){let ct=m[ft];ct||(ct=new hl,m[ft]=ct);let it=h.getCameraImage(ft);ct.sourceTexture=it}}}}for(let ve=0;ve<R.length;ve++){let Ae=C[ve],Se=R[ve];Ae!==null&&Se!==void 0&&Se.update(Ae,me,c||o)}se&&se(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new yv;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},JA=new en,Rv=new Qe;Rv.set(-1,0,0,0,1,0,0,0,1);function jA(n,e){function t(_,m){_.matrixAutoUpdate===!0&&_.updateMatrix(),m.value.copy(_.matrix)}function i(_,m){m.color.getRGB(_.fogColor.value,sp(n)),m.isFog?(_.fogNear.value=m.near,_.fogFar.value=m.far):m.isFogExp2&&(_.fogDensity.value=m.density)}function s(_,m,b,A,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(_,m):m.isMeshLambertMaterial?(r(_,m),m.envMap&&(_.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(_,m),h(_,m)):m.isMeshPhongMaterial?(r(_,m),u(_,m),m.envMap&&(_.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(_,m),f(_,m),m.isMeshPhysicalMaterial&&d(_,m,S)):m.isMeshMatcapMaterial?(r(_,m),p(_,m)):m.isMeshDepthMaterial?r(_,m):m.isMeshDistanceMaterial?(r(_,m),y(_,m)):m.isMeshNormalMaterial?r(_,m):m.isLineBasicMaterial?(o(_,m),m.isLineDashedMaterial&&a(_,m)):m.isPointsMaterial?l(_,m,b,A):m.isSpriteMaterial?c(_,m):m.isShadowMaterial?(_.color.value.copy(m.color),_.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(_,m){_.opacity.value=m.opacity,m.color&&_.diffuse.value.copy(m.color),m.emissive&&_.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(_.map.value=m.map,t(m.map,_.mapTransform)),m.alphaMap&&(_.alphaMap.value=m.alphaMap,t(m.alphaMap,_.alphaMapTransform)),m.bumpMap&&(_.bumpMap.value=m.bumpMap,t(m.bumpMap,_.bumpMapTransform),_.bumpScale.value=m.bumpScale,m.side===ti&&(_.bumpScale.value*=-1)),m.normalMap&&(_.normalMap.value=m.normalMap,t(m.normalMap,_.normalMapTransform),_.normalScale.value.copy(m.normalScale),m.side===ti&&_.normalScale.value.negate()),m.displacementMap&&(_.displacementMap.value=m.displacementMap,t(m.displacementMap,_.displacementMapTransform),_.displacementScale.value=m.displacementScale,_.displacementBias.value=m.displacementBias),m.emissiveMap&&(_.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,_.emissiveMapTransform)),m.specularMap&&(_.specularMap.value=m.specularMap,t(m.specularMap,_.specularMapTransform)),m.alphaTest>0&&(_.alphaTest.value=m.alphaTest);let b=e.get(m),A=b.envMap,S=b.envMapRotation;A&&(_.envMap.value=A,_.envMapRotation.value.setFromMatrix4(JA.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&_.envMapRotation.value.premultiply(Rv),_.reflectivity.value=m.reflectivity,_.ior.value=m.ior,_.refractionRatio.value=m.refractionRatio),m.lightMap&&(_.lightMap.value=m.lightMap,_.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,_.lightMapTransform)),m.aoMap&&(_.aoMap.value=m.aoMap,_.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,_.aoMapTransform))}function o(_,m){_.diffuse.value.copy(m.color),_.opacity.value=m.opacity,m.map&&(_.map.value=m.map,t(m.map,_.mapTransform))}function a(_,m){_.dashSize.value=m.dashSize,_.totalSize.value=m.dashSize+m.gapSize,_.scale.value=m.scale}function l(_,m,b,A){_.diffuse.value.copy(m.color),_.opacity.value=m.opacity,_.size.value=m.size*b,_.scale.value=A*.5,m.map&&(_.map.value=m.map,t(m.map,_.uvTransform)),m.alphaMap&&(_.alphaMap.value=m.alphaMap,t(m.alphaMap,_.alphaMapTransform)),m.alphaTest>0&&(_.alphaTest.value=m.alphaTest)}function c(_,m){_.diffuse.value.copy(m.color),_.opacity.value=m.opacity,_.rotation.value=m.rotation,m.map&&(_.map.value=m.map,t(m.map,_.mapTransform)),m.alphaMap&&(_.alphaMap.value=m.alphaMap,t(m.alphaMap,_.alphaMapTransform)),m.alphaTest>0&&(_.alphaTest.value=m.alphaTest)}function u(_,m){_.specular.value.copy(m.specular),_.shininess.value=Math.max(m.shininess,1e-4)}function h(_,m){m.gradientMap&&(_.gradientMap.value=m.gradientMap)}function f(_,m){_.metalness.value=m.metalness,m.metalnessMap&&(_.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,_.metalnessMapTransform)),_.roughness.value=m.roughness,m.roughnessMap&&(_.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,_.roughnessMapTransform)),m.envMap&&(_.envMapIntensity.value=m.envMapIntensity)}function d(_,m,b){_.ior.value=m.ior,m.diffuseRoughness>0&&(_.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(_.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,_.diffuseRoughnessMapTransform))),m.sheen>0&&(_.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),_.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(_.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,_.sheenColorMapTransform)),m.sheenRoughnessMap&&(_.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,_.sheenRoughnessMapTransform))),m.clearcoat>0&&(_.clearcoat.value=m.clearcoat,_.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(_.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,_.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(_.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,_.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(_.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,_.clearcoatNormalMapTransform),_.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ti&&_.clearcoatNormalScale.value.negate())),m.dispersion>0&&(_.dispersion.value=m.dispersion),m.retroreflectivity>0&&(_.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(_.iridescence.value=m.iridescence,_.iridescenceIOR.value=m.iridescenceIOR,_.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,_.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(_.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,_.iridescenceMapTransform)),m.iridescenceThicknessMap&&(_.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,_.iridescenceThicknessMapTransform))),m.transmission>0&&(_.transmission.value=m.transmission,_.transmissionSamplerMap.value=b.texture,_.transmissionSamplerSize.value.set(b.width,b.height),m.transmissionMap&&(_.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,_.transmissionMapTransform)),_.thickness.value=m.thickness,m.thicknessMap&&(_.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,_.thicknessMapTransform)),_.attenuationDistance.value=m.attenuationDistance,_.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(_.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(_.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,_.anisotropyMapTransform))),_.specularIntensity.value=m.specularIntensity,_.specularColor.value.copy(m.specularColor),m.specularColorMap&&(_.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,_.specularColorMapTransform)),m.specularIntensityMap&&(_.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,_.specularIntensityMapTransform))}function p(_,m){m.matcap&&(_.matcap.value=m.matcap)}function y(_,m){let b=e.get(m).light;_.referencePosition.value.setFromMatrixPosition(b.matrixWorld),_.nearDistance.value=b.shadow.camera.near,_.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function QA(n,e,t,i){let s={},r={};function o(b,A){let S=A.program;i.uniformBlockBinding(b,S,s[b.id])}function a(b,A){let S=s[b.id];S===void 0&&(p(b),S=l(b),s[b.id]=S,b.addEventListener("dispose",_));let R=A.program;i.updateUBOMapping(b,R);let C=e.render.frame;r[b.id]!==C&&(c(b),r[b.id]=C)}function l(b){let A=n.createBuffer(),S=b.__size,R=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,R),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(b){let A=s[b.id],S=b.uniforms,R=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let C=0,v=S.length;C<v;C++){let T=S[C];if(Array.isArray(T))for(let F=0,D=T.length;F<D;F++)u(T[F],C,F,R);else u(T,C,0,R)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(b,A,S,R){if(f(b,A,S,R)===!0){let C=b.__offset,v=b.value;if(Array.isArray(v)){let T=0;for(let F=0;F<v.length;F++){let D=v[F],L=y(D,!0);h(D,b.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else h(v,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,b.__data)}}function h(b,A,S){typeof b=="number"||typeof b=="boolean"?A[S]=b:b.isMatrix3?(A[S]=b.elements[0],A[S+1]=b.elements[1],A[S+2]=b.elements[2],A[S+3]=0,A[S+4]=b.elements[3],A[S+5]=b.elements[4],A[S+6]=b.elements[5],A[S+7]=0,A[S+8]=b.elements[6],A[S+9]=b.elements[7],A[S+10]=b.elements[8],A[S+11]=0):ArrayBuffer.isView(b)?A.set(b.subarray(0,A.length-S),S):b.toArray(A,S)}function f(b,A,S,R){let C=b.value,v=A+"_"+S;if(Array.isArray(C)){R[v]===void 0&&(R[v]=[]);let T=R[v],F=!1;for(let D=0;D<C.length;D++)d(C[D],T,D)===!0&&(F=!0);return F}return d(C,R,v)}function d(b,A,S){if(A[S]===void 0)return typeof b=="number"||typeof b=="boolean"?A[S]=b:ArrayBuffer.isView(b)?A[S]=b.slice():A[S]=b.clone(),!0;{let R=A[S];if(typeof b=="number"||typeof b=="boolean"){if(R!==b)return A[S]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(R.equals(b)===!1)return R.copy(b),!0}}return!1}function p(b){let A=b.uniforms,S=0,R=16;for(let v=0,T=A.length;v<T;v++){let F=Array.isArray(A[v])?A[v]:[A[v]];for(let D=0,L=F.length;D<L;D++){let k=F[D],G=Array.isArray(k.value)?k.value:[k.value],U=Array.isArray(A[v])||Array.isArray(k.value),H=S;for(let V=0,ae=G.length;V<ae;V++){let X=G[V],Q=y(X,U),se=S%R,fe=se%Q.boundary,he=se+fe;S+=fe,he!==0&&R-he<Q.storage&&(S+=R-he),V===0&&(H=S),S+=Q.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((S-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let C=S%R;return C>0&&(S+=R-C),b.__size=S,b.__cache={},this}function y(b,A){let S={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(S.boundary=4,S.storage=4):b.isVector2?(S.boundary=8,S.storage=8):b.isVector3||b.isColor?(S.boundary=16,S.storage=12):b.isVector4?(S.boundary=16,S.storage=16):b.isMatrix3?(S.boundary=16,S.storage=48):b.isMatrix4?(S.boundary=16,S.storage=64):b.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(S.boundary=16,S.storage=b.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",b),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function _(b){let A=b.target;A.removeEventListener("dispose",_),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let b in s)n.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:m}}var eC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),vs=null;function tC(){return vs===null&&(vs=new Zr(eC,16,16,Mr,Qi),vs.name="DFG_LUT",vs.minFilter=zn,vs.magFilter=zn,vs.wrapS=ps,vs.wrapT=ps,vs.generateMipmaps=!1,vs.needsUpdate=!0),vs}var gh=class{constructor(e={}){let{canvas:t=V0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=Ti}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let y=d,_=new Set([Fu,Uu,Nu]),m=new Set([Ti,Ji,ua,eo,Lu,Du]),b=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,C=null,v=[],T=[],F=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,k=null,G=null,U=null,H=null;this._outputColorSpace=vi;let $=0,V=0,ae=null,X=-1,Q=null,se=new tn,fe=new tn,he=null,ee=new xt(0),me=0,ve=t.width,Ae=t.height,Se=1,We=null,rt=null,Ve=new tn(0,0,ve,Ae),ft=new tn(0,0,ve,Ae),ct=!1,it=new Kr,Zt=new lu,zt=!1,dn=!1,Ut=new en,In=new K,bt=new tn,Mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nn=!1;function pn(){return ae===null?Se:1}let B=i;function Re(E,z){return t.getContext(E,z)}let Ze,ot,Me,Ot,ze,Ye,P,M,q,ue,oe,_e,ye,te,ie,pe,O,re,ne,we,ge,be,He;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let z="webgl2";if(B=Re(z,E),B===null)throw Re(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(E){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),tt("WebGLRenderer: "+E.message),E}function Je(){Ze=new fE(B),Ze.init(),ge=new $A(B,Ze),ot=new tE(B,Ze,e,ge),Me=new XA(B,Ze),ot.reversedDepthBuffer&&f&&Me.buffers.depth.setReversed(!0),G=B.createFramebuffer(),U=B.createFramebuffer(),H=B.createFramebuffer(),Ot=new mE(B),ze=new LA,Ye=new YA(B,Ze,Me,ze,ot,ge,Ot),P=new hE(D),M=new _w(B),be=new QT(B,M),q=new dE(B,M,Ot,be),ue=new _E(B,q,M,be,Ot),re=new gE(B,ot,Ye),ie=new nE(ze),oe=new IA(D,P,Ze,ot,be,ie),_e=new jA(D,ze),ye=new NA,te=new zA(Ze),O=new jT(D,P,Me,ue,p,l),pe=new qA(D,ue,ot),He=new QA(B,Ot,ot,Me),ne=new eE(B,Ze,Ot),we=new pE(B,Ze,Ot),Ot.programs=oe.programs,D.capabilities=ot,D.extensions=Ze,D.properties=ze,D.renderLists=ye,D.shadowMap=pe,D.state=Me,D.info=Ot}y!==Ti&&(F=new yE(y,t.width,t.height,a,s,r));let ce=new _p(D,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let E=Ze.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Ze.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(E){E!==void 0&&(Se=E,this.setSize(ve,Ae,!1))},this.getSize=function(E){return E.set(ve,Ae)},this.setSize=function(E,z,j=!0){if(ce.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=E,Ae=z,t.width=Math.floor(E*Se),t.height=Math.floor(z*Se),j===!0&&(t.style.width=E+"px",t.style.height=z+"px"),F!==null&&F.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(ve*Se,Ae*Se).floor()},this.setDrawingBufferSize=function(E,z,j){ve=E,Ae=z,Se=j,t.width=Math.floor(E*j),t.height=Math.floor(z*j),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(y===Ti){tt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}F.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(se)},this.getViewport=function(E){return E.copy(Ve)},this.setViewport=function(E,z,j,Y){E.isVector4?Ve.set(E.x,E.y,E.z,E.w):Ve.set(E,z,j,Y),Me.viewport(se.copy(Ve).multiplyScalar(pn()).round())},this.getScissor=function(E){return E.copy(ft)},this.setScissor=function(E,z,j,Y){E.isVector4?ft.set(E.x,E.y,E.z,E.w):ft.set(E,z,j,Y),Me.scissor(fe.copy(ft).multiplyScalar(pn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(E){Me.setScissorTest(ct=E)},this.setOpaqueSort=function(E){We=E},this.setTransparentSort=function(E){rt=E},this.getClearColor=function(E){return E.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,j=!0){let Y=0;if(E){let Z=!1;if(ae!==null){let Te=ae.texture.format;Z=_.has(Te)}if(Z){let Te=ae.texture.type,Pe=m.has(Te),Ee=O.getClearColor(),Ie=O.getClearAlpha(),ke=Ee.r,et=Ee.g,dt=Ee.b;Pe?(b[0]=ke,b[1]=et,b[2]=dt,b[3]=Ie,B.clearBufferuiv(B.COLOR,0,b)):(A[0]=ke,A[1]=et,A[2]=dt,A[3]=Ie,B.clearBufferiv(B.COLOR,0,A))}else Y|=B.COLOR_BUFFER_BIT}z&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),k=E},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),ye.dispose(),te.dispose(),Ye.dispose(),ze.dispose(),P.dispose(),ue.dispose(),q.dispose(),be.dispose(),He.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Pl),ce.removeEventListener("sessionend",ns),xs.stop()};function Oe(E){E.preventDefault(),Qd("WebGLRenderer: Context Lost."),L=!0}function je(){Qd("WebGLRenderer: Context Restored."),L=!1;let E=Ot.autoReset,z=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,Z=pe.type;Je(),Ot.autoReset=E,pe.enabled=z,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=Z}function Ce(E){tt("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function lt(E){let z=E.target;z.removeEventListener("dispose",lt),Ht(z)}function Ht(E){Xn(E),ze.remove(E)}function Xn(E){let z=ze.get(E).programs;z!==void 0&&(z.forEach(function(j){oe.releaseProgram(j)}),E.isShaderMaterial&&oe.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,j,Y,Z,Te){z===null&&(z=Mn);let Pe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ee=xa(E,z,j,Y,Z);Me.setMaterial(Y,Pe);let Ie=j.index,ke=1;if(Y.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ke=2}let et=j.drawRange,dt=j.attributes.position,Be=et.start*ke,pt=(et.start+et.count)*ke;Te!==null&&(Be=Math.max(Be,Te.start*ke),pt=Math.min(pt,(Te.start+Te.count)*ke)),Ie!==null?(Be=Math.max(Be,0),pt=Math.min(pt,Ie.count)):dt!=null&&(Be=Math.max(Be,0),pt=Math.min(pt,dt.count));let jt=pt-Be;if(jt<0||jt===1/0)return;be.setup(Z,Y,Ee,j,Ie);let It,Lt=ne;if(Ie!==null&&(It=M.get(Ie),Lt=we,Lt.setIndex(It)),Z.isMesh)Y.wireframe===!0?(Me.setLineWidth(Y.wireframeLinewidth*pn()),Lt.setMode(B.LINES)):Lt.setMode(B.TRIANGLES);else if(Z.isLine){let wn=Y.linewidth;wn===void 0&&(wn=1),Me.setLineWidth(wn*pn()),Z.isLineSegments?Lt.setMode(B.LINES):Z.isLineLoop?Lt.setMode(B.LINE_LOOP):Lt.setMode(B.LINE_STRIP)}else Z.isPoints?Lt.setMode(B.POINTS):Z.isSprite&&Lt.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Lt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let wn=Z._multiDrawStarts,Ue=Z._multiDrawCounts,mn=Z._multiDrawCount,_t=Ie?M.get(Ie).bytesPerElement:1,Ss=ze.get(Y).currentProgram.getUniforms();for(let gn=0;gn<mn;gn++)Ss.setValue(B,"_gl_DrawID",gn),Lt.render(wn[gn]/_t,Ue[gn])}else if(Z.isInstancedMesh)Lt.renderInstances(Be,jt,Z.count);else if(j.isInstancedBufferGeometry){let wn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,wn);Lt.renderInstances(Be,jt,Ue)}else Lt.render(Be,jt)};function _a(E,z,j,Y){k!==null&&E.isNodeMaterial&&k.setObject(Y,E),zt===!0&&ie.setState(E,j,!1),E.transparent===!0&&E.side===Oi&&E.forceSinglePass===!1?(E.side=ti,E.needsUpdate=!0,is(E,z,Y),E.side=Sr,E.needsUpdate=!0,is(E,z,Y),E.side=Oi):is(E,z,Y)}this.compile=function(E,z,j=null){j===null&&(j=E),k!==null&&k.renderStart(E,z,j),C=te.get(j),C.init(z),T.push(C),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(C.pushLight(Z),Z.castShadow&&C.pushShadow(Z))}),E!==j&&E.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(C.pushLight(Z),Z.castShadow&&C.pushShadow(Z))}),C.setupLights(),k!==null&&k.updateLights(C.state.lightsArray),dn=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,dn),zt===!0&&ie.setGlobalState(this.clippingPlanes,z),k!==null&&pe.render(C.state.shadowsArray,j,z);let Y=new Set;return E.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ee=Te[Pe];_a(Ee,j,z,Z),Y.add(Ee)}else _a(Te,j,z,Z),Y.add(Te)}),C=T.pop(),k!==null&&k.renderEnd(),Y},this.compileAsync=function(E,z,j=null){let Y=this.compile(E,z,j);return new Promise(Z=>{function Te(){if(Y.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&Y.delete(Pe)}),Y.size===0){Z(E);return}setTimeout(Te,10)}Ze.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let io=null;function Fh(E){io&&io(E)}function Pl(){xs.stop()}function ns(){xs.start()}let xs=new yv;xs.setAnimationLoop(Fh),typeof self<"u"&&xs.setContext(self),this.setAnimationLoop=function(E){io=E,ce.setAnimationLoop(E),E===null?xs.stop():xs.start()},ce.addEventListener("sessionstart",Pl),ce.addEventListener("sessionend",ns),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){tt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;k!==null&&k.renderStart(E,z);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=F!==null&&(ae===null||j)&&F.begin(D,ae);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(F===null||F.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),E.isScene===!0&&E.onBeforeRender(D,E,z,ae),C=te.get(E,T.length),C.init(z),C.state.textureUnits=Ye.getTextureUnits(),T.push(C),Ut.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Zt.setFromArrayCamera(z):it.setFromProjectionMatrix(Ut,Ui,z.reversedDepth),dn=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,dn),R=ye.get(E,v.length),R.init(),v.push(R),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=D.xr.getDepthSensingMesh();Pe!==null&&bs(Pe,z,-1/0,D.sortObjects)}bs(E,z,0,D.sortObjects),R.finish(),k!==null&&k.updateLights(C.state.lightsArray),D.sortObjects===!0&&R.sort(We,rt),nn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,nn&&O.addToRenderList(R,E),this.info.autoReset===!0&&this.info.reset(),zt===!0&&ie.beginShadows();let Z=C.state.shadowsArray;if(pe.render(Z,E,z),zt===!0&&ie.endShadows(),(Y&&F.hasRenderPass())===!1){let Pe=R.opaque,Ee=R.transmissive;if(C.setupLights(),z.isArrayCamera){let Ie=z.cameras;if(Ee.length>0)for(let ke=0,et=Ie.length;ke<et;ke++){let dt=Ie[ke];Bi(Pe,Ee,E,dt)}nn&&O.render(E);for(let ke=0,et=Ie.length;ke<et;ke++){let dt=Ie[ke];va(R,E,dt,dt.viewport)}}else Ee.length>0&&Bi(Pe,Ee,E,z),nn&&O.render(E),va(R,E,z)}ae!==null&&V===0&&(Ye.updateMultisampleRenderTarget(ae),Ye.updateRenderTargetMipmap(ae)),Y&&F.end(D),E.isScene===!0&&E.onAfterRender(D,E,z),be.resetDefaultState(),X=-1,Q=null,T.pop(),T.length>0?(C=T[T.length-1],Ye.setTextureUnits(C.state.textureUnits),zt===!0&&ie.setGlobalState(D.clippingPlanes,C.state.camera)):C=null,v.pop(),v.length>0?R=v[v.length-1]:R=null,k!==null&&k.renderEnd()};function bs(E,z,j,Y){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)C.pushLight(E),E.castShadow&&C.pushShadow(E);else if(E.isSprite){let Pe=z.isArrayCamera?Zt:it;if(!E.frustumCulled||E.intersectsFrustum(Pe)){Y&&bt.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Ut);let Ee=ue.update(E),Ie=E.material;Ie.visible&&R.push(E,Ee,Ie,j,bt.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Pe=z.isArrayCamera?Zt:it;if(!E.frustumCulled||E.intersectsFrustum(Pe)){let Ee=ue.update(E),Ie=E.material;if(Y&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),bt.copy(E.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),bt.copy(Ee.boundingSphere.center)),bt.applyMatrix4(E.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ie)){let ke=Ee.groups;for(let et=0,dt=ke.length;et<dt;et++){let Be=ke[et],pt=Ie[Be.materialIndex];pt&&pt.visible&&R.push(E,Ee,pt,j,bt.z,Be,z)}}else Ie.visible&&R.push(E,Ee,Ie,j,bt.z,null,z)}}}let Te=E.children;for(let Pe=0,Ee=Te.length;Pe<Ee;Pe++)bs(Te[Pe],z,j,Y)}function va(E,z,j,Y){let{opaque:Z,transmissive:Te,transparent:Pe}=E;C.setupLightsView(j),zt===!0&&ie.setGlobalState(D.clippingPlanes,j),Y&&Me.viewport(se.copy(Y)),Z.length>0&&sn(Z,z,j),Te.length>0&&sn(Te,z,j),Pe.length>0&&sn(Pe,z,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Bi(E,z,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[Y.id]===void 0){let Be=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[Y.id]=new bi(1,1,{generateMipmaps:!0,type:Be?Qi:Ti,minFilter:zs,samples:Math.max(4,ot.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:yt.workingColorSpace})}let Te=C.state.transmissionRenderTarget[Y.id],Pe=Y.viewport||se;Te.setSize(Pe.z*D.transmissionResolutionScale,Pe.w*D.transmissionResolutionScale);let Ee=D.getRenderTarget(),Ie=D.getActiveCubeFace(),ke=D.getActiveMipmapLevel();D.setRenderTarget(Te),D.getClearColor(ee),me=D.getClearAlpha(),me<1&&D.setClearColor(16777215,.5),D.clear(),nn&&O.render(j);let et=D.toneMapping;D.toneMapping=_s;let dt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),C.setupLightsView(Y),zt===!0&&ie.setGlobalState(D.clippingPlanes,Y),sn(E,j,Y),Ye.updateMultisampleRenderTarget(Te),Ye.updateRenderTargetMipmap(Te),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let pt=0,jt=z.length;pt<jt;pt++){let It=z[pt],{object:Lt,geometry:wn,material:Ue,group:mn}=It;if(Ue.side===Oi&&Lt.layers.test(Y.layers)){let _t=Ue.side;Ue.side=ti,Ue.needsUpdate=!0,cn(Lt,j,Y,wn,Ue,mn),Ue.side=_t,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(Ye.updateMultisampleRenderTarget(Te),Ye.updateRenderTargetMipmap(Te))}D.setRenderTarget(Ee,Ie,ke),D.setClearColor(ee,me),dt!==void 0&&(Y.viewport=dt),D.toneMapping=et}function sn(E,z,j){let Y=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Te=E.length;Z<Te;Z++){let Pe=E[Z],{object:Ee,geometry:Ie,group:ke}=Pe,et=Pe.material;et.allowOverride===!0&&Y!==null&&(et=Y),Ee.layers.test(j.layers)&&cn(Ee,z,j,Ie,et,ke)}}function cn(E,z,j,Y,Z,Te){k!==null&&Z.isNodeMaterial&&k.setObject(E,Z),E.onBeforeRender(D,z,j,Y,Z,Te),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),Z.onBeforeRender(D,z,j,Y,E,Te),Z.transparent===!0&&Z.side===Oi&&Z.forceSinglePass===!1?(Z.side=ti,Z.needsUpdate=!0,D.renderBufferDirect(j,z,Y,Z,E,Te),Z.side=Sr,Z.needsUpdate=!0,D.renderBufferDirect(j,z,Y,Z,E,Te),Z.side=Oi):D.renderBufferDirect(j,z,Y,Z,E,Te),E.onAfterRender(D,z,j,Y,Z,Te)}function un(E){let z=0;for(let j of E)j.texture!==null&&z++;return z}function is(E,z,j){z.isScene!==!0&&(z=Mn);let Y=ze.get(E),Z=C.state.lights,Te=C.state.shadowsArray,Pe=Z.state.version,Ee=oe.getParameters(E,Z.state,Te,z,j,C.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ee),ke=Y.programs;Y.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,Y.fog=z.fog;let et=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;Y.envMap=P.get(E.envMap||Y.environment,et),Y.envMapRotation=Y.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,ke===void 0&&(E.addEventListener("dispose",lt),ke=new Map,Y.programs=ke,Y.programVariants=new Map);let dt=ke.get(Ie);if(dt!==void 0){if(Y.currentProgram===dt&&Y.lightsStateVersion===Pe)return ya(E,Ee),dt}else Ee.uniforms=oe.getUniforms(E),k!==null&&E.isNodeMaterial&&k.build(E,j,Ee),E.onBeforeCompile(Ee,D),dt=oe.acquireProgram(Ee,Ie),ke.set(Ie,dt),Y.uniforms=Ee.uniforms;let Be=Y.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Be.clippingPlanes=ie.uniform),ya(E,Ee),Y.needsLights=qs(E),Y.lightsStateVersion=Pe,Y.needsLights&&(Be.ambientLightColor.value=Z.state.ambient,Be.lightProbe.value=Z.state.probe,Be.sunLights.value=Z.state.sun,Be.sunLightShadows.value=Z.state.sunShadow,Be.directionalLights.value=Z.state.directional,Be.directionalLightShadows.value=Z.state.directionalShadow,Be.spotLights.value=Z.state.spot,Be.spotLightShadows.value=Z.state.spotShadow,Be.rectAreaLights.value=Z.state.rectArea,Be.ltc_1.value=Z.state.rectAreaLTC1,Be.ltc_2.value=Z.state.rectAreaLTC2,Be.pointLights.value=Z.state.point,Be.pointLightShadows.value=Z.state.pointShadow,Be.hemisphereLights.value=Z.state.hemi,Be.sunShadowMatrix.value=Z.state.sunShadowMatrix,Be.sunShadowCascade.value=Z.state.sunShadowCascade,Be.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Be.spotLightMatrix.value=Z.state.spotLightMatrix,Be.spotLightMap.value=Z.state.spotLightMap,Be.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=un(C.state.lightProbeGridArray),Y.currentProgram=dt,Y.uniformsList=null,dt}function ci(E,z,j,Y,Z){let Te=ze.get(E),Pe=Te.currentProgram.id+","+Y+","+Z,Ee=Te.programVariants.get(Pe);return Ee===void 0?(Ee=is(E,z,j),Te.programVariants.set(Pe,Ee)):(Te.currentProgram=Ee,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=Z),Ee}function Ws(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=fa.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function ya(E,z){let j=ze.get(E);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function xa(E,z,j,Y,Z){z.isScene!==!0&&(z=Mn),Ye.resetTextureUnits();let Te=z.fog,Pe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?z.environment:null,Ee=ae===null?D.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:yt.workingColorSpace,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ke=P.get(Y.envMap||Pe,Ie),et=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,dt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Be=!!j.morphAttributes.position,pt=!!j.morphAttributes.normal,jt=!!j.morphAttributes.color,It=_s;Y.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(It=D.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,wn=Lt!==void 0?Lt.length:0,Ue=ze.get(Y),mn=C.state.lights;if(zt===!0&&(dn===!0||E!==Q)){let Dt=E===Q&&Y.id===X;ie.setState(Y,E,Dt)}let _t=!1,Ss=!1;Y.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==mn.state.version||Z.isBatchedMesh&&Ue.batching===!1||!Z.isBatchedMesh&&Ue.batching===!0||Z.isBatchedMesh&&Ue.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ue.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ue.instancing===!1||!Z.isInstancedMesh&&Ue.instancing===!0||Z.isSkinnedMesh&&Ue.skinning===!1||!Z.isSkinnedMesh&&Ue.skinning===!0||Z.isInstancedMesh&&Ue.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ue.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ue.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ue.instancingMorph===!1&&Z.morphTexture!==null||Ue.envMap!==ke||Y.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ie.numPlanes||Ue.numIntersection!==ie.numIntersection)||Ue.vertexAlphas!==et||Ue.vertexTangents!==dt||Ue.morphTargets!==Be||Ue.morphNormals!==pt||Ue.morphColors!==jt||Ue.morphTargetsCount!==wn||Ue.numLightProbeGrids!==un(C.state.lightProbeGridArray)?_t=!0:(Ue.outputColorSpace!==Ee||Ue.toneMapping!==It)&&(Ss=!0):(_t=!0,Ue.__version=Y.version);let gn=Ue.currentProgram;(_t===!0||Ss===!0)&&(gn=Ss===!0?ci(Y,z,Z,Ee,It):is(Y,z,Z),k&&Y.isNodeMaterial&&k.onUpdateProgram(Y,gn,Ue));let oo=!1,ss=!1,Ms=!1,ut=gn.getUniforms(),rn=Ue.uniforms;if(Me.useProgram(gn.program)&&(oo=!0,ss=!0,Ms=!0),Y.id!==X&&(X=Y.id,ss=!0),oo||Q!==E){Me.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),ut.setValue(B,"projectionMatrix",E.projectionMatrix),ut.setValue(B,"viewMatrix",E.matrixWorldInverse);let _n=ut.map.cameraPosition;_n!==void 0&&_n.setValue(B,In.setFromMatrixPosition(E.matrixWorld)),ot.logarithmicDepthBuffer&&ut.setValue(B,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ut.setValue(B,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,ss=!0,Ms=!0)}if(Ue.needsLights&&(mn.state.sunShadowMap.length>0&&ut.setValue(B,"sunShadowMap",mn.state.sunShadowMap,Ye),mn.state.directionalShadowMap.length>0&&ut.setValue(B,"directionalShadowMap",mn.state.directionalShadowMap,Ye),mn.state.spotShadowMap.length>0&&ut.setValue(B,"spotShadowMap",mn.state.spotShadowMap,Ye),mn.state.pointShadowMap.length>0&&ut.setValue(B,"pointShadowMap",mn.state.pointShadowMap,Ye)),Z.isSkinnedMesh){ut.setOptional(B,Z,"bindMatrix"),ut.setOptional(B,Z,"bindMatrixInverse");let Dt=Z.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ut.setValue(B,"boneTexture",Dt.boneTexture,Ye))}Z.isBatchedMesh&&(ut.setOptional(B,Z,"batchingTexture"),ut.setValue(B,"batchingTexture",Z._matricesTexture,Ye),ut.setOptional(B,Z,"batchingIdTexture"),ut.setValue(B,"batchingIdTexture",Z._indirectTexture,Ye),ut.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ut.setValue(B,"batchingColorTexture",Z._colorsTexture,Ye));let Yn=j.morphAttributes;if((Yn.position!==void 0||Yn.normal!==void 0||Yn.color!==void 0)&&re.update(Z,j,gn),(ss||Ue.receiveShadow!==Z.receiveShadow)&&(Ue.receiveShadow=Z.receiveShadow,ut.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&z.environment!==null&&(rn.envMapIntensity.value=z.environmentIntensity),rn.dfgLUT!==void 0&&(rn.dfgLUT.value=tC()),ss){if(ut.setValue(B,"toneMappingExposure",D.toneMappingExposure),Ue.needsLights&&so(rn,Ms),Te&&Y.fog===!0&&_e.refreshFogUniforms(rn,Te),_e.refreshMaterialUniforms(rn,Y,Se,Ae,C.state.transmissionRenderTarget[E.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Dt=S,_n=0;for(let Gn of C.state.lightProbeGridArray)Gn.texture!==null&&(Dt.textures[_n]=Gn.texture,Dt.min[_n]=Gn.boundingBox.min,Dt.max[_n]=Gn.boundingBox.max,Dt.resolution[_n]=Gn.resolution,_n++);for(let Gn in Dt)Dt[Gn].length=_n;rn.probesSH.value=Dt.textures,rn.probesMin.value=Dt.min,rn.probesMax.value=Dt.max,rn.probesResolution.value=Dt.resolution}fa.upload(B,Ws(Ue),rn,Ye)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(fa.upload(B,Ws(Ue),rn,Ye),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ut.setValue(B,"center",Z.center),ut.setValue(B,"modelViewMatrix",Z.modelViewMatrix),ut.setValue(B,"normalMatrix",Z.normalMatrix),ut.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Dt=Y.uniformsGroups;for(let _n=0,Gn=Dt.length;_n<Gn;_n++){let Il=Dt[_n];He.update(Il,gn),He.bind(Il,gn)}}return gn}function so(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function qs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(E,z,j){let Y=ze.get(E);Y.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),ze.get(E.texture).__webglTexture=z,ze.get(E.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let j=ze.get(E);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,j=0){ae=E,$=z,V=j;let Y=null,Z=!1,Te=!1;if(E){let Ee=ze.get(E);if(Ee.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(B.FRAMEBUFFER,Ee.__webglFramebuffer),se.copy(E.viewport),fe.copy(E.scissor),he=E.scissorTest,Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),X=-1;return}else if(Ee.__webglFramebuffer===void 0)Ye.setupRenderTarget(E);else if(Ee.__hasExternalTextures)Ye.rebindTextures(E,ze.get(E.texture).__webglTexture,ze.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let et=E.depthTexture;if(Ee.__boundDepthTexture!==et){if(et!==null&&ze.has(et)&&(E.width!==et.image.width||E.height!==et.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(E)}}let Ie=E.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ke=ze.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(ke[z])?Y=ke[z][j]:Y=ke[z],Z=!0):E.samples>0&&Ye.useMultisampledRTT(E)===!1?Y=ze.get(E).__webglMultisampledFramebuffer:Array.isArray(ke)?Y=ke[j]:Y=ke,se.copy(E.viewport),fe.copy(E.scissor),he=E.scissorTest}else se.copy(Ve).multiplyScalar(Se).floor(),fe.copy(ft).multiplyScalar(Se).floor(),he=ct;if(j!==0&&(Y=G),Me.bindFramebuffer(B.FRAMEBUFFER,Y)&&Me.drawBuffers(E,Y),Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),Z){let Ee=ze.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ee.__webglTexture,j)}else if(Te){let Ee=z;for(let Ie=0;Ie<E.textures.length;Ie++){let ke=ze.get(E.textures[Ie]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ie,ke.__webglTexture,j,Ee)}}else if(E!==null&&j!==0){let Ee=ze.get(E.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ee.__webglTexture,j)}X=-1};function ro(E){let z=ze.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=ot.textureFormatReadable(E.format),z.__typeReadable=ot.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,j,Y,Z,Te,Pe,Ee=0){if(!(E&&E.isWebGLRenderTarget)){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Me.bindFramebuffer(B.FRAMEBUFFER,Ie);try{let ke=E.textures[Ee],et=ke.format,dt=ke.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ee);let Be=ro(ke);if(Be.__formatReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){tt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-Y&&j>=0&&j<=E.height-Z&&B.readPixels(z,j,Y,Z,ge.convert(et),ge.convert(dt),Te)}finally{let ke=ae!==null?ze.get(ae).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(E,z,j,Y,Z,Te,Pe,Ee=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(z>=0&&z<=E.width-Y&&j>=0&&j<=E.height-Z){Me.bindFramebuffer(B.FRAMEBUFFER,Ie);let ke=E.textures[Ee],et=ke.format,dt=ke.type;E.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ee);let Be=ro(ke);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,pt),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(z,j,Y,Z,ge.convert(et),ge.convert(dt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let jt=ae!==null?ze.get(ae).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,jt);let It=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await W0(B,It,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,pt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(pt),B.deleteSync(It),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,j=0){let Y=Math.pow(2,-j),Z=Math.floor(E.image.width*Y),Te=Math.floor(E.image.height*Y),Pe=z!==null?z.x:0,Ee=z!==null?z.y:0;Ye.setTexture2D(E,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Pe,Ee,Z,Te),Me.unbindTexture()},this.copyTextureToTexture=function(E,z,j=null,Y=null,Z=0,Te=0){let Pe,Ee,Ie,ke,et,dt,Be,pt,jt,It=E.isCompressedTexture?E.mipmaps[Te]:E.image;if(j!==null)Pe=j.max.x-j.min.x,Ee=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ke=j.min.x,et=j.min.y,dt=j.isBox3?j.min.z:0;else{let ut=Math.pow(2,-Z);Pe=Math.floor(It.width*ut),Ee=Math.floor(It.height*ut),E.isDataArrayTexture?Ie=It.depth:E.isData3DTexture?Ie=Math.floor(It.depth*ut):Ie=1,ke=0,et=0,dt=0}Y!==null?(Be=Y.x,pt=Y.y,jt=Y.z):(Be=0,pt=0,jt=0);let Lt=ge.convert(z.format),wn=ge.convert(z.type),Ue;z.isData3DTexture?(Ye.setTexture3D(z,0),Ue=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ye.setTexture2DArray(z,0),Ue=B.TEXTURE_2D_ARRAY):(Ye.setTexture2D(z,0),Ue=B.TEXTURE_2D),Me.activeTexture(B.TEXTURE0),Me.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),Me.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Me.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let mn=Me.getParameter(B.UNPACK_ROW_LENGTH),_t=Me.getParameter(B.UNPACK_IMAGE_HEIGHT),Ss=Me.getParameter(B.UNPACK_SKIP_PIXELS),gn=Me.getParameter(B.UNPACK_SKIP_ROWS),oo=Me.getParameter(B.UNPACK_SKIP_IMAGES);Me.pixelStorei(B.UNPACK_ROW_LENGTH,It.width),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,It.height),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,ke),Me.pixelStorei(B.UNPACK_SKIP_ROWS,et),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,dt);let ss=E.isDataArrayTexture||E.isData3DTexture,Ms=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let ut=ze.get(E),rn=ze.get(z),Yn=ze.get(ut.__renderTarget),Dt=ze.get(rn.__renderTarget);Me.bindFramebuffer(B.READ_FRAMEBUFFER,Yn.__webglFramebuffer),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let _n=0;_n<Ie;_n++)ss&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ze.get(E).__webglTexture,Z,dt+_n),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ze.get(z).__webglTexture,Te,jt+_n)),B.blitFramebuffer(ke,et,ke+Pe,et+Ee,Be,pt,Be+Pe,pt+Ee,B.DEPTH_BUFFER_BIT,B.NEAREST);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||E.isRenderTargetTexture||ze.has(E)){let ut=ze.get(E),rn=ze.get(z);Me.bindFramebuffer(B.READ_FRAMEBUFFER,U),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,H);for(let Yn=0;Yn<Ie;Yn++)ss?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ut.__webglTexture,Z,dt+Yn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ut.__webglTexture,Z),Ms?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,rn.__webglTexture,Te,jt+Yn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,rn.__webglTexture,Te),Z!==0?B.blitFramebuffer(ke,et,ke+Pe,et+Ee,Be,pt,Be+Pe,pt+Ee,B.COLOR_BUFFER_BIT,B.NEAREST):Ms?B.copyTexSubImage3D(Ue,Te,Be,pt,jt+Yn,ke,et,Pe,Ee):B.copyTexSubImage2D(Ue,Te,Be,pt,ke,et,Pe,Ee);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Ms?E.isDataTexture||E.isData3DTexture?B.texSubImage3D(Ue,Te,Be,pt,jt,Pe,Ee,Ie,Lt,wn,It.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Ue,Te,Be,pt,jt,Pe,Ee,Ie,Lt,It.data):B.texSubImage3D(Ue,Te,Be,pt,jt,Pe,Ee,Ie,Lt,wn,It):E.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,Be,pt,Pe,Ee,Lt,wn,It.data):E.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,Be,pt,It.width,It.height,Lt,It.data):B.texSubImage2D(B.TEXTURE_2D,Te,Be,pt,Pe,Ee,Lt,wn,It);Me.pixelStorei(B.UNPACK_ROW_LENGTH,mn),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,_t),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,Ss),Me.pixelStorei(B.UNPACK_SKIP_ROWS,gn),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,oo),Te===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Ue),Me.unbindTexture()},this.initRenderTarget=function(E){ze.get(E).__webglFramebuffer===void 0&&Ye.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ye.setTextureCube(E,0):E.isData3DTexture?Ye.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ye.setTexture2DArray(E,0):Ye.setTexture2D(E,0),Me.unbindTexture()},this.resetState=function(){$=0,V=0,ae=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ui}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var Pv={type:"change"},yp={type:"start"},Lv={type:"end"},yh=new $r,Iv=new yi,iC=Math.cos(70*ip.DEG2RAD),Pn=new K,ai=2*Math.PI,Ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},vp=1e-6,xh=class extends ml{constructor(e,t=null){super(e,t),this.state=Ct.NONE,this.target=new K,this.cursor=new K,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:xr.ROTATE,MIDDLE:xr.DOLLY,RIGHT:xr.PAN},this.touches={ONE:br.ROTATE,TWO:br.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new K,this._lastQuaternion=new xi,this._lastTargetPosition=new K,this._quat=new xi().setFromUnitVectors(e.up,new K(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new oa,this._sphericalDelta=new oa,this._scale=1,this._panOffset=new K,this._rotateStart=new nt,this._rotateEnd=new nt,this._rotateDelta=new nt,this._panStart=new nt,this._panEnd=new nt,this._panDelta=new nt,this._dollyStart=new nt,this._dollyEnd=new nt,this._dollyDelta=new nt,this._dollyDirection=new K,this._mouse=new nt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=rC.bind(this),this._onPointerDown=sC.bind(this),this._onPointerUp=oC.bind(this),this._onContextMenu=dC.bind(this),this._onMouseWheel=cC.bind(this),this._onKeyDown=uC.bind(this),this._onTouchStart=hC.bind(this),this._onTouchMove=fC.bind(this),this._onMouseDown=aC.bind(this),this._onMouseMove=lC.bind(this),this._interceptControlDown=pC.bind(this),this._interceptControlUp=mC.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Pv),this.update(),this.state=Ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Pn.copy(t).sub(this.target),Pn.applyQuaternion(this._quat),this._spherical.setFromVector3(Pn),this.autoRotate&&this.state===Ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=ai:i>Math.PI&&(i-=ai),s<-Math.PI?s+=ai:s>Math.PI&&(s-=ai),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Pn.setFromSpherical(this._spherical),Pn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Pn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Pn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new K(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new K(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Pn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(yh.origin.copy(this.object.position),yh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(yh.direction))<iC?this.object.lookAt(this.target):(Iv.setFromNormalAndCoplanarPoint(this.object.up,this.target),yh.intersectPlane(Iv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>vp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>vp||this._lastTargetPosition.distanceToSquared(this.target)>vp?(this.dispatchEvent(Pv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?ai/60*this.autoRotateSpeed*e:ai/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Pn.setFromMatrixColumn(t,0),Pn.multiplyScalar(-e),this._panOffset.add(Pn)}_panUp(e,t){this.screenSpacePanning===!0?Pn.setFromMatrixColumn(t,1):(Pn.setFromMatrixColumn(t,0),Pn.crossVectors(this.object.up,Pn)),Pn.multiplyScalar(e),this._panOffset.add(Pn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Pn.copy(s).sub(this.target);let r=Pn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-ai*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(ai*this._rotateDelta.x/t.clientHeight),this._rotateUp(ai*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new nt,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function sC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function rC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function oC(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Lv),this.state=Ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function aC(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case xr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ct.DOLLY;break;case xr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}break;case xr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(yp)}function lC(n){switch(this.state){case Ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function cC(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ct.NONE||(n.preventDefault(),this.dispatchEvent(yp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Lv))}function uC(n){this.enabled!==!1&&this._handleKeyDown(n)}function hC(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case br.ROTATE:if(this.enableRotate===!1){this.state=Ct.NONE;break}this._handleTouchStartRotate(n),this.state=Ct.TOUCH_ROTATE;break;case br.PAN:if(this.enablePan===!1){this.state=Ct.NONE;break}this._handleTouchStartPan(n),this.state=Ct.TOUCH_PAN;break;default:this.state=Ct.NONE}break;case 2:switch(this.touches.TWO){case br.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ct.TOUCH_DOLLY_PAN;break;case br.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ct.TOUCH_DOLLY_ROTATE;break;default:this.state=Ct.NONE}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(yp)}function fC(n){switch(this._trackPointer(n),this.state){case Ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ct.NONE}}function dC(n){this.enabled!==!1&&n.preventDefault()}function pC(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function mC(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Dv=[[1,0],[0,1]],gC=`
attribute vec3 real;
attribute vec3 imag;
attribute vec3 origin;
attribute vec2 turn;
uniform vec2 phase;
uniform float swing;
uniform mat3 turned;
uniform vec3 middle;
varying vec3 seen;
varying float amount;
void main() {
  vec3 first = real * turn.x - imag * turn.y;
  vec3 second = real * turn.y + imag * turn.x;
  amount = sqrt(dot(real, real) + dot(imag, imag));
  vec3 moved = turned * (position - middle + swing * (first * phase.x - second * phase.y)) + middle + origin;
  vec4 place = modelViewMatrix * vec4(moved, 1.0);
  seen = place.xyz;
  gl_Position = projectionMatrix * place;
}`,_C=`
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`,vC=`
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`,yC={oblique:[.45,-.8,.45],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},bh=class{constructor(e,t,i){this.data=e;this.canvas=t;this.renderer=new gh({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),this.vectors=e.header.extra.lattice_vectors,this.period=Math.hypot(...this.vectors[0]);let s=Float32Array.from(e.values("skin_position"),u=>u/this.period),r={position:new ei(s,3),real:new ei(new Float32Array(s.length),3),imag:new ei(new Float32Array(s.length),3)};for(let u of[this.surface,this.edges])for(let[h,f]of Object.entries(r))u.setAttribute(h,f);this.surface.setIndex(bC(e.values("skin_face"))),this.edges.setIndex(Array.from(e.values("skin_edge"))),this.box.setFromBufferAttribute(r.position),this.box.getCenter(this.uniforms.middle.value);let o=new Zr(Uint8Array.from(i.flatMap(([u=0,h=0,f=0])=>[u,h,f,255])),i.length,1);o.minFilter=o.magFilter=zn,o.needsUpdate=!0,this.uniforms.scale.value=o;let a={uniforms:this.uniforms,vertexShader:gC},l=new Fi(this.surface,new Mi({...a,fragmentShader:_C,side:Oi,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),c=new ll(this.edges,new Mi({...a,fragmentShader:vC}));for(let u of[l,c])u.frustumCulled=!1,this.scene.add(u);this.camera.up.set(0,0,1),this.controls=new xh(this.camera,t),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.colourLines()}data;canvas;renderer;scene=new rl;camera=new Qn(28,1,.01,100);controls;uniforms={phase:{value:new nt(1,0)},swing:{value:.15},turned:{value:new Qe},middle:{value:new K},scale:{value:new Zr(new Uint8Array(4),1,1)},ink:{value:new xt(0,0,0)}};surface=new sa;edges=new sa;period;vectors;box=new ms;copies=[1,1];kappa=[0,0];frames=0;turns=[];show({of:e,row:t,band:i,kappa:s,turn:r,isReversed:o}){let[,a=0,l=0]=this.data.shape(`${e}_mode_real`),c=(t*a+i)*l,u=this.data.values("path_shape");for(let y of["real","imag"]){let _=`${e}_mode_${y}`,m=this.data.values(_).subarray(c,c+l),A=(o&&y==="imag"?-1:1)*this.data.scale(_)*this.data.scale("path_shape"),S=this.surface.getAttribute(y);xC(S.array,u,m,A),S.needsUpdate=!0}let[[h,f],[d,p]]=r;this.uniforms.turned.value.set(h,f,0,d,p,0,0,0,1),this.kappa=s,this.place()}repeat(e){this.copies=e,this.place(),this.look("oblique")}set swing(e){this.uniforms.swing.value=e}turn(e){this.uniforms.phase.value.set(Math.cos(2*Math.PI*e),Math.sin(2*Math.PI*e)),this.draw()}draw(){this.frames++,this.renderer.render(this.scene,this.camera)}look(e){let[t,i]=this.copies,s=this.box.clone();for(let[c,u]of[[t-1,0],[0,i-1],[t-1,i-1]])s.union(this.box.clone().translate(this.shift(c,u)));let r=s.getBoundingSphere(new Bs),o=this.camera.fov*Math.PI/360,a=Math.atan(Math.tan(o)*Math.min(1,this.camera.aspect)),l=1.08*r.radius/Math.sin(a);this.controls.target.copy(r.center),this.camera.position.set(...yC[e]).normalize().multiplyScalar(l).add(r.center),this.camera.near=.01*l,this.camera.far=10*l,this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}resize(e,t){this.renderer.setPixelRatio(devicePixelRatio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix()}colourLines(){this.uniforms.ink.value.set(at("ink"))}dispose(){this.controls.dispose(),this.surface.dispose(),this.edges.dispose(),this.uniforms.scale.value.dispose(),this.renderer.dispose()}shift(e,t){let[[i,s],[r,o]]=this.vectors;return new K((e*i+t*r)/this.period,(e*s+t*o)/this.period,0)}place(){let[e,t]=this.copies,i=[],s=[];for(let r=0;r<e;r++)for(let o=0;o<t;o++){let a=r*this.kappa[0]+o*this.kappa[1];i.push(...this.shift(r,o).toArray()),s.push(Math.cos(a),Math.sin(a))}this.turns=s;for(let r of[this.surface,this.edges])r.instanceCount=e*t,r.setAttribute("origin",new na(Float32Array.from(i),3)),r.setAttribute("turn",new na(Float32Array.from(s),2))}};function xC(n,e,t,i){n.fill(0);for(let s=0;s<t.length;s++){let r=(t[s]??0)*i;if(r===0)continue;let o=s*n.length;for(let a=0;a<n.length;a++)n[a]+=r*e[o+a]}}function bC(n){let e=[];for(let t=0;t<n.length;t+=4){let[i,s,r,o]=n.subarray(t,t+4);e.push(i,s,r,i,r,o)}return e}var SC=[["oblique","oblique"],["x","along x"],["y","along y"],["z","from above"]];function Sh({data:n,choice:e,motion:t,name:i}){let s=Nt(null),r=Nt(null),[o,a]=js("");return fn(()=>{if(s.current===null)return;let l;try{l=new bh(n,s.current,Nv(n))}catch{a("The mode cannot be drawn, because this browser has no WebGL.");return}return r.current=l,Object.assign(s.current,{moving:l}),wC(l,t,e)},[n,e,t]),g("div",{class:"mode",children:[o?g("p",{role:"alert",children:o}):g("canvas",{ref:s,role:"img","aria-label":"The cell moving in the selected mode"}),g("p",{class:"scale",children:[g("span",{children:"0"}),g("span",{class:"bar",style:{background:MC(n)}}),g("span",{children:"1"})," displacement, relative to the largest"]}),g("p",{class:"sides",children:[g("span",{id:`seen-${i}`,children:"Seen"}),SC.map(([l,c])=>g("button",{type:"button",onClick:()=>r.current?.look(l),"aria-describedby":`seen-${i}`,children:c}))]}),g(Fo,{canvas:s,name:i,caption:`${n.header.title}, ${Hi(n)}`})]})}function Nv(n){return n.header.extra.colours}function MC(n){return`linear-gradient(to right, ${Nv(n).map(e=>`rgb(${e.join(" ")})`).join(", ")})`}function wC(n,e,t){let{canvas:i}=n,s=()=>n.turn(r.moment),r=new ar(t,s,i);Uo(i,l=>r.at(l));let o=new ResizeObserver(()=>{n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1)),n.look("oblique")});n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1));let a=[Et(()=>n.repeat(t.copies.value)),Et(()=>{n.show(e.value),i.dataset.shown=`${e.value.row},${e.value.band}`,s()}),Et(()=>{n.swing=t.swing.value,s()}),si(()=>{n.colourLines(),n.draw()})];return o.observe(i),()=>{r.end(),o.disconnect();for(let l of a)l();n.dispose()}}function Uv({diagram:n,unit:e}){let{factor:t}=e;return n.gaps.length===0?g("p",{children:"The computed bands have no gap."}):g("div",{class:"wide",children:g("table",{children:[g("caption",{children:"Gaps"}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"bands"}),g("th",{scope:"col",children:"where"}),g("th",{scope:"col",children:Gt("lower",e)}),g("th",{scope:"col",children:Gt("upper",e)})]})}),g("tbody",{children:n.gaps.map(i=>g("tr",{children:[g("td",{children:[i.waves==="all"?"":`${i.waves} `,i.below,"-",i.below+1]}),g("td",{children:i.complete?"everywhere (complete)":i.waves==="all"?`${i.direction} only`:"everywhere, these waves only"}),g("td",{children:Vt(i.lower/t,i.lowerError/t)}),g("td",{children:Vt(i.upper/t,i.upperError/t)})]}))})]})})}function Fv({diagram:n,choice:e}){let{row:t,band:i}=e.point.value,s=e.unit.value,{factor:r}=s,o=Array.from({length:n.bands},(a,l)=>({row:t,band:l}));return g("div",{class:"wide",children:g("table",{children:[g("caption",{children:["Modes at ",n.place(t)]}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"band"}),g("th",{scope:"col",children:Gt("frequency",s)}),g("th",{scope:"col",children:"motion"}),g("th",{scope:"col",children:"symmetry"}),g("th",{scope:"col",children:"show"})]})}),g("tbody",{children:o.map(a=>g("tr",{"aria-current":a.band===i?"true":void 0,children:[g("td",{children:a.band+1}),g("td",{children:Vt(n.at(a)/r,n.errorAt(a)/r)}),g("td",{children:n.nature(a)}),g("td",{children:n.parity(a)}),g("td",{children:g("button",{type:"button",onClick:()=>e.point.value=a,children:["band ",a.band+1]})})]}))})]})})}function wr({colours:n,ends:[e,t],children:i}){let s=[0,.25,.5,.75,1].map(r=>`rgb(${(n[Math.round(r*(n.length-1))]??[]).join(" ")})`);return g("p",{class:"scale",children:[g("span",{children:e}),g("span",{class:"bar",style:{background:`linear-gradient(to right, ${s.join(", ")})`}}),g("span",{children:t})," ",i]})}var Tr="#1c2126",Ov={ink:Tr,rim:"#ffffff"};function Bv(n,e,t,i=()=>!0){n.beginPath();for(let{outline:s,places:r}of e)for(let o of r)i(o)&&xp(n,s.map(([a,l])=>[o[0]+a,o[1]+l]),t)}function kv(n,e,t){n.save(),n.strokeStyle=at("carrier"),n.lineWidth=4*devicePixelRatio;for(let{hold:i,ends:s}of e)n.setLineDash(i==="clamped"?[]:[5*devicePixelRatio,3*devicePixelRatio]),n.beginPath(),xp(n,s,t),n.stroke();n.restore()}function xp(n,e,t){e.forEach((i,s)=>s===0?n.moveTo(...t(i)):n.lineTo(...t(i))),n.closePath()}function Er(n,e,t){n.beginPath(),xp(n,e,t),n.stroke()}function Mh([n,e],[t,i]){let[s,r]=[t/2,i/2];return[[n-s,e-r],[n+s,e-r],[n+s,e+r],[n-s,e+r]]}function wh(n,e,t,i,s=Ov){let o=t.flatMap(f=>f.map((d,p)=>[i(d),i(f[(p+1)%f.length]??d)])).filter(([f,d])=>Math.abs(f[1]-d[1])<1),a=Math.min(...o.map(([f])=>f[1])),l=([f,d])=>Math.abs(f[0]-d[0]),[c]=o.filter(([f])=>f[1]<a+1).sort((f,d)=>l(d)-l(f));if(c===void 0)return;let[u,h]=c;TC(n,e,[(u[0]+h[0])/2,a+17*devicePixelRatio],s)}function TC(n,e,[t,i],s=Ov){n.save(),n.font=`${13*devicePixelRatio}px system-ui, sans-serif`,n.textAlign="center",n.lineWidth=3*devicePixelRatio,n.strokeStyle=s.rim,n.fillStyle=s.ink;let r=n.measureText(e).width/2,o=Math.min(Math.max(t,r),n.canvas.width-r);n.strokeText(e,o,i),n.fillText(e,o,i),n.restore()}var zv=new WeakMap;function Gv(n,e,t,i){let s=n.canvas.width,r=`${t} ${s}`,o=zv.get(e);o?.of!==r&&(o={of:r,surface:EC(e,t,s,i)},zv.set(e,o)),n.save(),n.resetTransform(),n.drawImage(o.surface,0,0),n.restore()}function EC(n,e,t,i){let s=new OffscreenCanvas(t,t),r=new ImageData(t,t),[o,a]=n.range(e),l=n.colours.length-1;for(let c of n.mesh(e)){let u=c.map(f=>i(n.wavevector(f)).map(d=>d*devicePixelRatio)),h=c.map(f=>(n.at(n.sample(f),e)-o)/(a-o||1)*l);AC(r,u,h,n.colours)}return s.getContext("2d")?.putImageData(r,0,0),s}var bp=1e-6;function AC(n,[e,t,i],[s,r,o],a){let l=(t[0]-e[0])*(i[1]-e[1])-(i[0]-e[0])*(t[1]-e[1]);if(l===0)return;let c=p=>[Math.max(Math.floor(Math.min(e[p],t[p],i[p])),0),Math.min(Math.ceil(Math.max(e[p],t[p],i[p])),n.width)],[[u,h],[f,d]]=[c(0),c(1)];for(let p=f;p<d;p++)for(let y=u;y<h;y++){let[_,m]=[y+.5-e[0],p+.5-e[1]],b=(_*(i[1]-e[1])-(i[0]-e[0])*m)/l,A=((t[0]-e[0])*m-_*(t[1]-e[1]))/l;if(b<-bp||A<-bp||b+A>1+bp)continue;let S=Math.min(Math.max(s+b*(r-s)+A*(o-s),0),a.length-1),[R,C,v]=[a[Math.floor(S)]??[],a[Math.ceil(S)]??[],S%1],T=4*(p*n.width+y);for(let F=0;F<3;F++)n.data[T+F]=(1-v)*(R[F]??0)+v*(C[F]??0);n.data[T+3]=255}}var CC=[1,2,5,10],RC=1e-6,PC=.7,Th=class{constructor(e){this.data=e;this.places=e.values("zone_wavevector"),this.samples=e.values("zone_sample"),this.frequency=e.values("zone_frequency"),this.error=e.values("zone_error"),[,this.bands=0]=e.shape("zone_frequency");let t=Array.from(e.values("zone_mesh"));this.triangles=Array.from({length:t.length/3},(i,s)=>t.slice(3*s,3*s+3)),this.corners=e.header.extra.zone,this.colours=e.header.extra.colours,this.reach=Math.max(...Array.from(this.places,Math.abs))}data;bands;triangles;meshes=new Map;corners;colours;reach;places;samples;frequency;error;wavevector(e){return[this.places[2*e]??NaN,this.places[2*e+1]??NaN]}sample(e){return this.samples[e]??0}phases(e){let t=this.data.values("zone_kappa");return[t[2*e]??NaN,t[2*e+1]??NaN]}at(e,t){return this.frequency[e*this.bands+t]??NaN}errorAt(e,t){return this.error[e*this.bands+t]??NaN}get hasModes(){return this.data.has("zone_mode_real")}motion(e,t){let[i,s]=this.turned(e),[r,o]=this.wavevector(e),a=this.data.header.extra.lattice_vectors,[l,c]=a.map(([u,h])=>r*u+o*h);return{of:"zone",row:this.sample(e),band:t,kappa:[l??0,c??0],turn:i,isReversed:s}}velocity(e,t){let i=2*(this.sample(e)*this.bands+t),[s,r]=[this.data.values("zone_velocity")[i]??NaN,this.data.values("zone_velocity")[i+1]??NaN],[[[o,a],[l,c]],u]=this.turned(e),h=u?-1:1;return Number.isFinite(s)&&Number.isFinite(r)?[h*(o*s+a*r),h*(l*s+c*r)]:void 0}velocityError(e,t){return this.data.values("zone_velocity_error")[this.sample(e)*this.bands+t]??NaN}described(e,t){let i=this.sample(e),s=o=>this.data.values(o)[i*this.bands+t];return{motion:s("zone_character"),symmetry:Xf(s("zone_parity"),"the mirror of the wavevector",s("zone_middle_parity"))}}turned(e){let t=Math.floor(e/this.count),i=this.data.header.extra.zone_turns[t];if(i===void 0)throw new Error(`the zone has no copy ${t}`);return[i,this.data.header.extra.zone_signs[t]===-1]}mesh(e){let t=this.meshes.get(e);if(t!==void 0)return t;let i=[...this.triangles],s=(l,c)=>Math.abs(this.at(this.sample(l),e)-this.at(this.sample(c),e)),r=(l,c)=>Math.hypot(...[0,1].map(u=>(this.wavevector(l)[u]??0)-(this.wavevector(c)[u]??0))),o=new Map,a=new Set;return this.triangles.forEach((l,c)=>l.forEach((u,h)=>{let[f=0,d=0]=[l[(h+1)%3],l[(h+2)%3]],p=`${Math.min(f,d)} ${Math.max(f,d)}`,[y,_]=o.get(p)??[-1,-1];o.set(p,[c,u]),!(y<0||a.has(c)||a.has(y))&&(r(u,_)>(1+RC)*r(f,d)||s(u,_)>=s(f,d)||([i[c],i[y]]=[[u,_,f],[u,_,d]],a.add(c).add(y)))})),this.meshes.set(e,i),i}range(e){let t=Array.from({length:this.frequency.length/this.bands},(i,s)=>this.at(s,e));return[Math.min(...t),Math.max(...t)]}levels(e,t){let[i,s]=this.range(e),r=Array.from({length:this.count},(a,l)=>this.errorAt(l,e)),o=Math.max(...r);return IC(i,s,t).filter(a=>a-i>o&&s-a>o)}get count(){return this.frequency.length/this.bands}highest(e){return this.all.reduce((t,i)=>this.at(this.sample(i),e)>this.at(this.sample(t),e)?i:t,0)}nearest([e,t]){let i=s=>Math.hypot(this.wavevector(s)[0]-e,this.wavevector(s)[1]-t);return this.all.reduce((s,r)=>i(r)<i(s)?r:s,0)}next(e,t,i){let[s,r]=this.wavevector(e),[o,a]=[e,1/0];for(let l of this.all){let[c,u]=[this.wavevector(l)[0]-s,this.wavevector(l)[1]-r],h=Math.hypot(c,u),f=(c*t+u*i)/h;h>1e-9*this.reach&&f>PC&&h/f**2<a&&([o,a]=[l,h/f**2])}return o}contour(e,t){let i=[];for(let s of this.mesh(e)){let r=[];s.forEach((o,a)=>{let l=s[(a+1)%3]??0,[c,u]=[this.at(this.sample(o),e),this.at(this.sample(l),e)];if(c<t==u<t)return;let h=(t-c)/(u-c),[f,d]=[this.wavevector(o),this.wavevector(l)];r.push([f[0]+h*(d[0]-f[0]),f[1]+h*(d[1]-f[1])])}),r[0]&&r[1]&&i.push([r[0],r[1]])}return i}get all(){return Array.from(this.samples,(e,t)=>t)}};function IC(n,e,t){if(!(e>n))return[];let i=10**Math.floor(Math.log10((e-n)/t)),s=i*(CC.find(o=>o*i*t>=e-n)??10),r=Math.ceil(n/s);return Array.from({length:Math.floor(e/s)-r+1},(o,a)=>(r+a)*s)}var Vv=440,LC=26,Hv=8,DC=-5*Math.PI/8,Eh=34;function Wv({diagram:n,choice:e}){return n.data.has("zone_wavevector")?g(NC,{diagram:n,choice:e}):null}function NC({diagram:n,choice:e}){let t=Ge(()=>new Th(n.data),[n]),i=Ge(()=>({image:Xe(t.highest(e.point.peek().band))}),[t,e]),s=Ge(()=>UC(n,t,i,e),[n,t,i,e]),r=Ge(()=>xn(()=>t.motion(i.image.value,e.point.value.band)),[t,i,e]),{band:o}=e.point.value;return g("section",{"aria-label":"Brillouin zone",class:"pair",children:[g("div",{children:[g(Vn,{label:"Brillouin zone. Arrow keys move the wavevector, page keys change the band.",describedBy:"zone-point",onKeyDown:a=>{Jl(a,s),a.defaultPrevented&&a.stopPropagation()},children:g(FC,{zone:t,band:o,own:i,unit:e.unit.value})}),g("p",{class:"axes",children:g("label",{children:["Band"," ",g("select",{value:o+1,onChange:({currentTarget:a})=>e.point.value={...e.point.value,band:a.selectedIndex},children:Array.from({length:n.bands},(a,l)=>g("option",{children:l+1}))})]})}),g(GC,{zone:t,diagram:n,band:o,unit:e.unit.value}),g(VC,{diagram:n,zone:t,own:i,choice:e})]}),t.hasModes&&g("div",{children:[g(Sh,{data:n.data,choice:e,motion:r,name:"zone-mode"}),g("p",{class:"sides",children:g(Nr,{playing:e.playing})})]})]})}function UC(n,e,t,i){let s=o=>()=>i.point.value=vc(n,i.point.value,0,o),r=(o,a)=>()=>t.image.value=e.next(t.image.value,o,a);return[{keys:"arrows",effect:"next wavevector",actions:{ArrowLeft:r(-1,0),ArrowRight:r(1,0),ArrowUp:r(0,1),ArrowDown:r(0,-1)}},{keys:"page up, page down",effect:"next higher or lower band",actions:{PageUp:s(1),PageDown:s(-1)}}]}function FC({zone:n,band:e,own:t,unit:i}){let s=Nt(null),r=t.image.value,o=()=>{s.current!==null&&OC(s.current,n,e,r,i)};Gi(o),fn(()=>{let l=s.current?.parentElement;if(!l)return;let c=new ResizeObserver(()=>a.current());c.observe(l);let u=si(()=>a.current());return()=>{c.disconnect(),u()}},[]);let a=Nt(o);return a.current=o,g("div",{class:"map zone",children:g("canvas",{ref:s,role:"img","aria-label":`Frequency of band ${e+1} over the zone`,onClick:({offsetX:l,offsetY:c,currentTarget:u})=>{let{toWavevector:h}=qv(u,n);t.image.value=n.nearest(h(l,c))}})})}function qv(n,e){let t=n.clientWidth,i=(t-2*LC)/(2*e.reach);return{toPixel:([s,r])=>[t/2+i*s,t/2-i*r],toWavevector:(s,r)=>[(s-t/2)/i,(t/2-r)/i]}}function OC(n,e,t,i,s){let r=Math.min(n.parentElement?.clientWidth??Vv,Vv);if(r===0)return;n.style.width=n.style.height=`${r}px`,n.width=n.height=Math.round(r*devicePixelRatio);let o=n.getContext("2d");if(o===null)return;o.scale(devicePixelRatio,devicePixelRatio);let{toPixel:a}=qv(n,e);Gv(o,e,t,a),o.strokeStyle="#ffffff",o.lineWidth=1,o.beginPath();let l=e.levels(t,Hv).map(u=>({level:u,segments:e.contour(t,u)}));for(let[u,h]of l.flatMap(({segments:f})=>f))o.moveTo(...a(u)),o.lineTo(...a(h));o.stroke(),BC(o,l,a,s),zC(o,e,a);let c=e.hasModes?e.velocity(i,t):void 0;c!==void 0&&Math.hypot(...c)>e.velocityError(i,t)&&kC(o,a(e.wavevector(i)),c),o.beginPath(),o.arc(...a(e.wavevector(i)),5,0,2*Math.PI),o.fillStyle=at("accent"),o.strokeStyle="#ffffff",o.lineWidth=2,o.fill(),o.stroke(),n.dataset.shown=`${i},${t}`,Object.assign(n,{zone:e})}function BC(n,e,t,i){let s=[t([0,0])];n.save(),n.font="12px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle="#ffffff",n.strokeStyle=Tr,n.lineWidth=3,n.lineJoin="round";for(let{level:r,segments:o}of e){let a=o.map(([[d,p],[y,_]])=>[(d+y)/2,(p+_)/2]),l=([d,p])=>Math.abs(Math.atan2(p,d)-DC),c=a.reduce((d,p)=>d!==null&&l(d)<=l(p)?d:p,null);if(c===null)continue;let[u,h]=t(c);if(s.some(([d,p])=>Math.abs(d-u)<34&&Math.abs(p-h)<14))continue;s.push([u,h]);let f=bo(Number((r/i.factor).toPrecision(5)));n.strokeText(f,u,h),n.fillText(f,u,h)}n.restore()}function kC(n,[e,t],[i,s]){let r=Math.hypot(i,s),[o,a]=[i/r,-s/r],l=(c,u)=>[e+c*o-u*a,t+c*a+u*o];for(let[c,u]of[["#ffffff",5],[at("accent"),2.5]])n.strokeStyle=c,n.lineWidth=u,n.beginPath(),n.moveTo(e,t),n.lineTo(...l(Eh,0)),n.moveTo(...l(Eh-8,5)),n.lineTo(...l(Eh,0)),n.lineTo(...l(Eh-8,-5)),n.stroke()}function zC(n,e,t){n.strokeStyle=at("carrier"),n.setLineDash([5,4]),n.lineWidth=1.5,n.beginPath();for(let r of Object.values(e.corners))n.lineTo(...t(r));n.closePath(),n.stroke(),n.setLineDash([]),n.font="15px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.lineWidth=3,n.lineJoin="round";let i=Object.values(e.corners),s=[0,1].map(r=>i.reduce((o,a)=>o+(a[r]??0),0)/i.length);for(let[r,o]of Object.entries(e.corners)){let[a,l]=t(o),[c,u]=[Math.sign(o[0]-(s[0]??0)),Math.sign(o[1]-(s[1]??0))],h=Math.hypot(...o)<1e-6*e.reach;n.strokeStyle=h?Tr:at("paper"),n.fillStyle=h?"#ffffff":at("ink"),n.strokeText(r,a+13*c,l-13*u),n.fillText(r,a+13*c,l-13*u)}}function GC({zone:n,diagram:e,band:t,unit:i}){let[s="",r=""]=n.range(t).map(l=>cs(Number((l/i.factor).toPrecision(4)))),o=n.levels(t,Hv),a=((o[1]??0)-(o[0]??0))/i.factor;return g(wr,{colours:n.colours,ends:[s,r],children:[Gt("frequency",i)," of band ",t+1," of ",e.bands,o.length>1&&`; contours every ${Number(a.toPrecision(4))}`]})}function VC({diagram:n,zone:e,own:t,choice:i}){let[s,r,o]=[t.image.value,i.wavevectorUnit.value,i.unit.value],{band:a}=i.point.value,[l,c]=e.wavevector(s).map(p=>Number((p/r.factor).toFixed(3))),u=e.sample(s),h=p=>Vt(e.at(u,p)/o.factor,e.errorAt(u,p)/o.factor),[f,d]=e.phases(u).map(p=>Number((p/Math.PI).toFixed(4)));return g("div",{class:"facts",children:[g("p",{id:"zone-point","aria-live":"polite",children:["Band ",a+1," at ",Vi(`(${l}, ${c})`)," ",r.name,": ",g("b",{children:kn(h(a),o)})]}),e.hasModes&&g(ln,{children:[g(Ii,{facts:HC(n,e,s,a)}),g("p",{class:"again",children:["The arrow in the zone is the direction of the group velocity. Bands and modes are computed at ",e.count," ","wavevectors of the irreducible zone; a click selects the nearest one or its image."]})]}),g("details",{children:[g("summary",{children:"Frequencies of all bands at this wavevector"}),g("div",{class:"wide",children:g("table",{children:[g("caption",{children:"Frequencies at this wavevector"}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"band"}),g("th",{scope:"col",children:Gt("frequency",o)})]})}),g("tbody",{children:Array.from({length:e.bands},(p,y)=>g("tr",{"aria-current":y===a?"true":void 0,children:[g("td",{children:y+1}),g("td",{children:h(y)})]}))})]})})]}),g("p",{class:"again",children:["Its modes as a picture: ",g("code",{children:['haptonic bands STUDY --modes-at "',f,", ",d,'"']})]})]})}function HC(n,e,t,i){let[{motion:s,symmetry:r},o]=[e.described(t,i),e.velocity(t,i)];return[["motion",n.motion(s)],["symmetry",r],["group velocity",o?jl(o,e.velocityError(t,i)):"not defined"]]}function Yv(n,e){return g(qC,{data:n,host:e})}var WC="Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of the model.";function qC({data:n,host:e}){let t=Ge(()=>new pc(n),[n]),i=Ge(()=>v_(t),[t.rows,t.bands]),s=Ge(()=>YC(t,i),[t,i]),r=Ge(()=>u_(e?.turned),[e]),o=()=>{let y=r.layer.peek()??mc(t);i.held.value!==null?i.held.value=null:!y.areGapsPreview&&!r.isWaiting.peek()&&(i.held.value={layer:y,gaps:y.gaps,carrier:t.carrier,design:e?.design()??{}})},a=Ge(()=>b_(t,i,e&&o),[t,i,e]),l=r.layer.value,c=r.isWaiting.value?"earlier design":XC(l),u=r.isWaiting.value||l!==null,h=i.held.value,{carrier:f}=t,d=t.units.find(({name:y})=>y===i.unit.value.name)??i.unit.value,p=(l??t).gaps;return g(Jn,{name:"bands",data:n,keys:a,foot:WC,isOld:u,children:[g("div",{class:"insight",children:[e?.controls,g("span",{class:`kind ${c}`,children:c}),e&&g("button",{type:"button",class:"minor","aria-label":"Hold this design","aria-pressed":h!==null,disabled:c!=="certified"&&h===null,onClick:o,children:"Hold"}),c==="earlier design"?g("p",{children:[e?.turned.value?.preview?"Too far for a preview.":"No preview yet."," Certified curves follow."]}):g(g_,{gaps:p,carrier:f,unit:d})]}),g("div",{class:"pair",children:[g("section",{"aria-label":"Band diagram",children:[g(Vn,{label:"Band diagram. Arrow keys move along the path and between bands.",children:g(h_,{diagram:t,choice:i,newer:r})}),g("p",{class:"axes",children:[g(Pi,{title:"Frequencies in",units:t.units,unit:i.unit}),g(Pi,{title:"Wavevectors in",units:t.wavevectorUnits,unit:i.wavevectorUnit}),g($C,{diagram:t,isPreview:c==="preview",isHeld:h!==null})]}),h!==null&&e&&c!=="earlier design"&&g(__,{held:h,now:{gaps:p,carrier:f,design:e.design()},unit:d,isPreview:c!=="certified",drop:o})]}),g("section",{"aria-label":"Mode",children:[g(Sh,{data:n,choice:i,motion:s,name:"mode"}),g(ZC,{diagram:t,choice:i,isOld:u}),g(KC,{choice:i})]})]}),g(Wv,{diagram:t,choice:i}),g(ii,{listing:i.listing,keys:a,children:[g(Uv,{diagram:t,unit:i.unit.value}),g(Fv,{diagram:t,choice:i})]})]})}function XC(n){return n===null||!n.areGapsPreview?"certified":n.isPreview?"preview":"preview of gaps"}function YC(n,e){return xn(()=>{let{row:t,band:i}=e.point.value;return{of:"path",row:t,band:i,kappa:n.phases(t),turn:Dv,isReversed:!1}})}function $C({diagram:n,isPreview:e,isHeld:t}){return g("span",{class:"legend",children:[n.gaps.some(i=>i.complete)&&g("span",{class:"of-gap",children:"complete gap"}),n.gaps.some(i=>i.waves!=="all")&&g("span",{class:"of-parity",children:"gap of one parity"}),n.carrier!==void 0&&g("span",{class:"of-carrier",children:"carrier"}),e&&g("span",{class:"of-preview",children:"preview with its error"}),t&&g("span",{class:"of-held",children:"held design"})]})}function ZC({diagram:n,choice:e,isOld:t}){let i=e.point.value,s=e.unit.value,r=n.velocity(i),o=[["motion",n.nature(i)],["symmetry",n.parity(i)],["group velocity",r?jl(r,n.velocityError(i)):"not defined"]],a=n.place(i.row);return g("div",{class:"facts",children:[g("p",{id:"point","aria-live":"polite",children:["Band ",i.band+1," at ",a,t&&", earlier design",": ",g("b",{children:kn(Vt(n.at(i)/s.factor,n.errorAt(i)/s.factor),s)})]}),g(Ii,{facts:o}),g("p",{class:"again",children:["The same mode as a picture: ",g("code",{children:['haptonic bands STUDY --modes-at "',a,'"']})," or, in Python,"," ",g("code",{children:['study.bands(modes_at="',a,'").plot("modes")']})]})]})}function KC({choice:n}){let[e,t]=n.copies.value;return g("div",{class:"controls",children:[g(Nr,{playing:n.playing}),g("label",{children:["largest displacement, share of the period: ",n.swing.value.toFixed(2),g("input",{type:"range",min:"0",max:_c,step:"0.01",value:n.swing.value,onInput:i=>n.swing.value=Number(i.currentTarget.value)})]}),g(Ua,{pace:n.pace}),g("label",{children:["cells along a1",g("input",{type:"number",min:"1",max:gc,value:e,onChange:i=>n.copies.value=[Xv(i.currentTarget.value),t]})]}),g("label",{children:["cells along a2",g("input",{type:"number",min:"1",max:gc,value:t,onChange:i=>n.copies.value=[e,Xv(i.currentTarget.value)]})]})]})}function Xv(n){let e=Math.round(Number(n));return Number.isFinite(e)?Math.min(Math.max(e,1),gc):1}function ts(n){let{x:e,curves:t,titles:i,height:s,limits:r,whole:o}=n,a=Nt(null),l=Nt(n);l.current=n;let c=Nt(null);return Gi(()=>{let u=a.current;if(u===null)return;let h=()=>({width:sr(u),height:s}),f=new Qt({...h(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(d,p,y)=>p===null?r?.x??[0,1]:[p,y]},y:{range:(d,p,y)=>p===null?r?.y??[0,1]:[p,y]}},axes:[{...Rs(),label:i[0],labelSize:22,size:34,...o?{incrs:[1,2,5,10]}:{}},{...ir(),label:i[1]}],series:[{},...t.map(({colour:d,dash:p,width:y,points:_})=>({...Ps,stroke:()=>at(d),fill:()=>"transparent",dash:p??[],width:_?0:y??1.4,points:_?{show:!0,size:4,fill:()=>at(d),width:0}:{show:!1}}))],hooks:{drawClear:[d=>or(d,()=>l.current.below?.(d))],draw:[d=>or(d,()=>l.current.above?.(d))]}},[e,...t.map(({values:d})=>d)],u);return r?.x&&f.setScale("x",{min:r.x[0],max:r.x[1]}),r?.y&&f.setScale("y",{min:r.y[0],max:r.y[1]}),Do(f,(d,p)=>l.current.pick?.(f.posToVal(d,"x"),f.posToVal(p,"y"),f)),c.current=f,rr(f,u,h,[])},[e,t,i[0],i[1]]),Gi(()=>c.current?.redraw(!1,!1)),g("div",{class:"curves",ref:a})}var Ar=class n{constructor(e,t,i,s){this.canvas=e;this.context=t;this.small=i;this.inner=s;this.image=new ImageData(i.width,i.height)}canvas;context;small;inner;image;static on(e,t,i){let s=new OffscreenCanvas(t,i),[r,o]=[e.getContext("2d"),s.getContext("2d")];return r===null||o===null?null:new n(e,r,s,o)}show(e){let{canvas:t,context:i}=this;this.inner.putImageData(this.image,0,0),i.clearRect(0,0,t.width,t.height),i.imageSmoothingEnabled=e,i.imageSmoothingQuality="high",i.drawImage(this.small,0,0,t.width,t.height)}follow(e,t){let{canvas:i}=this,s=()=>{let o=Math.min(i.parentElement?.clientWidth??300,.62*innerHeight/e);i.style.width=`${o}px`,i.style.height=`${o*e}px`,i.width=Math.round(o*devicePixelRatio),i.height=Math.round(o*e*devicePixelRatio),t()},r=new ResizeObserver(s);return i.parentElement!==null&&r.observe(i.parentElement),()=>r.disconnect()}};function pa({grid:n,part:e,wave:t,pace:i,label:s,shown:r,name:o,caption:a}){let l=Nt(null);return fn(()=>l.current===null?void 0:JC(l.current,new Sp(n,e),t,i),[n,e,t,i]),g("div",{class:"map",children:[g("canvas",{ref:l,role:"img","aria-label":s}),g(wr,{colours:n.colours,ends:["−1","1"],children:r}),g(Fo,{canvas:l,name:o,caption:a})]})}function JC(n,e,t,i){let s=Ar.on(n,e.columns,e.rows);if(s===null)return()=>{};let r={frames:0,painter:e},o=()=>{r.frames++,e.paint(s.image,t.peek(),a.moment),s.show(!0);for(let c of t.peek().edges??[]){let u=(1-c)*n.height;nr(s.context,[0,u],[n.width,u],"quiet",[6,5])}n.dataset.shown=String(t.peek().number)},a=new ar(i,o,n);Uo(n,c=>a.at(c)),Object.assign(n,{counted:r});let l=[s.follow(e.ratio,o),Et(()=>{t.value,o()}),si(o)];return()=>{a.end();for(let c of l)c()}}var Sp=class{constructor(e,t){this.grid=e;this.part=t;let{repeats:i=1,periods:s}=t;this.columns=s*e.along,this.rows=i*e.across,this.ratio=i*e.width/(s*e.length)}grid;part;columns;rows;ratio;paint(e,{number:t,phase:i,decay:s},r){let{real:o,imag:a,present:l,across:c,along:u,colours:h}=this.grid,f=(h.length-1)/2,d=t*c*u;for(let p=0;p<this.columns;p++){let y=Math.floor(p/u),_=2*Math.PI*r+y*i,m=Math.exp(-y*s),[b,A]=[m*Math.cos(_),m*Math.sin(_)],S=Math.round(y*(this.part.slip??0)*c);for(let R=0;R<this.rows;R++){let v=((R-S)%c+c)%c*u+p%u,T=(o[d+v]??0)*b-(a[d+v]??0)*A,F=Math.min(Math.max(Math.round(f+T),0),2*f),[D=0,L=0,k=0]=h[F]??[],G=4*((this.rows-1-R)*this.columns+p);e.data.set([D,L,k,l[v]===0?0:255],G)}}}};var jC=12,Ah=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;[this.count=0]=e.shape("frequency"),this.best=Number(t.best),this.mode=String(i.mode),this.ends=String(i.ends),this.frequencyError=Number(i.relative_frequency_error),this.units=Ci(e),this.period=Number(i.period);let[,s=0,r=0]=e.shape("mode_real"),[o=0,a=0]=e.values("across");this.fields={grid:{real:e.values("mode_real"),imag:e.values("mode_imag"),present:e.values("present"),across:s,along:r,width:(a-o)*s,length:this.period,colours:t.colours},part:{periods:jC}}}data;count;best;mode;ends;frequencyError;units;fields;period;value(e,t){return this.data.values(e)[t]??NaN}wave(e){let t=.5*this.value("width",e)/this.fields.grid.width;return{number:e,phase:this.value("phase",e),decay:0,edges:[.5-t,.5+t]}}profile(e){let{real:t,imag:i,across:s,along:r}=this.fields.grid,o=Array.from({length:s},(l,c)=>{let u=(e*s+c)*r,h=0;for(let f=u;f<u+r;f++)h+=(t[f]??0)**2+(i[f]??0)**2;return Math.sqrt(h)}),a=Math.max(...o);return{position:Array.from(this.data.values("across")),size:o.map(l=>l/a)}}};function $v(n){return g(QC,{data:n})}function QC({data:n}){let e=Ge(()=>new Ah(n),[n]),t=Ge(()=>({guide:Xe(e.best),unit:Xe(Ri(e.units,e.value("frequency",e.best))),...fs(),listing:Xe("none")}),[e]),i=Ge(()=>tR(e,t),[e,t]),s=Ge(()=>xn(()=>e.wave(t.guide.value)),[e,t]),{grid:r,part:o}=e.fields;return g(Jn,{name:"guides",data:n,keys:i,foot:eR(e),children:[g("div",{class:"pair",children:[g("section",{"aria-label":"Waveguides",children:[g(Vn,{label:"Waveguides. Arrow keys select another length.",children:[e.count>1&&g(nR,{guides:e,choice:t}),g(sR,{guides:e,choice:t})]}),g("p",{class:"axes",children:g(Pi,{title:"Frequencies in",units:e.units,unit:t.unit})}),g(rR,{guides:e,choice:t})]}),g("section",{"aria-label":"Mode",children:[g(pa,{grid:r,part:o,wave:s,pace:t,label:"Field of the guided mode, the strip from left to right between rows of the lattice",shown:"normal displacement; 1 is the largest; dashed: edges of the strip",name:"waveguide",caption:`${n.header.title}, ${Hi(n)}`}),g(xo,{...t})]})]}),g(ii,{listing:t.listing,keys:i,children:g(oR,{guides:e,choice:t})})]})}function eR(n){return`Frequencies of the lattice have errors of up to ${(100*n.frequencyError).toPrecision(2)} %, which move all frequencies of the waveguides alike; the conditions at their ${n.ends} ends are approximate. The field is the displacement normal to the flat face, of a wave that travels to the left; two opposite ones form the mode of the strip. Dashed lines are the edges of the strip.`}function tR(n,e){let t=i=>()=>e.guide.value=Math.min(Math.max(e.guide.value+i,0),n.count-1);return[{keys:"← →",effect:"next shorter or longer waveguide",actions:{ArrowLeft:t(-1),ArrowRight:t(1)}},{keys:"b",effect:"waveguide nearest to the carrier",actions:{b:()=>e.guide.value=n.best}},us(e),...ni(e.listing)]}function nR({guides:n,choice:e}){let t=Ge(()=>Array.from({length:n.count},(u,h)=>h),[n]),[i,s]=Ge(()=>["length","width"].map(u=>t.map(h=>1e3*n.value(u,h))),[n,t]),r=Ge(()=>[{values:s,colour:"quiet",dash:[2,4]}],[s]),o=(u,h)=>[Math.min(...u)-h,Math.max(...u)+h],a=e.guide.value,l=u=>{for(let h of t){let f=[u.valToPos(i[h]??0,"x",!0),u.valToPos(s[h]??0,"y",!0)];Cs(u.ctx,f,h===a?"accent":"quiet",h===a?6:4)}},c=.08*(Math.max(...s)-Math.min(...s))||1;return g(ts,{x:i,curves:r,titles:["length / mm","width / mm"],height:240,limits:{x:o(i,500*n.period),y:o(s,c)},above:l,pick:u=>e.guide.value=iR(i,u)})}function iR(n,e){return n.reduce((t,i,s)=>Math.abs(i-e)<Math.abs((n[t]??NaN)-e)?s:t,0)}function sR({guides:n,choice:e}){let t=e.guide.value,{position:i,size:s}=Ge(()=>n.profile(t),[n,t]),r=Ge(()=>i.map(l=>1e3*l),[i]),o=Ge(()=>[{values:s,colour:"accent",width:2}],[s]),a=500*n.value("width",t);return g(ts,{x:r,curves:o,titles:["from the middle of the strip / mm","rms over its peak"],height:220,limits:{x:[r[0]??0,r[r.length-1]??1],y:[0,1.05]},below:l=>{Gr(l,[r[0]??0,-a],"panel"),Gr(l,[a,r[r.length-1]??0],"panel")},above:l=>[-a,a].forEach(c=>tr(l,c,"ink",[4,4]))},t)}function rR({guides:n,choice:e}){let[t,i]=[e.guide.value,e.unit.value],s=(o,a)=>`${(1e3*n.value(o,t)).toFixed(a)} mm`,r=[["width",s("width",2)],["length",`${s("length",1)}, ${n.value("rows",t)} cells`],["distance of nodal lines",s("nodal_spacing",3)],["amplitude at the edge",`${(100*n.value("amplitude_at_edge",t)).toFixed(1)} % of the peak`],["decay in the lattice",`${Kv(n,t)} dB per row`]];return g("div",{class:"facts",children:[g("p",{id:"point","aria-live":"polite",children:["Mode ",n.mode,", ",n.value("rows",t)," cells long: ",g("b",{children:kn(Zv(n,t,i),i)})]}),g(Ii,{facts:r})]})}function Zv(n,e,{factor:t}){let i=n.value("frequency",e)/t;return Vt(i,n.frequencyError*i)}var Kv=(n,e)=>Vt(n.value("decay",e),n.value("decay_error",e));function oR({guides:n,choice:e}){let t=e.unit.value;return g("div",{class:"wide",children:g("table",{children:[g("caption",{children:["Waveguides for mode ",n.mode]}),g("thead",{children:g("tr",{children:["cells","length / mm","width / mm",Gt("frequency",t),"decay / (dB/row)","edge / peak","show"].map(i=>g("th",{scope:"col",children:i}))})}),g("tbody",{children:Array.from({length:n.count},(i,s)=>g("tr",{"aria-current":s===e.guide.value?"true":void 0,children:[g("td",{children:n.value("rows",s)}),g("td",{children:(1e3*n.value("length",s)).toFixed(1)}),g("td",{children:(1e3*n.value("width",s)).toFixed(2)}),g("td",{children:Zv(n,s,t)}),g("td",{children:Kv(n,s)}),g("td",{children:n.value("amplitude_at_edge",s).toFixed(3)}),g("td",{children:g("button",{type:"button",onClick:()=>e.guide.value=s,children:[n.value("rows",s)," cells"]})})]}))})]})})}var aR=n=>`${(100*n).toFixed(0)} %`,lR=250,Jv=1e6,cR=["low","high","value"];function jv({data:n,finger:e}){let t=Nt(null);return Gi(()=>{if(t.current!==null)return uR(t.current,n,e)},[n,e]),g(ln,{children:[g("div",{class:"curves",ref:t}),g("p",{class:"legend",children:[g("span",{class:"of-curve",children:[g("svg",{width:"34",height:"8","aria-hidden":"true",children:g("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:"var(--curve-0)"})})," ","model"]}),g("span",{class:"of-gap",children:"its interval"}),g("span",{class:"of-carrier",children:["just noticed, ",aR(n.extra.weber)," less friction"]})]})]})}function uR(n,e,t){let i=Array.from(e.amplitudes,l=>l*Jv),s=()=>[i,...cR.map(l=>Array.from(t.law.value[l]))],r=()=>({width:sr(n),height:lR}),o={...Ps,width:0,points:{show:!1}},a=new Qt({...r(),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,distr:3},y:{range:[0,1.02]}},bands:[{series:[2,1],fill:()=>at("gap")}],axes:[{...Rs(),label:`${e.data.title("table")} / µm`,labelSize:22,size:34,values:(l,c)=>c.map(u=>Number.isInteger(Math.round(1e6*Math.log10(u))/1e6)?String(u):"")},{...ir(),label:e.data.title("load_sharing")}],series:[{},o,o,{...Ps,stroke:()=>at("curve-0"),width:2,points:{show:!1}}],hooks:{draw:[l=>hR(l,e,t)]}},s(),n);return rr(a,n,r,[Et(()=>a.setData(s())),Et(()=>{t.below.value,a.redraw(!1,!1)})])}function hR(n,e,t){let{ctx:i,bbox:s,valToPos:r}=n,{amplitude:o,friction:a}=t.below.peek(),[l,c]=[r(Math.max(o.value*Jv,.001),"x",!0),r(a.value,"y",!0)];Lo(n,1-e.extra.weber,"carrier",[7,5]),nr(i,[l,s.top],[l,s.top+s.height],"accent"),i.save(),i.fillStyle=at("accent"),i.beginPath(),i.arc(l,c,5*devicePixelRatio,0,2*Math.PI),i.fill(),i.restore()}var Qv=["value","low","high"],Ch=class{constructor(e){this.data=e;this.extra=e.header.extra,this.forces=e.values("force"),this.speeds=e.values("speed"),this.amplitudes=e.values("table"),this.x=e.values("x"),this.y=e.values("y"),this.columns=[...new Set(this.x)].sort((s,r)=>s-r),this.rows=[...new Set(this.y)].sort((s,r)=>s-r),this.cells=new Int32Array(this.columns.length*this.rows.length).fill(-1);let[t,i]=[this.columns,this.rows].map(s=>new Map(s.map((r,o)=>[r,o])));this.x.forEach((s,r)=>{this.cells[(i?.get(this.y[r]??0)??0)*this.columns.length+(t?.get(s)??0)]=r})}data;extra;forces;speeds;amplitudes;x;y;columns;rows;cells;get count(){return this.x.length}placeIn(e,t){if(t<0||t>=this.columns.length)return null;let i=this.cells[e*this.columns.length+t]??-1;return i<0?null:i}nearest([e,t]){let[i,s]=[0,1/0];for(let r=0;r<this.count;r++){let o=((this.x[r]??0)-e)**2+((this.y[r]??0)-t)**2;o<s&&([i,s]=[r,o])}return i}beside(e,t,i){let[s,r]=[this.rows.indexOf(this.y[e]??0),this.columns.indexOf(this.x[e]??0)];return this.placeIn(s+i,r+t)??e}region(e){return this.data.texts("region")[e]||"a lattice"}amplitude(e,t,i){let s=this.data.texts("load").indexOf(t);return i*(this.data.values("amplitude")[s*this.count+e]??0)}law(e,t){let i=this.amplitudes.length,s=this.data.texts("end"),r=(h,f)=>{let d=this.data.values(h);return p=>{let y=(f*s.length+s.indexOf(p))*i;return d.subarray(y,y+i)}},[o,a]=[r("load_sharing",e),r("intermittent",t)],l=[o("value"),a("value")],c=(h,f)=>{let d=[o(h),a(h),...l];return Float64Array.from(d[0]??[],(p,y)=>{let _=d.map(m=>m[y]??NaN).filter(m=>!Number.isNaN(m));return _.length>0?f(..._):NaN})};return{value:Float64Array.from(l[0]??[],(h,f)=>Number.isNaN(h)?l[1]?.[f]??NaN:h),low:c("low",Math.min),high:c("high",Math.max)}}friction(e,t){let[i=1,s=1]=[this.amplitudes[0],this.amplitudes.at(-1)],r=e.length-1,o=Math.log(Math.max(t,i)/i)/Math.log(s/i)*r,a=Math.min(Math.floor(o),r-1),l=Math.min(o-a,1);return(e[a]??NaN)*(1-l)+(e[a+1]??NaN)*l}};function ey(n,e){return n.low>e?"noticed, also at the lower limit":n.value>e?"probably noticed, but not at the lower limit":n.high>e?"probably not noticed, except at the upper limit":"not noticed, even at the upper limit"}function ty({data:n,finger:e}){let t=Nt(null);return fn(()=>{if(t.current!==null)return fR(t.current,n,e)},[n,e]),g("div",{class:"map",children:[g("canvas",{ref:t,role:"img","aria-label":"Map of the reduction of friction"}),g(wr,{colours:n.extra.colours,ends:["0","100 %"],children:"less friction below a finger with its middle there, model"})]})}function fR(n,e,t){let[i,s]=[e.columns,e.rows],r=Ar.on(n,i.length,s.length);if(r===null)return()=>{};let{image:o,context:a}=r,[l,c]=[i,s].map(p=>dR(p)),u=([p,y])=>[n.width*(p-l[0])/(l[1]-l[0]),n.height*(c[1]-y)/(c[1]-c[0])],h=()=>{let{colours:p}=e.extra,[y,_]=[t.law.peek(),t.drive.peek()];s.forEach((m,b)=>i.forEach((A,S)=>{let R=e.placeIn(b,S),C=4*((s.length-1-b)*i.length+S);if(o.data[C+3]=R===null?0:255,R===null)return;let v=1-e.friction(y.value,e.amplitude(R,"value",_));(p[Math.round(Math.min(Math.max(v,0),1)*(p.length-1))]??[]).forEach((F,D)=>o.data[C+D]=F)}))},f=()=>{r.show(!0),pR(a,e,u),mR(a,e,t.place.peek(),u),n.dataset.shown=String(t.place.peek())},d=[r.follow((c[1]-c[0])/(l[1]-l[0]),f),Et(()=>{t.law.value,t.drive.value,h(),f()}),Et(()=>{t.place.value,f()}),si(f),gR(n,([p,y])=>{let _=[l[0]+p*(l[1]-l[0]),c[1]-y*(c[1]-c[0])];t.place.value=e.nearest(_)})];return()=>{for(let p of d)p()}}function dR(n){let[e=0,t=e+.001]=n,i=(t-e)/2;return[e-i,(n.at(-1)??0)+i]}function pR(n,{extra:e},t){n.lineWidth=1.2*devicePixelRatio,n.strokeStyle="#ffffff";for(let i of Object.values(e.regions).flat())Er(n,i,t);n.strokeStyle=at("quiet");for(let i of e.plate)Er(n,i,t);n.strokeStyle="#ffffff",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[i,s,r,o]of Object.values(e.patches))Er(n,Mh([i,s],[r,o]),t);n.setLineDash([]);for(let[i,s]of Object.entries(e.regions))wh(n,i,s,t)}function mR(n,e,t,i){let s=[e.x[t]??0,e.y[t]??0],[r,o]=i(s),a=i([s[0]+e.extra.diameter/2,s[1]])[0]-r;for(let[l,c]of[["#ffffff",5],[Tr,2]])n.strokeStyle=l,n.lineWidth=c*devicePixelRatio,n.beginPath(),n.arc(r,o,a,0,2*Math.PI),n.moveTo(r-4*devicePixelRatio,o),n.lineTo(r+4*devicePixelRatio,o),n.moveTo(r,o-4*devicePixelRatio),n.lineTo(r,o+4*devicePixelRatio),n.stroke()}function gR(n,e){let t=i=>{if(i.type==="pointerdown")n.setPointerCapture(i.pointerId);else if(i.buttons===0)return;let s=n.getBoundingClientRect();e([(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height])};return n.addEventListener("pointerdown",t),n.addEventListener("pointermove",t),()=>{n.removeEventListener("pointerdown",t),n.removeEventListener("pointermove",t)}}var _R=5,ny=1.05;function iy(n){let{drive:e,force:t,speed:i}=n.extra,s=Xe(vR(n)),r={drive:Xe(e.value),force:Xe(n.forces.indexOf(t)),speed:Xe(n.speeds.indexOf(i))};r.force.peek()<0&&(r.force.value=0);let o=xn(()=>n.law(r.force.value,r.speed.value)),a=xn(()=>yR(n,o.value,s.value,r.drive.value));return{place:s,...r,listing:Xe("none"),law:o,below:a}}function vR(n){let e=n.extra.diameter/2,t=(r,o)=>r-e>=(o[0]??0)&&r+e<=(o.at(-1)??0),[i,s]=[0,-1];for(let r=0;r<n.count;r++){let o=n.amplitude(r,"value",1),a=t(n.x[r]??0,n.columns)&&t(n.y[r]??0,n.rows);o>s&&a&&([i,s]=[r,o])}return i}function yR(n,e,t,i){let s=a=>Object.fromEntries(Qv.map(l=>[l,a(l)])),r=s(a=>n.amplitude(t,a,i)),o=s(a=>n.friction(e[a],r[a]));return{amplitude:r,free:n.amplitude(t,"free",i),friction:o,reduction:{value:1-o.value,low:1-o.high,high:1-o.low}}}function sy(n,e){let t=(c,u)=>h=>{for(let f=0;f<(h.shiftKey?_R:1);f++)e.place.value=n.beside(e.place.peek(),c,u)},{low:i,high:s}=n.extra.drive,r=c=>()=>e.drive.value=Math.min(Math.max(e.drive.peek()*c,i),s),o=(c,u,h)=>()=>c.value=Math.min(Math.max(c.peek()+u,0),h-1),[a,l]=[n.forces.length,n.speeds.length];return[{keys:"← → ↑ ↓",effect:"move the finger; five places with Shift",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}},{keys:"+ −",effect:"5 % more or less drive",actions:{"+":r(ny),"-":r(1/ny)}},{keys:"f F",effect:"more or less force",actions:{f:o(e.force,1,a),F:o(e.force,-1,a)}},{keys:"s S",effect:"faster or slower",actions:{s:o(e.speed,1,l),S:o(e.speed,-1,l)}},...ni(e.listing)]}function ry({plate:n,choice:e}){let t=Nt(null);return fn(()=>{if(t.current!==null)return bR([...t.current.querySelectorAll("canvas")],n,e)},[n,e]),g("div",{class:n.fields.length>1?"maps":"",ref:t,children:n.fields.map(i=>g(xR,{plate:n,choice:e,field:i},i.title))})}function xR({plate:n,choice:e,field:t}){let i=Nt(null),s=no(oy(n,e,t,e.line.value)),r=t.title||Hi(n.data);return g("div",{class:"map",children:[t.title&&g("h2",{children:t.title}),g("canvas",{ref:i,role:"img","aria-label":`Map of the moving plate${t.title&&`, ${t.title}`}`}),g(wr,{colours:n.colours,ends:[`−${s}`,s],children:["normal displacement",n.drive]}),g(Fo,{canvas:i,name:"map",caption:`${n.data.header.title}, ${r}`})]})}function oy(n,e,t,i){return n.largest(i,e.common.value?n.fields:[t])}function no(n){let[e,t]=n>=1e-6?["µm",1e6]:n>=1e-9?["nm",1e9]:["pm",1e12];return`${Number((n*Number(t)).toPrecision(3))} ${e}`}function bR(n,e,t){let{left:i,right:s,bottom:r,top:o}=e.extent,a=e.fields.flatMap((f,d)=>{let p=n[d],y=p===void 0?null:Ar.on(p,f.columns,f.rows);return p===void 0||y===null?[]:[{field:f,canvas:p,raster:y,counted:{frames:0}}]}),l=()=>{for(let f of a)c(f)},c=({field:f,canvas:d,raster:p,counted:y})=>{let _=t.line.peek();y.frames++;let m=(e.fields[0]??f).outermost(_)+u.moment;f.paint(p.image,_,m,oy(e,t,f,_)),p.show(!e.data.has("place"));let b=([A,S])=>[d.width*(A-i)/(s-i),d.height*(o-S)/(o-r)];SR(p.context,e,b,t.plan.peek()),d.dataset.shown=String(_)},u=new ar(t,l,...n);for(let{canvas:f,counted:d}of a)Uo(f,p=>u.at(p)),Object.assign(f,{counted:d});let h=[...a.map(({raster:f})=>f.follow((o-r)/(s-i),l)),Et(()=>{t.line.value,t.plan.value,t.common.value,l()}),si(l)];return()=>{u.end();for(let f of h)f()}}function SR(n,e,t,i){let{plate:s,regions:r,patches:o,features:a,held:l}=e.parts;n.strokeStyle=Tr,n.lineWidth=1.2*devicePixelRatio;for(let c of Object.values(r).flat())Er(n,c,t);i&&(n.lineWidth=.8*devicePixelRatio,Bv(n,a,t),n.stroke(),kv(n,l,t)),n.lineWidth=1.2*devicePixelRatio,n.strokeStyle=at("quiet");for(let c of s)Er(n,c,t);n.strokeStyle="#855a12",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[c,u,h,f]of Object.values(o))Er(n,Mh([c,u],[h,f]),t);n.setLineDash([]);for(let[c,u]of Object.entries(r))wh(n,c,u,t)}var MR="All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, at the nearest computed place.",wR=500;function cy(n){return g(TR,{dataset:n})}function TR({dataset:n}){let e=Ge(()=>new Ch(n),[n]),t=Ge(()=>iy(e),[e]),i=Ge(()=>sy(e,t),[e,t]);return g(Jn,{name:"finger",data:n,keys:i,foot:MR,children:[g("div",{class:"pair",children:[g("section",{"aria-label":"Map",children:g(Vn,{label:"Finger on the plate. Arrow keys move it.",describedBy:"felt",children:g(ty,{data:e,finger:t})})}),g("section",{"aria-label":"Friction",children:[g(ER,{data:e,finger:t}),g(jv,{data:e,finger:t}),g(AR,{data:e,finger:t})]})]}),g(ii,{listing:t.listing,keys:i,children:g(CR,{data:e})})]})}function Hs(n,e){let t=Math.abs(n),[i,s]=t>=1||t===0?["",1]:t>=.001?["m",1e3]:["µ",1e6];return`${Number((n*Number(s)).toPrecision(3))} ${i}${e}`}var ay=n=>`${(100*n).toFixed(0)} %`;function ER({data:n,finger:e}){let{amplitude:t,free:i,friction:s,reduction:r}=e.below.value,o=e.place.value,{weber:a,frequency:l,drive:c,diameter:u}=n.extra,h=(d,p,[y,_])=>`${p(d.value)} (${p(d[y])} to ${p(d[_])})`,f=d=>d.toFixed(2);return g("div",{class:"facts",children:[g("p",{id:"felt","aria-live":"polite",children:[g("b",{children:n.region(o)}),", x = ",Hs(n.x[o]??0,"m"),", y = ",Hs(n.y[o]??0,"m"),":"," ",g("b",{children:ey(r,a)})]}),g(Ii,{facts:[["μ/μ₀, model",h(s,f,["low","high"])],["less friction",h(r,ay,["low","high"])],["amplitude below the finger",h(t,no,["high","low"])],["without a finger",no(i)]]}),g("p",{class:"again",children:["Just noticed: ",ay(a)," less friction. The finger covers ",Hs(u,"m"),";"," ",Number((l/1e3).toFixed(3))," kHz. The same in the study:"," ",g("code",{children:["touch = ","{",' force = "',Hs(n.forces[e.force.value]??0,"N"),'", speed = "',Hs(n.speeds[e.speed.value]??0,"m/s"),'"',c.unit==="V"?`, voltage = "${Hs(e.drive.value,"V")}"`:""," ","}"]})]})]})}function AR({data:n,finger:e}){let{low:t,high:i,title:s,unit:r}=n.extra.drive;return g("div",{class:"controls",children:[g("label",{class:"long",children:["Drive, ",s.toLowerCase(),": ",Hs(e.drive.value,r),g("input",{type:"range",min:t,max:i,step:(i-t)/wR||1,value:e.drive.value,"aria-valuetext":Hs(e.drive.value,r),onInput:o=>e.drive.value=Number(o.currentTarget.value)})]}),g(ly,{title:n.data.title("force"),unit:"N",values:n.forces,chosen:e.force}),g(ly,{title:n.data.title("speed"),unit:"m/s",values:n.speeds,chosen:e.speed})]})}function ly({title:n,unit:e,values:t,chosen:i}){let s=Hs(t[i.value]??0,e);return g("label",{class:"long",children:[n,": ",s,g("input",{type:"range",min:"0",max:t.length-1,step:"1",value:i.value,"aria-valuetext":s,onInput:r=>i.value=Number(r.currentTarget.value)})]})}function CR({data:n}){return g("div",{class:"wide",children:[g("table",{children:[g("caption",{children:"Numbers of the models"}),g("thead",{children:g("tr",{children:["number","value","plausible","origin","source"].map(e=>g("th",{scope:"col",children:e}))})}),g("tbody",{children:n.extra.parameters.map(({title:e,value:t,plausible:i,mark:s,source:r})=>g("tr",{children:[e,t,i,s,r].map(o=>g("td",{children:o}))}))})]}),g("dl",{children:Object.entries(n.extra.models).map(([e,t])=>g("div",{children:[g("dt",{children:["Model of ",e]}),g("dd",{children:t})]}))})]})}var RR="Squares are all participants together, discs are single ones; circles are trials.",[Rh,Mp,PR,IR]=[24,8,36,16],LR=7.2,uy=300;function hy(n){return g(DR,{data:n})}function DR({data:n}){let e=Ge(()=>OR(n),[n]),t=Ge(()=>[...new Set(e.map(({quantity:l})=>l))],[e]),i=Ge(()=>({quantity:Xe(t[0]??""),row:Xe(0),listing:Xe("none")}),[t]),s=Ge(()=>BR(e,t,i),[e,t,i]),r=e.filter(({quantity:l})=>l===i.quantity.value),o=r[i.row.value],a=n.header.extra.sentences??[];return g(Jn,{name:"friction",data:n,keys:s,foot:RR,children:[a.length>0&&g("details",{children:[g("summary",{children:"Estimates, tests and assumptions"}),a.map(l=>g("p",{children:$l(l)}))]}),g("p",{class:"axes",children:g("label",{children:["Quantity"," ",g("select",{value:i.quantity.value,onChange:l=>{i.quantity.value=l.currentTarget.value,i.row.value=0},children:t.map(l=>g("option",{children:l}))})]})}),g(Vn,{label:"Estimates. Arrow keys go from one to the next.",children:g(NR,{estimates:r,choice:i})}),g("div",{class:"facts",children:g("p",{id:"point","aria-live":"polite",children:o!==void 0&&g(ln,{children:[g("b",{children:o.name}),": ",FR(o),o.note&&`; ${o.note}`]})})}),g(ii,{listing:i.listing,keys:s,children:t.map(l=>g(UR,{title:l,estimates:e.filter(c=>c.quantity===l)}))})]})}function NR({estimates:n,choice:e}){let[t,i]=zR(),s=Math.min(LR*Math.max(...n.map(({name:u})=>u.length),4)+12,.5*i),r=n.flatMap(({value:u,low:h,high:f,trials:d})=>[u,h,f,...d]).filter(Number.isFinite),[o,a]=[Math.min(0,...r),Math.max(...r,.01)],l=u=>s+(u-o)/(a-o)*(i-s-IR),c=Mp+Rh*n.length;return g("div",{ref:t,children:g("svg",{class:"estimates",width:i,height:c+PR,role:"img","aria-label":`${e.quantity.value}; the table has all numbers`,children:[kR(o,a).map(u=>g(ln,{children:[g("line",{x1:l(u),x2:l(u),y1:Mp,y2:c}),g("text",{x:l(u),y:c+16,"text-anchor":"middle",class:"quiet",children:`${u}`.replace("-","−")})]})),g("text",{x:(s+i)/2,y:c+32,"text-anchor":"middle",children:e.quantity.value}),n.map((u,h)=>{let f=Mp+Rh*(h+.5),{value:d,low:p,high:y,name:_,whole:m,trials:b}=u;return g("g",{class:m?"whole":"",onClick:()=>e.row.value=h,children:[g("rect",{class:e.row.value===h?"chosen":"",x:"1",y:f-Rh/2,width:i-2,height:Rh,fill:"transparent"}),g("text",{x:s-8,y:f+4,"text-anchor":"end",children:_}),b.map(A=>g("circle",{class:"trial",cx:l(A),cy:f,r:"2.5"})),Number.isFinite(p)&&g("line",{class:"interval",x1:l(p),x2:l(y),y1:f,y2:f}),Number.isFinite(d)&&(m?g("rect",{class:"mark",x:l(d)-5,y:f-5,width:"10",height:"10"}):g("circle",{cx:l(d),cy:f,r:"4.5"}))]})})]})})}function UR({title:n,estimates:e}){return g("div",{class:"wide",tabIndex:0,role:"group","aria-label":n,children:g("table",{children:[g("caption",{children:n}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"of"}),g("th",{scope:"col",children:"value"}),g("th",{scope:"col",children:"from"}),g("th",{scope:"col",children:"to"}),g("th",{scope:"col",children:"note"})]})}),g("tbody",{children:e.map(({name:t,value:i,low:s,high:r,note:o})=>g("tr",{children:[g("td",{children:t}),g("td",{children:ma(i)}),g("td",{children:ma(s)}),g("td",{children:ma(r)}),g("td",{children:o})]}))})]})})}var ma=n=>Number.isFinite(n)?n.toFixed(3).replace("-","−"):"-",FR=({value:n,low:e,high:t})=>ma(n)+(Number.isFinite(e)?`, from ${ma(e)} to ${ma(t)}`:"");function OR(n){let[e,t,i]=["quantity","name","note"].map(c=>n.texts(c)),[s,r,o]=["low","high","whole"].map(c=>n.values(c)),a=n.texts("trial_condition"),l=new Map;return n.values("trial_friction").forEach((c,u)=>{let h=a[u]??"";l.set(h,[...l.get(h)??[],c])}),Array.from(n.values("value"),(c,u)=>({quantity:e?.[u]??"",name:t?.[u]??"",note:i?.[u]??"",value:c,low:s?.[u]??NaN,high:r?.[u]??NaN,whole:o?.[u]===1,trials:(l.get(t?.[u]??"")??[]).filter(Number.isFinite)}))}function BR(n,e,t){let i=()=>n.filter(({quantity:o})=>o===t.quantity.peek()).length-1,s=o=>()=>t.row.value=Math.min(Math.max(t.row.peek()+o,0),i()),r=()=>{let o=e.indexOf(t.quantity.peek());t.quantity.value=e[(o+1)%e.length]??"",t.row.value=0};return[{keys:"↑ ↓",effect:"previous or next estimate",actions:{ArrowUp:s(-1),ArrowDown:s(1)}},{keys:"q",effect:"next quantity",actions:{q:r}},...ni(t.listing)]}function kR(n,e){let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5,10].find(a=>a*i>=t)??10),r=Math.ceil(n/s-1e-9),o=Math.floor(e/s+1e-9)-r+1;return Array.from({length:o},(a,l)=>Number(((r+l)*s).toPrecision(6)))}function zR(){let n=Nt(null),[e,t]=js(uy);return fn(()=>{let i=n.current;if(i===null)return;let s=new ResizeObserver(()=>t(Math.min(Math.max(i.clientWidth,uy),960)));return s.observe(i),()=>s.disconnect()},[]),[n,e]}var GR=6,VR=2,HR=["across the rows","along the rows","normal to the plate"],Ph=class{constructor(e){this.data=e;this.frequency=e.values("frequency"),this.rows=e.values("rows"),this.kinds=e.texts("incident"),this.incident=this.kinds.filter(t=>this.losses(t).flat().some(Number.isFinite)),[this.waves=0]=e.shape("decay"),this.carrier=Number(e.header.extra.carrier),this.gap=e.header.extra.gap,this.units=Ci(e)}data;frequency;rows;incident;waves;carrier;gap;units;kinds;nearest(e){let t=Array.from(this.frequency,i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}losses(e,t="loss"){let i=this.kinds.indexOf(e)*this.rows.length;return Array.from(this.rows,(s,r)=>this.curve(t,i+r))}ofWaves(e){return Array.from({length:this.waves},(t,i)=>this.curve(e,i))}get hasFields(){return this.data.has("wave_real")}get fields(){let{data:e}=this,[,,t=0,i=0]=e.shape("wave_real"),[s,r]=[fy(e.values("across")),fy(e.values("along"))],o={real:e.values("wave_real"),imag:e.values("wave_imag"),present:e.values("present")},a=e.header.extra.colours,l=e.values("slab_slip")[0]??0;return{grid:{...o,across:t,along:i,width:s*t,length:r*i,colours:a},part:{periods:Math.ceil(GR/(e.values("slab_rows")[0]??1)),repeats:VR,slip:l}}}field(e,t){let i=e*this.frequency.length+t;return{number:i,phase:this.data.values("slab_phase")[i]??0,decay:this.data.values("slab_decay")[i]??0}}direction(e,t){return HR[this.data.values("wave_component")[e*this.frequency.length+t]??2]??""}curve(e,t){let i=this.frequency.length;return Array.from(this.data.values(e).subarray(t*i,(t+1)*i))}};function Ih(n){return n.map(e=>Number.isFinite(e)?e:null)}function fy(n){return(n[1]??0)-(n[0]??0)}var WR="Errors are the change of a value if all frequencies of the lattice move by the bound of their relative error, and this share of the value. Waves of the lattice are shown at normal incidence. The field is that of the strongest component on the flat face, over six rows; a wave enters them from the left, relative to its largest displacement in the first row.",qR=10,Tp=1.05,XR=60,YR="Fields of the waves are computed with the option --html.";function my(n){return g($R,{data:n})}function $R({data:n}){let e=Ge(()=>new Ph(n),[n]),t=Ge(()=>({line:Xe(e.nearest(e.carrier)),rows:Xe(e.rows.length-1),incident:Xe(e.incident[0]??""),wave:Xe(0),...fs(),unit:Xe(Ri(e.units,Math.max(...e.frequency))),listing:Xe("none")}),[e]),i=Ge(()=>ZR(e,t),[e,t]);return g(Jn,{name:"mirror",data:n,keys:i,foot:WR,children:[g("div",{class:"pair",children:[g("section",{"aria-label":"Insertion loss",children:[g(Vn,{label:"Insertion loss. Arrow keys change the frequency and the number of rows.",children:g(KR,{mirror:e,choice:t})}),g("p",{class:"axes",children:[g("label",{children:["Incident wave"," ",g("select",{value:t.incident.value,onChange:s=>t.incident.value=s.currentTarget.value,children:e.incident.map(s=>g("option",{children:s}))})]}),g(Pi,{title:"Frequencies in",units:e.units,unit:t.unit}),g("span",{class:"legend",children:[g("span",{class:"of-curve",children:[g(py,{colour:"accent"})," ",wp(e.rows[t.rows.value]??0)]}),e.rows.length>1&&g("span",{class:"of-curve",children:[g(py,{colour:"quiet"})," ",Math.min(...e.rows)," to ",wp(Math.max(...e.rows))]}),e.gap&&g("span",{class:"of-gap",children:"gap"}),g("span",{class:"of-carrier",children:"carrier"})]})]}),g(tP,{mirror:e,choice:t}),g(JR,{mirror:e,choice:t})]}),g("section",{"aria-label":"Waves of the lattice",children:[g(dy,{mirror:e,choice:t,name:"decay"}),g(eP,{mirror:e,choice:t}),e.hasFields?g(QR,{mirror:e,choice:t}):g("p",{children:YR}),g(dy,{mirror:e,choice:t,name:"phase"})]})]}),g(ii,{listing:t.listing,keys:i,children:[g(nP,{mirror:e,choice:t}),g(iP,{mirror:e,choice:t})]})]})}function ZR(n,e){let t=(o,a)=>Math.min(Math.max(o,0),a-1),i=o=>e.line.value=t(e.line.value+o,n.frequency.length),s=o=>e.rows.value=t(e.rows.value+o,n.rows.length),r=o=>o.shiftKey?qR:1;return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:o=>i(-r(o)),ArrowRight:o=>i(r(o))}},{keys:"↑ ↓",effect:"one more or one less row",actions:{ArrowUp:()=>s(1),ArrowDown:()=>s(-1)}},{keys:"i",effect:"next incident wave",actions:{i:()=>{let o=(n.incident.indexOf(e.incident.value)+1)%n.incident.length;e.incident.value=n.incident[o]??""}}},{keys:"w W",effect:"wave of the lattice with the next higher or lower decay",actions:{w:()=>e.wave.value=t(e.wave.value+1,n.waves),W:()=>e.wave.value=t(e.wave.value-1,n.waves)}},us(e),{keys:"c",effect:"carrier",actions:{c:()=>e.line.value=n.nearest(n.carrier)}},...ni(e.listing)]}function gy({mirror:n,choice:e}){let{factor:t}=e.unit.value,i=(n.frequency[e.line.value]??0)/t;return{below:s=>{n.gap&&Gr(s,[n.gap[0]/t,n.gap[1]/t],"gap")},above:s=>{tr(s,n.carrier/t,"carrier",[7,5]),tr(s,i,"accent")},pick:s=>e.line.value=n.nearest(s*t)}}function _y({mirror:n,choice:e}){let{factor:t}=e.unit.value;return Ge(()=>Array.from(n.frequency,i=>i/t),[n,t])}function KR({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.rows.value],s=Ge(()=>n.losses(t).map((l,c)=>({values:Ih(l),colour:c===i?"accent":"quiet",width:c===i?2.6:1})),[n,t,i]),r=n.losses(t).flat().filter(Number.isFinite),[o,a]=[Math.min(0,...r),Math.max(1,...r)];return g(ts,{x:_y({mirror:n,choice:e}),curves:s,titles:[Gt("frequency",e.unit.value),`${n.data.title("loss")} / dB`],height:300,limits:{y:[o,o+Tp*(a-o)]},...gy({mirror:n,choice:e})})}function JR({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.line.value],[s,r]=["loss","loss_error"].map(c=>n.losses(t,c).map(u=>u[i]??NaN)),o=Ge(()=>Array.from(n.rows),[n]),a=Ge(()=>[{values:Ih(s??[]),colour:"quiet",dash:[2,4]}],[n,t,i]),l=Math.max(1,...o.map((c,u)=>(s?.[u]??NaN)+(r?.[u]??NaN)).filter(Number.isFinite));return g(ts,{x:o,curves:a,titles:["rows",`${n.data.title("loss")} / dB`],height:200,whole:!0,limits:{x:[.5,o.length+.5],y:[Math.min(0,...(s??[]).filter(Number.isFinite)),Tp*l]},above:c=>o.forEach((u,h)=>{let[f=NaN,d=NaN]=[s?.[h],r?.[h]];if(!Number.isFinite(f))return;let p=y=>[c.valToPos(u,"x",!0),c.valToPos(y,"y",!0)];nr(c.ctx,p(f-d),p(f+d),"ink"),Cs(c.ctx,p(f),h===e.rows.value?"accent":"quiet")}),pick:c=>e.rows.value=Math.min(Math.max(Math.round(c)-1,0),o.length-1)},`${t} ${i}`)}function dy({mirror:n,choice:e,name:t}){let i=Ge(()=>n.ofWaves(t).map(l=>({values:Ih(l),colour:"curve-0",points:!0})),[n,t]),s=e.line.value,r=i[e.wave.value]?.values[s],o=gy({mirror:n,choice:e}),a=Math.min(XR,Tp*Math.max(...i.flatMap(({values:l})=>l.map(c=>c??0))));return g(ts,{x:_y({mirror:n,choice:e}),curves:i,titles:[Gt("frequency",e.unit.value),`${n.data.title(t)} / ${t==="decay"?"(dB/row)":"π"}`],height:t==="decay"?300:200,limits:{y:t==="decay"?[0,a]:[0,1]},below:o.below,above:l=>{o.above(l),typeof r=="number"&&Cs(l.ctx,[l.valToPos((n.frequency[s]??0)/e.unit.value.factor,"x",!0),l.valToPos(r,"y",!0)],"accent")},pick:(l,c)=>{o.pick(l),e.wave.value=jR(i.map(({values:u})=>u[e.line.value]??NaN),c)??e.wave.value}})}function jR(n,e){return n.map((i,s)=>s).filter(i=>Number.isFinite(n[i])).sort((i,s)=>Math.abs(n[i]-e)-Math.abs(n[s]-e))[0]}function QR({mirror:n,choice:e}){let{grid:t,part:i}=Ge(()=>n.fields,[n]),s=Ge(()=>xn(()=>n.field(e.wave.value,e.line.value)),[n,e]),r=`${n.data.header.title}, ${Hi(n.data)}`,o=`displacement ${n.direction(e.wave.value,e.line.value)}; 1 is the largest in the first row`;return g(ln,{children:[g(pa,{grid:t,part:i,wave:s,pace:e,label:"Field of the wave, rows from left to right",shown:o,name:"wave",caption:r}),g(xo,{...e})]})}function eP({mirror:n,choice:e}){let[t,i]=[e.wave.value,e.line.value],s=c=>n.ofWaves(c)[t]?.[i]??NaN,[r,o]=[s("decay"),s("phase")],a=Number.isFinite(o),l=[["decay",`${Vt(r,s("decay_error"))} dB per row`],["phase",a?`${Vt(o,s("phase_error"))} π per row`:""],["shown displacement",n.hasFields?n.direction(t,i):""]];return g("div",{class:"facts",children:[g("p",{id:"wave","aria-live":"polite",children:["Wave ",t+1," of ",n.waves," in the lattice at ",g("b",{children:Lh({mirror:n,choice:e})}),":"," ",g("b",{children:a?"propagates":"decays"})]}),g(Ii,{facts:l})]})}function Lh({mirror:n,choice:e}){let t=e.unit.value;return kn(cs((n.frequency[e.line.value]??0)/t.factor),t)}function wp(n){return`${n} row${n===1?"":"s"}`}function py({colour:n}){return g("svg",{width:"34",height:"8","aria-hidden":"true",children:g("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--${n})`})})}function vy(n,e){return Number.isFinite(n)?`${Vt(n??NaN,e??NaN)} dB`:"does not propagate"}function tP({mirror:n,choice:e}){let[t,i,s]=[e.incident.value,e.line.value,e.rows.value],[r,o]=["loss","loss_error"].map(l=>n.losses(t,l)[s]?.[i]),a=n.rows[s]??0;return g("div",{class:"facts",children:[g("p",{id:"point","aria-live":"polite",children:[t," at ",g("b",{children:Lh({mirror:n,choice:e})}),", ",wp(a),": ",g("b",{children:vy(r,o)})]}),g("p",{class:"again",children:["The same as a picture, in Python: ",g("code",{children:['study.layers().plot("layers", incident="',t,'")']})]})]})}function nP({mirror:n,choice:e}){let t=e.line.value;return g("div",{class:"wide",children:g("table",{children:[g("caption",{children:["Insertion loss at ",Lh({mirror:n,choice:e})]}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"rows"}),n.incident.map(i=>g("th",{scope:"col",children:["incident ",i]}))]})}),g("tbody",{children:Array.from(n.rows,(i,s)=>g("tr",{"aria-current":s===e.rows.value?"true":void 0,children:[g("td",{children:i}),n.incident.map(r=>g("td",{children:vy(n.losses(r)[s]?.[t],n.losses(r,"loss_error")[s]?.[t])}))]}))})]})})}function iP({mirror:n,choice:e}){let t=e.line.value,i=["decay","decay_error","phase","phase_error"].map(s=>n.ofWaves(s));return g("div",{class:"wide",children:g("table",{children:[g("caption",{children:["Waves of the lattice at ",Lh({mirror:n,choice:e})]}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"decay / (dB/row)"}),g("th",{scope:"col",children:"phase per row / π"}),g("th",{scope:"col",children:"show"})]})}),g("tbody",{children:Array.from({length:n.waves},(s,r)=>{let[o=NaN,a=NaN,l=NaN,c=NaN]=i.map(u=>u[r]?.[t]);return g("tr",{"aria-current":r===e.wave.value?"true":void 0,children:[g("td",{children:Vt(o,a)}),g("td",{children:Number.isFinite(l)?Vt(l,c):"decays"}),g("td",{children:g("button",{type:"button",onClick:()=>e.wave.value=r,children:["wave ",r+1]})})]})})})]})})}var Ep=class{constructor(e,t,i,s,r,o,a){this.title=i;this.columns=s;this.rows=r;this.places=o;this.colours=a;this.real=e.values(`${t}_real`),this.imag=e.values(`${t}_imag`),this.step=e.values(`${t}_step`),this.count=e.shape(`${t}_real`).slice(1).reduce((l,c)=>l*c,1),this.largestStep=(a.length-1)/2}title;columns;rows;places;colours;largestStep;real;imag;step;count;largest(e){return(this.step[e]??0)*this.largestStep}paint(e,t,i,s){let r=s>0?this.largest(t)/s:0,[o,a]=[r*Math.cos(2*Math.PI*i),r*Math.sin(2*Math.PI*i)],l=this.largestStep,c=t*this.count;for(let u=0;u<this.rows;u++)for(let h=0;h<this.columns;h++){let f=this.places[u*this.columns+h]??-1,d=(this.real[c+f]??0)*o-(this.imag[c+f]??0)*a,p=Math.min(Math.max(Math.round(l+d),0),2*l),[y=0,_=0,m=0]=this.colours[p]??[],b=4*((this.rows-1-u)*this.columns+h);e.data[b]=y,e.data[b+1]=_,e.data[b+2]=m,e.data[b+3]=f<0?0:255}}outermost(e){let t=e*this.count,[i,s]=[0,-1];for(let r=t;r<t+this.count;r++){let o=Math.hypot(this.real[r]??0,this.imag[r]??0);o>s&&([i,s]=[r,o])}return-Math.atan2(this.imag[i]??0,this.real[i]??0)/(2*Math.PI)}},Dh=class{constructor(e){this.data=e;let{extra:t}=e.header;this.frequency=e.values("frequency"),this.gap=t.gap,this.carrier=t.carrier,this.drive=String(t.drive),this.firstIs=String(t.first_is),this.python=String(t.python),this.parts=t,this.colours=t.colours,this.units=Ci(e);let i=sP(e),[s=0,r=0]=e.shape(e.has("place")?"place":"present");this.fields=Object.entries(t.maps).map(([c,u])=>new Ep(e,c,u,r,s,i,this.colours));let o=e.has("mode_frequency"),[a,l]=o?[e.values("mode_frequency"),e.values("mode_quality")]:[[],[]];this.modes=Array.from(a,(c,u)=>({frequency:c,name:e.texts("mode_name")[u]??"",quality:l[u]??NaN}))}data;frequency;fields;gap;carrier;drive;firstIs;python;parts;modes;colours;units;covers(e,t=e){return(this.frequency[0]??1/0)<=t&&e<=(this.frequency[this.frequency.length-1]??-1/0)}nearest(e){let t=0;return this.frequency.forEach((i,s)=>{Math.abs(i-e)<Math.abs((this.frequency[t]??0)-e)&&(t=s)}),t}get first(){return this.nearest(Number(this.data.header.extra.first))}largest(e,t=this.fields){return Math.max(...t.map(i=>i.largest(e)))}get extent(){let[e,t]=[this.data.values("x"),this.data.values("y")],[i,s]=[yy(e),yy(t)];return{left:(e[0]??0)-i,right:(e[e.length-1]??0)+i,bottom:(t[0]??0)-s,top:(t[t.length-1]??0)+s}}has(e){return this.data.has(e)}curves(e){if(!this.data.has(e))return[];let t=this.data.values(e),i=this.data.texts(e==="level"?"region":"pair"),s=this.frequency.length;return i.map((r,o)=>({name:r,values:Array.from(t.subarray(o*s,(o+1)*s),a=>Number.isFinite(a)&&(e==="contrast"||a>0)?a:null)}))}};function sP(n){return n.has("place")?Int32Array.from(n.values("place")):Int32Array.from(n.values("present"),(e,t)=>e===0?-1:t)}function yy(n){return n.length>1?.5*((n[1]??0)-(n[0]??0)):5e-4}var Cl=[[],[8,4],[2,3],[10,3,2,3]],Ap=4,rP=300;function xy({plate:n,choice:e}){let t=Nt(null),i=e.shown.value;return Gi(()=>{if(t.current!==null)return oP(t.current,n,e)},[n,e,i]),g("div",{class:"curves",ref:t})}function oP(n,e,t){let i=t.shown.peek(),s=e.curves(i),r=e.data.unit(i),o=()=>t.unit.peek().factor,a=()=>[Array.from(e.frequency,u=>u/o()),...s.map(({values:u})=>u)],l=()=>({width:sr(n),height:rP}),c=new Qt({...l(),legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},scales:{x:{time:!1},y:{distr:i==="level"?3:1}},axes:[{...Rs(),label:"frequency",labelSize:22,size:34},{...ir(),label:Gt(e.data.title(i),{name:r,factor:1}),values:(u,h)=>h.map(f=>f===null?"":aP(f,i==="level"))}],series:[{},...s.map((u,h)=>({...Ps,stroke:()=>at(`curve-${h%Ap}`),dash:Cl[h%Cl.length]??[],width:1.4,points:{show:!1}}))],hooks:{drawClear:[u=>or(u,()=>lP(u,e,o()))],draw:[u=>cP(u,e,t)]}},a(),n);return Do(c,u=>t.line.value=e.nearest(o()*c.posToVal(u,"x"))),rr(c,n,l,[Et(()=>{let u=c.axes[0];u!==void 0&&(u.label=Gt("frequency",t.unit.value)),c.setData(a(),!0)}),Et(()=>{t.line.value,c.redraw(!1,!1)})])}function aP(n,e){if(!e)return bo(n);let t=Math.log10(n);return Math.abs(t-Math.round(t))<1e-9?Zl(Math.round(t)):""}function lP(n,e,t){e.gap!==null&&Gr(n,[e.gap[0]/t,e.gap[1]/t],"gap")}function cP(n,e,t){let{factor:i}=t.unit.peek();e.carrier!==null&&tr(n,e.carrier/i,"carrier",[7,5]),tr(n,(e.frequency[t.line.peek()]??0)/i,"accent")}var uP=10;function by(n){return{line:Xe(n.first),shown:Xe(n.has("level")?"level":"contrast"),plan:Xe(!1),common:Xe(!1),unit:Xe(Ri(n.units,Math.max(...n.frequency))),...fs(),listing:Xe("none")}}function Sy(n,e){let t=n.frequency.length-1,i=u=>e.line.value=Math.min(Math.max(e.line.value+u,0),t),s=u=>u.shiftKey?uP:1,r=n.modes.map(({frequency:u})=>n.nearest(u)).sort((u,h)=>u-h),o=u=>{u!==void 0&&(e.line.value=u)},{carrier:a}=n,l={keys:"p n",effect:"previous or next mode near the carrier",actions:{p:()=>o(r.filter(u=>u<e.line.value).pop()),n:()=>o(r.find(u=>u>e.line.value))}},c={keys:"s",effect:"one scale of colours for both maps, or one for each",actions:{s:()=>e.common.value=!e.common.value}};return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:u=>i(-s(u)),ArrowRight:u=>i(s(u))}},...r.length>0?[l]:[],...a!==null?[{keys:"c",effect:"carrier",actions:{c:()=>o(n.nearest(a))}}]:[],{keys:"g",effect:n.firstIs,actions:{g:()=>o(n.first)}},...n.fields.length>1?[c]:[],{keys:"l",effect:"pillars and supports",actions:{l:()=>e.plan.value=!e.plan.value}},us(e),...ni(e.listing)]}var hP="The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.",fP="Each point of the scan is a square of the map. Measurement and model move with the phase of the drive.",My=["level","contrast"];function wy(n){return g(Ey,{data:n,foot:hP})}function Ty(n){return g(Ey,{data:n,foot:fP})}function Ey({data:n,foot:e}){let t=Ge(()=>new Dh(n),[n]),i=Ge(()=>by(t),[t]),s=Ge(()=>Sy(t,i),[t,i]),r=My.filter(o=>t.has(o));return g(Jn,{name:"plate",data:n,keys:s,foot:e,children:[g("div",{class:t.fields.length>1?"":"pair",children:[g("section",{"aria-label":"Spectra",children:[r.length>0&&t.frequency.length>1&&g(ln,{children:[g(Vn,{label:"Spectra. Arrow keys change the frequency.",children:g(xy,{plate:t,choice:i})}),g(dP,{plate:t,choice:i}),g("p",{class:"axes",children:[g("label",{children:["Curves"," ",g("select",{value:i.shown.value,onChange:o=>i.shown.value=o.currentTarget.value,children:r.map(o=>g("option",{value:o,children:t.data.title(o)}))})]}),g(Pi,{title:"Frequencies in",units:t.units,unit:i.unit})]})]}),g(pP,{plate:t,choice:i})]}),g("section",{"aria-label":"Map",children:[g(ry,{plate:t,choice:i}),g("div",{class:"controls",children:[g(Nr,{playing:i.playing}),g(mP,{plate:t,choice:i}),g(Ua,{pace:i.pace}),g("label",{class:"check",children:[g("input",{type:"checkbox",checked:i.plan.value,onChange:o=>i.plan.value=o.currentTarget.checked}),"pillars and supports"]}),t.fields.length>1&&g("label",{class:"check",children:[g("input",{type:"checkbox",checked:i.common.value,onChange:o=>i.common.value=o.currentTarget.checked}),"one scale of colours for both maps"]})]})]})]}),g(ii,{listing:i.listing,keys:s,children:[g(gP,{plate:t,choice:i}),g(_P,{plate:t,choice:i})]})]})}function dP({plate:n,choice:e}){return g("p",{class:"legend",children:[n.curves(e.shown.value).map(({name:t},i)=>g("span",{class:"of-curve",children:[g("svg",{width:"34",height:"8","aria-hidden":"true",children:g("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${i%Ap})`,"stroke-dasharray":(Cl[i%Cl.length]??[]).join(" ")})})," ",t]})),n.gap!==null&&n.covers(...n.gap)&&g("span",{class:"of-gap",children:"gap"}),n.carrier!==null&&n.covers(n.carrier)&&g("span",{class:"of-carrier",children:"carrier"})]})}function ga(n,e){return kn(cs(n/e.factor),e)}function pP({plate:n,choice:e}){let t=e.line.value,i=n.frequency[t]??0,s=n.curves("contrast");return g("div",{class:"facts",children:[g("p",{id:"point","aria-live":"polite",children:[g("b",{children:ga(i,e.unit.value)}),": up to ",no(n.largest(t)),n.drive,s.map(({name:r,values:o})=>`; ${r} ${Vi(o[t]?.toFixed(1)??"-")} dB`).join("")]}),g("p",{class:"again",children:["The same map as a picture, in Python: ",g("code",{children:`${n.python}.plot("maps", frequency=${Number(i.toFixed(3))})`})]})]})}function mP({plate:n,choice:e}){let t=n.frequency.length-1,i=e.line.value;return g("label",{class:"long",children:["frequency: ",ga(n.frequency[i]??0,e.unit.value),g("input",{type:"range",min:"0",max:t,step:"1",value:i,disabled:t===0,"aria-valuetext":ga(n.frequency[i]??0,e.unit.value),onInput:s=>e.line.value=Number(s.currentTarget.value)})]})}function gP({plate:n,choice:e}){let t=e.line.value,i=My.flatMap(s=>n.curves(s).map(({name:r,values:o})=>[n.data.title(s),r,`${Vi(o[t]?.toPrecision(3)??"-")} ${n.data.unit(s)}`]));for(let s of n.fields.length>1?n.fields:[])i.push(["largest displacement",s.title,`${no(s.largest(t))}${n.drive}`]);return n.data.has("agreement")&&i.push([n.data.title("agreement"),"both maps",(n.data.values("agreement")[t]??0).toFixed(3)]),g("div",{class:"wide",children:g("table",{children:[g("caption",{children:["Regions at ",ga(n.frequency[t]??0,e.unit.value)]}),g("tbody",{children:i.map(s=>g("tr",{children:s.map(r=>g("td",{children:r}))}))})]})})}function _P({plate:n,choice:e}){return n.modes.length===0?null:g("div",{class:"wide",children:g("table",{children:[g("caption",{children:"Modes near the carrier"}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"frequency"}),g("th",{scope:"col",children:"nodal lines"}),g("th",{scope:"col",children:"Q"}),g("th",{scope:"col",children:"show"})]})}),g("tbody",{children:n.modes.map(({frequency:t,name:i,quality:s})=>g("tr",{children:[g("td",{children:ga(t,e.unit.value)}),g("td",{children:i}),g("td",{children:s.toFixed(0)}),g("td",{children:g("button",{type:"button",onClick:()=>e.line.value=n.nearest(t),children:ga(n.frequency[n.nearest(t)]??0,e.unit.value)})})]}))})]})})}function Ry({points:n,drawing:e}){let t=e?.plate.flat()??[],[i,s,r,o]=Cp([...n,...t]),a=Math.max(s-i,o-r,1e-6),[l,c]=[.06*a,.045*a],u=[i-l,-o-l,s-i+2*l,o-r+2*l],[h,f]=[n[0],n.at(-1)];return g("svg",{class:"points",viewBox:u.map(d=>1e3*d).join(" "),role:"img","aria-label":vP(n,e),children:[e!==null&&g(ln,{children:[g("path",{d:e.plate.map(Cy).join(""),class:"plate"}),g("path",{d:Object.values(e.regions).flat().map(Cy).join(""),class:"region"})]}),g("path",{d:n.map(([d,p])=>`M${li(d)} ${li(-p)}h1e-4`).join(""),class:"places"}),h!==void 0&&g("path",{d:`M${li(h[0])} ${li(-h[1])}h1e-4`,class:"first"}),g("g",{"font-size":1e3*c,children:[Object.entries(e?.regions??{}).map(([d,p])=>{let[y,_,,m]=Cp(p.flat());return g("text",{x:li((y+_)/2),y:li(1.2*c-m),"text-anchor":"middle",children:d})}),h!==void 0&&g(Ay,{at:h,letter:c,words:"1"}),f!==void 0&&n.length>1&&g(Ay,{at:f,letter:c,words:`${n.length}`}),g("text",{x:li(s+l),y:li(-r+.9*l),"text-anchor":"end",class:"quiet",children:"x →"}),g("text",{x:li(i-.9*l),y:li(-o-.2*l),class:"quiet",children:"y ↑"})]})]})}function Ay({at:[n,e],letter:t,words:i}){return g("text",{x:li(n+.3*t),y:li(-e-.3*t),class:"number",children:i})}var li=n=>Number((1e3*n).toFixed(4)),Cy=n=>`M${n.map(([e,t])=>`${li(e)} ${li(-t)}`).join("L")}Z`;function Cp(n){let[e,t,i,s]=[1/0,-1/0,1/0,-1/0];for(let[r,o]of n)[e,t]=[Math.min(e,r),Math.max(t,r)],[i,s]=[Math.min(i,o),Math.max(s,o)];return[e,t,i,s]}function vP(n,e){let[t,i,s,r]=Cp(n),o=(l,c)=>`${Number((1e3*l).toPrecision(4))} to ${Number((1e3*c).toPrecision(4))} mm`,a=e===null?"":" over the outline of the plate";return`${n.length} points${a}: x from ${o(t,i)}, y from ${o(s,r)}`}var yP=260,Nh=[[],[8,4]];function Py(n){return g(xP,{data:n})}function xP({data:n}){let{points:e,drawing:t,curves:i,unit:s,axis:r,names:o,title:a}=Ge(()=>bP(n),[n]),l=n.values(r),c=Ge(()=>Array.from(l,u=>u/s.factor),[n]);return g("div",{class:"reading",children:[e.length>0&&g(Ry,{points:e,drawing:t}),c.length>1&&g("div",{children:[g(ts,{x:c,curves:i,titles:[Gt(n.title(r),s),a],height:yP}),o.length>1&&g("p",{class:"legend",children:o.map((u,h)=>g("span",{class:"of-curve",children:[g("svg",{width:"34",height:"8","aria-hidden":"true",children:g("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${h})`,"stroke-dasharray":(Nh[h%Nh.length]??[]).join(" ")})})," ",n.title(u)]}))})]})]})}function bP(n){let{extra:e,variables:t}=n.header,i=String(e.axis),s=Object.keys(t).filter(d=>d!==i&&t[d]?.dims[0]===i),r=s.flatMap(d=>Array.from(n.values(d),Math.abs)).filter(Number.isFinite),o=Lm(n.unit(s[0]??i),r.reduce((d,p)=>Math.max(d,p),0)),a=s.map((d,p)=>({values:Array.from(n.values(d),y=>Number.isFinite(y)?y/o.factor:null),colour:`curve-${p}`,dash:Nh[p%Nh.length]??[]})),l=n.has("y")?n.values("y"):[],c=n.has("x")?Array.from(n.values("x"),(d,p)=>[d,l[p]??0]):[],u={name:n.unit(i),factor:1},h=u.name==="Hz"?Ri(Ci(n),Math.max(...n.values(i))):u,f=Gt(s.length===1?n.title(s[0]??i):"force",o);return{points:c,drawing:e.drawing,curves:a,unit:h,axis:i,names:s,title:f}}var SP=40,MP=.42;function Iy({ribbon:n,choice:e}){let[t,i]=[e.unit.value,e.wavevectorUnit.value],s=e.mode.value,r=Ge(()=>Array.from(n.phases,l=>l/n.period/i.factor),[n,i]),o=Ge(()=>{let[l,c]=n.range;return{x:[0,Math.PI/n.period/i.factor],y:[l/t.factor,c/t.factor]}},[n,i,t]),a=(l,c,u=!1)=>[l.valToPos(n.wavevector(c)/i.factor,"x",u),l.valToPos(n.at(c)/t.factor,"y",u)];return g(ts,{x:r,curves:wP,titles:[Gt("wavevector along the ribbon",i),Gt("frequency",t)],height:420,limits:o,below:l=>TP(l,n,r,t.factor),above:l=>{EP(l,n,t.factor,i.factor),n.carrier!==null&&Lo(l,n.carrier/t.factor,"carrier",[7,5]),Cs(l.ctx,a(l,s,!0),"accent")},pick:(l,c,u)=>{let[h,f]=[u.valToPos(l,"x"),u.valToPos(c,"y")],d=y=>Math.hypot(a(u,y)[0]-h,a(u,y)[1]-f),p=n.all.reduce((y,_)=>d(_)<d(y)?_:y,0);d(p)<SP&&(e.mode.value=p)}})}var wP=[];function TP(n,e,t,i){let{ctx:s}=n;s.save(),s.globalAlpha=.4;for(let{crystal:r,lower:o,upper:a}of e.bulk()){s.fillStyle=at(r===0?"rule":`curve-${r}`),s.beginPath();let l=(c,u)=>s.lineTo(n.valToPos(t[u]??0,"x",!0),n.valToPos((c[u]??0)/i,"y",!0));t.forEach((c,u)=>l(a,u)),t.forEach((c,u)=>l(o,t.length-1-u)),s.fill()}s.restore()}function EP(n,e,t,i){let{ctx:s}=n,r=e.phases.length>1?(e.phases[1]??0)-(e.phases[0]??0):.1,o=MP*r/e.period;s.save();for(let a of e.all){let l=(e.velocity[a]??0)*o/(2*Math.PI),c=h=>[n.valToPos((e.wavevector(a)+h*o)/i,"x",!0),n.valToPos((e.at(a)+h*l)/t,"y",!0)],u=e.share[a]??0;s.strokeStyle=Rp(e.shares,u),s.lineWidth=(e.isGuided(a)?3:1.4)*devicePixelRatio,s.beginPath(),s.moveTo(...c(-1)),s.lineTo(...c(1)),s.stroke()}s.restore()}function Rp(n,e){let t=matchMedia("(prefers-color-scheme: dark)").matches?e:1-e;return`rgb(${(n[Math.round(Math.min(Math.max(t,0),1)*(n.length-1))]??[]).join(" ")})`}var AP=1.6,CP=30,RP=["across the ribbon","along the ribbon","normal to the plate"],Uh=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),this.phase=e.values("phase"),this.velocity=e.values("group_velocity"),this.share=e.values("guide_share"),this.phases=e.values("wavevector_phase"),this.period=Number(i.period),this.range=t.range,this.carrier=t.carrier,this.place=i.kind==="strip"?"the outermost columns":`the ${i.kind}`,this.units=Ci(e),this.wavevectorUnits=yo(this.period),this.shares=t.shares,this.atPhase=Array.from(this.phases,s=>this.all.filter(r=>this.phase[r]===s).sort((r,o)=>this.at(r)-this.at(o)))}data;frequency;error;phase;velocity;share;phases;period;range;carrier;place;units;wavevectorUnits;shares;atPhase;get all(){return Array.from(this.frequency,(e,t)=>t)}get hasFields(){return this.data.has("mode_real")}get fields(){let{data:e,period:t}=this,[,i=0,s=0]=e.shape("mode_real"),r=e.values("across"),o=((r[1]??0)-(r[0]??0))*i;return{grid:{...{real:e.values("mode_real"),imag:e.values("mode_imag"),present:e.values("present")},across:i,along:s,width:o,length:t,colours:e.header.extra.colours},part:{periods:Math.min(CP,Math.max(2,Math.round(AP*o/t)))}}}wave(e){return{number:e,phase:this.phase[e]??0,decay:0}}at(e){return this.frequency[e]??NaN}wavevector(e){return(this.phase[e]??0)/this.period}isGuided(e){return this.data.values("guided")[e]===1}decay(e){let[t,i]=["decay","decay_error"].map(s=>this.data.values(s)[e]??NaN);return Number.isFinite(t)?Vt(t,i):""}speed(e){return Vt(this.velocity[e]??NaN,this.data.values("group_velocity_error")[e]??NaN)}direction(e){return RP[this.data.values("mode_component")[e]??2]??""}get first(){let[e,t]=this.range,i=this.carrier!==null&&this.carrier>e&&this.carrier<t?this.carrier:(e+t)/2,s=this.all.filter(r=>this.isGuided(r));return Ly(s.length>0?s:this.all,r=>this.at(r),i)}beside(e){return this.atPhase[this.row(e)]??[]}moved(e,t,i){let s=this.beside(e);if(i!==0)return s[Math.min(Math.max(s.indexOf(e)+i,0),s.length-1)]??e;let r=this.atPhase.map((a,l)=>l).filter(a=>(this.atPhase[a]??[]).length>0),o=Math.min(Math.max(r.indexOf(this.row(e))+t,0),r.length-1);return Ly(this.atPhase[r[o]??0]??[],a=>this.at(a),this.at(e))}get guided(){return this.atPhase.flat().filter(e=>this.isGuided(e))}bulk(){let[e=0,t=0,i=0]=this.data.shape("bulk_lower"),[s,r]=[this.data.values("bulk_lower"),this.data.values("bulk_upper")];return Array.from({length:e*i},(o,a)=>{let[l,c]=[Math.floor(a/i),a%i],u=h=>Array.from({length:t},(f,d)=>h[(l*t+d)*i+c]??NaN);return{crystal:l,lower:u(s),upper:u(r)}})}row(e){return Array.from(this.phases).indexOf(this.phase[e]??NaN)}};function Ly(n,e,t){return n.reduce((i,s)=>Math.abs(e(s)-t)<Math.abs(e(i)-t)?s:i,n[0]??0)}var Dy="Errors of frequencies bound the distance to the exact ones of the model, those of velocity and decay are estimates. The field is that of the strongest component on the flat face, relative to its largest displacement.",PP="Fields of the modes are computed with the option --html.";function Ny(n){return g(IP,{data:n})}function IP({data:n}){let e=Ge(()=>new Uh(n),[n]),t=Ge(()=>({mode:Xe(e.first),unit:Xe(Ri(e.units,e.range[1])),wavevectorUnit:Xe(e.wavevectorUnits[1]),...fs(),listing:Xe("none")}),[e]),i=Ge(()=>LP(e,t),[e,t]);return e.all.length===0?g(Jn,{name:"ribbon",data:n,keys:[],foot:Dy,children:null}):g(Jn,{name:"ribbon",data:n,keys:i,foot:Dy,children:[g("div",{class:"pair",children:[g("section",{"aria-label":"Projected bands",children:[g(Vn,{label:"Projected bands. Arrow keys move between wavevectors and modes.",children:g(Iy,{ribbon:e,choice:t})}),g("p",{class:"axes",children:[g(Pi,{title:"Frequencies in",units:e.units,unit:t.unit}),g(Pi,{title:"Wavevectors in",units:e.wavevectorUnits,unit:t.wavevectorUnit})]}),g(NP,{ribbon:e})]}),g("section",{"aria-label":"Mode",children:[e.hasFields?g(DP,{ribbon:e,choice:t}):g("p",{children:PP}),g(UP,{ribbon:e,choice:t}),e.hasFields&&g(xo,{...t})]})]}),g(ii,{listing:t.listing,keys:i,children:g(FP,{ribbon:e,choice:t})})]})}function LP(n,e){let t=(s,r)=>e.mode.value=n.moved(e.mode.value,s,r),i=s=>{let{guided:r}=n;if(r.length===0)return;let o=r.indexOf(e.mode.value);e.mode.value=r[(o+s+r.length)%r.length]??e.mode.value};return[{keys:"← →",effect:"mode of about this frequency at the previous or next wavevector",actions:{ArrowLeft:()=>t(-1,0),ArrowRight:()=>t(1,0)}},{keys:"↑ ↓",effect:"next higher or lower mode at this wavevector",actions:{ArrowUp:()=>t(0,1),ArrowDown:()=>t(0,-1)}},{keys:"p n",effect:"previous or next guided mode",actions:{p:()=>i(-1),n:()=>i(1)}},us(e),...ni(e.listing)]}function DP({ribbon:n,choice:e}){let{grid:t,part:i}=Ge(()=>n.fields,[n]),s=Ge(()=>xn(()=>n.wave(e.mode.value)),[n,e]),r=`${n.data.header.title}, ${Hi(n.data)}`,o=`displacement ${n.direction(e.mode.value)}; 1 is the largest`;return g(pa,{grid:t,part:i,wave:s,pace:e,label:"Field of the mode",shown:o,name:"ribbon",caption:r})}function NP({ribbon:n}){let[,e]=js(0);fn(()=>si(()=>e(i=>i+1)),[]);let t=[0,.25,.5,.75,1].map(i=>Rp(n.shares,i));return g("p",{class:"scale legend",children:[g("span",{class:"plain",children:"0 %"}),g("span",{class:"bar",style:{background:`linear-gradient(to right, ${t.join(", ")})`}}),g("span",{class:"plain",children:"100 %"}),g("span",{class:"plain",children:["of the energy in ",n.place,"; guided modes are thick; shaded: bulk bands"]}),n.carrier!==null&&g("span",{class:"of-carrier",children:"carrier"})]})}function Uy(n,e,{factor:t,name:i}){return`${Number((n.wavevector(e)/t).toPrecision(4))} ${i}`}function Fy(n){return`${(100*(n??NaN)).toFixed(1)} %`}function Oy(n,e,{factor:t}){return Vt(n.at(e)/t,(n.error[e]??NaN)/t)}function UP({ribbon:n,choice:e}){let[t,i,s]=[e.mode.value,e.unit.value,e.wavevectorUnit.value],r=n.decay(t),o=[["group velocity",`${n.speed(t)} m/s`],[`energy in ${n.place}`,Fy(n.share[t])],["decay",r&&`${r} dB per row`],["shown displacement",n.hasFields?n.direction(t):""]];return g("div",{class:"facts",children:[g("p",{id:"point","aria-live":"polite",children:[n.isGuided(t)?"Guided mode":"Mode"," at ",Uy(n,t,s),":"," ",g("b",{children:kn(Oy(n,t,i),i)})]}),g(Ii,{facts:o})]})}function FP({ribbon:n,choice:e}){let[t,i,s]=[e.mode.value,e.unit.value,e.wavevectorUnit.value];return g("div",{class:"wide",children:g("table",{children:[g("caption",{children:["Modes at ",Uy(n,t,s)]}),g("thead",{children:g("tr",{children:[Gt("frequency",i),"guided",`energy in ${n.place}`,"decay / (dB/row)","show"].map(r=>g("th",{scope:"col",children:r}))})}),g("tbody",{children:n.beside(t).map(r=>g("tr",{"aria-current":r===t?"true":void 0,children:[g("td",{children:Oy(n,r,i)}),g("td",{children:n.isGuided(r)?"yes":"no"}),g("td",{children:Fy(n.share[r])}),g("td",{children:n.decay(r)||"-"}),g("td",{children:g("button",{type:"button",onClick:()=>e.mode.value=r,children:kn(cs(n.at(r)/i.factor),i)})})]}))})]})})}var By='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var ky=`& {
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
.legend :is(.of-curve, .plain, .bar)::before { display: none; }
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
.reading { display: grid; gap: 0.75rem; grid-template-columns: repeat(auto-fit, minmax(min(18rem, 100%), 1fr)); align-items: start; }
.points { width: 100%; max-height: 22rem; background: var(--panel); border: 1px solid var(--rule); border-radius: 0.3rem; }
.points path { fill: none; stroke: var(--quiet); stroke-width: 1.5px; vector-effect: non-scaling-stroke; }
.points .region { stroke: var(--curve-1); }
.points .places { stroke: var(--accent); stroke-width: 4px; stroke-linecap: round; }
.points .first { stroke: var(--carrier); stroke-width: 9px; stroke-linecap: round; }
.points text { fill: var(--ink); paint-order: stroke; stroke: var(--panel); stroke-width: 3px; vector-effect: non-scaling-stroke; }
.points .number { font-weight: 700; }
.maps { display: grid; gap: 0.5rem 1rem; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr)); }
.maps h2 { font-size: 1rem; margin: 0.2rem 0; }
.estimates { width: 100%; max-width: 60rem; display: block; }
.estimates text { fill: var(--ink); font-size: 13px; }
.estimates .quiet { fill: var(--quiet); }
.estimates line { stroke: var(--rule); }
.estimates .interval { stroke: var(--curve-0); stroke-width: 2; }
.estimates circle { fill: var(--curve-0); }
.estimates .whole .interval { stroke: var(--curve-1); stroke-width: 4; }
.estimates .mark { fill: var(--curve-1); }
.estimates .whole text { font-weight: 700; }
.estimates .trial { fill: none; stroke: var(--quiet); }
.friction td:last-child { min-width: 14rem; }
.estimates .chosen { fill: var(--panel); stroke: var(--accent); }
`;var kP={bands:Yv,layers:my,plate:wy,scan:Ty,finger:cy,ribbon:Ny,friction:hy,reading:Py,guides:$v};function Pp(n,e,t){let i=kP[n.header.kind];if(i===void 0)throw new Error(`this version has no view "${n.header.kind}"`);return zP(),e.classList.add("haptonic","view"),nf(i(n,t),e),()=>nf(null,e)}function zP(){if(document.getElementById("haptonic-style")!==null)return;let n=document.createElement("style");n.id="haptonic-style",n.textContent=`${By}:where(.haptonic) { ${ky} }`,document.head.append(n)}async function GP({model:n,el:e}){e.dataset.lmSuppressShortcuts="true";let{buffer:t,byteOffset:i,byteLength:s}=n.get("data");return Pp(Ta.read(await Xh(new Uint8Array(t,i,s))),e)}async function zy(n){let e=document.getElementById(n.dataset.view??"")?.textContent??"";try{let t=Uint8Array.from(atob(e.trim()),s=>s.charCodeAt(0)),i=Ta.read(await Xh(t));return n.replaceChildren(),Pp(i,n)}catch(t){let i=document.createElement("p");return i.textContent=`The view cannot be shown: ${t instanceof Error?t.message:String(t)}`,n.replaceChildren(i),()=>{}}}var Rl=null;function VP(n,e){let t=document.createElement("button"),i=document.createElement("div");t.type="button";let s=null,r=()=>{s?.(),i.remove(),t.textContent=e,t.ariaExpanded="false",[Rl,s]=[null,null]};t.addEventListener("click",async()=>{let o=Rl===r;if(Rl?.(),o)return;Rl=r,t.textContent="Close the view",t.ariaExpanded="true",n.append(i),i.dataset.view=n.dataset.view??"";let a=await zy(i);Rl===r?s=a:a()}),r(),n.append(t)}for(let n of document.querySelectorAll("[data-view]")){let e=n.dataset.opens;e===void 0?zy(n):VP(n,e)}var kB={render:GP};export{kB as default};
