var Ay=Object.create;var Lp=Object.defineProperty;var Cy=Object.getOwnPropertyDescriptor;var Ry=Object.getOwnPropertyNames;var Py=Object.getPrototypeOf,Iy=Object.prototype.hasOwnProperty;var Ly=(n,e)=>()=>{try{return e||n((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var Dy=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Ry(e))!Iy.call(n,s)&&s!==t&&Lp(n,s,{get:()=>e[s],enumerable:!(i=Cy(e,s))||i.enumerable});return n};var Ny=(n,e,t)=>(t=n!=null?Ay(Py(n)):{},Dy(e||!n||!n.__esModule?Lp(t,"default",{value:n,enumerable:!0}):t,n));var f_=Ly(Nf=>{var i_=Object.defineProperty,yS=n=>i_(n,"__esModule",{value:!0}),xS=(n,e)=>{for(var t in e)i_(n,t,{get:e[t],enumerable:!0})};yS(Nf);xS(Nf,{GIFEncoder:()=>u_,applyPalette:()=>RS,default:()=>kS,nearestColor:()=>DS,nearestColorIndex:()=>l_,nearestColorIndexWithDistance:()=>c_,prequantize:()=>CS,quantize:()=>ES,snapColorsToPalette:()=>LS});var bS={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};function s_(n=256){let e=0,t=new Uint8Array(n);return{get buffer(){return t.buffer},reset(){e=0},bytesView(){return t.subarray(0,e)},bytes(){return t.slice(0,e)},writeByte(s){i(e+1),t[e]=s,e++},writeBytes(s,r=0,o=s.length){i(e+o);for(let a=0;a<o;a++)t[e++]=s[a+r]},writeBytesView(s,r=0,o=s.byteLength){i(e+o),t.set(s.subarray(r,r+o),e),e+=o}};function i(s){var r=t.length;if(r>=s)return;var o=1024*1024;s=Math.max(s,r*(r<o?2:1.125)>>>0),r!=0&&(s=Math.max(s,256));let a=t;t=new Uint8Array(s),e>0&&t.set(a.subarray(0,e),0)}}var If=12,e_=5003,SS=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function MS(n,e,t,i,s=s_(512),r=new Uint8Array(256),o=new Int32Array(e_),a=new Int32Array(e_)){let l=o.length,c=Math.max(2,i);r.fill(0),a.fill(0),o.fill(-1);let u=0,f=0,h=c+1,d=h,p=!1,y=d,g=(1<<y)-1,m=1<<h-1,b=m+1,A=m+2,S=0,P=t[0],C=0;for(let B=l;B<65536;B*=2)++C;C=8-C,s.writeByte(c),E(m);let v=t.length;for(let B=1;B<v;B++)e:{let N=t[B],L=(N<<If)+P,k=N<<C^P;if(o[k]===L){P=a[k];break e}let z=k===0?1:l-k;for(;o[k]>=0;)if(k-=z,k<0&&(k+=l),o[k]===L){P=a[k];break e}E(P),P=N,A<1<<If?(a[k]=A++,o[k]=L):(o.fill(-1),A=m+2,p=!0,E(m))}return E(P),E(b),s.writeByte(0),s.bytesView();function E(B){for(u&=SS[f],f>0?u|=B<<f:u=B,f+=y;f>=8;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,f-=8;if((A>g||p)&&(p?(y=d,g=(1<<y)-1,p=!1):(++y,g=y===If?1<<y:(1<<y)-1)),B==b){for(;f>0;)r[S++]=u&255,S>=254&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0),u>>=8,f-=8;S>0&&(s.writeByte(S),s.writeBytesView(r,0,S),S=0)}}}var wS=MS;function r_(n,e,t){return n<<8&63488|e<<2&992|t>>3}function o_(n,e,t,i){return n>>4|e&240|(t&240)<<4|(i&240)<<8}function a_(n,e,t){return n>>4<<8|e&240|t>>4}function rc(n,e,t){return n<e?e:n>t?t:n}function Pa(n){return n*n}function t_(n,e,t){var i=0,s=1e100;let r=n[e],o=r.cnt,a=r.ac,l=r.rc,c=r.gc,u=r.bc;for(var f=r.fw;f!=0;f=n[f].fw){let d=n[f],p=d.cnt,y=o*p/(o+p);if(!(y>=s)){var h=0;t&&(h+=y*Pa(d.ac-a),h>=s)||(h+=y*Pa(d.rc-l),!(h>=s)&&(h+=y*Pa(d.gc-c),!(h>=s)&&(h+=y*Pa(d.bc-u),!(h>=s)&&(s=h,i=f))))}}r.err=s,r.nn=i}function Lf(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function TS(n,e){let t=e==="rgb444"?4096:65536,i=new Array(t),s=n.length;if(e==="rgba4444")for(let r=0;r<s;++r){let o=n[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255,f=o_(u,c,l,a),h=f in i?i[f]:i[f]=Lf();h.rc+=u,h.gc+=c,h.bc+=l,h.ac+=a,h.cnt++}else if(e==="rgb444")for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=a_(c,l,a),f=u in i?i[u]:i[u]=Lf();f.rc+=c,f.gc+=l,f.bc+=a,f.cnt++}else for(let r=0;r<s;++r){let o=n[r],a=o>>16&255,l=o>>8&255,c=o&255,u=r_(c,l,a),f=u in i?i[u]:i[u]=Lf();f.rc+=c,f.gc+=l,f.bc+=a,f.cnt++}return i}function ES(n,e,t={}){let{format:i="rgb565",clearAlpha:s=!0,clearAlphaColor:r=0,clearAlphaThreshold:o=0,oneBitAlpha:a=!1}=t;if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(n.buffer),c=t.useSqrt!==!1,u=i==="rgba4444",f=TS(l,i),h=f.length,d=h-1,p=new Uint32Array(h+1);for(var y=0,m=0;m<h;++m){let H=f[m];if(H!=null){var g=1/H.cnt;u&&(H.ac*=g),H.rc*=g,H.gc*=g,H.bc*=g,f[y++]=H}}Pa(e)/y<.022&&(c=!1);for(var m=0;m<y-1;++m)f[m].fw=m+1,f[m+1].bk=m,c&&(f[m].cnt=Math.sqrt(f[m].cnt));c&&(f[m].cnt=Math.sqrt(f[m].cnt));var b,A,S;for(m=0;m<y;++m){t_(f,m,!1);var P=f[m].err;for(A=++p[0];A>1&&(S=A>>1,!(f[b=p[S]].err<=P));A=S)p[A]=b;p[A]=m}var C=y-e;for(m=0;m<C;){for(var v;;){var E=p[1];if(v=f[E],v.tm>=v.mtm&&f[v.nn].mtm<=v.tm)break;v.mtm==d?E=p[1]=p[p[0]--]:(t_(f,E,!1),v.tm=m);var P=f[E].err;for(A=1;(S=A+A)<=p[0]&&(S<p[0]&&f[p[S]].err>f[p[S+1]].err&&S++,!(P<=f[b=p[S]].err));A=S)p[A]=b;p[A]=E}var B=f[v.nn],N=v.cnt,L=B.cnt,g=1/(N+L);u&&(v.ac=g*(N*v.ac+L*B.ac)),v.rc=g*(N*v.rc+L*B.rc),v.gc=g*(N*v.gc+L*B.gc),v.bc=g*(N*v.bc+L*B.bc),v.cnt+=B.cnt,v.mtm=++m,f[B.bk].fw=B.fw,f[B.fw].bk=B.bk,B.mtm=d}let k=[];var z=0;for(m=0;;++z){let U=rc(Math.round(f[m].rc),0,255),H=rc(Math.round(f[m].gc),0,255),$=rc(Math.round(f[m].bc),0,255),G=255;u&&(G=rc(Math.round(f[m].ac),0,255),a&&(G=G<=(typeof a=="number"?a:127)?0:255),s&&G<=o&&(U=H=$=r,G=0));let le=u?[U,H,$,G]:[U,H,$];if(AS(k,le)||k.push(le),(m=f[m].fw)==0)break}return k}function AS(n,e){for(let t=0;t<n.length;t++){let i=n[t],s=i[0]===e[0]&&i[1]===e[1]&&i[2]===e[2],r=i.length>=4&&e.length>=4?i[3]===e[3]:!0;if(s&&r)return!0}return!1}function ac(n,e){var t=0,i;for(i=0;i<n.length;i++){let s=n[i]-e[i];t+=s*s}return t}function oc(n,e){return e>1?Math.round(n/e)*e:n}function CS(n,{roundRGB:e=5,roundAlpha:t=10,oneBitAlpha:i=null}={}){let s=new Uint32Array(n.buffer);for(let r=0;r<s.length;r++){let o=s[r],a=o>>24&255,l=o>>16&255,c=o>>8&255,u=o&255;a=oc(a,t),i&&(a=a<=(typeof i=="number"?i:127)?0:255),u=oc(u,e),c=oc(c,e),l=oc(l,e),s[r]=a<<24|l<<16|c<<8|u<<0}}function RS(n,e,t="rgb565"){if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let i=new Uint32Array(n.buffer),s=i.length,r=t==="rgb444"?4096:65536,o=new Uint8Array(s),a=new Array(r),l=t==="rgba4444";if(t==="rgba4444")for(let c=0;c<s;c++){let u=i[c],f=u>>24&255,h=u>>16&255,d=u>>8&255,p=u&255,y=o_(p,d,h,f),g=y in a?a[y]:a[y]=PS(p,d,h,f,e);o[c]=g}else{let c=t==="rgb444"?a_:r_;for(let u=0;u<s;u++){let f=i[u],h=f>>16&255,d=f>>8&255,p=f&255,y=c(p,d,h),g=y in a?a[y]:a[y]=IS(p,d,h,e);o[u]=g}}return o}function PS(n,e,t,i,s){let r=0,o=1e100;for(let a=0;a<s.length;a++){let l=s[a],c=l[3],u=Pr(c-i);if(u>o)continue;let f=l[0];if(u+=Pr(f-n),u>o)continue;let h=l[1];if(u+=Pr(h-e),u>o)continue;let d=l[2];u+=Pr(d-t),!(u>o)&&(o=u,r=a)}return r}function IS(n,e,t,i){let s=0,r=1e100;for(let o=0;o<i.length;o++){let a=i[o],l=a[0],c=Pr(l-n);if(c>r)continue;let u=a[1];if(c+=Pr(u-e),c>r)continue;let f=a[2];c+=Pr(f-t),!(c>r)&&(r=c,s=o)}return s}function LS(n,e,t=5){if(!n.length||!e.length)return;let i=n.map(o=>o.slice(0,3)),s=t*t,r=n[0].length;for(let o=0;o<e.length;o++){let a=e[o];a.length<r?a=[a[0],a[1],a[2],255]:a.length>r?a=a.slice(0,3):a=a.slice();let l=c_(i,a.slice(0,3),ac),c=l[0],u=l[1];u>0&&u<=s&&(n[c]=a)}}function Pr(n){return n*n}function l_(n,e,t=ac){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return s}function c_(n,e,t=ac){let i=1/0,s=-1;for(let r=0;r<n.length;r++){let o=n[r],a=t(e,o);a<i&&(i=a,s=r)}return[s,i]}function DS(n,e,t=ac){return n[l_(n,e,t)]}function u_(n={}){let{initialCapacity:e=4096,auto:t=!0}=n,i=s_(e),s=5003,r=new Uint8Array(256),o=new Int32Array(s),a=new Int32Array(s),l=!1;return{reset(){i.reset(),l=!1},finish(){i.writeByte(bS.trailer)},bytes(){return i.bytes()},bytesView(){return i.bytesView()},get buffer(){return i.buffer},get stream(){return i},writeHeader:c,writeFrame(u,f,h,d={}){let{transparent:p=!1,transparentIndex:y=0,delay:g=0,palette:m=null,repeat:b=0,colorDepth:A=8,dispose:S=-1}=d,P=!1;if(t?l||(P=!0,c(),l=!0):P=!!d.first,f=Math.max(0,Math.floor(f)),h=Math.max(0,Math.floor(h)),P){if(!m)throw new Error("First frame must include a { palette } option");US(i,f,h,m,A),n_(i,m),b>=0&&FS(i,b)}let C=Math.round(g/10);NS(i,S,C,p,y);let v=!!m&&!P;OS(i,f,h,v?m:null),v&&n_(i,m),BS(i,u,f,h,A,r,o,a)}};function c(){h_(i,"GIF89a")}}function NS(n,e,t,i,s){n.writeByte(33),n.writeByte(249),n.writeByte(4),s<0&&(s=0,i=!1);var r,o;i?(r=1,o=2):(r=0,o=0),e>=0&&(o=e&7),o<<=2,n.writeByte(0|o|0|r),js(n,t),n.writeByte(s||0),n.writeByte(0)}function US(n,e,t,i,s=8){let a=Df(i.length)-1,l=128|s-1<<4|0|a,c=0,u=0;js(n,e),js(n,t),n.writeBytes([l,c,u])}function FS(n,e){n.writeByte(33),n.writeByte(255),n.writeByte(11),h_(n,"NETSCAPE2.0"),n.writeByte(3),n.writeByte(1),js(n,e),n.writeByte(0)}function n_(n,e){let t=1<<Df(e.length);for(let i=0;i<t;i++){let s=[0,0,0];i<e.length&&(s=e[i]),n.writeByte(s[0]),n.writeByte(s[1]),n.writeByte(s[2])}}function OS(n,e,t,i){if(n.writeByte(44),js(n,0),js(n,0),js(n,e),js(n,t),i){let o=Df(i.length)-1;n.writeByte(128|o)}else n.writeByte(0)}function BS(n,e,t,i,s=8,r,o,a){wS(t,i,e,s,n,r,o,a)}function js(n,e){n.writeByte(e&255),n.writeByte(e>>8&255)}function h_(n,e){for(var t=0;t<e.length;t++)n.writeByte(e.charCodeAt(t))}function Df(n){return Math.max(Math.ceil(Math.log2(n)),1)}var kS=u_});async function Ph(n){let e=new Blob([n]).stream().pipeThrough(new DecompressionStream("deflate"));return new Response(e).arrayBuffer()}var Dp=8,Uy={"<f8":Float64Array,"<f4":Float32Array,"<i4":Int32Array,"<i2":Int16Array,"|i1":Int8Array},pa=class n{constructor(e,t,i){this.header=e;this.content=t;this.front=i}header;content;front;static read(e){let t=new DataView(e).getUint32(0,!0),i=new TextDecoder().decode(new Uint8Array(e,4,t)),s=Math.ceil((4+t)/Dp)*Dp;return new n(JSON.parse(i),e,s)}has(e){return e in this.header.variables}values(e){let{type:t,start:i,shape:s}=this.described(e);if(t===void 0||i===void 0)throw new Error(`${e} has no numbers`);let r=s.reduce((o,a)=>o*a,1);return new Uy[t](this.content,this.front+i,r)}scale(e){return this.described(e).scale??1}texts(e){return this.described(e).texts??[]}shape(e){return this.described(e).shape}unit(e){return this.described(e).attrs.units??""}title(e){return this.described(e).attrs.long_name??e}parsed(e){return JSON.parse(String(this.header.attrs[e]))}described(e){let t=this.header.variables[e];if(t===void 0)throw new Error(`the dataset has no variable ${e}`);return t}};var St,Fp,Dh,Vs,Ih,Tl,Op,Ml,Bp,Nh,Lh,Fy,ga=Symbol.for("pv"),El={},Al=[],Oy=/^m(i|n|o|s|text|space)$/,Uh=Array.isArray,Fh=Al.slice,br=Object.assign;function xr(n){n&&n.parentNode&&n.remove()}function kp(n,e,t){var i,s,r,o={},a=arguments.length;for(r in e)r=="key"?i=e[r]:r=="ref"&&typeof n!="function"?s=e[r]:o[r]=e[r];return a>2&&(o.children=a>3?Fh.call(arguments,2):t),ma(n,o,i,s,null)}function ma(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:ga,__v:s||++Fp,__i:-1,__u:0};return!s&&St.vnode&&St.vnode(r),r}function gn(n){return n.children}function no(n,e){this.props=n,this.context=e,this.__g=0}function Gs(n,e){if(e==null)return n.__&&Gs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Gs(n)}function By(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=br({constructor:ga},t)).__v=t.__v+1,St.vnode&&St.vnode(e),Oh(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Gs(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,qp(s,e,r),t.__=t.__e=null,e.__e!=i&&zp(e))}function zp(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),zp(n)}function Np(n){(8&n.__g||(n.__g|=8,Vs.push(n),Tl++))&&Ih==St.debounceRendering||((Ih=St.debounceRendering)||queueMicrotask)(Vp)}function Vp(){try{for(var n,e=1;Vs.length;)Vs.length>e&&Vs.sort(Op),n=Vs.shift(),e=Vs.length,8&n.__g&&By(n)}finally{(Tl=Vs.length)&&(Ih||queueMicrotask)(Vp)}}function Gp(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,y,g,m=i.__k||Al,b=e.length;for(l=ky(t,e,m,l,b),f=0;f<b;f++)(d=t.__k[f])!=null&&(h=~d.__i&&m[d.__i]||El,d.__i=f,g=Oh(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&Bh(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),y=y||p,4&d.__u?(l=Hp(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&g!==void 0?l=g:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=y,l}function ky(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,y=p,g=0,m=0,b=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=b[r]=ma(null,o):Uh(o)?o=b[r]=ma(gn,{children:o}):o.constructor===ga&&o.__b?o=b[r]=ma(o.type,o.props,o.key,o.ref,o.__v):b[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=zy(o,t,l,y))&&(y--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,m=1)):(~c||(s>p?g--:s<p&&g++),typeof o.type!="function"&&(o.__u|=4))):b[r]=null;if(m){for(u=[],f=[],r=0;r<s;r++)if((o=b[r])&&16&o.__u){for(g=0,h=u.length;g<h;)u[d=g+h>>1]<o.__i?g=d+1:h=d;u[g]=o.__i,f[r]=g+1}for(g=u.length;r--;)f[r]&&(f[r]==g?g--:b[r].__u|=4)}if(y)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Gs(a)),kh(a,a));return i}function Hp(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Hp(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Gs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function zy(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Up(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Sl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Up(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Up(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Lh[e]||(Lh[e]=Vy(e)),(n.__a||(n.__a={}))[e]=Nh,r=e!=(e=e.replace(Bp,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Vy(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Ml]==null)e[Ml]=Nh++;else if(e[Ml]<this.__a[n])return;return t(St.event?St.event(e):e)}}}function Oh(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,y,g,m,b,A,S,P,C,v,E,B,N,L,k=e.type;if(e.constructor!==ga)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=wl(u,r):r.push(u),a=r[0]||a),(u=St.__b)&&u(e);e:if(typeof k=="function"){h=o.length;try{if(m=e.props,b=(u=k.prototype)&&u.render,A=(u=k.contextType)&&i[u.__c],S=u?A?A.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(b?e.__c=d=new k(m,S):(e.__c=d=new no(m,S),d.constructor=k,d.render=Hy),A&&A.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),b&&(d.__s||(d.__s=d.state),k.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=br({},d.__s)),br(d.__s,k.getDerivedStateFromProps(m,d.__s)))),p=d.props,y=d.state,d.__v=e,t.__c){if(m!==p&&b&&!k.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(m,S),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(m,d.__s,S)===!1){e.__v!=t.__v&&(d.props=m,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),Al.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=Gs(t);break e}d.componentWillUpdate&&d.componentWillUpdate(m,d.__s,S),b&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,y,g)})}else b&&!k.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),b&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=S,d.props=m,d.__P=n,d.__g&=-5,P=St.__r,C=b?25:0;do d.__g&=-9,P&&P(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++C<25);b&&(Al.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=br({},i,d.getChildContext())),b&&t.__c&&d.getSnapshotBeforeUpdate&&(g=d.getSnapshotBeforeUpdate(p,y)),v=u&&u.type===gn&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&kh(z,z)}),t.__k=null),a=t.__k?Gs(t,0):null),a=Gp(n,Uh(v)?v:[v],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(xr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(z){if(o.length=h,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(N=r.indexOf(a||void 0))||(N=r.length);(L=r[N-1])&&L.nodeType==8;)N--;for(;N<r.length;N++)if(L=r[N])if(r[N]=null,E){if(L==B)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(B=wl(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=wl(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(xr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||Wp(e),St.__e(z,e,t)}}else a=e.__e=Gy(t.__e,e,t,i,s,r,o,l,c,n);return(u=St.diffed)&&u(e),a}function wl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Wp(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Wp))}function qp(n,e,t){for(var i=0;i<t.length;)Bh(t[i++],t[i++],t[i++]);St.__c&&St.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){St.__e(r,s.__v)}})}function Gy(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,y,g,m,b=t.props||El,A=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(S?p.localName==S:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!S)return m.createTextNode(A);n=m.createElementNS(s,S,A.is?A:c),a&&(St.__m&&St.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&A.defaultValue!=null?null:r&&Fh.call(c.childNodes),!a&&r)for(b={},u=0;u<n.attributes.length;u++)b[(p=n.attributes[u]).name]=p.value;for(u in b)p=b[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in A||u=="value"&&"defaultValue"in A||u=="checked"&&"defaultChecked"in A||Sl(n,u,null,p,s);for(u in A)p=A[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?y=p:u=="checked"?g=p:a&&typeof p!="function"||b[u]===p||Sl(n,u,p,b[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Oy.test(S))&&(s="http://www.w3.org/1999/xhtml"),Gp(c,Uh(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&Gs(t,0),a,l),r&&r.some(xr)),a&&S!="textarea"||(u="value",S=="progress"&&y==null?n.removeAttribute(u):y==null||y===n[u]&&(S!="progress"||y)||Sl(n,u,y,b[u],s),u="checked",g!=null&&g!=n[u]&&Sl(n,u,g,b[u],s))}else b===A||a&&n.data==A||(n.data=A);return n}function Bh(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){St.__e(s,t)}}function kh(n,e,t){var i,s,r,o;if(St.unmount&&St.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Bh(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){St.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&kh(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=wl(i,r=[]))&&(i==n.__e&&r.some(xr),xr(s),xr(i)),t||xr(n.__e),n.__e=n.__c=n.__=null}function Hy(n,e,t){return this.constructor(n,t)}function zh(n,e){var t,i,s,r;St.__&&St.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=ma(gn,{children:[n]}),s=[],r=[],Oh(e,e.__k,i||El,El,e.namespaceURI,i?null:e.firstChild?Fh.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),qp(s,e.__k,r),e.__k.props.children=null}St={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Tl=0,n}},Fp=0,Dh=function(n){return n!=null&&n.constructor===ga},no.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=br({},this.state)),typeof n=="function"&&(n=n(br({},t),this.props)),n&&(br(t,n),this.__v&&(e&&this.__k.push(e),Np(this)))},no.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Np(this))},no.prototype.render=gn,Vs=[],Tl=0,Op=function(n,e){return n.__v.__b-e.__v.__b},Ml=Symbol(),Bp=/(PointerCapture)$|Capture$/i,Nh=0,Lh={},Fy=0;var io,_n,Vh,Xp,Gh=Object.is,Cl=0,tm=[],Hh=[],cn=St,Yp=cn.__b,$p=cn.__r,Zp=cn.diffed,Kp=cn.__c,Jp=cn.unmount,jp=cn.__;function Rl(n,e){cn.__h&&cn.__h(_n,n,Cl||e),Cl=0;var t=_n.__H||(_n.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Hs(n){return Cl=1,Wy(nm,n)}function Wy(n,e,t){var i=Rl(io++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):nm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Gh(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=_n,!_n.__f)){_n.__f=!0;var s=_n.shouldComponentUpdate;_n.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,Gh(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function Dn(n,e){var t=Rl(io++,3);!cn.__s&&qh(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,_n.__H.__h.push(t))}function Oi(n,e){var t=Rl(io++,4);!cn.__s&&qh(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,_n.__h.push(t))}function Nt(n){return Cl=5,je(function(){return{current:n}},[])}function je(n,e){var t=Rl(io++,7);return qh(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function qy(){var n;do{for(;n=Hh.shift();)try{_a(n)}catch(t){cn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=tm.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(_a),e.__h.some(Wh),e.__h=[]}catch(t){e.__h=[],cn.__e(t,n.__v)}}}while(Hh.length)}cn.__b=function(n){_n=null,Yp&&Yp(n)},cn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),jp&&jp(n,e)},cn.__r=function(n){$p&&$p(n),io=0;var e=(_n=n.__c).__H;e&&(Vh==_n?_n.__h=[]:(e.__h.some(_a),e.__h.some(Wh),io=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Vh=_n},cn.diffed=function(n){Zp&&Zp(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&em(tm.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Vh=_n=null},cn.__c=function(n,e){e.some(function(t){try{t.__h.some(_a),t.__h=t.__h.filter(function(i){return!i.__||Wh(i)})}catch(i){t.__h=[function(){throw i}]}}),Kp&&Kp(n,e)},cn.unmount=function(n){Jp&&Jp(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,em(Hh.push(s))}else _a(s)}catch(r){e=r}}),i.__H=void 0,e&&cn.__e(e,i.__v))};var Qp=typeof requestAnimationFrame=="function";function Xy(n){var e,t=function(){clearTimeout(i),Qp&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Qp&&(e=requestAnimationFrame(t))}function em(n){n!=1&&Xp==cn.requestAnimationFrame||((Xp=cn.requestAnimationFrame)||Xy)(qy)}function _a(n){var e=_n,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),_n=e}function Wh(n){var e=_n;n.__c=n.__(),_n=e}function qh(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Gh(t,n[i])})}function nm(n,e){return typeof e=="function"?e(n):e}var Yy=Symbol.for("preact-signals");function Dl(){if(ys>1)ys--;else{var n,e=!1;for((function(){var s=Il;for(Il=void 0;s!==void 0;){var r=s.S;if(r.v===s.v)for(var o=r.t;o!==void 0;o=o.x)o.i===s.i&&(o.i=r.i);s=s.o}})();ya!==void 0;){var t=ya;for(ya=void 0,Pl++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&sm(t))try{t.c()}catch(s){e||(n=s,e=!0)}t=i}}if(Pl=0,ys--,e)throw n}}function Nl(n){if(ys>0)return n();Xh=++$y,ys++;try{return n()}finally{Dl()}}var va,Zt=void 0;function xa(n){var e=Zt,t=va;Zt=void 0,va=void 0;try{return n()}finally{Zt=e,va=t}}var ya=void 0,ys=0,Pl=0,$y=0,Xh=0,Il=void 0,Ll=0;function im(n){if(Zt!==void 0){var e=n.n;if(e===void 0||e.t!==Zt)return e={i:0,S:n,p:Zt.s,n:void 0,t:Zt,e:void 0,x:void 0,r:e},Zt.s!==void 0&&(Zt.s.n=e),Zt.s=e,n.n=e,32&Zt.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=Zt.s,e.n=void 0,Zt.s.n=e,Zt.s=e),e}}function Sn(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Sn.prototype.brand=Yy;Sn.prototype.h=function(){return!0};Sn.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:xa(function(){var i;(i=e.W)==null||i.call(e)}))};Sn.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&xa(function(){var s;(s=e.Z)==null||s.call(e)}))}};Sn.prototype.subscribe=function(n){var e=this;return Ct(function(){var t=e.value;xa(function(){return n(t)})},{name:"sub"})};Sn.prototype.valueOf=function(){return this.value};Sn.prototype.toString=function(){return this.value+""};Sn.prototype.toJSON=function(){return this.value};Sn.prototype.peek=function(){var n=this;return xa(function(){return n.value})};Object.defineProperty(Sn.prototype,"value",{get:function(){var n=im(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Pl>100)throw new Error("Cycle detected");(function(t){ys!==0&&Pl===0&&t.l!==Xh&&(t.l=Xh,Il={S:t,v:t.v,i:t.i,o:Il})})(this),this.v=n,this.i++,Ll++,ys++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{Dl()}}}});function $e(n,e){return new Sn(n,e)}function sm(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function rm(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function om(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function Sr(n,e){Sn.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Ll-1,this.f=4}Sr.prototype=new Sn;Sr.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Ll))return!0;if(this.g=Ll,this.f|=1,this.i>0&&!sm(this))return this.f&=-2,!0;var n=Zt;try{rm(this),Zt=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return Zt=n,om(this),this.f&=-2,!0};Sr.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Sn.prototype.S.call(this,n)};Sr.prototype.U=function(n){if(this.t!==void 0&&(Sn.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};Sr.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(Sr.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=im(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function Qn(n,e){return new Sr(n,e)}function am(n){var e=n.j;if(n.j=void 0,typeof e=="function"){ys++;var t=Zt;Zt=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,Yh(n),i}finally{Zt=t,Dl()}}}function Yh(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,am(n)}function Zy(n){if(Zt!==this)throw new Error("Out-of-order effect");om(this),Zt=n,this.f&=-2;try{8&this.f&&Yh(this)}finally{Dl()}}function so(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,va&&va.push(this)}so.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};so.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,am(this),rm(this),ys++;var n=Zt;return Zt=this,Zy.bind(this,n)};so.prototype.N=function(){2&this.f||(this.f|=2,this.u=ya,ya=this)};so.prototype.d=function(){this.f|=8,1&this.f||Yh(this)};so.prototype.dispose=function(){this.d()};function Ct(n,e){var t=new so(n,e);try{t.c()}catch(s){throw t.d(),s}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var $h,Sa,Ul,Ky=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,lm=[],cm=[];Ct(function(){$h=this.N})();function ro(n,e){St[n]=e.bind(null,St[n]||function(){})}function ba(n){if(Ul){var e=Ul;Ul=void 0,e()}Ul=n&&n.S()}function um(n){var e=this,t=n.data,i=jy(t);i.name="ReactiveDom",i.value=t;var s=je(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=Qn(function(){var d=i.value.value;return d===0?0:d===!0?"":d||""}),u=Qn(function(){return!Array.isArray(c.value)&&!Dh(c.value)}),f=Ct(function(){if(this.N=hm,u.value){var d=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=d)}}),h=e.__$u.d;return e.__$u.d=function(){f(),h.call(this)},[u,c]},[]),r=s[0],o=s[1];return r.value?o.peek():o.value}um.displayName="ReactiveTextNode";Object.defineProperties(Sn.prototype,{constructor:{configurable:!0,value:kp(gn,null).constructor},type:{configurable:!0,value:um},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});ro("__b",function(n,e){if(ba(),Sa=void 0,typeof e.type=="string"){var t,i=e.props;for(var s in i)if(s!=="children"){var r=i[s];r instanceof Sn&&(t||(e.__np=t={}),t[s]=r,i[s]=r.peek())}}n(e)});ro("__r",function(n,e){if(n(e),e.type!==gn){ba();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(s,r){var o;return Ct(function(){o=this},{name:r}),o.c=s,o})((function(s){return function(){var r;Ky&&((r=this.y)==null||r.call(this)),s.__$f|=1,s.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),Sa=i,ba(t)}});ro("__e",function(n,e,t,i){ba(),Sa=void 0,n(e,t,i)});ro("diffed",function(n,e){ba(),Sa=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,s=e.props,r=t.U;if(r)for(var o in r){var a=r[o];a===void 0||i&&o in i||(a.d(),r[o]=void 0)}if(i){r||(r={},t.U=r);for(var l in i){var c=r[l],u=i[l];c===void 0?(c=Jy(t,l,u,s),r[l]=c):c.o(u,s)}}}n(e)});function Jy(n,e,t,i){var s=e in n&&n.ownerSVGElement===void 0,r=$e(t);return{o:function(o,a){r.value=o,i=a},d:Ct(function(){this.N=hm;var o=r.value.value;i[e]!==o&&(i[e]=o,s?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}ro("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var s in i){var r=i[s];r&&r.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var u=c.__$u;u&&(c.__$u=void 0,u.d())}}n(e)});ro("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});no.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var s in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var r=2&this.__$f;if(!(i||r||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function jy(n,e){return je(function(){return $e(n,e)},[])}var Qy=typeof requestAnimationFrame>"u"?setTimeout:function(n){var e=function(){clearTimeout(t),cancelAnimationFrame(i),n()},t=setTimeout(e,35),i=requestAnimationFrame(e)},ex=function(n){queueMicrotask(function(){queueMicrotask(n)})};function tx(){Nl(function(){for(var n;n=lm.shift();)$h.call(n)})}function nx(){lm.push(this)===1&&(St.requestAnimationFrame||Qy)(tx)}function ix(){Nl(function(){for(var n;n=cm.shift();)$h.call(n)})}function hm(){cm.push(this)===1&&(St.requestAnimationFrame||ex)(ix)}function fm(n,e){var t=Nt(n);t.current=n;var i=Sa;Dn(function(){return Ct(function(){if(this.N=nx,!(i&&8&i.__$f))return t.current()},e)},[])}var sx=Symbol.for("pv"),rx=0;function _(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:sx,__v:--rx,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),St.vnode&&St.vnode(c),c}function Bi({title:n,units:e,unit:t}){return _("label",{children:[n," ",_("select",{value:t.value.name,onChange:({currentTarget:i})=>t.value=e[i.selectedIndex]??t.value,children:e.map(({name:i})=>_("option",{children:i}))})]})}function Ws({playing:n}){return _("button",{type:"button",onClick:()=>n.value=!n.value,children:n.value?"Stop":"Move"})}function oo({pace:n}){return _("label",{children:["pace, cycles per second: ",n.value.toFixed(1),_("input",{type:"range",min:"0.1",max:"3",step:"0.1",value:n.value,onInput:e=>n.value=Number(e.currentTarget.value)})]})}function qs({facts:n}){return _("dl",{children:n.filter(([,e])=>e).map(([e,t])=>_("div",{children:[_("dt",{children:e}),_("dd",{children:t})]}))})}var Fl=$e([]);function dm(n,e){let t={title:n,keys:e};return Fl.value=[...Fl.peek(),t],()=>Fl.value=Fl.peek().filter(i=>i!==t)}var ox="input, textarea, select",ax="button, summary, a";function Ol(n,e){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return;let t=n.target;if(t.closest(ox)!==null||n.key===" "&&t.closest(ax)!==null)return;let i=e.map(s=>s.actions[n.key]).find(s=>s!==void 0);i!==void 0&&(n.preventDefault(),i(n))}var Mr=n=>String(n.header.attrs.origin??"simulated");function ui({name:n,data:e,keys:t,foot:i,isOld:s=!1,children:r}){Dn(()=>dm(e.header.title,t),[e,t]);let o=e.header.extra.summary??[];return _("div",{class:n,tabIndex:-1,onKeyDown:a=>Ol(a,t),children:[_("header",{children:[_("h1",{children:e.header.title}),_("p",{class:"origin",children:Mr(e)}),_("div",{class:s?"old":"",children:o.map(a=>_("p",{children:a}))})]}),r,_("footer",{children:_("p",{children:["haptonic ",String(e.header.attrs.haptonic_version??""),". ",i]})})]})}function Ei(n){return[{keys:"t",effect:"tables",actions:{t:()=>Zh(n,"table")}},{keys:"?",effect:"this list",actions:{"?":()=>Zh(n,"keys")}}]}function Zh(n,e){n.value=n.value===e?"none":e}function Ai({listing:n,keys:e,children:t}){let i=Nt(null);return fm(()=>{n.value!=="none"&&i.current?.focus()}),_("section",{"aria-label":"Tables and keys",children:[_("p",{class:"opened",children:[["table","Tables"],["keys","Keys"]].map(([r,o])=>_("button",{type:"button","aria-expanded":n.value===r,onClick:()=>Zh(n,r),children:o}))}),_("div",{ref:i,tabIndex:-1,children:[n.value==="table"&&t,n.value==="keys"&&_(lx,{title:"Keys",keys:e})]})]})}function lx({title:n,keys:e}){return _("table",{children:[n&&_("caption",{children:n}),_("tbody",{children:e.map(({keys:t,effect:i})=>_("tr",{children:[_("th",{scope:"row",children:_("kbd",{children:t})}),_("td",{children:i})]}))})]})}function kn(n,e){if(!(Number.isFinite(e)&&e>0))return n.toFixed(3);e=Math.max(e,10**-6);let t=Math.floor(Math.log10(e)+1e-9);e<2*10**t&&(t-=1);let i=Math.ceil(e/10**t-1e-9);i===10&&([i,t]=[1,t+1]);let s=Math.min(Math.max(-t,0),6);return`${n.toFixed(s)} ± ${(i*10**t).toFixed(s)}`}var pm=[{name:"Hz",factor:1},{name:"kHz",factor:1e3},{name:"MHz",factor:1e6}],cx=1e4;function is(n){let{pitch_m:e,shear_speed_m_per_s:t}=n.header.attrs;return typeof e!="number"||typeof t!="number"?pm:[...pm,{name:"ωa/(2πcₜ)",factor:t/e,relative:!0}]}function ss(n,e){return n.find(({factor:i,relative:s})=>!s&&e<cx*i)??n[0]}function Bl(n){return[{name:"rad/m",factor:1},{name:"π/a",factor:Math.PI/n},{name:"2π/a",factor:2*Math.PI/n}]}function $n(n,{name:e,relative:t}){return t?`${e} = ${n}`:`${n} ${e}`}function on(n,{name:e,relative:t}){return t?e:`${n} / ${e.includes("/")?`(${e})`:e}`}function rs(n){return`${Number(n.toPrecision(6))}`}function ei({label:n,describedBy:e="point",onKeyDown:t,children:i}){return _("div",{class:"walk",tabIndex:0,role:"application","aria-label":n,"aria-describedby":e,onKeyDown:t,children:i})}var ux="uplot",hx="u-hz",fx="u-vt",dx="u-title",px="u-wrap",mx="u-under",gx="u-over",_x="u-axis",Er="u-off",vx="u-select",yx="u-cursor-x",xx="u-cursor-y",bx="u-cursor-pt",Sx="u-legend",Mx="u-live",wx="u-inline",Tx="u-series",Ex="u-marker",mm="u-label",Ax="u-value",wa="width",Ta="height";var gm="bottom",ao="left",Kh="right",pf="#000",_m=pf+"0",Jh="mousemove",vm="mousedown",jh="mouseup",ym="mouseenter",xm="mouseleave",bm="dblclick",Cx="resize",Rx="scroll",Sm="change",Hl="dppxchange",mf="--",mo=typeof window<"u",sf=mo?document:null,co=mo?window:null,Px=mo?navigator:null,Et,kl;function rf(){let n=devicePixelRatio;Et!=n&&(Et=n,kl&&af(Sm,kl,rf),kl=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),Ar(Sm,kl,rf),co.dispatchEvent(new CustomEvent(Hl)))}function hi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function of(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function qt(n,e,t){n.style[e]=t+"px"}function ki(n,e,t,i){let s=sf.createElement(n);return e!=null&&hi(s,e),t?.insertBefore(s,i),s}function Ci(n,e){return ki("div",n,e)}var Mm=new WeakMap;function os(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Mm.get(n);r!=o&&(n.style.transform=r,Mm.set(n,r),e<0||t<0||e>i||t>s?hi(n,Er):of(n,Er))}var wm=new WeakMap;function Tm(n,e,t){let i=e+t,s=wm.get(n);i!=s&&(wm.set(n,i),n.style.background=e,n.style.borderColor=t)}var Em=new WeakMap;function Am(n,e,t,i){let s=e+""+t,r=Em.get(n);s!=r&&(Em.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var gf={passive:!0},Ix={...gf,capture:!0};function Ar(n,e,t,i){e.addEventListener(n,t,i?Ix:gf)}function af(n,e,t,i){e.removeEventListener(n,t,gf)}mo&&rf();function zi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:fi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function tg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var ng=n=>n!=null,ig=n=>n!=null&&n>0,Xl=tg(ng),Lx=tg(ig);function Dx(n,e,t,i=0,s=!1){let r=s?Lx:Xl,o=s?ig:ng;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Bt,l??-Bt]}function Yl(n,e,t,i){let s=Pm(n),r=Pm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?xs:sg,a=s==1?fi:Ri,l=r==1?Ri:fi,c=a(o(wn(n))),u=l(o(wn(e))),f=uo(t,c),h=uo(t,u);return t==10&&(c<0&&(f=kt(f,-c)),u<0&&(h=kt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=lg(n,f),e=$l(e,h)),[n,e]}function _f(n,e,t,i){let s=Yl(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var vf=.1,Cm={mode:3,pad:vf},Aa={pad:0,soft:null,mode:0},Nx={min:Aa,max:Aa};function Wl(n,e,t,i){return Zl(t)?Rm(n,e,t):(Aa.pad=t,Aa.soft=i?0:null,Aa.mode=i?3:0,Rm(n,e,Nx))}function wt(n,e){return n??e}function Ux(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Rm(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Bt),l=wt(s.hard,Bt),c=wt(i.soft,Bt),u=wt(s.soft,-Bt),f=wt(i.mode,0),h=wt(s.mode,0),d=e-n,p=xs(d),y=Zn(wn(n),wn(e)),g=xs(y),m=wn(g-p);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Bt&&(r=0),h==2&&u!=-Bt&&(o=0)));let b=d||y||1e3,A=xs(b),S=uo(10,fi(A)),P=b*(d==0?n==0?.1:1:r),C=kt(lg(n-P,S/10),24),v=n>=c&&(f==1||f==3&&C<=c||f==2&&C>=c)?c:Bt,E=Zn(a,C<v&&n>=v?v:Vi(v,C)),B=b*(d==0?e==0?.1:1:o),N=kt($l(e+B,S/10),24),L=e<=u&&(h==1||h==3&&N>=u||h==2&&N<=u)?u:-Bt,k=Vi(l,N>L&&e<=L?L:Zn(L,N));return E==k&&E==0&&(k=100),[E,k]}var Fx=new Intl.NumberFormat(mo?Px.language:"en-US"),yf=n=>Fx.format(n),di=Math,Gl=di.PI,wn=di.abs,fi=di.floor,Mn=di.round,Ri=di.ceil,Vi=di.min,Zn=di.max,uo=di.pow,Pm=di.sign,xs=di.log10,sg=di.log2,Ox=(n,e=1)=>di.sinh(n)*e,Qh=(n,e=1)=>di.asinh(n/e),Bt=1/0;function Im(n){return(xs((n^n>>31)-(n>>31))|0)+1}function lf(n,e,t){return Vi(Zn(n,e),t)}function rg(n){return typeof n=="function"}function vt(n){return rg(n)?n:()=>n}var Bx=()=>{},og=n=>n,ag=(n,e)=>e,kx=n=>null,Lm=n=>!0,Dm=(n,e)=>n==e,zx=/\.\d*?(?=9{6,}|0{6,})/gm,Cr=n=>{if(ug(n)||Ys.has(n))return n;let e=`${n}`,t=e.match(zx);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Cr(s)}e${r}`}return kt(n,i)};function wr(n,e){return Cr(kt(Cr(n/e))*e)}function $l(n,e){return Cr(Ri(Cr(n/e))*e)}function lg(n,e){return Cr(fi(Cr(n/e))*e)}function kt(n,e=0){if(ug(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Mn(i)/t}var Ys=new Map;function cg(n){return((""+n).split(".")[1]||"").length}function Ra(n,e,t,i){let s=[],r=i.map(cg);for(let o=e;o<t;o++){let a=wn(o),l=kt(uo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:kt(u,f);s.push(h),Ys.set(h,f)}}return s}var Ca={},xf=[],ho=[null,null],Xs=Array.isArray,ug=Number.isInteger,Vx=n=>n===void 0;function Nm(n){return typeof n=="string"}function Zl(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Gx(n){return n!=null&&typeof n=="object"}var Hx=Object.getPrototypeOf(Uint8Array),hg="__proto__";function fo(n,e=Zl){let t;if(Xs(n)){let i=n.find(s=>s!=null);if(Xs(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=fo(n[s],e)}else t=n.slice()}else if(n instanceof Hx)t=n.slice();else if(e(n)){t={};for(let i in n)i!=hg&&(t[i]=fo(n[i],e))}else t=n;return t}function vn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=hg&&(Zl(n[s])?vn(n[s],fo(i[s])):n[s]=fo(i[s]))}return n}var Wx=0,qx=1,Xx=2;function Yx(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function $x(n,e){if(Jx(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return jx(o[0])||(o=Kx(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:qx,d=[];for(let p=0;p<u.length;p++){let y=u[p],g=r.get(l[p]);y===null?h!=Wx&&(f[g]=y,h==Xx&&d.push(g)):f[g]=y}Yx(f,d,s),i.push(f)}}return i}var Zx=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Kx(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Jx(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function jx(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Zn(1,fi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var fg=["January","February","March","April","May","June","July","August","September","October","November","December"],dg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function pg(n){return n.slice(0,3)}var Qx=dg.map(pg),eb=fg.map(pg),tb={MMMM:fg,MMM:eb,WWWW:dg,WWW:Qx};function Ma(n){return(n<10?"0":"")+n}function nb(n){return(n<10?"00":n<100?"0":"")+n}var ib={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ma(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ma(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ma(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ma(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ma(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>nb(n.getMilliseconds())};function bf(n,e){e=e||tb;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?ib[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var sb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function rb(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==sb?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var mg=n=>n%1==0,ql=[1,2,2.5,5],ob=Ra(10,-32,0,ql),gg=Ra(10,0,32,ql),ab=gg.filter(mg),Tr=ob.concat(gg),Sf=`
`,_g="{YYYY}",Um=Sf+_g,vg="{M}/{D}",Ea=Sf+vg,zl=Ea+"/{YY}",yg="{aa}",lb="{h}:{mm}",lo=lb+yg,Fm=Sf+lo,Om=":{ss}",Rt=null;function xg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ra(10,0,3,ql).filter(mg):Ra(10,-3,0,ql)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,_g,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",Um,Rt,Rt,Rt,Rt,Rt,1],[s,vg,Um,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+yg,zl,Rt,Ea,Rt,Rt,Rt,1],[t,lo,zl,Rt,Ea,Rt,Rt,Rt,1],[e,Om,zl+" "+lo,Rt,Ea+" "+lo,Rt,Fm,Rt,1],[n,Om+".{fff}",zl+" "+lo,Rt,Ea+" "+lo,Rt,Fm,Rt,1]];function u(f){return(h,d,p,y,g,m)=>{let b=[],A=g>=o,S=g>=r&&g<o,P=f(p),C=kt(P*n,3),v=ef(P.getFullYear(),A?0:P.getMonth(),S||A?1:P.getDate()),E=kt(v*n,3);if(S||A){let B=S?g/r:0,N=A?g/o:0,L=C==E?C:kt(ef(v.getFullYear()+N,v.getMonth()+B,1)*n,3),k=new Date(Mn(L/n)),z=k.getFullYear(),U=k.getMonth();for(let H=0;L<=y;H++){let $=ef(z+N*H,U+B*H,1),G=$-f(kt($*n,3));L=kt((+$+G)*n,3),L<=y&&b.push(L)}}else{let B=g>=s?s:g,N=fi(p)-fi(C),L=E+N+$l(C-E,B);b.push(L);let k=f(L),z=k.getHours()+k.getMinutes()/t+k.getSeconds()/i,U=g/i,H=h.axes[d]._space,$=m/H;for(;L=kt(L+g,n==1?0:3),!(L>y);)if(U>1){let G=fi(kt(z+U,6))%24,Q=f(L).getHours()-G;Q>1&&(Q=-1),L-=Q*i,z=(z+U)%24;let se=b[b.length-1];kt((L-se)/g,3)*$>=.7&&b.push(L)}else b.push(L)}return b}}return[l,c,u]}var[cb,ub,hb]=xg(1),[fb,db,pb]=xg(.001);Ra(2,-53,53,[1]);function Bm(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function km(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let y=n(p),g=y.getFullYear(),m=y.getMonth(),b=y.getDate(),A=y.getHours(),S=y.getMinutes(),P=y.getSeconds(),C=g!=l&&a[2]||m!=c&&a[3]||b!=u&&a[4]||A!=f&&a[5]||S!=h&&a[6]||P!=d&&a[7]||a[1];return l=g,c=m,u=b,f=A,h=S,d=P,C(y)})}}function mb(n,e){let t=bf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function ef(n,e,t){return new Date(n,e,t)}function zm(n,e){return e(n)}var gb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Vm(n,e){return(t,i,s,r)=>r==null?mf:e(n(i))}function _b(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function vb(n,e){return n.series[e].fill(n,e)}var yb={show:!0,live:!0,isolate:!1,mount:Bx,markers:{show:!0,width:2,stroke:_b,fill:vb,dash:"solid"},idx:null,idxs:null,values:[]};function xb(n,e){let t=n.cursor.points,i=Ci(),s=t.size(n,e);qt(i,wa,s),qt(i,Ta,s);let r=s/-2;qt(i,"marginLeft",r),qt(i,"marginTop",r);let o=t.width(n,e,s);return o&&qt(i,"borderWidth",o),i}function bb(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Sb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Mb(n,e){return n.series[e].points.size}var tf=[0,0];function wb(n,e,t){return tf[0]=e,tf[1]=t,tf}function Vl(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function nf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var Tb={show:!0,x:!0,y:!0,lock:!1,move:wb,points:{one:!1,show:xb,size:Mb,width:0,stroke:Sb,fill:bb},bind:{mousedown:Vl,mouseup:Vl,click:Vl,dblclick:Vl,mousemove:nf,mouseleave:nf,mouseenter:nf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},bg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Mf=vn({},bg,{filter:ag}),Sg=vn({},Mf,{size:10}),Mg=vn({},bg,{show:!1}),wf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',wg="bold "+wf,Tg=1.5,Gm={show:!0,scale:"x",stroke:pf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wg,side:2,grid:Mf,ticks:Sg,border:Mg,font:wf,lineGap:Tg,rotate:0},Eb="Value",Ab="Time",Hm={show:!0,scale:"x",auto:!1,sorted:1,min:Bt,max:-Bt,idxs:[]};function Cb(n,e,t,i,s){return e.map(r=>r==null?"":yf(r))}function Rb(n,e,t,i,s,r,o){let a=[],l=Ys.get(s)||0;t=o?t:kt($l(t,s),l);for(let c=t;c<=i;c=kt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function cf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?xs:sg,u=fi(c(t));s=uo(l,u),l==10&&(s=Tr[zi(s,Tr)]);let f=t,h=s*l;l==10&&(h=Tr[zi(h,Tr)]);do a.push(f),f=f+s,l==10&&!Ys.has(f)&&(f=kt(f,Ys.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Tr[zi(h,Tr)]));while(f<=i);return a}function Pb(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?cf(n,e,Zn(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?cf(n,e,Zn(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Eg=/./,Ib=/[12357]/,Lb=/[125]/,Wm=/1/,uf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Db(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?Eg:l(7,o)-u>=c?Ib:l(5,o)-u>=c?Lb:Wm;if(f==Wm){let h=wn(l(1,o)-u);if(h<c)return uf(e.slice().reverse(),a.distr,f,Ri(c/h)).reverse()}return uf(e,a.distr,f,1)}function Nb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=wn(l(1,o)-l(2,o));return c<a?uf(e.slice().reverse(),3,Eg,Ri(a/c)).reverse():e}function Ub(n,e,t,i){return i==null?mf:e==null?"":yf(e)}var qm={show:!0,scale:"y",stroke:pf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:wg,side:3,grid:Mf,ticks:Sg,border:Mg,font:wf,lineGap:Tg,rotate:0};function Fb(n,e){let t=3+(n||1)*2;return kt(t*e,3)}function Ob(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=wn(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}var Xm={scale:null,auto:!0,sorted:0,min:Bt,max:-Bt},Ag=(n,e,t,i,s)=>s,Ym={show:!0,auto:!0,sorted:0,gaps:Ag,alpha:1,facets:[vn({},Xm,{scale:"x"}),vn({},Xm,{scale:"y"})]},$m={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Ag,alpha:1,points:{show:Ob,filter:null},values:null,min:Bt,max:-Bt,idxs:[],path:null,clip:null};function Bb(n,e,t,i,s){return t/10}var Cg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},kb=vn({},Cg,{time:!1,ori:1}),Zm={};function Rg(n,e){let t=Zm[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(Zm[n]=t)),t}var po=1,hf=2;function Rr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,y=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,f,g,m,h,d,p,y,Jl,go,Ql,Ig,Dg):t(s,l,c,u,f,m,g,d,h,y,p,jl,_o,Af,Lg,Ng)}function Tf(n,e){let t=0,i=0,s=wt(n.bands,xf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function zb(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(n,e,t,i,s,r){return Rr(n,e,(o,a,l,c,u,f,h,d,p,y,g)=>{let m=o.pxRound,b=c.dir*(c.ori==0?1:-1),A=c.ori==0?go:_o,S,P;b==1?(S=t,P=i):(S=i,P=t);let C=m(f(a[S],c,y,d)),v=m(h(l[S],u,g,p)),E=m(f(a[P],c,y,d)),B=m(h(r==1?u.max:u.min,u,g,p)),N=new Path2D(s);return A(N,E,B),A(N,C,B),A(N,C,v),N})}function Kl(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Ql:Af,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Vb(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Ef(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),y=f-s;d=o<=0&&y>=0&&y<l?r(n[y]):d;let m=h+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=d&&a.push([d,p])}return a}function Km(n){return n==0?og:n==1?Mn:e=>wr(e,n)}function Pg(n){let e=n==0?Jl:jl,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Vi(c,a/2,l/2),u=Vi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Jl=(n,e,t)=>{n.moveTo(e,t)},jl=(n,e,t)=>{n.moveTo(t,e)},go=(n,e,t)=>{n.lineTo(e,t)},_o=(n,e,t)=>{n.lineTo(t,e)},Ql=Pg(0),Af=Pg(1),Ig=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Lg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},Dg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Ng=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function Ug(n){return(e,t,i,s,r)=>Rr(e,t,(o,a,l,c,u,f,h,d,p,y,g)=>{let{pxRound:m,points:b}=o,A,S;c.ori==0?(A=Jl,S=Ig):(A=jl,S=Lg);let P=kt(b.width*Et,3),C=(b.size-b.width)/2*Et,v=kt(C*2,3),E=new Path2D,B=new Path2D,{left:N,top:L,width:k,height:z}=e.bbox;Ql(B,N-v,L-v,k+v*2,z+v*2);let U=H=>{if(l[H]!=null){let $=m(f(a[H],c,y,d)),G=m(h(l[H],u,g,p));A(E,$+C,G),S(E,$,G,C,0,Gl*2)}};if(r)r.forEach(U);else for(let H=i;H<=s;H++)U(H);return{stroke:P>0?E:null,fill:E,clip:B,flags:po|hf}})}function Fg(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Gb=Fg(go),Hb=Fg(_o);function Og(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>Rr(t,i,(o,a,l,c,u,f,h,d,p,y,g)=>{[s,r]=Xl(l,s,r);let m=o.pxRound,b=z=>m(f(z,c,y,d)),A=z=>m(h(z,u,g,p)),S,P;c.ori==0?(S=go,P=Gb):(S=_o,P=Hb);let C=c.dir*(c.ori==0?1:-1),v={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:po},E=v.stroke,B=!1;if(r-s>=y*4){let z=he=>t.posToVal(he,c.key,!0),U=null,H=null,$,G,le,J=b(a[C==1?s:r]),Q=b(a[s]),se=b(a[r]),fe=z(C==1?Q+1:se-1);for(let he=C==1?s:r;he>=s&&he<=r;he+=C){let ee=a[he],ve=(C==1?ee<fe:ee>fe)?J:b(ee),Ae=l[he];ve==J?Ae!=null?(G=Ae,U==null?(S(E,ve,A(G)),$=U=H=G):G<U?U=G:G>H&&(H=G)):Ae===null&&(B=!0):(U!=null&&P(E,J,A(U),A(H),A($),A(G)),Ae!=null?(G=Ae,S(E,ve,A(G)),U=H=$=G):(U=H=null,Ae===null&&(B=!0)),J=ve,fe=z(J+C))}U!=null&&U!=H&&le!=J&&P(E,J,A(U),A(H),A($),A(G))}else for(let z=C==1?s:r;z>=s&&z<=r;z+=C){let U=l[z];U===null?B=!0:U!=null&&S(E,b(a[z]),A(U))}let[L,k]=Tf(t,i);if(o.fill!=null||L!=0){let z=v.fill=new Path2D(E),U=o.fillTo(t,i,o.min,o.max,L),H=A(U),$=b(a[s]),G=b(a[r]);C==-1&&([G,$]=[$,G]),S(z,G,H),S(z,$,H)}if(!o.spanGaps){let z=[];B&&z.push(...Ef(a,l,s,r,C,b,e)),v.gaps=z=o.gaps(t,i,s,r,z),v.clip=Kl(z,c.ori,d,p,y,g)}return k!=0&&(v.band=k==2?[bs(t,i,s,r,E,-1),bs(t,i,s,r,E,1)]:bs(t,i,s,r,E,k)),v})}function Wb(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>Rr(r,o,(c,u,f,h,d,p,y,g,m,b,A)=>{[a,l]=Xl(f,a,l);let S=c.pxRound,{left:P,width:C}=r.bbox,v=Q=>S(p(Q,h,b,g)),E=Q=>S(y(Q,d,A,m)),B=h.ori==0?go:_o,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:po},L=N.stroke,k=h.dir*(h.ori==0?1:-1),z=E(f[k==1?a:l]),U=v(u[k==1?a:l]),H=U,$=U;s&&e==-1&&($=P,B(L,$,z)),B(L,U,z);for(let Q=k==1?a:l;Q>=a&&Q<=l;Q+=k){let se=f[Q];if(se==null)continue;let fe=v(u[Q]),he=E(se);e==1?B(L,fe,z):B(L,H,he),B(L,fe,he),z=he,H=fe}let G=H;s&&e==1&&(G=P+C,B(L,G,z));let[le,J]=Tf(r,o);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(L),se=c.fillTo(r,o,c.min,c.max,le),fe=E(se);B(Q,G,fe),B(Q,$,fe)}if(!c.spanGaps){let Q=[];Q.push(...Ef(u,f,a,l,k,v,i));let se=c.width*Et/2,fe=t||e==1?se:-se,he=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=he}),N.gaps=Q=c.gaps(r,o,a,l,Q),N.clip=Kl(Q,h.ori,g,m,b,A)}return J!=0&&(N.band=J==2?[bs(r,o,a,l,L,-1),bs(r,o,a,l,L,1)]:bs(r,o,a,l,L,J)),N})}function Jm(n,e,t,i,s,r,o=Bt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=wn(n[l]-n[a]);u<c&&(c=u,o=wn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function qb(n){n=n||Ca;let e=wt(n.size,[.6,Bt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=vt(s),o=1-e[0],a=wt(e[1],Bt),l=wt(e[2],1),c=wt(n.disp,Ca),u=wt(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,y,g)=>Rr(d,p,(m,b,A,S,P,C,v,E,B,N,L)=>{let k=m.pxRound,z=t,U=i*Et,H=a*Et,$=l*Et,G,le;S.ori==0?[G,le]=r(d,p):[le,G]=r(d,p);let J=S.dir*(S.ori==0?1:-1),Q=S.ori==0?Ql:Af,se=S.ori==0?u:(Re,Ye,at,Me,Ot,ze,qe)=>{u(Re,Ye,at,Ot,Me,qe,ze)},fe=wt(d.bands,xf).find(Re=>Re.series[0]==p),he=fe!=null?fe.dir:0,ee=m.fillTo(d,p,m.min,m.max,he),me=k(v(ee,P,L,B)),ve,Ae,Se,He=N,ot=k(m.width*Et),Ve=!1,ft=null,ct=null,st=null,Yt=null;f!=null&&(ot==0||h!=null)&&(Ve=!0,ft=f.values(d,p,y,g),ct=new Map,new Set(ft).forEach(Re=>{Re!=null&&ct.set(Re,new Path2D)}),ot>0&&(st=h.values(d,p,y,g),Yt=new Map,new Set(st).forEach(Re=>{Re!=null&&Yt.set(Re,new Path2D)})));let{x0:zt,size:un}=c;if(zt!=null&&un!=null){z=1,b=zt.values(d,p,y,g),zt.unit==2&&(b=b.map(at=>d.posToVal(E+at*N,S.key,!0)));let Re=un.values(d,p,y,g);un.unit==2?Ae=Re[0]*N:Ae=C(Re[0],S,N,E)-C(0,S,N,E),He=Jm(b,A,C,S,N,E,He),Se=He-Ae+U}else He=Jm(b,A,C,S,N,E,He),Se=He*o+U,Ae=He-Se;Se<1&&(Se=0),ot>=Ae/2&&(ot=0),Se<5&&(k=og);let Ut=Se>0,Cn=He-Se-(Ut?ot:0);Ae=k(lf(Cn,$,H)),ve=(z==0?Ae/2:z==J?0:Ae)-z*J*((z==0?U/2:0)+(Ut?ot/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},xn=Ve?null:new Path2D,en=null;if(fe!=null)en=d.data[fe.series[1]];else{let{y0:Re,y1:Ye}=c;Re!=null&&Ye!=null&&(A=Ye.values(d,p,y,g),en=Re.values(d,p,y,g))}let hn=G*Ae,O=le*Ae;for(let Re=J==1?y:g;Re>=y&&Re<=g;Re+=J){let Ye=A[Re];if(Ye==null)continue;if(en!=null){let q=en[Re]??0;if(Ye-q==0)continue;me=v(q,P,L,B)}let at=S.distr!=2||c!=null?b[Re]:Re,Me=C(at,S,N,E),Ot=v(wt(Ye,ee),P,L,B),ze=k(Me-ve),qe=k(Zn(Ot,me)),R=k(Vi(Ot,me)),M=qe-R;if(Ye!=null){let q=Ye<0?O:hn,ue=Ye<0?hn:O;Ve?(ot>0&&st[Re]!=null&&Q(Yt.get(st[Re]),ze,R+fi(ot/2),Ae,Zn(0,M-ot),q,ue),ft[Re]!=null&&Q(ct.get(ft[Re]),ze,R+fi(ot/2),Ae,Zn(0,M-ot),q,ue)):Q(xn,ze,R+fi(ot/2),Ae,Zn(0,M-ot),q,ue),se(d,p,Re,ze-ot/2,R,Ae+ot,M)}}return ot>0?bt.stroke=Ve?Yt:xn:Ve||(bt._fill=m.width==0?m._fill:m._stroke??m._fill,bt.width=0),bt.fill=Ve?ct:xn,bt})}function Xb(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>Rr(i,s,(a,l,c,u,f,h,d,p,y,g,m)=>{[r,o]=Xl(c,r,o);let b=a.pxRound,A=G=>b(h(G,u,g,p)),S=G=>b(d(G,f,m,y)),P,C,v;u.ori==0?(P=Jl,v=go,C=Dg):(P=jl,v=_o,C=Ng);let E=u.dir*(u.ori==0?1:-1),B=A(l[E==1?r:o]),N=B,L=[],k=[];for(let G=E==1?r:o;G>=r&&G<=o;G+=E)if(c[G]!=null){let J=l[G],Q=A(J);L.push(N=Q),k.push(S(c[G]))}let z={stroke:n(L,k,P,v,C,b),fill:null,clip:null,band:null,gaps:null,flags:po},U=z.stroke,[H,$]=Tf(i,s);if(a.fill!=null||H!=0){let G=z.fill=new Path2D(U),le=a.fillTo(i,s,a.min,a.max,H),J=S(le);v(G,N,J),v(G,B,J)}if(!a.spanGaps){let G=[];G.push(...Ef(l,c,r,o,E,A,t)),z.gaps=G=a.gaps(i,s,r,o,G),z.clip=Kl(G,u.ori,p,y,g,m)}return $!=0&&(z.band=$==2?[bs(i,s,r,o,U,-1),bs(i,s,r,o,U,1)]:bs(i,s,r,o,U,$)),z})}function Yb(n){return Xb($b,n)}function $b(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var ff=new Set;function jm(){for(let n of ff)n.syncRect(!0)}mo&&(Ar(Cx,co,jm),Ar(Rx,co,jm,!0),Ar(Hl,co,()=>{Jt.pxRatio=Et}));var Zb=Og(),Kb=Ug();function Qm(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>df(r,o,e,t))}function Jb(n,e){return n.map((t,i)=>i==0?{}:vn({},e,t))}function df(n,e,t,i){return vn({},e==0?t:i,n)}function Bg(n,e,t){return e==null?ho:[e,t]}var jb=Bg;function Qb(n,e,t){return e==null?ho:Wl(e,t,vf,!0)}function kg(n,e,t,i){return e==null?ho:Yl(e,t,n.scales[i].log,!1)}var eS=kg;function zg(n,e,t,i){return e==null?ho:_f(e,t,n.scales[i].log,!1)}var tS=zg;function nS(n,e,t,i,s){let r=Zn(Im(n),Im(e)),o=e-n,a=zi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Ys.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function eg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Mn((t=+s)*Et))+"px"),[n,e,t]}function iS(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=kt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Jt(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(x,w,I,D){let W=w.valToPct(x);return D+I*(w.dir==-1?1-W:W)}function o(x,w,I,D){let W=w.valToPct(x);return D+I*(w.dir==-1?W:1-W)}function a(x,w,I,D){return w.ori==0?r(x,w,I,D):o(x,w,I,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ci(ux);if(n.id!=null&&(c.id=n.id),hi(c,n.class),n.title){let x=Ci(dx,c);x.textContent=n.title}let u=ki("canvas"),f=i.ctx=u.getContext("2d"),h=Ci(px,c);Ar("click",h,x=>{x.target===p&&(Gt!=Jr||$t!=jr)&&Fn.click(i,x)},!0);let d=i.under=Ci(mx,h);h.appendChild(u);let p=i.over=Ci(gx,h);n=fo(n);let y=+wt(n.pxAlign,1),g=Km(y);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let m=n.ms||.001,b=i.series=s==1?Qm(n.series||[],Hm,$m,!1):Jb(n.series||[null],Ym),A=i.axes=Qm(n.axes||[],Gm,qm,!0),S=i.scales={},P=i.bands=n.bands||[];P.forEach(x=>{x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1)});let C=s==2?b[1].facets[0].scale:b[0].scale,v={axes:_s,series:pt},E=(n.drawOrder||["axes","series"]).map(x=>v[x]);function B(x){let w=x.distr==3?I=>xs(I>0?I:x.clamp(i,I,x.min,x.max,x.key)):x.distr==4?I=>Qh(I,x.asinh):x.distr==100?I=>x.fwd(I):I=>I;return I=>{let D=w(I),{_min:W,_max:K}=x,ae=K-W;return(D-W)/ae}}function N(x){let w=S[x];if(w==null){let I=(n.scales||Ca)[x]||Ca;if(I.from!=null){N(I.from);let D=vn({},S[I.from],I,{key:x});D.valToPct=B(D),S[x]=D}else{w=S[x]=vn({},x==C?Cg:kb,I),w.key=x;let D=w.time,W=w.range,K=Xs(W);if((x!=C||s==2&&!D)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Cm:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Cm:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&Zl(W))){let ae=W;W=(de,xe,De)=>xe==null?ho:Wl(xe,De,ae)}w.range=vt(W||(D?jb:x==C?w.distr==3?eS:w.distr==4?tS:Bg:w.distr==3?kg:w.distr==4?zg:Qb)),w.auto=vt(K?!1:w.auto),w.clamp=vt(w.clamp||Bb),w._min=w._max=null,w.valToPct=B(w)}}}N("x"),N("y"),s==1&&b.forEach(x=>{N(x.scale)}),A.forEach(x=>{N(x.scale)});for(let x in n.scales)N(x);let L=S[C],k=L.distr,z,U;L.ori==0?(hi(c,hx),z=r,U=o):(hi(c,fx),z=o,U=r);let H={};for(let x in S){let w=S[x];(w.min!=null||w.max!=null)&&(H[x]={min:w.min,max:w.max},w.min=w.max=null)}let $=n.tzDate||(x=>new Date(Mn(x/m))),G=n.fmtDate||bf,le=m==1?hb($):pb($),J=km($,Bm(m==1?ub:db,G)),Q=Vm($,zm(gb,G)),se=[],fe=i.legend=vn({},yb,n.legend),he=i.cursor=vn({},Tb,{drag:{y:s==2}},n.cursor),ee=fe.show,me=he.show,ve=fe.markers;fe.idxs=se,ve.width=vt(ve.width),ve.dash=vt(ve.dash),ve.stroke=vt(ve.stroke),ve.fill=vt(ve.fill);let Ae,Se,He,ot=[],Ve=[],ft,ct=!1,st={};if(fe.live){let x=b[1]?b[1].values:null;ct=x!=null,ft=ct?x(i,1,0):{_:0};for(let w in ft)st[w]=mf}if(ee)if(Ae=ki("table",Sx,c),He=ki("tbody",null,Ae),fe.mount(i,Ae),ct){Se=ki("thead",null,Ae,He);let x=ki("tr",null,Se);ki("th",null,x);for(var Yt in ft)ki("th",mm,x).textContent=Yt}else hi(Ae,wx),fe.live&&hi(Ae,Mx);let zt={show:!0},un={show:!1};function Ut(x,w){if(w==0&&(ct||!fe.live||s==2))return ho;let I=[],D=ki("tr",Tx,He,He.childNodes[w]);hi(D,x.class),x.show||hi(D,Er);let W=ki("th",null,D);if(ve.show){let de=Ci(Ex,W);if(w>0){let xe=ve.width(i,w);xe&&(de.style.border=xe+"px "+ve.dash(i,w)+" "+ve.stroke(i,w)),de.style.background=ve.fill(i,w)}}let K=Ci(mm,W);x.label instanceof HTMLElement?K.appendChild(x.label):K.textContent=x.label,w>0&&(ve.show||(K.style.color=x.width>0?ve.stroke(i,w):ve.fill(i,w)),bt("click",W,de=>{if(he._lock)return;Ke(de);let xe=b.indexOf(x);if((de.ctrlKey||de.metaKey)!=fe.isolate){let De=b.some((Ne,Fe)=>Fe>0&&Fe!=xe&&Ne.show);b.forEach((Ne,Fe)=>{Fe>0&&Qi(Fe,De?Fe==xe?zt:un:zt,!0,mn.setSeries)})}else Qi(xe,{show:!x.show},!0,mn.setSeries)},!1),Je&&bt(ym,W,de=>{he._lock||(Ke(de),Qi(b.indexOf(x),eo,!0,mn.setSeries))},!1));for(var ae in ft){let de=ki("td",Ax,D);de.textContent="--",I.push(de)}return[D,I]}let Cn=new Map;function bt(x,w,I,D=!0){let W=Cn.get(w)||{},K=he.bind[x](i,w,I,D);K&&(Ar(x,w,W[x]=K),Cn.set(w,W))}function xn(x,w,I){let D=Cn.get(w)||{};for(let W in D)(x==null||W==x)&&(af(W,w,D[W]),delete D[W]);x==null&&Cn.delete(w)}let en=0,hn=0,O=0,Re=0,Ye=0,at=0,Me=Ye,Ot=at,ze=O,qe=Re,R=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,_e=!1,ye=!1,te=!1,ie=!1,pe=!1;function F(x,w,I){(I||x!=i.width||w!=i.height)&&re(x,w),ut(!1),ye=!0,_e=!0,Bn()}function re(x,w){i.width=en=O=x,i.height=hn=Re=w,Ye=at=0,be(),Ge();let I=i.bbox;R=I.left=wr(Ye*Et,.5),M=I.top=wr(at*Et,.5),q=I.width=wr(O*Et,.5),ue=I.height=wr(Re*Et,.5)}let ne=3;function we(){let x=!1,w=0;for(;!x;){w++;let I=$r(w),D=ji(w);x=w==ne||I&&D,x||(re(i.width,i.height),_e=!0)}}function ge({width:x,height:w}){F(x,w)}i.setSize=ge;function be(){let x=!1,w=!1,I=!1,D=!1;A.forEach((W,K)=>{if(W.show&&W._show){let{side:ae,_size:de}=W,xe=ae%2,De=W.label!=null?W.labelSize:0,Ne=de+De;Ne>0&&(xe?(O-=Ne,ae==3?(Ye+=Ne,D=!0):I=!0):(Re-=Ne,ae==0?(at+=Ne,x=!0):w=!0))}}),Ki[0]=x,Ki[1]=I,Ki[2]=w,Ki[3]=D,O-=Ni[1]+Ni[3],Ye+=Ni[3],Re-=Ni[2]+Ni[0],at+=Ni[0]}function Ge(){let x=Ye+O,w=at+Re,I=Ye,D=at;function W(K,ae){switch(K){case 1:return x+=ae,x-ae;case 2:return w+=ae,w-ae;case 3:return I-=ae,I+ae;case 0:return D-=ae,D+ae}}A.forEach((K,ae)=>{if(K.show&&K._show){let de=K.side;K._pos=W(de,K._size),K.label!=null&&(K._lpos=W(de,K.labelSize))}})}if(he.dataIdx==null){let x=he.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let I=x.prox=vt(x.prox),D=x.bias??=0;he.dataIdx=(W,K,ae,de)=>{if(K==0)return ae;let xe=ae,De=I(W,K,ae,de)??Bt,Ne=De>=0&&De<Bt,Fe=L.ori==0?O:Re,rt=he.left,Tt=e[0],Mt=e[K];if(w.has(Mt[ae])){xe=null;let gt=null,Ze=null,We;if(D==0||D==-1)for(We=ae;gt==null&&We-- >0;)w.has(Mt[We])||(gt=We);if(D==0||D==1)for(We=ae;Ze==null&&We++<Mt.length;)w.has(Mt[We])||(Ze=We);if(gt!=null||Ze!=null)if(Ne){let Wt=gt==null?-1/0:z(Tt[gt],L,Fe,0),sn=Ze==null?1/0:z(Tt[Ze],L,Fe,0),Ln=rt-Wt,Ft=sn-rt;Ln<=Ft?Ln<=De&&(xe=gt):Ft<=De&&(xe=Ze)}else xe=Ze==null?gt:gt==null?Ze:ae-gt<=Ze-ae?gt:Ze}else Ne&&wn(rt-z(Tt[ae],L,Fe,0))>De&&(xe=null);return xe}}let Ke=x=>{he.event=x};he.idxs=se,he._lock=!1;let ce=he.points;ce.show=vt(ce.show),ce.size=vt(ce.size),ce.stroke=vt(ce.stroke),ce.width=vt(ce.width),ce.fill=vt(ce.fill);let Oe=i.focus=vn({},n.focus||{alpha:.3},he.focus),Je=Oe.prox>=0,Ce=Je&&ce.one,lt=[],Vt=[],Hn=[];function oa(x,w){let I=ce.show(i,w);if(I instanceof HTMLElement)return hi(I,bx),hi(I,x.class),os(I,-10,-10,O,Re),p.insertBefore(I,lt[w]),I}function qr(x,w){if(s==1||w>0){let I=s==1&&S[x.scale].time,D=x.value;x.value=I?Nm(D)?Vm($,zm(D,G)):D||Q:D||Ub,x.label=x.label||(I?Ab:Eb)}if(Ce||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Zb||kx,x.fillTo=vt(x.fillTo||zb),x.pxAlign=+wt(x.pxAlign,y),x.pxRound=Km(x.pxAlign),x.stroke=vt(x.stroke||null),x.fill=vt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let I=Fb(Zn(1,x.width),1),D=x.points=vn({},{size:I,width:Zn(1,I*.2),stroke:x.stroke,space:I*2,paths:Kb,_stroke:null,_fill:null},x.points);D.show=vt(D.show),D.filter=vt(D.filter),D.fill=vt(D.fill),D.stroke=vt(D.stroke),D.paths=vt(D.paths),D.pxAlign=x.pxAlign}if(ee){let I=Ut(x,w);ot.splice(w,0,I[0]),Ve.splice(w,0,I[1]),fe.values.push(null)}if(me){se.splice(w,0,null);let I=null;Ce?w==0&&(I=oa(x,w)):w>0&&(I=oa(x,w)),lt.splice(w,0,I),Vt.splice(w,0,0),Hn.splice(w,0,0)}In("addSeries",w)}function xh(x,w){w=w??b.length,x=s==1?df(x,w,Hm,$m):df(x,w,{},Ym),b.splice(w,0,x),qr(b[w],w)}i.addSeries=xh;function vl(x){if(b.splice(x,1),ee){fe.values.splice(x,1),Ve.splice(x,1);let w=ot.splice(x,1)[0];xn(null,w.firstChild),w.remove()}me&&(se.splice(x,1),lt.splice(x,1)[0].remove(),Vt.splice(x,1),Hn.splice(x,1)),In("delSeries",x)}i.delSeries=vl;let Ki=[!1,!1,!1,!1];function ps(x,w){if(x._show=x.show,x.show){let I=x.side%2,D=S[x.scale];D==null&&(x.scale=I?b[1].scale:C,D=S[x.scale]);let W=D.time;x.size=vt(x.size),x.space=vt(x.space),x.rotate=vt(x.rotate),Xs(x.incrs)&&x.incrs.forEach(ae=>{!Ys.has(ae)&&Ys.set(ae,cg(ae))}),x.incrs=vt(x.incrs||(D.distr==2?ab:W?m==1?cb:fb:Tr)),x.splits=vt(x.splits||(W&&D.distr==1?le:D.distr==3?cf:D.distr==4?Pb:Rb)),x.stroke=vt(x.stroke),x.grid.stroke=vt(x.grid.stroke),x.ticks.stroke=vt(x.ticks.stroke),x.border.stroke=vt(x.border.stroke);let K=x.values;x.values=Xs(K)&&!Xs(K[0])?vt(K):W?Xs(K)?km($,Bm(K,G)):Nm(K)?mb($,K):K||J:K||Cb,x.filter=vt(x.filter||(D.distr>=3&&D.log==10?Db:D.distr==3&&D.log==2?Nb:ag)),x.font=eg(x.font),x.labelFont=eg(x.labelFont),x._size=x.size(i,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Ki[w]=!0,x._el=Ci(_x,h))}}function ms(x,w,I,D){let[W,K,ae,de]=I,xe=w%2,De=0;return xe==0&&(de||K)&&(De=w==0&&!W||w==2&&!ae?Mn(Gm.size/3):0),xe==1&&(W||ae)&&(De=w==1&&!K||w==3&&!de?Mn(qm.size/2):0),De}let aa=i.padding=(n.padding||[ms,ms,ms,ms]).map(x=>vt(wt(x,ms))),Ni=i._padding=aa.map((x,w)=>x(i,w,Ki,0)),tn,an=null,ln=null,Ji=s==1?b[0].idxs:null,oi=null,Us=!1;function la(x,w){if(e=x??[],i.data=i._data=e,s==2){tn=0;for(let I=1;I<b.length;I++)tn+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),oi=e[0],tn=oi.length;let I=e;if(k==2){I=e.slice();let D=I[0]=Array(tn);for(let W=0;W<tn;W++)D[W]=W}i._data=e=I}if(ut(!0),In("setData"),k==2&&(ye=!0),w!==!1){let I=L;I.auto(i,Us)?ca():Bs(C,I.min,I.max),te=te||he.left>=0,pe=!0,Bn()}}i.setData=la;function ca(){Us=!0;let x,w;s==1&&(tn>0?(an=Ji[0]=0,ln=Ji[1]=tn-1,x=e[0][an],w=e[0][ln],k==2?(x=an,w=ln):x==w&&(k==3?[x,w]=Yl(x,x,L.log,!1):k==4?[x,w]=_f(x,x,L.log,!1):L.time?w=x+Mn(86400/m):[x,w]=Wl(x,w,vf,!0))):(an=Ji[0]=x=null,ln=Ji[1]=w=null)),Bs(C,x,w)}let Xr,Fs,Yr,T,V,j,X,Y,Te,Pe;function Ee(x,w,I,D,W,K){x??=_m,I??=xf,D??="butt",W??=_m,K??="round",x!=Xr&&(f.strokeStyle=Xr=x),W!=Fs&&(f.fillStyle=Fs=W),w!=Yr&&(f.lineWidth=Yr=w),K!=V&&(f.lineJoin=V=K),D!=j&&(f.lineCap=j=D),I!=T&&f.setLineDash(T=I)}function Ie(x,w,I,D){w!=Fs&&(f.fillStyle=Fs=w),x!=X&&(f.font=X=x),I!=Y&&(f.textAlign=Y=I),D!=Te&&(f.textBaseline=Te=D)}function ke(x,w,I,D,W=0){if(D.length>0&&x.auto(i,Us)&&(w==null||w.min==null)){let K=wt(an,0),ae=wt(ln,D.length-1),de=I.min==null?Dx(D,K,ae,W,x.distr==3):[I.min,I.max];x.min=Vi(x.min,I.min=de[0]),x.max=Zn(x.max,I.max=de[1])}}let tt={min:null,max:null};function dt(){for(let D in S){let W=S[D];H[D]==null&&(W.min==null||H[C]!=null&&W.auto(i,Us))&&(H[D]=tt)}for(let D in S){let W=S[D];H[D]==null&&W.from!=null&&H[W.from]!=null&&(H[D]=tt)}H[C]!=null&&ut(!0);let x={};for(let D in H){let W=H[D];if(W!=null){let K=x[D]=fo(S[D],Gx);if(W.min!=null)vn(K,W);else if(D!=C||s==2)if(tn==0&&K.from==null){let ae=K.range(i,null,null,D);K.min=ae[0],K.max=ae[1]}else K.min=Bt,K.max=-Bt}}if(tn>0){b.forEach((D,W)=>{if(s==1){let K=D.scale,ae=H[K];if(ae==null)return;let de=x[K];if(W==0){let xe=de.range(i,de.min,de.max,K);de.min=xe[0],de.max=xe[1],an=zi(de.min,e[0]),ln=zi(de.max,e[0]),ln-an>1&&(e[0][an]<de.min&&an++,e[0][ln]>de.max&&ln--),D.min=oi[an],D.max=oi[ln]}else D.show&&D.auto&&ke(de,ae,D,e[W],D.sorted);D.idxs[0]=an,D.idxs[1]=ln}else if(W>0&&D.show&&D.auto){let[K,ae]=D.facets,de=K.scale,xe=ae.scale,[De,Ne]=e[W],Fe=x[de],rt=x[xe];Fe!=null&&ke(Fe,H[de],K,De,K.sorted),rt!=null&&ke(rt,H[xe],ae,Ne,ae.sorted),D.min=ae.min,D.max=ae.max}});for(let D in x){let W=x[D],K=H[D];if(W.from==null&&(K==null||K.min==null)){let ae=W.range(i,W.min==Bt?null:W.min,W.max==-Bt?null:W.max,D);W.min=ae[0],W.max=ae[1]}}}for(let D in x){let W=x[D];if(W.from!=null){let K=x[W.from];if(K.min==null)W.min=W.max=null;else{let ae=W.range(i,K.min,K.max,D);W.min=ae[0],W.max=ae[1]}}}let w={},I=!1;for(let D in x){let W=x[D],K=S[D];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let ae=K.distr;K._min=ae==3?xs(K.min):ae==4?Qh(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?xs(K.max):ae==4?Qh(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,w[D]=I=!0}}if(I){b.forEach((D,W)=>{s==2?W>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)ye=!0,In("setScale",D);me&&he.left>=0&&(te=pe=!0)}for(let D in H)H[D]=null}function Be(x){let w=lf(an-1,0,tn-1),I=lf(ln+1,0,tn-1);for(;x[w]==null&&w>0;)w--;for(;x[I]==null&&I<tn-1;)I++;return[w,I]}function pt(){if(tn>0){let x=b.some(w=>w._focus)&&Pe!=Oe.alpha;x&&(f.globalAlpha=Pe=Oe.alpha),b.forEach((w,I)=>{if(I>0&&w.show&&(Kt(I,!1),Kt(I,!0),w._paths==null)){let D=Pe;Pe!=w.alpha&&(f.globalAlpha=Pe=w.alpha);let W=s==2?[0,e[I][0].length-1]:Be(e[I]);w._paths=w.paths(i,I,W[0],W[1]),Pe!=D&&(f.globalAlpha=Pe=D)}}),b.forEach((w,I)=>{if(I>0&&w.show){let D=Pe;Pe!=w.alpha&&(f.globalAlpha=Pe=w.alpha),w._paths!=null&&It(I,!1);{let W=w._paths!=null?w._paths.gaps:null,K=w.points.show(i,I,an,ln,W),ae=w.points.filter(i,I,K,W);(K||ae)&&(w.points._paths=w.points.paths(i,I,an,ln,ae),It(I,!0))}Pe!=D&&(f.globalAlpha=Pe=D),In("drawSeries",I)}}),x&&(f.globalAlpha=Pe=1)}}function Kt(x,w){let I=w?b[x].points:b[x];I._stroke=I.stroke(i,x),I._fill=I.fill(i,x)}function It(x,w){let I=w?b[x].points:b[x],{stroke:D,fill:W,clip:K,flags:ae,_stroke:de=I._stroke,_fill:xe=I._fill,_width:De=I.width}=I._paths;De=kt(De*Et,3);let Ne=null,Fe=De%2/2;w&&xe==null&&(xe=De>0?"#fff":de);let rt=I.pxAlign==1&&Fe>0;if(rt&&f.translate(Fe,Fe),!w){let Tt=R-De/2,Mt=M-De/2,gt=q+De,Ze=ue+De;Ne=new Path2D,Ne.rect(Tt,Mt,gt,Ze)}w?Ue(de,De,I.dash,I.cap,xe,D,W,ae,K):Lt(x,de,De,I.dash,I.cap,xe,D,W,ae,Ne,K),rt&&f.translate(-Fe,-Fe)}function Lt(x,w,I,D,W,K,ae,de,xe,De,Ne){let Fe=!1;xe!=0&&P.forEach((rt,Tt)=>{if(rt.series[0]==x){let Mt=b[rt.series[1]],gt=e[rt.series[1]],Ze=(Mt._paths||Ca).band;Xs(Ze)&&(Ze=rt.dir==1?Ze[0]:Ze[1]);let We,Wt=null;Mt.show&&Ze&&Ux(gt,an,ln)?(Wt=rt.fill(i,Tt)||K,We=Mt._paths.clip):Ze=null,Ue(w,I,D,W,Wt,ae,de,xe,De,Ne,We,Ze),Fe=!0}}),Fe||Ue(w,I,D,W,K,ae,de,xe,De,Ne)}let bn=po|hf;function Ue(x,w,I,D,W,K,ae,de,xe,De,Ne,Fe){Ee(x,w,I,D,W),(xe||De||Fe)&&(f.save(),xe&&f.clip(xe),De&&f.clip(De)),Fe?(de&bn)==bn?(f.clip(Fe),Ne&&f.clip(Ne),_t(W,ae),fn(x,K,w)):de&hf?(_t(W,ae),f.clip(Fe),fn(x,K,w)):de&po&&(f.save(),f.clip(Fe),Ne&&f.clip(Ne),_t(W,ae),f.restore(),fn(x,K,w)):(_t(W,ae),fn(x,K,w)),(xe||De||Fe)&&f.restore()}function fn(x,w,I){I>0&&(w instanceof Map?w.forEach((D,W)=>{f.strokeStyle=Xr=W,f.stroke(D)}):w!=null&&x&&f.stroke(w))}function _t(x,w){w instanceof Map?w.forEach((I,D)=>{f.fillStyle=Fs=D,f.fill(I)}):w!=null&&x&&f.fill(w)}function gs(x,w,I,D){let W=A[x],K;if(D<=0)K=[0,0];else{let ae=W._space=W.space(i,x,w,I,D),de=W._incrs=W.incrs(i,x,w,I,D,ae);K=nS(w,I,de,D,ae)}return W._found=K}function dn(x,w,I,D,W,K,ae,de,xe,De){let Ne=ae%2/2;y==1&&f.translate(Ne,Ne),Ee(de,ae,xe,De,de),f.beginPath();let Fe,rt,Tt,Mt,gt=W+(D==0||D==3?-K:K);I==0?(rt=W,Mt=gt):(Fe=W,Tt=gt);for(let Ze=0;Ze<x.length;Ze++)w[Ze]!=null&&(I==0?Fe=Tt=x[Ze]:rt=Mt=x[Ze],f.moveTo(Fe,rt),f.lineTo(Tt,Mt));f.stroke(),y==1&&f.translate(-Ne,-Ne)}function $r(x){let w=!0;return A.forEach((I,D)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,ut(!1));return}else I._show||(w=!1,I._show=!0,ut(!1));let K=I.side,ae=K%2,{min:de,max:xe}=W,[De,Ne]=gs(D,de,xe,ae==0?O:Re);if(Ne==0)return;let Fe=W.distr==2,rt=I._splits=I.splits(i,D,de,xe,De,Ne,Fe),Tt=W.distr==2?rt.map(We=>oi[We]):rt,Mt=W.distr==2?oi[rt[1]]-oi[rt[0]]:De,gt=I._values=I.values(i,I.filter(i,Tt,D,Ne,Mt),D,Ne,Mt);I._rotate=K==2?I.rotate(i,gt,D,Ne):0;let Ze=I._size;I._size=Ri(I.size(i,gt,D,x)),Ze!=null&&I._size!=Ze&&(w=!1)}),w}function ji(x){let w=!0;return aa.forEach((I,D)=>{let W=I(i,D,Ki,x);W!=Ni[D]&&(w=!1),Ni[D]=W}),w}function _s(){for(let x=0;x<A.length;x++){let w=A[x];if(!w.show||!w._show)continue;let I=w.side,D=I%2,W,K,ae=w.stroke(i,x),de=I==0||I==3?-1:1,[xe,De]=w._found;if(w.label!=null){let Xn=w.labelGap*de,ci=Mn((w._lpos+Xn)*Et);Ie(w.labelFont[0],ae,"center",I==2?"top":gm),f.save(),D==1?(W=K=0,f.translate(ci,Mn(M+ue/2)),f.rotate((I==3?-Gl:Gl)/2)):(W=Mn(R+q/2),K=ci);let yr=rg(w.label)?w.label(i,x,xe,De):w.label;f.fillText(yr,W,K),f.restore()}if(De==0)continue;let Ne=S[w.scale],Fe=D==0?q:ue,rt=D==0?R:M,Tt=w._splits,Mt=Ne.distr==2?Tt.map(Xn=>oi[Xn]):Tt,gt=Ne.distr==2?oi[Tt[1]]-oi[Tt[0]]:xe,Ze=w.ticks,We=w.border,Wt=Ze.show?Ze.size:0,sn=Mn(Wt*Et),Ln=Mn((w.alignTo==2?w._size-Wt-w.gap:w.gap)*Et),Ft=w._rotate*-Gl/180,rn=g(w._pos*Et),ai=(sn+Ln)*de,qn=rn+ai;K=D==0?qn:0,W=D==1?qn:0;let wi=w.font[0],Ui=w.align==1?ao:w.align==2?Kh:Ft>0?ao:Ft<0?Kh:D==0?"center":I==3?Kh:ao,ts=Ft||D==1?"middle":I==2?"top":gm;Ie(wi,ae,Ui,ts);let li=w.font[1]*w.lineGap,Ti=Tt.map(Xn=>g(a(Xn,Ne,Fe,rt))),Fi=w._values;for(let Xn=0;Xn<Fi.length;Xn++){let ci=Fi[Xn];if(ci!=null){D==0?W=Ti[Xn]:K=Ti[Xn],ci=""+ci;let yr=ci.indexOf(`
`)==-1?[ci]:ci.split(/\n/gm);for(let Yn=0;Yn<yr.length;Yn++){let Ip=yr[Yn];Ft?(f.save(),f.translate(W,K+Yn*li),f.rotate(Ft),f.fillText(Ip,0,0),f.restore()):f.fillText(Ip,W,K+Yn*li)}}}Ze.show&&dn(Ti,Ze.filter(i,Mt,x,De,gt),D,I,rn,sn,kt(Ze.width*Et,3),Ze.stroke(i,x),Ze.dash,Ze.cap);let ns=w.grid;ns.show&&dn(Ti,ns.filter(i,Mt,x,De,gt),D,D==0?2:1,D==0?M:R,D==0?ue:q,kt(ns.width*Et,3),ns.stroke(i,x),ns.dash,ns.cap),We.show&&dn([rn],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:q,kt(We.width*Et,3),We.stroke(i,x),We.dash,We.cap)}In("drawAxes")}function ut(x){b.forEach((w,I)=>{I>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let nn=!1,Wn=!1,Dt=[];function pn(){Wn=!1;for(let x=0;x<Dt.length;x++)In(...Dt[x]);Dt.length=0}function Bn(){nn||(Zx(dp),nn=!0)}function yl(x,w=!1){nn=!0,Wn=w,x(i),dp(),w&&Dt.length>0&&queueMicrotask(pn)}i.batch=yl;function dp(){if(oe&&(dt(),oe=!1),ye&&(we(),ye=!1),_e){if(qt(d,ao,Ye),qt(d,"top",at),qt(d,wa,O),qt(d,Ta,Re),qt(p,ao,Ye),qt(p,"top",at),qt(p,wa,O),qt(p,Ta,Re),qt(h,wa,en),qt(h,Ta,hn),u.width=Mn(en*Et),u.height=Mn(hn*Et),A.forEach(({_el:x,_show:w,_size:I,_pos:D,side:W})=>{if(x!=null)if(w){let K=W===3||W===0?I:0,ae=W%2==1;qt(x,ae?"left":"top",D-K),qt(x,ae?"width":"height",I),qt(x,ae?"top":"left",ae?at:Ye),qt(x,ae?"height":"width",ae?Re:O),of(x,Er)}else hi(x,Er)}),Xr=Fs=Yr=V=j=X=Y=Te=T=null,Pe=1,fa(!0),Ye!=Me||at!=Ot||O!=ze||Re!=qe){ut(!1);let x=O/ze,w=Re/qe;if(me&&!te&&he.left>=0){he.left*=x,he.top*=w,Zr&&os(Zr,Mn(he.left),0,O,Re),Kr&&os(Kr,0,Mn(he.top),O,Re);for(let I=0;I<lt.length;I++){let D=lt[I];D!=null&&(Vt[I]*=x,Hn[I]*=w,os(D,Ri(Vt[I]),Ri(Hn[I]),O,Re))}}if(Ht.show&&!ie&&Ht.left>=0&&Ht.width>0){Ht.left*=x,Ht.width*=x,Ht.top*=w,Ht.height*=w;for(let I in Eh)qt(Qr,I,Ht[I])}Me=Ye,Ot=at,ze=O,qe=Re}In("setSize"),_e=!1}en>0&&hn>0&&(f.clearRect(0,0,u.width,u.height),In("drawClear"),E.forEach(x=>x()),In("draw")),Ht.show&&ie&&(xl(Ht),ie=!1),me&&te&&(vr(null,!0,!1),te=!1),fe.show&&fe.live&&pe&&(wh(),pe=!1),l||(l=!0,i.status=1,In("ready")),Us=!1,nn=!1}i.redraw=(x,w)=>{ye=w||!1,x!==!1?Bs(C,L.min,L.max):Bn()};function bh(x,w){let I=S[x];if(I.from==null){if(tn==0){let D=I.range(i,w.min,w.max,x);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(tn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==C&&I.distr==2&&tn>0&&(w.min=zi(w.min,e[0]),w.max=zi(w.max,e[0]),w.min==w.max&&w.max++),H[x]=w,oe=!0,Bn()}}i.setScale=bh;let Sh,Mh,Zr,Kr,pp,mp,Jr,jr,gp,_p,Gt,$t,Os=!1,Fn=he.drag,Rn=Fn.x,Pn=Fn.y;me&&(he.x&&(Sh=Ci(yx,p)),he.y&&(Mh=Ci(xx,p)),L.ori==0?(Zr=Sh,Kr=Mh):(Zr=Mh,Kr=Sh),Gt=he.left,$t=he.top);let Ht=i.select=vn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Qr=Ht.show?Ci(vx,Ht.over?p:d):null;function xl(x,w){if(Ht.show){for(let I in x)Ht[I]=x[I],I in Eh&&qt(Qr,I,x[I]);w!==!1&&In("setSelect")}}i.setSelect=xl;function my(x){if(b[x].show)ee&&of(ot[x],Er);else if(ee&&hi(ot[x],Er),me){let I=Ce?lt[0]:lt[x];I!=null&&os(I,-10,-10,O,Re)}}function Bs(x,w,I){bh(x,{min:w,max:I})}function Qi(x,w,I,D){w.focus!=null&&xy(x),w.show!=null&&b.forEach((W,K)=>{K>0&&(x==K||x==null)&&(W.show=w.show,my(K),s==2?(Bs(W.facets[0].scale,null,null),Bs(W.facets[1].scale,null,null)):Bs(W.scale,null,null),Bn())}),I!==!1&&In("setSeries",x,w),D&&da("setSeries",i,x,w)}i.setSeries=Qi;function gy(x,w){vn(P[x],w)}function _y(x,w){x.fill=vt(x.fill||null),x.dir=wt(x.dir,-1),w=w??P.length,P.splice(w,0,x)}function vy(x){x==null?P.length=0:P.splice(x,1)}i.addBand=_y,i.setBand=gy,i.delBand=vy;function yy(x,w){b[x].alpha=w,me&&lt[x]!=null&&(lt[x].style.opacity=w),ee&&ot[x]&&(ot[x].style.opacity=w)}let vs,ks,_r,eo={focus:!0};function xy(x){if(x!=_r){let w=x==null,I=Oe.alpha!=1;b.forEach((D,W)=>{if(s==1||W>0){let K=w||W==0||W==x;D._focus=w?null:K,I&&yy(W,K?1:Oe.alpha)}}),_r=x,I&&Bn()}}ee&&Je&&bt(xm,Ae,x=>{he._lock||(Ke(x),_r!=null&&Qi(null,eo,!0,mn.setSeries))});function es(x,w,I){let D=S[w];I&&(x=x/Et-(D.ori==1?at:Ye));let W=O;D.ori==1&&(W=Re,x=W-x),D.dir==-1&&(x=W-x);let K=D._min,ae=D._max,de=x/W,xe=K+(ae-K)*de,De=D.distr;return De==3?uo(10,xe):De==4?Ox(xe,D.asinh):De==100?D.bwd(xe):xe}function by(x,w){let I=es(x,C,w);return zi(I,e[0],an,ln)}i.valToIdx=x=>zi(x,e[0]),i.posToIdx=by,i.posToVal=es,i.valToPos=(x,w,I)=>S[w].ori==0?r(x,S[w],I?q:O,I?R:0):o(x,S[w],I?ue:Re,I?M:0),i.setCursor=(x,w,I)=>{Gt=x.left,$t=x.top,vr(null,w,I)};function vp(x,w){qt(Qr,ao,Ht.left=x),qt(Qr,wa,Ht.width=w)}function yp(x,w){qt(Qr,"top",Ht.top=x),qt(Qr,Ta,Ht.height=w)}let ua=L.ori==0?vp:yp,ha=L.ori==1?vp:yp;function Sy(){if(ee&&fe.live)for(let x=s==2?1:0;x<b.length;x++){if(x==0&&ct)continue;let w=fe.values[x],I=0;for(let D in w)Ve[x][I++].firstChild.nodeValue=w[D]}}function wh(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((I,D)=>{se[D]=I}):Vx(x.idx)||se.fill(x.idx),fe.idx=se[0]),ee&&fe.live){for(let I=0;I<b.length;I++)(I>0||s==1&&!ct)&&My(I,se[I]);Sy()}pe=!1,w!==!1&&In("setLegend")}i.setLegend=wh;function My(x,w){let I=b[x],D=x==0&&k==2?oi:e[x],W;ct?W=I.values(i,x,w)??st:(W=I.value(i,w==null?null:D[w],x,w),W=W==null?st:{_:W}),fe.values[x]=W}function vr(x,w,I){gp=Gt,_p=$t,[Gt,$t]=he.move(i,Gt,$t),he.left=Gt,he.top=$t,me&&(Zr&&os(Zr,Mn(Gt),0,O,Re),Kr&&os(Kr,0,Mn($t),O,Re));let D,W=an>ln;vs=Bt,ks=null;let K=L.ori==0?O:Re,ae=L.ori==1?O:Re;if(Gt<0||tn==0||W){D=he.idx=null;for(let de=0;de<b.length;de++){let xe=lt[de];xe!=null&&os(xe,-10,-10,O,Re)}Je&&Qi(null,eo,!0,x==null&&mn.setSeries),fe.live&&(se.fill(D),pe=!0)}else{let de,xe,De;s==1&&(de=L.ori==0?Gt:$t,xe=es(de,C),D=he.idx=zi(xe,e[0],an,ln),De=z(e[0][D],L,K,0));let Ne=-10,Fe=-10,rt=0,Tt=0,Mt=!0,gt="",Ze="";for(let We=s==2?1:0;We<b.length;We++){let Wt=b[We],sn=se[We],Ln=sn==null?null:s==1?e[We][sn]:e[We][1][sn],Ft=he.dataIdx(i,We,D,xe),rn=Ft==null?null:s==1?e[We][Ft]:e[We][1][Ft];if(pe=pe||rn!=Ln||Ft!=sn,se[We]=Ft,We>0&&Wt.show){let ai=Ft==null?-10:Ft==D?De:z(s==1?e[0][Ft]:e[We][0][Ft],L,K,0),qn=rn==null?-10:U(rn,s==1?S[Wt.scale]:S[Wt.facets[1].scale],ae,0);if(Je&&rn!=null){let wi=L.ori==1?Gt:$t,Ui=wn(Oe.dist(i,We,Ft,qn,wi));if(Ui<vs){let ts=Oe.bias;if(ts!=0){let li=es(wi,Wt.scale),Ti=rn>=0?1:-1,Fi=li>=0?1:-1;Fi==Ti&&(Fi==1?ts==1?rn>=li:rn<=li:ts==1?rn<=li:rn>=li)&&(vs=Ui,ks=We)}else vs=Ui,ks=We}}if(pe||Ce){let wi,Ui;L.ori==0?(wi=ai,Ui=qn):(wi=qn,Ui=ai);let ts,li,Ti,Fi,ns,Xn,ci=!0,yr=ce.bbox;if(yr!=null){ci=!1;let Yn=yr(i,We);Ti=Yn.left,Fi=Yn.top,ts=Yn.width,li=Yn.height}else Ti=wi,Fi=Ui,ts=li=ce.size(i,We);if(Xn=ce.fill(i,We),ns=ce.stroke(i,We),Ce)We==ks&&vs<=Oe.prox&&(Ne=Ti,Fe=Fi,rt=ts,Tt=li,Mt=ci,gt=Xn,Ze=ns);else{let Yn=lt[We];Yn!=null&&(Vt[We]=Ti,Hn[We]=Fi,Am(Yn,ts,li,ci),Tm(Yn,Xn,ns),os(Yn,Ri(Ti),Ri(Fi),O,Re))}}}}if(Ce){let We=Oe.prox,Wt=_r==null?vs<=We:vs>We||ks!=_r;if(pe||Wt){let sn=lt[0];sn!=null&&(Vt[0]=Ne,Hn[0]=Fe,Am(sn,rt,Tt,Mt),Tm(sn,gt,Ze),os(sn,Ri(Ne),Ri(Fe),O,Re))}}}if(Ht.show&&Os)if(x!=null){let[de,xe]=mn.scales,[De,Ne]=mn.match,[Fe,rt]=x.cursor.sync.scales,Tt=x.cursor.drag;if(Rn=Tt._x,Pn=Tt._y,Rn||Pn){let{left:Mt,top:gt,width:Ze,height:We}=x.select,Wt=x.scales[Fe].ori,sn=x.posToVal,Ln,Ft,rn,ai,qn,wi=de!=null&&De(de,Fe),Ui=xe!=null&&Ne(xe,rt);wi&&Rn?(Wt==0?(Ln=Mt,Ft=Ze):(Ln=gt,Ft=We),rn=S[de],ai=z(sn(Ln,Fe),rn,K,0),qn=z(sn(Ln+Ft,Fe),rn,K,0),ua(Vi(ai,qn),wn(qn-ai))):ua(0,K),Ui&&Pn?(Wt==1?(Ln=Mt,Ft=Ze):(Ln=gt,Ft=We),rn=S[xe],ai=U(sn(Ln,rt),rn,ae,0),qn=U(sn(Ln+Ft,rt),rn,ae,0),ha(Vi(ai,qn),wn(qn-ai))):ha(0,ae)}else Ah()}else{let de=wn(gp-pp),xe=wn(_p-mp);if(L.ori==1){let rt=de;de=xe,xe=rt}Rn=Fn.x&&de>=Fn.dist,Pn=Fn.y&&xe>=Fn.dist;let De=Fn.uni;De!=null?Rn&&Pn&&(Rn=de>=De,Pn=xe>=De,!Rn&&!Pn&&(xe>de?Pn=!0:Rn=!0)):Fn.x&&Fn.y&&(Rn||Pn)&&(Rn=Pn=!0);let Ne,Fe;Rn&&(L.ori==0?(Ne=Jr,Fe=Gt):(Ne=jr,Fe=$t),ua(Vi(Ne,Fe),wn(Fe-Ne)),Pn||ha(0,ae)),Pn&&(L.ori==1?(Ne=Jr,Fe=Gt):(Ne=jr,Fe=$t),ha(Vi(Ne,Fe),wn(Fe-Ne)),Rn||ua(0,K)),!Rn&&!Pn&&(ua(0,0),ha(0,0))}if(Fn._x=Rn,Fn._y=Pn,x==null){if(I){if(Pp!=null){let[de,xe]=mn.scales;mn.values[0]=de!=null?es(L.ori==0?Gt:$t,de):null,mn.values[1]=xe!=null?es(L.ori==1?Gt:$t,xe):null}da(Jh,i,Gt,$t,O,Re,D)}if(Je){let de=I&&mn.setSeries,xe=Oe.prox;_r==null?vs<=xe&&Qi(ks,eo,!0,de):vs>xe?Qi(null,eo,!0,de):ks!=_r&&Qi(ks,eo,!0,de)}}pe&&(fe.idx=D,wh()),w!==!1&&In("setCursor")}let zs=null;Object.defineProperty(i,"rect",{get(){return zs==null&&fa(!1),zs}});function fa(x=!1){x?zs=null:(zs=p.getBoundingClientRect(),In("syncRect",zs))}function xp(x,w,I,D,W,K,ae){he._lock||Os&&x!=null&&x.movementX==0&&x.movementY==0||(Th(x,w,I,D,W,K,ae,!1,x!=null),x!=null?vr(null,!0,!0):vr(w,!0,!1))}function Th(x,w,I,D,W,K,ae,de,xe){if(zs==null&&fa(!1),Ke(x),x!=null)I=x.clientX-zs.left,D=x.clientY-zs.top;else{if(I<0||D<0){Gt=-10,$t=-10;return}let[De,Ne]=mn.scales,Fe=w.cursor.sync,[rt,Tt]=Fe.values,[Mt,gt]=Fe.scales,[Ze,We]=mn.match,Wt=w.axes[0].side%2==1,sn=L.ori==0?O:Re,Ln=L.ori==1?O:Re,Ft=Wt?K:W,rn=Wt?W:K,ai=Wt?D:I,qn=Wt?I:D;if(Mt!=null?I=Ze(De,Mt)?a(rt,S[De],sn,0):-10:I=sn*(ai/Ft),gt!=null?D=We(Ne,gt)?a(Tt,S[Ne],Ln,0):-10:D=Ln*(qn/rn),L.ori==1){let wi=I;I=D,D=wi}}xe&&(w==null||w.cursor.event.type==Jh)&&((I<=1||I>=O-1)&&(I=wr(I,O)),(D<=1||D>=Re-1)&&(D=wr(D,Re))),de?(pp=I,mp=D,[Jr,jr]=he.move(i,I,D)):(Gt=I,$t=D)}let Eh={width:0,height:0,left:0,top:0};function Ah(){xl(Eh,!1)}let bp,Sp,Mp,wp;function Tp(x,w,I,D,W,K,ae){Os=!0,Rn=Pn=Fn._x=Fn._y=!1,Th(x,w,I,D,W,K,ae,!0,!1),x!=null&&(bt(jh,sf,Ep,!1),da(vm,i,Jr,jr,O,Re,null));let{left:de,top:xe,width:De,height:Ne}=Ht;bp=de,Sp=xe,Mp=De,wp=Ne}function Ep(x,w,I,D,W,K,ae){Os=Fn._x=Fn._y=!1,Th(x,w,I,D,W,K,ae,!1,!0);let{left:de,top:xe,width:De,height:Ne}=Ht,Fe=De>0||Ne>0,rt=bp!=de||Sp!=xe||Mp!=De||wp!=Ne;if(Fe&&rt&&xl(Ht),Fn.setScale&&Fe&&rt){let Tt=de,Mt=De,gt=xe,Ze=Ne;if(L.ori==1&&(Tt=xe,Mt=Ne,gt=de,Ze=De),Rn&&Bs(C,es(Tt,C),es(Tt+Mt,C)),Pn)for(let We in S){let Wt=S[We];We!=C&&Wt.from==null&&Wt.min!=Bt&&Bs(We,es(gt+Ze,We),es(gt,We))}Ah()}else he.lock&&(he._lock=!he._lock,vr(w,!0,x!=null));x!=null&&(xn(jh,sf),da(jh,i,Gt,$t,O,Re,null))}function wy(x,w,I,D,W,K,ae){if(he._lock)return;Ke(x);let de=Os;if(Os){let xe=!0,De=!0,Ne=10,Fe,rt;L.ori==0?(Fe=Rn,rt=Pn):(Fe=Pn,rt=Rn),Fe&&rt&&(xe=Gt<=Ne||Gt>=O-Ne,De=$t<=Ne||$t>=Re-Ne),Fe&&xe&&(Gt=Gt<Jr?0:O),rt&&De&&($t=$t<jr?0:Re),vr(null,!0,!0),Os=!1}Gt=-10,$t=-10,se.fill(null),vr(null,!0,!0),de&&(Os=de)}function Ap(x,w,I,D,W,K,ae){he._lock||(Ke(x),ca(),Ah(),x!=null&&da(bm,i,Gt,$t,O,Re,null))}function Cp(){A.forEach(iS),F(i.width,i.height,!0)}Ar(Hl,co,Cp);let to={};to.mousedown=Tp,to.mousemove=xp,to.mouseup=Ep,to.dblclick=Ap,to.setSeries=(x,w,I,D)=>{let W=mn.match[2];I=W(i,w,I),I!=-1&&Qi(I,D,!0,!1)},me&&(bt(vm,p,Tp),bt(Jh,p,xp),bt(ym,p,x=>{Ke(x),fa(!1)}),bt(xm,p,wy),bt(bm,p,Ap),ff.add(i),i.syncRect=fa);let bl=i.hooks=n.hooks||{};function In(x,w,I){Wn?Dt.push([x,w,I]):x in bl&&bl[x].forEach(D=>{D.call(null,i,w,I)})}(n.plugins||[]).forEach(x=>{for(let w in x.hooks)bl[w]=(bl[w]||[]).concat(x.hooks[w])});let Rp=(x,w,I)=>I,mn=vn({key:null,setSeries:!1,filters:{pub:Lm,sub:Lm},scales:[C,b[1]?b[1].scale:null],match:[Dm,Dm,Rp],values:[null,null]},he.sync);mn.match.length==2&&mn.match.push(Rp),he.sync=mn;let Pp=mn.key,Ch=Rg(Pp);function da(x,w,I,D,W,K,ae){mn.filters.pub(x,w,I,D,W,K,ae)&&Ch.pub(x,w,I,D,W,K,ae)}Ch.sub(i);function Ty(x,w,I,D,W,K,ae){mn.filters.sub(x,w,I,D,W,K,ae)&&to[x](null,w,I,D,W,K,ae)}i.pub=Ty;function Ey(){Ch.unsub(i),ff.delete(i),Cn.clear(),af(Hl,co,Cp),c.remove(),Ae?.remove(),In("destroy")}i.destroy=Ey;function Rh(){In("init",n,e),la(e||n.data,!1),H[C]?bh(C,H[C]):ca(),ie=Ht.show&&(Ht.width>0||Ht.height>0),te=pe=!0,F(n.width,n.height)}return b.forEach(qr),A.forEach(ps),t?t instanceof HTMLElement?(t.appendChild(c),Rh()):t(i,Rh):Rh(),i}Jt.assign=vn;Jt.fmtNum=yf;Jt.rangeNum=Wl;Jt.rangeLog=Yl;Jt.rangeAsinh=_f;Jt.orient=Rr;Jt.pxRatio=Et;Jt.join=$x;Jt.fmtDate=bf,Jt.tzDate=rb;Jt.sync=Rg;{Jt.addGap=Vb,Jt.clipGaps=Kl;let n=Jt.paths={points:Ug};n.linear=Og,n.stepped=Wb,n.bars=qb,n.spline=Yb}function Qe(n){let e=document.querySelector(".haptonic")??document.documentElement;return getComputedStyle(e).getPropertyValue(`--${n}`).trim()}function ti(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}function vo(n,e,t,i=[]){let{ctx:s,bbox:r}=n,o=n.valToPos(e,"x",!0);o<r.left||o>r.left+r.width||xo(s,[o,r.top],[o,r.top+r.height],t,i)}function yo(n,e,t,i=[]){let{ctx:s,bbox:r}=n,o=n.valToPos(e,"y",!0);xo(s,[r.left,o],[r.left+r.width,o],t,i)}function xo(n,e,t,i,s=[]){n.save(),n.strokeStyle=Qe(i),n.lineWidth=1.5*devicePixelRatio,n.setLineDash(s.map(r=>r*devicePixelRatio)),n.beginPath(),n.moveTo(...e),n.lineTo(...t),n.stroke(),n.restore()}function bo(n,[e,t],i,s=5){n.save(),n.beginPath(),n.arc(e,t,s*devicePixelRatio,0,2*Math.PI),n.fillStyle=Qe(i),n.strokeStyle=Qe("paper"),n.lineWidth=2*devicePixelRatio,n.fill(),n.stroke(),n.restore()}function ec(n,[e,t],i){let{ctx:s,bbox:r}=n,[o,a]=[n.valToPos(e,"x",!0),n.valToPos(t,"x",!0)];s.fillStyle=Qe(i),s.fillRect(o,r.top,a-o,r.height)}var sS=240;function $s(n){return Math.max(n.clientWidth,sS)}function Zs(n,e,t,i){let s=[...i,ti(()=>n.redraw(!1,!0))],r=new ResizeObserver(()=>n.setSize(t()));return r.observe(e),()=>{r.disconnect();for(let o of s)o();n.destroy()}}function So(n,e){n.over.addEventListener("click",({clientX:t,clientY:i})=>{let s=n.over.getBoundingClientRect();e(t-s.left,i-s.top)})}function Ks({ctx:n,bbox:e},t){n.save(),n.beginPath(),n.rect(e.left,e.top,e.width,e.height),n.clip(),t(),n.restore()}var rS={preview:{colour:"accent",dash:[5,3],width:1.6},certified:{colour:"ink",dash:[],width:1.6},held:{colour:"curve-1",dash:[1.5,3],width:1.5}};function Cf(n,e,t,i,s){let{ctx:r}=n,{colour:o,dash:a,width:l}=rS[s],c=Array.from(e.distance,h=>n.valToPos(h,"x",!0)),u=(h,d)=>{let p=(t.frequency[h]??NaN)+d*(t.error[h]??NaN);return n.valToPos(p/i,"y",!0)},f=(h,d,p=!1)=>{for(let y=0;y<e.rows;y++){let g=p?e.rows-1-y:y;r.lineTo(c[g]??0,u(g*e.bands+h,d))}};r.save(),r.fillStyle=r.strokeStyle=Qe(o),r.lineWidth=l*devicePixelRatio,r.setLineDash(a.map(h=>h*devicePixelRatio));for(let h=0;h<e.bands;h++)s==="preview"&&(r.globalAlpha=.2,r.beginPath(),f(h,1),f(h,-1,!0),r.fill(),r.globalAlpha=1),r.beginPath(),f(h,0),r.stroke();if(s==="held")for(let h of t.gaps.filter(({complete:d})=>d))for(let d of[h.lower,h.upper]){let p=n.valToPos(d/i,"y",!0);r.beginPath(),r.moveTo(n.bbox.left,p),r.lineTo(n.bbox.left+n.bbox.width,p),r.stroke()}r.restore()}var oS=320,aS=.72,lS=40;function Vg({diagram:n,choice:e,newer:t}){let i=Nt(null);return Oi(()=>{let s=i.current;if(s!==null)return cS(s,n,e,t)},[n,e,t]),_("div",{class:"curves",ref:i})}function cS(n,e,t,{layer:i,isWaiting:s}){let r=()=>t.unit.peek().factor,o=e.branches(),a=()=>[Array.from(e.distance),...o.map(d=>d.map(p=>p===null?null:p/r()))],l=()=>{let d=$s(n);return{width:d,height:Math.max(oS,Math.min(aS*d,.7*innerHeight))}},c=e.corners.map(({row:d})=>e.distance[d]??0),u={stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")},grid:{}},f=new Jt({...l(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(d,p,y)=>[p,y]},y:{range:(d,p,y)=>p===null?[0,1]:[p<.2*y?0:p,y]}},axes:[{...u,splits:()=>c,values:()=>e.corners.map(({label:d})=>d),font:"15px system-ui, sans-serif",grid:{stroke:()=>Qe("rule"),width:1}},{...u,size:48,font:"13px system-ui, sans-serif",grid:{show:!1},label:"frequency",labelFont:"14px system-ui, sans-serif",labelSize:24,values:(d,p)=>p.map(y=>`${Number(y.toPrecision(6))}`)}],series:[{},...o.map(()=>({stroke:()=>i.peek()!==null?"transparent":Qe(s.peek()?"rule":"ink"),width:1.6,points:{show:!1}}))],hooks:{drawClear:[d=>Ks(d,()=>{let p=t.held.peek(),y=s.peek()?[]:(i.peek()??e).gaps;hS(d,y,e.carrier,r()),p!==null&&Cf(d,e,p.layer,r(),"held")})],draw:[d=>{let p=i.peek();p!==null&&Ks(d,()=>Cf(d,e,p,r(),p.isPreview?"preview":"certified")),dS(d,e,t,p)}]}},a(),n),h=()=>f.setScale("y",{min:0,max:e.top/r()});return h(),So(f,(d,p)=>{let y=uS(f,e,r(),d,p);y!==void 0&&(t.point.value=y)}),Zs(f,n,l,[Ct(()=>{let d=f.axes[1];d!==void 0&&(d.label=on("frequency",t.unit.value)),f.setData(a(),!0),h()}),Ct(()=>{let d=e.at(t.point.value)/r();i.value,s.value,t.held.value,d>(f.scales.y?.max??1/0)?f.setScale("y",{min:0,max:1.03*d}):f.redraw(!1,!1)})])}function uS(n,e,t,i,s){let[r,o]=[void 0,lS];for(let a=0;a<e.rows;a++){let l=n.valToPos(e.distance[a]??0,"x")-i;if(!(Math.abs(l)>o))for(let c=0;c<e.bands;c++){let u=Math.hypot(l,n.valToPos(e.at({row:a,band:c})/t,"y")-s);u<o&&([r,o]=[{row:a,band:c},u])}}return r}function hS(n,e,t,i){let{ctx:s,bbox:r}=n;for(let o of e){let a=n.valToPos(o.upper/i,"y",!0),l=n.valToPos(o.lower/i,"y",!0)-a;o.complete?(s.fillStyle=Qe("gap"),s.fillRect(r.left,a,r.width,l)):o.waves!=="all"&&fS(s,r.left,a,r.width,l)}t!==void 0&&yo(n,t/i,"carrier",[7,5])}function fS(n,e,t,i,s){let r=12*devicePixelRatio;n.save(),n.beginPath(),n.rect(e,t,i,s),n.clip(),n.beginPath();for(let o=e-s;o<e+i;o+=r)n.moveTo(o,t+s),n.lineTo(o+s,t);n.strokeStyle=Qe("gap"),n.lineWidth=2*devicePixelRatio,n.stroke(),n.restore()}function dS(n,e,t,i){let s=t.point.peek(),r=n.valToPos(e.distance[s.row]??0,"x",!0),o=i?.frequency[s.row*e.bands+s.band]??e.at(s),a=n.valToPos(o/t.unit.peek().factor,"y",!0);bo(n.ctx,[r,a],"accent",6)}var tc=class{constructor(e){this.data=e;this.distance=e.values("distance"),this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),[this.rows=0,this.bands=0]=e.shape("frequency"),this.names=e.parsed("character_names");let t=e.parsed("path_labels"),i=e.parsed("path_corners");this.corners=t.map((r,o)=>({label:r,row:i[o]??0}));let s=e.header.attrs.carrier_hz;this.carrier=typeof s=="number"?s:void 0,this.top=Number(e.header.extra.top),this.units=is(e),this.gaps=Rf(e)}data;distance;frequency;error;rows;bands;gaps;corners;carrier;top;units;names;branches(){let e=this.data.values("branch"),t=new Map;return e.forEach((i,s)=>{let r=t.get(i)??Array(this.rows).fill(null);r[Math.floor(s/this.bands)]=this.frequency[s]??null,t.set(i,r)}),[...t.values()]}at({row:e,band:t}){return this.frequency[e*this.bands+t]??NaN}errorAt({row:e,band:t}){return this.error[e*this.bands+t]??NaN}nature({row:e,band:t}){return this.motion(this.data.values("character")[e*this.bands+t])}motion(e){return this.names[e??-1]??""}parity({row:e,band:t}){let i=e*this.bands+t;return Pf(this.data.values("parity")[i],"the mirror of the path",this.data.values("middle_parity")[i])}velocity({row:e,band:t}){let i=this.data.values("group_velocity"),s=2*(e*this.bands+t),[r,o]=[i[s]??NaN,i[s+1]??NaN];return Number.isFinite(r)&&Number.isFinite(o)?[r,o]:void 0}phases(e){let t=this.data.values("kappa");return[t[2*e]??0,t[2*e+1]??0]}place(e){let t=this.corners.find(a=>a.row===e);if(t!==void 0)return t.label;let i=this.corners.findIndex(a=>a.row>e),[s,r]=[this.corners[i-1],this.corners[i]];if(s===void 0||r===void 0)return"";let o=(e-s.row)/(r.row-s.row);return`${Number(o.toFixed(3))} of ${s.label}-${r.label}`}belowGap(e){let t=e.below-1,i=0;for(let s=1;s<this.rows;s++)this.at({row:s,band:t})>this.at({row:i,band:t})&&(i=s);return{row:i,band:t}}};function Rf(n){if(!n.has("gap_below"))return[];let e=t=>n.values(t);return Array.from(e("gap_below"),(t,i)=>({below:t,lower:e("gap_lower")[i]??NaN,upper:e("gap_upper")[i]??NaN,lowerError:e("gap_lower_error")[i]??NaN,upperError:e("gap_upper_error")[i]??NaN,complete:e("gap_complete")[i]===1,direction:n.texts("gap_direction")[i]??"",waves:n.texts("gap_waves")[i]??""}))}function Pf(n,e,t){let i=["even","odd"][Gg(n)],s=["symmetric","antisymmetric"][Gg(t)];return[i&&`${i} under ${e}`,s&&`${s} about the plate's middle plane`].filter(Boolean).join(", ")}function Gg(n){return n===1?0:n===-1?1:-1}function Hg(n,e){let t=i=>e===void 0?i.upper-i.lower:Wg(i,e).room;return n.filter(({complete:i})=>i).sort((i,s)=>t(s)-t(i))[0]}function Wg(n,e){let[t,i]=[e-n.lower,n.upper-e];return t<i?{room:t,error:n.lowerError}:{room:i,error:n.upperError}}function qg(n,e,t){let i=Hg(n,e),{factor:s}=t,r=(l,c)=>kn(l/s,c/s),o=(l,c)=>$n(r(l,c),t);if(i===void 0)return{gap:"none complete below the last band"};let a=e===void 0?void 0:Wg(i,e);return{gap:$n(`${r(i.lower,i.lowerError)} to ${r(i.upper,i.upperError)}`,t),width:o(i.upper-i.lower,i.lowerError+i.upperError),...a&&e!==void 0?{[`margin at ${$n(rs(e/s),t)}`]:o(a.room,a.error)}:{}}}function Xg({gaps:n,carrier:e,unit:t}){let i=Hg(n,e),s=i!==void 0&&i.upper-i.lower>i.lowerError+i.upperError;return _("dl",{class:"edges",children:[Object.entries(qg(n,e,t)).map(([r,o])=>_("div",{children:[_("dt",{children:r}),_("dd",{children:o})]})),i!==void 0&&!s&&_("div",{children:[_("dt",{children:"narrower than its errors"}),_("dd",{children:"may be closed"})]})]})}function Yg({held:n,now:e,unit:t,isPreview:i,drop:s}){let r=({gaps:l,carrier:c})=>qg(l,c,t),a=[...Object.keys(e.design).filter(l=>e.design[l]!==n.design[l]).map(l=>[l,n.design[l]??"",e.design[l]??""]),...[...new Set([...Object.keys(r(n)),...Object.keys(r(e))])].map(l=>[l,r(n)[l]??"",r(e)[l]??""])];return _("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Held design and this one",children:[_("table",{children:[_("caption",{children:"Held design and this one"}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"quantity"}),_("th",{scope:"col",children:"held"}),_("th",{scope:"col",children:i?"preview":"this design"})]})}),_("tbody",{children:a.map(([l,c,u])=>_("tr",{children:[_("th",{scope:"row",children:l}),_("td",{children:c}),_("td",{children:u})]}))})]}),_("button",{type:"button",onClick:s,children:"Let go of the held design"})]})}function Mo(){return matchMedia("(prefers-reduced-motion: reduce)").matches}var Js=class{constructor({playing:e,pace:t},i,...s){this.draw=i;for(let a of s)this.seen.observe(a);let r=0,o=a=>{r>0&&(this.moment=(this.moment+(a-r)/1e3*t.peek())%1),r=a,!document.hidden&&this.hidden.size<s.length&&i(),this.frame=requestAnimationFrame(o)};this.stop=Ct(()=>{cancelAnimationFrame(this.frame),r=0,e.value&&(this.frame=requestAnimationFrame(o))})}draw;moment=0;frame=0;stop;hidden=new Set;seen=new IntersectionObserver(e=>{for(let{target:t,isIntersecting:i}of e)i?this.hidden.delete(t):this.hidden.add(t)});at(e){this.moment=e,this.draw()}end(){cancelAnimationFrame(this.frame),this.seen.disconnect(),this.stop()}};var nc=6,ic=.5;function $g(n){let e=n.gaps[0];return{point:$e(e?n.belowGap(e):{row:n.corners[1]?.row??0,band:0}),playing:$e(!Mo()),swing:$e(.15),pace:$e(.7),copies:$e([2,2]),unit:$e(ss(n.units,Math.max(...n.frequency))),listing:$e("none"),held:$e(null)}}function sc(n,{row:e,band:t},i,s){return{row:Math.min(Math.max(e+i,0),n.rows-1),band:Math.min(Math.max(t+s,0),n.bands-1)}}function Zg(n,{band:e}){let t=[...n.gaps].filter(s=>s.waves==="all").sort((s,r)=>s.below-r.below),i=t.find(s=>s.below-1>e)??t[0];return i&&n.belowGap(i)}var pS=10,Kg=.05;function Jg(n,e,t){let i=(o,a)=>e.point.value=sc(n,e.point.value,o,a),s=o=>e.swing.value=Math.min(Math.max(e.swing.value+o,0),ic),r=o=>o.shiftKey?pS:1;return[{keys:"← →",effect:"previous or next wavevector; ten with Shift",actions:{ArrowLeft:o=>i(-r(o),0),ArrowRight:o=>i(r(o),0)}},{keys:"↑ ↓",effect:"next higher or lower band",actions:{ArrowUp:()=>i(0,1),ArrowDown:()=>i(0,-1)}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},{keys:"+ −",effect:"larger or smaller displacement",actions:{"+":()=>s(Kg),"-":()=>s(-Kg)}},{keys:"g",effect:"lower edge of the next gap",actions:{g:()=>e.point.value=Zg(n,e.point.value)??e.point.value}},...t?[{keys:"h",effect:"hold this design, or let it go",actions:{h:t}}]:[],...Ei(e.listing)]}var mS=.2,gS=.1;function _S({data:n,at:e}){if(n===null)return null;if(e!==null)return vS(n,e);let[t,i]=[n.values("frequency"),n.values("frequency_error")];return{isPreview:!1,frequency:t,error:i,gaps:Rf(n)}}function jg(n){let e=Qn(()=>n?.value?_S(n.value):null);return{layer:e,isWaiting:Qn(()=>!!n?.value&&e.value===null)}}var Qg=({frequency:n,error:e,gaps:t})=>({isPreview:!1,frequency:n,error:e,gaps:t});function vS(n,e){let t=n.values("value"),i=t.length-1;if(e<(t[0]??NaN)*(1-1e-9)||e>(t[i]??NaN)*(1+1e-9))return null;let s=Math.max(1,t.findIndex(m=>m>=e)),[r,o]=[t[s-1]??0,t[s]??1],a=o-r,l=Math.min(Math.max((e-r)/a,0),1),c=m=>{let b=n.values(m).length/t.length,A=k=>{let z=n.values(k);return[z.subarray((s-1)*b,s*b),z.subarray(s*b,(s+1)*b)]},[[S,P],[C,v],[E,B]]=[A(m),A(`${m}_error`),A(`${m}_bend`)],N=(k,z,U)=>(1-l)*(k[U]??NaN)+l*(z[U]??NaN),L=a*l*(1-l);return[Float64Array.from(S,(k,z)=>N(S,P,z)),Float64Array.from(S,(k,z)=>N(C,v,z)+L*((E[z]??NaN)+(B[z]??NaN)))]},[u,f]=c("frequency"),h=gS*Math.max(...u);if(u.some((m,b)=>!((f[b]??NaN)<=mS*Math.max(m,h))))return null;let[d,p]=c("edge"),y=d.length/2,g=Array.from({length:y},(m,b)=>({below:b+1,lower:d[b]??NaN,upper:d[y+b]??NaN,lowerError:p[b]??NaN,upperError:p[y+b]??NaN,complete:!0,direction:"all",waves:"all"}));return{isPreview:!0,frequency:u,error:f,gaps:g.filter(({lower:m,upper:b})=>b>m)}}var wo=Ny(f_(),1);function d_(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),6e4)}var lc=40,cc=40,Uf="video/webm",zS=6,p_=new WeakMap;function To(n,e){p_.set(n,e)}function Eo({canvas:n,name:e,caption:t}){let[i,s]=Hs(""),r=typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported(Uf),o=(a,l)=>async()=>{if(n.current!==null){s(`The ${a} is made.`),await new Promise(c=>setTimeout(c,cc));try{d_(await l(new Ff(n.current,t)),`${e}.${a.toLowerCase()}`),s("")}catch(c){s(`The ${a} cannot be made: ${String(c)}`)}}};return _("p",{class:"sides film",children:[_("span",{children:"Save the motion"}),_("button",{type:"button",onClick:()=>{o("GIF",VS)()},children:"GIF"}),r&&_("button",{type:"button",onClick:()=>{o("WebM",GS)()},children:"WebM"}),_("span",{role:"status",children:i})]})}var Ff=class{constructor(e,t){this.canvas=e;this.caption=t;let i=p_.get(e),s=this.copy.getContext("2d",{willReadFrequently:!0});if(i===void 0||s===null)throw new Error("the canvas does not move");[this.draw,this.context]=[i,s],[this.copy.width,this.copy.height]=[e.width,e.height]}canvas;caption;copy=document.createElement("canvas");context;draw;show(e){let{context:t,copy:i}=this;this.draw(e),t.fillStyle=Qe("panel"),t.fillRect(0,0,i.width,i.height),t.drawImage(this.canvas,0,0),t.font=`${13*devicePixelRatio}px system-ui, sans-serif`,t.fillStyle=Qe("ink");let s=zS*devicePixelRatio;return t.fillText(this.caption,s,i.height-s,i.width-2*s),t}};async function VS(n){let{width:e,height:t}=n.copy,i=(0,wo.GIFEncoder)(),s;for(let r=0;r<lc;r++){let{data:o}=n.show(r/lc).getImageData(0,0,e,t);s??=(0,wo.quantize)(o,256),i.writeFrame((0,wo.applyPalette)(o,s),e,t,r===0?{palette:s,delay:cc}:{delay:cc}),r%5===4&&await new Promise(a=>setTimeout(a))}return i.finish(),new Blob([i.bytes()],{type:"image/gif"})}async function GS(n){n.show(0);let e=n.copy.captureStream(),t=new MediaRecorder(e,{mimeType:Uf,videoBitsPerSecond:8e6}),i=[];t.ondataavailable=({data:r})=>i.push(r);let s=new Promise(r=>t.onstop=r);t.start();for(let r=0;r<lc;r++)n.show(r/lc),await new Promise(o=>setTimeout(o,cc));t.stop(),await s;for(let r of e.getTracks())r.stop();return new Blob(i,{type:Uf})}var ur={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},hr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},V_=0,cd=1,G_=2;var il=1,H_=2,Jo=3,fr=0,jn=1,Di=2,kr=0,jo=1,ud=2,hd=3,fd=4,W_=5;var zr=100,q_=101,X_=102,Y_=103,$_=104,Z_=200,K_=201,J_=202,j_=203,dd=204,pd=205,Q_=206,e0=207,t0=208,n0=209,i0=210,s0=211,r0=212,o0=213,a0=214,Nc=0,Uc=1,Fc=2,Vo=3,Oc=4,Bc=5,kc=6,zc=7,md=0,l0=1,c0=2,hs=0,gd=1,_d=2,vd=3,yd=4,xd=5,bd=6,Sd=7;var Md=300,Vr=301,Qo=302,pu=303,mu=304,Vc=1e3,ls=1001,Gc=1002,Un=1003,u0=1004;var sl=1005;var On=1006,gu=1007;var Is=1008;var Mi=1009,wd=1010,Td=1011,ea=1012,_u=1013,Xi=1014,Yi=1015,$i=1016,vu=1017,yu=1018,Gr=1020,Ed=35902,Ad=35899,Cd=1021,Rd=1022,Zi=1023,Cs=1026,Ls=1027,Pd=1028,xu=1029,dr=1030,bu=1031;var Su=1033,rl=33776,ol=33777,al=33778,ll=33779,Mu=35840,wu=35841,Tu=35842,Eu=35843,Au=36196,Cu=37492,Ru=37496,Pu=37488,Iu=37489,cl=37490,Lu=37491,Du=37808,Nu=37809,Uu=37810,Fu=37811,Ou=37812,Bu=37813,ku=37814,zu=37815,Vu=37816,Gu=37817,Hu=37818,Wu=37819,qu=37820,Xu=37821,Yu=36492,$u=36494,Zu=36495,Ku=36283,Ju=36284,ul=36285,ju=36286;var ka=2300,Hc=2301,Lc=2302,id=2303,sd=2400,rd=2401,od=2402;var h0=3200;var Id=0,f0=1,Ds="",gi="srgb",za="srgb-linear",Va="linear",Pt="srgb";var Dc=7680;var d0=519,p0=512,m0=513,g0=514,Ld=515,_0=516,v0=517,Dd=518,Nd=519,y0=35044;var Ud="300 es",Ii=2e3,Ga=2001;function HS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function WS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ha(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function x0(){let n=Ha("canvas");return n.style.display="block",n}var m_={},Go=null;function Fd(...n){let e="THREE."+n.shift();Go?Go("log",e,...n):console.log(e,...n)}function b0(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Xe(...n){n=b0(n);let e="THREE."+n.shift();if(Go)Go("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function nt(...n){n=b0(n);let e="THREE."+n.shift();if(Go)Go("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Fa(...n){let e=n.join(" ");e in m_||(m_[e]=!0,Xe(...n))}function S0(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var M0={[Nc]:Nc,[Fc]:kc,[Oc]:Oc,[Vo]:Bc,[Uc]:Uc,[kc]:Fc,[zc]:zc,[Bc]:Vo},qi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],g_=1234567,Oa=Math.PI/180,Ho=180/Math.PI;function ta(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]+"-"+zn[e&255]+zn[e>>8&255]+"-"+zn[e>>16&15|64]+zn[e>>24&255]+"-"+zn[t&63|128]+zn[t>>8&255]+"-"+zn[t>>16&255]+zn[t>>24&255]+zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]).toLowerCase()}function mt(n,e,t){return Math.max(e,Math.min(t,n))}function Od(n,e){return(n%e+e)%e}function qS(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function XS(n,e,t){return n!==e?(t-n)/(e-n):0}function Ba(n,e,t){return(1-t)*n+t*e}function YS(n,e,t,i){return Ba(n,e,1-Math.exp(-t*i))}function $S(n,e=1){return e-Math.abs(Od(n,e*2)-e)}function ZS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function KS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function JS(n,e){return n+Math.floor(Math.random()*(e-n+1))}function jS(n,e){return n+Math.random()*(e-n)}function QS(n){return n*(.5-Math.random())}function eM(n){n!==void 0&&(g_=n);let e=g_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function tM(n){return n*Oa}function nM(n){return n*Ho}function iM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function sM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Bd(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function rM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:Xe("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function kd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function w0(n,e){if(e.constructor===Float32Array)return n;let t=kd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function T0(n,e){if(e.constructor===Float32Array)return n;let t=kd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var zd={DEG2RAD:Oa,RAD2DEG:Ho,generateUUID:ta,clamp:mt,euclideanModulo:Od,mapLinear:qS,inverseLerp:XS,lerp:Ba,damp:YS,pingpong:$S,smoothstep:ZS,smootherstep:KS,randInt:JS,randFloat:jS,randFloatSpread:QS,seededRandom:eM,degToRad:tM,radToDeg:nM,isPowerOfTwo:iM,ceilPowerOfTwo:sM,floorPowerOfTwo:Bd,setQuaternionFromProperEuler:rM,normalize:T0,denormalize:w0},it=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},vi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],y=r[o+3];if(f!==y||l!==h||c!==d||u!==p){let g=l*h+c*d+u*p+f*y;g<0&&(h=-h,d=-d,p=-p,y=-y,g=-g);let m=1-a;if(g<.9995){let b=Math.acos(g),A=Math.sin(b);m=Math.sin(m*b)/A,a=Math.sin(a*b)/A,l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+y*a}else{l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+y*a;let b=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=b,c*=b,u*=b,f*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:Xe("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(mt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Z=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(__.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(__.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Of.copy(this).projectOnVector(e),this.sub(Of)}reflect(e){return this.sub(Of.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Of=new Z,__=new vi,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],y=s[0],g=s[3],m=s[6],b=s[1],A=s[4],S=s[7],P=s[2],C=s[5],v=s[8];return r[0]=o*y+a*b+l*P,r[3]=o*g+a*A+l*C,r[6]=o*m+a*S+l*v,r[1]=c*y+u*b+f*P,r[4]=c*g+u*A+f*C,r[7]=c*m+u*S+f*v,r[2]=h*y+d*b+p*P,r[5]=h*g+d*A+p*C,r[8]=h*m+d*S+p*v,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let y=1/p;return e[0]=f*y,e[1]=(s*c-u*i)*y,e[2]=(a*i-s*o)*y,e[3]=h*y,e[4]=(u*t-s*l)*y,e[5]=(s*r-a*t)*y,e[6]=d*y,e[7]=(i*l-c*t)*y,e[8]=(o*t-i*r)*y,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Fa("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Bf.makeScale(e,t)),this}rotate(e){return Fa("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Bf.makeRotation(-e)),this}translate(e,t){return Fa("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Bf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Bf=new et,v_=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),y_=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function oM(){let n={enabled:!0,workingColorSpace:za,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Pt&&(s.r=As(s.r),s.g=As(s.g),s.b=As(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Pt&&(s.r=zo(s.r),s.g=zo(s.g),s.b=zo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ds?Va:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[za]:{primaries:e,whitePoint:i,transfer:Va,toXYZ:v_,fromXYZ:y_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:gi},outputColorSpaceConfig:{drawingBufferColorSpace:gi}},[gi]:{primaries:e,whitePoint:i,transfer:Pt,toXYZ:v_,fromXYZ:y_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:gi}}}),n}var yt=oM();function As(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function zo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ao,Wc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Ao===void 0&&(Ao=Ha("canvas")),Ao.width=e.width,Ao.height=e.height;let s=Ao.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Ao}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ha("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=As(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(As(t[i]/255)*255):t[i]=As(t[i]);return{data:t,width:e.width,height:e.height}}else return Xe("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},aM=0,Wo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:aM++}),this.uuid=ta(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(kf(s[o].image)):r.push(kf(s[o]))}else r=kf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function kf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Wc.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Xe("Texture: Unable to serialize Texture."),{})}var lM=0,zf=new Z,ii=class n extends qi{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ls,s=ls,r=On,o=Is,a=Zi,l=Mi,c=n.DEFAULT_ANISOTROPY,u=Ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:lM++}),this.uuid=ta(),this.name="",this.source=new Wo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new it(0,0),this.repeat=new it(1,1),this.center=new it(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(zf).x}get height(){return this.source.getSize(zf).y}get depth(){return this.source.getSize(zf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Xe(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Xe(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Md)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Vc:e.x=e.x-Math.floor(e.x);break;case ls:e.x=e.x<0?0:1;break;case Gc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Vc:e.y=e.y-Math.floor(e.y);break;case ls:e.y=e.y<0?0:1;break;case Gc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ii.DEFAULT_IMAGE=null;ii.DEFAULT_MAPPING=Md;ii.DEFAULT_ANISOTROPY=1;var Qt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],y=l[2],g=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-y)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+y)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(d+1)/2,P=(m+1)/2,C=(u+h)/4,v=(f+y)/4,E=(p+g)/4;return A>S&&A>P?A<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(A),s=C/i,r=v/i):S>P?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=C/s,r=E/s):P<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),i=v/r,s=E/r),this.set(i,s,r,t),this}let b=Math.sqrt((g-p)*(g-p)+(f-y)*(f-y)+(h-u)*(h-u));return Math.abs(b)<.001&&(b=1),this.x=(g-p)/b,this.y=(f-y)/b,this.z=(h-u)/b,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=mt(this.x,e.x,t.x),this.y=mt(this.y,e.y,t.y),this.z=mt(this.z,e.z,t.z),this.w=mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=mt(this.x,e,t),this.y=mt(this.y,e,t),this.z=mt(this.z,e,t),this.w=mt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},qc=class extends qi{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:On,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Qt(0,0,e,t),this.scissorTest=!1,this.viewport=new Qt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new ii({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:On,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Wo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},yi=class extends qc{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Wa=class extends ii{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Xc=class extends ii{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Un,this.minFilter=Un,this.wrapR=ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var jt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,g)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,y,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=d,m[7]=p,m[11]=y,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Co.setFromMatrixColumn(e,0).length(),r=1/Co.setFromMatrixColumn(e,1).length(),o=1/Co.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,y=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-y*c,t[9]=-a*l,t[2]=y-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,y=c*f;t[0]=h+y*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=y+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,y=c*f;t[0]=h-y*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=y-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,y=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+y,t[1]=l*f,t[5]=y*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=y-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-y*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,y=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+y,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=y*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(cM,e,uM)}lookAt(e,t,i){let s=this.elements;return pi.subVectors(e,t),pi.lengthSq()===0&&(pi.z=1),pi.normalize(),Qs.crossVectors(i,pi),Qs.lengthSq()===0&&(Math.abs(i.z)===1?pi.x+=1e-4:pi.z+=1e-4,pi.normalize(),Qs.crossVectors(i,pi)),Qs.normalize(),uc.crossVectors(pi,Qs),s[0]=Qs.x,s[4]=uc.x,s[8]=pi.x,s[1]=Qs.y,s[5]=uc.y,s[9]=pi.y,s[2]=Qs.z,s[6]=uc.z,s[10]=pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],y=i[6],g=i[10],m=i[14],b=i[3],A=i[7],S=i[11],P=i[15],C=s[0],v=s[4],E=s[8],B=s[12],N=s[1],L=s[5],k=s[9],z=s[13],U=s[2],H=s[6],$=s[10],G=s[14],le=s[3],J=s[7],Q=s[11],se=s[15];return r[0]=o*C+a*N+l*U+c*le,r[4]=o*v+a*L+l*H+c*J,r[8]=o*E+a*k+l*$+c*Q,r[12]=o*B+a*z+l*G+c*se,r[1]=u*C+f*N+h*U+d*le,r[5]=u*v+f*L+h*H+d*J,r[9]=u*E+f*k+h*$+d*Q,r[13]=u*B+f*z+h*G+d*se,r[2]=p*C+y*N+g*U+m*le,r[6]=p*v+y*L+g*H+m*J,r[10]=p*E+y*k+g*$+m*Q,r[14]=p*B+y*z+g*G+m*se,r[3]=b*C+A*N+S*U+P*le,r[7]=b*v+A*L+S*H+P*J,r[11]=b*E+A*k+S*$+P*Q,r[15]=b*B+A*z+S*G+P*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],y=e[7],g=e[11],m=e[15],b=l*d-c*h,A=a*d-c*f,S=a*h-l*f,P=o*d-c*u,C=o*h-l*u,v=o*f-a*u;return t*(y*b-g*A+m*S)-i*(p*b-g*P+m*C)+s*(p*A-y*P+m*v)-r*(p*S-y*C+g*v)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],y=e[13],g=e[14],m=e[15],b=t*a-i*o,A=t*l-s*o,S=t*c-r*o,P=i*l-s*a,C=i*c-r*a,v=s*c-r*l,E=u*y-f*p,B=u*g-h*p,N=u*m-d*p,L=f*g-h*y,k=f*m-d*y,z=h*m-d*g,U=b*z-A*k+S*L+P*N-C*B+v*E;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/U;return e[0]=(a*z-l*k+c*L)*H,e[1]=(s*k-i*z-r*L)*H,e[2]=(y*v-g*C+m*P)*H,e[3]=(h*C-f*v-d*P)*H,e[4]=(l*N-o*z-c*B)*H,e[5]=(t*z-s*N+r*B)*H,e[6]=(g*S-p*v-m*A)*H,e[7]=(u*v-h*S+d*A)*H,e[8]=(o*k-a*N+c*E)*H,e[9]=(i*N-t*k-r*E)*H,e[10]=(p*C-y*S+m*b)*H,e[11]=(f*S-u*C-d*b)*H,e[12]=(a*B-o*L-l*E)*H,e[13]=(t*L-i*B+s*E)*H,e[14]=(y*A-p*P-g*b)*H,e[15]=(u*P-f*A+h*b)*H,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,y=o*u,g=o*f,m=a*f,b=l*c,A=l*u,S=l*f,P=i.x,C=i.y,v=i.z;return s[0]=(1-(y+m))*P,s[1]=(d+S)*P,s[2]=(p-A)*P,s[3]=0,s[4]=(d-S)*C,s[5]=(1-(h+m))*C,s[6]=(g+b)*C,s[7]=0,s[8]=(p+A)*v,s[9]=(g-b)*v,s[10]=(1-(h+y))*v,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Co.set(s[0],s[1],s[2]).length(),a=Co.set(s[4],s[5],s[6]).length(),l=Co.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Gi.copy(this);let c=1/o,u=1/a,f=1/l;return Gi.elements[0]*=c,Gi.elements[1]*=c,Gi.elements[2]*=c,Gi.elements[4]*=u,Gi.elements[5]*=u,Gi.elements[6]*=u,Gi.elements[8]*=f,Gi.elements[9]*=f,Gi.elements[10]*=f,t.setFromRotationMatrix(Gi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Ii,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,y;if(l)p=r/(o-r),y=o*r/(o-r);else if(a===Ii)p=-(o+r)/(o-r),y=-2*o*r/(o-r);else if(a===Ga)p=-o/(o-r),y=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,y;if(l)p=1/(o-r),y=o/(o-r);else if(a===Ii)p=-2/(o-r),y=-(o+r)/(o-r);else if(a===Ga)p=-1/(o-r),y=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=y,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Co=new Z,Gi=new jt,cM=new Z(0,0,0),uM=new Z(1,1,1),Qs=new Z,uc=new Z,pi=new Z,x_=new jt,b_=new vi,rr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(mt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-mt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Xe("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return x_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(x_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return b_.setFromEuler(this),this.setFromQuaternion(b_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};rr.DEFAULT_ORDER="XYZ";var qa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},hM=0,S_=new Z,Ro=new vi,Ss=new jt,hc=new Z,Ia=new Z,fM=new Z,dM=new vi,M_=new Z(1,0,0),w_=new Z(0,1,0),T_=new Z(0,0,1),E_={type:"added"},pM={type:"removed"},Po={type:"childadded",child:null},Vf={type:"childremoved",child:null},xi=class n extends qi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:hM++}),this.uuid=ta(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new Z,t=new rr,i=new vi,s=new Z(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new jt},normalMatrix:{value:new et}}),this.matrix=new jt,this.matrixWorld=new jt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new qa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Ro.setFromAxisAngle(e,t),this.quaternion.multiply(Ro),this}rotateOnWorldAxis(e,t){return Ro.setFromAxisAngle(e,t),this.quaternion.premultiply(Ro),this}rotateX(e){return this.rotateOnAxis(M_,e)}rotateY(e){return this.rotateOnAxis(w_,e)}rotateZ(e){return this.rotateOnAxis(T_,e)}translateOnAxis(e,t){return S_.copy(e).applyQuaternion(this.quaternion),this.position.add(S_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(M_,e)}translateY(e){return this.translateOnAxis(w_,e)}translateZ(e){return this.translateOnAxis(T_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ss.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?hc.copy(e):hc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ia.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ss.lookAt(Ia,hc,this.up):Ss.lookAt(hc,Ia,this.up),this.quaternion.setFromRotationMatrix(Ss),s&&(Ss.extractRotation(s.matrixWorld),Ro.setFromRotationMatrix(Ss),this.quaternion.premultiply(Ro.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(nt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(E_),Po.child=e,this.dispatchEvent(Po),Po.child=null):nt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(pM),Vf.child=e,this.dispatchEvent(Vf),Vf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ss.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ss.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ss),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(E_),Po.child=e,this.dispatchEvent(Po),Po.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ia,e,fM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ia,dM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};xi.DEFAULT_UP=new Z(0,1,0);xi.DEFAULT_MATRIX_AUTO_UPDATE=!0;xi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ur=class extends xi{constructor(){super(),this.isGroup=!0,this.type="Group"}},mM={type:"move"},qo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ur,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ur,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ur,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let y of e.hand.values()){let g=t.getJointPose(y,i),m=this._getHandJoint(c,y);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(mM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ur;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},E0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},er={h:0,s:0,l:0},fc={h:0,s:0,l:0};function Gf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var xt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=gi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,yt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=yt.workingColorSpace){return this.r=e,this.g=t,this.b=i,yt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=yt.workingColorSpace){if(e=Od(e,1),t=mt(t,0,1),i=mt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Gf(o,r,e+1/3),this.g=Gf(o,r,e),this.b=Gf(o,r,e-1/3)}return yt.colorSpaceToWorking(this,s),this}setStyle(e,t=gi){function i(r){r!==void 0&&parseFloat(r)<1&&Xe("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Xe("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Xe("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=gi){let i=E0[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Xe("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=As(e.r),this.g=As(e.g),this.b=As(e.b),this}copyLinearToSRGB(e){return this.r=zo(e.r),this.g=zo(e.g),this.b=zo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=gi){return yt.workingToColorSpace(Vn.copy(this),e),Math.round(mt(Vn.r*255,0,255))*65536+Math.round(mt(Vn.g*255,0,255))*256+Math.round(mt(Vn.b*255,0,255))}getHexString(e=gi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=yt.workingColorSpace){yt.workingToColorSpace(Vn.copy(this),t);let i=Vn.r,s=Vn.g,r=Vn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=yt.workingColorSpace){return yt.workingToColorSpace(Vn.copy(this),t),e.r=Vn.r,e.g=Vn.g,e.b=Vn.b,e}getStyle(e=gi){yt.workingToColorSpace(Vn.copy(this),e);let t=Vn.r,i=Vn.g,s=Vn.b;return e!==gi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(er),this.setHSL(er.h+e,er.s+t,er.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(er),e.getHSL(fc);let i=Ba(er.h,fc.h,t),s=Ba(er.s,fc.s,t),r=Ba(er.l,fc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Vn=new xt;xt.NAMES=E0;var Xa=class extends xi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new rr,this.environmentIntensity=1,this.environmentRotation=new rr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Hi=new Z,Ms=new Z,Hf=new Z,ws=new Z,Io=new Z,Lo=new Z,A_=new Z,Wf=new Z,qf=new Z,Xf=new Z,Yf=new Qt,$f=new Qt,Zf=new Qt,sr=class n{constructor(e=new Z,t=new Z,i=new Z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Hi.subVectors(e,t),s.cross(Hi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Hi.subVectors(s,t),Ms.subVectors(i,t),Hf.subVectors(e,t);let o=Hi.dot(Hi),a=Hi.dot(Ms),l=Hi.dot(Hf),c=Ms.dot(Ms),u=Ms.dot(Hf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ws)===null?!1:ws.x>=0&&ws.y>=0&&ws.x+ws.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ws)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ws.x),l.addScaledVector(o,ws.y),l.addScaledVector(a,ws.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Yf.setScalar(0),$f.setScalar(0),Zf.setScalar(0),Yf.fromBufferAttribute(e,t),$f.fromBufferAttribute(e,i),Zf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Yf,r.x),o.addScaledVector($f,r.y),o.addScaledVector(Zf,r.z),o}static isFrontFacing(e,t,i,s){return Hi.subVectors(i,t),Ms.subVectors(e,t),Hi.cross(Ms).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Hi.subVectors(this.c,this.b),Ms.subVectors(this.a,this.b),Hi.cross(Ms).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Io.subVectors(s,i),Lo.subVectors(r,i),Wf.subVectors(e,i);let l=Io.dot(Wf),c=Lo.dot(Wf);if(l<=0&&c<=0)return t.copy(i);qf.subVectors(e,s);let u=Io.dot(qf),f=Lo.dot(qf);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Io,o);Xf.subVectors(e,r);let d=Io.dot(Xf),p=Lo.dot(Xf);if(p>=0&&d<=p)return t.copy(r);let y=d*c-l*p;if(y<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Lo,a);let g=u*p-d*f;if(g<=0&&f-u>=0&&d-p>=0)return A_.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(A_,a);let m=1/(g+y+h);return o=y*m,a=h*m,t.copy(i).addScaledVector(Io,o).addScaledVector(Lo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},cs=class{constructor(e=new Z(1/0,1/0,1/0),t=new Z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Wi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Wi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Wi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Wi):Wi.fromBufferAttribute(r,o),Wi.applyMatrix4(e.matrixWorld),this.expandByPoint(Wi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),dc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),dc.copy(i.boundingBox)),dc.applyMatrix4(e.matrixWorld),this.union(dc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Wi),Wi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(La),pc.subVectors(this.max,La),Do.subVectors(e.a,La),No.subVectors(e.b,La),Uo.subVectors(e.c,La),tr.subVectors(No,Do),nr.subVectors(Uo,No),Ir.subVectors(Do,Uo);let t=[0,-tr.z,tr.y,0,-nr.z,nr.y,0,-Ir.z,Ir.y,tr.z,0,-tr.x,nr.z,0,-nr.x,Ir.z,0,-Ir.x,-tr.y,tr.x,0,-nr.y,nr.x,0,-Ir.y,Ir.x,0];return!Kf(t,Do,No,Uo,pc)||(t=[1,0,0,0,1,0,0,0,1],!Kf(t,Do,No,Uo,pc))?!1:(mc.crossVectors(tr,nr),t=[mc.x,mc.y,mc.z],Kf(t,Do,No,Uo,pc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Wi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Wi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ts[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ts[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ts[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ts[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ts[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ts[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ts[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ts[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ts),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ts=[new Z,new Z,new Z,new Z,new Z,new Z,new Z,new Z],Wi=new Z,dc=new cs,Do=new Z,No=new Z,Uo=new Z,tr=new Z,nr=new Z,Ir=new Z,La=new Z,pc=new Z,mc=new Z,Lr=new Z;function Kf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Lr.fromArray(n,r);let a=s.x*Math.abs(Lr.x)+s.y*Math.abs(Lr.y)+s.z*Math.abs(Lr.z),l=e.dot(Lr),c=t.dot(Lr),u=i.dot(Lr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var yn=new Z,gc=new it,gM=0,Jn=class extends qi{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:gM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=y0,this.updateRanges=[],this.gpuType=Yi,this.version=0,this._normalizationScale=e!==void 0?kd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)gc.fromBufferAttribute(this,t),gc.applyMatrix3(e),this.setXY(t,gc.x,gc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix3(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix4(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyNormalMatrix(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.transformDirection(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):w0(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):T0(e,this.array)}};var Ya=class extends Jn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var $a=class extends Jn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var ni=class extends Jn{constructor(e,t,i){super(new Float32Array(e),t,i)}},_M=new cs,Da=new Z,Jf=new Z,Rs=class{constructor(e=new Z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):_M.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Da.subVectors(e,this.center);let t=Da.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Da,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Jf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Da.copy(e.center).add(Jf)),this.expandByPoint(Da.copy(e.center).sub(Jf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},vM=0,Pi=new jt,jf=new xi,Fo=new Z,mi=new cs,Na=new cs,Nn=new Z,us=class n extends qi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:vM++}),this.uuid=ta(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(HS(e)?$a:Ya)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new et().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Pi.makeRotationFromQuaternion(e),this.applyMatrix4(Pi),this}rotateX(e){return Pi.makeRotationX(e),this.applyMatrix4(Pi),this}rotateY(e){return Pi.makeRotationY(e),this.applyMatrix4(Pi),this}rotateZ(e){return Pi.makeRotationZ(e),this.applyMatrix4(Pi),this}translate(e,t,i){return Pi.makeTranslation(e,t,i),this.applyMatrix4(Pi),this}scale(e,t,i){return Pi.makeScale(e,t,i),this.applyMatrix4(Pi),this}lookAt(e){return jf.lookAt(e),jf.updateMatrix(),this.applyMatrix4(jf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Fo).negate(),this.translate(Fo.x,Fo.y,Fo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new ni(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Xe("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new cs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Z(-1/0,-1/0,-1/0),new Z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];mi.setFromBufferAttribute(r),this.morphTargetsRelative?(Nn.addVectors(this.boundingBox.min,mi.min),this.boundingBox.expandByPoint(Nn),Nn.addVectors(this.boundingBox.max,mi.max),this.boundingBox.expandByPoint(Nn)):(this.boundingBox.expandByPoint(mi.min),this.boundingBox.expandByPoint(mi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&nt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Rs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){nt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Z,1/0);return}if(e){let i=this.boundingSphere.center;if(mi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Na.setFromBufferAttribute(a),this.morphTargetsRelative?(Nn.addVectors(mi.min,Na.min),mi.expandByPoint(Nn),Nn.addVectors(mi.max,Na.max),mi.expandByPoint(Nn)):(mi.expandByPoint(Na.min),mi.expandByPoint(Na.max))}mi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Nn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Nn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Nn.fromBufferAttribute(a,c),l&&(Fo.fromBufferAttribute(e,c),Nn.add(Fo)),s=Math.max(s,i.distanceToSquared(Nn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&nt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){nt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Jn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new Z,l[B]=new Z;let u=new Z,f=new Z,h=new Z,d=new it,p=new it,y=new it,g=new Z,m=new Z;function b(B,N,L){c[B]=c[N]=c[L]=1,u.fromBufferAttribute(i,B),f.fromBufferAttribute(i,N),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,B),p.fromBufferAttribute(r,N),y.fromBufferAttribute(r,L),f.sub(u),h.sub(u),p.sub(d),y.sub(d);let k=1/(p.x*y.y-y.x*p.y);isFinite(k)&&(g.copy(f).multiplyScalar(y.y).addScaledVector(h,-p.y).multiplyScalar(k),m.copy(h).multiplyScalar(p.x).addScaledVector(f,-y.x).multiplyScalar(k),a[B].add(g),a[N].add(g),a[L].add(g),l[B].add(m),l[N].add(m),l[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let B=0,N=A.length;B<N;++B){let L=A[B],k=L.start,z=L.count;for(let U=k,H=k+z;U<H;U+=3)b(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let S=new Z,P=new Z,C=new Z,v=new Z;function E(B){C.fromBufferAttribute(s,B),v.copy(C);let N=a[B];S.copy(N),S.sub(C.multiplyScalar(C.dot(N))).normalize(),P.crossVectors(v,N);let k=P.dot(l[B])<0?-1:1;o.setXYZW(B,S.x,S.y,S.z,k)}for(let B=0,N=i.count;B<N;++B)c[B]&&E(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Jn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new Z,r=new Z,o=new Z,a=new Z,l=new Z,c=new Z,u=new Z,f=new Z;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),y=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,y),o.fromBufferAttribute(t,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,y),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(y,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Nn.fromBufferAttribute(e,t),Nn.normalize(),e.setXYZ(t,Nn.x,Nn.y,Nn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let y=0,g=l.length;y<g;y++){a.isInterleavedBufferAttribute?d=l[y]*a.data.stride+a.offset:d=l[y]*u;for(let m=0;m<u;m++)h[p++]=c[d++]}return new Jn(h,u,f)}if(this.index===null)return Xe("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Qf=new Z,yM=new Z,xM=new et,_i=class{constructor(e=new Z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Qf.subVectors(i,t).cross(yM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Qf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||xM.getNormalMatrix(e),s=this.coplanarPoint(Qf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},bM=0,or=class extends qi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:bM++}),this.uuid=ta(),this.name="",this.type="Material",this.blending=jo,this.side=fr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=dd,this.blendDst=pd,this.blendEquation=zr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new xt(0,0,0),this.blendAlpha=0,this.depthFunc=Vo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=d0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dc,this.stencilZFail=Dc,this.stencilZPass=Dc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Xe(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Xe(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new xt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new _i().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new it().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new it().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Es=new Z,ed=new Z,_c=new Z,vc=new Z,Fr=class{constructor(e=new Z,t=new Z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Es)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Es.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Es.copy(this.origin).addScaledVector(this.direction,t),Es.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){ed.copy(e).add(t).multiplyScalar(.5),_c.copy(t).sub(e).normalize(),vc.copy(this.origin).sub(ed);let r=e.distanceTo(t)*.5,o=-this.direction.dot(_c),a=vc.dot(this.direction),l=-vc.dot(_c),c=vc.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let y=1/u;f*=y,h*=y,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(ed).addScaledVector(_c,h),d}intersectSphere(e,t){if(e.radius<0)return null;Es.subVectors(e.center,this.origin);let i=Es.dot(this.direction),s=Es.dot(Es)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Es)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,y=t.y-o.y,g=t.z-o.z,m=i.x-o.x,b=i.y-o.y,A=i.z-o.z,S=Math.abs(l),P=Math.abs(c),C=Math.abs(u),v,E,B,N,L,k,z,U,H,$,G,le;if(S>=P&&S>=C?(B=l,k=f,H=p,le=m,l>=0?(v=c,E=u,N=h,L=d,z=y,U=g,$=b,G=A):(v=u,E=c,N=d,L=h,z=g,U=y,$=A,G=b)):P>=C?(B=c,k=h,H=y,le=b,c>=0?(v=u,E=l,N=d,L=f,z=g,U=p,$=A,G=m):(v=l,E=u,N=f,L=d,z=p,U=g,$=m,G=A)):(B=u,k=d,H=g,le=A,u>=0?(v=l,E=c,N=f,L=h,z=p,U=y,$=m,G=b):(v=c,E=l,N=h,L=f,z=y,U=p,$=b,G=m)),B===0)return null;let J=v/B,Q=E/B,se=1/B,fe=N-J*k,he=L-Q*k,ee=z-J*H,me=U-Q*H,ve=$-J*le,Ae=G-Q*le,Se=ve*me-Ae*ee,He=fe*Ae-he*ve,ot=ee*he-me*fe;if(s){if(Se<0||He<0||ot<0)return null}else if((Se<0||He<0||ot<0)&&(Se>0||He>0||ot>0))return null;let Ve=Se+He+ot;if(Ve===0)return null;let ft=se*(Se*k+He*H+ot*le);return(Ve>0?ft<0:ft>0)?null:this.at(ft/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Yc=class extends or{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new xt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new rr,this.combine=md,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},C_=new jt,Dr=new Fr,yc=new Rs,R_=new Z,xc=new Z,bc=new Z,Sc=new Z,td=new Z,Mc=new Z,P_=new Z,wc=new Z,Li=class extends xi{constructor(e=new us,t=new Yc){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Mc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(td.fromBufferAttribute(f,e),o?Mc.addScaledVector(td,u):Mc.addScaledVector(td.sub(t),u))}t.add(Mc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),yc.copy(i.boundingSphere),yc.applyMatrix4(r),Dr.copy(e.ray).recast(e.near),!(yc.containsPoint(Dr.origin)===!1&&(Dr.intersectSphere(yc,R_)===null||Dr.origin.distanceToSquared(R_)>(e.far-e.near)**2))&&(C_.copy(r).invert(),Dr.copy(e.ray).applyMatrix4(C_),!(i.boundingBox!==null&&Dr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Dr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,y=h.length;p<y;p++){let g=h[p],m=o[g.materialIndex],b=Math.max(g.start,d.start),A=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let S=b,P=A;S<P;S+=3){let C=a.getX(S),v=a.getX(S+1),E=a.getX(S+2);s=Tc(this,m,e,i,c,u,f,C,v,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(a.count,d.start+d.count);for(let g=p,m=y;g<m;g+=3){let b=a.getX(g),A=a.getX(g+1),S=a.getX(g+2);s=Tc(this,o,e,i,c,u,f,b,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,y=h.length;p<y;p++){let g=h[p],m=o[g.materialIndex],b=Math.max(g.start,d.start),A=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let S=b,P=A;S<P;S+=3){let C=S,v=S+1,E=S+2;s=Tc(this,m,e,i,c,u,f,C,v,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),y=Math.min(l.count,d.start+d.count);for(let g=p,m=y;g<m;g+=3){let b=g,A=g+1,S=g+2;s=Tc(this,o,e,i,c,u,f,b,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function SM(n,e,t,i,s,r,o,a){let l;if(e.side===jn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===fr,a),l===null)return null;wc.copy(a),wc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(wc);return c<t.near||c>t.far?null:{distance:c,point:wc.clone(),object:n}}function Tc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,xc),n.getVertexPosition(l,bc),n.getVertexPosition(c,Sc);let u=SM(n,e,t,i,xc,bc,Sc,P_);if(u){let f=new Z;sr.getBarycoord(P_,xc,bc,Sc,f),s&&(u.uv=sr.getInterpolatedAttribute(s,a,l,c,f,new it)),r&&(u.uv1=sr.getInterpolatedAttribute(r,a,l,c,f,new it)),o&&(u.normal=sr.getInterpolatedAttribute(o,a,l,c,f,new Z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new Z,materialIndex:0};sr.getNormal(xc,bc,Sc,h.normal),u.face=h,u.barycoord=f}return u}var Or=class extends ii{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Un,u=Un,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Xo=class extends Jn{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var Nr=new Rs,MM=new it(.5,.5),Ec=new Z,Br=class{constructor(e=new _i,t=new _i,i=new _i,s=new _i,r=new _i,o=new _i){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ii,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],y=r[9],g=r[10],m=r[11],b=r[12],A=r[13],S=r[14],P=r[15];if(s[0].setComponents(c-o,d-u,m-p,P-b).normalize(),s[1].setComponents(c+o,d+u,m+p,P+b).normalize(),s[2].setComponents(c+a,d+f,m+y,P+A).normalize(),s[3].setComponents(c-a,d-f,m-y,P-A).normalize(),i)s[4].setComponents(l,h,g,S).normalize(),s[5].setComponents(c-l,d-h,m-g,P-S).normalize();else if(s[4].setComponents(c-l,d-h,m-g,P-S).normalize(),t===Ii)s[5].setComponents(c+l,d+h,m+g,P+S).normalize();else if(t===Ga)s[5].setComponents(l,h,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Nr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Nr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Nr)}intersectsSprite(e){Nr.center.set(0,0,0);let t=MM.distanceTo(e.center);return Nr.radius=.7071067811865476+t,Nr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Nr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Ec.x=s.normal.x>0?e.max.x:e.min.x,Ec.y=s.normal.y>0?e.max.y:e.min.y,Ec.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ec)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},I_=new jt,$c=class n{constructor(){this.coordinateSystem=Ii,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];I_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Br),i[s].setFromProjectionMatrix(I_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Br),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Zc=class extends or{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new xt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Kc=new Z,Jc=new Z,L_=new jt,Ua=new Fr,Ac=new Rs,nd=new Z,D_=new Z,jc=class extends xi{constructor(e=new us,t=new Zc){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Kc.fromBufferAttribute(t,s-1),Jc.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Kc.distanceTo(Jc);e.setAttribute("lineDistance",new ni(i,1))}else Xe("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ac.copy(i.boundingSphere),Ac.applyMatrix4(s),Ac.radius+=r,e.ray.intersectsSphere(Ac)===!1)return;L_.copy(s).invert(),Ua.copy(e.ray).applyMatrix4(L_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let y=d,g=p-1;y<g;y+=c){let m=u.getX(y),b=u.getX(y+1),A=Cc(this,e,Ua,l,m,b,y);A&&t.push(A)}if(this.isLineLoop){let y=u.getX(p-1),g=u.getX(d),m=Cc(this,e,Ua,l,y,g,p-1);m&&t.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let y=d,g=p-1;y<g;y+=c){let m=Cc(this,e,Ua,l,y,y+1,y);m&&t.push(m)}if(this.isLineLoop){let y=Cc(this,e,Ua,l,p-1,d,p-1);y&&t.push(y)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Cc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Kc.fromBufferAttribute(a,s),Jc.fromBufferAttribute(a,r),t.distanceSqToSegment(Kc,Jc,nd,D_)>i)return;nd.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(nd);if(!(c<e.near||c>e.far))return{distance:c,point:D_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var N_=new Z,U_=new Z,Za=class extends jc{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)N_.fromBufferAttribute(t,s),U_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+N_.distanceTo(U_);e.setAttribute("lineDistance",new ni(i,1))}else Xe("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ka=class extends ii{constructor(e=[],t=Vr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ps=class extends ii{constructor(e,t,i=Xi,s,r,o,a=Un,l=Un,c,u=Cs,f=1){if(u!==Cs&&u!==Ls)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Wo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ja=class extends Ps{constructor(e,t=Xi,i=Vr,s,r,o=Un,a=Un,l,c=Cs){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ja=class extends ii{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Yo=class n extends us{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new ni(c,3)),this.setAttribute("normal",new ni(u,3)),this.setAttribute("uv",new ni(f,2));function p(y,g,m,b,A,S,P,C,v,E,B){let N=S/v,L=P/E,k=S/2,z=P/2,U=C/2,H=v+1,$=E+1,G=0,le=0,J=new Z;for(let Q=0;Q<$;Q++){let se=Q*L-z;for(let fe=0;fe<H;fe++){let he=fe*N-k;J[y]=he*b,J[g]=se*A,J[m]=U,c.push(J.x,J.y,J.z),J[y]=0,J[g]=0,J[m]=C>0?1:-1,u.push(J.x,J.y,J.z),f.push(fe/v),f.push(1-Q/E),G+=1}}for(let Q=0;Q<E;Q++)for(let se=0;se<v;se++){let fe=h+se+H*Q,he=h+se+H*(Q+1),ee=h+(se+1)+H*(Q+1),me=h+(se+1)+H*Q;l.push(fe,he,me),l.push(he,ee,me),le+=6}a.addGroup(d,le,B),d+=le,h+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Qa=class n extends us{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],y=[],g=[];for(let m=0;m<u;m++){let b=m*h-o;for(let A=0;A<c;A++){let S=A*f-r;p.push(S,-b,0),y.push(0,0,1),g.push(A/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let b=0;b<a;b++){let A=b+c*m,S=b+c*(m+1),P=b+1+c*(m+1),C=b+1+c*m;d.push(A,S,C),d.push(S,P,C)}this.setIndex(d),this.setAttribute("position",new ni(p,3)),this.setAttribute("normal",new ni(y,3)),this.setAttribute("uv",new ni(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function Hr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(F_(s))s.isRenderTargetTexture?(Xe("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(F_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function Gn(n){let e={};for(let t=0;t<n.length;t++){let i=Hr(n[t]);for(let s in i)e[s]=i[s]}return e}function F_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function wM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Vd(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:yt.workingColorSpace}var A0={clone:Hr,merge:Gn},TM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,EM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,bi=class extends or{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=TM,this.fragmentShader=EM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Hr(e.uniforms),this.uniformsGroups=wM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new xt().setHex(s.value);break;case"v2":this.uniforms[i].value=new it().fromArray(s.value);break;case"v3":this.uniforms[i].value=new Z().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Qt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new et().fromArray(s.value);break;case"m4":this.uniforms[i].value=new jt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Qc=class extends bi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var eu=class extends or{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=h0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},tu=class extends or{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Oo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Rc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ar=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},nu=class extends ar{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:sd,endingEnd:sd}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case rd:r=e,a=2*t-i;break;case od:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case rd:o=e,l=2*i-t;break;case od:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),y=p*p,g=y*p,m=-h*g+2*h*y-h*p,b=(1+h)*g+(-1.5-2*h)*y+(-.5+h)*p+1,A=(-1-d)*g+(1.5+d)*y+.5*p,S=d*g-d*y;for(let P=0;P!==a;++P)r[P]=m*o[u+P]+b*o[c+P]+A*o[l+P]+S*o[f+P];return r}},iu=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},su=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},ru=class extends ar{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),y=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*y+o[l+g]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let y=o[c+p],g=o[l+p],m=d*h+p*2,b=f[m],A=f[m+1],S=e*h+p*2,P=u[S],C=u[S+1],v=CM(i,t,b,P,s);r[p]=C0(v,y,A,C,g)}return r}};function C0(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function AM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function CM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=C0(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=AM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Si=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Oo(t,this.TimeBufferType),this.values=Oo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Oo(e.times,Array),values:Oo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Rc(e.settings)&&(i.settings={inTangents:Oo(e.settings.inTangents,Array),outTangents:Oo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new su(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new iu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new nu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new ru(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ka:t=this.InterpolantFactoryMethodDiscrete;break;case Hc:t=this.InterpolantFactoryMethodLinear;break;case Lc:t=this.InterpolantFactoryMethodSmooth;break;case id:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Xe("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ka;case this.InterpolantFactoryMethodLinear:return Hc;case this.InterpolantFactoryMethodSmooth:return Lc;case this.InterpolantFactoryMethodBezier:return id}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Rc(this.settings)&&(O_(this.settings.inTangents,e),O_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Rc(this.settings)&&(B_(this.settings.inTangents,e),B_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(nt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(nt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){nt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){nt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&WS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){nt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Lc,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let y=t[f+p];if(y!==t[h+p]||y!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Rc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function O_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function B_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Si.prototype.ValueTypeName="";Si.prototype.TimeBufferType=Float32Array;Si.prototype.ValueBufferType=Float32Array;Si.prototype.DefaultInterpolation=Hc;var lr=class extends Si{constructor(e,t,i){super(e,t,i)}};lr.prototype.ValueTypeName="bool";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=ka;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var ou=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};ou.prototype.ValueTypeName="color";var au=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};au.prototype.ValueTypeName="number";var lu=class extends ar{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)vi.slerpFlat(r,0,o,c-a,o,c,l);return r}},el=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new lu(this.times,this.values,this.getValueSize(),e)}};el.prototype.ValueTypeName="quaternion";el.prototype.InterpolantFactoryMethodSmooth=void 0;var cr=class extends Si{constructor(e,t,i){super(e,t,i)}};cr.prototype.ValueTypeName="string";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=ka;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var cu=class extends Si{constructor(e,t,i,s){super(e,t,i,s)}};cu.prototype.ValueTypeName="vector";var uu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},R0=new uu,hu=class{constructor(e){this.manager=e!==void 0?e:R0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};hu.DEFAULT_MATERIAL_NAME="__DEFAULT";var Pc=new Z,Ic=new vi,as=new Z,tl=class extends xi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new jt,this.projectionMatrix=new jt,this.projectionMatrixInverse=new jt,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Pc,Ic,as),as.x===1&&as.y===1&&as.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pc,Ic,as.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Pc,Ic,as),as.x===1&&as.y===1&&as.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pc,Ic,as.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},ir=new Z,k_=new it,z_=new it,Kn=class extends tl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ho*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Oa*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ho*2*Math.atan(Math.tan(Oa*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){ir.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(ir.x,ir.y).multiplyScalar(-e/ir.z),ir.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(ir.x,ir.y).multiplyScalar(-e/ir.z)}getViewSize(e,t){return this.getViewBounds(e,k_,z_),t.subVectors(z_,k_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Oa*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var fu=class extends tl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var $o=class extends us{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Bo=-90,ko=1,Zo=class extends xi{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Kn(Bo,ko,e,t);s.layers=this.layers,this.add(s);let r=new Kn(Bo,ko,e,t);r.layers=this.layers,this.add(r);let o=new Kn(Bo,ko,e,t);o.layers=this.layers,this.add(o);let a=new Kn(Bo,ko,e,t);a.layers=this.layers,this.add(a);let l=new Kn(Bo,ko,e,t);l.layers=this.layers,this.add(l);let c=new Kn(Bo,ko,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ga)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let y=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=y,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},du=class extends Kn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Gd="\\[\\]\\.:\\/",RM=new RegExp("["+Gd+"]","g"),Hd="[^"+Gd+"]",PM="[^"+Gd.replace("\\.","")+"]",IM=/((?:WC+[\/:])*)/.source.replace("WC",Hd),LM=/(WCOD+)?/.source.replace("WCOD",PM),DM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Hd),NM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Hd),UM=new RegExp("^"+IM+LM+DM+NM+"$"),FM=["material","materials","bones","map"],ad=class{constructor(e,t,i){let s=i||Xt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Xt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(RM,"")}static parseTrackName(e){let t=UM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);FM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Xe("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){nt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){nt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){nt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){nt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){nt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){nt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;nt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){nt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Xt.Composite=ad;Xt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Xt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Xt.prototype.GetterByBindingType=[Xt.prototype._getValue_direct,Xt.prototype._getValue_array,Xt.prototype._getValue_arrayElement,Xt.prototype._getValue_toArray];Xt.prototype.SetterByBindingTypeAndVersioning=[[Xt.prototype._setValue_direct,Xt.prototype._setValue_direct_setNeedsUpdate,Xt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_array,Xt.prototype._setValue_array_setNeedsUpdate,Xt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_arrayElement,Xt.prototype._setValue_arrayElement_setNeedsUpdate,Xt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Xt.prototype._setValue_fromArray,Xt.prototype._setValue_fromArray_setNeedsUpdate,Xt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var fI=new Float32Array(1);var Ko=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=mt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(mt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ld=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var nl=class extends qi{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Wd(n,e,t,i){let s=OM(i);switch(t){case Cd:return n*e;case Pd:return n*e/s.components*s.byteLength;case xu:return n*e/s.components*s.byteLength;case dr:return n*e*2/s.components*s.byteLength;case bu:return n*e*2/s.components*s.byteLength;case Rd:return n*e*3/s.components*s.byteLength;case Zi:return n*e*4/s.components*s.byteLength;case Su:return n*e*4/s.components*s.byteLength;case rl:case ol:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case al:case ll:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case wu:case Eu:return Math.max(n,16)*Math.max(e,8)/4;case Mu:case Tu:return Math.max(n,8)*Math.max(e,8)/2;case Au:case Cu:case Pu:case Iu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ru:case cl:case Lu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Du:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Nu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Uu:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Fu:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Ou:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Bu:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ku:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case zu:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Vu:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Gu:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Hu:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Wu:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case qu:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Xu:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Yu:case $u:case Zu:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Ku:case Ju:return Math.ceil(n/4)*Math.ceil(e/4)*8;case ul:case ju:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function OM(n){switch(n){case Mi:case wd:return{byteLength:1,components:1};case ea:case Td:case $i:return{byteLength:2,components:1};case vu:case yu:return{byteLength:2,components:4};case Xi:case _u:case Yi:return{byteLength:4,components:1};case Ed:case Ad:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Xe("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function J0(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function kM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],y=f[d];y.start<=p.start+p.count+1?p.count=Math.max(p.count,y.start+y.count-p.start):(++h,f[h]=y)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let y=f[d];n.bufferSubData(c,y.start*u.BYTES_PER_ELEMENT,u,y.start,y.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var zM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,VM=`#ifdef USE_ALPHAHASH
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
#endif`,GM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,HM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,WM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,qM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,XM=`#ifdef USE_AOMAP
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
#endif`,YM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,$M=`#ifdef USE_BATCHING
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
#endif`,ZM=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,KM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,JM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,jM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,QM=`#ifdef USE_IRIDESCENCE
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
#endif`,ew=`#ifdef USE_BUMPMAP
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
#endif`,tw=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,nw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,iw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,sw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,rw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,ow=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,aw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,lw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,cw=`#define PI 3.141592653589793
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
} // validated`,uw=`vec3 transformedNormal = objectNormal;
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
#endif`,hw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,fw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,dw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,pw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,mw="gl_FragColor = linearToOutputTexel( gl_FragColor );",gw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,_w=`#ifdef USE_ENVMAP
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
#endif`,vw=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,yw=`#ifdef USE_ENVMAP
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
#endif`,xw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,bw=`#ifdef USE_ENVMAP
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
#endif`,Sw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Mw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,ww=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Tw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Ew=`#ifdef USE_GRADIENTMAP
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
}`,Aw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Cw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Rw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Pw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Iw=`#ifdef USE_ENVMAP
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
#endif`,Lw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Dw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Nw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Uw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Fw=`PhysicalMaterial material;
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
#endif`,Ow=`uniform sampler2D dfgLUT;
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
}`,Bw=`
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
#endif`,kw=`#if defined( RE_IndirectDiffuse )
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
#endif`,zw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Vw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Gw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Hw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ww=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,qw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Xw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Yw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,$w=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Zw=`#if defined( USE_POINTS_UV )
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
#endif`,Kw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Jw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,jw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Qw=`#if defined( USE_MORPHCOLORS )
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
#endif`,e1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,t1=`#ifdef USE_MORPHTARGETS
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
#endif`,n1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,i1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,s1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,r1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,o1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,a1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,l1=`#ifdef USE_NORMALMAP
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
#endif`,c1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,u1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,h1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,f1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,d1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,p1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,m1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,g1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,_1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,v1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,y1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,x1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,b1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,S1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,M1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,w1=`float getShadowMask() {
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
}`,T1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,E1=`#ifdef USE_SKINNING
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
#endif`,A1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,C1=`#ifdef USE_SKINNING
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
#endif`,R1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,P1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,I1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,L1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,D1=`#ifdef USE_TRANSMISSION
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
#endif`,N1=`#ifdef USE_TRANSMISSION
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
#endif`,U1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,F1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,O1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,B1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,k1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,z1=`uniform sampler2D t2D;
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
}`,V1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,G1=`uniform float backgroundBlurriness;
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
}`,H1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,W1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,q1=`#include <common>
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
}`,X1=`#if DEPTH_PACKING == 3200
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
}`,Y1=`#define DISTANCE
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
}`,$1=`#define DISTANCE
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
}`,Z1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,K1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,J1=`uniform float scale;
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
}`,j1=`uniform vec3 diffuse;
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
}`,Q1=`#include <common>
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
}`,eT=`uniform vec3 diffuse;
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
}`,tT=`#define LAMBERT
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
}`,nT=`#define LAMBERT
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
}`,iT=`#define MATCAP
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
}`,sT=`#define MATCAP
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
}`,rT=`#define NORMAL
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
}`,oT=`#define NORMAL
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
}`,aT=`#define PHONG
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
}`,lT=`#define PHONG
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
}`,cT=`#define STANDARD
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
}`,uT=`#define STANDARD
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
}`,hT=`#define TOON
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
}`,fT=`#define TOON
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
}`,dT=`uniform float size;
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
}`,pT=`uniform vec3 diffuse;
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
}`,mT=`#include <common>
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
}`,gT=`uniform vec3 color;
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
}`,_T=`uniform float rotation;
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
}`,vT=`uniform vec3 diffuse;
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
}`,ht={alphahash_fragment:zM,alphahash_pars_fragment:VM,alphamap_fragment:GM,alphamap_pars_fragment:HM,alphatest_fragment:WM,alphatest_pars_fragment:qM,aomap_fragment:XM,aomap_pars_fragment:YM,batching_pars_vertex:$M,batching_vertex:ZM,begin_vertex:KM,beginnormal_vertex:JM,bsdfs:jM,iridescence_fragment:QM,bumpmap_pars_fragment:ew,clipping_planes_fragment:tw,clipping_planes_pars_fragment:nw,clipping_planes_pars_vertex:iw,clipping_planes_vertex:sw,color_fragment:rw,color_pars_fragment:ow,color_pars_vertex:aw,color_vertex:lw,common:cw,defaultnormal_vertex:uw,displacementmap_pars_vertex:hw,displacementmap_vertex:fw,emissivemap_fragment:dw,emissivemap_pars_fragment:pw,colorspace_fragment:mw,colorspace_pars_fragment:gw,envmap_fragment:_w,envmap_common_pars_fragment:vw,envmap_pars_fragment:yw,envmap_pars_vertex:xw,envmap_physical_pars_fragment:Iw,envmap_vertex:bw,fog_vertex:Sw,fog_pars_vertex:Mw,fog_fragment:ww,fog_pars_fragment:Tw,gradientmap_pars_fragment:Ew,lightmap_pars_fragment:Aw,lights_lambert_fragment:Cw,lights_lambert_pars_fragment:Rw,lights_pars_begin:Pw,lights_toon_fragment:Lw,lights_toon_pars_fragment:Dw,lights_phong_fragment:Nw,lights_phong_pars_fragment:Uw,lights_physical_fragment:Fw,lights_physical_pars_fragment:Ow,lights_fragment_begin:Bw,lights_fragment_maps:kw,lights_fragment_end:zw,lightprobes_pars_fragment:Vw,logdepthbuf_fragment:Gw,logdepthbuf_pars_fragment:Hw,logdepthbuf_pars_vertex:Ww,logdepthbuf_vertex:qw,map_fragment:Xw,map_pars_fragment:Yw,map_particle_fragment:$w,map_particle_pars_fragment:Zw,metalnessmap_fragment:Kw,metalnessmap_pars_fragment:Jw,morphinstance_vertex:jw,morphcolor_vertex:Qw,morphnormal_vertex:e1,morphtarget_pars_vertex:t1,morphtarget_vertex:n1,normal_fragment_begin:i1,normal_fragment_maps:s1,normal_pars_fragment:r1,normal_pars_vertex:o1,normal_vertex:a1,normalmap_pars_fragment:l1,clearcoat_normal_fragment_begin:c1,clearcoat_normal_fragment_maps:u1,clearcoat_pars_fragment:h1,iridescence_pars_fragment:f1,opaque_fragment:d1,packing:p1,premultiplied_alpha_fragment:m1,project_vertex:g1,dithering_fragment:_1,dithering_pars_fragment:v1,roughnessmap_fragment:y1,roughnessmap_pars_fragment:x1,shadowmap_pars_fragment:b1,shadowmap_pars_vertex:S1,shadowmap_vertex:M1,shadowmask_pars_fragment:w1,skinbase_vertex:T1,skinning_pars_vertex:E1,skinning_vertex:A1,skinnormal_vertex:C1,specularmap_fragment:R1,specularmap_pars_fragment:P1,tonemapping_fragment:I1,tonemapping_pars_fragment:L1,transmission_fragment:D1,transmission_pars_fragment:N1,uv_pars_fragment:U1,uv_pars_vertex:F1,uv_vertex:O1,worldpos_vertex:B1,background_vert:k1,background_frag:z1,backgroundCube_vert:V1,backgroundCube_frag:G1,cube_vert:H1,cube_frag:W1,depth_vert:q1,depth_frag:X1,distance_vert:Y1,distance_frag:$1,equirect_vert:Z1,equirect_frag:K1,linedashed_vert:J1,linedashed_frag:j1,meshbasic_vert:Q1,meshbasic_frag:eT,meshlambert_vert:tT,meshlambert_frag:nT,meshmatcap_vert:iT,meshmatcap_frag:sT,meshnormal_vert:rT,meshnormal_frag:oT,meshphong_vert:aT,meshphong_frag:lT,meshphysical_vert:cT,meshphysical_frag:uT,meshtoon_vert:hT,meshtoon_frag:fT,points_vert:dT,points_frag:pT,shadow_vert:mT,shadow_frag:gT,sprite_vert:_T,sprite_frag:vT},Le={common:{diffuse:{value:new xt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new it(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new xt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new xt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new xt(16777215)},opacity:{value:1},center:{value:new it(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},ds={basic:{uniforms:Gn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ht.meshbasic_vert,fragmentShader:ht.meshbasic_frag},lambert:{uniforms:Gn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},envMapIntensity:{value:1}}]),vertexShader:ht.meshlambert_vert,fragmentShader:ht.meshlambert_frag},phong:{uniforms:Gn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},specular:{value:new xt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ht.meshphong_vert,fragmentShader:ht.meshphong_frag},standard:{uniforms:Gn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new xt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag},toon:{uniforms:Gn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new xt(0)}}]),vertexShader:ht.meshtoon_vert,fragmentShader:ht.meshtoon_frag},matcap:{uniforms:Gn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ht.meshmatcap_vert,fragmentShader:ht.meshmatcap_frag},points:{uniforms:Gn([Le.points,Le.fog]),vertexShader:ht.points_vert,fragmentShader:ht.points_frag},dashed:{uniforms:Gn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ht.linedashed_vert,fragmentShader:ht.linedashed_frag},depth:{uniforms:Gn([Le.common,Le.displacementmap]),vertexShader:ht.depth_vert,fragmentShader:ht.depth_frag},normal:{uniforms:Gn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ht.meshnormal_vert,fragmentShader:ht.meshnormal_frag},sprite:{uniforms:Gn([Le.sprite,Le.fog]),vertexShader:ht.sprite_vert,fragmentShader:ht.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ht.background_vert,fragmentShader:ht.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:ht.backgroundCube_vert,fragmentShader:ht.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ht.cube_vert,fragmentShader:ht.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ht.equirect_vert,fragmentShader:ht.equirect_frag},distance:{uniforms:Gn([Le.common,Le.displacementmap,{referencePosition:{value:new Z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ht.distance_vert,fragmentShader:ht.distance_frag},shadow:{uniforms:Gn([Le.lights,Le.fog,{color:{value:new xt(0)},opacity:{value:1}}]),vertexShader:ht.shadow_vert,fragmentShader:ht.shadow_frag}};ds.physical={uniforms:Gn([ds.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new it(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new xt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new it},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new xt(0)},specularColor:{value:new xt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new it},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:ht.meshphysical_vert,fragmentShader:ht.meshphysical_frag};var Qu={r:0,b:0,g:0},yT=new jt,j0=new et;j0.set(-1,0,0,0,1,0,0,0,1);function xT(n,e,t,i,s,r){let o=new xt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(b){let A=b.isScene===!0?b.background:null;if(A&&A.isTexture){let S=b.backgroundBlurriness>0;A=e.get(A,S)}return A}function p(b){let A=!1,S=d(b);S===null?g(o,a):S&&S.isColor&&(g(S,1),A=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function y(b,A){let S=d(A);S&&S.isCubeTexture?(c===void 0&&(c=new Li(new Yo(1,1,1),new bi({name:"BackgroundCubeMaterial",uniforms:Hr(ds.backgroundCube.uniforms),vertexShader:ds.backgroundCube.vertexShader,fragmentShader:ds.backgroundCube.fragmentShader,side:jn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,v){this.matrixWorld.copyPosition(v.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(yT.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(j0),c.material.toneMapped=yt.getTransfer(S.colorSpace)!==Pt,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Li(new Qa(2,2),new bi({name:"BackgroundMaterial",uniforms:Hr(ds.background.uniforms),vertexShader:ds.background.vertexShader,fragmentShader:ds.background.fragmentShader,side:fr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=yt.getTransfer(S.colorSpace)!==Pt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function g(b,A){b.getRGB(Qu,Vd(n)),t.buffers.color.setClear(Qu.r,Qu.g,Qu.b,A,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,A=1){o.set(b),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,g(o,a)},render:p,addToRenderList:y,dispose:m}}function bT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,k,z,U,H){let $=!1,G=f(L,U,z,k);r!==G&&(r=G,c(r.object)),$=d(L,U,z,H),$&&p(L,U,z,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,S(L,k,z,U),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,k,z,U){let H=U.wireframe===!0,$=i[k.id];$===void 0&&($={},i[k.id]=$);let G=L.isInstancedMesh===!0?L.id:0,le=$[G];le===void 0&&(le={},$[G]=le);let J=le[z.id];J===void 0&&(J={},le[z.id]=J);let Q=J[H];return Q===void 0&&(Q=h(l()),J[H]=Q),Q}function h(L){let k=[],z=[],U=[];for(let H=0;H<t;H++)k[H]=0,z[H]=0,U[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:z,attributeDivisors:U,object:L,attributes:{},index:null}}function d(L,k,z,U){let H=r.attributes,$=k.attributes,G=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let se=H[J],fe=$[J];if(fe===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;G++}return r.attributesNum!==G||r.index!==U}function p(L,k,z,U){let H={},$=k.attributes,G=0,le=z.getAttributes();for(let J in le)if(le[J].location>=0){let se=$[J];se===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[J]=fe,G++}r.attributes=H,r.attributesNum=G,r.index=U}function y(){let L=r.newAttributes;for(let k=0,z=L.length;k<z;k++)L[k]=0}function g(L){m(L,0)}function m(L,k){let z=r.newAttributes,U=r.enabledAttributes,H=r.attributeDivisors;z[L]=1,U[L]===0&&(n.enableVertexAttribArray(L),U[L]=1),H[L]!==k&&(n.vertexAttribDivisor(L,k),H[L]=k)}function b(){let L=r.newAttributes,k=r.enabledAttributes;for(let z=0,U=k.length;z<U;z++)k[z]!==L[z]&&(n.disableVertexAttribArray(z),k[z]=0)}function A(L,k,z,U,H,$,G){G===!0?n.vertexAttribIPointer(L,k,z,H,$):n.vertexAttribPointer(L,k,z,U,H,$)}function S(L,k,z,U){y();let H=U.attributes,$=z.getAttributes(),G=k.defaultAttributeValues;for(let le in $){let J=$[le];if(J.location>=0){let Q=H[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let se=Q.normalized,fe=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,me=he.type,ve=he.bytesPerElement,Ae=me===n.INT||me===n.UNSIGNED_INT||Q.gpuType===_u;if(Q.isInterleavedBufferAttribute){let Se=Q.data,He=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,ot=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Ve=0;Ve<J.locationSize;Ve++)m(J.location+Ve,Se.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Ve=0;Ve<J.locationSize;Ve++)g(J.location+Ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ve=0;Ve<J.locationSize;Ve++)A(J.location+Ve,fe/J.locationSize,me,se,He*ve,(ot+fe/J.locationSize*Ve)*ve,Ae)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<J.locationSize;Se++)m(J.location+Se,Q.meshPerAttribute);L.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<J.locationSize;Se++)g(J.location+Se);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Se=0;Se<J.locationSize;Se++)A(J.location+Se,fe/J.locationSize,me,se,fe*ve,fe/J.locationSize*Se*ve,Ae)}}else if(G!==void 0){let se=G[le];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(J.location,se);break;case 3:n.vertexAttrib3fv(J.location,se);break;case 4:n.vertexAttrib4fv(J.location,se);break;default:n.vertexAttrib1fv(J.location,se)}}}}b()}function P(){B();for(let L in i){let k=i[L];for(let z in k){let U=k[z];for(let H in U){let $=U[H];for(let G in $)u($[G].object),delete $[G];delete U[H]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let k=i[L.id];for(let z in k){let U=k[z];for(let H in U){let $=U[H];for(let G in $)u($[G].object),delete $[G];delete U[H]}}delete i[L.id]}function v(L){for(let k in i){let z=i[k];for(let U in z){let H=z[U];if(H[L.id]===void 0)continue;let $=H[L.id];for(let G in $)u($[G].object),delete $[G];delete H[L.id]}}}function E(L){for(let k in i){let z=i[k],U=L.isInstancedMesh===!0?L.id:0,H=z[U];if(H!==void 0){for(let $ in H){let G=H[$];for(let le in G)u(G[le].object),delete G[le];delete H[$]}delete z[U],Object.keys(z).length===0&&delete i[k]}}}function B(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:N,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:E,releaseStatesOfProgram:v,initAttributes:y,enableAttribute:g,disableUnusedAttributes:b}}function ST(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function MT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let v=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(v.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(v){return!(v!==Zi&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(v){let E=v===$i&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(v!==Mi&&v!==Yi&&!E&&i.convert(v)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(v){if(v==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";v="mediump"}return v==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Xe("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Xe("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Xe("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),y=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:y,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:b,maxVaryings:A,maxFragmentUniforms:S,maxSamples:P,samples:C}}function wT(n){let e=this,t=null,i=0,s=!1,r=!1,o=new _i,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,y=f.clipIntersection,g=f.clipShadows,m=n.get(f);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let b=r?0:i,A=b*4,S=m.clippingState||null;l.value=S,S=u(p,h,A,d);for(let P=0;P!==A;++P)S[P]=t[P];m.clippingState=S,this.numIntersection=y?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let y=f!==null?f.length:0,g=null;if(y!==0){if(g=l.value,p!==!0||g===null){let m=d+y*4,b=h.matrixWorldInverse;a.getNormalMatrix(b),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,S=d;A!==y;++A,S+=4)o.copy(f[A]).applyMatrix4(b,a),o.normal.toArray(g,S),g[S+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=y,e.numIntersection=0,g}}var dl=class extends yi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Ka(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Yo(5,5,5),r=new bi({name:"CubemapFromEquirect",uniforms:Hr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:jn,blending:kr});r.uniforms.tEquirect.value=t;let o=new Li(s,r),a=t.minFilter;return t.minFilter===Is&&(t.minFilter=On),new Zo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},P0=256,TT=3,ET=20,Q0=256,ev=16,AT=3,CT=new Z,RT=new xt,th=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Zo(1,10,null),this._boxMesh=new Li(new Yo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=CT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,y=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,y===null&&(e.background=l.getClearColor(RT));let g=new Zo(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=y,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=D0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=L0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(P0,Bd(e))}_fromTexture(e,t){e.mapping===Vr||e.mapping===Qo?this._setSize(e.image.length===0?P0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=I0(e,!1,!1),i=Math.log2(e)-TT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=I0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Vr||e.mapping===Qo?(this._cubemapMaterial===null&&(this._cubemapMaterial=D0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=L0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=PT(),this._integrationMaterial=IT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/ev);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-AT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Q0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=LT());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function I0(n,e,t){return new dl(n,{minFilter:Is,generateMipmaps:e,type:$i,colorSpace:za,depthBuffer:t})}function pl(n,e,t){return new bi({name:n,uniforms:e,vertexShader:ht.cube_vert,fragmentShader:t,side:jn,blending:kr,depthTest:!1,depthWrite:!1})}function PT(){return pl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Q0}u

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
	`)}function IT(){return pl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:ev}},`

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
	`)}function LT(){return pl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ET}
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
	`)}function L0(){return pl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function D0(){return pl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function DT(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===pu||d===mu)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let y=new dl(p.height);return y.fromEquirectangularTexture(n,h),e.set(h,y),h.addEventListener("dispose",c),a(y.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===pu||d===mu,y=d===Vr||d===Qo;if(p||y){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new th(n)),g=p?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let b=h.image;return p&&b&&b.height>0||y&&b&&l(b)?(i===null&&(i=new th(n)),g=p?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,d){return d===pu?h.mapping=Vr:d===mu&&(h.mapping=Qo),h}function l(h){let d=0,p=6;for(let y=0;y<p;y++)h[y]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function NT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Fa("WebGLRenderer: "+i+" extension not supported."),s}}}function UT(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let y=r.get(p);y&&(e.remove(y),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,y){return s[y.id]!==void 0||(y.addEventListener("dispose",a),s[y.id]=new WeakRef(y),o.register(y,y.id,y),t.memory.geometries++),y}function u(p){let y=p.attributes;for(let g in y)e.update(y[g],n.ARRAY_BUFFER)}function f(p){let y=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let b=y!==null?y.array.length:g.array.length/3-1,A=g.count>=65535?$a:Ya,S=new A(Math.ceil(b/3)*6,1),P=S.array;if(y!==null){let v=y.array;m=y.version;for(let E=0,B=0;E<b;E+=3){let N=v[E+0],L=v[E+1],k=v[E+2];P[B++]=N,P[B++]=L,P[B++]=L,P[B++]=k,P[B++]=k,P[B++]=N}}else{m=g.version;for(let v=0,E=0;v<b;v+=3){let B=v+0,N=v+1,L=v+2;P[E++]=B,P[E++]=N,P[E++]=N,P[E++]=L,P[E++]=L,P[E++]=B}}S.version=m;let C=r.get(p);C&&e.remove(C),r.set(p,S)}function h(p){let y=r.get(p);if(y){let g=p.index;g!==null&&y.version<g.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let y=s[p].deref();y!==void 0&&l(y)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function FT(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let y=0;for(let g=0;g<d;g++)y+=h[g];t.update(y,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function OT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:nt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function BT(n,e,t){let i=new WeakMap,s=new Qt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let B=function(){v.dispose(),i.delete(a),a.removeEventListener("dispose",B)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,y=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],A=0;d===!0&&(A=1),p===!0&&(A=2),y===!0&&(A=3);let S=a.attributes.position.count*A,P=1;S>e.maxTextureSize&&(P=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*P*4*f),v=new Wa(C,S,P,f);v.type=Yi,v.needsUpdate=!0;let E=A*4;for(let N=0;N<f;N++){let L=g[N],k=m[N],z=b[N],U=S*P*4*N;for(let H=0;H<L.count;H++){let $=H*E;d===!0&&(s.fromBufferAttribute(L,H),C[U+$+0]=s.x,C[U+$+1]=s.y,C[U+$+2]=s.z,C[U+$+3]=0),p===!0&&(s.fromBufferAttribute(k,H),C[U+$+4]=s.x,C[U+$+5]=s.y,C[U+$+6]=s.z,C[U+$+7]=0),y===!0&&(s.fromBufferAttribute(z,H),C[U+$+8]=s.x,C[U+$+9]=s.y,C[U+$+10]=s.z,C[U+$+11]=z.itemSize===4?s.w:1)}}h={count:f,texture:v,size:new it(S,P)},i.set(a,h),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let y=0;y<c.length;y++)d+=c[y];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function kT(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var zT={[gd]:"LINEAR_TONE_MAPPING",[_d]:"REINHARD_TONE_MAPPING",[vd]:"CINEON_TONE_MAPPING",[yd]:"ACES_FILMIC_TONE_MAPPING",[bd]:"AGX_TONE_MAPPING",[Sd]:"NEUTRAL_TONE_MAPPING",[xd]:"CUSTOM_TONE_MAPPING"};function VT(n,e,t,i,s,r){let o=new yi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new us;u.setAttribute("position",new ni([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new ni([0,2,0,0,2,0],2));let f=new Qc({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Li(u,f),d=new fu(-1,1,1,-1,0,1),p=null,y=null,g=!1,m,b=null,A=[],S=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let v=0;v<A.length;v++){let E=A[v];E.setSize&&E.setSize(P,C)}},this.setEffects=function(P){A=P,S=A.length>0&&A[0].isRenderPass===!0;let C=o.width,v=o.height;A.length>0&&a===null&&(a=new yi(C,v,{type:$i,depthBuffer:!1,stencilBuffer:!1}),l=new yi(C,v,{type:$i,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&A.some(B=>B.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new Ps(C,v),r===!0&&(c.format=Ls,c.type=Gr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let B=0;B<A.length;B++){let N=A[B];N.setSize&&N.setSize(C,v),E&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(P,C){if(g||P.toneMapping===hs&&A.length===0)return!1;if(b=C,C!==null){let v=C.width,E=C.height;(o.width!==v||o.height!==E)&&this.setSize(v,E)}return S===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=hs,!0},this.hasRenderPass=function(){return S},this.end=function(P,C){P.toneMapping=m,g=!0;let v=o,E=a;for(let B=0;B<A.length;B++){let N=A[B];N.enabled!==!1&&(N.render(P,E,v,C),N.needsSwap!==!1&&(v=E,E=E===a?l:a))}if(p!==P.outputColorSpace||y!==P.toneMapping){p=P.outputColorSpace,y=P.toneMapping,f.defines={},yt.getTransfer(p)===Pt&&(f.defines.SRGB_TRANSFER="");let B=zT[y];B&&(f.defines[B]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=v.texture,P.setRenderTarget(b),P.render(h,d),b=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var tv=new ii,nv=new Ps(1,1),iv=new Ja(1),sv=new Wa,rv=new Xc,ov=new Ka,N0=[],U0=[],F0=new Float32Array(16),O0=new Float32Array(9),B0=new Float32Array(4);function ia(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=N0[s];if(r===void 0&&(r=new Float32Array(s),N0[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Tn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function En(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function ih(n,e){let t=U0[e];t===void 0&&(t=new Int32Array(e),U0[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function GT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function HT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2fv(this.addr,e),En(t,e)}}function WT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Tn(t,e))return;n.uniform3fv(this.addr,e),En(t,e)}}function qT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4fv(this.addr,e),En(t,e)}}function XT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;B0.set(i),n.uniformMatrix2fv(this.addr,!1,B0),En(t,i)}}function YT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;O0.set(i),n.uniformMatrix3fv(this.addr,!1,O0),En(t,i)}}function $T(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;F0.set(i),n.uniformMatrix4fv(this.addr,!1,F0),En(t,i)}}function ZT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function KT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2iv(this.addr,e),En(t,e)}}function JT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3iv(this.addr,e),En(t,e)}}function jT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4iv(this.addr,e),En(t,e)}}function QT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function eE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2uiv(this.addr,e),En(t,e)}}function tE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3uiv(this.addr,e),En(t,e)}}function nE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4uiv(this.addr,e),En(t,e)}}function sh(n){return n.version===0&&(n.compareFunction=Nd,n.needsUpdate=!0),n}function iE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=sh(nv):r=tv,t.setTexture2D(e||r,s)}function sE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||rv,s)}function rE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=sh(iv):r=ov,t.setTextureCube(e||r,s)}function oE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||sv,s)}function aE(n){switch(n){case 5126:return GT;case 35664:return HT;case 35665:return WT;case 35666:return qT;case 35674:return XT;case 35675:return YT;case 35676:return $T;case 5124:case 35670:return ZT;case 35667:case 35671:return KT;case 35668:case 35672:return JT;case 35669:case 35673:return jT;case 5125:return QT;case 36294:return eE;case 36295:return tE;case 36296:return nE;case 35678:case 36198:case 36298:case 36306:case 35682:return iE;case 35679:case 36299:case 36307:return sE;case 35680:case 36300:case 36308:case 36293:return rE;case 36289:case 36303:case 36311:case 36292:return oE}}function lE(n,e){n.uniform1fv(this.addr,e)}function cE(n,e){let t=ia(e,this.size,2);n.uniform2fv(this.addr,t)}function uE(n,e){let t=ia(e,this.size,3);n.uniform3fv(this.addr,t)}function hE(n,e){let t=ia(e,this.size,4);n.uniform4fv(this.addr,t)}function fE(n,e){let t=ia(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function dE(n,e){let t=ia(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function pE(n,e){let t=ia(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function mE(n,e){n.uniform1iv(this.addr,e)}function gE(n,e){n.uniform2iv(this.addr,e)}function _E(n,e){n.uniform3iv(this.addr,e)}function vE(n,e){n.uniform4iv(this.addr,e)}function yE(n,e){n.uniform1uiv(this.addr,e)}function xE(n,e){n.uniform2uiv(this.addr,e)}function bE(n,e){n.uniform3uiv(this.addr,e)}function SE(n,e){n.uniform4uiv(this.addr,e)}function ME(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=sh(nv):o=tv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function wE(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||rv,r[o])}function TE(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=sh(iv):o=ov;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function EE(n,e,t){let i=this.cache,s=e.length,r=ih(t,s);Tn(i,r)||(n.uniform1iv(this.addr,r),En(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||sv,r[o])}function AE(n){switch(n){case 5126:return lE;case 35664:return cE;case 35665:return uE;case 35666:return hE;case 35674:return fE;case 35675:return dE;case 35676:return pE;case 5124:case 35670:return mE;case 35667:case 35671:return gE;case 35668:case 35672:return _E;case 35669:case 35673:return vE;case 5125:return yE;case 36294:return xE;case 36295:return bE;case 36296:return SE;case 35678:case 36198:case 36298:case 36306:case 35682:return ME;case 35679:case 36299:case 36307:return wE;case 35680:case 36300:case 36308:case 36293:return TE;case 36289:case 36303:case 36311:case 36292:return EE}}var Yd=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=aE(t.type)}},$d=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=AE(t.type)}},Zd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},qd=/(\w+)(\])?(\[|\.)?/g;function k0(n,e){n.seq.push(e),n.map[e.id]=e}function CE(n,e,t){let i=n.name,s=i.length;for(qd.lastIndex=0;;){let r=qd.exec(i),o=qd.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){k0(t,c===void 0?new Yd(a,n,e):new $d(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new Zd(a),k0(t,f)),t=f}}}var na=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);CE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function z0(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var RE=37297,PE=0;function IE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var V0=new et;function LE(n){yt._getMatrix(V0,yt.workingColorSpace,n);let e=`mat3( ${V0.elements.map(t=>t.toFixed(4))} )`;switch(yt.getTransfer(n)){case Va:return[e,"LinearTransferOETF"];case Pt:return[e,"sRGBTransferOETF"];default:return Xe("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function G0(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+IE(n.getShaderSource(e),a)}else return r}function DE(n,e){let t=LE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var NE={[gd]:"Linear",[_d]:"Reinhard",[vd]:"Cineon",[yd]:"ACESFilmic",[bd]:"AgX",[Sd]:"Neutral",[xd]:"Custom"};function UE(n,e){let t=NE[e];return t===void 0?(Xe("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var eh=new Z;function FE(){yt.getLuminanceCoefficients(eh);let n=eh.x.toFixed(4),e=eh.y.toFixed(4),t=eh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function OE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(fl).join(`
`)}function BE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function kE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function fl(n){return n!==""}function H0(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function W0(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var zE=/^[ \t]*#include +<([\w\d./]+)>/gm;function Kd(n){return n.replace(zE,VE)}function VE(n,e){let t=ht[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Kd(t)}var GE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function q0(n){return n.replace(GE,HE)}function HE(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function X0(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var WE={[il]:"SHADOWMAP_TYPE_PCF",[Jo]:"SHADOWMAP_TYPE_VSM"};function qE(n){return WE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var XE={[Qo]:"ENVMAP_MODE_REFRACTION"};function YE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":XE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var $E={[md]:"ENVMAP_BLENDING_MULTIPLY",[l0]:"ENVMAP_BLENDING_MIX",[c0]:"ENVMAP_BLENDING_ADD"};function ZE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":$E[n.combine]||"ENVMAP_BLENDING_NONE"}function KE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=qE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=YE(t),f=ZE(t),h=OE(t),d=BE(r),p=s.createProgram(),y,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(y=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(fl).join(`
`),y.length>0&&(y+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(fl).join(`
`),g.length>0&&(g+=`
`)):(y=[X0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(fl).join(`
`),g=[X0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==hs?"#define TONE_MAPPING":"",t.toneMapping!==hs?ht.tonemapping_pars_fragment:"",t.toneMapping!==hs?UE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ht.colorspace_pars_fragment,DE("linearToOutputTexel",t.outputColorSpace),FE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(fl).join(`
`)),o=Kd(o),o=H0(o,t),o=W0(o,t),a=Kd(a),a=H0(a,t),a=W0(a,t),o=q0(o),a=q0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,y=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+y,g=["#define varying in",t.glslVersion===Ud?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ud?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let b=m+y+o,A=m+g+a,S=z0(s,s.VERTEX_SHADER,b),P=z0(s,s.FRAGMENT_SHADER,A);s.attachShader(p,S),s.attachShader(p,P),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function C(N){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",k=s.getShaderInfoLog(S)||"",z=s.getShaderInfoLog(P)||"",U=L.trim(),H=k.trim(),$=z.trim(),G=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,P);else{let J=G0(s,S,"vertex"),Q=G0(s,P,"fragment");nt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+U+`
`+J+`
`+Q)}else U!==""?Xe("WebGLProgram: Program Info Log:",U):(H===""||$==="")&&(le=!1);le&&(N.diagnostics={runnable:G,programLog:U,vertexShader:{log:H,prefix:y},fragmentShader:{log:$,prefix:g}})}s.deleteShader(S),s.deleteShader(P),v=new na(s,p),E=kE(s,p)}let v;this.getUniforms=function(){return v===void 0&&C(this),v};let E;this.getAttributes=function(){return E===void 0&&C(this),E};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(p,RE)),B},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=PE++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=P,this}var JE=0,Jd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new jd(e),t.set(e,i)),i}},jd=class{constructor(e){this.id=JE++,this.code=e,this.usedTimes=0}};function jE(n){return n===dr||n===cl||n===ul}function QE(n,e,t,i,s,r){let o=new qa,a=new Jd,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(v){return l.add(v),v===0?"uv":`uv${v}`}function p(v,E,B,N,L,k){let z=N.fog,U=L.geometry,H=v.isMeshStandardMaterial||v.isMeshLambertMaterial||v.isMeshPhongMaterial?N.environment:null,$=v.isMeshStandardMaterial||v.isMeshLambertMaterial&&!v.envMap||v.isMeshPhongMaterial&&!v.envMap,G=e.get(v.envMap||H,$),le=h[v.type],J=i.precision;v.precision!==null&&(J=i.getMaxPrecision(v.precision),J!==v.precision&&Xe("WebGLProgram.getParameters:",v.precision,"not supported, using",J,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,se=Q!==void 0?Q.length:0,fe=0;U.morphAttributes.position!==void 0&&(fe=1),U.morphAttributes.normal!==void 0&&(fe=2),U.morphAttributes.color!==void 0&&(fe=3);let he,ee,me,ve;if(le){let Ce=ds[le];he=Ce.vertexShader,ee=Ce.fragmentShader}else{he=v.vertexShader,ee=v.fragmentShader;let Ce=a.getVertexShaderStage(v),lt=a.getFragmentShaderStage(v);a.update(v,Ce,lt),me=Ce.id,ve=lt.id}let Ae=n.getRenderTarget(),Se=n.state.buffers.depth.getReversed(),He=L.isInstancedMesh===!0,ot=L.isBatchedMesh===!0,Ve=!!v.map,ft=!!v.matcap,ct=!!G,st=ct&&G.isPMREMTexture===!0,Yt=!!v.aoMap,zt=!!v.lightMap,un=!!v.bumpMap&&v.wireframe===!1,Ut=!!v.normalMap,Cn=!!v.displacementMap,bt=!!v.emissiveMap,xn=!!v.metalnessMap,en=!!v.roughnessMap,hn=v.anisotropy>0,O=v.clearcoat>0,Re=v.diffuseRoughness>0,Ye=v.dispersion>0,at=v.retroreflectivity>0,Me=v.iridescence>0,Ot=v.sheen>0,ze=v.transmission>0,qe=hn&&!!v.anisotropyMap,R=O&&!!v.clearcoatMap,M=O&&!!v.clearcoatNormalMap,q=O&&!!v.clearcoatRoughnessMap,ue=Re&&!!v.diffuseRoughnessMap,oe=Me&&!!v.iridescenceMap,_e=Me&&!!v.iridescenceThicknessMap,ye=Ot&&!!v.sheenColorMap,te=Ot&&!!v.sheenRoughnessMap,ie=!!v.specularMap,pe=!!v.specularColorMap,F=!!v.specularIntensityMap,re=ze&&!!v.transmissionMap,ne=ze&&!!v.thicknessMap,we=!!v.gradientMap,ge=!!v.alphaMap,be=v.alphaTest>0,Ge=!!v.alphaHash,Ke=!!v.extensions,ce=hs;v.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Oe=st?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Je={shaderID:le,shaderType:v.type,shaderName:v.name,vertexShader:he,fragmentShader:ee,defines:v.defines,customVertexShaderID:me,customFragmentShaderID:ve,isRawShaderMaterial:v.isRawShaderMaterial===!0,glslVersion:v.glslVersion,precision:J,batching:ot,batchingColor:ot&&L._colorsTexture!==null,instancing:He,instancingColor:He&&L.instanceColor!==null,instancingMorph:He&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:yt.workingColorSpace,alphaToCoverage:!!v.alphaToCoverage,map:Ve,matcap:ft,envMap:ct,envMapMode:ct&&G.mapping,envMapPMREM:st,envMapMaxLod:st?Oe.length-1:null,envMapSize:st?Oe[0].width:null,aoMap:Yt,lightMap:zt,bumpMap:un,normalMap:Ut,displacementMap:Cn,emissiveMap:bt,normalMapObjectSpace:Ut&&v.normalMapType===f0,normalMapTangentSpace:Ut&&v.normalMapType===Id,packedNormalMap:Ut&&v.normalMapType===Id&&jE(v.normalMap.format),metalnessMap:xn,roughnessMap:en,anisotropy:hn,anisotropyMap:qe,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ye,retroreflection:at,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:_e,sheen:Ot,sheenColorMap:ye,sheenRoughnessMap:te,specularMap:ie,specularColorMap:pe,specularIntensityMap:F,transmission:ze,transmissionMap:re,thicknessMap:ne,gradientMap:we,opaque:v.transparent===!1&&v.blending===jo&&v.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:Ge,combine:v.combine,mapUv:Ve&&d(v.map.channel),aoMapUv:Yt&&d(v.aoMap.channel),lightMapUv:zt&&d(v.lightMap.channel),bumpMapUv:un&&d(v.bumpMap.channel),normalMapUv:Ut&&d(v.normalMap.channel),displacementMapUv:Cn&&d(v.displacementMap.channel),emissiveMapUv:bt&&d(v.emissiveMap.channel),metalnessMapUv:xn&&d(v.metalnessMap.channel),roughnessMapUv:en&&d(v.roughnessMap.channel),anisotropyMapUv:qe&&d(v.anisotropyMap.channel),clearcoatMapUv:R&&d(v.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(v.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(v.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(v.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(v.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&d(v.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(v.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(v.sheenRoughnessMap.channel),specularMapUv:ie&&d(v.specularMap.channel),specularColorMapUv:pe&&d(v.specularColorMap.channel),specularIntensityMapUv:F&&d(v.specularIntensityMap.channel),transmissionMapUv:re&&d(v.transmissionMap.channel),thicknessMapUv:ne&&d(v.thicknessMap.channel),alphaMapUv:ge&&d(v.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ut||hn),vertexNormals:!!U.attributes.normal,vertexColors:v.vertexColors,vertexAlphas:v.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!U.attributes.uv&&(Ve||ge),fog:!!z,useFog:v.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:v.wireframe===!1&&(v.flatShading===!0||U.attributes.normal===void 0&&Ut===!1&&(v.isMeshLambertMaterial||v.isMeshPhongMaterial||v.isMeshStandardMaterial||v.isMeshPhysicalMaterial)),sizeAttenuation:v.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Se,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:k.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:v.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Ve&&v.map.isVideoTexture===!0&&yt.getTransfer(v.map.colorSpace)===Pt,decodeVideoTextureEmissive:bt&&v.emissiveMap.isVideoTexture===!0&&yt.getTransfer(v.emissiveMap.colorSpace)===Pt,premultipliedAlpha:v.premultipliedAlpha,doubleSided:v.side===Di,flipSided:v.side===jn,useDepthPacking:v.depthPacking>=0,depthPacking:v.depthPacking||0,index0AttributeName:v.index0AttributeName,extensionClipCullDistance:Ke&&v.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ke&&v.extensions.multiDraw===!0||ot)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:v.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),Je}function y(v){let E=[];if(v.shaderID?E.push(v.shaderID):(E.push(v.customVertexShaderID),E.push(v.customFragmentShaderID)),v.defines!==void 0)for(let B in v.defines)E.push(B),E.push(v.defines[B]);return v.isRawShaderMaterial===!1&&(g(E,v),m(E,v),E.push(n.outputColorSpace)),E.push(v.customProgramCacheKey),E.join()}function g(v,E){v.push(E.precision),v.push(E.outputColorSpace),v.push(E.envMapMode),v.push(E.envMapPMREM),v.push(E.envMapMaxLod),v.push(E.envMapSize),v.push(E.mapUv),v.push(E.alphaMapUv),v.push(E.lightMapUv),v.push(E.aoMapUv),v.push(E.bumpMapUv),v.push(E.normalMapUv),v.push(E.displacementMapUv),v.push(E.emissiveMapUv),v.push(E.metalnessMapUv),v.push(E.roughnessMapUv),v.push(E.anisotropyMapUv),v.push(E.clearcoatMapUv),v.push(E.clearcoatNormalMapUv),v.push(E.clearcoatRoughnessMapUv),v.push(E.diffuseRoughnessMapUv),v.push(E.iridescenceMapUv),v.push(E.iridescenceThicknessMapUv),v.push(E.sheenColorMapUv),v.push(E.sheenRoughnessMapUv),v.push(E.specularMapUv),v.push(E.specularColorMapUv),v.push(E.specularIntensityMapUv),v.push(E.transmissionMapUv),v.push(E.thicknessMapUv),v.push(E.combine),v.push(E.fogExp2),v.push(E.sizeAttenuation),v.push(E.morphTargetsCount),v.push(E.numSunLights),v.push(E.numDirLights),v.push(E.numPointLights),v.push(E.numSpotLights),v.push(E.numSpotLightMaps),v.push(E.numHemiLights),v.push(E.numRectAreaLights),v.push(E.numSunLightShadows),v.push(E.numDirLightShadows),v.push(E.numPointLightShadows),v.push(E.numSpotLightShadows),v.push(E.numSpotLightShadowsWithMaps),v.push(E.numLightProbes),v.push(E.numLightProbeGrids),v.push(E.shadowMapType),v.push(E.toneMapping),v.push(E.numClippingPlanes),v.push(E.numClipIntersection),v.push(E.depthPacking)}function m(v,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),v.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),v.push(o.mask)}function b(v){let E=h[v.type],B;if(E){let N=ds[E];B=A0.clone(N.uniforms)}else B=v.uniforms;return B}function A(v,E){let B=u.get(E);return B!==void 0?++B.usedTimes:(B=new KE(n,E,v,s),c.push(B),u.set(E,B)),B}function S(v){if(--v.usedTimes===0){let E=c.indexOf(v);c[E]=c[c.length-1],c.pop(),u.delete(v.cacheKey),v.destroy()}}function P(v){a.remove(v)}function C(){a.dispose()}return{getParameters:p,getProgramCacheKey:y,getUniforms:b,acquireProgram:A,releaseProgram:S,releaseShaderCache:P,programs:c,dispose:C}}function eA(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function tA(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Y0(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function $0(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,y,g,m){let b=n[e];return b===void 0?(b={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:y,renderOrder:h.renderOrder,z:g,group:m},n[e]=b):(b.id=h.id,b.object=h,b.geometry=d,b.material=p,b.materialVariant=o(h),b.groupOrder=y,b.renderOrder=h.renderOrder,b.z=g,b.group=m),e++,b}function l(h,d,p,y,g,m,b){b.reversedDepth===!0&&(g=-g);let A=a(h,d,p,y,g,m);p.transmission>0?i.push(A):p.transparent===!0?s.push(A):t.push(A)}function c(h,d,p,y,g,m){let b=a(h,d,p,y,g,m);p.transmission>0?i.unshift(b):p.transparent===!0?s.unshift(b):t.unshift(b)}function u(h,d){t.length>1&&t.sort(h||tA),i.length>1&&i.sort(d||Y0),s.length>1&&s.sort(d||Y0)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function nA(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new $0,n.set(i,[o])):s>=r.length?(o=new $0,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function iA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Z,color:new xt};break;case"SpotLight":t={position:new Z,direction:new Z,color:new xt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Z,color:new xt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Z,skyColor:new xt,groundColor:new xt};break;case"RectAreaLight":t={color:new xt,position:new Z,halfWidth:new Z,halfHeight:new Z};break}return n[e.id]=t,t}}}function sA(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new it,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var rA=0;function oA(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function aA(n){let e=new iA,t=sA(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Z);let s=new Z,r=new jt,o=new jt;function a(c){let u=0,f=0,h=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let d=0,p=0,y=0,g=0,m=0,b=0,A=0,S=0,P=0,C=0,v=0,E=0,B=0,N=0;c.sort(oA);for(let k=0,z=c.length;k<z;k++){let U=c[k],H=U.color,$=U.intensity,G=U.distance,le=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===dr?le=U.shadow.map.texture:le=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)u+=H.r*$,f+=H.g*$,h+=H.b*$;else if(U.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(U.sh.coefficients[J],$);N++}else if(U.isSunLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=se,i.sunShadowMap[p]=le;let fe=Q.getViewportCount();for(let he=0;he<fe;he++)i.sunShadowMatrix[y+he]=Q.getMatrix(he),i.sunShadowCascade[y+he]=Q._cascadeData[he];y+=fe,p++}i.sun[d]=J,d++}else if(U.isDirectionalLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[g]=se,i.directionalShadowMap[g]=le,i.directionalShadowMatrix[g]=U.shadow.matrix,P++}i.directional[g]=J,g++}else if(U.isSpotLight){let J=e.get(U);J.position.setFromMatrixPosition(U.matrixWorld),J.color.copy(H).multiplyScalar($),J.distance=G,J.coneCos=Math.cos(U.angle),J.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),J.decay=U.decay,i.spot[b]=J;let Q=U.shadow;if(U.map&&(i.spotLightMap[E]=U.map,E++,Q.updateMatrices(U),U.castShadow&&B++),i.spotLightMatrix[b]=Q.matrix,U.castShadow){let se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[b]=se,i.spotShadowMap[b]=le,v++}b++}else if(U.isRectAreaLight){let J=e.get(U);J.color.copy(H).multiplyScalar($),J.halfWidth.set(U.width*.5,0,0),J.halfHeight.set(0,U.height*.5,0),i.rectArea[A]=J,A++}else if(U.isPointLight){let J=e.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),J.distance=U.distance,J.decay=U.decay,U.castShadow){let Q=U.shadow,se=t.get(U);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[m]=se,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=U.shadow.matrix,C++}i.point[m]=J,m++}else if(U.isHemisphereLight){let J=e.get(U);J.skyColor.copy(U.color).multiplyScalar($),J.groundColor.copy(U.groundColor).multiplyScalar($),i.hemi[S]=J,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let L=i.hash;(L.sunLength!==d||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==b||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==p||L.numDirectionalShadows!==P||L.numPointShadows!==C||L.numSpotShadows!==v||L.numSpotMaps!==E||L.numLightProbes!==N)&&(i.sun.length=d,i.directional.length=g,i.spot.length=b,i.rectArea.length=A,i.point.length=m,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=y,i.sunShadowCascade.length=y,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=v,i.spotShadowMap.length=v,i.spotLightMatrix.length=v+E-B,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=N,L.sunLength=d,L.directionalLength=g,L.pointLength=m,L.spotLength=b,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=p,L.numDirectionalShadows=P,L.numPointShadows=C,L.numSpotShadows=v,L.numSpotMaps=E,L.numLightProbes=N,i.version=rA++)}function l(c,u){let f=0,h=0,d=0,p=0,y=0,g=0,m=u.matrixWorldInverse;for(let b=0,A=c.length;b<A;b++){let S=c[b];if(S.isSunLight){let P=i.sun[f];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),f++}else if(S.isDirectionalLight){let P=i.directional[h];P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),h++}else if(S.isSpotLight){let P=i.spot[p];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),p++}else if(S.isRectAreaLight){let P=i.rectArea[y];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),y++}else if(S.isPointLight){let P=i.point[d];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),d++}else if(S.isHemisphereLight){let P=i.hemi[g];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Z0(n){let e=new aA(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function lA(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Z0(n),e.set(s,[a])):r>=o.length?(a=new Z0(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var cA=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,uA=`uniform sampler2D shadow_pass;
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
}`,hA=[new Z(1,0,0),new Z(-1,0,0),new Z(0,1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1)],fA=[new Z(0,-1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1),new Z(0,-1,0),new Z(0,-1,0)],K0=new jt,hl=new Z,Xd=new Z;function dA(n,e,t){let i=new Br,s=new it,r=new it,o=new Qt,a=new eu,l=new tu,c={},u=t.maxTextureSize,f={[fr]:jn,[jn]:fr,[Di]:Di},h=new bi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new it},radius:{value:4}},vertexShader:cA,fragmentShader:uA}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new us;p.setAttribute("position",new Jn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let y=new Li(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=il;let m=this.type;this.render=function(C,v,E){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||C.length===0)return;this.type===H_&&(Xe("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=il);let B=n.getRenderTarget(),N=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),k=n.state;k.setBlending(kr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let z=m!==this.type;z&&v.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(H=>H.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,H=C.length;U<H;U++){let $=C[U],G=$.shadow;if(G===void 0){Xe("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let le=G.getFrameExtents();s.multiply(le),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,G.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=J,G.map===null||z===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Jo){if($.isPointLight){Xe("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new yi(s.x,s.y,{format:dr,type:$i,minFilter:On,magFilter:On,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new Ps(s.x,s.y,Yi),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=Cs,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Un,G.map.depthTexture.magFilter=Un}else $.isPointLight?(G.map=new dl(s.x),G.map.depthTexture=new Ja(s.x,Xi)):(G.map=new yi(s.x,s.y),G.map.depthTexture=new Ps(s.x,s.y,Xi)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=Cs,this.type===il?(G.map.depthTexture.compareFunction=J?Dd:Ld,G.map.depthTexture.minFilter=On,G.map.depthTexture.magFilter=On):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Un,G.map.depthTexture.magFilter=Un);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,E);let se=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:E.layers;for(let fe=0;fe<Q;fe++){let he=G.getCamera(fe);if($.isPointLight){let ee=G.camera,me=G.matrix,ve=$.distance||ee.far;ve!==ee.far&&(ee.far=ve,ee.updateProjectionMatrix()),hl.setFromMatrixPosition($.matrixWorld),ee.position.copy(hl),Xd.copy(ee.position),Xd.add(hA[fe]),ee.up.copy(fA[fe]),ee.lookAt(Xd),ee.updateMatrixWorld(),me.makeTranslation(-hl.x,-hl.y,-hl.z),K0.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(K0,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(fe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),k.viewport(o)}i=G.getFrustum(fe),S(v,E,he,$,se,this.type)}G.isPointLightShadow!==!0&&this.type===Jo&&b(G,E),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(B,N,L)};function b(C,v){let E=e.update(y);h.defines.VSM_SAMPLES!==C.blurSamples&&(h.defines.VSM_SAMPLES=C.blurSamples,d.defines.VSM_SAMPLES=C.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),C.mapPass===null?C.mapPass=new yi(s.x,s.y,{format:dr,type:$i}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),h.uniforms.shadow_pass.value=C.map.depthTexture,h.uniforms.resolution.value.set(C.map.width,C.map.height),h.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(v,null,E,h,y,null),d.uniforms.shadow_pass.value=C.mapPass.texture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(v,null,E,d,y,null)}function A(C,v,E,B){let N=null,L=E.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)N=L;else if(N=E.isPointLight===!0?l:a,n.localClippingEnabled&&v.clipShadows===!0&&Array.isArray(v.clippingPlanes)&&v.clippingPlanes.length!==0||v.displacementMap&&v.displacementScale!==0||v.alphaMap&&v.alphaTest>0||v.map&&v.alphaTest>0||v.alphaToCoverage===!0){let k=N.uuid,z=v.uuid,U=c[k];U===void 0&&(U={},c[k]=U);let H=U[z];H===void 0&&(H=N.clone(),U[z]=H,v.addEventListener("dispose",P)),N=H}if(N.visible=v.visible,N.wireframe=v.wireframe,B===Jo?N.side=v.shadowSide!==null?v.shadowSide:v.side:N.side=v.shadowSide!==null?v.shadowSide:f[v.side],N.alphaMap=v.alphaMap,N.alphaTest=v.alphaToCoverage===!0?.5:v.alphaTest,N.map=v.map,N.clipShadows=v.clipShadows,N.clippingPlanes=v.clippingPlanes,N.clipIntersection=v.clipIntersection,N.displacementMap=v.displacementMap,N.displacementScale=v.displacementScale,N.displacementBias=v.displacementBias,N.wireframeLinewidth=v.wireframeLinewidth,N.linewidth=v.linewidth,E.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let k=n.properties.get(N);k.light=E}return N}function S(C,v,E,B,N,L){if(C.visible===!1)return;if(C.layers.test(N)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===Jo)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,C.matrixWorld);let U=e.update(C),H=C.material;if(Array.isArray(H)){let $=U.groups;for(let G=0,le=$.length;G<le;G++){let J=$[G],Q=H[J.materialIndex];if(Q&&Q.visible){let se=A(C,Q,B,L);C.onBeforeShadow(n,C,v,E,U,se,J),n.renderBufferDirect(E,null,U,se,C,J),C.onAfterShadow(n,C,v,E,U,se,J)}}}else if(H.visible){let $=A(C,H,B,L);C.onBeforeShadow(n,C,v,E,U,$,null),n.renderBufferDirect(E,null,U,$,C,null),C.onAfterShadow(n,C,v,E,U,$,null)}}let z=C.children;for(let U=0,H=z.length;U<H;U++)S(z[U],v,E,B,N,L)}function P(C){C.target.removeEventListener("dispose",P);for(let E in c){let B=c[E],N=C.target.uuid;N in B&&(B[N].dispose(),delete B[N])}}}function pA(n,e){function t(){let F=!1,re=new Qt,ne=null,we=new Qt(0,0,0,0);return{setMask:function(ge){ne!==ge&&!F&&(n.colorMask(ge,ge,ge,ge),ne=ge)},setLocked:function(ge){F=ge},setClear:function(ge,be,Ge,Ke,ce){ce===!0&&(ge*=Ke,be*=Ke,Ge*=Ke),re.set(ge,be,Ge,Ke),we.equals(re)===!1&&(n.clearColor(ge,be,Ge,Ke),we.copy(re))},reset:function(){F=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let F=!1,re=!1,ne=null,we=null,ge=null;return{setReversed:function(be){if(re!==be){let Ge=e.get("EXT_clip_control");be?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),re=be;let Ke=ge;ge=null,this.setClear(Ke)}},getReversed:function(){return re},setTest:function(be){be?Se(n.DEPTH_TEST):He(n.DEPTH_TEST)},setMask:function(be){ne!==be&&!F&&(n.depthMask(be),ne=be)},setFunc:function(be){if(re&&(be=M0[be]),we!==be){switch(be){case Nc:n.depthFunc(n.NEVER);break;case Uc:n.depthFunc(n.ALWAYS);break;case Fc:n.depthFunc(n.LESS);break;case Vo:n.depthFunc(n.LEQUAL);break;case Oc:n.depthFunc(n.EQUAL);break;case Bc:n.depthFunc(n.GEQUAL);break;case kc:n.depthFunc(n.GREATER);break;case zc:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=be}},setLocked:function(be){F=be},setClear:function(be){ge!==be&&(ge=be,re&&(be=1-be),n.clearDepth(be))},reset:function(){F=!1,ne=null,we=null,ge=null,re=!1}}}function s(){let F=!1,re=null,ne=null,we=null,ge=null,be=null,Ge=null,Ke=null,ce=null;return{setTest:function(Oe){F||(Oe?Se(n.STENCIL_TEST):He(n.STENCIL_TEST))},setMask:function(Oe){re!==Oe&&!F&&(n.stencilMask(Oe),re=Oe)},setFunc:function(Oe,Je,Ce){(ne!==Oe||we!==Je||ge!==Ce)&&(n.stencilFunc(Oe,Je,Ce),ne=Oe,we=Je,ge=Ce)},setOp:function(Oe,Je,Ce){(be!==Oe||Ge!==Je||Ke!==Ce)&&(n.stencilOp(Oe,Je,Ce),be=Oe,Ge=Je,Ke=Ce)},setLocked:function(Oe){F=Oe},setClear:function(Oe){ce!==Oe&&(n.clearStencil(Oe),ce=Oe)},reset:function(){F=!1,re=null,ne=null,we=null,ge=null,be=null,Ge=null,Ke=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],y=null,g=!1,m=null,b=null,A=null,S=null,P=null,C=null,v=null,E=new xt(0,0,0),B=0,N=!1,L=null,k=null,z=null,U=null,H=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),G=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),G=le>=2);let Q=null,se={},fe=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new Qt().fromArray(fe),me=new Qt().fromArray(he);function ve(F,re,ne,we){let ge=new Uint8Array(4),be=n.createTexture();n.bindTexture(F,be),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ge=0;Ge<ne;Ge++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,ge):n.texImage2D(re+Ge,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ge);return be}let Ae={};Ae[n.TEXTURE_2D]=ve(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=ve(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=ve(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=ve(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Se(n.DEPTH_TEST),o.setFunc(Vo),un(!1),Ut(cd),Se(n.CULL_FACE),Yt(kr);function Se(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function He(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function ot(F,re){return h[F]!==re?(n.bindFramebuffer(F,re),h[F]=re,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Ve(F,re){let ne=p,we=!1;if(F){ne=d.get(re),ne===void 0&&(ne=[],d.set(re,ne));let ge=F.textures;if(ne.length!==ge.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let be=0,Ge=ge.length;be<Ge;be++)ne[be]=n.COLOR_ATTACHMENT0+be;ne.length=ge.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function ft(F){return y!==F?(n.useProgram(F),y=F,!0):!1}let ct={[zr]:n.FUNC_ADD,[q_]:n.FUNC_SUBTRACT,[X_]:n.FUNC_REVERSE_SUBTRACT};ct[Y_]=n.MIN,ct[$_]=n.MAX;let st={[Z_]:n.ZERO,[K_]:n.ONE,[J_]:n.SRC_COLOR,[dd]:n.SRC_ALPHA,[i0]:n.SRC_ALPHA_SATURATE,[t0]:n.DST_COLOR,[Q_]:n.DST_ALPHA,[j_]:n.ONE_MINUS_SRC_COLOR,[pd]:n.ONE_MINUS_SRC_ALPHA,[n0]:n.ONE_MINUS_DST_COLOR,[e0]:n.ONE_MINUS_DST_ALPHA,[s0]:n.CONSTANT_COLOR,[r0]:n.ONE_MINUS_CONSTANT_COLOR,[o0]:n.CONSTANT_ALPHA,[a0]:n.ONE_MINUS_CONSTANT_ALPHA};function Yt(F,re,ne,we,ge,be,Ge,Ke,ce,Oe){if(F===kr){g===!0&&(He(n.BLEND),g=!1);return}if(g===!1&&(Se(n.BLEND),g=!0),F!==W_){if(F!==m||Oe!==N){if((b!==zr||P!==zr)&&(n.blendEquation(n.FUNC_ADD),b=zr,P=zr),Oe)switch(F){case jo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ud:n.blendFunc(n.ONE,n.ONE);break;case hd:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case fd:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:nt("WebGLState: Invalid blending: ",F);break}else switch(F){case jo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case ud:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case hd:nt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case fd:nt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:nt("WebGLState: Invalid blending: ",F);break}A=null,S=null,C=null,v=null,E.set(0,0,0),B=0,m=F,N=Oe}return}ge=ge||re,be=be||ne,Ge=Ge||we,(re!==b||ge!==P)&&(n.blendEquationSeparate(ct[re],ct[ge]),b=re,P=ge),(ne!==A||we!==S||be!==C||Ge!==v)&&(n.blendFuncSeparate(st[ne],st[we],st[be],st[Ge]),A=ne,S=we,C=be,v=Ge),(Ke.equals(E)===!1||ce!==B)&&(n.blendColor(Ke.r,Ke.g,Ke.b,ce),E.copy(Ke),B=ce),m=F,N=!1}function zt(F,re){F.side===Di?He(n.CULL_FACE):Se(n.CULL_FACE);let ne=F.side===jn;re&&(ne=!ne),un(ne),F.blending===jo&&F.transparent===!1?Yt(kr):Yt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let we=F.stencilWrite;a.setTest(we),we&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),bt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Se(n.SAMPLE_ALPHA_TO_COVERAGE):He(n.SAMPLE_ALPHA_TO_COVERAGE)}function un(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function Ut(F){F!==V_?(Se(n.CULL_FACE),F!==k&&(F===cd?n.cullFace(n.BACK):F===G_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):He(n.CULL_FACE),k=F}function Cn(F){F!==z&&(G&&n.lineWidth(F),z=F)}function bt(F,re,ne){F?(Se(n.POLYGON_OFFSET_FILL),(U!==re||H!==ne)&&(U=re,H=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):He(n.POLYGON_OFFSET_FILL)}function xn(F){F?Se(n.SCISSOR_TEST):He(n.SCISSOR_TEST)}function en(F){F===void 0&&(F=n.TEXTURE0+$-1),Q!==F&&(n.activeTexture(F),Q=F)}function hn(F,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let we=se[ne];we===void 0&&(we={type:void 0,texture:void 0},se[ne]=we),(we.type!==F||we.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(F,re||Ae[F]),we.type=F,we.texture=re)}function O(){let F=se[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function Ye(){try{n.compressedTexImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function at(){try{n.texSubImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function Me(){try{n.texSubImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function Ot(){try{n.compressedTexSubImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function qe(){try{n.texStorage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){nt("WebGLState:",F)}}function q(){try{n.texImage3D(...arguments)}catch(F){nt("WebGLState:",F)}}function ue(F){return f[F]!==void 0?f[F]:n.getParameter(F)}function oe(F,re){f[F]!==re&&(n.pixelStorei(F,re),f[F]=re)}function _e(F){ee.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function ye(F){me.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function te(F,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let we=ne.get(F);we===void 0&&(we=n.getUniformBlockIndex(re,F.name),n.uniformBlockBinding(re,we,we),ne.set(F,we))}function ie(F,re,ne){let ge=c.get(re).get(F);l[ge]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ge,ne),l[ge]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,se={},h={},l={},d=new WeakMap,p=[],y=null,g=!1,m=null,b=null,A=null,S=null,P=null,C=null,v=null,E=new xt(0,0,0),B=0,N=!1,L=null,k=null,z=null,U=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Se,disable:He,bindFramebuffer:ot,drawBuffers:Ve,useProgram:ft,setBlending:Yt,setMaterial:zt,setFlipSided:un,setCullFace:Ut,setLineWidth:Cn,setPolygonOffset:bt,setScissorTest:xn,activeTexture:en,bindTexture:hn,unbindTexture:O,compressedTexImage2D:Re,compressedTexImage3D:Ye,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:qe,texStorage3D:R,texSubImage2D:at,texSubImage3D:Me,compressedTexSubImage2D:Ot,compressedTexSubImage3D:ze,scissor:_e,viewport:ye,reset:pe}}function mA(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new it,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,y=new FinalizationRegistry(R=>p.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,M){return g?new OffscreenCanvas(R,M):Ha("canvas")}function b(R,M,q){let ue=1,oe=qe(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _e=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);h===void 0&&(h=m(_e,ye));let te=M?m(_e,ye):h;return te.width=_e,te.height=ye,te.getContext("2d").drawImage(R,0,0,_e,ye),Xe("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+_e+"x"+ye+")."),te}else return"data"in R&&Xe("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function P(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,M,q,ue,oe,_e=!1){if(R!==null){if(n[R]!==void 0)return n[R];Xe("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Xe("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.R16_EXT),q===n.SHORT&&ye&&(te=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),M===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RG16_EXT),q===n.SHORT&&ye&&(te=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGB16_EXT),q===n.SHORT&&ye&&(te=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let ie=_e?Va:yt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Pt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(te=ye.RGBA16_EXT),q===n.SHORT&&ye&&(te=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function v(R,M){let q;return R?M===null||M===Xi||M===Gr?q=n.DEPTH24_STENCIL8:M===Yi?q=n.DEPTH32F_STENCIL8:M===ea&&(q=n.DEPTH24_STENCIL8,Xe("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Xi||M===Gr?q=n.DEPTH_COMPONENT24:M===Yi?q=n.DEPTH_COMPONENT32F:M===ea&&(q=n.DEPTH_COMPONENT16),q}function E(R,M){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Un&&R.minFilter!==On?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function B(R){let M=new WeakRef(R);i.get(R).__ref=M,p.add(M),y.register(R,M,M)}function N(R){let M=i.get(R).__ref;M!==void 0&&(p.delete(M),y.unregister(M))}function L(R){z(R.target)}function k(R){U(R.target)}function z(R){R.removeEventListener("dispose",L),N(R),$(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function U(R){R.removeEventListener("dispose",k),N(R),le(R)}function H(){for(let R of p){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?U(M):z(M))}p.clear(),f.clear()}function $(R){let M=i.get(R);if(M.__webglInit===void 0)return;let q=R.source,ue=d.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(R),Object.keys(ue).length===0&&d.delete(q)}i.remove(R)}function G(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let q=R.source,ue=d.get(q);delete ue[M.__cacheKey],o.memory.textures--}function le(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&z(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let _e=0;_e<M.__webglFramebuffer[oe].length;_e++)n.deleteFramebuffer(M.__webglFramebuffer[oe][_e]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,_e=ue.length;oe<_e;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let J=0;function Q(){J=0}function se(){return J}function fe(R){J=R}function he(){let R=J;return R>=s.maxTextures&&Xe("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function ee(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let q=i.get(R);if(R.isVideoTexture&&Ot(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Xe("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Xe("WebGLRenderer: Texture marked for update but image is incomplete");else{zt(q,R,M);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ve(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){zt(q,R,M);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Ae(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){zt(q,R,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function Se(R,M){let q=i.get(R);if(R.version>0&&q.__version!==R.version){un(q,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let He={[Vc]:n.REPEAT,[ls]:n.CLAMP_TO_EDGE,[Gc]:n.MIRRORED_REPEAT},ot={[Un]:n.NEAREST,[u0]:n.NEAREST_MIPMAP_NEAREST,[sl]:n.NEAREST_MIPMAP_LINEAR,[On]:n.LINEAR,[gu]:n.LINEAR_MIPMAP_NEAREST,[Is]:n.LINEAR_MIPMAP_LINEAR},Ve={[p0]:n.NEVER,[Nd]:n.ALWAYS,[m0]:n.LESS,[Ld]:n.LEQUAL,[g0]:n.EQUAL,[Dd]:n.GEQUAL,[_0]:n.GREATER,[v0]:n.NOTEQUAL};function ft(R,M){if(M.type===Yi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===On||M.magFilter===gu||M.magFilter===sl||M.magFilter===Is||M.minFilter===On||M.minFilter===gu||M.minFilter===sl||M.minFilter===Is)&&Xe("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,He[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,He[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,He[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ot[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ot[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ve[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===Un||M.minFilter!==sl&&M.minFilter!==Is||M.type===Yi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ct(R,M){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),B(M));let ue=M.source,oe=d.get(ue);oe===void 0&&(oe={},d.set(ue,oe));let _e=ee(M);if(_e!==R.__cacheKey){oe[_e]===void 0&&(oe[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[_e].usedTimes++;let ye=oe[R.__cacheKey];ye!==void 0&&(oe[R.__cacheKey].usedTimes--,ye.usedTimes===0&&G(M)),R.__cacheKey=_e,R.__webglTexture=oe[_e].texture}return q}function st(R,M,q){return Math.floor(Math.floor(R/q)/M)}function Yt(R,M,q,ue){let _e=R.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{_e.sort((F,re)=>F.start-re.start);let ye=0;for(let F=1;F<_e.length;F++){let re=_e[ye],ne=_e[F],we=re.start+re.count,ge=st(ne.start,M.width,4),be=st(re.start,M.width,4);ne.start<=we+1&&ge===be&&st(ne.start+ne.count-1,M.width,4)===ge?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ye,_e[ye]=ne)}_e.length=ye+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,re=_e.length;F<re;F++){let ne=_e[F],we=Math.floor(ne.start/4),ge=Math.ceil(ne.count/4),be=we%M.width,Ge=Math.floor(we/M.width),Ke=ge,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,be),t.pixelStorei(n.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(n.TEXTURE_2D,0,be,Ge,Ke,ce,q,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function zt(R,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=ct(R,M),_e=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(_e);if(_e.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=yt.getPrimaries(yt.workingColorSpace),Oe=M.colorSpace===Ds?null:yt.getPrimaries(M.colorSpace),Je=M.colorSpace===Ds||ce===Oe?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let ie=b(M.image,!1,s.maxTextureSize);ie=ze(M,ie);let pe=r.convert(M.format,M.colorSpace),F=r.convert(M.type),re=C(M.internalFormat,pe,F,M.normalized,M.colorSpace,M.isVideoTexture);ft(ue,M);let ne,we=M.mipmaps,ge=M.isVideoTexture!==!0,be=ye.__version===void 0||oe===!0,Ge=_e.dataReady,Ke=E(M,ie);if(M.isDepthTexture)re=v(M.format===Ls,M.type),be&&(ge?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,null));else if(M.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(n.TEXTURE_2D,Ke,re,we[0].width,we[0].height);for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],ge?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data);M.generateMipmaps=!1}else ge?(be&&t.texStorage2D(n.TEXTURE_2D,Ke,re,ie.width,ie.height),Ge&&Yt(M,ie,pe,F)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,pe,F,ie.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){ge&&be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,re,we[0].width,we[0].height,ie.depth);for(let ce=0,Oe=we.length;ce<Oe;ce++)if(ne=we[ce],M.format!==Zi)if(pe!==null)if(ge){if(Ge)if(M.layerUpdates.size>0){let Je=Wd(ne.width,ne.height,M.format,M.type);for(let Ce of M.layerUpdates){let lt=ne.data.subarray(Ce*Je/ne.data.BYTES_PER_ELEMENT,(Ce+1)*Je/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,lt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?Ge&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,pe,F,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,pe,F,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(n.TEXTURE_2D,Ke,re,we[0].width,we[0].height);for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],M.format!==Zi?pe!==null?ge?Ge&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data)}else if(M.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(n.TEXTURE_2D_ARRAY,Ke,re,ie.width,ie.height,ie.depth),Ge)if(M.layerUpdates.size>0){let ce=Wd(ie.width,ie.height,M.format,M.type);for(let Oe of M.layerUpdates){let Je=ie.data.subarray(Oe*ce/ie.data.BYTES_PER_ELEMENT,(Oe+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Oe,ie.width,ie.height,1,pe,F,Je)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isData3DTexture)ge?(be&&t.texStorage3D(n.TEXTURE_3D,Ke,re,ie.width,ie.height,ie.depth),Ge&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,pe,F,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,pe,F,ie.data);else if(M.isFramebufferTexture){if(be)if(ge)t.texStorage2D(n.TEXTURE_2D,Ke,re,ie.width,ie.height);else{let ce=ie.width,Oe=ie.height;for(let Je=0;Je<Ke;Je++)t.texImage2D(n.TEXTURE_2D,Je,re,ce,Oe,0,pe,F,null),ce>>=1,Oe>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),f.add(M),ce.onpaint=Oe=>{let Je=Oe.changedElements;for(let Ce of f)Je.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let Je=n.RGBA,Ce=n.RGBA,lt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Je,Ce,lt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ce=qe(we[0]);t.texStorage2D(n.TEXTURE_2D,Ke,re,ce.width,ce.height)}for(let ce=0,Oe=we.length;ce<Oe;ce++)ne=we[ce],ge?Ge&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,F,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,F,ne);M.generateMipmaps=!1}else if(ge){if(be){let ce=qe(ie);t.texStorage2D(n.TEXTURE_2D,Ke,re,ce.width,ce.height)}Ge&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,F,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,F,ie);A(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=_e.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function un(R,M,q){if(M.image.length!==6)return;let ue=ct(R,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let _e=i.get(oe);if(oe.version!==_e.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=yt.getPrimaries(yt.workingColorSpace),te=M.colorSpace===Ds?null:yt.getPrimaries(M.colorSpace),ie=M.colorSpace===Ds||ye===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!F?re[Ce]=b(M.image[Ce],!0,s.maxCubemapSize):re[Ce]=F?M.image[Ce].image:M.image[Ce],re[Ce]=ze(M,re[Ce]);let ne=re[0],we=r.convert(M.format,M.colorSpace),ge=r.convert(M.type),be=C(M.internalFormat,we,ge,M.normalized,M.colorSpace),Ge=M.isVideoTexture!==!0,Ke=_e.__version===void 0||ue===!0,ce=oe.dataReady,Oe=E(M,ne);ft(n.TEXTURE_CUBE_MAP,M);let Je;if(M.isDepthTexture){if(be=v(M.format===Ls,M.type),Ke)if(Ge)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,be,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,ne.width,ne.height,0,we,ge,null)}else if(pe){Ge&&Ke&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,be,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){Je=re[Ce].mipmaps;for(let lt=0;lt<Je.length;lt++){let Vt=Je[lt];M.format!==Zi?we!==null?Ge?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Vt.width,Vt.height,we,Vt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,be,Vt.width,Vt.height,0,Vt.data):Xe("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,0,0,Vt.width,Vt.height,we,ge,Vt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt,be,Vt.width,Vt.height,0,we,ge,Vt.data)}}}else{if(Je=M.mipmaps,Ge&&Ke){Je.length>0&&Oe++;let Ce=qe(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Oe,be,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(F){Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,we,ge,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,re[Ce].width,re[Ce].height,0,we,ge,re[Ce].data);for(let lt=0;lt<Je.length;lt++){let Hn=Je[lt].image[Ce].image;Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,Hn.width,Hn.height,we,ge,Hn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,be,Hn.width,Hn.height,0,we,ge,Hn.data)}}else{Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,ge,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,be,we,ge,re[Ce]);for(let lt=0;lt<Je.length;lt++){let Vt=Je[lt];Ge?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,0,0,we,ge,Vt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,lt+1,be,we,ge,Vt.image[Ce])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=oe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Ut(R,M,q,ue,oe,_e){let ye=r.convert(q.format,q.colorSpace),te=r.convert(q.type),ie=C(q.internalFormat,ye,te,q.normalized,q.colorSpace),pe=i.get(M),F=i.get(q);if(F.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>_e),ne=Math.max(1,M.height>>_e);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,_e,ie,re,ne,M.depth,0,ye,te,null):t.texImage2D(oe,_e,ie,re,ne,0,ye,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,F.__webglTexture,0,at(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,F.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Cn(R,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,_e=v(M.stencilBuffer,oe),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),_e,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),_e,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,_e,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let _e=ue[oe],ye=r.convert(_e.format,_e.colorSpace),te=r.convert(_e.type),ie=C(_e.internalFormat,ye,te,_e.normalized,_e.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(M),ie,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(M),ie,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,ie,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(R,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let _e=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||_e.width!==M.width||_e.height!==M.height)&&(_e.width=M.width,_e.height=M.height,M.depthTexture.needsUpdate=!0),ue?Se(M.depthTexture,0):me(M.depthTexture,0);let ye=oe.__webglTexture,te=at(M),ie=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===Ls?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Cs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else if(M.depthTexture.format===Ls)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,ie,ye,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,ie,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function xn(R){let M=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)bt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?bt(M.__webglFramebuffer[0],R,0):bt(M.__webglFramebuffer,R,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),Cn(M.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Cn(M.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function en(R,M,q){let ue=i.get(R);M!==void 0&&Ut(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&xn(R)}function hn(R){let M=R.texture,q=i.get(R),ue=i.get(M);R.addEventListener("dispose",k),B(R);let oe=R.textures,_e=R.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<M.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let te=0,ie=oe.length;te<ie;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(ie.format,ie.colorSpace),F=r.convert(ie.type),re=C(ie.internalFormat,pe,F,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=at(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Cn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ft(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(q.__webglFramebuffer[te][ie],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Ut(q.__webglFramebuffer[te],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let te=0,ie=oe.length;te<ie;te++){let pe=oe[te],F=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,F.__webglTexture),ft(re,pe),Ut(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,re,0),A(pe)&&S(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),ft(te,M),M.mipmaps.length>0)for(let ie=0;ie<M.mipmaps.length;ie++)Ut(q.__webglFramebuffer[ie],R,M,n.COLOR_ATTACHMENT0,te,ie);else Ut(q.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,te,0);A(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&xn(R)}function O(R){let M=R.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(A(oe)&&oe.mipmapsAutoUpdate===!0){let _e=P(R),ye=i.get(oe).__webglTexture;t.bindTexture(_e,ye),S(_e),t.unbindTexture()}}}let Re=[];function Ye(R){if(R.samples>0){if(Me(R)===!1){let M=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,_e=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function at(R){return Math.min(s.maxSamples,R.samples)}function Me(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Ot(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function ze(R,M){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==za&&q!==Ds&&(yt.getTransfer(q)===Pt?(ue!==Zi||oe!==Mi)&&Xe("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):nt("WebGLTextures: Unsupported texture color space:",q)),M}function qe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=me,this.setTexture2DArray=ve,this.setTexture3D=Ae,this.setTextureCube=Se,this.rebindTextures=en,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Ye,this.setupDepthRenderbuffer=xn,this.setupFrameBufferTexture=Ut,this.useMultisampledRTT=Me,this.dispose=H}function gA(n,e){function t(i,s=Ds){let r,o=yt.getTransfer(s);if(i===Mi)return n.UNSIGNED_BYTE;if(i===vu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===yu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Ed)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ad)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===wd)return n.BYTE;if(i===Td)return n.SHORT;if(i===ea)return n.UNSIGNED_SHORT;if(i===_u)return n.INT;if(i===Xi)return n.UNSIGNED_INT;if(i===Yi)return n.FLOAT;if(i===$i)return n.HALF_FLOAT;if(i===Cd)return n.ALPHA;if(i===Rd)return n.RGB;if(i===Zi)return n.RGBA;if(i===Cs)return n.DEPTH_COMPONENT;if(i===Ls)return n.DEPTH_STENCIL;if(i===Pd)return n.RED;if(i===xu)return n.RED_INTEGER;if(i===dr)return n.RG;if(i===bu)return n.RG_INTEGER;if(i===Su)return n.RGBA_INTEGER;if(i===rl||i===ol||i===al||i===ll)if(o===Pt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===rl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===rl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===ol)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===al)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===ll)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Mu||i===wu||i===Tu||i===Eu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Mu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===wu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Tu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Eu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Au||i===Cu||i===Ru||i===Pu||i===Iu||i===cl||i===Lu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Au||i===Cu)return o===Pt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ru)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Pu)return r.COMPRESSED_R11_EAC;if(i===Iu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===cl)return r.COMPRESSED_RG11_EAC;if(i===Lu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Du||i===Nu||i===Uu||i===Fu||i===Ou||i===Bu||i===ku||i===zu||i===Vu||i===Gu||i===Hu||i===Wu||i===qu||i===Xu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Du)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Nu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Uu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Fu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Ou)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Bu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ku)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===zu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Vu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Gu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Hu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Wu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===qu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Xu)return o===Pt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Yu||i===$u||i===Zu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Yu)return o===Pt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===$u)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Zu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ku||i===Ju||i===ul||i===ju)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Ku)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ju)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===ul)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===ju)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Gr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var _A=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,vA=`
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

}`,Qd=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ja(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new bi({vertexShader:_A,fragmentShader:vA,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Li(new Qa(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},ep=class extends qi{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,y=typeof XRWebGLBinding<"u",g=new Qd,m={},b=t.getContextAttributes(),A=null,S=null,P=[],C=[],v=new it,E=null,B=null,N=new Kn;N.viewport=new Qt;let L=new Kn;L.viewport=new Qt;let k=[N,L],z=new du,U=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let me=P[ee];return me===void 0&&(me=new qo,P[ee]=me),me.getTargetRaySpace()},this.getControllerGrip=function(ee){let me=P[ee];return me===void 0&&(me=new qo,P[ee]=me),me.getGripSpace()},this.getHand=function(ee){let me=P[ee];return me===void 0&&(me=new qo,P[ee]=me),me.getHandSpace()};function $(ee){let me=C.indexOf(ee.inputSource);if(me===-1)return;let ve=P[me];ve!==void 0&&(ve.update(ee.inputSource,ee.frame,c||o),ve.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<P.length;ee++){let me=C[ee];me!==null&&(C[ee]=null,P[ee].disconnect(me))}U=null,H=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(A),d=null,h=null,f=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(v.width,v.height,!1),B!==null){let ee=B.camera;ee.fov=B.fov,ee.zoom=B.zoom,ee.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Xe("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Xe("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&y&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",le),b.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(v),y&&"createProjectionLayer"in XRWebGLBinding.prototype){let ve=null,Ae=null,Se=null;b.depth&&(Se=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ve=b.stencil?Ls:Cs,Ae=b.stencil?Gr:Xi);let He={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(He),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new yi(h.textureWidth,h.textureHeight,{format:Zi,type:Mi,depthTexture:new Ps(h.textureWidth,h.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,ve),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ve={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ve),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new yi(d.framebufferWidth,d.framebufferHeight,{format:Zi,type:Mi,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(ee){for(let me=0;me<ee.removed.length;me++){let ve=ee.removed[me],Ae=C.indexOf(ve);Ae>=0&&(C[Ae]=null,P[Ae].disconnect(ve))}for(let me=0;me<ee.added.length;me++){let ve=ee.added[me],Ae=C.indexOf(ve);if(Ae===-1){for(let He=0;He<P.length;He++)if(He>=C.length){C.push(ve),Ae=He;break}else if(C[He]===null){C[He]=ve,Ae=He;break}if(Ae===-1)break}let Se=P[Ae];Se&&Se.connect(ve)}}function J(ee,me){me===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(me.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let me=ee.near,ve=ee.far;g.texture!==null&&(g.depthNear>0&&(me=g.depthNear),g.depthFar>0&&(ve=g.depthFar)),z.near=L.near=N.near=me,z.far=L.far=N.far=ve,(U!==z.near||H!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,H=z.far),z.layers.mask=ee.layers.mask|6,N.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Ae=ee.parent,Se=z.cameras;J(z,Ae);for(let He=0;He<Se.length;He++)J(Se[He],Ae);z.projectionMatrix.copy(N.projectionMatrix),z.projectionMatrixInverse.copy(N.projectionMatrixInverse),B===null&&ee.isPerspectiveCamera&&(B={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,z,Ae)};function Q(ee,me,ve){ve===null?ee.matrix.copy(me.matrixWorld):(ee.matrix.copy(ve.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(me.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(me.projectionMatrix),ee.projectionMatrixInverse.copy(me.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Ho*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(z)},this.getCameraTexture=function(ee){return m[ee]};let se=null;function fe(ee,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ve=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Ae=!1;ve.length!==z.cameras.length&&(z.cameras.length=0,Ae=!0);for(let Ve=0;Ve<ve.length;Ve++){let ft=ve[Ve],ct=null;if(d!==null)ct=d.getViewport(ft);else{let Yt=f.getViewSubImage(h,ft);ct=Yt.viewport,Ve===0&&(e.setRenderTargetTextures(S,Yt.colorTexture,Yt.depthStencilTexture),e.setRenderTarget(S))}let st=k[Ve];st===void 0&&(st=new Kn,st.layers.enable(Ve),st.viewport=new Qt,k[Ve]=st),st.matrix.fromArray(ft.transform.matrix),st.matrix.decompose(st.position,st.quaternion,st.scale),st.projectionMatrix.fromArray(ft.projectionMatrix),st.projectionMatrixInverse.copy(st.projectionMatrix).invert(),st.viewport.set(ct.x,ct.y,ct.width,ct.height),Ve===0&&(z.matrix.copy(st.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Ae===!0&&z.cameras.push(st)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&y){f=i.getBinding();let Ve=f.getDepthInformation(ve[0]);Ve&&Ve.isValid&&Ve.texture&&g.init(Ve,s.renderState)}if(Se&&Se.includes("camera-access")&&y){e.state.unbindTexture(),f=i.getBinding();for(let Ve=0;Ve<ve.length;Ve++){let ft=ve[Ve].camera;if(ft){let ct=m[ft];ct||(ct=new ja,m[ft]=ct);let st=f.getCameraImage(ft);ct.sourceTexture=st}}}}for(let ve=0;ve<P.length;ve++){let Ae=C[ve],Se=P[ve];Ae!==null&&Se!==void 0&&Se.update(Ae,me,c||o)}se&&se(ee,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new J0;he.setAnimationLoop(fe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},yA=new jt,av=new et;av.set(-1,0,0,0,1,0,0,0,1);function xA(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Vd(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,b,A,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),f(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&d(g,m,S)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),y(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,b,A):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===jn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===jn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let b=e.get(m),A=b.envMap,S=b.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(yA.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(av),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,b,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*b,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function f(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,b){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===jn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=b.texture,g.transmissionSamplerSize.value.set(b.width,b.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function y(g,m){let b=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(b.matrixWorld),g.nearDistance.value=b.shadow.camera.near,g.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function bA(n,e,t,i){let s={},r={};function o(b,A){let S=A.program;i.uniformBlockBinding(b,S,s[b.id])}function a(b,A){let S=s[b.id];S===void 0&&(p(b),S=l(b),s[b.id]=S,b.addEventListener("dispose",g));let P=A.program;i.updateUBOMapping(b,P);let C=e.render.frame;r[b.id]!==C&&(c(b),r[b.id]=C)}function l(b){let A=n.createBuffer(),S=b.__size,P=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,P),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(b){let A=s[b.id],S=b.uniforms,P=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let C=0,v=S.length;C<v;C++){let E=S[C];if(Array.isArray(E))for(let B=0,N=E.length;B<N;B++)u(E[B],C,B,P);else u(E,C,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(b,A,S,P){if(h(b,A,S,P)===!0){let C=b.__offset,v=b.value;if(Array.isArray(v)){let E=0;for(let B=0;B<v.length;B++){let N=v[B],L=y(N,!0);f(N,b.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(v,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,b.__data)}}function f(b,A,S){typeof b=="number"||typeof b=="boolean"?A[S]=b:b.isMatrix3?(A[S]=b.elements[0],A[S+1]=b.elements[1],A[S+2]=b.elements[2],A[S+3]=0,A[S+4]=b.elements[3],A[S+5]=b.elements[4],A[S+6]=b.elements[5],A[S+7]=0,A[S+8]=b.elements[6],A[S+9]=b.elements[7],A[S+10]=b.elements[8],A[S+11]=0):ArrayBuffer.isView(b)?A.set(b.subarray(0,A.length-S),S):b.toArray(A,S)}function h(b,A,S,P){let C=b.value,v=A+"_"+S;if(Array.isArray(C)){P[v]===void 0&&(P[v]=[]);let E=P[v],B=!1;for(let N=0;N<C.length;N++)d(C[N],E,N)===!0&&(B=!0);return B}return d(C,P,v)}function d(b,A,S){if(A[S]===void 0)return typeof b=="number"||typeof b=="boolean"?A[S]=b:ArrayBuffer.isView(b)?A[S]=b.slice():A[S]=b.clone(),!0;{let P=A[S];if(typeof b=="number"||typeof b=="boolean"){if(P!==b)return A[S]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(P.equals(b)===!1)return P.copy(b),!0}}return!1}function p(b){let A=b.uniforms,S=0,P=16;for(let v=0,E=A.length;v<E;v++){let B=Array.isArray(A[v])?A[v]:[A[v]];for(let N=0,L=B.length;N<L;N++){let k=B[N],z=Array.isArray(k.value)?k.value:[k.value],U=Array.isArray(A[v])||Array.isArray(k.value),H=S;for(let G=0,le=z.length;G<le;G++){let J=z[G],Q=y(J,U),se=S%P,fe=se%Q.boundary,he=se+fe;S+=fe,he!==0&&P-he<Q.storage&&(S+=P-he),G===0&&(H=S),S+=Q.storage}let $=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new $((S-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let C=S%P;return C>0&&(S+=P-C),b.__size=S,b.__cache={},this}function y(b,A){let S={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(S.boundary=4,S.storage=4):b.isVector2?(S.boundary=8,S.storage=8):b.isVector3||b.isColor?(S.boundary=16,S.storage=12):b.isVector4?(S.boundary=16,S.storage=16):b.isMatrix3?(S.boundary=16,S.storage=48):b.isMatrix4?(S.boundary=16,S.storage=64):b.isTexture?Xe("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(S.boundary=16,S.storage=b.byteLength):Xe("WebGLRenderer: Unsupported uniform value type.",b),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(b){let A=b.target;A.removeEventListener("dispose",g),n.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let b in s)n.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:m}}var SA=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),fs=null;function MA(){return fs===null&&(fs=new Or(SA,16,16,dr,$i),fs.name="DFG_LUT",fs.minFilter=On,fs.magFilter=On,fs.wrapS=ls,fs.wrapT=ls,fs.generateMipmaps=!1,fs.needsUpdate=!0),fs}var nh=class{constructor(e={}){let{canvas:t=x0(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=Mi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let y=d,g=new Set([Su,bu,xu]),m=new Set([Mi,Xi,ea,Gr,vu,yu]),b=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,C=null,v=[],E=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=hs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,k=null,z=null,U=null,H=null;this._outputColorSpace=gi;let $=0,G=0,le=null,J=-1,Q=null,se=new Qt,fe=new Qt,he=null,ee=new xt(0),me=0,ve=t.width,Ae=t.height,Se=1,He=null,ot=null,Ve=new Qt(0,0,ve,Ae),ft=new Qt(0,0,ve,Ae),ct=!1,st=new Br,Yt=new $c,zt=!1,un=!1,Ut=new jt,Cn=new Z,bt=new Qt,xn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function hn(){return le===null?Se:1}let O=i;function Re(T,V){return t.getContext(T,V)}let Ye,at,Me,Ot,ze,qe,R,M,q,ue,oe,_e,ye,te,ie,pe,F,re,ne,we,ge,be,Ge;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),O===null){let V="webgl2";if(O=Re(V,T),O===null)throw Re(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ke()}catch(T){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),nt("WebGLRenderer: "+T.message),T}function Ke(){Ye=new NT(O),Ye.init(),ge=new gA(O,Ye),at=new MT(O,Ye,e,ge),Me=new pA(O,Ye),at.reversedDepthBuffer&&h&&Me.buffers.depth.setReversed(!0),z=O.createFramebuffer(),U=O.createFramebuffer(),H=O.createFramebuffer(),Ot=new OT(O),ze=new eA,qe=new mA(O,Ye,Me,ze,at,ge,Ot),R=new DT(N),M=new kM(O),be=new bT(O,M),q=new UT(O,M,Ot,be),ue=new kT(O,q,M,be,Ot),re=new BT(O,at,qe),ie=new wT(ze),oe=new QE(N,R,Ye,at,be,ie),_e=new xA(N,ze),ye=new nA,te=new lA(Ye),F=new xT(N,R,Me,ue,p,l),pe=new dA(N,ue,at),Ge=new bA(O,Ot,at,Me),ne=new ST(O,Ye,Ot),we=new FT(O,Ye,Ot),Ot.programs=oe.programs,N.capabilities=at,N.extensions=Ye,N.properties=ze,N.renderLists=ye,N.shadowMap=pe,N.state=Me,N.info=Ot}y!==Mi&&(B=new VT(y,t.width,t.height,a,s,r));let ce=new ep(N,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let T=Ye.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=Ye.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(T){T!==void 0&&(Se=T,this.setSize(ve,Ae,!1))},this.getSize=function(T){return T.set(ve,Ae)},this.setSize=function(T,V,j=!0){if(ce.isPresenting){Xe("WebGLRenderer: Can't change size while VR device is presenting.");return}ve=T,Ae=V,t.width=Math.floor(T*Se),t.height=Math.floor(V*Se),j===!0&&(t.style.width=T+"px",t.style.height=V+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,T,V)},this.getDrawingBufferSize=function(T){return T.set(ve*Se,Ae*Se).floor()},this.setDrawingBufferSize=function(T,V,j){ve=T,Ae=V,Se=j,t.width=Math.floor(T*j),t.height=Math.floor(V*j),this.setViewport(0,0,T,V)},this.setEffects=function(T){if(y===Mi){nt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let V=0;V<T.length;V++)if(T[V].isOutputPass===!0){Xe("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(se)},this.getViewport=function(T){return T.copy(Ve)},this.setViewport=function(T,V,j,X){T.isVector4?Ve.set(T.x,T.y,T.z,T.w):Ve.set(T,V,j,X),Me.viewport(se.copy(Ve).multiplyScalar(hn()).round())},this.getScissor=function(T){return T.copy(ft)},this.setScissor=function(T,V,j,X){T.isVector4?ft.set(T.x,T.y,T.z,T.w):ft.set(T,V,j,X),Me.scissor(fe.copy(ft).multiplyScalar(hn()).round())},this.getScissorTest=function(){return ct},this.setScissorTest=function(T){Me.setScissorTest(ct=T)},this.setOpaqueSort=function(T){He=T},this.setTransparentSort=function(T){ot=T},this.getClearColor=function(T){return T.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(T=!0,V=!0,j=!0){let X=0;if(T){let Y=!1;if(le!==null){let Te=le.texture.format;Y=g.has(Te)}if(Y){let Te=le.texture.type,Pe=m.has(Te),Ee=F.getClearColor(),Ie=F.getClearAlpha(),ke=Ee.r,tt=Ee.g,dt=Ee.b;Pe?(b[0]=ke,b[1]=tt,b[2]=dt,b[3]=Ie,O.clearBufferuiv(O.COLOR,0,b)):(A[0]=ke,A[1]=tt,A[2]=dt,A[3]=Ie,O.clearBufferiv(O.COLOR,0,A))}else X|=O.COLOR_BUFFER_BIT}V&&(X|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(X|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),X!==0&&O.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),k=T},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),F.dispose(),ye.dispose(),te.dispose(),qe.dispose(),ze.dispose(),R.dispose(),ue.dispose(),q.dispose(),be.dispose(),Ge.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",vl),ce.removeEventListener("sessionend",Ki),ps.stop()};function Oe(T){T.preventDefault(),Fd("WebGLRenderer: Context Lost."),L=!0}function Je(){Fd("WebGLRenderer: Context Restored."),L=!1;let T=Ot.autoReset,V=pe.enabled,j=pe.autoUpdate,X=pe.needsUpdate,Y=pe.type;Ke(),Ot.autoReset=T,pe.enabled=V,pe.autoUpdate=j,pe.needsUpdate=X,pe.type=Y}function Ce(T){nt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function lt(T){let V=T.target;V.removeEventListener("dispose",lt),Vt(V)}function Vt(T){Hn(T),ze.remove(T)}function Hn(T){let V=ze.get(T).programs;V!==void 0&&(V.forEach(function(j){oe.releaseProgram(j)}),T.isShaderMaterial&&oe.releaseShaderCache(T))}this.renderBufferDirect=function(T,V,j,X,Y,Te){V===null&&(V=xn);let Pe=Y.isMesh&&Y.matrixWorld.determinantAffine()<0,Ee=ca(T,V,j,X,Y);Me.setMaterial(X,Pe);let Ie=j.index,ke=1;if(X.wireframe===!0){if(Ie=q.getWireframeAttribute(j),Ie===void 0)return;ke=2}let tt=j.drawRange,dt=j.attributes.position,Be=tt.start*ke,pt=(tt.start+tt.count)*ke;Te!==null&&(Be=Math.max(Be,Te.start*ke),pt=Math.min(pt,(Te.start+Te.count)*ke)),Ie!==null?(Be=Math.max(Be,0),pt=Math.min(pt,Ie.count)):dt!=null&&(Be=Math.max(Be,0),pt=Math.min(pt,dt.count));let Kt=pt-Be;if(Kt<0||Kt===1/0)return;be.setup(Y,X,Ee,j,Ie);let It,Lt=ne;if(Ie!==null&&(It=M.get(Ie),Lt=we,Lt.setIndex(It)),Y.isMesh)X.wireframe===!0?(Me.setLineWidth(X.wireframeLinewidth*hn()),Lt.setMode(O.LINES)):Lt.setMode(O.TRIANGLES);else if(Y.isLine){let bn=X.linewidth;bn===void 0&&(bn=1),Me.setLineWidth(bn*hn()),Y.isLineSegments?Lt.setMode(O.LINES):Y.isLineLoop?Lt.setMode(O.LINE_LOOP):Lt.setMode(O.LINE_STRIP)}else Y.isPoints?Lt.setMode(O.POINTS):Y.isSprite&&Lt.setMode(O.TRIANGLES);if(Y.isBatchedMesh)if(Ye.get("WEBGL_multi_draw"))Lt.renderMultiDraw(Y._multiDrawStarts,Y._multiDrawCounts,Y._multiDrawCount);else{let bn=Y._multiDrawStarts,Ue=Y._multiDrawCounts,fn=Y._multiDrawCount,_t=Ie?M.get(Ie).bytesPerElement:1,gs=ze.get(X).currentProgram.getUniforms();for(let dn=0;dn<fn;dn++)gs.setValue(O,"_gl_DrawID",dn),Lt.render(bn[dn]/_t,Ue[dn])}else if(Y.isInstancedMesh)Lt.renderInstances(Be,Kt,Y.count);else if(j.isInstancedBufferGeometry){let bn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,bn);Lt.renderInstances(Be,Kt,Ue)}else Lt.render(Be,Kt)};function oa(T,V,j,X){k!==null&&T.isNodeMaterial&&k.setObject(X,T),zt===!0&&ie.setState(T,j,!1),T.transparent===!0&&T.side===Di&&T.forceSinglePass===!1?(T.side=jn,T.needsUpdate=!0,Ji(T,V,X),T.side=fr,T.needsUpdate=!0,Ji(T,V,X),T.side=Di):Ji(T,V,X)}this.compile=function(T,V,j=null){j===null&&(j=T),k!==null&&k.renderStart(T,V,j),C=te.get(j),C.init(V),E.push(C),j.traverseVisible(function(Y){Y.isLight&&Y.layers.test(V.layers)&&(C.pushLight(Y),Y.castShadow&&C.pushShadow(Y))}),T!==j&&T.traverseVisible(function(Y){Y.isLight&&Y.layers.test(V.layers)&&(C.pushLight(Y),Y.castShadow&&C.pushShadow(Y))}),C.setupLights(),k!==null&&k.updateLights(C.state.lightsArray),un=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,un),zt===!0&&ie.setGlobalState(this.clippingPlanes,V),k!==null&&pe.render(C.state.shadowsArray,j,V);let X=new Set;return T.traverse(function(Y){if(!(Y.isMesh||Y.isPoints||Y.isLine||Y.isSprite))return;let Te=Y.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ee=Te[Pe];oa(Ee,j,V,Y),X.add(Ee)}else oa(Te,j,V,Y),X.add(Te)}),C=E.pop(),k!==null&&k.renderEnd(),X},this.compileAsync=function(T,V,j=null){let X=this.compile(T,V,j);return new Promise(Y=>{function Te(){if(X.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&X.delete(Pe)}),X.size===0){Y(T);return}setTimeout(Te,10)}Ye.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let qr=null;function xh(T){qr&&qr(T)}function vl(){ps.stop()}function Ki(){ps.start()}let ps=new J0;ps.setAnimationLoop(xh),typeof self<"u"&&ps.setContext(self),this.setAnimationLoop=function(T){qr=T,ce.setAnimationLoop(T),T===null?ps.stop():ps.start()},ce.addEventListener("sessionstart",vl),ce.addEventListener("sessionend",Ki),this.render=function(T,V){if(V!==void 0&&V.isCamera!==!0){nt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;k!==null&&k.renderStart(T,V);let j=ce.enabled===!0&&ce.isPresenting===!0,X=B!==null&&(le===null||j)&&B.begin(N,le);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(V),V=ce.getCamera()),T.isScene===!0&&T.onBeforeRender(N,T,V,le),C=te.get(T,E.length),C.init(V),C.state.textureUnits=qe.getTextureUnits(),E.push(C),Ut.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?Yt.setFromArrayCamera(V):st.setFromProjectionMatrix(Ut,Ii,V.reversedDepth),un=this.localClippingEnabled,zt=ie.init(this.clippingPlanes,un),P=ye.get(T,v.length),P.init(),v.push(P),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&ms(Pe,V,-1/0,N.sortObjects)}ms(T,V,0,N.sortObjects),P.finish(),k!==null&&k.updateLights(C.state.lightsArray),N.sortObjects===!0&&P.sort(He,ot),en=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,en&&F.addToRenderList(P,T),this.info.autoReset===!0&&this.info.reset(),zt===!0&&ie.beginShadows();let Y=C.state.shadowsArray;if(pe.render(Y,T,V),zt===!0&&ie.endShadows(),(X&&B.hasRenderPass())===!1){let Pe=P.opaque,Ee=P.transmissive;if(C.setupLights(),V.isArrayCamera){let Ie=V.cameras;if(Ee.length>0)for(let ke=0,tt=Ie.length;ke<tt;ke++){let dt=Ie[ke];Ni(Pe,Ee,T,dt)}en&&F.render(T);for(let ke=0,tt=Ie.length;ke<tt;ke++){let dt=Ie[ke];aa(P,T,dt,dt.viewport)}}else Ee.length>0&&Ni(Pe,Ee,T,V),en&&F.render(T),aa(P,T,V)}le!==null&&G===0&&(qe.updateMultisampleRenderTarget(le),qe.updateRenderTargetMipmap(le)),X&&B.end(N),T.isScene===!0&&T.onAfterRender(N,T,V),be.resetDefaultState(),J=-1,Q=null,E.pop(),E.length>0?(C=E[E.length-1],qe.setTextureUnits(C.state.textureUnits),zt===!0&&ie.setGlobalState(N.clippingPlanes,C.state.camera)):C=null,v.pop(),v.length>0?P=v[v.length-1]:P=null,k!==null&&k.renderEnd()};function ms(T,V,j,X){if(T.visible===!1)return;if(T.layers.test(V.layers)){if(T.isGroup)j=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(V);else if(T.isLight)C.pushLight(T),T.castShadow&&C.pushShadow(T);else if(T.isSprite){let Pe=V.isArrayCamera?Yt:st;if(!T.frustumCulled||T.intersectsFrustum(Pe)){X&&bt.setFromMatrixPosition(T.matrixWorld).applyMatrix4(Ut);let Ee=ue.update(T),Ie=T.material;Ie.visible&&P.push(T,Ee,Ie,j,bt.z,null,V)}}else if(T.isMesh||T.isLine||T.isPoints){let Pe=V.isArrayCamera?Yt:st;if(!T.frustumCulled||T.intersectsFrustum(Pe)){let Ee=ue.update(T),Ie=T.material;if(X&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),bt.copy(T.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),bt.copy(Ee.boundingSphere.center)),bt.applyMatrix4(T.matrixWorld).applyMatrix4(Ut)),Array.isArray(Ie)){let ke=Ee.groups;for(let tt=0,dt=ke.length;tt<dt;tt++){let Be=ke[tt],pt=Ie[Be.materialIndex];pt&&pt.visible&&P.push(T,Ee,pt,j,bt.z,Be,V)}}else Ie.visible&&P.push(T,Ee,Ie,j,bt.z,null,V)}}}let Te=T.children;for(let Pe=0,Ee=Te.length;Pe<Ee;Pe++)ms(Te[Pe],V,j,X)}function aa(T,V,j,X){let{opaque:Y,transmissive:Te,transparent:Pe}=T;C.setupLightsView(j),zt===!0&&ie.setGlobalState(N.clippingPlanes,j),X&&Me.viewport(se.copy(X)),Y.length>0&&tn(Y,V,j),Te.length>0&&tn(Te,V,j),Pe.length>0&&tn(Pe,V,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Ni(T,V,j,X){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[X.id]===void 0){let Be=Ye.has("EXT_color_buffer_half_float")||Ye.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[X.id]=new yi(1,1,{generateMipmaps:!0,type:Be?$i:Mi,minFilter:Is,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:yt.workingColorSpace})}let Te=C.state.transmissionRenderTarget[X.id],Pe=X.viewport||se;Te.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Ee=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ke=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(ee),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),en&&F.render(j);let tt=N.toneMapping;N.toneMapping=hs;let dt=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),C.setupLightsView(X),zt===!0&&ie.setGlobalState(N.clippingPlanes,X),tn(T,j,X),qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te),Ye.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let pt=0,Kt=V.length;pt<Kt;pt++){let It=V[pt],{object:Lt,geometry:bn,material:Ue,group:fn}=It;if(Ue.side===Di&&Lt.layers.test(X.layers)){let _t=Ue.side;Ue.side=jn,Ue.needsUpdate=!0,an(Lt,j,X,bn,Ue,fn),Ue.side=_t,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ee,Ie,ke),N.setClearColor(ee,me),dt!==void 0&&(X.viewport=dt),N.toneMapping=tt}function tn(T,V,j){let X=V.isScene===!0?V.overrideMaterial:null;for(let Y=0,Te=T.length;Y<Te;Y++){let Pe=T[Y],{object:Ee,geometry:Ie,group:ke}=Pe,tt=Pe.material;tt.allowOverride===!0&&X!==null&&(tt=X),Ee.layers.test(j.layers)&&an(Ee,V,j,Ie,tt,ke)}}function an(T,V,j,X,Y,Te){k!==null&&Y.isNodeMaterial&&k.setObject(T,Y),T.onBeforeRender(N,V,j,X,Y,Te),T.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),Y.onBeforeRender(N,V,j,X,T,Te),Y.transparent===!0&&Y.side===Di&&Y.forceSinglePass===!1?(Y.side=jn,Y.needsUpdate=!0,N.renderBufferDirect(j,V,X,Y,T,Te),Y.side=fr,Y.needsUpdate=!0,N.renderBufferDirect(j,V,X,Y,T,Te),Y.side=Di):N.renderBufferDirect(j,V,X,Y,T,Te),T.onAfterRender(N,V,j,X,Y,Te)}function ln(T){let V=0;for(let j of T)j.texture!==null&&V++;return V}function Ji(T,V,j){V.isScene!==!0&&(V=xn);let X=ze.get(T),Y=C.state.lights,Te=C.state.shadowsArray,Pe=Y.state.version,Ee=oe.getParameters(T,Y.state,Te,V,j,C.state.lightProbeGridArray),Ie=oe.getProgramCacheKey(Ee),ke=X.programs;X.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?V.environment:null,X.fog=V.fog;let tt=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;X.envMap=R.get(T.envMap||X.environment,tt),X.envMapRotation=X.environment!==null&&T.envMap===null?V.environmentRotation:T.envMapRotation,ke===void 0&&(T.addEventListener("dispose",lt),ke=new Map,X.programs=ke,X.programVariants=new Map);let dt=ke.get(Ie);if(dt!==void 0){if(X.currentProgram===dt&&X.lightsStateVersion===Pe)return la(T,Ee),dt}else Ee.uniforms=oe.getUniforms(T),k!==null&&T.isNodeMaterial&&k.build(T,j,Ee),T.onBeforeCompile(Ee,N),dt=oe.acquireProgram(Ee,Ie),ke.set(Ie,dt),X.uniforms=Ee.uniforms;let Be=X.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Be.clippingPlanes=ie.uniform),la(T,Ee),X.needsLights=Fs(T),X.lightsStateVersion=Pe,X.needsLights&&(Be.ambientLightColor.value=Y.state.ambient,Be.lightProbe.value=Y.state.probe,Be.sunLights.value=Y.state.sun,Be.sunLightShadows.value=Y.state.sunShadow,Be.directionalLights.value=Y.state.directional,Be.directionalLightShadows.value=Y.state.directionalShadow,Be.spotLights.value=Y.state.spot,Be.spotLightShadows.value=Y.state.spotShadow,Be.rectAreaLights.value=Y.state.rectArea,Be.ltc_1.value=Y.state.rectAreaLTC1,Be.ltc_2.value=Y.state.rectAreaLTC2,Be.pointLights.value=Y.state.point,Be.pointLightShadows.value=Y.state.pointShadow,Be.hemisphereLights.value=Y.state.hemi,Be.sunShadowMatrix.value=Y.state.sunShadowMatrix,Be.sunShadowCascade.value=Y.state.sunShadowCascade,Be.directionalShadowMatrix.value=Y.state.directionalShadowMatrix,Be.spotLightMatrix.value=Y.state.spotLightMatrix,Be.spotLightMap.value=Y.state.spotLightMap,Be.pointShadowMatrix.value=Y.state.pointShadowMatrix),X.numLightProbeGrids=ln(C.state.lightProbeGridArray),X.currentProgram=dt,X.uniformsList=null,dt}function oi(T,V,j,X,Y){let Te=ze.get(T),Pe=Te.currentProgram.id+","+X+","+Y,Ee=Te.programVariants.get(Pe);return Ee===void 0?(Ee=Ji(T,V,j),Te.programVariants.set(Pe,Ee)):(Te.currentProgram=Ee,Te.uniformsList=null,Te.outputColorSpace=X,Te.toneMapping=Y),Ee}function Us(T){if(T.uniformsList===null){let V=T.currentProgram.getUniforms();T.uniformsList=na.seqWithValue(V.seq,T.uniforms)}return T.uniformsList}function la(T,V){let j=ze.get(T);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function ca(T,V,j,X,Y){V.isScene!==!0&&(V=xn),qe.resetTextureUnits();let Te=V.fog,Pe=X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial?V.environment:null,Ee=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:yt.workingColorSpace,Ie=X.isMeshStandardMaterial||X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,ke=R.get(X.envMap||Pe,Ie),tt=X.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,dt=!!j.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Be=!!j.morphAttributes.position,pt=!!j.morphAttributes.normal,Kt=!!j.morphAttributes.color,It=hs;X.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(It=N.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,bn=Lt!==void 0?Lt.length:0,Ue=ze.get(X),fn=C.state.lights;if(zt===!0&&(un===!0||T!==Q)){let Dt=T===Q&&X.id===J;ie.setState(X,T,Dt)}let _t=!1,gs=!1;X.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==fn.state.version||Y.isBatchedMesh&&Ue.batching===!1||!Y.isBatchedMesh&&Ue.batching===!0||Y.isBatchedMesh&&Ue.batchingColor===!0&&Y._colorsTexture===null||Y.isBatchedMesh&&Ue.batchingColor===!1&&Y._colorsTexture!==null||Y.isInstancedMesh&&Ue.instancing===!1||!Y.isInstancedMesh&&Ue.instancing===!0||Y.isSkinnedMesh&&Ue.skinning===!1||!Y.isSkinnedMesh&&Ue.skinning===!0||Y.isInstancedMesh&&Ue.instancingColor===!0&&Y.instanceColor===null||Y.isInstancedMesh&&Ue.instancingColor===!1&&Y.instanceColor!==null||Y.isInstancedMesh&&Ue.instancingMorph===!0&&Y.morphTexture===null||Y.isInstancedMesh&&Ue.instancingMorph===!1&&Y.morphTexture!==null||Ue.envMap!==ke||X.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ie.numPlanes||Ue.numIntersection!==ie.numIntersection)||Ue.vertexAlphas!==tt||Ue.vertexTangents!==dt||Ue.morphTargets!==Be||Ue.morphNormals!==pt||Ue.morphColors!==Kt||Ue.morphTargetsCount!==bn||Ue.numLightProbeGrids!==ln(C.state.lightProbeGridArray)?_t=!0:(Ue.outputColorSpace!==Ee||Ue.toneMapping!==It)&&(gs=!0):(_t=!0,Ue.__version=X.version);let dn=Ue.currentProgram;(_t===!0||gs===!0)&&(dn=gs===!0?oi(X,V,Y,Ee,It):Ji(X,V,Y),k&&X.isNodeMaterial&&k.onUpdateProgram(X,dn,Ue));let $r=!1,ji=!1,_s=!1,ut=dn.getUniforms(),nn=Ue.uniforms;if(Me.useProgram(dn.program)&&($r=!0,ji=!0,_s=!0),X.id!==J&&(J=X.id,ji=!0),$r||Q!==T){Me.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),ut.setValue(O,"projectionMatrix",T.projectionMatrix),ut.setValue(O,"viewMatrix",T.matrixWorldInverse);let pn=ut.map.cameraPosition;pn!==void 0&&pn.setValue(O,Cn.setFromMatrixPosition(T.matrixWorld)),at.logarithmicDepthBuffer&&ut.setValue(O,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&ut.setValue(O,"isOrthographic",T.isOrthographicCamera===!0),Q!==T&&(Q=T,ji=!0,_s=!0)}if(Ue.needsLights&&(fn.state.sunShadowMap.length>0&&ut.setValue(O,"sunShadowMap",fn.state.sunShadowMap,qe),fn.state.directionalShadowMap.length>0&&ut.setValue(O,"directionalShadowMap",fn.state.directionalShadowMap,qe),fn.state.spotShadowMap.length>0&&ut.setValue(O,"spotShadowMap",fn.state.spotShadowMap,qe),fn.state.pointShadowMap.length>0&&ut.setValue(O,"pointShadowMap",fn.state.pointShadowMap,qe)),Y.isSkinnedMesh){ut.setOptional(O,Y,"bindMatrix"),ut.setOptional(O,Y,"bindMatrixInverse");let Dt=Y.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ut.setValue(O,"boneTexture",Dt.boneTexture,qe))}Y.isBatchedMesh&&(ut.setOptional(O,Y,"batchingTexture"),ut.setValue(O,"batchingTexture",Y._matricesTexture,qe),ut.setOptional(O,Y,"batchingIdTexture"),ut.setValue(O,"batchingIdTexture",Y._indirectTexture,qe),ut.setOptional(O,Y,"batchingColorTexture"),Y._colorsTexture!==null&&ut.setValue(O,"batchingColorTexture",Y._colorsTexture,qe));let Wn=j.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&re.update(Y,j,dn),(ji||Ue.receiveShadow!==Y.receiveShadow)&&(Ue.receiveShadow=Y.receiveShadow,ut.setValue(O,"receiveShadow",Y.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&V.environment!==null&&(nn.envMapIntensity.value=V.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=MA()),ji){if(ut.setValue(O,"toneMappingExposure",N.toneMappingExposure),Ue.needsLights&&Xr(nn,_s),Te&&X.fog===!0&&_e.refreshFogUniforms(nn,Te),_e.refreshMaterialUniforms(nn,X,Se,Ae,C.state.transmissionRenderTarget[T.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Dt=S,pn=0;for(let Bn of C.state.lightProbeGridArray)Bn.texture!==null&&(Dt.textures[pn]=Bn.texture,Dt.min[pn]=Bn.boundingBox.min,Dt.max[pn]=Bn.boundingBox.max,Dt.resolution[pn]=Bn.resolution,pn++);for(let Bn in Dt)Dt[Bn].length=pn;nn.probesSH.value=Dt.textures,nn.probesMin.value=Dt.min,nn.probesMax.value=Dt.max,nn.probesResolution.value=Dt.resolution}na.upload(O,Us(Ue),nn,qe)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(na.upload(O,Us(Ue),nn,qe),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&ut.setValue(O,"center",Y.center),ut.setValue(O,"modelViewMatrix",Y.modelViewMatrix),ut.setValue(O,"normalMatrix",Y.normalMatrix),ut.setValue(O,"modelMatrix",Y.matrixWorld),X.uniformsGroups!==void 0){let Dt=X.uniformsGroups;for(let pn=0,Bn=Dt.length;pn<Bn;pn++){let yl=Dt[pn];Ge.update(yl,dn),Ge.bind(yl,dn)}}return dn}function Xr(T,V){T.ambientLightColor.needsUpdate=V,T.lightProbe.needsUpdate=V,T.sunLights.needsUpdate=V,T.sunLightShadows.needsUpdate=V,T.directionalLights.needsUpdate=V,T.directionalLightShadows.needsUpdate=V,T.pointLights.needsUpdate=V,T.pointLightShadows.needsUpdate=V,T.spotLights.needsUpdate=V,T.spotLightShadows.needsUpdate=V,T.rectAreaLights.needsUpdate=V,T.hemisphereLights.needsUpdate=V}function Fs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(T,V,j){let X=ze.get(T);X.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),ze.get(T.texture).__webglTexture=V,ze.get(T.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?void 0:j,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,V){let j=ze.get(T);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(T,V=0,j=0){le=T,$=V,G=j;let X=null,Y=!1,Te=!1;if(T){let Ee=ze.get(T);if(Ee.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(O.FRAMEBUFFER,Ee.__webglFramebuffer),se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest,Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),J=-1;return}else if(Ee.__webglFramebuffer===void 0)qe.setupRenderTarget(T);else if(Ee.__hasExternalTextures)qe.rebindTextures(T,ze.get(T.texture).__webglTexture,ze.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let tt=T.depthTexture;if(Ee.__boundDepthTexture!==tt){if(tt!==null&&ze.has(tt)&&(T.width!==tt.image.width||T.height!==tt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(T)}}let Ie=T.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ke=ze.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(ke[V])?X=ke[V][j]:X=ke[V],Y=!0):T.samples>0&&qe.useMultisampledRTT(T)===!1?X=ze.get(T).__webglMultisampledFramebuffer:Array.isArray(ke)?X=ke[j]:X=ke,se.copy(T.viewport),fe.copy(T.scissor),he=T.scissorTest}else se.copy(Ve).multiplyScalar(Se).floor(),fe.copy(ft).multiplyScalar(Se).floor(),he=ct;if(j!==0&&(X=z),Me.bindFramebuffer(O.FRAMEBUFFER,X)&&Me.drawBuffers(T,X),Me.viewport(se),Me.scissor(fe),Me.setScissorTest(he),Y){let Ee=ze.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+V,Ee.__webglTexture,j)}else if(Te){let Ee=V;for(let Ie=0;Ie<T.textures.length;Ie++){let ke=ze.get(T.textures[Ie]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Ie,ke.__webglTexture,j,Ee)}}else if(T!==null&&j!==0){let Ee=ze.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ee.__webglTexture,j)}J=-1};function Yr(T){let V=ze.get(T);return(V.__readFormat!==T.format||V.__readType!==T.type)&&(V.__readFormat=T.format,V.__readType=T.type,V.__formatReadable=at.textureFormatReadable(T.format),V.__typeReadable=at.textureTypeReadable(T.type)),V}this.readRenderTargetPixels=function(T,V,j,X,Y,Te,Pe,Ee=0){if(!(T&&T.isWebGLRenderTarget)){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Me.bindFramebuffer(O.FRAMEBUFFER,Ie);try{let ke=T.textures[Ee],tt=ke.format,dt=ke.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=Yr(ke);if(Be.__formatReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){nt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=T.width-X&&j>=0&&j<=T.height-Y&&O.readPixels(V,j,X,Y,ge.convert(tt),ge.convert(dt),Te)}finally{let ke=le!==null?ze.get(le).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(T,V,j,X,Y,Te,Pe,Ee=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(V>=0&&V<=T.width-X&&j>=0&&j<=T.height-Y){Me.bindFramebuffer(O.FRAMEBUFFER,Ie);let ke=T.textures[Ee],tt=ke.format,dt=ke.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ee);let Be=Yr(ke);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let pt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.bufferData(O.PIXEL_PACK_BUFFER,Te.byteLength,O.STREAM_READ),O.readPixels(V,j,X,Y,ge.convert(tt),ge.convert(dt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Kt=le!==null?ze.get(le).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,Kt);let It=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await S0(O,It,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,pt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Te),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(pt),O.deleteSync(It),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,V=null,j=0){let X=Math.pow(2,-j),Y=Math.floor(T.image.width*X),Te=Math.floor(T.image.height*X),Pe=V!==null?V.x:0,Ee=V!==null?V.y:0;qe.setTexture2D(T,0),O.copyTexSubImage2D(O.TEXTURE_2D,j,0,0,Pe,Ee,Y,Te),Me.unbindTexture()},this.copyTextureToTexture=function(T,V,j=null,X=null,Y=0,Te=0){let Pe,Ee,Ie,ke,tt,dt,Be,pt,Kt,It=T.isCompressedTexture?T.mipmaps[Te]:T.image;if(j!==null)Pe=j.max.x-j.min.x,Ee=j.max.y-j.min.y,Ie=j.isBox3?j.max.z-j.min.z:1,ke=j.min.x,tt=j.min.y,dt=j.isBox3?j.min.z:0;else{let ut=Math.pow(2,-Y);Pe=Math.floor(It.width*ut),Ee=Math.floor(It.height*ut),T.isDataArrayTexture?Ie=It.depth:T.isData3DTexture?Ie=Math.floor(It.depth*ut):Ie=1,ke=0,tt=0,dt=0}X!==null?(Be=X.x,pt=X.y,Kt=X.z):(Be=0,pt=0,Kt=0);let Lt=ge.convert(V.format),bn=ge.convert(V.type),Ue;V.isData3DTexture?(qe.setTexture3D(V,0),Ue=O.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(qe.setTexture2DArray(V,0),Ue=O.TEXTURE_2D_ARRAY):(qe.setTexture2D(V,0),Ue=O.TEXTURE_2D),Me.activeTexture(O.TEXTURE0),Me.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,V.flipY),Me.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Me.pixelStorei(O.UNPACK_ALIGNMENT,V.unpackAlignment);let fn=Me.getParameter(O.UNPACK_ROW_LENGTH),_t=Me.getParameter(O.UNPACK_IMAGE_HEIGHT),gs=Me.getParameter(O.UNPACK_SKIP_PIXELS),dn=Me.getParameter(O.UNPACK_SKIP_ROWS),$r=Me.getParameter(O.UNPACK_SKIP_IMAGES);Me.pixelStorei(O.UNPACK_ROW_LENGTH,It.width),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,It.height),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,ke),Me.pixelStorei(O.UNPACK_SKIP_ROWS,tt),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,dt);let ji=T.isDataArrayTexture||T.isData3DTexture,_s=V.isDataArrayTexture||V.isData3DTexture;if(T.isDepthTexture){let ut=ze.get(T),nn=ze.get(V),Wn=ze.get(ut.__renderTarget),Dt=ze.get(nn.__renderTarget);Me.bindFramebuffer(O.READ_FRAMEBUFFER,Wn.__webglFramebuffer),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let pn=0;pn<Ie;pn++)ji&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ze.get(T).__webglTexture,Y,dt+pn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ze.get(V).__webglTexture,Te,Kt+pn)),O.blitFramebuffer(ke,tt,ke+Pe,tt+Ee,Be,pt,Be+Pe,pt+Ee,O.DEPTH_BUFFER_BIT,O.NEAREST);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(Y!==0||T.isRenderTargetTexture||ze.has(T)){let ut=ze.get(T),nn=ze.get(V);Me.bindFramebuffer(O.READ_FRAMEBUFFER,U),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let Wn=0;Wn<Ie;Wn++)ji?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ut.__webglTexture,Y,dt+Wn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ut.__webglTexture,Y),_s?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,nn.__webglTexture,Te,Kt+Wn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,nn.__webglTexture,Te),Y!==0?O.blitFramebuffer(ke,tt,ke+Pe,tt+Ee,Be,pt,Be+Pe,pt+Ee,O.COLOR_BUFFER_BIT,O.NEAREST):_s?O.copyTexSubImage3D(Ue,Te,Be,pt,Kt+Wn,ke,tt,Pe,Ee):O.copyTexSubImage2D(Ue,Te,Be,pt,ke,tt,Pe,Ee);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else _s?T.isDataTexture||T.isData3DTexture?O.texSubImage3D(Ue,Te,Be,pt,Kt,Pe,Ee,Ie,Lt,bn,It.data):V.isCompressedArrayTexture?O.compressedTexSubImage3D(Ue,Te,Be,pt,Kt,Pe,Ee,Ie,Lt,It.data):O.texSubImage3D(Ue,Te,Be,pt,Kt,Pe,Ee,Ie,Lt,bn,It):T.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Pe,Ee,Lt,bn,It.data):T.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Te,Be,pt,It.width,It.height,Lt,It.data):O.texSubImage2D(O.TEXTURE_2D,Te,Be,pt,Pe,Ee,Lt,bn,It);Me.pixelStorei(O.UNPACK_ROW_LENGTH,fn),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,_t),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,gs),Me.pixelStorei(O.UNPACK_SKIP_ROWS,dn),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,$r),Te===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&O.generateMipmap(Ue),Me.unbindTexture()},this.initRenderTarget=function(T){ze.get(T).__webglFramebuffer===void 0&&qe.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?qe.setTextureCube(T,0):T.isData3DTexture?qe.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?qe.setTexture2DArray(T,0):qe.setTexture2D(T,0),Me.unbindTexture()},this.resetState=function(){$=0,G=0,le=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=yt._getDrawingBufferColorSpace(e),t.unpackColorSpace=yt._getUnpackColorSpace()}};var lv={type:"change"},np={type:"start"},uv={type:"end"},rh=new Fr,cv=new _i,TA=Math.cos(70*zd.DEG2RAD),An=new Z,si=2*Math.PI,At={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},tp=1e-6,oh=class extends nl{constructor(e,t=null){super(e,t),this.state=At.NONE,this.target=new Z,this.cursor=new Z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:ur.ROTATE,MIDDLE:ur.DOLLY,RIGHT:ur.PAN},this.touches={ONE:hr.ROTATE,TWO:hr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Z,this._lastQuaternion=new vi,this._lastTargetPosition=new Z,this._quat=new vi().setFromUnitVectors(e.up,new Z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ko,this._sphericalDelta=new Ko,this._scale=1,this._panOffset=new Z,this._rotateStart=new it,this._rotateEnd=new it,this._rotateDelta=new it,this._panStart=new it,this._panEnd=new it,this._panDelta=new it,this._dollyStart=new it,this._dollyEnd=new it,this._dollyDelta=new it,this._dollyDirection=new Z,this._mouse=new it,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=AA.bind(this),this._onPointerDown=EA.bind(this),this._onPointerUp=CA.bind(this),this._onContextMenu=UA.bind(this),this._onMouseWheel=IA.bind(this),this._onKeyDown=LA.bind(this),this._onTouchStart=DA.bind(this),this._onTouchMove=NA.bind(this),this._onMouseDown=RA.bind(this),this._onMouseMove=PA.bind(this),this._interceptControlDown=FA.bind(this),this._interceptControlUp=OA.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=At.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(lv),this.update(),this.state=At.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;An.copy(t).sub(this.target),An.applyQuaternion(this._quat),this._spherical.setFromVector3(An),this.autoRotate&&this.state===At.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=si:i>Math.PI&&(i-=si),s<-Math.PI?s+=si:s>Math.PI&&(s-=si),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(An.setFromSpherical(this._spherical),An.applyQuaternion(this._quatInverse),t.copy(this.target).add(An),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=An.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new Z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new Z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=An.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(rh.origin.copy(this.object.position),rh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(rh.direction))<TA?this.object.lookAt(this.target):(cv.setFromNormalAndCoplanarPoint(this.object.up,this.target),rh.intersectPlane(cv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>tp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>tp||this._lastTargetPosition.distanceToSquared(this.target)>tp?(this.dispatchEvent(lv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?si/60*this.autoRotateSpeed*e:si/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){An.setFromMatrixColumn(t,0),An.multiplyScalar(-e),this._panOffset.add(An)}_panUp(e,t){this.screenSpacePanning===!0?An.setFromMatrixColumn(t,1):(An.setFromMatrixColumn(t,0),An.crossVectors(this.object.up,An)),An.multiplyScalar(e),this._panOffset.add(An)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;An.copy(s).sub(this.target);let r=An.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(si*this._rotateDelta.x/t.clientHeight),this._rotateUp(si*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-si*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(si*this._rotateDelta.x/t.clientHeight),this._rotateUp(si*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new it,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function EA(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function AA(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function CA(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(uv),this.state=At.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function RA(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case ur.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=At.DOLLY;break;case ur.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=At.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=At.ROTATE}break;case ur.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=At.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=At.PAN}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(np)}function PA(n){switch(this.state){case At.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case At.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case At.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function IA(n){this.enabled===!1||this.enableZoom===!1||this.state!==At.NONE||(n.preventDefault(),this.dispatchEvent(np),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(uv))}function LA(n){this.enabled!==!1&&this._handleKeyDown(n)}function DA(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case hr.ROTATE:if(this.enableRotate===!1){this.state=At.NONE;break}this._handleTouchStartRotate(n),this.state=At.TOUCH_ROTATE;break;case hr.PAN:if(this.enablePan===!1){this.state=At.NONE;break}this._handleTouchStartPan(n),this.state=At.TOUCH_PAN;break;default:this.state=At.NONE}break;case 2:switch(this.touches.TWO){case hr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=At.TOUCH_DOLLY_PAN;break;case hr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=At.TOUCH_DOLLY_ROTATE;break;default:this.state=At.NONE}break;default:this.state=At.NONE}this.state!==At.NONE&&this.dispatchEvent(np)}function NA(n){switch(this._trackPointer(n),this.state){case At.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case At.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case At.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case At.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=At.NONE}}function UA(n){this.enabled!==!1&&n.preventDefault()}function FA(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function OA(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var hv=[[1,0],[0,1]],BA=`
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
}`,kA=`
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`,zA=`
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`,VA={oblique:[.45,-.8,.45],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},ah=class{constructor(e,t,i){this.data=e;this.canvas=t;this.renderer=new nh({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),this.vectors=e.header.extra.lattice_vectors,this.period=Math.hypot(...this.vectors[0]);let s=Float32Array.from(e.values("skin_position"),u=>u/this.period),r={position:new Jn(s,3),real:new Jn(new Float32Array(s.length),3),imag:new Jn(new Float32Array(s.length),3)};for(let u of[this.surface,this.edges])for(let[f,h]of Object.entries(r))u.setAttribute(f,h);this.surface.setIndex(HA(e.values("skin_face"))),this.edges.setIndex(Array.from(e.values("skin_edge"))),this.box.setFromBufferAttribute(r.position),this.box.getCenter(this.uniforms.middle.value);let o=new Or(Uint8Array.from(i.flatMap(([u=0,f=0,h=0])=>[u,f,h,255])),i.length,1);o.minFilter=o.magFilter=On,o.needsUpdate=!0,this.uniforms.scale.value=o;let a={uniforms:this.uniforms,vertexShader:BA},l=new Li(this.surface,new bi({...a,fragmentShader:kA,side:Di,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),c=new Za(this.edges,new bi({...a,fragmentShader:zA}));for(let u of[l,c])u.frustumCulled=!1,this.scene.add(u);this.camera.up.set(0,0,1),this.controls=new oh(this.camera,t),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.colourLines()}data;canvas;renderer;scene=new Xa;camera=new Kn(28,1,.01,100);controls;uniforms={phase:{value:new it(1,0)},swing:{value:.15},turned:{value:new et},middle:{value:new Z},scale:{value:new Or(new Uint8Array(4),1,1)},ink:{value:new xt(0,0,0)}};surface=new $o;edges=new $o;period;vectors;box=new cs;copies=[1,1];kappa=[0,0];frames=0;turns=[];show({of:e,row:t,band:i,kappa:s,turn:r,isReversed:o}){let[,a=0,l=0]=this.data.shape(`${e}_mode_real`),c=(t*a+i)*l,u=this.data.values("path_shape");for(let y of["real","imag"]){let g=`${e}_mode_${y}`,m=this.data.values(g).subarray(c,c+l),A=(o&&y==="imag"?-1:1)*this.data.scale(g)*this.data.scale("path_shape"),S=this.surface.getAttribute(y);GA(S.array,u,m,A),S.needsUpdate=!0}let[[f,h],[d,p]]=r;this.uniforms.turned.value.set(f,h,0,d,p,0,0,0,1),this.kappa=s,this.place()}repeat(e){this.copies=e,this.place(),this.look("oblique")}set swing(e){this.uniforms.swing.value=e}turn(e){this.uniforms.phase.value.set(Math.cos(2*Math.PI*e),Math.sin(2*Math.PI*e)),this.draw()}draw(){this.frames++,this.renderer.render(this.scene,this.camera)}look(e){let[t,i]=this.copies,s=this.box.clone();for(let[c,u]of[[t-1,0],[0,i-1],[t-1,i-1]])s.union(this.box.clone().translate(this.shift(c,u)));let r=s.getBoundingSphere(new Rs),o=this.camera.fov*Math.PI/360,a=Math.atan(Math.tan(o)*Math.min(1,this.camera.aspect)),l=1.08*r.radius/Math.sin(a);this.controls.target.copy(r.center),this.camera.position.set(...VA[e]).normalize().multiplyScalar(l).add(r.center),this.camera.near=.01*l,this.camera.far=10*l,this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}resize(e,t){this.renderer.setPixelRatio(devicePixelRatio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix()}colourLines(){this.uniforms.ink.value.set(Qe("ink"))}dispose(){this.controls.dispose(),this.surface.dispose(),this.edges.dispose(),this.uniforms.scale.value.dispose(),this.renderer.dispose()}shift(e,t){let[[i,s],[r,o]]=this.vectors;return new Z((e*i+t*r)/this.period,(e*s+t*o)/this.period,0)}place(){let[e,t]=this.copies,i=[],s=[];for(let r=0;r<e;r++)for(let o=0;o<t;o++){let a=r*this.kappa[0]+o*this.kappa[1];i.push(...this.shift(r,o).toArray()),s.push(Math.cos(a),Math.sin(a))}this.turns=s;for(let r of[this.surface,this.edges])r.instanceCount=e*t,r.setAttribute("origin",new Xo(Float32Array.from(i),3)),r.setAttribute("turn",new Xo(Float32Array.from(s),2))}};function GA(n,e,t,i){n.fill(0);for(let s=0;s<t.length;s++){let r=(t[s]??0)*i;if(r===0)continue;let o=s*n.length;for(let a=0;a<n.length;a++)n[a]+=r*e[o+a]}}function HA(n){let e=[];for(let t=0;t<n.length;t+=4){let[i,s,r,o]=n.subarray(t,t+4);e.push(i,s,r,i,r,o)}return e}var WA=[["oblique","oblique"],["x","along x"],["y","along y"],["z","from above"]];function lh({data:n,choice:e,motion:t,name:i}){let s=Nt(null),r=Nt(null),[o,a]=Hs("");return Dn(()=>{if(s.current===null)return;let l;try{l=new ah(n,s.current,fv(n))}catch{a("The mode cannot be drawn, because this browser has no WebGL.");return}return r.current=l,Object.assign(s.current,{moving:l}),XA(l,t,e)},[n,e,t]),_("div",{class:"mode",children:[o?_("p",{role:"alert",children:o}):_("canvas",{ref:s,role:"img","aria-label":"The cell moving in the selected mode"}),_("p",{class:"scale",children:[_("span",{children:"0"}),_("span",{class:"bar",style:{background:qA(n)}}),_("span",{children:"1"})," displacement, relative to the largest"]}),_("p",{class:"sides",children:[_("span",{id:`seen-${i}`,children:"Seen"}),WA.map(([l,c])=>_("button",{type:"button",onClick:()=>r.current?.look(l),"aria-describedby":`seen-${i}`,children:c}))]}),_(Eo,{canvas:s,name:i,caption:`${n.header.title}, ${Mr(n)}`})]})}function fv(n){return n.header.extra.colours}function qA(n){return`linear-gradient(to right, ${fv(n).map(e=>`rgb(${e.join(" ")})`).join(", ")})`}function XA(n,e,t){let{canvas:i}=n,s=()=>n.turn(r.moment),r=new Js(t,s,i);To(i,l=>r.at(l));let o=new ResizeObserver(()=>{n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1)),n.look("oblique")});n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1));let a=[Ct(()=>n.repeat(t.copies.value)),Ct(()=>{n.show(e.value),i.dataset.shown=`${e.value.row},${e.value.band}`,s()}),Ct(()=>{n.swing=t.swing.value,s()}),ti(()=>{n.colourLines(),n.draw()})];return o.observe(i),()=>{r.end(),o.disconnect();for(let l of a)l();n.dispose()}}function dv({diagram:n,unit:e}){let{factor:t}=e;return n.gaps.length===0?_("p",{children:"The computed bands have no gap."}):_("div",{class:"wide",children:_("table",{children:[_("caption",{children:"Gaps"}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"bands"}),_("th",{scope:"col",children:"where"}),_("th",{scope:"col",children:on("lower",e)}),_("th",{scope:"col",children:on("upper",e)})]})}),_("tbody",{children:n.gaps.map(i=>_("tr",{children:[_("td",{children:[i.waves==="all"?"":`${i.waves} `,i.below,"-",i.below+1]}),_("td",{children:i.complete?"everywhere (complete)":i.waves==="all"?`${i.direction} only`:"everywhere, these waves only"}),_("td",{children:kn(i.lower/t,i.lowerError/t)}),_("td",{children:kn(i.upper/t,i.upperError/t)})]}))})]})})}function pv({diagram:n,choice:e}){let{row:t,band:i}=e.point.value,s=e.unit.value,{factor:r}=s,o=Array.from({length:n.bands},(a,l)=>({row:t,band:l}));return _("div",{class:"wide",children:_("table",{children:[_("caption",{children:["Modes at ",n.place(t)]}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"band"}),_("th",{scope:"col",children:on("frequency",s)}),_("th",{scope:"col",children:"motion"}),_("th",{scope:"col",children:"symmetry"}),_("th",{scope:"col",children:"show"})]})}),_("tbody",{children:o.map(a=>_("tr",{"aria-current":a.band===i?"true":void 0,children:[_("td",{children:a.band+1}),_("td",{children:kn(n.at(a)/r,n.errorAt(a)/r)}),_("td",{children:n.nature(a)}),_("td",{children:n.parity(a)}),_("td",{children:_("button",{type:"button",onClick:()=>e.point.value=a,children:["band ",a.band+1]})})]}))})]})})}var YA=[1,2,5,10],$A=.7,ch=class{constructor(e){this.data=e;this.places=e.values("zone_wavevector"),this.samples=e.values("zone_sample"),this.frequency=e.values("zone_frequency"),this.error=e.values("zone_error"),[,this.bands=0]=e.shape("zone_frequency");let t=Array.from(e.values("zone_mesh"));this.triangles=Array.from({length:t.length/3},(i,s)=>t.slice(3*s,3*s+3)),this.corners=e.header.extra.zone,this.colours=e.header.extra.colours,this.reach=Math.max(...Array.from(this.places,Math.abs))}data;bands;triangles;corners;colours;reach;places;samples;frequency;error;wavevector(e){return[this.places[2*e]??NaN,this.places[2*e+1]??NaN]}sample(e){return this.samples[e]??0}phases(e){let t=this.data.values("zone_kappa");return[t[2*e]??NaN,t[2*e+1]??NaN]}at(e,t){return this.frequency[e*this.bands+t]??NaN}errorAt(e,t){return this.error[e*this.bands+t]??NaN}get hasModes(){return this.data.has("zone_mode_real")}motion(e,t){let[i,s]=this.turned(e),[r,o]=this.wavevector(e),a=this.data.header.extra.lattice_vectors,[l,c]=a.map(([u,f])=>r*u+o*f);return{of:"zone",row:this.sample(e),band:t,kappa:[l??0,c??0],turn:i,isReversed:s}}velocity(e,t){let i=2*(this.sample(e)*this.bands+t),[s,r]=[this.data.values("zone_velocity")[i]??NaN,this.data.values("zone_velocity")[i+1]??NaN],[[[o,a],[l,c]],u]=this.turned(e),f=u?-1:1;return Number.isFinite(s)&&Number.isFinite(r)?[f*(o*s+a*r),f*(l*s+c*r)]:void 0}described(e,t){let i=this.sample(e),s=o=>this.data.values(o)[i*this.bands+t];return{motion:s("zone_character"),symmetry:Pf(s("zone_parity"),"the mirror of the wavevector",s("zone_middle_parity"))}}turned(e){let t=Math.floor(e/this.count),i=this.data.header.extra.zone_turns[t];if(i===void 0)throw new Error(`the zone has no copy ${t}`);return[i,this.data.header.extra.zone_signs[t]===-1]}mean(e,t){return e.reduce((i,s)=>i+this.at(this.sample(s),t),0)/3}range(e){let t=Array.from({length:this.frequency.length/this.bands},(i,s)=>this.at(s,e));return[Math.min(...t),Math.max(...t)]}get count(){return this.frequency.length/this.bands}highest(e){return this.all.reduce((t,i)=>this.at(this.sample(i),e)>this.at(this.sample(t),e)?i:t,0)}nearest([e,t]){let i=s=>Math.hypot(this.wavevector(s)[0]-e,this.wavevector(s)[1]-t);return this.all.reduce((s,r)=>i(r)<i(s)?r:s,0)}next(e,t,i){let[s,r]=this.wavevector(e),[o,a]=[e,1/0];for(let l of this.all){let[c,u]=[this.wavevector(l)[0]-s,this.wavevector(l)[1]-r],f=Math.hypot(c,u),h=(c*t+u*i)/f;f>1e-9*this.reach&&h>$A&&f/h**2<a&&([o,a]=[l,f/h**2])}return o}contour(e,t){let i=[];for(let s of this.triangles){let r=[];s.forEach((o,a)=>{let l=s[(a+1)%3]??0,[c,u]=[this.at(this.sample(o),e),this.at(this.sample(l),e)];if(c<t==u<t)return;let f=(t-c)/(u-c),[h,d]=[this.wavevector(o),this.wavevector(l)];r.push([h[0]+f*(d[0]-h[0]),h[1]+f*(d[1]-h[1])])}),r[0]&&r[1]&&i.push([r[0],r[1]])}return i}get all(){return Array.from(this.samples,(e,t)=>t)}};function ip(n,e,t){if(!(e>n))return[];let i=10**Math.floor(Math.log10((e-n)/t)),s=i*(YA.find(o=>o*i*t>=e-n)??10),r=Math.ceil(n/s);return Array.from({length:Math.floor(e/s)-r+1},(o,a)=>(r+a)*s)}var mv=440,ZA=26,gv=8,uh=34,_v=1;function vv({diagram:n,choice:e}){return n.data.has("zone_wavevector")?_(KA,{diagram:n,choice:e}):null}function KA({diagram:n,choice:e}){let t=je(()=>new ch(n.data),[n]),i=je(()=>Bl(Number(n.data.header.attrs.pitch_m)),[n]),s=je(()=>({image:$e(t.highest(e.point.peek().band)),wavevectorUnit:$e(i[1])}),[t,i,e]),r=je(()=>JA(n,t,s,e),[n,t,s,e]),o=je(()=>Qn(()=>t.motion(s.image.value,e.point.value.band)),[t,s,e]),{band:a}=e.point.value;return _("section",{"aria-label":"Brillouin zone",class:"pair",children:[_("div",{children:[_(ei,{label:"Brillouin zone. Arrow keys move the wavevector, page keys change the band.",describedBy:"zone-point",onKeyDown:l=>{Ol(l,r),l.defaultPrevented&&l.stopPropagation()},children:_(jA,{zone:t,band:a,own:s})}),_("p",{class:"axes",children:[_("label",{children:["Band"," ",_("select",{value:a+1,onChange:({currentTarget:l})=>e.point.value={...e.point.value,band:l.selectedIndex},children:Array.from({length:n.bands},(l,c)=>_("option",{children:c+1}))})]}),_(Bi,{title:"Wavevectors in",units:i,unit:s.wavevectorUnit})]}),_(nC,{zone:t,diagram:n,band:a,unit:e.unit.value}),_(iC,{diagram:n,zone:t,own:s,choice:e})]}),t.hasModes&&_("div",{children:[_(lh,{data:n.data,choice:e,motion:o,name:"zone-mode"}),_("p",{class:"sides",children:_(Ws,{playing:e.playing})})]})]})}function JA(n,e,t,i){let s=o=>()=>i.point.value=sc(n,i.point.value,0,o),r=(o,a)=>()=>t.image.value=e.next(t.image.value,o,a);return[{keys:"arrows",effect:"next wavevector",actions:{ArrowLeft:r(-1,0),ArrowRight:r(1,0),ArrowUp:r(0,1),ArrowDown:r(0,-1)}},{keys:"page up, page down",effect:"next higher or lower band",actions:{PageUp:s(1),PageDown:s(-1)}}]}function jA({zone:n,band:e,own:t}){let i=Nt(null),s=t.image.value,r=()=>{i.current!==null&&QA(i.current,n,e,s)};Oi(r),Dn(()=>{let a=i.current?.parentElement;if(!a)return;let l=new ResizeObserver(()=>o.current());l.observe(a);let c=ti(()=>o.current());return()=>{l.disconnect(),c()}},[]);let o=Nt(r);return o.current=r,_("div",{class:"map zone",children:_("canvas",{ref:i,role:"img","aria-label":`Frequency of band ${e+1} over the zone`,onClick:({offsetX:a,offsetY:l,currentTarget:c})=>{let{toWavevector:u}=yv(c,n);t.image.value=n.nearest(u(a,l))}})})}function yv(n,e){let t=n.clientWidth,i=(t-2*ZA)/(2*e.reach);return{toPixel:([s,r])=>[t/2+i*s,t/2-i*r],toWavevector:(s,r)=>[(s-t/2)/i,(t/2-r)/i]}}function QA(n,e,t,i){let s=Math.min(n.parentElement?.clientWidth??mv,mv);n.style.width=n.style.height=`${s}px`,n.width=n.height=Math.round(s*devicePixelRatio);let r=n.getContext("2d");if(r===null)return;r.scale(devicePixelRatio,devicePixelRatio);let{toPixel:o}=yv(n,e),[a,l]=e.range(t);for(let u of e.triangles){let f=e.colours[Math.round((e.mean(u,t)-a)/(l-a||1)*(e.colours.length-1))];r.fillStyle=r.strokeStyle=`rgb(${(f??[]).join(" ")})`,r.beginPath();for(let h of u)r.lineTo(...o(e.wavevector(h)));r.closePath(),r.fill(),r.stroke()}r.strokeStyle="#ffffff",r.lineWidth=1,r.beginPath();for(let u of ip(a,l,gv))for(let[f,h]of e.contour(t,u))r.moveTo(...o(f)),r.lineTo(...o(h));r.stroke(),tC(r,e,o);let c=e.hasModes?e.velocity(i,t):void 0;c!==void 0&&eC(r,o(e.wavevector(i)),c),r.beginPath(),r.arc(...o(e.wavevector(i)),5,0,2*Math.PI),r.fillStyle=Qe("accent"),r.strokeStyle="#ffffff",r.lineWidth=2,r.fill(),r.stroke(),n.dataset.shown=`${i},${t}`,Object.assign(n,{zone:e})}function eC(n,[e,t],[i,s]){let r=Math.hypot(i,s);if(!(r>_v))return;let[o,a]=[i/r,-s/r],l=(c,u)=>[e+c*o-u*a,t+c*a+u*o];for(let[c,u]of[["#ffffff",5],[Qe("accent"),2.5]])n.strokeStyle=c,n.lineWidth=u,n.beginPath(),n.moveTo(e,t),n.lineTo(...l(uh,0)),n.moveTo(...l(uh-8,5)),n.lineTo(...l(uh,0)),n.lineTo(...l(uh-8,-5)),n.stroke()}function tC(n,e,t){n.strokeStyle=Qe("carrier"),n.setLineDash([5,4]),n.lineWidth=1.5,n.beginPath();for(let r of Object.values(e.corners))n.lineTo(...t(r));n.closePath(),n.stroke(),n.setLineDash([]),n.font="15px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.lineWidth=3,n.strokeStyle=Qe("paper"),n.fillStyle=Qe("ink");let i=Object.values(e.corners),s=[0,1].map(r=>i.reduce((o,a)=>o+(a[r]??0),0)/i.length);for(let[r,o]of Object.entries(e.corners)){let[a,l]=t(o),[c,u]=[Math.sign(o[0]-(s[0]??0)),Math.sign(o[1]-(s[1]??0))];n.strokeText(r,a+13*c,l-13*u),n.fillText(r,a+13*c,l-13*u)}}function nC({zone:n,diagram:e,band:t,unit:i}){let[s,r]=n.range(t).map(u=>rs(Number((u/i.factor).toPrecision(4)))),a=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(u=>`rgb(${(n.colours[u]??[]).join(" ")})`),l=ip(...n.range(t),gv),c=((l[1]??0)-(l[0]??0))/i.factor;return _("p",{class:"scale",children:[_("span",{children:s}),_("span",{class:"bar",style:{background:`linear-gradient(to right, ${a.join(", ")})`}}),_("span",{children:r})," ",on("frequency",i)," of band ",t+1," of ",e.bands,l.length>1&&`; contours every ${Number(c.toPrecision(4))}`]})}function iC({diagram:n,zone:e,own:t,choice:i}){let[s,r,o]=[t.image.value,t.wavevectorUnit.value,i.unit.value],{band:a}=i.point.value,[l,c]=e.wavevector(s).map(p=>Number((p/r.factor).toFixed(3))),u=e.sample(s),f=p=>kn(e.at(u,p)/o.factor,e.errorAt(u,p)/o.factor),[h,d]=e.phases(u).map(p=>Number((p/Math.PI).toFixed(4)));return _("div",{class:"facts",children:[_("p",{id:"zone-point","aria-live":"polite",children:["Band ",a+1," at (",l,", ",c,") ",r.name,": ",_("b",{children:$n(f(a),o)})]}),e.hasModes&&_(gn,{children:[_(qs,{facts:sC(n,e,s,a)}),_("p",{class:"again",children:["The arrow in the zone is the direction of the group velocity. Bands and modes are computed at ",e.count," ","wavevectors of the irreducible zone; a click selects the nearest one or its image."]})]}),_("details",{children:[_("summary",{children:"Frequencies of all bands at this wavevector"}),_("div",{class:"wide",children:_("table",{children:[_("caption",{children:"Frequencies at this wavevector"}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"band"}),_("th",{scope:"col",children:on("frequency",o)})]})}),_("tbody",{children:Array.from({length:e.bands},(p,y)=>_("tr",{"aria-current":y===a?"true":void 0,children:[_("td",{children:y+1}),_("td",{children:f(y)})]}))})]})})]}),_("p",{class:"again",children:["Its modes as a picture: ",_("code",{children:['haptonic bands STUDY --modes-at "',h,", ",d,'"']})]})]})}function sC(n,e,t,i){let[{motion:s,symmetry:r},o]=[e.described(t,i),e.velocity(t,i)];return[["motion",n.motion(s)],["symmetry",r],["group velocity",o?rC(o):"not defined"]]}function rC([n,e]){let t=Math.hypot(n,e);return t<_v?"0 m/s":`${t.toPrecision(3)} m/s at ${(Math.atan2(e,n)*180/Math.PI).toFixed(0)}° from x`}function bv(n,e){return _(aC,{data:n,host:e})}var oC="Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of the model.";function aC({data:n,host:e}){let t=je(()=>new tc(n),[n]),i=je(()=>$g(t),[t.rows,t.bands]),s=je(()=>lC(t,i),[t,i]),r=je(()=>jg(e?.turned),[e]),o=()=>{let y=r.layer.peek()??Qg(t);i.held.value!==null?i.held.value=null:!y.isPreview&&!r.isWaiting.peek()&&(i.held.value={layer:y,gaps:y.gaps,carrier:t.carrier,design:e?.design()??{}})},a=je(()=>Jg(t,i,e&&o),[t,i,e]),l=r.layer.value,c=r.isWaiting.value?"earlier design":l?.isPreview?"preview":"certified",u=r.isWaiting.value||l!==null,f=i.held.value,{carrier:h}=t,d=t.units.find(({name:y})=>y===i.unit.value.name)??i.unit.value,p=(l??t).gaps;return _(ui,{name:"bands",data:n,keys:a,foot:oC,isOld:u,children:[_("div",{class:"insight",children:[e?.controls,_("span",{class:`kind ${c}`,children:c}),e&&_("button",{type:"button",class:"minor","aria-label":"Hold this design","aria-pressed":f!==null,disabled:c!=="certified"&&f===null,onClick:o,children:"Hold"}),c==="earlier design"?_("p",{children:[e?.turned.value?.data?"Too far for a preview.":"No preview yet."," Certified curves follow."]}):_(Xg,{gaps:p,carrier:h,unit:d})]}),_("div",{class:"pair",children:[_("section",{"aria-label":"Band diagram",children:[_(ei,{label:"Band diagram. Arrow keys move along the path and between bands.",children:_(Vg,{diagram:t,choice:i,newer:r})}),_("p",{class:"axes",children:[_(Bi,{title:"Frequencies in",units:t.units,unit:i.unit}),_(cC,{diagram:t,isPreview:c==="preview",isHeld:f!==null})]}),f!==null&&e&&c!=="earlier design"&&_(Yg,{held:f,now:{gaps:p,carrier:h,design:e.design()},unit:d,isPreview:c==="preview",drop:o})]}),_("section",{"aria-label":"Mode",children:[_(lh,{data:n,choice:i,motion:s,name:"mode"}),_(uC,{diagram:t,choice:i,isOld:u}),_(hC,{choice:i})]})]}),_(vv,{diagram:t,choice:i}),_(Ai,{listing:i.listing,keys:a,children:[_(dv,{diagram:t,unit:i.unit.value}),_(pv,{diagram:t,choice:i})]})]})}function lC(n,e){return Qn(()=>{let{row:t,band:i}=e.point.value;return{of:"path",row:t,band:i,kappa:n.phases(t),turn:hv,isReversed:!1}})}function cC({diagram:n,isPreview:e,isHeld:t}){return _("span",{class:"legend",children:[n.gaps.some(i=>i.complete)&&_("span",{class:"of-gap",children:"complete gap"}),n.gaps.some(i=>i.waves!=="all")&&_("span",{class:"of-parity",children:"gap of one parity"}),n.carrier!==void 0&&_("span",{class:"of-carrier",children:"carrier"}),e&&_("span",{class:"of-preview",children:"preview with its error"}),t&&_("span",{class:"of-held",children:"held design"})]})}function uC({diagram:n,choice:e,isOld:t}){let i=e.point.value,s=e.unit.value,r=n.velocity(i),o=[["motion",n.nature(i)],["symmetry",n.parity(i)],["group velocity",r?`${Math.hypot(...r).toPrecision(3)} m/s`:"not defined"]],a=n.place(i.row);return _("div",{class:"facts",children:[_("p",{id:"point","aria-live":"polite",children:["Band ",i.band+1," at ",a,t&&", earlier design",": ",_("b",{children:$n(kn(n.at(i)/s.factor,n.errorAt(i)/s.factor),s)})]}),_(qs,{facts:o}),_("p",{class:"again",children:["The same mode as a picture: ",_("code",{children:['haptonic bands STUDY --modes-at "',a,'"']})," or, in Python,"," ",_("code",{children:['study.bands(modes_at="',a,'").plot("modes")']})]})]})}function hC({choice:n}){let[e,t]=n.copies.value;return _("div",{class:"controls",children:[_(Ws,{playing:n.playing}),_("label",{children:["largest displacement, share of the period: ",n.swing.value.toFixed(2),_("input",{type:"range",min:"0",max:ic,step:"0.01",value:n.swing.value,onInput:i=>n.swing.value=Number(i.currentTarget.value)})]}),_(oo,{pace:n.pace}),_("label",{children:["cells along a1",_("input",{type:"number",min:"1",max:nc,value:e,onChange:i=>n.copies.value=[xv(i.currentTarget.value),t]})]}),_("label",{children:["cells along a2",_("input",{type:"number",min:"1",max:nc,value:t,onChange:i=>n.copies.value=[e,xv(i.currentTarget.value)]})]})]})}function xv(n){let e=Math.round(Number(n));return Number.isFinite(e)?Math.min(Math.max(e,1),nc):1}var fC=250,Sv=1e6,dC=["low","high","value"];function Mv({data:n,finger:e}){let t=Nt(null);return Oi(()=>{if(t.current!==null)return pC(t.current,n,e)},[n,e]),_(gn,{children:[_("div",{class:"curves",ref:t}),_("p",{class:"legend",children:[_("span",{class:"of-curve",children:[_("svg",{width:"34",height:"8","aria-hidden":"true",children:_("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:"var(--curve-0)"})})," ","model"]}),_("span",{class:"of-gap",children:"its interval"}),_("span",{class:"of-carrier",children:"people notice less than this"})]})]})}function pC(n,e,t){let i=Array.from(e.amplitudes,c=>c*Sv),s=()=>[i,...dC.map(c=>Array.from(t.law.value[c]))],r={stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")},grid:{show:!1},font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},o=()=>({width:$s(n),height:fC}),a={width:0,points:{show:!1}},l=new Jt({...o(),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,distr:3},y:{range:[0,1.02]}},bands:[{series:[2,1],fill:()=>Qe("gap")}],axes:[{...r,label:`${e.data.title("table")} / µm`,labelSize:22,size:34,values:(c,u)=>u.map(f=>Number.isInteger(Math.round(1e6*Math.log10(f))/1e6)?String(f):"")},{...r,label:e.data.title("load_sharing"),labelSize:24,size:50}],series:[{},a,a,{stroke:()=>Qe("curve-0"),width:2,points:{show:!1}}],hooks:{draw:[c=>mC(c,e,t)]}},s(),n);return Zs(l,n,o,[Ct(()=>l.setData(s())),Ct(()=>{t.below.value,l.redraw(!1,!1)})])}function mC(n,e,t){let{ctx:i,bbox:s,valToPos:r}=n,{amplitude:o,friction:a}=t.below.peek(),[l,c]=[r(Math.max(o.value*Sv,.001),"x",!0),r(a.value,"y",!0)];yo(n,1-e.extra.weber,"carrier",[7,5]),xo(i,[l,s.top],[l,s.top+s.height],"accent"),i.save(),i.fillStyle=Qe("accent"),i.beginPath(),i.arc(l,c,5*devicePixelRatio,0,2*Math.PI),i.fill(),i.restore()}var wv=["value","low","high"],hh=class{constructor(e){this.data=e;this.extra=e.header.extra,this.forces=e.values("force"),this.speeds=e.values("speed"),this.amplitudes=e.values("table"),this.x=e.values("x"),this.y=e.values("y"),this.columns=[...new Set(this.x)].sort((s,r)=>s-r),this.rows=[...new Set(this.y)].sort((s,r)=>s-r),this.cells=new Int32Array(this.columns.length*this.rows.length).fill(-1);let[t,i]=[this.columns,this.rows].map(s=>new Map(s.map((r,o)=>[r,o])));this.x.forEach((s,r)=>{this.cells[(i?.get(this.y[r]??0)??0)*this.columns.length+(t?.get(s)??0)]=r})}data;extra;forces;speeds;amplitudes;x;y;columns;rows;cells;get count(){return this.x.length}placeIn(e,t){if(t<0||t>=this.columns.length)return null;let i=this.cells[e*this.columns.length+t]??-1;return i<0?null:i}nearest([e,t]){let[i,s]=[0,1/0];for(let r=0;r<this.count;r++){let o=((this.x[r]??0)-e)**2+((this.y[r]??0)-t)**2;o<s&&([i,s]=[r,o])}return i}beside(e,t,i){let[s,r]=[this.rows.indexOf(this.y[e]??0),this.columns.indexOf(this.x[e]??0)];return this.placeIn(s+i,r+t)??e}region(e){return this.data.texts("region")[e]||"a lattice"}amplitude(e,t,i){let s=this.data.texts("load").indexOf(t);return i*(this.data.values("amplitude")[s*this.count+e]??0)}law(e,t){let i=this.amplitudes.length,s=this.data.texts("end"),r=(c,u)=>{let f=this.data.values(c);return h=>{let d=(u*s.length+s.indexOf(h))*i;return f.subarray(d,d+i)}},[o,a]=[r("load_sharing",e),r("intermittent",t)],l=(c,u)=>{let[f,h]=[o(c),a(c)];return Float64Array.from(f,(d,p)=>Number.isNaN(d)?h[p]??NaN:u(d,h[p]??NaN))};return{value:l("value",c=>c),low:l("low",Math.min),high:l("high",Math.max)}}friction(e,t){let[i=1,s=1]=[this.amplitudes[0],this.amplitudes.at(-1)],r=e.length-1,o=Math.log(Math.max(t,i)/i)/Math.log(s/i)*r,a=Math.min(Math.floor(o),r-1),l=Math.min(o-a,1);return(e[a]??NaN)*(1-l)+(e[a+1]??NaN)*l}};function Tv(n,e){return n.low>e?"noticed, also at the lower limit":n.value>e?"probably noticed; the lower limit is below the threshold":n.high>e?"probably not noticed; the upper limit is above the threshold":"not noticed, even at the upper limit"}var ml="#1c2126",Ev={ink:ml,rim:"#ffffff"};function Av(n,e,t,i=()=>!0){n.beginPath();for(let{outline:s,places:r}of e)for(let o of r)i(o)&&sp(n,s.map(([a,l])=>[o[0]+a,o[1]+l]),t)}function Cv(n,e,t){n.save(),n.strokeStyle=Qe("carrier"),n.lineWidth=4*devicePixelRatio;for(let{hold:i,ends:s}of e)n.setLineDash(i==="clamped"?[]:[5*devicePixelRatio,3*devicePixelRatio]),n.beginPath(),sp(n,s,t),n.stroke();n.restore()}function sp(n,e,t){e.forEach((i,s)=>s===0?n.moveTo(...t(i)):n.lineTo(...t(i))),n.closePath()}function pr(n,e,t){n.beginPath(),sp(n,e,t),n.stroke()}function fh([n,e],[t,i]){let[s,r]=[t/2,i/2];return[[n-s,e-r],[n+s,e-r],[n+s,e+r],[n-s,e+r]]}function dh(n,e,t,i,s=Ev){let o=t.flatMap(h=>h.map((d,p)=>[i(d),i(h[(p+1)%h.length]??d)])).filter(([h,d])=>Math.abs(h[1]-d[1])<1),a=Math.min(...o.map(([h])=>h[1])),l=([h,d])=>Math.abs(h[0]-d[0]),[c]=o.filter(([h])=>h[1]<a+1).sort((h,d)=>l(d)-l(h));if(c===void 0)return;let[u,f]=c;gC(n,e,[(u[0]+f[0])/2,a+17*devicePixelRatio],s)}function gC(n,e,[t,i],s=Ev){n.save(),n.font=`${13*devicePixelRatio}px system-ui, sans-serif`,n.textAlign="center",n.lineWidth=3*devicePixelRatio,n.strokeStyle=s.rim,n.fillStyle=s.ink;let r=n.measureText(e).width/2,o=Math.min(Math.max(t,r),n.canvas.width-r);n.strokeText(e,o,i),n.fillText(e,o,i),n.restore()}var mr=class n{constructor(e,t,i,s){this.canvas=e;this.context=t;this.small=i;this.inner=s;this.image=new ImageData(i.width,i.height)}canvas;context;small;inner;image;static on(e,t,i){let s=new OffscreenCanvas(t,i),[r,o]=[e.getContext("2d"),s.getContext("2d")];return r===null||o===null?null:new n(e,r,s,o)}show(e){let{canvas:t,context:i}=this;this.inner.putImageData(this.image,0,0),i.clearRect(0,0,t.width,t.height),i.imageSmoothingEnabled=e,i.imageSmoothingQuality="high",i.drawImage(this.small,0,0,t.width,t.height)}follow(e,t){let{canvas:i}=this,s=()=>{let o=Math.min(i.parentElement?.clientWidth??300,.62*innerHeight/e);i.style.width=`${o}px`,i.style.height=`${o*e}px`,i.width=Math.round(o*devicePixelRatio),i.height=Math.round(o*e*devicePixelRatio),t()},r=new ResizeObserver(s);return i.parentElement!==null&&r.observe(i.parentElement),()=>r.disconnect()}};function Rv({data:n,finger:e}){let t=Nt(null);Dn(()=>{if(t.current!==null)return _C(t.current,n,e)},[n,e]);let{colours:i}=n.extra,s=[0,.25,.5,.75,1].map(r=>`rgb(${(i[Math.round(r*(i.length-1))]??[]).join(" ")})`);return _("div",{class:"map",children:[_("canvas",{ref:t,role:"img","aria-label":"Map of the reduction of friction"}),_("p",{class:"scale",children:[_("span",{children:"0"}),_("span",{class:"bar",style:{background:`linear-gradient(to right, ${s.join(", ")})`}}),_("span",{children:"100 %"})," less friction below a finger with its middle there, model"]})]})}function _C(n,e,t){let[i,s]=[e.columns,e.rows],r=mr.on(n,i.length,s.length);if(r===null)return()=>{};let{image:o,context:a}=r,[l,c]=[i,s].map(p=>vC(p)),u=([p,y])=>[n.width*(p-l[0])/(l[1]-l[0]),n.height*(c[1]-y)/(c[1]-c[0])],f=()=>{let{colours:p}=e.extra,[y,g]=[t.law.peek(),t.drive.peek()];s.forEach((m,b)=>i.forEach((A,S)=>{let P=e.placeIn(b,S),C=4*((s.length-1-b)*i.length+S);if(o.data[C+3]=P===null?0:255,P===null)return;let v=1-e.friction(y.value,e.amplitude(P,"value",g));(p[Math.round(Math.min(Math.max(v,0),1)*(p.length-1))]??[]).forEach((B,N)=>o.data[C+N]=B)}))},h=()=>{r.show(!1),yC(a,e,u),xC(a,e,t.place.peek(),u),n.dataset.shown=String(t.place.peek())},d=[r.follow((c[1]-c[0])/(l[1]-l[0]),h),Ct(()=>{t.law.value,t.drive.value,f(),h()}),Ct(()=>{t.place.value,h()}),ti(h),bC(n,([p,y])=>{let g=[l[0]+p*(l[1]-l[0]),c[1]-y*(c[1]-c[0])];t.place.value=e.nearest(g)})];return()=>{for(let p of d)p()}}function vC(n){let[e=0,t=e+.001]=n,i=(t-e)/2;return[e-i,(n.at(-1)??0)+i]}function yC(n,{extra:e},t){n.lineWidth=1.2*devicePixelRatio,n.strokeStyle="#ffffff";for(let i of Object.values(e.regions).flat())pr(n,i,t);n.strokeStyle=Qe("quiet");for(let i of e.plate)pr(n,i,t);n.strokeStyle="#ffffff",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[i,s,r,o]of Object.values(e.patches))pr(n,fh([i,s],[r,o]),t);n.setLineDash([]);for(let[i,s]of Object.entries(e.regions))dh(n,i,s,t)}function xC(n,e,t,i){let s=[e.x[t]??0,e.y[t]??0],[r,o]=i(s),a=i([s[0]+e.extra.diameter/2,s[1]])[0]-r;for(let[l,c]of[["#ffffff",5],[ml,2]])n.strokeStyle=l,n.lineWidth=c*devicePixelRatio,n.beginPath(),n.arc(r,o,a,0,2*Math.PI),n.moveTo(r-4*devicePixelRatio,o),n.lineTo(r+4*devicePixelRatio,o),n.moveTo(r,o-4*devicePixelRatio),n.lineTo(r,o+4*devicePixelRatio),n.stroke()}function bC(n,e){let t=i=>{if(i.type==="pointerdown")n.setPointerCapture(i.pointerId);else if(i.buttons===0)return;let s=n.getBoundingClientRect();e([(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height])};return n.addEventListener("pointerdown",t),n.addEventListener("pointermove",t),()=>{n.removeEventListener("pointerdown",t),n.removeEventListener("pointermove",t)}}var SC=5,Pv=1.05;function Iv(n){let{drive:e,force:t,speed:i}=n.extra,s=$e(MC(n)),r={drive:$e(e.value),force:$e(n.forces.indexOf(t)),speed:$e(n.speeds.indexOf(i))};r.force.peek()<0&&(r.force.value=0);let o=Qn(()=>n.law(r.force.value,r.speed.value)),a=Qn(()=>wC(n,o.value,s.value,r.drive.value));return{place:s,...r,listing:$e("none"),law:o,below:a}}function MC(n){let e=n.extra.diameter/2,t=(r,o)=>r-e>=(o[0]??0)&&r+e<=(o.at(-1)??0),[i,s]=[0,-1];for(let r=0;r<n.count;r++){let o=n.amplitude(r,"value",1),a=t(n.x[r]??0,n.columns)&&t(n.y[r]??0,n.rows);o>s&&a&&([i,s]=[r,o])}return i}function wC(n,e,t,i){let s=a=>Object.fromEntries(wv.map(l=>[l,a(l)])),r=s(a=>n.amplitude(t,a,i)),o=s(a=>n.friction(e[a],r[a]));return{amplitude:r,free:n.amplitude(t,"free",i),friction:o,reduction:{value:1-o.value,low:1-o.high,high:1-o.low}}}function Lv(n,e){let t=(c,u)=>f=>{for(let h=0;h<(f.shiftKey?SC:1);h++)e.place.value=n.beside(e.place.peek(),c,u)},{low:i,high:s}=n.extra.drive,r=c=>()=>e.drive.value=Math.min(Math.max(e.drive.peek()*c,i),s),o=(c,u,f)=>()=>c.value=Math.min(Math.max(c.peek()+u,0),f-1),[a,l]=[n.forces.length,n.speeds.length];return[{keys:"← → ↑ ↓",effect:"move the finger; five places with Shift",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}},{keys:"+ −",effect:"5 % more or less drive",actions:{"+":r(Pv),"-":r(1/Pv)}},{keys:"f F",effect:"more or less force",actions:{f:o(e.force,1,a),F:o(e.force,-1,a)}},{keys:"s S",effect:"faster or slower",actions:{s:o(e.speed,1,l),S:o(e.speed,-1,l)}},...Ei(e.listing)]}function Dv({plate:n,choice:e}){let t=Nt(null);return Dn(()=>{if(t.current!==null)return EC([...t.current.querySelectorAll("canvas")],n,e)},[n,e]),_("div",{class:n.fields.length>1?"maps":"",ref:t,children:n.fields.map(i=>_(TC,{plate:n,choice:e,field:i},i.title))})}function TC({plate:n,choice:e,field:t}){let i=Nt(null),r=[0,Math.floor(n.colours.length/2),n.colours.length-1].map(l=>`rgb(${(n.colours[l]??[]).join(" ")})`),o=Wr(Nv(n,e,t,e.line.value)),a=t.title||Mr(n.data);return _("div",{class:"map",children:[t.title&&_("h2",{children:t.title}),_("canvas",{ref:i,role:"img","aria-label":`Map of the moving plate${t.title&&`, ${t.title}`}`}),_("p",{class:"scale",children:[_("span",{children:`−${o}`}),_("span",{class:"bar",style:{background:`linear-gradient(to right, ${r.join(", ")})`}}),_("span",{children:o})," normal displacement",n.drive]}),_(Eo,{canvas:i,name:"map",caption:`${n.data.header.title}, ${a}`})]})}function Nv(n,e,t,i){return n.largest(i,e.common.value?n.fields:[t])}function Wr(n){let[e,t]=n>=1e-6?["µm",1e6]:n>=1e-9?["nm",1e9]:["pm",1e12];return`${Number((n*Number(t)).toPrecision(3))} ${e}`}function EC(n,e,t){let{left:i,right:s,bottom:r,top:o}=e.extent,a=e.fields.flatMap((h,d)=>{let p=n[d],y=p===void 0?null:mr.on(p,h.columns,h.rows);return p===void 0||y===null?[]:[{field:h,canvas:p,raster:y,counted:{frames:0}}]}),l=()=>{for(let h of a)c(h)},c=({field:h,canvas:d,raster:p,counted:y})=>{let g=t.line.peek();y.frames++;let m=(e.fields[0]??h).outermost(g)+u.moment;h.paint(p.image,g,m,Nv(e,t,h,g)),p.show(!e.data.has("place"));let b=([A,S])=>[d.width*(A-i)/(s-i),d.height*(o-S)/(o-r)];AC(p.context,e,b,t.plan.peek()),d.dataset.shown=String(g)},u=new Js(t,l,...n);for(let{canvas:h,counted:d}of a)To(h,p=>u.at(p)),Object.assign(h,{counted:d});let f=[...a.map(({raster:h})=>h.follow((o-r)/(s-i),l)),Ct(()=>{t.line.value,t.plan.value,t.common.value,l()}),ti(l)];return()=>{u.end();for(let h of f)h()}}function AC(n,e,t,i){let{plate:s,regions:r,patches:o,features:a,held:l}=e.parts;n.strokeStyle=ml,n.lineWidth=1.2*devicePixelRatio;for(let c of Object.values(r).flat())pr(n,c,t);i&&(n.lineWidth=.8*devicePixelRatio,Av(n,a,t),n.stroke(),Cv(n,l,t)),n.lineWidth=1.2*devicePixelRatio,n.strokeStyle=Qe("quiet");for(let c of s)pr(n,c,t);n.strokeStyle="#855a12",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[c,u,f,h]of Object.values(o))pr(n,fh([c,u],[f,h]),t);n.setLineDash([]);for(let[c,u]of Object.entries(r))dh(n,c,u,t)}var CC="All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, at the nearest computed place.",RC=500;function Ov(n){return _(PC,{dataset:n})}function PC({dataset:n}){let e=je(()=>new hh(n),[n]),t=je(()=>Iv(e),[e]),i=je(()=>Lv(e,t),[e,t]);return _(ui,{name:"finger",data:n,keys:i,foot:CC,children:[_("div",{class:"pair",children:[_("section",{"aria-label":"Map",children:_(ei,{label:"Finger on the plate. Arrow keys move it.",describedBy:"felt",children:_(Rv,{data:e,finger:t})})}),_("section",{"aria-label":"Friction",children:[_(IC,{data:e,finger:t}),_(Mv,{data:e,finger:t}),_(LC,{data:e,finger:t})]})]}),_(Ai,{listing:t.listing,keys:i,children:_(DC,{data:e})})]})}function Ns(n,e){let t=Math.abs(n),[i,s]=t>=1||t===0?["",1]:t>=.001?["m",1e3]:["µ",1e6];return`${Number((n*Number(s)).toPrecision(3))} ${i}${e}`}var Uv=n=>`${(100*n).toFixed(0)} %`;function IC({data:n,finger:e}){let{amplitude:t,free:i,friction:s,reduction:r}=e.below.value,o=e.place.value,{weber:a,frequency:l,drive:c,diameter:u}=n.extra,f=(d,p,[y,g])=>`${p(d.value)} (${p(d[y])} to ${p(d[g])})`,h=d=>d.toFixed(2);return _("div",{class:"facts",children:[_("p",{id:"felt","aria-live":"polite",children:[_("b",{children:n.region(o)}),", x = ",Ns(n.x[o]??0,"m"),", y = ",Ns(n.y[o]??0,"m"),":"," ",_("b",{children:Tv(r,a)})]}),_(qs,{facts:[["mu / mu0, model",f(s,h,["low","high"])],["less friction",f(r,Uv,["low","high"])],["amplitude below the finger",f(t,Wr,["high","low"])],["without a finger",Wr(i)]]}),_("p",{class:"again",children:["People notice reductions above ",Uv(a),". The finger covers ",Ns(u,"m"),";"," ",Number((l/1e3).toFixed(3))," kHz. The same in the study:"," ",_("code",{children:["touch = ","{",' force = "',Ns(n.forces[e.force.value]??0,"N"),'", speed = "',Ns(n.speeds[e.speed.value]??0,"m/s"),'"',c.unit==="V"?`, voltage = "${Ns(e.drive.value,"V")}"`:""," ","}"]})]})]})}function LC({data:n,finger:e}){let{low:t,high:i,title:s,unit:r}=n.extra.drive;return _("div",{class:"controls",children:[_("label",{class:"long",children:["Drive, ",s.toLowerCase(),": ",Ns(e.drive.value,r),_("input",{type:"range",min:t,max:i,step:(i-t)/RC||1,value:e.drive.value,"aria-valuetext":Ns(e.drive.value,r),onInput:o=>e.drive.value=Number(o.currentTarget.value)})]}),_(Fv,{title:n.data.title("force"),unit:"N",values:n.forces,chosen:e.force}),_(Fv,{title:n.data.title("speed"),unit:"m/s",values:n.speeds,chosen:e.speed})]})}function Fv({title:n,unit:e,values:t,chosen:i}){let s=Ns(t[i.value]??0,e);return _("label",{class:"long",children:[n,": ",s,_("input",{type:"range",min:"0",max:t.length-1,step:"1",value:i.value,"aria-valuetext":s,onInput:r=>i.value=Number(r.currentTarget.value)})]})}function DC({data:n}){return _("div",{class:"wide",children:[_("table",{children:[_("caption",{children:"Numbers of the models"}),_("thead",{children:_("tr",{children:["number","value","plausible","origin","source"].map(e=>_("th",{scope:"col",children:e}))})}),_("tbody",{children:n.extra.parameters.map(({title:e,value:t,plausible:i,mark:s,source:r})=>_("tr",{children:[e,t,i,s,r].map(o=>_("td",{children:o}))}))})]}),_("dl",{children:Object.entries(n.extra.models).map(([e,t])=>_("div",{children:[_("dt",{children:["Model of ",e]}),_("dd",{children:t})]}))})]})}var NC="Squares are all participants together, discs are single ones; circles are trials.",[ph,rp,UC,FC]=[24,8,36,16],OC=7.2,Bv=300;function kv(n){return _(BC,{data:n})}function BC({data:n}){let e=je(()=>GC(n),[n]),t=je(()=>[...new Set(e.map(({quantity:l})=>l))],[e]),i=je(()=>({quantity:$e(t[0]??""),row:$e(0),listing:$e("none")}),[t]),s=je(()=>HC(e,t,i),[e,t,i]),r=e.filter(({quantity:l})=>l===i.quantity.value),o=r[i.row.value],a=n.header.extra.sentences??[];return _(ui,{name:"friction",data:n,keys:s,foot:NC,children:[a.length>0&&_("details",{children:[_("summary",{children:"Estimates, tests and assumptions"}),a.map(l=>_("p",{children:l}))]}),_("p",{class:"axes",children:_("label",{children:["Quantity"," ",_("select",{value:i.quantity.value,onChange:l=>{i.quantity.value=l.currentTarget.value,i.row.value=0},children:t.map(l=>_("option",{children:l}))})]})}),_(ei,{label:"Estimates. Arrow keys go from one to the next.",children:_(kC,{estimates:r,choice:i})}),_("div",{class:"facts",children:_("p",{id:"point","aria-live":"polite",children:o!==void 0&&_(gn,{children:[_("b",{children:o.name}),": ",VC(o),o.note&&`; ${o.note}`]})})}),_(Ai,{listing:i.listing,keys:s,children:t.map(l=>_(zC,{title:l,estimates:e.filter(c=>c.quantity===l)}))})]})}function kC({estimates:n,choice:e}){let[t,i]=qC(),s=Math.min(OC*Math.max(...n.map(({name:u})=>u.length),4)+12,.5*i),r=n.flatMap(({value:u,low:f,high:h,trials:d})=>[u,f,h,...d]).filter(Number.isFinite),[o,a]=[Math.min(0,...r),Math.max(...r,.01)],l=u=>s+(u-o)/(a-o)*(i-s-FC),c=rp+ph*n.length;return _("div",{ref:t,children:_("svg",{class:"estimates",width:i,height:c+UC,role:"img","aria-label":`${e.quantity.value}; the table has all numbers`,children:[WC(o,a).map(u=>_(gn,{children:[_("line",{x1:l(u),x2:l(u),y1:rp,y2:c}),_("text",{x:l(u),y:c+16,"text-anchor":"middle",class:"quiet",children:`${u}`.replace("-","−")})]})),_("text",{x:(s+i)/2,y:c+32,"text-anchor":"middle",children:e.quantity.value}),n.map((u,f)=>{let h=rp+ph*(f+.5),{value:d,low:p,high:y,name:g,whole:m,trials:b}=u;return _("g",{class:m?"whole":"",onClick:()=>e.row.value=f,children:[_("rect",{class:e.row.value===f?"chosen":"",x:"1",y:h-ph/2,width:i-2,height:ph,fill:"transparent"}),_("text",{x:s-8,y:h+4,"text-anchor":"end",children:g}),b.map(A=>_("circle",{class:"trial",cx:l(A),cy:h,r:"2.5"})),Number.isFinite(p)&&_("line",{class:"interval",x1:l(p),x2:l(y),y1:h,y2:h}),Number.isFinite(d)&&(m?_("rect",{class:"mark",x:l(d)-5,y:h-5,width:"10",height:"10"}):_("circle",{cx:l(d),cy:h,r:"4.5"}))]})})]})})}function zC({title:n,estimates:e}){return _("div",{class:"wide",tabIndex:0,role:"group","aria-label":n,children:_("table",{children:[_("caption",{children:n}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"of"}),_("th",{scope:"col",children:"value"}),_("th",{scope:"col",children:"from"}),_("th",{scope:"col",children:"to"}),_("th",{scope:"col",children:"note"})]})}),_("tbody",{children:e.map(({name:t,value:i,low:s,high:r,note:o})=>_("tr",{children:[_("td",{children:t}),_("td",{children:sa(i)}),_("td",{children:sa(s)}),_("td",{children:sa(r)}),_("td",{children:o})]}))})]})})}var sa=n=>Number.isFinite(n)?n.toFixed(3).replace("-","−"):"-",VC=({value:n,low:e,high:t})=>sa(n)+(Number.isFinite(e)?`, from ${sa(e)} to ${sa(t)}`:"");function GC(n){let[e,t,i]=["quantity","name","note"].map(c=>n.texts(c)),[s,r,o]=["low","high","whole"].map(c=>n.values(c)),a=n.texts("trial_condition"),l=new Map;return n.values("trial_friction").forEach((c,u)=>{let f=a[u]??"";l.set(f,[...l.get(f)??[],c])}),Array.from(n.values("value"),(c,u)=>({quantity:e?.[u]??"",name:t?.[u]??"",note:i?.[u]??"",value:c,low:s?.[u]??NaN,high:r?.[u]??NaN,whole:o?.[u]===1,trials:(l.get(t?.[u]??"")??[]).filter(Number.isFinite)}))}function HC(n,e,t){let i=()=>n.filter(({quantity:o})=>o===t.quantity.peek()).length-1,s=o=>()=>t.row.value=Math.min(Math.max(t.row.peek()+o,0),i()),r=()=>{let o=e.indexOf(t.quantity.peek());t.quantity.value=e[(o+1)%e.length]??"",t.row.value=0};return[{keys:"↑ ↓",effect:"previous or next estimate",actions:{ArrowUp:s(-1),ArrowDown:s(1)}},{keys:"q",effect:"next quantity",actions:{q:r}},...Ei(t.listing)]}function WC(n,e){let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),s=i*([1,2,5,10].find(a=>a*i>=t)??10),r=Math.ceil(n/s-1e-9),o=Math.floor(e/s+1e-9)-r+1;return Array.from({length:o},(a,l)=>Number(((r+l)*s).toPrecision(6)))}function qC(){let n=Nt(null),[e,t]=Hs(Bv);return Dn(()=>{let i=n.current;if(i===null)return;let s=new ResizeObserver(()=>t(Math.min(Math.max(i.clientWidth,Bv),960)));return s.observe(i),()=>s.disconnect()},[]),[n,e]}var XC={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"};function gr(n){let{x:e,curves:t,titles:i,height:s,limits:r,whole:o}=n,a=Nt(null),l=Nt(n);l.current=n;let c=Nt(null);return Oi(()=>{let u=a.current;if(u===null)return;let f={...XC,stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")},grid:{show:!1}},h=()=>({width:$s(u),height:s}),d=new Jt({...h(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(p,y,g)=>y===null?r?.x??[0,1]:[y,g]},y:{range:(p,y,g)=>y===null?r?.y??[0,1]:[y,g]}},axes:[{...f,label:i[0],labelSize:22,size:34,...o?{incrs:[1,2,5,10]}:{}},{...f,label:i[1],labelSize:24,size:52}],series:[{},...t.map(({colour:p,dash:y,width:g,points:m})=>({stroke:()=>Qe(p),fill:()=>"transparent",dash:y??[],width:m?0:g??1.4,points:m?{show:!0,size:4,fill:()=>Qe(p),width:0}:{show:!1}}))],hooks:{drawClear:[p=>Ks(p,()=>l.current.below?.(p))],draw:[p=>Ks(p,()=>l.current.above?.(p))]}},[e,...t.map(({values:p})=>p)],u);return r?.x&&d.setScale("x",{min:r.x[0],max:r.x[1]}),r?.y&&d.setScale("y",{min:r.y[0],max:r.y[1]}),So(d,(p,y)=>l.current.pick?.(d.posToVal(p,"x"),d.posToVal(y,"y"),d)),c.current=d,Zs(d,u,h,[])},[e,t,i[0],i[1]]),Oi(()=>c.current?.redraw(!1,!1)),_("div",{class:"curves",ref:a})}var mh=class{constructor(e){this.data=e;this.frequency=e.values("frequency"),this.rows=e.values("rows"),this.kinds=e.texts("incident"),this.incident=this.kinds.filter(t=>this.losses(t).flat().some(Number.isFinite)),[this.waves=0]=e.shape("decay"),this.carrier=Number(e.header.extra.carrier),this.gap=e.header.extra.gap,this.units=is(e)}data;frequency;rows;incident;waves;carrier;gap;units;kinds;nearest(e){let t=Array.from(this.frequency,i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}losses(e,t="loss"){let i=this.kinds.indexOf(e)*this.rows.length;return Array.from(this.rows,(s,r)=>this.curve(t,i+r))}ofWaves(e){return Array.from({length:this.waves},(t,i)=>this.curve(e,i))}curve(e,t){let i=this.frequency.length;return Array.from(this.data.values(e).subarray(t*i,(t+1)*i))}};function gh(n){return n.map(e=>Number.isFinite(e)?e:null)}var YC="Errors are the change of a value if all frequencies of the lattice move by the bound of their relative error, and this share of the value. Waves of the lattice are shown at normal incidence.",$C=10,Vv=1.05,ZC=60;function Gv(n){return _(KC,{data:n})}function KC({data:n}){let e=je(()=>new mh(n),[n]),t=je(()=>({line:$e(e.nearest(e.carrier)),rows:$e(e.rows.length-1),incident:$e(e.incident[0]??""),unit:$e(ss(e.units,Math.max(...e.frequency))),listing:$e("none")}),[e]),i=je(()=>JC(e,t),[e,t]);return _(ui,{name:"mirror",data:n,keys:i,foot:YC,children:[_("div",{class:"pair",children:[_("section",{"aria-label":"Insertion loss",children:[_(ei,{label:"Insertion loss. Arrow keys change the frequency and the number of rows.",children:_(jC,{mirror:e,choice:t})}),_("p",{class:"axes",children:[_("label",{children:["Incident wave"," ",_("select",{value:t.incident.value,onChange:s=>t.incident.value=s.currentTarget.value,children:e.incident.map(s=>_("option",{children:s}))})]}),_(Bi,{title:"Frequencies in",units:e.units,unit:t.unit}),_("span",{class:"legend",children:[e.gap&&_("span",{class:"of-gap",children:"gap"}),_("span",{class:"of-carrier",children:"carrier"})]})]}),_(eR,{mirror:e,choice:t}),_(QC,{mirror:e,choice:t})]}),_("section",{"aria-label":"Waves of the lattice",children:[_(zv,{mirror:e,choice:t,name:"decay"}),_(zv,{mirror:e,choice:t,name:"phase"})]})]}),_(Ai,{listing:t.listing,keys:i,children:[_(tR,{mirror:e,choice:t}),_(nR,{mirror:e,choice:t})]})]})}function JC(n,e){let t=(o,a)=>Math.min(Math.max(o,0),a-1),i=o=>e.line.value=t(e.line.value+o,n.frequency.length),s=o=>e.rows.value=t(e.rows.value+o,n.rows.length),r=o=>o.shiftKey?$C:1;return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:o=>i(-r(o)),ArrowRight:o=>i(r(o))}},{keys:"↑ ↓",effect:"one more or one less row",actions:{ArrowUp:()=>s(1),ArrowDown:()=>s(-1)}},{keys:"i",effect:"next incident wave",actions:{i:()=>{let o=(n.incident.indexOf(e.incident.value)+1)%n.incident.length;e.incident.value=n.incident[o]??""}}},{keys:"c",effect:"carrier",actions:{c:()=>e.line.value=n.nearest(n.carrier)}},...Ei(e.listing)]}function Hv({mirror:n,choice:e}){let{factor:t}=e.unit.value,i=(n.frequency[e.line.value]??0)/t;return{below:s=>{n.gap&&ec(s,[n.gap[0]/t,n.gap[1]/t],"gap")},above:s=>{vo(s,n.carrier/t,"carrier",[7,5]),vo(s,i,"accent")},pick:s=>e.line.value=n.nearest(s*t)}}function Wv({mirror:n,choice:e}){let{factor:t}=e.unit.value;return je(()=>Array.from(n.frequency,i=>i/t),[n,t])}function jC({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.rows.value],s=je(()=>n.losses(t).map((r,o)=>({values:gh(r),colour:o===i?"accent":"quiet",width:o===i?2.6:1})),[n,t,i]);return _(gr,{x:Wv({mirror:n,choice:e}),curves:s,titles:[on("frequency",e.unit.value),`${n.data.title("loss")} / dB`],height:300,...Hv({mirror:n,choice:e})})}function QC({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.line.value],[s,r]=["loss","loss_error"].map(c=>n.losses(t,c).map(u=>u[i]??NaN)),o=je(()=>Array.from(n.rows),[n]),a=je(()=>[{values:gh(s??[]),colour:"quiet",dash:[2,4]}],[n,t,i]),l=Math.max(1,...o.map((c,u)=>(s?.[u]??NaN)+(r?.[u]??NaN)).filter(Number.isFinite));return _(gr,{x:o,curves:a,titles:["rows",`${n.data.title("loss")} / dB`],height:200,whole:!0,limits:{x:[.5,o.length+.5],y:[Math.min(0,...(s??[]).filter(Number.isFinite)),Vv*l]},above:c=>o.forEach((u,f)=>{let[h=NaN,d=NaN]=[s?.[f],r?.[f]];if(!Number.isFinite(h))return;let p=y=>[c.valToPos(u,"x",!0),c.valToPos(y,"y",!0)];xo(c.ctx,p(h-d),p(h+d),"ink"),bo(c.ctx,p(h),f===e.rows.value?"accent":"quiet")}),pick:c=>e.rows.value=Math.min(Math.max(Math.round(c)-1,0),o.length-1)},`${t} ${i}`)}function zv({mirror:n,choice:e,name:t}){let i=je(()=>n.ofWaves(t).map(r=>({values:gh(r),colour:"curve-0",points:!0})),[n,t]),s=Math.min(ZC,Vv*Math.max(...i.flatMap(({values:r})=>r.map(o=>o??0))));return _(gr,{x:Wv({mirror:n,choice:e}),curves:i,titles:[on("frequency",e.unit.value),`${n.data.title(t)} / ${t==="decay"?"(dB/row)":"π"}`],height:t==="decay"?300:200,limits:{y:t==="decay"?[0,s]:[0,1]},...Hv({mirror:n,choice:e})})}function op({mirror:n,choice:e}){let t=e.unit.value;return $n(rs((n.frequency[e.line.value]??0)/t.factor),t)}function qv(n,e){return Number.isFinite(n)?`${kn(n??NaN,e??NaN)} dB`:"does not propagate"}function eR({mirror:n,choice:e}){let[t,i,s]=[e.incident.value,e.line.value,e.rows.value],[r,o]=["loss","loss_error"].map(l=>n.losses(t,l)[s]?.[i]),a=n.rows[s]??0;return _("div",{class:"facts",children:[_("p",{id:"point","aria-live":"polite",children:[t," at ",_("b",{children:op({mirror:n,choice:e})}),", ",a," row",a===1?"":"s",": ",_("b",{children:qv(r,o)})]}),_("p",{class:"again",children:["The same as a picture, in Python: ",_("code",{children:['study.layers().plot("layers", incident="',t,'")']})]})]})}function tR({mirror:n,choice:e}){let t=e.line.value;return _("div",{class:"wide",children:_("table",{children:[_("caption",{children:["Insertion loss at ",op({mirror:n,choice:e})]}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"rows"}),n.incident.map(i=>_("th",{scope:"col",children:["incident ",i]}))]})}),_("tbody",{children:Array.from(n.rows,(i,s)=>_("tr",{"aria-current":s===e.rows.value?"true":void 0,children:[_("td",{children:i}),n.incident.map(r=>_("td",{children:qv(n.losses(r)[s]?.[t],n.losses(r,"loss_error")[s]?.[t])}))]}))})]})})}function nR({mirror:n,choice:e}){let t=e.line.value,i=["decay","decay_error","phase","phase_error"].map(s=>n.ofWaves(s));return _("div",{class:"wide",children:_("table",{children:[_("caption",{children:["Waves of the lattice at ",op({mirror:n,choice:e})]}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"decay / (dB/row)"}),_("th",{scope:"col",children:"phase per row / π"})]})}),_("tbody",{children:Array.from({length:n.waves},(s,r)=>{let[o=NaN,a=NaN,l=NaN,c=NaN]=i.map(u=>u[r]?.[t]);return _("tr",{children:[_("td",{children:kn(o,a)}),_("td",{children:Number.isFinite(l)?kn(l,c):"decays"})]})})})]})})}var ap=class{constructor(e,t,i,s,r,o,a){this.title=i;this.columns=s;this.rows=r;this.places=o;this.colours=a;this.real=e.values(`${t}_real`),this.imag=e.values(`${t}_imag`),this.step=e.values(`${t}_step`),this.count=e.shape(`${t}_real`).slice(1).reduce((l,c)=>l*c,1),this.largestStep=(a.length-1)/2}title;columns;rows;places;colours;largestStep;real;imag;step;count;largest(e){return(this.step[e]??0)*this.largestStep}paint(e,t,i,s){let r=s>0?this.largest(t)/s:0,[o,a]=[r*Math.cos(2*Math.PI*i),r*Math.sin(2*Math.PI*i)],l=this.largestStep,c=t*this.count;for(let u=0;u<this.rows;u++)for(let f=0;f<this.columns;f++){let h=this.places[u*this.columns+f]??-1,d=(this.real[c+h]??0)*o-(this.imag[c+h]??0)*a,p=Math.min(Math.max(Math.round(l+d),0),2*l),[y=0,g=0,m=0]=this.colours[p]??[],b=4*((this.rows-1-u)*this.columns+f);e.data[b]=y,e.data[b+1]=g,e.data[b+2]=m,e.data[b+3]=h<0?0:255}}outermost(e){let t=e*this.count,[i,s]=[0,-1];for(let r=t;r<t+this.count;r++){let o=Math.hypot(this.real[r]??0,this.imag[r]??0);o>s&&([i,s]=[r,o])}return-Math.atan2(this.imag[i]??0,this.real[i]??0)/(2*Math.PI)}},_h=class{constructor(e){this.data=e;let{extra:t}=e.header;this.frequency=e.values("frequency"),this.gap=t.gap,this.carrier=t.carrier,this.drive=String(t.drive),this.firstIs=String(t.first_is),this.python=String(t.python),this.parts=t,this.colours=t.colours,this.units=is(e);let i=iR(e),[s=0,r=0]=e.shape(e.has("place")?"place":"present");this.fields=Object.entries(t.maps).map(([c,u])=>new ap(e,c,u,r,s,i,this.colours));let o=e.has("mode_frequency"),[a,l]=o?[e.values("mode_frequency"),e.values("mode_quality")]:[[],[]];this.modes=Array.from(a,(c,u)=>({frequency:c,name:e.texts("mode_name")[u]??"",quality:l[u]??NaN}))}data;frequency;fields;gap;carrier;drive;firstIs;python;parts;modes;colours;units;nearest(e){let t=0;return this.frequency.forEach((i,s)=>{Math.abs(i-e)<Math.abs((this.frequency[t]??0)-e)&&(t=s)}),t}get first(){return this.nearest(Number(this.data.header.extra.first))}largest(e,t=this.fields){return Math.max(...t.map(i=>i.largest(e)))}get extent(){let[e,t]=[this.data.values("x"),this.data.values("y")],[i,s]=[Xv(e),Xv(t)];return{left:(e[0]??0)-i,right:(e[e.length-1]??0)+i,bottom:(t[0]??0)-s,top:(t[t.length-1]??0)+s}}has(e){return this.data.has(e)}curves(e){if(!this.data.has(e))return[];let t=this.data.values(e),i=this.data.texts(e==="level"?"region":"pair"),s=this.frequency.length;return i.map((r,o)=>({name:r,values:Array.from(t.subarray(o*s,(o+1)*s),a=>Number.isFinite(a)&&(e==="contrast"||a>0)?a:null)}))}};function iR(n){return n.has("place")?Int32Array.from(n.values("place")):Int32Array.from(n.values("present"),(e,t)=>e===0?-1:t)}function Xv(n){return n.length>1?.5*((n[1]??0)-(n[0]??0)):5e-4}var gl=[[],[8,4],[2,3],[10,3,2,3]],lp=4,sR=300;function Yv({plate:n,choice:e}){let t=Nt(null),i=e.shown.value;return Oi(()=>{if(t.current!==null)return rR(t.current,n,e)},[n,e,i]),_("div",{class:"curves",ref:t})}function rR(n,e,t){let i=t.shown.peek(),s=e.curves(i),r=e.data.unit(i),o={stroke:()=>Qe("ink"),ticks:{stroke:()=>Qe("rule")}},a={font:"13px system-ui, sans-serif",labelFont:"14px system-ui, sans-serif"},l=()=>t.unit.peek().factor,c=()=>[Array.from(e.frequency,h=>h/l()),...s.map(({values:h})=>h)],u=()=>({width:$s(n),height:sR}),f=new Jt({...u(),legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},scales:{x:{time:!1},y:{distr:i==="level"?3:1}},axes:[{...o,...a,label:"frequency",labelSize:22,size:34,grid:{show:!1}},{...o,...a,label:`${e.data.title(i)} / ${r}`,labelSize:24,size:58,grid:{show:!1},values:(h,d)=>d.map(p=>p===null?"":oR(p,i==="level"))}],series:[{},...s.map((h,d)=>({stroke:()=>Qe(`curve-${d%lp}`),dash:gl[d%gl.length]??[],width:1.4,points:{show:!1}}))],hooks:{drawClear:[h=>Ks(h,()=>aR(h,e,l()))],draw:[h=>lR(h,e,t)]}},c(),n);return So(f,h=>t.line.value=e.nearest(l()*f.posToVal(h,"x"))),Zs(f,n,u,[Ct(()=>{let h=f.axes[0];h!==void 0&&(h.label=on("frequency",t.unit.value)),f.setData(c(),!0)}),Ct(()=>{t.line.value,f.redraw(!1,!1)})])}function oR(n,e){if(!e)return`${Number(n.toPrecision(4))}`.replace("-","−");let t=Math.log10(n);return Math.abs(t-Math.round(t))<1e-9?`1e${Math.round(t)}`.replace("-","−"):""}function aR(n,e,t){e.gap!==null&&ec(n,[e.gap[0]/t,e.gap[1]/t],"gap")}function lR(n,e,t){let{factor:i}=t.unit.peek();e.carrier!==null&&vo(n,e.carrier/i,"carrier",[7,5]),vo(n,(e.frequency[t.line.peek()]??0)/i,"accent")}var cR=10;function $v(n){return{line:$e(n.first),shown:$e(n.has("level")?"level":"contrast"),plan:$e(!1),common:$e(!1),unit:$e(ss(n.units,Math.max(...n.frequency))),playing:$e(!Mo()),pace:$e(.7),listing:$e("none")}}function Zv(n,e){let t=n.frequency.length-1,i=u=>e.line.value=Math.min(Math.max(e.line.value+u,0),t),s=u=>u.shiftKey?cR:1,r=n.modes.map(({frequency:u})=>n.nearest(u)).sort((u,f)=>u-f),o=u=>{u!==void 0&&(e.line.value=u)},{carrier:a}=n,l={keys:"p n",effect:"previous or next mode near the carrier",actions:{p:()=>o(r.filter(u=>u<e.line.value).pop()),n:()=>o(r.find(u=>u>e.line.value))}},c={keys:"s",effect:"one scale of colours for both maps, or one for each",actions:{s:()=>e.common.value=!e.common.value}};return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:u=>i(-s(u)),ArrowRight:u=>i(s(u))}},...r.length>0?[l]:[],...a!==null?[{keys:"c",effect:"carrier",actions:{c:()=>o(n.nearest(a))}}]:[],{keys:"g",effect:n.firstIs,actions:{g:()=>o(n.first)}},...n.fields.length>1?[c]:[],{keys:"l",effect:"pillars and supports",actions:{l:()=>e.plan.value=!e.plan.value}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},...Ei(e.listing)]}var uR="The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.",hR="Each point of the scan is a square of the map. Measurement and model move with the phase of the drive.",Kv=["level","contrast"];function Jv(n){return _(Qv,{data:n,foot:uR})}function jv(n){return _(Qv,{data:n,foot:hR})}function Qv({data:n,foot:e}){let t=je(()=>new _h(n),[n]),i=je(()=>$v(t),[t]),s=je(()=>Zv(t,i),[t,i]),r=Kv.filter(o=>t.has(o));return _(ui,{name:"plate",data:n,keys:s,foot:e,children:[_("div",{class:t.fields.length>1?"":"pair",children:[_("section",{"aria-label":"Spectra",children:[r.length>0&&t.frequency.length>1&&_(gn,{children:[_(ei,{label:"Spectra. Arrow keys change the frequency.",children:_(Yv,{plate:t,choice:i})}),_(fR,{plate:t,choice:i}),_("p",{class:"axes",children:[_("label",{children:["Curves"," ",_("select",{value:i.shown.value,onChange:o=>i.shown.value=o.currentTarget.value,children:r.map(o=>_("option",{value:o,children:t.data.title(o)}))})]}),_(Bi,{title:"Frequencies in",units:t.units,unit:i.unit})]})]}),_(dR,{plate:t,choice:i})]}),_("section",{"aria-label":"Map",children:[_(Dv,{plate:t,choice:i}),_("div",{class:"controls",children:[_(Ws,{playing:i.playing}),_(pR,{plate:t,choice:i}),_(oo,{pace:i.pace}),_("label",{class:"check",children:[_("input",{type:"checkbox",checked:i.plan.value,onChange:o=>i.plan.value=o.currentTarget.checked}),"pillars and supports"]}),t.fields.length>1&&_("label",{class:"check",children:[_("input",{type:"checkbox",checked:i.common.value,onChange:o=>i.common.value=o.currentTarget.checked}),"one scale of colours for both maps"]})]})]})]}),_(Ai,{listing:i.listing,keys:s,children:[_(mR,{plate:t,choice:i}),_(gR,{plate:t,choice:i})]})]})}function fR({plate:n,choice:e}){return _("p",{class:"legend",children:[n.curves(e.shown.value).map(({name:t},i)=>_("span",{class:"of-curve",children:[_("svg",{width:"34",height:"8","aria-hidden":"true",children:_("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${i%lp})`,"stroke-dasharray":(gl[i%gl.length]??[]).join(" ")})})," ",t]})),n.gap!==null&&_("span",{class:"of-gap",children:"gap"}),n.carrier!==null&&_("span",{class:"of-carrier",children:"carrier"})]})}function ra(n,e){return $n(rs(n/e.factor),e)}function dR({plate:n,choice:e}){let t=e.line.value,i=n.frequency[t]??0,s=n.curves("contrast");return _("div",{class:"facts",children:[_("p",{id:"point","aria-live":"polite",children:[_("b",{children:ra(i,e.unit.value)}),": up to ",Wr(n.largest(t)),n.drive,s.map(({name:r,values:o})=>`; ${r} ${o[t]?.toFixed(1)??"-"} dB`).join("")]}),_("p",{class:"again",children:["The same map as a picture, in Python: ",_("code",{children:`${n.python}.plot("maps", frequency=${Number(i.toFixed(3))})`})]})]})}function pR({plate:n,choice:e}){let t=n.frequency.length-1,i=e.line.value;return _("label",{class:"long",children:["frequency: ",ra(n.frequency[i]??0,e.unit.value),_("input",{type:"range",min:"0",max:t,step:"1",value:i,disabled:t===0,"aria-valuetext":ra(n.frequency[i]??0,e.unit.value),onInput:s=>e.line.value=Number(s.currentTarget.value)})]})}function mR({plate:n,choice:e}){let t=e.line.value,i=Kv.flatMap(s=>n.curves(s).map(({name:r,values:o})=>[n.data.title(s),r,`${o[t]?.toPrecision(3)??"-"} ${n.data.unit(s)}`]));for(let s of n.fields.length>1?n.fields:[])i.push(["largest displacement",s.title,`${Wr(s.largest(t))}${n.drive}`]);return n.data.has("agreement")&&i.push([n.data.title("agreement"),"both maps",(n.data.values("agreement")[t]??0).toFixed(3)]),_("div",{class:"wide",children:_("table",{children:[_("caption",{children:["Regions at ",ra(n.frequency[t]??0,e.unit.value)]}),_("tbody",{children:i.map(s=>_("tr",{children:s.map(r=>_("td",{children:r}))}))})]})})}function gR({plate:n,choice:e}){return n.modes.length===0?null:_("div",{class:"wide",children:_("table",{children:[_("caption",{children:"Modes near the carrier"}),_("thead",{children:_("tr",{children:[_("th",{scope:"col",children:"frequency"}),_("th",{scope:"col",children:"nodal lines"}),_("th",{scope:"col",children:"Q"}),_("th",{scope:"col",children:"show"})]})}),_("tbody",{children:n.modes.map(({frequency:t,name:i,quality:s})=>_("tr",{children:[_("td",{children:ra(t,e.unit.value)}),_("td",{children:i}),_("td",{children:s.toFixed(0)}),_("td",{children:_("button",{type:"button",onClick:()=>e.line.value=n.nearest(t),children:ra(n.frequency[n.nearest(t)]??0,e.unit.value)})})]}))})]})})}function ny({points:n,drawing:e}){let t=e?.plate.flat()??[],[i,s,r,o]=cp([...n,...t]),a=Math.max(s-i,o-r,1e-6),[l,c]=[.06*a,.045*a],u=[i-l,-o-l,s-i+2*l,o-r+2*l],[f,h]=[n[0],n.at(-1)];return _("svg",{class:"points",viewBox:u.map(d=>1e3*d).join(" "),role:"img","aria-label":_R(n,e),children:[e!==null&&_(gn,{children:[_("path",{d:e.plate.map(ty).join(""),class:"plate"}),_("path",{d:Object.values(e.regions).flat().map(ty).join(""),class:"region"})]}),_("path",{d:n.map(([d,p])=>`M${ri(d)} ${ri(-p)}h1e-4`).join(""),class:"places"}),f!==void 0&&_("path",{d:`M${ri(f[0])} ${ri(-f[1])}h1e-4`,class:"first"}),_("g",{"font-size":1e3*c,children:[Object.entries(e?.regions??{}).map(([d,p])=>{let[y,g,,m]=cp(p.flat());return _("text",{x:ri((y+g)/2),y:ri(1.2*c-m),"text-anchor":"middle",children:d})}),f!==void 0&&_(ey,{at:f,letter:c,words:"1"}),h!==void 0&&n.length>1&&_(ey,{at:h,letter:c,words:`${n.length}`}),_("text",{x:ri(s+l),y:ri(-r+.9*l),"text-anchor":"end",class:"quiet",children:"x →"}),_("text",{x:ri(i-.9*l),y:ri(-o-.2*l),class:"quiet",children:"y ↑"})]})]})}function ey({at:[n,e],letter:t,words:i}){return _("text",{x:ri(n+.3*t),y:ri(-e-.3*t),class:"number",children:i})}var ri=n=>Number((1e3*n).toFixed(4)),ty=n=>`M${n.map(([e,t])=>`${ri(e)} ${ri(-t)}`).join("L")}Z`;function cp(n){let[e,t,i,s]=[1/0,-1/0,1/0,-1/0];for(let[r,o]of n)[e,t]=[Math.min(e,r),Math.max(t,r)],[i,s]=[Math.min(i,o),Math.max(s,o)];return[e,t,i,s]}function _R(n,e){let[t,i,s,r]=cp(n),o=(l,c)=>`${Number((1e3*l).toPrecision(4))} to ${Number((1e3*c).toPrecision(4))} mm`,a=e===null?"":" over the outline of the plate";return`${n.length} points${a}: x from ${o(t,i)}, y from ${o(s,r)}`}var vR=220,vh=[[],[8,4]];function iy(n){return _(yR,{data:n})}function yR({data:n}){let{points:e,drawing:t,curves:i,unit:s,axis:r,names:o}=je(()=>xR(n),[n]),a=n.values(r),l=je(()=>Array.from(a,c=>c/s.factor),[n]);return _("div",{class:"reading",children:[e.length>0&&_(ny,{points:e,drawing:t}),l.length>1&&_("div",{children:[_(gr,{x:l,curves:i,titles:[on(n.title(r),s),bR(n,o)],height:vR}),o.length>1&&_("p",{class:"legend",children:o.map((c,u)=>_("span",{class:"of-curve",children:[_("svg",{width:"34",height:"8","aria-hidden":"true",children:_("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${u})`,"stroke-dasharray":(vh[u%vh.length]??[]).join(" ")})})," ",n.title(c)]}))})]})]})}function xR(n){let{extra:e,variables:t}=n.header,i=String(e.axis),s=Object.keys(t).filter(u=>u!==i&&t[u]?.dims[0]===i),r=s.map((u,f)=>({values:Array.from(n.values(u),h=>Number.isFinite(h)?h:null),colour:`curve-${f}`,dash:vh[f%vh.length]??[]})),o=n.has("y")?n.values("y"):[],a=n.has("x")?Array.from(n.values("x"),(u,f)=>[u,o[f]??0]):[],l={name:n.unit(i),factor:1},c=l.name==="Hz"?ss(is(n),Math.max(...n.values(i))):l;return{points:a,drawing:e.drawing,curves:r,unit:c,axis:i,names:s}}function bR(n,e){let[t=""]=e;return on(e.length===1?n.title(t):"force",{name:n.unit(t),factor:1})}var SR=40,MR=.42;function sy({ribbon:n,choice:e}){let[t,i]=[e.unit.value,e.wavevectorUnit.value],s=e.mode.value,r=je(()=>Array.from(n.phases,l=>l/n.period/i.factor),[n,i]),o=je(()=>{let[l,c]=n.range;return{x:[0,Math.PI/n.period/i.factor],y:[l/t.factor,c/t.factor]}},[n,i,t]),a=(l,c,u=!1)=>[l.valToPos(n.wavevector(c)/i.factor,"x",u),l.valToPos(n.at(c)/t.factor,"y",u)];return _(gr,{x:r,curves:wR,titles:[on("wavevector along the ribbon",i),on("frequency",t)],height:420,limits:o,below:l=>TR(l,n,r,t.factor),above:l=>{ER(l,n,t.factor,i.factor),n.carrier!==null&&yo(l,n.carrier/t.factor,"carrier",[7,5]),bo(l.ctx,a(l,s,!0),"accent")},pick:(l,c,u)=>{let[f,h]=[u.valToPos(l,"x"),u.valToPos(c,"y")],d=y=>Math.hypot(a(u,y)[0]-f,a(u,y)[1]-h),p=n.all.reduce((y,g)=>d(g)<d(y)?g:y,0);d(p)<SR&&(e.mode.value=p)}})}var wR=[];function TR(n,e,t,i){let{ctx:s}=n;s.save(),s.globalAlpha=.4;for(let{crystal:r,lower:o,upper:a}of e.bulk()){s.fillStyle=Qe(r===0?"rule":`curve-${r}`),s.beginPath();let l=(c,u)=>s.lineTo(n.valToPos(t[u]??0,"x",!0),n.valToPos((c[u]??0)/i,"y",!0));t.forEach((c,u)=>l(a,u)),t.forEach((c,u)=>l(o,t.length-1-u)),s.fill()}s.restore()}function ER(n,e,t,i){let{ctx:s}=n,r=e.phases.length>1?(e.phases[1]??0)-(e.phases[0]??0):.1,o=MR*r/e.period;s.save();for(let a of e.all){let l=(e.velocity[a]??0)*o/(2*Math.PI),c=f=>[n.valToPos((e.wavevector(a)+f*o)/i,"x",!0),n.valToPos((e.at(a)+f*l)/t,"y",!0)],u=e.share[a]??0;s.strokeStyle=up(e.shares,u),s.lineWidth=(e.isGuided(a)?3:1.4)*devicePixelRatio,s.beginPath(),s.moveTo(...c(-1)),s.lineTo(...c(1)),s.stroke()}s.restore()}function up(n,e){let t=matchMedia("(prefers-color-scheme: dark)").matches?e:1-e;return`rgb(${(n[Math.round(Math.min(Math.max(t,0),1)*(n.length-1))]??[]).join(" ")})`}var AR=1.6,CR=30;function ry({ribbon:n,choice:e}){let t=Nt(null);return Dn(()=>t.current===null?void 0:RR(t.current,n,e),[n,e]),_("div",{class:"map",children:[_("canvas",{ref:t,role:"img","aria-label":"Field of the mode"}),_(Eo,{canvas:t,name:"ribbon",caption:`${n.data.header.title}, ${Mr(n.data)}`})]})}function RR(n,e,t){let i=new hp(e),s=mr.on(n,i.columns,i.rows);if(s===null)return()=>{};let r={frames:0,painter:i},o=()=>{let c=t.mode.peek();r.frames++,i.paint(s.image,c,a.moment),s.show(!0),n.dataset.shown=String(c)},a=new Js(t,o,n);To(n,c=>a.at(c)),Object.assign(n,{counted:r});let l=[s.follow(i.width/i.length,o),Ct(()=>{t.mode.value,o()}),ti(o)];return()=>{a.end();for(let c of l)c()}}var hp=class{constructor(e){this.ribbon=e;let[,t=0,i=0]=e.data.shape("mode_real"),s=e.data.values("across");this.width=((s[1]??0)-(s[0]??0))*t;let r=Math.min(CR,Math.max(2,Math.round(AR*this.width/e.period)));this.length=r*e.period,this.columns=r*i,this.rows=t,this.along=i}ribbon;columns;rows;width;length;along;paint(e,t,i){let{data:s,colours:r,phase:o}=this.ribbon,[a,l,c]=[s.values("mode_real"),s.values("mode_imag"),s.values("present")],u=(r.length-1)/2,f=t*this.rows*this.along;for(let h=0;h<this.columns;h++){let d=Math.floor(h/this.along),p=2*Math.PI*i+d*(o[t]??0),[y,g]=[Math.cos(p),Math.sin(p)];for(let m=0;m<this.rows;m++){let b=m*this.along+h%this.along,A=(a[f+b]??0)*y-(l[f+b]??0)*g,S=Math.min(Math.max(Math.round(u+A),0),2*u),[P=0,C=0,v=0]=r[S]??[],E=4*((this.rows-1-m)*this.columns+h);e.data.set([P,C,v,c[b]===0?0:255],E)}}}};var PR=["across the ribbon","along the ribbon","normal to the plate"],yh=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),this.phase=e.values("phase"),this.velocity=e.values("group_velocity"),this.share=e.values("guide_share"),this.phases=e.values("wavevector_phase"),this.period=Number(i.period),this.range=t.range,this.carrier=t.carrier,this.place=i.kind==="strip"?"the outermost columns":`the ${i.kind}`,this.units=is(e),this.wavevectorUnits=Bl(this.period),this.colours=t.colours,this.shares=t.shares,this.atPhase=Array.from(this.phases,s=>this.all.filter(r=>this.phase[r]===s).sort((r,o)=>this.at(r)-this.at(o)))}data;frequency;error;phase;velocity;share;phases;period;range;carrier;place;units;wavevectorUnits;colours;shares;atPhase;get all(){return Array.from(this.frequency,(e,t)=>t)}get hasFields(){return this.data.has("mode_real")}at(e){return this.frequency[e]??NaN}wavevector(e){return(this.phase[e]??0)/this.period}isGuided(e){return this.data.values("guided")[e]===1}decay(e){return this.data.values("decay")[e]??NaN}direction(e){return PR[this.data.values("mode_component")[e]??2]??""}get first(){let[e,t]=this.range,i=this.carrier!==null&&this.carrier>e&&this.carrier<t?this.carrier:(e+t)/2,s=this.all.filter(r=>this.isGuided(r));return oy(s.length>0?s:this.all,r=>this.at(r),i)}beside(e){return this.atPhase[this.row(e)]??[]}moved(e,t,i){let s=this.beside(e);if(i!==0)return s[Math.min(Math.max(s.indexOf(e)+i,0),s.length-1)]??e;let r=this.atPhase.map((a,l)=>l).filter(a=>(this.atPhase[a]??[]).length>0),o=Math.min(Math.max(r.indexOf(this.row(e))+t,0),r.length-1);return oy(this.atPhase[r[o]??0]??[],a=>this.at(a),this.at(e))}get guided(){return this.atPhase.flat().filter(e=>this.isGuided(e))}bulk(){let[e=0,t=0,i=0]=this.data.shape("bulk_lower"),[s,r]=[this.data.values("bulk_lower"),this.data.values("bulk_upper")];return Array.from({length:e*i},(o,a)=>{let[l,c]=[Math.floor(a/i),a%i],u=f=>Array.from({length:t},(h,d)=>f[(l*t+d)*i+c]??NaN);return{crystal:l,lower:u(s),upper:u(r)}})}row(e){return Array.from(this.phases).indexOf(this.phase[e]??NaN)}};function oy(n,e,t){return n.reduce((i,s)=>Math.abs(e(s)-t)<Math.abs(e(i)-t)?s:i,n[0]??0)}var ay="Each error bounds the distance to the exact frequency of the model. The field is that of the strongest component on the flat face, relative to its largest displacement.",IR="Fields of the modes are computed with the option --html.";function ly(n){return _(LR,{data:n})}function LR({data:n}){let e=je(()=>new yh(n),[n]),t=je(()=>({mode:$e(e.first),unit:$e(ss(e.units,e.range[1])),wavevectorUnit:$e(e.wavevectorUnits[1]),playing:$e(!Mo()),pace:$e(.7),listing:$e("none")}),[e]),i=je(()=>DR(e,t),[e,t]);return e.all.length===0?_(ui,{name:"ribbon",data:n,keys:[],foot:ay,children:null}):_(ui,{name:"ribbon",data:n,keys:i,foot:ay,children:[_("div",{class:"pair",children:[_("section",{"aria-label":"Projected bands",children:[_(ei,{label:"Projected bands. Arrow keys move between wavevectors and modes.",children:_(sy,{ribbon:e,choice:t})}),_("p",{class:"axes",children:[_(Bi,{title:"Frequencies in",units:e.units,unit:t.unit}),_(Bi,{title:"Wavevectors in",units:e.wavevectorUnits,unit:t.wavevectorUnit})]}),_(NR,{ribbon:e})]}),_("section",{"aria-label":"Mode",children:[e.hasFields?_(ry,{ribbon:e,choice:t}):_("p",{children:IR}),_(UR,{ribbon:e,choice:t}),e.hasFields&&_("div",{class:"controls",children:[_(Ws,{playing:t.playing}),_(oo,{pace:t.pace})]})]})]}),_(Ai,{listing:t.listing,keys:i,children:_(FR,{ribbon:e,choice:t})})]})}function DR(n,e){let t=(s,r)=>e.mode.value=n.moved(e.mode.value,s,r),i=s=>{let{guided:r}=n;if(r.length===0)return;let o=r.indexOf(e.mode.value);e.mode.value=r[(o+s+r.length)%r.length]??e.mode.value};return[{keys:"← →",effect:"mode of about this frequency at the previous or next wavevector",actions:{ArrowLeft:()=>t(-1,0),ArrowRight:()=>t(1,0)}},{keys:"↑ ↓",effect:"next higher or lower mode at this wavevector",actions:{ArrowUp:()=>t(0,1),ArrowDown:()=>t(0,-1)}},{keys:"p n",effect:"previous or next guided mode",actions:{p:()=>i(-1),n:()=>i(1)}},{keys:"space",effect:"move or stop",actions:{" ":()=>e.playing.value=!e.playing.value}},...Ei(e.listing)]}function NR({ribbon:n}){let[,e]=Hs(0);Dn(()=>ti(()=>e(i=>i+1)),[]);let t=[0,.25,.5,.75,1].map(i=>up(n.shares,i));return _("p",{class:"scale legend",children:["0 %",_("span",{class:"bar",style:{background:`linear-gradient(to right, ${t.join(", ")})`}}),"100 % of the energy in ",n.place,"; guided modes are thick",n.carrier!==null&&_("span",{class:"of-carrier",children:"carrier"})]})}function cy(n,e,{factor:t,name:i}){return`${Number((n.wavevector(e)/t).toPrecision(4))} ${i}`}function uy(n){return`${(100*(n??NaN)).toFixed(1)} %`}function hy(n,e,{factor:t}){return kn(n.at(e)/t,(n.error[e]??NaN)/t)}function UR({ribbon:n,choice:e}){let[t,i,s]=[e.mode.value,e.unit.value,e.wavevectorUnit.value],r=n.decay(t),o=[["group velocity",`${(n.velocity[t]??0).toFixed(0)} m/s`],[`energy in ${n.place}`,uy(n.share[t])],["decay",Number.isFinite(r)?`${r.toFixed(1)} dB per row`:""],["shown displacement",n.hasFields?n.direction(t):""]];return _("div",{class:"facts",children:[_("p",{id:"point","aria-live":"polite",children:[n.isGuided(t)?"Guided mode":"Mode"," at ",cy(n,t,s),":"," ",_("b",{children:$n(hy(n,t,i),i)})]}),_(qs,{facts:o})]})}function FR({ribbon:n,choice:e}){let[t,i,s]=[e.mode.value,e.unit.value,e.wavevectorUnit.value];return _("div",{class:"wide",children:_("table",{children:[_("caption",{children:["Modes at ",cy(n,t,s)]}),_("thead",{children:_("tr",{children:[on("frequency",i),"guided",`energy in ${n.place}`,"decay / (dB/row)","show"].map(r=>_("th",{scope:"col",children:r}))})}),_("tbody",{children:n.beside(t).map(r=>_("tr",{"aria-current":r===t?"true":void 0,children:[_("td",{children:hy(n,r,i)}),_("td",{children:n.isGuided(r)?"yes":"no"}),_("td",{children:uy(n.share[r])}),_("td",{children:Number.isFinite(n.decay(r))?n.decay(r).toFixed(1):"-"}),_("td",{children:_("button",{type:"button",onClick:()=>e.mode.value=r,children:$n(rs(n.at(r)/i.factor),i)})})]}))})]})})}var fy='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var dy=`& {
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
.reading { display: grid; gap: 0.75rem; grid-template-columns: repeat(auto-fit, minmax(min(18rem, 100%), 1fr)); align-items: start; }
.points { width: 100%; max-height: 22rem; background: var(--panel); border: 1px solid var(--rule); border-radius: 0.3rem; }
.points path { fill: none; stroke: var(--quiet); stroke-width: 1.5px; vector-effect: non-scaling-stroke; }
.points .region { stroke: var(--curve-1); }
.points .places { stroke: var(--accent); stroke-width: 4px; stroke-linecap: round; }
.points .first { stroke: var(--carrier); stroke-width: 9px; stroke-linecap: round; }
.points text { fill: var(--ink); }
.points .number { font-weight: 700; paint-order: stroke; stroke: var(--panel); stroke-width: 3px; vector-effect: non-scaling-stroke; }
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
`;var kR={bands:bv,layers:Gv,plate:Jv,scan:jv,finger:Ov,ribbon:ly,friction:kv,reading:iy};function fp(n,e,t){let i=kR[n.header.kind];if(i===void 0)throw new Error(`this version has no view "${n.header.kind}"`);return zR(),e.classList.add("haptonic","view"),zh(i(n,t),e),()=>zh(null,e)}function zR(){if(document.getElementById("haptonic-style")!==null)return;let n=document.createElement("style");n.id="haptonic-style",n.textContent=`${fy}:where(.haptonic) { ${dy} }`,document.head.append(n)}async function VR({model:n,el:e}){e.dataset.lmSuppressShortcuts="true";let{buffer:t,byteOffset:i,byteLength:s}=n.get("data");return fp(pa.read(await Ph(new Uint8Array(t,i,s))),e)}async function py(n){let e=document.getElementById(n.dataset.view??"")?.textContent??"";try{let t=Uint8Array.from(atob(e.trim()),s=>s.charCodeAt(0)),i=pa.read(await Ph(t));return n.replaceChildren(),fp(i,n)}catch(t){let i=document.createElement("p");return i.textContent=`The view cannot be shown: ${t instanceof Error?t.message:String(t)}`,n.replaceChildren(i),()=>{}}}var _l=null;function GR(n,e){let t=document.createElement("button"),i=document.createElement("div");t.type="button";let s=null,r=()=>{s?.(),i.remove(),t.textContent=e,t.ariaExpanded="false",[_l,s]=[null,null]};t.addEventListener("click",async()=>{let o=_l===r;if(_l?.(),o)return;_l=r,t.textContent="Close the view",t.ariaExpanded="true",n.append(i),i.dataset.view=n.dataset.view??"";let a=await py(i);_l===r?s=a:a()}),r(),n.append(t)}for(let n of document.querySelectorAll("[data-view]")){let e=n.dataset.opens;e===void 0?py(n):GR(n,e)}var HF={render:VR};export{HF as default};
