var k1=Object.create;var Cv=Object.defineProperty;var B1=Object.getOwnPropertyDescriptor;var z1=Object.getOwnPropertyNames;var G1=Object.getPrototypeOf,V1=Object.prototype.hasOwnProperty;var H1=(n,e)=>()=>{try{return e||n((e={exports:{}}).exports,e),e.exports}catch(t){throw e=0,t}};var W1=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let r of z1(e))!V1.call(n,r)&&r!==t&&Cv(n,r,{get:()=>e[r],enumerable:!(i=B1(e,r))||i.enumerable});return n};var q1=(n,e,t)=>(t=n!=null?k1(G1(n)):{},W1(e||!n||!n.__esModule?Cv(t,"default",{value:n,enumerable:!0}):t,n));var hx=H1(Lm=>{var nx=Object.defineProperty,FA=n=>nx(n,"__esModule",{value:!0}),UA=(n,e)=>{for(var t in e)nx(n,t,{get:e[t],enumerable:!0})};FA(Lm);UA(Lm,{GIFEncoder:()=>cx,applyPalette:()=>qA,default:()=>tC,nearestColor:()=>KA,nearestColorIndex:()=>ax,nearestColorIndexWithDistance:()=>lx,prequantize:()=>WA,quantize:()=>VA,snapColorsToPalette:()=>YA});var OA={signature:"GIF",version:"89a",trailer:59,extensionIntroducer:33,applicationExtensionLabel:255,graphicControlExtensionLabel:249,imageSeparator:44,signatureSize:3,versionSize:3,globalColorTableFlagMask:128,colorResolutionMask:112,sortFlagMask:8,globalColorTableSizeMask:7,applicationIdentifierSize:8,applicationAuthCodeSize:3,disposalMethodMask:28,userInputFlagMask:2,transparentColorFlagMask:1,localColorTableFlagMask:128,interlaceFlagMask:64,idSortFlagMask:32,localColorTableSizeMask:7};function ix(n=256){let e=0,t=new Uint8Array(n);return{get buffer(){return t.buffer},reset(){e=0},bytesView(){return t.subarray(0,e)},bytes(){return t.slice(0,e)},writeByte(r){i(e+1),t[e]=r,e++},writeBytes(r,s=0,o=r.length){i(e+o);for(let a=0;a<o;a++)t[e++]=r[a+s]},writeBytesView(r,s=0,o=r.byteLength){i(e+o),t.set(r.subarray(s,s+o),e),e+=o}};function i(r){var s=t.length;if(s>=r)return;var o=1024*1024;r=Math.max(r,s*(s<o?2:1.125)>>>0),s!=0&&(r=Math.max(r,256));let a=t;t=new Uint8Array(r),e>0&&t.set(a.subarray(0,e),0)}}var Pm=12,Qy=5003,kA=[0,1,3,7,15,31,63,127,255,511,1023,2047,4095,8191,16383,32767,65535];function BA(n,e,t,i,r=ix(512),s=new Uint8Array(256),o=new Int32Array(Qy),a=new Int32Array(Qy)){let l=o.length,c=Math.max(2,i);s.fill(0),a.fill(0),o.fill(-1);let h=0,d=0,f=c+1,p=f,m=!1,_=p,v=(1<<_)-1,g=1<<f-1,x=g+1,A=g+2,S=0,P=t[0],C=0;for(let U=l;U<65536;U*=2)++C;C=8-C,r.writeByte(c),T(g);let y=t.length;for(let U=1;U<y;U++)e:{let D=t[U],L=(D<<Pm)+P,B=D<<C^P;if(o[B]===L){P=a[B];break e}let G=B===0?1:l-B;for(;o[B]>=0;)if(B-=G,B<0&&(B+=l),o[B]===L){P=a[B];break e}T(P),P=D,A<1<<Pm?(a[B]=A++,o[B]=L):(o.fill(-1),A=g+2,m=!0,T(g))}return T(P),T(x),r.writeByte(0),r.bytesView();function T(U){for(h&=kA[d],d>0?h|=U<<d:h=U,d+=_;d>=8;)s[S++]=h&255,S>=254&&(r.writeByte(S),r.writeBytesView(s,0,S),S=0),h>>=8,d-=8;if((A>v||m)&&(m?(_=p,v=(1<<_)-1,m=!1):(++_,v=_===Pm?1<<_:(1<<_)-1)),U==x){for(;d>0;)s[S++]=h&255,S>=254&&(r.writeByte(S),r.writeBytesView(s,0,S),S=0),h>>=8,d-=8;S>0&&(r.writeByte(S),r.writeBytesView(s,0,S),S=0)}}}var zA=BA;function rx(n,e,t){return n<<8&63488|e<<2&992|t>>3}function sx(n,e,t,i){return n>>4|e&240|(t&240)<<4|(i&240)<<8}function ox(n,e,t){return n>>4<<8|e&240|t>>4}function lh(n,e,t){return n<e?e:n>t?t:n}function yc(n){return n*n}function ex(n,e,t){var i=0,r=1e100;let s=n[e],o=s.cnt,a=s.ac,l=s.rc,c=s.gc,h=s.bc;for(var d=s.fw;d!=0;d=n[d].fw){let p=n[d],m=p.cnt,_=o*m/(o+m);if(!(_>=r)){var f=0;t&&(f+=_*yc(p.ac-a),f>=r)||(f+=_*yc(p.rc-l),!(f>=r)&&(f+=_*yc(p.gc-c),!(f>=r)&&(f+=_*yc(p.bc-h),!(f>=r)&&(r=f,i=d))))}}s.err=r,s.nn=i}function Rm(){return{ac:0,rc:0,gc:0,bc:0,cnt:0,nn:0,fw:0,bk:0,tm:0,mtm:0,err:0}}function GA(n,e){let t=e==="rgb444"?4096:65536,i=new Array(t),r=n.length;if(e==="rgba4444")for(let s=0;s<r;++s){let o=n[s],a=o>>24&255,l=o>>16&255,c=o>>8&255,h=o&255,d=sx(h,c,l,a),f=d in i?i[d]:i[d]=Rm();f.rc+=h,f.gc+=c,f.bc+=l,f.ac+=a,f.cnt++}else if(e==="rgb444")for(let s=0;s<r;++s){let o=n[s],a=o>>16&255,l=o>>8&255,c=o&255,h=ox(c,l,a),d=h in i?i[h]:i[h]=Rm();d.rc+=c,d.gc+=l,d.bc+=a,d.cnt++}else for(let s=0;s<r;++s){let o=n[s],a=o>>16&255,l=o>>8&255,c=o&255,h=rx(c,l,a),d=h in i?i[h]:i[h]=Rm();d.rc+=c,d.gc+=l,d.bc+=a,d.cnt++}return i}function VA(n,e,t={}){let{format:i="rgb565",clearAlpha:r=!0,clearAlphaColor:s=0,clearAlphaThreshold:o=0,oneBitAlpha:a=!1}=t;if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");let l=new Uint32Array(n.buffer),c=t.useSqrt!==!1,h=i==="rgba4444",d=GA(l,i),f=d.length,p=f-1,m=new Uint32Array(f+1);for(var _=0,g=0;g<f;++g){let H=d[g];if(H!=null){var v=1/H.cnt;h&&(H.ac*=v),H.rc*=v,H.gc*=v,H.bc*=v,d[_++]=H}}yc(e)/_<.022&&(c=!1);for(var g=0;g<_-1;++g)d[g].fw=g+1,d[g+1].bk=g,c&&(d[g].cnt=Math.sqrt(d[g].cnt));c&&(d[g].cnt=Math.sqrt(d[g].cnt));var x,A,S;for(g=0;g<_;++g){ex(d,g,!1);var P=d[g].err;for(A=++m[0];A>1&&(S=A>>1,!(d[x=m[S]].err<=P));A=S)m[A]=x;m[A]=g}var C=_-e;for(g=0;g<C;){for(var y;;){var T=m[1];if(y=d[T],y.tm>=y.mtm&&d[y.nn].mtm<=y.tm)break;y.mtm==p?T=m[1]=m[m[0]--]:(ex(d,T,!1),y.tm=g);var P=d[T].err;for(A=1;(S=A+A)<=m[0]&&(S<m[0]&&d[m[S]].err>d[m[S+1]].err&&S++,!(P<=d[x=m[S]].err));A=S)m[A]=x;m[A]=T}var U=d[y.nn],D=y.cnt,L=U.cnt,v=1/(D+L);h&&(y.ac=v*(D*y.ac+L*U.ac)),y.rc=v*(D*y.rc+L*U.rc),y.gc=v*(D*y.gc+L*U.gc),y.bc=v*(D*y.bc+L*U.bc),y.cnt+=U.cnt,y.mtm=++g,d[U.bk].fw=U.fw,d[U.fw].bk=U.bk,U.mtm=p}let B=[];var G=0;for(g=0;;++G){let F=lh(Math.round(d[g].rc),0,255),H=lh(Math.round(d[g].gc),0,255),Y=lh(Math.round(d[g].bc),0,255),V=255;h&&(V=lh(Math.round(d[g].ac),0,255),a&&(V=V<=(typeof a=="number"?a:127)?0:255),r&&V<=o&&(F=H=Y=s,V=0));let le=h?[F,H,Y,V]:[F,H,Y];if(HA(B,le)||B.push(le),(g=d[g].fw)==0)break}return B}function HA(n,e){for(let t=0;t<n.length;t++){let i=n[t],r=i[0]===e[0]&&i[1]===e[1]&&i[2]===e[2],s=i.length>=4&&e.length>=4?i[3]===e[3]:!0;if(r&&s)return!0}return!1}function uh(n,e){var t=0,i;for(i=0;i<n.length;i++){let r=n[i]-e[i];t+=r*r}return t}function ch(n,e){return e>1?Math.round(n/e)*e:n}function WA(n,{roundRGB:e=5,roundAlpha:t=10,oneBitAlpha:i=null}={}){let r=new Uint32Array(n.buffer);for(let s=0;s<r.length;s++){let o=r[s],a=o>>24&255,l=o>>16&255,c=o>>8&255,h=o&255;a=ch(a,t),i&&(a=a<=(typeof i=="number"?i:127)?0:255),h=ch(h,e),c=ch(c,e),l=ch(l,e),r[s]=a<<24|l<<16|c<<8|h<<0}}function qA(n,e,t="rgb565"){if(!n||!n.buffer)throw new Error("quantize() expected RGBA Uint8Array data");if(!(n instanceof Uint8Array)&&!(n instanceof Uint8ClampedArray))throw new Error("quantize() expected RGBA Uint8Array data");if(e.length>256)throw new Error("applyPalette() only works with 256 colors or less");let i=new Uint32Array(n.buffer),r=i.length,s=t==="rgb444"?4096:65536,o=new Uint8Array(r),a=new Array(s),l=t==="rgba4444";if(t==="rgba4444")for(let c=0;c<r;c++){let h=i[c],d=h>>24&255,f=h>>16&255,p=h>>8&255,m=h&255,_=sx(m,p,f,d),v=_ in a?a[_]:a[_]=XA(m,p,f,d,e);o[c]=v}else{let c=t==="rgb444"?ox:rx;for(let h=0;h<r;h++){let d=i[h],f=d>>16&255,p=d>>8&255,m=d&255,_=c(m,p,f),v=_ in a?a[_]:a[_]=$A(m,p,f,e);o[h]=v}}return o}function XA(n,e,t,i,r){let s=0,o=1e100;for(let a=0;a<r.length;a++){let l=r[a],c=l[3],h=Jo(c-i);if(h>o)continue;let d=l[0];if(h+=Jo(d-n),h>o)continue;let f=l[1];if(h+=Jo(f-e),h>o)continue;let p=l[2];h+=Jo(p-t),!(h>o)&&(o=h,s=a)}return s}function $A(n,e,t,i){let r=0,s=1e100;for(let o=0;o<i.length;o++){let a=i[o],l=a[0],c=Jo(l-n);if(c>s)continue;let h=a[1];if(c+=Jo(h-e),c>s)continue;let d=a[2];c+=Jo(d-t),!(c>s)&&(s=c,r=o)}return r}function YA(n,e,t=5){if(!n.length||!e.length)return;let i=n.map(o=>o.slice(0,3)),r=t*t,s=n[0].length;for(let o=0;o<e.length;o++){let a=e[o];a.length<s?a=[a[0],a[1],a[2],255]:a.length>s?a=a.slice(0,3):a=a.slice();let l=lx(i,a.slice(0,3),uh),c=l[0],h=l[1];h>0&&h<=r&&(n[c]=a)}}function Jo(n){return n*n}function ax(n,e,t=uh){let i=1/0,r=-1;for(let s=0;s<n.length;s++){let o=n[s],a=t(e,o);a<i&&(i=a,r=s)}return r}function lx(n,e,t=uh){let i=1/0,r=-1;for(let s=0;s<n.length;s++){let o=n[s],a=t(e,o);a<i&&(i=a,r=s)}return[r,i]}function KA(n,e,t=uh){return n[ax(n,e,t)]}function cx(n={}){let{initialCapacity:e=4096,auto:t=!0}=n,i=ix(e),r=5003,s=new Uint8Array(256),o=new Int32Array(r),a=new Int32Array(r),l=!1;return{reset(){i.reset(),l=!1},finish(){i.writeByte(OA.trailer)},bytes(){return i.bytes()},bytesView(){return i.bytesView()},get buffer(){return i.buffer},get stream(){return i},writeHeader:c,writeFrame(h,d,f,p={}){let{transparent:m=!1,transparentIndex:_=0,delay:v=0,palette:g=null,repeat:x=0,colorDepth:A=8,dispose:S=-1}=p,P=!1;if(t?l||(P=!0,c(),l=!0):P=!!p.first,d=Math.max(0,Math.floor(d)),f=Math.max(0,Math.floor(f)),P){if(!g)throw new Error("First frame must include a { palette } option");JA(i,d,f,g,A),tx(i,g),x>=0&&jA(i,x)}let C=Math.round(v/10);ZA(i,S,C,m,_);let y=!!g&&!P;QA(i,d,f,y?g:null),y&&tx(i,g),eC(i,h,d,f,A,s,o,a)}};function c(){ux(i,"GIF89a")}}function ZA(n,e,t,i,r){n.writeByte(33),n.writeByte(249),n.writeByte(4),r<0&&(r=0,i=!1);var s,o;i?(s=1,o=2):(s=0,o=0),e>=0&&(o=e&7),o<<=2,n.writeByte(0|o|0|s),io(n,t),n.writeByte(r||0),n.writeByte(0)}function JA(n,e,t,i,r=8){let a=Im(i.length)-1,l=128|r-1<<4|0|a,c=0,h=0;io(n,e),io(n,t),n.writeBytes([l,c,h])}function jA(n,e){n.writeByte(33),n.writeByte(255),n.writeByte(11),ux(n,"NETSCAPE2.0"),n.writeByte(3),n.writeByte(1),io(n,e),n.writeByte(0)}function tx(n,e){let t=1<<Im(e.length);for(let i=0;i<t;i++){let r=[0,0,0];i<e.length&&(r=e[i]),n.writeByte(r[0]),n.writeByte(r[1]),n.writeByte(r[2])}}function QA(n,e,t,i){if(n.writeByte(44),io(n,0),io(n,0),io(n,e),io(n,t),i){let o=Im(i.length)-1;n.writeByte(128|o)}else n.writeByte(0)}function eC(n,e,t,i,r=8,s,o,a){zA(t,i,e,r,n,s,o,a)}function io(n,e){n.writeByte(e&255),n.writeByte(e>>8&255)}function ux(n,e){for(var t=0;t<e.length;t++)n.writeByte(e.charCodeAt(t))}function Im(n){return Math.max(Math.ceil(Math.log2(n)),1)}var tC=cx});var Pt,Iv,Lp,$s,Rp,Pu,Lv,Au,Dv,Dp,Ip,X1,tc=Symbol.for("pv"),Ru={},Iu=[],$1=/^m(i|n|o|s|text|space)$/,Np=Array.isArray,Fp=Iu.slice,zo=Object.assign;function Bo(n){n&&n.parentNode&&n.remove()}function Nv(n,e,t){var i,r,s,o={},a=arguments.length;for(s in e)s=="key"?i=e[s]:s=="ref"&&typeof n!="function"?r=e[s]:o[s]=e[s];return a>2&&(o.children=a>3?Fp.call(arguments,2):t),ec(n,o,i,r,null)}function ec(n,e,t,i,r){var s={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:tc,__v:r||++Iv,__i:-1,__u:0};return!r&&Pt.vnode&&Pt.vnode(s),s}function ot(n){return n.children}function Da(n,e){this.props=n,this.context=e,this.__g=0}function Ys(n,e){if(e==null)return n.__&&Ys(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Ys(n)}function Y1(n){var e,t=n.__v,i=t.__e,r=[],s=[],o=n.__P;o&&((e=zo({constructor:tc},t)).__v=t.__v+1,Pt.vnode&&Pt.vnode(e),Up(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,r,i||Ys(t),32&t.__u,s),e.__v=t.__v,e.__.__k[e.__i]=e,zv(r,e,s),t.__=t.__e=null,e.__e!=i&&Fv(e))}function Fv(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Fv(n)}function Pv(n){(8&n.__g||(n.__g|=8,$s.push(n),Pu++))&&Rp==Pt.debounceRendering||((Rp=Pt.debounceRendering)||queueMicrotask)(Uv)}function Uv(){try{for(var n,e=1;$s.length;)$s.length>e&&$s.sort(Lv),n=$s.shift(),e=$s.length,8&n.__g&&Y1(n)}finally{(Pu=$s.length)&&(Rp||queueMicrotask)(Uv)}}function Ov(n,e,t,i,r,s,o,a,l,c,h){var d,f,p,m,_,v,g=i.__k||Iu,x=e.length;for(l=K1(t,e,g,l,x),d=0;d<x;d++)(p=t.__k[d])!=null&&(f=~p.__i&&g[p.__i]||Ru,p.__i=d,v=Up(n,p,f,r,s,o,a,l,c,h),m=p.__e,(f.ref!=p.ref||8&f.__u)&&(f.ref&&Op(f.ref,null,p,f),p.ref&&h.push(p.ref,p.__c||m,p)),_=_||m,4&p.__u?(l=kv(p,l,n,!f.__v),f.__e&&(f.__e=null)):typeof p.type=="function"&&v!==void 0?l=v:m&&(l=m.nextSibling),p.__u&=-21);return t.__e=_,l}function K1(n,e,t,i,r){var s,o,a,l,c,h,d,f,p,m=t.length,_=m,v=0,g=0,x=n.__k=Array(r);for(s=0;s<r;s++)(o=e[s])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=x[s]=ec(null,o):Np(o)?o=x[s]=ec(ot,{children:o}):o.constructor===tc&&o.__b?o=x[s]=ec(o.type,o.props,o.key,o.ref,o.__v):x[s]=o,l=s+v,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Z1(o,t,l,_))&&(_--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?v--:c==l+1?v++:c!=l&&(c>l?v--:v++,g=1)):(~c||(r>m?v--:r<m&&v++),typeof o.type!="function"&&(o.__u|=4))):x[s]=null;if(g){for(h=[],d=[],s=0;s<r;s++)if((o=x[s])&&16&o.__u){for(v=0,f=h.length;v<f;)h[p=v+f>>1]<o.__i?v=p+1:f=p;h[v]=o.__i,d[s]=v+1}for(v=h.length;s--;)d[s]&&(d[s]==v?v--:x[s].__u|=4)}if(_)for(s=0;s<m;s++)!(a=t[s])||2&a.__u||(a.__e==i&&(i=Ys(a)),kp(a,a));return i}function kv(n,e,t,i){var r,s,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(r=n.__k)for(s=0;s<r.length;s++)r[s]&&(r[s].__=n,e=kv(r[s],e,t,!1));return e}for(e&&!e.parentNode&&(e=Ys(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Z1(n,e,t,i){var r,s=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&s==null||l&&s==a.key&&o==a.type)return t;if(i>(l?1:0)){for(r=t-1;r>=0;r--)if((a=e[r])&&!(2&a.__u)&&s==a.key&&o==a.type)return r;for(r=t+1;r<e.length;r++)if((a=e[r])&&!(2&a.__u)&&s==a.key&&o==a.type)return r}return-1}function Rv(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Eu(n,e,t,i,r){var s,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Rv(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Rv(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Ip[e]||(Ip[e]=J1(e)),(n.__a||(n.__a={}))[e]=Dp,s=e!=(e=e.replace(Dv,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,s):n.removeEventListener(e,o,s));else{if(r=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function J1(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Au]==null)e[Au]=Dp++;else if(e[Au]<this.__a[n])return;return t(Pt.event?Pt.event(e):e)}}}function Up(n,e,t,i,r,s,o,a,l,c){var h,d,f,p,m,_,v,g,x,A,S,P,C,y,T,U,D,L,B=e.type;if(e.constructor!==tc)return null;128&t.__u&&(l=32&t.__u,h=t.__c.__z)&&(e.__u|=l,d=s=[],h.nodeType==8?a=Cu(h,s):s.push(h),a=s[0]||a),(h=Pt.__b)&&h(e);e:if(typeof B=="function"){f=o.length;try{if(g=e.props,x=(h=B.prototype)&&h.render,A=(h=B.contextType)&&i[h.__c],S=h?A?A.props.value:h.__:i,(p=t.__c)?(e.__c=p,2&p.__g&&(p.__g|=1)):(x?e.__c=p=new B(g,S):(e.__c=p=new Da(g,S),p.constructor=B,p.render=Q1),A&&A.sub(p),p.state||(p.state={}),p.__n=i,p.__g|=8,p.__h=[],p.__k=[]),x&&(p.__s||(p.__s=p.state),B.getDerivedStateFromProps&&(p.__s==p.state&&(p.__s=zo({},p.__s)),zo(p.__s,B.getDerivedStateFromProps(g,p.__s)))),m=p.props,_=p.state,p.__v=e,t.__c){if(g!==m&&x&&!B.getDerivedStateFromProps&&p.componentWillReceiveProps&&p.componentWillReceiveProps(g,S),e.__v==t.__v&&!(8&p.__g)||!(4&p.__g)&&p.shouldComponentUpdate&&p.shouldComponentUpdate(g,p.__s,S)===!1){e.__v!=t.__v&&(p.props=g,p.state=p.__s,p.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(G){G&&(G.__=e)}),Iu.push.apply(p.__h,p.__k),p.__k=[],p.__h.length&&o.push(p),a=Ys(t);break e}p.componentWillUpdate&&p.componentWillUpdate(g,p.__s,S),x&&p.componentDidUpdate&&p.__h.push(function(){p.componentDidUpdate(m,_,v)})}else x&&!B.getDerivedStateFromProps&&p.componentWillMount&&p.componentWillMount(),x&&p.componentDidMount&&p.__h.push(p.componentDidMount);p.context=S,p.props=g,p.__P=n,p.__g&=-5,P=Pt.__r,C=x?25:0;do p.__g&=-9,P&&P(e),h=p.render(p.props,p.state=p.__s,p.context);while(8&p.__g&&++C<25);x&&(Iu.push.apply(p.__h,p.__k),p.__k=[]),p.state=p.__s,p.getChildContext&&(i=zo({},i,p.getChildContext())),x&&t.__c&&p.getSnapshotBeforeUpdate&&(v=p.getSnapshotBeforeUpdate(m,_)),y=h&&h.type===ot&&h.key==null?h.props.children:h,g.__P&&(h=a,r=(n=g.__P).namespaceURI,l=s=null,t.props&&t.props.__P!=n&&(t.__k.some(function(G){G&&kp(G,G)}),t.__k=null),a=t.__k?Ys(t,0):null),a=Ov(n,Np(y)?y:[y],e,t,i,r,s,o,a,l,c),g.__P&&(e.__e=null,a=h),e.__u&=-161,d&&d.some(Bo),p.__h.length&&o.push(p),1&p.__g&&(p.__g&=-4)}catch(G){if(o.length=f,e.__v=null,l||s)if(G&&G.then){if(e.__u|=128|l,s){for(~(D=s.indexOf(a||void 0))||(D=s.length);(L=s[D-1])&&L.nodeType==8;)D--;for(;D<s.length;D++)if(L=s[D])if(s[D]=null,T){if(L==U)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(U=Cu(T=L))}}if(!T){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;T=a}(h=Cu(T=e.__c.__z||(e.__c.__z=T)))?(e.__e=T,a=h):e.__e=a,a=a&&a.nextSibling}else s&&s.some(Bo);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),G&&G.then||Bv(e),Pt.__e(G,e,t)}}else a=e.__e=j1(t.__e,e,t,i,r,s,o,l,c,n);return(h=Pt.diffed)&&h(e),a}function Cu(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Bv(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Bv))}function zv(n,e,t){for(var i=0;i<t.length;)Op(t[i++],t[i++],t[i++]);Pt.__c&&Pt.__c(e,n),n.some(function(r){try{n=r.__h,r.__h=[],n.some(function(s){s.call(r)})}catch(s){Pt.__e(s,r.__v)}})}function j1(n,e,t,i,r,s,o,a,l,c){var h,d,f,p,m,_,v,g,x=t.props||Ru,A=e.props,S=e.type;if(S=="svg"?r="http://www.w3.org/2000/svg":S=="math"?r="http://www.w3.org/1998/Math/MathML":r||(r="http://www.w3.org/1999/xhtml"),s){for(h=0;h<s.length;h++)if((m=s[h])&&(S?m.localName==S:m.nodeType==3)){n=m,s[h]=null;break}}if(!n){if(g=c.ownerDocument||document,!S)return g.createTextNode(A);n=g.createElementNS(r,S,A.is?A:c),a&&(Pt.__m&&Pt.__m(e,s),a=!1),s=null}if(S){if(c=S=="template"&&n.content||n,s=S=="textarea"&&A.defaultValue!=null?null:s&&Fp.call(c.childNodes),!a&&s)for(x={},h=0;h<n.attributes.length;h++)x[(m=n.attributes[h]).name]=m.value;for(h in x)m=x[h],h=="dangerouslySetInnerHTML"?f=m:h=="children"||h in A||h=="value"&&"defaultValue"in A||h=="checked"&&"defaultChecked"in A||Eu(n,h,null,m,r);for(h in A)m=A[h],h=="children"?p=m:h=="dangerouslySetInnerHTML"?d=m:h=="value"?_=m:h=="checked"?v=m:a&&typeof m!="function"||x[h]===m||Eu(n,h,m,x[h],r);d?(a||f&&(d.__html==f.__html||d.__html==n.innerHTML)||(n.innerHTML=d.__html),e.__k=[]):(f&&(n.textContent=""),(S=="foreignObject"||r=="http://www.w3.org/1998/Math/MathML"&&$1.test(S))&&(r="http://www.w3.org/1999/xhtml"),Ov(c,Np(p)?p:[p],e,t,i,r,s,o,s?s[0]:t.__k&&Ys(t,0),a,l),s&&s.some(Bo)),a&&S!="textarea"||(h="value",S=="progress"&&_==null?n.removeAttribute(h):_==null||_===n[h]&&(S!="progress"||_)||Eu(n,h,_,x[h],r),h="checked",v!=null&&v!=n[h]&&Eu(n,h,v,x[h],r))}else x===A||a&&n.data==A||(n.data=A);return n}function Op(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(r){Pt.__e(r,t)}}function kp(n,e,t){var i,r,s,o;if(Pt.unmount&&Pt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||Op(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Pt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&kp(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(r=Cu(i,s=[]))&&(i==n.__e&&s.some(Bo),Bo(r),Bo(i)),t||Bo(n.__e),n.__e=n.__c=n.__=null}function Q1(n,e,t){return this.constructor(n,t)}function nc(n,e){var t,i,r,s;Pt.__&&Pt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=ec(ot,{children:[n]}),r=[],s=[],Up(e,e.__k,i||Ru,Ru,e.namespaceURI,i?null:e.firstChild?Fp.call(e.childNodes):null,r,i?i.__e:e.firstChild,t,s),zv(r,e.__k,s),e.__k.props.children=null}Pt={__e:function(n,e,t,i){for(var r,s,o;e=e.__;)if((r=e.__c)&&!(1&r.__g)){r.__g|=4;try{if((o=(s=r.constructor)&&s.getDerivedStateFromError)&&r.setState(s.getDerivedStateFromError(n)),r.componentDidCatch&&(r.componentDidCatch(n,i||{}),o=1),o&&8&r.__g)return void(r.__g|=2)}catch(a){n=a}}throw Pu=0,n}},Iv=0,Lp=function(n){return n!=null&&n.constructor===tc},Da.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=zo({},this.state)),typeof n=="function"&&(n=n(zo({},t),this.props)),n&&(zo(t,n),this.__v&&(e&&this.__k.push(e),Pv(this)))},Da.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Pv(this))},Da.prototype.render=ot,$s=[],Pu=0,Lv=function(n,e){return n.__v.__b-e.__v.__b},Au=Symbol(),Dv=/(PointerCapture)$|Capture$/i,Dp=0,Ip={},X1=0;var Na,En,Bp,Gv,zp=Object.is,Lu=0,Zv=[],Gp=[],yn=Pt,Vv=yn.__b,Hv=yn.__r,Wv=yn.diffed,qv=yn.__c,Xv=yn.unmount,$v=yn.__;function Du(n,e){yn.__h&&yn.__h(En,n,Lu||e),Lu=0;var t=En.__H||(En.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Rt(n){return Lu=1,eT(Jv,n)}function eT(n,e,t){var i=Du(Na++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Jv(void 0,e),function(s){var o=(i.__N||i.__)[0],a=i.t(o,s);zp(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=En,!En.__f)){En.__f=!0;var r=En.shouldComponentUpdate;En.shouldComponentUpdate=function(s,o,a){var l=this.__H;if(!l)return!0;var c=!1,h=this.props!=s;if(l.__.some(function(f){f.__N&&(c=!0,zp(f.__[0],f.__N[0])||(h=!0))}),r){var d=r.call(this,s,o,a);return c?d||h:d}return!c||h}}return i.__}function mt(n,e){var t=Du(Na++,3);!yn.__s&&Hp(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,En.__H.__h.push(t))}function Li(n,e){var t=Du(Na++,4);!yn.__s&&Hp(t.__H,e)&&(t.__P=!1,t.__=n,t.u=e,En.__h.push(t))}function Ke(n){return Lu=5,Ge(function(){return{current:n}},[])}function Ge(n,e){var t=Du(Na++,7);return Hp(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function tT(){var n;do{for(;n=Gp.shift();)try{ic(n)}catch(t){yn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Zv.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(ic),e.__h.some(Vp),e.__h=[]}catch(t){e.__h=[],yn.__e(t,n.__v)}}}while(Gp.length)}yn.__b=function(n){En=null,Vv&&Vv(n)},yn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),$v&&$v(n,e)},yn.__r=function(n){Hv&&Hv(n),Na=0;var e=(En=n.__c).__H;e&&(Bp==En?En.__h=[]:(e.__h.some(ic),e.__h.some(Vp),Na=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Bp=En},yn.diffed=function(n){Wv&&Wv(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Kv(Zv.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Bp=En=null},yn.__c=function(n,e){e.some(function(t){try{t.__h.some(ic),t.__h=t.__h.filter(function(i){return!i.__||Vp(i)})}catch(i){t.__h=[function(){throw i}]}}),qv&&qv(n,e)},yn.unmount=function(n){Xv&&Xv(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(r){try{if(r.__P&&r.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}r.__P=t,Kv(Gp.push(r))}else ic(r)}catch(s){e=s}}),i.__H=void 0,e&&yn.__e(e,i.__v))};var Yv=typeof requestAnimationFrame=="function";function nT(n){var e,t=function(){clearTimeout(i),Yv&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Yv&&(e=requestAnimationFrame(t))}function Kv(n){n!=1&&Gv==yn.requestAnimationFrame||((Gv=yn.requestAnimationFrame)||nT)(tT)}function ic(n){var e=En,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),En=e}function Vp(n){var e=En;n.__c=n.__(),En=e}function Hp(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!zp(t,n[i])})}function Jv(n,e){return typeof e=="function"?e(n):e}var iT=Symbol.for("preact-signals");function Ou(){if(gs>1)gs--;else{var n,e=!1;for((function(){var r=Fu;for(Fu=void 0;r!==void 0;){var s=r.S;if(s.v===r.v)for(var o=s.t;o!==void 0;o=o.x)o.i===r.i&&(o.i=s.i);r=r.o}})();sc!==void 0;){var t=sc;for(sc=void 0,Nu++;t!==void 0;){var i=t.u;if(t.u=void 0,t.f&=-3,!(8&t.f)&&Qv(t))try{t.c()}catch(r){e||(n=r,e=!0)}t=i}}if(Nu=0,gs--,e)throw n}}function ku(n){if(gs>0)return n();Wp=++rT,gs++;try{return n()}finally{Ou()}}var rc,on=void 0;function oc(n){var e=on,t=rc;on=void 0,rc=void 0;try{return n()}finally{on=e,rc=t}}var sc=void 0,gs=0,Nu=0,rT=0,Wp=0,Fu=void 0,Uu=0;function jv(n){if(on!==void 0){var e=n.n;if(e===void 0||e.t!==on)return e={i:0,S:n,p:on.s,n:void 0,t:on,e:void 0,x:void 0,r:e},on.s!==void 0&&(on.s.n=e),on.s=e,n.n=e,32&on.f&&n.S(e),e;if(e.i===-1)return e.i=0,e.n!==void 0&&(e.n.p=e.p,e.p!==void 0&&(e.p.n=e.n),e.p=on.s,e.n=void 0,on.s.n=e,on.s=e),e}}function Ln(n,e){this.v=n,this.i=0,this.n=void 0,this.t=void 0,this.l=0,this.W=e?.watched,this.Z=e?.unwatched,this.name=e?.name}Ln.prototype.brand=iT;Ln.prototype.h=function(){return!0};Ln.prototype.S=function(n){var e=this,t=this.t;t!==n&&n.e===void 0&&(n.x=t,this.t=n,t!==void 0?t.e=n:oc(function(){var i;(i=e.W)==null||i.call(e)}))};Ln.prototype.U=function(n){var e=this;if(this.t!==void 0){var t=n.e,i=n.x;t!==void 0&&(t.x=i,n.e=void 0),i!==void 0&&(i.e=t,n.x=void 0),n===this.t&&(this.t=i,i===void 0&&oc(function(){var r;(r=e.Z)==null||r.call(e)}))}};Ln.prototype.subscribe=function(n){var e=this;return Je(function(){var t=e.value;oc(function(){return n(t)})},{name:"sub"})};Ln.prototype.valueOf=function(){return this.value};Ln.prototype.toString=function(){return this.value+""};Ln.prototype.toJSON=function(){return this.value};Ln.prototype.peek=function(){var n=this;return oc(function(){return n.value})};Object.defineProperty(Ln.prototype,"value",{get:function(){var n=jv(this);return n!==void 0&&(n.i=this.i),this.v},set:function(n){if(n!==this.v){if(Nu>100)throw new Error("Cycle detected");(function(t){gs!==0&&Nu===0&&t.l!==Wp&&(t.l=Wp,Fu={S:t,v:t.v,i:t.i,o:Fu})})(this),this.v=n,this.i++,Uu++,gs++;try{for(var e=this.t;e!==void 0;e=e.x)e.t.N()}finally{Ou()}}}});function re(n,e){return new Ln(n,e)}function Qv(n){for(var e=n.s;e!==void 0;e=e.n)if(e.S.i!==e.i||!e.S.h()||e.S.i!==e.i)return!0;return!1}function e_(n){for(var e=n.s;e!==void 0;e=e.n){var t=e.S.n;if(t!==void 0&&(e.r=t),e.S.n=e,e.i=-1,e.n===void 0){n.s=e;break}}}function t_(n){for(var e=n.s,t=void 0;e!==void 0;){var i=e.p;e.i===-1?(e.S.U(e),i!==void 0&&(i.n=e.n),e.n!==void 0&&(e.n.p=i)):t=e,e.S.n=e.r,e.r!==void 0&&(e.r=void 0),e=i}n.s=t}function Go(n,e){Ln.call(this,void 0,e),this.x=n,this.s=void 0,this.g=Uu-1,this.f=4}Go.prototype=new Ln;Go.prototype.h=function(){if(this.f&=-3,1&this.f)return!1;if((36&this.f)==32||(this.f&=-5,this.g===Uu))return!0;if(this.g=Uu,this.f|=1,this.i>0&&!Qv(this))return this.f&=-2,!0;var n=on;try{e_(this),on=this;var e=this.x();(16&this.f||this.v!==e||this.i===0)&&(this.v=e,this.f&=-17,this.i++)}catch(t){this.v=t,this.f|=16,this.i++}return on=n,t_(this),this.f&=-2,!0};Go.prototype.S=function(n){if(this.t===void 0){this.f|=36;for(var e=this.s;e!==void 0;e=e.n)e.S.S(e)}Ln.prototype.S.call(this,n)};Go.prototype.U=function(n){if(this.t!==void 0&&(Ln.prototype.U.call(this,n),this.t===void 0)){this.f&=-33;for(var e=this.s;e!==void 0;e=e.n)e.S.U(e)}};Go.prototype.N=function(){if(!(2&this.f)){this.f|=6;for(var n=this.t;n!==void 0;n=n.x)n.t.N()}};Object.defineProperty(Go.prototype,"value",{get:function(){if(1&this.f)throw new Error("Cycle detected");var n=jv(this);if(this.h(),n!==void 0&&(n.i=this.i),16&this.f)throw this.v;return this.v}});function Ve(n,e){return new Go(n,e)}function n_(n){var e=n.j;if(n.j=void 0,typeof e=="function"){gs++;var t=on;on=void 0;try{e()}catch(i){throw n.f&=-2,n.f|=8,qp(n),i}finally{on=t,Ou()}}}function qp(n){for(var e=n.s;e!==void 0;e=e.n)e.S.U(e);n.x=void 0,n.s=void 0,n_(n)}function sT(n){if(on!==this)throw new Error("Out-of-order effect");t_(this),on=n,this.f&=-2;try{8&this.f&&qp(this)}finally{Ou()}}function Fa(n,e){this.x=n,this.j=void 0,this.s=void 0,this.u=void 0,this.f=32,this.name=e?.name,rc&&rc.push(this)}Fa.prototype.c=function(){var n=this.S();try{if(8&this.f||this.x===void 0)return;var e=this.x();typeof e=="function"&&(this.j=e)}finally{n()}};Fa.prototype.S=function(){if(1&this.f)throw new Error("Cycle detected");this.f|=1,this.f&=-9,n_(this),e_(this),gs++;var n=on;return on=this,sT.bind(this,n)};Fa.prototype.N=function(){2&this.f||(this.f|=2,this.u=sc,sc=this)};Fa.prototype.d=function(){this.f|=8,1&this.f||qp(this)};Fa.prototype.dispose=function(){this.d()};function Je(n,e){var t=new Fa(n,e);try{t.c()}catch(r){throw t.d(),r}var i=t.d.bind(t);return i[Symbol.dispose]=i,i}var Xp,lc,Bu,oT=typeof window<"u"&&!!window.__PREACT_SIGNALS_DEVTOOLS__,i_=[],r_=[];Je(function(){Xp=this.N})();function Ua(n,e){Pt[n]=e.bind(null,Pt[n]||function(){})}function ac(n){if(Bu){var e=Bu;Bu=void 0,e()}Bu=n&&n.S()}function s_(n){var e=this,t=n.data,i=lT(t);i.name="ReactiveDom",i.value=t;var r=Ge(function(){for(var a=e,l=e.__v;l=l.__;)if(l.__c){l.__c.__$f|=4;break}var c=Ve(function(){var p=i.value.value;return p===0?0:p===!0?"":p||""}),h=Ve(function(){return!Array.isArray(c.value)&&!Lp(c.value)}),d=Je(function(){if(this.N=o_,h.value){var p=c.value;a.__v&&a.__v.__e&&a.__v.__e.nodeType===3&&(a.__v.__e.data=p)}}),f=e.__$u.d;return e.__$u.d=function(){d(),f.call(this)},[h,c]},[]),s=r[0],o=r[1];return s.value?o.peek():o.value}s_.displayName="ReactiveTextNode";Object.defineProperties(Ln.prototype,{constructor:{configurable:!0,value:Nv(ot,null).constructor},type:{configurable:!0,value:s_},props:{configurable:!0,get:function(){var n=this;return{data:{get value(){return n.value}}}}},__b:{configurable:!0,value:1}});Ua("__b",function(n,e){if(ac(),lc=void 0,typeof e.type=="string"){var t,i=e.props;for(var r in i)if(r!=="children"){var s=i[r];s instanceof Ln&&(t||(e.__np=t={}),t[r]=s,i[r]=s.peek())}}n(e)});Ua("__r",function(n,e){if(n(e),e.type!==ot){ac();var t,i=e.__c;i&&(i.__$f&=-2,(t=i.__$u)===void 0&&(i.__$u=t=(function(r,s){var o;return Je(function(){o=this},{name:s}),o.c=r,o})((function(r){return function(){var s;oT&&((s=this.y)==null||s.call(this)),r.__$f|=1,r.setState({})}})(i),typeof e.type=="function"?e.type.displayName||e.type.name:""))),lc=i,ac(t)}});Ua("__e",function(n,e,t,i){ac(),lc=void 0,n(e,t,i)});Ua("diffed",function(n,e){ac(),lc=void 0;var t;if(typeof e.type=="string"&&(t=e.__e)){var i=e.__np,r=e.props,s=t.U;if(s)for(var o in s){var a=s[o];a===void 0||i&&o in i||(a.d(),s[o]=void 0)}if(i){s||(s={},t.U=s);for(var l in i){var c=s[l],h=i[l];c===void 0?(c=aT(t,l,h,r),s[l]=c):c.o(h,r)}}}n(e)});function aT(n,e,t,i){var r=e in n&&n.ownerSVGElement===void 0,s=re(t);return{o:function(o,a){s.value=o,i=a},d:Je(function(){this.N=o_;var o=s.value.value;i[e]!==o&&(i[e]=o,r?n[e]=o:o!=null&&(o!==!1||e[4]==="-")?n.setAttribute(e,o):n.removeAttribute(e))})}}Ua("unmount",function(n,e){if(typeof e.type=="string"){var t=e.__e;if(t){var i=t.U;if(i){t.U=void 0;for(var r in i){var s=i[r];s&&s.d()}}}var o=e.__np;if(o){var a=e.props;for(var l in o)a[l]=o[l]}e.__np=void 0}else{var c=e.__c;if(c){c.__$f|=8;var h=c.__$u;h&&(c.__$u=void 0,h.d())}}n(e)});Ua("__h",function(n,e,t,i){i<3&&(e.__$f|=2),n(e,t,i)});Da.prototype.shouldComponentUpdate=function(n,e){if(this.__R)return!0;var t=this.__$u,i=t&&t.s!==void 0;for(var r in e)return!0;if(this.__f||typeof this.u=="boolean"&&this.u===!0){var s=2&this.__$f;if(!(i||s||4&this.__$f)||1&this.__$f)return!0}else if(!(i||4&this.__$f)||3&this.__$f)return!0;for(var o in n)if(o!=="__source"&&n[o]!==this.props[o])return!0;for(var a in this.props)if(!(a in n))return!0;return!1};function lT(n,e){return Ge(function(){return re(n,e)},[])}var cT=typeof requestAnimationFrame>"u"?setTimeout:function(n){var e=function(){clearTimeout(t),cancelAnimationFrame(i),n()},t=setTimeout(e,35),i=requestAnimationFrame(e)},uT=function(n){queueMicrotask(function(){queueMicrotask(n)})};function hT(){ku(function(){for(var n;n=i_.shift();)Xp.call(n)})}function dT(){i_.push(this)===1&&(Pt.requestAnimationFrame||cT)(hT)}function fT(){ku(function(){for(var n;n=r_.shift();)Xp.call(n)})}function o_(){r_.push(this)===1&&(Pt.requestAnimationFrame||uT)(fT)}function a_(n,e){var t=Ke(n);t.current=n;var i=lc;mt(function(){return Je(function(){if(this.N=dT,!(i&&8&i.__$f))return t.current()},e)},[])}var Oa=re([]);function cc(n,e){let t={title:n,keys:e};return Oa.value=[...Oa.peek(),t],()=>Oa.value=Oa.peek().filter(i=>i!==t)}var Gr=({playing:n})=>({keys:"space",effect:"move or stop",actions:{" ":()=>n.value=!n.value}}),pT="input, textarea, select",mT="button, summary, a";function Vr(n,e){if(n.defaultPrevented||n.ctrlKey||n.metaKey||n.altKey)return;let t=n.target;if(t.closest(pT)!==null||n.key===" "&&t.closest(mT)!==null)return;let i=e.map(r=>r.actions[n.key]).find(r=>r!==void 0);i!==void 0&&(n.preventDefault(),i(n))}var l_=8,gT={"<f8":Float64Array,"<f4":Float32Array,"<i4":Int32Array,"<i2":Int16Array,"|i1":Int8Array},Ks=class n{constructor(e,t,i){this.header=e;this.content=t;this.front=i}header;content;front;static read(e){let t=new DataView(e).getUint32(0,!0),i=new TextDecoder().decode(new Uint8Array(e,4,t)),r=Math.ceil((4+t)/l_)*l_;return new n(JSON.parse(i),e,r)}has(e){return e in this.header.variables}values(e){let{type:t,start:i,shape:r}=this.described(e);if(t===void 0||i===void 0)throw new Error(`${e} has no numbers`);let s=r.reduce((o,a)=>o*a,1);return new gT[t](this.content,this.front+i,s)}scale(e){return this.described(e).scale??1}texts(e){return this.described(e).texts??[]}shape(e){return this.described(e).shape}unit(e){return this.described(e).attrs.units??""}title(e){return this.described(e).attrs.long_name??e}parsed(e){return JSON.parse(String(this.header.attrs[e]))}described(e){let t=this.header.variables[e];if(t===void 0)throw new Error(`the dataset has no variable ${e}`);return t}};var c_=[{name:"Hz",factor:1},{name:"kHz",factor:1e3},{name:"MHz",factor:1e6}],vT=1e4,Vo=re({});function ji(n){let{pitch_m:e,shear_speed_m_per_s:t}=n.header.attrs;return typeof e!="number"||typeof t!="number"?c_:[...c_,{name:"ωa/(2πcₜ)",factor:t/e,relative:!0}]}function Qi(n,e){return n.find(({factor:i,relative:r})=>!r&&e<vT*i)??n[0]}function ka(n){return[{name:"rad/m",factor:1},{name:"π/a",factor:Math.PI/n},{name:"2π/a",factor:2*Math.PI/n}]}var _T=/^[mN](?=$|\/)/,yT=[["",1],["m",.001],["µ",1e-6],["n",1e-9]];function u_(n,e){let t=yT.find(([,s])=>_T.test(n)&&e>=s),[i,r]=t??["",1];return{name:i+n,factor:r}}function Kn(n,{name:e,relative:t}){return t?`${e} = ${n}`:`${n} ${e}`}function Yt(n,{name:e,relative:t}){return t?e:`${n} / ${e.includes("/")?`(${e})`:e}`}function Hr(n){return`${Number(n.toPrecision(6))}`}var xT=Symbol.for("pv"),bT=0;function u(n,e,t,i,r,s){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:xT,__v:--bT,__i:-1,__u:0};return(r||s)&&(c.__source=r,c.__self=s),Pt.vnode&&Pt.vnode(c),c}function er({title:n,units:e,unit:t}){let{value:i}=t,r=e[0]?.name??"";return mt(()=>{Vo.value={...Vo.peek(),[r]:i}},[r,i]),mt(()=>()=>{let{[r]:s,...o}=Vo.peek();Vo.value=o},[r]),u("label",{children:[n," ",u("select",{value:i.name,onChange:({currentTarget:s})=>t.value=e[s.selectedIndex]??t.value,children:e.map(({name:s})=>u("option",{children:s}))})]})}function Ho({playing:n}){return u("button",{type:"button",onClick:()=>n.value=!n.value,children:n.value?"Stop":"Move"})}function Ba({playing:n,pace:e}){return u("div",{class:"controls",children:[u(Ho,{playing:n}),u(uc,{pace:e})]})}function uc({pace:n}){return u("label",{children:["pace, cycles per second: ",n.value.toFixed(1),u("input",{type:"range",min:"0.1",max:"3",step:"0.1",value:n.value,onInput:e=>n.value=Number(e.currentTarget.value)})]})}function _i({facts:n}){return u("dl",{children:n.filter(([,e])=>e).map(([e,t])=>u("div",{children:[u("dt",{children:e}),u("dd",{children:t})]}))})}var ST="⁰¹²³⁴⁵⁶⁷⁸⁹";function Wr(n){let e=n.replace(/(?<=\d)e([+-]?\d+)\b/g,(t,i)=>`×${zu(Number(i))}`);return Di(e)}function Di(n){return n.replace(/(?<![\w.)])-(?=\.?\d)/g,"−")}function zu(n){let e=Array.from(String(Math.abs(n)),t=>ST[Number(t)]);return`10${n<0?"⁻":""}${e.join("")}`}function Zs(n){let[e="",t]=String(Number(n.toPrecision(12))).split("e");return Di(e)+(t===void 0?"":`×${zu(Number(t))}`)}function Ht(n,e){if(!(Number.isFinite(e)&&e>0))return Di(n.toFixed(3));e=Math.max(e,10**-6);let t=Math.floor(Math.log10(e)+1e-9);e<2*10**t&&(t-=1);let i=Math.ceil(e/10**t-1e-9);i===10&&([i,t]=[1,t+1]);let r=Math.min(Math.max(-t,0),6),s=10**Math.max(t,0),o=s>1?Math.round(n/s)*s:n;return`${Di(o.toFixed(r))} ± ${(i*10**t).toFixed(r)}`}var mr=n=>String(n.header.attrs.origin??"simulated");function ui({name:n,data:e,keys:t,foot:i,isOld:r=!1,children:s}){mt(()=>cc(e.header.title,t),[e,t]);let o=e.header.extra.summary??[];return u("div",{class:n,tabIndex:-1,onKeyDown:a=>Vr(a,t),children:[u("header",{children:[u("h1",{children:e.header.title}),u("p",{class:"origin",children:mr(e)}),u("div",{class:r?"old":"",children:o.map(a=>u("p",{children:Wr(a)}))})]}),s,u("footer",{children:u("p",{children:["haptonic ",String(e.header.attrs.haptonic_version??""),". ",i]})})]})}function yi(n){return[{keys:"t",effect:"tables",actions:{t:()=>$p(n,"table")}},{keys:"?",effect:"this list",actions:{"?":()=>$p(n,"keys")}}]}function $p(n,e){n.value=n.value===e?"none":e}function xi({listing:n,keys:e,children:t}){let i=Ke(null);return a_(()=>{n.value!=="none"&&i.current?.focus()}),u("section",{"aria-label":"Tables and keys",children:[u("p",{class:"opened",children:[["table","Tables"],["keys","Keys"]].map(([s,o])=>u("button",{type:"button","aria-expanded":n.value===s,onClick:()=>$p(n,s),children:o}))}),u("div",{ref:i,tabIndex:-1,children:[n.value==="table"&&t,n.value==="keys"&&u(hc,{title:"Keys",keys:e})]})]})}function hc({title:n,keys:e}){return u("table",{children:[n&&u("caption",{children:n}),u("tbody",{children:e.map(({keys:t,effect:i})=>u("tr",{children:[u("th",{scope:"row",children:u("kbd",{children:t})}),u("td",{children:i})]}))})]})}function Gu([n,e],t){let i=Math.hypot(n,e);if(t===void 0)return`${i.toPrecision(3)} m/s`;let r=i>t?` at ${Di(String(Math.round(Math.atan2(e,n)*180/Math.PI)||0))}° from x`:"";return`${Ht(i,t)} m/s${r}`}function Hn({label:n,describedBy:e="point",onKeyDown:t,children:i}){return u("div",{class:"walk",tabIndex:0,role:"application","aria-label":n,"aria-describedby":e,onKeyDown:t,children:i})}var wT="uplot",MT="u-hz",TT="u-vt",ET="u-title",AT="u-wrap",CT="u-under",PT="u-over",RT="u-axis",Xo="u-off",IT="u-select",LT="u-cursor-x",DT="u-cursor-y",NT="u-cursor-pt",FT="u-legend",UT="u-live",OT="u-inline",kT="u-series",BT="u-marker",h_="u-label",zT="u-value",fc="width",pc="height";var d_="bottom",za="left",Yp="right",hm="#000",f_=hm+"0",Kp="mousemove",p_="mousedown",Zp="mouseup",m_="mouseenter",g_="mouseleave",v_="dblclick",GT="resize",VT="scroll",__="change",Xu="dppxchange",dm="--",$a=typeof window<"u",tm=$a?document:null,Va=$a?window:null,HT=$a?navigator:null,Nt,Vu;function nm(){let n=devicePixelRatio;Nt!=n&&(Nt=n,Vu&&rm(__,Vu,nm),Vu=matchMedia(`(min-resolution: ${Nt-.001}dppx) and (max-resolution: ${Nt+.001}dppx)`),$o(__,Vu,nm),Va.dispatchEvent(new CustomEvent(Xu)))}function Ni(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function im(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function en(n,e,t){n.style[e]=t+"px"}function gr(n,e,t,i){let r=tm.createElement(n);return e!=null&&Ni(r,e),t?.insertBefore(r,i),r}function tr(n,e){return gr("div",n,e)}var y_=new WeakMap;function qr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=y_.get(n);s!=o&&(n.style.transform=s,y_.set(n,s),e<0||t<0||e>i||t>r?Ni(n,Xo):im(n,Xo))}var x_=new WeakMap;function b_(n,e,t){let i=e+t,r=x_.get(n);i!=r&&(x_.set(n,i),n.style.background=e,n.style.borderColor=t)}var S_=new WeakMap;function w_(n,e,t,i){let r=e+""+t,s=S_.get(n);r!=s&&(S_.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var fm={passive:!0},WT={...fm,capture:!0};function $o(n,e,t,i){e.addEventListener(n,t,i?WT:fm)}function rm(n,e,t,i){e.removeEventListener(n,t,fm)}$a&&nm();function vr(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:Fi((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function J_(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var j_=n=>n!=null,Q_=n=>n!=null&&n>0,Ku=J_(j_),qT=J_(Q_);function XT(n,e,t,i=0,r=!1){let s=r?qT:Ku,o=r?Q_:j_;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??qt,l??-qt]}function Zu(n,e,t,i){let r=E_(n),s=E_(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?vs:ey,a=r==1?Fi:nr,l=s==1?nr:Fi,c=a(o(Nn(n))),h=l(o(Nn(e))),d=Ha(t,c),f=Ha(t,h);return t==10&&(c<0&&(d=Xt(d,-c)),h<0&&(f=Xt(f,-h))),i||t==2?(n=d*r,e=f*s):(n=ry(n,d),e=Ju(e,f)),[n,e]}function pm(n,e,t,i){let r=Zu(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var mm=.1,M_={mode:3,pad:mm},gc={pad:0,soft:null,mode:0},$T={min:gc,max:gc};function $u(n,e,t,i){return ju(t)?T_(n,e,t):(gc.pad=t,gc.soft=i?0:null,gc.mode=i?3:0,T_(n,e,$T))}function Lt(n,e){return n??e}function YT(n,e,t){for(e=Lt(e,0),t=Lt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function T_(n,e,t){let i=t.min,r=t.max,s=Lt(i.pad,0),o=Lt(r.pad,0),a=Lt(i.hard,-qt),l=Lt(r.hard,qt),c=Lt(i.soft,qt),h=Lt(r.soft,-qt),d=Lt(i.mode,0),f=Lt(r.mode,0),p=e-n,m=vs(p),_=hi(Nn(n),Nn(e)),v=vs(_),g=Nn(v-m);(p<1e-24||g>10)&&(p=0,(n==0||e==0)&&(p=1e-24,d==2&&c!=qt&&(s=0),f==2&&h!=-qt&&(o=0)));let x=p||_||1e3,A=vs(x),S=Ha(10,Fi(A)),P=x*(p==0?n==0?.1:1:s),C=Xt(ry(n-P,S/10),24),y=n>=c&&(d==1||d==3&&C<=c||d==2&&C>=c)?c:qt,T=hi(a,C<y&&n>=y?y:_r(y,C)),U=x*(p==0?e==0?.1:1:o),D=Xt(Ju(e+U,S/10),24),L=e<=h&&(f==1||f==3&&D>=h||f==2&&D<=h)?h:-qt,B=_r(l,D>L&&e<=L?L:hi(L,D));return T==B&&T==0&&(B=100),[T,B]}var KT=new Intl.NumberFormat($a?HT.language:"en-US"),gm=n=>KT.format(n),Ui=Math,qu=Ui.PI,Nn=Ui.abs,Fi=Ui.floor,Dn=Ui.round,nr=Ui.ceil,_r=Ui.min,hi=Ui.max,Ha=Ui.pow,E_=Ui.sign,vs=Ui.log10,ey=Ui.log2,ZT=(n,e=1)=>Ui.sinh(n)*e,Jp=(n,e=1)=>Ui.asinh(n/e),qt=1/0;function A_(n){return(vs((n^n>>31)-(n>>31))|0)+1}function sm(n,e,t){return _r(hi(n,e),t)}function ty(n){return typeof n=="function"}function Mt(n){return ty(n)?n:()=>n}var JT=()=>{},ny=n=>n,iy=(n,e)=>e,jT=n=>null,C_=n=>!0,P_=(n,e)=>n==e,QT=/\.\d*?(?=9{6,}|0{6,})/gm,Yo=n=>{if(oy(n)||js.has(n))return n;let e=`${n}`,t=e.match(QT);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${Yo(r)}e${s}`}return Xt(n,i)};function Wo(n,e){return Yo(Xt(Yo(n/e))*e)}function Ju(n,e){return Yo(nr(Yo(n/e))*e)}function ry(n,e){return Yo(Fi(Yo(n/e))*e)}function Xt(n,e=0){if(oy(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Dn(i)/t}var js=new Map;function sy(n){return((""+n).split(".")[1]||"").length}function _c(n,e,t,i){let r=[],s=i.map(sy);for(let o=e;o<t;o++){let a=Nn(o),l=Xt(Ha(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=n==10?h:Xt(h,d);r.push(f),js.set(f,d)}}return r}var vc={},vm=[],Wa=[null,null],Js=Array.isArray,oy=Number.isInteger,eE=n=>n===void 0;function R_(n){return typeof n=="string"}function ju(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function tE(n){return n!=null&&typeof n=="object"}var nE=Object.getPrototypeOf(Uint8Array),ay="__proto__";function qa(n,e=ju){let t;if(Js(n)){let i=n.find(r=>r!=null);if(Js(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=qa(n[r],e)}else t=n.slice()}else if(n instanceof nE)t=n.slice();else if(e(n)){t={};for(let i in n)i!=ay&&(t[i]=qa(n[i],e))}else t=n;return t}function An(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=ay&&(ju(n[r])?An(n[r],qa(i[r])):n[r]=qa(i[r]))}return n}var iE=0,rE=1,sE=2;function oE(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function aE(n,e){if(uE(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return hE(o[0])||(o=cE(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)t.add(l[h])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],d=Array(r).fill(void 0),f=e?e[o][c]:rE,p=[];for(let m=0;m<h.length;m++){let _=h[m],v=s.get(l[m]);_===null?f!=iE&&(d[v]=_,f==sE&&p.push(v)):d[v]=_}oE(d,p,r),i.push(d)}}return i}var lE=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function cE(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function uE(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function hE(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=hi(1,Fi((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var ly=["January","February","March","April","May","June","July","August","September","October","November","December"],cy=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function uy(n){return n.slice(0,3)}var dE=cy.map(uy),fE=ly.map(uy),pE={MMMM:ly,MMM:fE,WWWW:cy,WWW:dE};function dc(n){return(n<10?"0":"")+n}function mE(n){return(n<10?"00":n<100?"0":"")+n}var gE={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>dc(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>dc(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>dc(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>dc(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>dc(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>mE(n.getMilliseconds())};function _m(n,e){e=e||pE;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?gE[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var vE=new Intl.DateTimeFormat().resolvedOptions().timeZone;function _E(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==vE?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var hy=n=>n%1==0,Yu=[1,2,2.5,5],yE=_c(10,-32,0,Yu),dy=_c(10,0,32,Yu),xE=dy.filter(hy),qo=yE.concat(dy),ym=`
`,fy="{YYYY}",I_=ym+fy,py="{M}/{D}",mc=ym+py,Hu=mc+"/{YY}",my="{aa}",bE="{h}:{mm}",Ga=bE+my,L_=ym+Ga,D_=":{ss}",Ut=null;function gy(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?_c(10,0,3,Yu).filter(hy):_c(10,-3,0,Yu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,fy,Ut,Ut,Ut,Ut,Ut,Ut,1],[r*28,"{MMM}",I_,Ut,Ut,Ut,Ut,Ut,1],[r,py,I_,Ut,Ut,Ut,Ut,Ut,1],[i,"{h}"+my,Hu,Ut,mc,Ut,Ut,Ut,1],[t,Ga,Hu,Ut,mc,Ut,Ut,Ut,1],[e,D_,Hu+" "+Ga,Ut,mc+" "+Ga,Ut,L_,Ut,1],[n,D_+".{fff}",Hu+" "+Ga,Ut,mc+" "+Ga,Ut,L_,Ut,1]];function h(d){return(f,p,m,_,v,g)=>{let x=[],A=v>=o,S=v>=s&&v<o,P=d(m),C=Xt(P*n,3),y=jp(P.getFullYear(),A?0:P.getMonth(),S||A?1:P.getDate()),T=Xt(y*n,3);if(S||A){let U=S?v/s:0,D=A?v/o:0,L=C==T?C:Xt(jp(y.getFullYear()+D,y.getMonth()+U,1)*n,3),B=new Date(Dn(L/n)),G=B.getFullYear(),F=B.getMonth();for(let H=0;L<=_;H++){let Y=jp(G+D*H,F+U*H,1),V=Y-d(Xt(Y*n,3));L=Xt((+Y+V)*n,3),L<=_&&x.push(L)}}else{let U=v>=r?r:v,D=Fi(m)-Fi(C),L=T+D+Ju(C-T,U);x.push(L);let B=d(L),G=B.getHours()+B.getMinutes()/t+B.getSeconds()/i,F=v/i,H=f.axes[p]._space,Y=g/H;for(;L=Xt(L+v,n==1?0:3),!(L>_);)if(F>1){let V=Fi(Xt(G+F,6))%24,Q=d(L).getHours()-V;Q>1&&(Q=-1),L-=Q*i,G=(G+F)%24;let se=x[x.length-1];Xt((L-se)/v,3)*Y>=.7&&x.push(L)}else x.push(L)}return x}}return[l,c,h]}var[SE,wE,ME]=gy(1),[TE,EE,AE]=gy(.001);_c(2,-53,53,[1]);function N_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function F_(n,e){return(t,i,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,h,d,f,p;return i.map(m=>{let _=n(m),v=_.getFullYear(),g=_.getMonth(),x=_.getDate(),A=_.getHours(),S=_.getMinutes(),P=_.getSeconds(),C=v!=l&&a[2]||g!=c&&a[3]||x!=h&&a[4]||A!=d&&a[5]||S!=f&&a[6]||P!=p&&a[7]||a[1];return l=v,c=g,h=x,d=A,f=S,p=P,C(_)})}}function CE(n,e){let t=_m(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function jp(n,e,t){return new Date(n,e,t)}function U_(n,e){return e(n)}var PE="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function O_(n,e){return(t,i,r,s)=>s==null?dm:e(n(i))}function RE(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function IE(n,e){return n.series[e].fill(n,e)}var LE={show:!0,live:!0,isolate:!1,mount:JT,markers:{show:!0,width:2,stroke:RE,fill:IE,dash:"solid"},idx:null,idxs:null,values:[]};function DE(n,e){let t=n.cursor.points,i=tr(),r=t.size(n,e);en(i,fc,r),en(i,pc,r);let s=r/-2;en(i,"marginLeft",s),en(i,"marginTop",s);let o=t.width(n,e,r);return o&&en(i,"borderWidth",o),i}function NE(n,e){let t=n.series[e].points;return t._fill||t._stroke}function FE(n,e){let t=n.series[e].points;return t._stroke||t._fill}function UE(n,e){return n.series[e].points.size}var Qp=[0,0];function OE(n,e,t){return Qp[0]=e,Qp[1]=t,Qp}function Wu(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function em(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var kE={show:!0,x:!0,y:!0,lock:!1,move:OE,points:{one:!1,show:DE,size:UE,width:0,stroke:FE,fill:NE},bind:{mousedown:Wu,mouseup:Wu,click:Wu,dblclick:Wu,mousemove:em,mouseleave:em,mouseenter:em},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},vy={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},xm=An({},vy,{filter:iy}),_y=An({},xm,{size:10}),yy=An({},vy,{show:!1}),bm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',xy="bold "+bm,by=1.5,k_={show:!0,scale:"x",stroke:hm,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:xy,side:2,grid:xm,ticks:_y,border:yy,font:bm,lineGap:by,rotate:0},BE="Value",zE="Time",B_={show:!0,scale:"x",auto:!1,sorted:1,min:qt,max:-qt,idxs:[]};function GE(n,e,t,i,r){return e.map(s=>s==null?"":gm(s))}function VE(n,e,t,i,r,s,o){let a=[],l=js.get(r)||0;t=o?t:Xt(Ju(t,r),l);for(let c=t;c<=i;c=Xt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function om(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?vs:ey,h=Fi(c(t));r=Ha(l,h),l==10&&(r=qo[vr(r,qo)]);let d=t,f=r*l;l==10&&(f=qo[vr(f,qo)]);do a.push(d),d=d+r,l==10&&!js.has(d)&&(d=Xt(d,js.get(r))),d>=f&&(r=d,f=r*l,l==10&&(f=qo[vr(f,qo)]));while(d<=i);return a}function HE(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?om(n,e,hi(l,t),i,r):[l],h=i>=0&&t<=0?[0]:[];return(t<-l?om(n,e,hi(l,-i),-t,r):[l]).reverse().map(f=>-f).concat(h,c)}var Sy=/./,WE=/[12357]/,qE=/[125]/,z_=/1/,am=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function XE(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,h=l(10,o),d=l(9,o)-h>=c?Sy:l(7,o)-h>=c?WE:l(5,o)-h>=c?qE:z_;if(d==z_){let f=Nn(l(1,o)-h);if(f<c)return am(e.slice().reverse(),a.distr,d,nr(c/f)).reverse()}return am(e,a.distr,d,1)}function $E(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=Nn(l(1,o)-l(2,o));return c<a?am(e.slice().reverse(),3,Sy,nr(a/c)).reverse():e}function YE(n,e,t,i){return i==null?dm:e==null?"":gm(e)}var G_={show:!0,scale:"y",stroke:hm,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:xy,side:3,grid:xm,ticks:_y,border:yy,font:bm,lineGap:by,rotate:0};function KE(n,e){let t=3+(n||1)*2;return Xt(t*e,3)}function ZE(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Nn(o-s),l=n.series[e],c=a/(l.points.space*Nt);return i[1]-i[0]<=c}var V_={scale:null,auto:!0,sorted:0,min:qt,max:-qt},wy=(n,e,t,i,r)=>r,H_={show:!0,auto:!0,sorted:0,gaps:wy,alpha:1,facets:[An({},V_,{scale:"x"}),An({},V_,{scale:"y"})]},W_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:wy,alpha:1,points:{show:ZE,filter:null},values:null,min:qt,max:-qt,idxs:[],path:null,clip:null};function JE(n,e,t,i,r){return t/10}var My={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},jE=An({},My,{time:!1,ori:1}),q_={};function Ty(n,e){let t=q_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let h=0;h<t.plots.length;h++)t.plots[h]!=r&&t.plots[h].pub(i,r,s,o,a,l,c)}},n!=null&&(q_[n]=t)),t}var Xa=1,lm=2;function Ko(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],h=i==2?o[r.facets[0].scale]:o[n.series[0].scale],d=i==2?o[r.facets[1].scale]:o[r.scale],f=a.left,p=a.top,m=a.width,_=a.height,v=n.valToPosH,g=n.valToPosV;return h.ori==0?t(r,l,c,h,d,v,g,f,p,m,_,eh,Ya,nh,Ay,Py):t(r,l,c,h,d,g,v,p,f,_,m,th,Ka,Mm,Cy,Ry)}function Sm(n,e){let t=0,i=0,r=Lt(n.bands,vm);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function QE(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function _s(n,e,t,i,r,s){return Ko(n,e,(o,a,l,c,h,d,f,p,m,_,v)=>{let g=o.pxRound,x=c.dir*(c.ori==0?1:-1),A=c.ori==0?Ya:Ka,S,P;x==1?(S=t,P=i):(S=i,P=t);let C=g(d(a[S],c,_,p)),y=g(f(l[S],h,v,m)),T=g(d(a[P],c,_,p)),U=g(f(s==1?h.max:h.min,h,v,m)),D=new Path2D(r);return A(D,T,U),A(D,C,U),A(D,C,y),D})}function Qu(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?nh:Mm,l=t;for(let d=0;d<n.length;d++){let f=n[d];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,i,p,i+s),l=f[1]}}let c=t+r-l,h=10;c>0&&a(o,l,i-h/2,c,i+s+h)}return o}function eA(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function wm(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let d=c,f=c;if(r==1)for(;++c<=i&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let p=s(n[d]),m=f==d?p:s(n[f]),_=d-r;p=o<=0&&_>=0&&_<l?s(n[_]):p;let g=f+r;m=o>=0&&g>=0&&g<l?s(n[g]):m,m>=p&&a.push([p,m])}return a}function X_(n){return n==0?ny:n==1?Dn:e=>Wo(e,n)}function Ey(n){let e=n==0?eh:th,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,h=0)=>{c==0&&h==0?i(r,s,o,a,l):(c=_r(c,a/2,l/2),h=_r(h,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,h),t(r,s,o+l,s,o,h),t(r,s,o,s+a,o,c),r.closePath())}}var eh=(n,e,t)=>{n.moveTo(e,t)},th=(n,e,t)=>{n.moveTo(t,e)},Ya=(n,e,t)=>{n.lineTo(e,t)},Ka=(n,e,t)=>{n.lineTo(t,e)},nh=Ey(0),Mm=Ey(1),Ay=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},Cy=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Py=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Ry=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function Iy(n){return(e,t,i,r,s)=>Ko(e,t,(o,a,l,c,h,d,f,p,m,_,v)=>{let{pxRound:g,points:x}=o,A,S;c.ori==0?(A=eh,S=Ay):(A=th,S=Cy);let P=Xt(x.width*Nt,3),C=(x.size-x.width)/2*Nt,y=Xt(C*2,3),T=new Path2D,U=new Path2D,{left:D,top:L,width:B,height:G}=e.bbox;nh(U,D-y,L-y,B+y*2,G+y*2);let F=H=>{if(l[H]!=null){let Y=g(d(a[H],c,_,p)),V=g(f(l[H],h,v,m));A(T,Y+C,V),S(T,Y,V,C,0,qu*2)}};if(s)s.forEach(F);else for(let H=i;H<=r;H++)F(H);return{stroke:P>0?T:null,fill:T,clip:U,flags:Xa|lm}})}function Ly(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var tA=Ly(Ya),nA=Ly(Ka);function Dy(n){let e=Lt(n?.alignGaps,0);return(t,i,r,s)=>Ko(t,i,(o,a,l,c,h,d,f,p,m,_,v)=>{[r,s]=Ku(l,r,s);let g=o.pxRound,x=G=>g(d(G,c,_,p)),A=G=>g(f(G,h,v,m)),S,P;c.ori==0?(S=Ya,P=tA):(S=Ka,P=nA);let C=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xa},T=y.stroke,U=!1;if(s-r>=_*4){let G=de=>t.posToVal(de,c.key,!0),F=null,H=null,Y,V,le,X=x(a[C==1?r:s]),Q=x(a[r]),se=x(a[s]),fe=G(C==1?Q+1:se-1);for(let de=C==1?r:s;de>=r&&de<=s;de+=C){let ee=a[de],ye=(C==1?ee<fe:ee>fe)?X:x(ee),Ce=l[de];ye==X?Ce!=null?(V=Ce,F==null?(S(T,ye,A(V)),Y=F=H=V):V<F?F=V:V>H&&(H=V)):Ce===null&&(U=!0):(F!=null&&P(T,X,A(F),A(H),A(Y),A(V)),Ce!=null?(V=Ce,S(T,ye,A(V)),F=H=Y=V):(F=H=null,Ce===null&&(U=!0)),X=ye,fe=G(X+C))}F!=null&&F!=H&&le!=X&&P(T,X,A(F),A(H),A(Y),A(V))}else for(let G=C==1?r:s;G>=r&&G<=s;G+=C){let F=l[G];F===null?U=!0:F!=null&&S(T,x(a[G]),A(F))}let[L,B]=Sm(t,i);if(o.fill!=null||L!=0){let G=y.fill=new Path2D(T),F=o.fillTo(t,i,o.min,o.max,L),H=A(F),Y=x(a[r]),V=x(a[s]);C==-1&&([V,Y]=[Y,V]),S(G,V,H),S(G,Y,H)}if(!o.spanGaps){let G=[];U&&G.push(...wm(a,l,r,s,C,x,e)),y.gaps=G=o.gaps(t,i,r,s,G),y.clip=Qu(G,c.ori,p,m,_,v)}return B!=0&&(y.band=B==2?[_s(t,i,r,s,T,-1),_s(t,i,r,s,T,1)]:_s(t,i,r,s,T,B)),y})}function iA(n){let e=Lt(n.align,1),t=Lt(n.ascDesc,!1),i=Lt(n.alignGaps,0),r=Lt(n.extend,!1);return(s,o,a,l)=>Ko(s,o,(c,h,d,f,p,m,_,v,g,x,A)=>{[a,l]=Ku(d,a,l);let S=c.pxRound,{left:P,width:C}=s.bbox,y=Q=>S(m(Q,f,x,v)),T=Q=>S(_(Q,p,A,g)),U=f.ori==0?Ya:Ka,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Xa},L=D.stroke,B=f.dir*(f.ori==0?1:-1),G=T(d[B==1?a:l]),F=y(h[B==1?a:l]),H=F,Y=F;r&&e==-1&&(Y=P,U(L,Y,G)),U(L,F,G);for(let Q=B==1?a:l;Q>=a&&Q<=l;Q+=B){let se=d[Q];if(se==null)continue;let fe=y(h[Q]),de=T(se);e==1?U(L,fe,G):U(L,H,de),U(L,fe,de),G=de,H=fe}let V=H;r&&e==1&&(V=P+C,U(L,V,G));let[le,X]=Sm(s,o);if(c.fill!=null||le!=0){let Q=D.fill=new Path2D(L),se=c.fillTo(s,o,c.min,c.max,le),fe=T(se);U(Q,V,fe),U(Q,Y,fe)}if(!c.spanGaps){let Q=[];Q.push(...wm(h,d,a,l,B,y,i));let se=c.width*Nt/2,fe=t||e==1?se:-se,de=t||e==-1?-se:se;Q.forEach(ee=>{ee[0]+=fe,ee[1]+=de}),D.gaps=Q=c.gaps(s,o,a,l,Q),D.clip=Qu(Q,f.ori,v,g,x,A)}return X!=0&&(D.band=X==2?[_s(s,o,a,l,L,-1),_s(s,o,a,l,L,1)]:_s(s,o,a,l,L,X)),D})}function $_(n,e,t,i,r,s,o=qt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let h=Nn(n[l]-n[a]);h<c&&(c=h,o=Nn(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function rA(n){n=n||vc;let e=Lt(n.size,[.6,qt,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=Mt(r),o=1-e[0],a=Lt(e[1],qt),l=Lt(e[2],1),c=Lt(n.disp,vc),h=Lt(n.each,p=>{}),{fill:d,stroke:f}=c;return(p,m,_,v)=>Ko(p,m,(g,x,A,S,P,C,y,T,U,D,L)=>{let B=g.pxRound,G=t,F=i*Nt,H=a*Nt,Y=l*Nt,V,le;S.ori==0?[V,le]=s(p,m):[le,V]=s(p,m);let X=S.dir*(S.ori==0?1:-1),Q=S.ori==0?nh:Mm,se=S.ori==0?h:(Re,Qe,ht,Me,Wt,He,Ze)=>{h(Re,Qe,ht,Wt,Me,Ze,He)},fe=Lt(p.bands,vm).find(Re=>Re.series[0]==m),de=fe!=null?fe.dir:0,ee=g.fillTo(p,m,g.min,g.max,de),ge=B(y(ee,P,L,U)),ye,Ce,we,$e=D,ut=B(g.width*Nt),We=!1,_t=null,ft=null,lt=null,rn=null;d!=null&&(ut==0||f!=null)&&(We=!0,_t=d.values(p,m,_,v),ft=new Map,new Set(_t).forEach(Re=>{Re!=null&&ft.set(Re,new Path2D)}),ut>0&&(lt=f.values(p,m,_,v),rn=new Map,new Set(lt).forEach(Re=>{Re!=null&&rn.set(Re,new Path2D)})));let{x0:$t,size:xn}=c;if($t!=null&&xn!=null){G=1,x=$t.values(p,m,_,v),$t.unit==2&&(x=x.map(ht=>p.posToVal(T+ht*D,S.key,!0)));let Re=xn.values(p,m,_,v);xn.unit==2?Ce=Re[0]*D:Ce=C(Re[0],S,D,T)-C(0,S,D,T),$e=$_(x,A,C,S,D,T,$e),we=$e-Ce+F}else $e=$_(x,A,C,S,D,T,$e),we=$e*o+F,Ce=$e-we;we<1&&(we=0),ut>=Ce/2&&(ut=0),we<5&&(B=ny);let Gt=we>0,kn=$e-we-(Gt?ut:0);Ce=B(sm(kn,Y,H)),ye=(G==0?Ce/2:G==X?0:Ce)-G*X*((G==0?F/2:0)+(Gt?ut/2:0));let Ct={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Rn=We?null:new Path2D,dn=null;if(fe!=null)dn=p.data[fe.series[1]];else{let{y0:Re,y1:Qe}=c;Re!=null&&Qe!=null&&(A=Qe.values(p,m,_,v),dn=Re.values(p,m,_,v))}let bn=V*Ce,k=le*Ce;for(let Re=X==1?_:v;Re>=_&&Re<=v;Re+=X){let Qe=A[Re];if(Qe==null)continue;if(dn!=null){let q=dn[Re]??0;if(Qe-q==0)continue;ge=y(q,P,L,U)}let ht=S.distr!=2||c!=null?x[Re]:Re,Me=C(ht,S,D,T),Wt=y(Lt(Qe,ee),P,L,U),He=B(Me-ye),Ze=B(hi(Wt,ge)),R=B(_r(Wt,ge)),w=Ze-R;if(Qe!=null){let q=Qe<0?k:bn,he=Qe<0?bn:k;We?(ut>0&&lt[Re]!=null&&Q(rn.get(lt[Re]),He,R+Fi(ut/2),Ce,hi(0,w-ut),q,he),_t[Re]!=null&&Q(ft.get(_t[Re]),He,R+Fi(ut/2),Ce,hi(0,w-ut),q,he)):Q(Rn,He,R+Fi(ut/2),Ce,hi(0,w-ut),q,he),se(p,m,Re,He-ut/2,R,Ce+ut,w)}}return ut>0?Ct.stroke=We?rn:Rn:We||(Ct._fill=g.width==0?g._fill:g._stroke??g._fill,Ct.width=0),Ct.fill=We?ft:Rn,Ct})}function sA(n,e){let t=Lt(e?.alignGaps,0);return(i,r,s,o)=>Ko(i,r,(a,l,c,h,d,f,p,m,_,v,g)=>{[s,o]=Ku(c,s,o);let x=a.pxRound,A=V=>x(f(V,h,v,m)),S=V=>x(p(V,d,g,_)),P,C,y;h.ori==0?(P=eh,y=Ya,C=Py):(P=th,y=Ka,C=Ry);let T=h.dir*(h.ori==0?1:-1),U=A(l[T==1?s:o]),D=U,L=[],B=[];for(let V=T==1?s:o;V>=s&&V<=o;V+=T)if(c[V]!=null){let X=l[V],Q=A(X);L.push(D=Q),B.push(S(c[V]))}let G={stroke:n(L,B,P,y,C,x),fill:null,clip:null,band:null,gaps:null,flags:Xa},F=G.stroke,[H,Y]=Sm(i,r);if(a.fill!=null||H!=0){let V=G.fill=new Path2D(F),le=a.fillTo(i,r,a.min,a.max,H),X=S(le);y(V,D,X),y(V,U,X)}if(!a.spanGaps){let V=[];V.push(...wm(l,c,s,o,T,A,t)),G.gaps=V=a.gaps(i,r,s,o,V),G.clip=Qu(V,h.ori,m,_,v,g)}return Y!=0&&(G.band=Y==2?[_s(i,r,s,o,F,-1),_s(i,r,s,o,F,1)]:_s(i,r,s,o,F,Y)),G})}function oA(n){return sA(aA,n)}function aA(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),d=Array(o-1);for(let f=0;f<o-1;f++)h[f]=e[f+1]-e[f],d[f]=n[f+1]-n[f],c[f]=h[f]/d[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(d[f-1]+d[f])/((2*d[f]+d[f-1])/c[f-1]+(d[f]+2*d[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,n[f]+d[f]/3,e[f]+l[f]*d[f]/3,n[f+1]-d[f]/3,e[f+1]-l[f+1]*d[f]/3,n[f+1],e[f+1])}return a}var cm=new Set;function Y_(){for(let n of cm)n.syncRect(!0)}$a&&($o(GT,Va,Y_),$o(VT,Va,Y_,!0),$o(Xu,Va,()=>{tn.pxRatio=Nt}));var lA=Dy(),cA=Iy();function K_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>um(s,o,e,t))}function uA(n,e){return n.map((t,i)=>i==0?{}:An({},e,t))}function um(n,e,t,i){return An({},e==0?t:i,n)}function Ny(n,e,t){return e==null?Wa:[e,t]}var hA=Ny;function dA(n,e,t){return e==null?Wa:$u(e,t,mm,!0)}function Fy(n,e,t,i){return e==null?Wa:Zu(e,t,n.scales[i].log,!1)}var fA=Fy;function Uy(n,e,t,i){return e==null?Wa:pm(e,t,n.scales[i].log,!1)}var pA=Uy;function mA(n,e,t,i,r){let s=hi(A_(n),A_(e)),o=e-n,a=vr(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?js.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Z_(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Dn((t=+r)*Nt))+"px"),[n,e,t]}function gA(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Xt(e[2]*Nt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function tn(n,e,t){let i={mode:Lt(n.mode,1)},r=i.mode;function s(b,M,I,N){let W=M.valToPct(b);return N+I*(M.dir==-1?1-W:W)}function o(b,M,I,N){let W=M.valToPct(b);return N+I*(M.dir==-1?W:1-W)}function a(b,M,I,N){return M.ori==0?s(b,M,I,N):o(b,M,I,N)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=tr(wT);if(n.id!=null&&(c.id=n.id),Ni(c,n.class),n.title){let b=tr(ET,c);b.textContent=n.title}let h=gr("canvas"),d=i.ctx=h.getContext("2d"),f=tr(AT,c);$o("click",f,b=>{b.target===m&&(Jt!=Ca||sn!=Pa)&&Yn.click(i,b)},!0);let p=i.under=tr(CT,f);f.appendChild(h);let m=i.over=tr(PT,f);n=qa(n);let _=+Lt(n.pxAlign,1),v=X_(_);(n.plugins||[]).forEach(b=>{b.opts&&(n=b.opts(i,n)||n)});let g=n.ms||.001,x=i.series=r==1?K_(n.series||[],B_,W_,!1):uA(n.series||[null],H_),A=i.axes=K_(n.axes||[],k_,G_,!0),S=i.scales={},P=i.bands=n.bands||[];P.forEach(b=>{b.fill=Mt(b.fill||null),b.dir=Lt(b.dir,-1)});let C=r==2?x[1].facets[0].scale:x[0].scale,y={axes:ps,series:xt},T=(n.drawOrder||["axes","series"]).map(b=>y[b]);function U(b){let M=b.distr==3?I=>vs(I>0?I:b.clamp(i,I,b.min,b.max,b.key)):b.distr==4?I=>Jp(I,b.asinh):b.distr==100?I=>b.fwd(I):I=>I;return I=>{let N=M(I),{_min:W,_max:J}=b,ce=J-W;return(N-W)/ce}}function D(b){let M=S[b];if(M==null){let I=(n.scales||vc)[b]||vc;if(I.from!=null){D(I.from);let N=An({},S[I.from],I,{key:b});N.valToPct=U(N),S[b]=N}else{M=S[b]=An({},b==C?My:jE,I),M.key=b;let N=M.time,W=M.range,J=Js(W);if((b!=C||r==2&&!N)&&(J&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?M_:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?M_:{mode:1,hard:W[1],soft:W[1]}},J=!1),!J&&ju(W))){let ce=W;W=(pe,be,Ne)=>be==null?Wa:$u(be,Ne,ce)}M.range=Mt(W||(N?hA:b==C?M.distr==3?fA:M.distr==4?pA:Ny:M.distr==3?Fy:M.distr==4?Uy:dA)),M.auto=Mt(J?!1:M.auto),M.clamp=Mt(M.clamp||JE),M._min=M._max=null,M.valToPct=U(M)}}}D("x"),D("y"),r==1&&x.forEach(b=>{D(b.scale)}),A.forEach(b=>{D(b.scale)});for(let b in n.scales)D(b);let L=S[C],B=L.distr,G,F;L.ori==0?(Ni(c,MT),G=s,F=o):(Ni(c,TT),G=o,F=s);let H={};for(let b in S){let M=S[b];(M.min!=null||M.max!=null)&&(H[b]={min:M.min,max:M.max},M.min=M.max=null)}let Y=n.tzDate||(b=>new Date(Dn(b/g))),V=n.fmtDate||_m,le=g==1?ME(Y):AE(Y),X=F_(Y,N_(g==1?wE:EE,V)),Q=O_(Y,U_(PE,V)),se=[],fe=i.legend=An({},LE,n.legend),de=i.cursor=An({},kE,{drag:{y:r==2}},n.cursor),ee=fe.show,ge=de.show,ye=fe.markers;fe.idxs=se,ye.width=Mt(ye.width),ye.dash=Mt(ye.dash),ye.stroke=Mt(ye.stroke),ye.fill=Mt(ye.fill);let Ce,we,$e,ut=[],We=[],_t,ft=!1,lt={};if(fe.live){let b=x[1]?x[1].values:null;ft=b!=null,_t=ft?b(i,1,0):{_:0};for(let M in _t)lt[M]=dm}if(ee)if(Ce=gr("table",FT,c),$e=gr("tbody",null,Ce),fe.mount(i,Ce),ft){we=gr("thead",null,Ce,$e);let b=gr("tr",null,we);gr("th",null,b);for(var rn in _t)gr("th",h_,b).textContent=rn}else Ni(Ce,OT),fe.live&&Ni(Ce,UT);let $t={show:!0},xn={show:!1};function Gt(b,M){if(M==0&&(ft||!fe.live||r==2))return Wa;let I=[],N=gr("tr",kT,$e,$e.childNodes[M]);Ni(N,b.class),b.show||Ni(N,Xo);let W=gr("th",null,N);if(ye.show){let pe=tr(BT,W);if(M>0){let be=ye.width(i,M);be&&(pe.style.border=be+"px "+ye.dash(i,M)+" "+ye.stroke(i,M)),pe.style.background=ye.fill(i,M)}}let J=tr(h_,W);b.label instanceof HTMLElement?J.appendChild(b.label):J.textContent=b.label,M>0&&(ye.show||(J.style.color=b.width>0?ye.stroke(i,M):ye.fill(i,M)),Ct("click",W,pe=>{if(de._lock)return;tt(pe);let be=x.indexOf(b);if((pe.ctrlKey||pe.metaKey)!=fe.isolate){let Ne=x.some((Fe,Oe)=>Oe>0&&Oe!=be&&Fe.show);x.forEach((Fe,Oe)=>{Oe>0&&Or(Oe,Ne?Oe==be?$t:xn:$t,!0,Tn.setSeries)})}else Or(be,{show:!b.show},!0,Tn.setSeries)},!1),nt&&Ct(m_,W,pe=>{de._lock||(tt(pe),Or(x.indexOf(b),Ia,!0,Tn.setSeries))},!1));for(var ce in _t){let pe=gr("td",zT,N);pe.textContent="--",I.push(pe)}return[N,I]}let kn=new Map;function Ct(b,M,I,N=!0){let W=kn.get(M)||{},J=de.bind[b](i,M,I,N);J&&($o(b,M,W[b]=J),kn.set(M,W))}function Rn(b,M,I){let N=kn.get(M)||{};for(let W in N)(b==null||W==b)&&(rm(W,M,N[W]),delete N[W]);b==null&&kn.delete(M)}let dn=0,bn=0,k=0,Re=0,Qe=0,ht=0,Me=Qe,Wt=ht,He=k,Ze=Re,R=0,w=0,q=0,he=0;i.bbox={};let ae=!1,_e=!1,xe=!1,te=!1,ie=!1,me=!1;function O(b,M,I){(I||b!=i.width||M!=i.height)&&oe(b,M),pt(!1),xe=!0,_e=!0,jn()}function oe(b,M){i.width=dn=k=b,i.height=bn=Re=M,Qe=ht=0,Se(),qe();let I=i.bbox;R=I.left=Wo(Qe*Nt,.5),w=I.top=Wo(ht*Nt,.5),q=I.width=Wo(k*Nt,.5),he=I.height=Wo(Re*Nt,.5)}let ne=3;function Te(){let b=!1,M=0;for(;!b;){M++;let I=Ta(M),N=Ur(M);b=M==ne||I&&N,b||(oe(i.width,i.height),_e=!0)}}function ve({width:b,height:M}){O(b,M)}i.setSize=ve;function Se(){let b=!1,M=!1,I=!1,N=!1;A.forEach((W,J)=>{if(W.show&&W._show){let{side:ce,_size:pe}=W,be=ce%2,Ne=W.label!=null?W.labelSize:0,Fe=pe+Ne;Fe>0&&(be?(k-=Fe,ce==3?(Qe+=Fe,N=!0):I=!0):(Re-=Fe,ce==0?(ht+=Fe,b=!0):M=!0))}}),Nr[0]=b,Nr[1]=I,Nr[2]=M,Nr[3]=N,k-=dr[1]+dr[3],Qe+=dr[3],Re-=dr[2]+dr[0],ht+=dr[0]}function qe(){let b=Qe+k,M=ht+Re,I=Qe,N=ht;function W(J,ce){switch(J){case 1:return b+=ce,b-ce;case 2:return M+=ce,M-ce;case 3:return I-=ce,I+ce;case 0:return N-=ce,N+ce}}A.forEach((J,ce)=>{if(J.show&&J._show){let pe=J.side;J._pos=W(pe,J._size),J.label!=null&&(J._lpos=W(pe,J.labelSize))}})}if(de.dataIdx==null){let b=de.hover,M=b.skip=new Set(b.skip??[]);M.add(void 0);let I=b.prox=Mt(b.prox),N=b.bias??=0;de.dataIdx=(W,J,ce,pe)=>{if(J==0)return ce;let be=ce,Ne=I(W,J,ce,pe)??qt,Fe=Ne>=0&&Ne<qt,Oe=L.ori==0?k:Re,ct=de.left,Dt=e[0],It=e[J];if(M.has(It[ce])){be=null;let St=null,et=null,Ye;if(N==0||N==-1)for(Ye=ce;St==null&&Ye-- >0;)M.has(It[Ye])||(St=Ye);if(N==0||N==1)for(Ye=ce;et==null&&Ye++<It.length;)M.has(It[Ye])||(et=Ye);if(St!=null||et!=null)if(Fe){let Qt=St==null?-1/0:G(Dt[St],L,Oe,0),mn=et==null?1/0:G(Dt[et],L,Oe,0),Vn=ct-Qt,Vt=mn-ct;Vn<=Vt?Vn<=Ne&&(be=St):Vt<=Ne&&(be=et)}else be=et==null?St:St==null?et:ce-St<=et-ce?St:et}else Fe&&Nn(ct-G(Dt[ce],L,Oe,0))>Ne&&(be=null);return be}}let tt=b=>{de.event=b};de.idxs=se,de._lock=!1;let ue=de.points;ue.show=Mt(ue.show),ue.size=Mt(ue.size),ue.stroke=Mt(ue.stroke),ue.width=Mt(ue.width),ue.fill=Mt(ue.fill);let ke=i.focus=An({},n.focus||{alpha:.3},de.focus),nt=ke.prox>=0,Pe=nt&&ue.one,dt=[],Zt=[],si=[];function Xl(b,M){let I=ue.show(i,M);if(I instanceof HTMLElement)return Ni(I,NT),Ni(I,b.class),qr(I,-10,-10,k,Re),m.insertBefore(I,dt[M]),I}function Sa(b,M){if(r==1||M>0){let I=r==1&&S[b.scale].time,N=b.value;b.value=I?R_(N)?O_(Y,U_(N,V)):N||Q:N||YE,b.label=b.label||(I?zE:BE)}if(Pe||M>0){b.width=b.width==null?1:b.width,b.paths=b.paths||lA||jT,b.fillTo=Mt(b.fillTo||QE),b.pxAlign=+Lt(b.pxAlign,_),b.pxRound=X_(b.pxAlign),b.stroke=Mt(b.stroke||null),b.fill=Mt(b.fill||null),b._stroke=b._fill=b._paths=b._focus=null;let I=KE(hi(1,b.width),1),N=b.points=An({},{size:I,width:hi(1,I*.2),stroke:b.stroke,space:I*2,paths:cA,_stroke:null,_fill:null},b.points);N.show=Mt(N.show),N.filter=Mt(N.filter),N.fill=Mt(N.fill),N.stroke=Mt(N.stroke),N.paths=Mt(N.paths),N.pxAlign=b.pxAlign}if(ee){let I=Gt(b,M);ut.splice(M,0,I[0]),We.splice(M,0,I[1]),fe.values.push(null)}if(ge){se.splice(M,0,null);let I=null;Pe?M==0&&(I=Xl(b,M)):M>0&&(I=Xl(b,M)),dt.splice(M,0,I),Zt.splice(M,0,0),si.splice(M,0,0)}Gn("addSeries",M)}function xp(b,M){M=M??x.length,b=r==1?um(b,M,B_,W_):um(b,M,{},H_),x.splice(M,0,b),Sa(x[M],M)}i.addSeries=xp;function Su(b){if(x.splice(b,1),ee){fe.values.splice(b,1),We.splice(b,1);let M=ut.splice(b,1)[0];Rn(null,M.firstChild),M.remove()}ge&&(se.splice(b,1),dt.splice(b,1)[0].remove(),Zt.splice(b,1),si.splice(b,1)),Gn("delSeries",b)}i.delSeries=Su;let Nr=[!1,!1,!1,!1];function hs(b,M){if(b._show=b.show,b.show){let I=b.side%2,N=S[b.scale];N==null&&(b.scale=I?x[1].scale:C,N=S[b.scale]);let W=N.time;b.size=Mt(b.size),b.space=Mt(b.space),b.rotate=Mt(b.rotate),Js(b.incrs)&&b.incrs.forEach(ce=>{!js.has(ce)&&js.set(ce,sy(ce))}),b.incrs=Mt(b.incrs||(N.distr==2?xE:W?g==1?SE:TE:qo)),b.splits=Mt(b.splits||(W&&N.distr==1?le:N.distr==3?om:N.distr==4?HE:VE)),b.stroke=Mt(b.stroke),b.grid.stroke=Mt(b.grid.stroke),b.ticks.stroke=Mt(b.ticks.stroke),b.border.stroke=Mt(b.border.stroke);let J=b.values;b.values=Js(J)&&!Js(J[0])?Mt(J):W?Js(J)?F_(Y,N_(J,V)):R_(J)?CE(Y,J):J||X:J||GE,b.filter=Mt(b.filter||(N.distr>=3&&N.log==10?XE:N.distr==3&&N.log==2?$E:iy)),b.font=Z_(b.font),b.labelFont=Z_(b.labelFont),b._size=b.size(i,null,M,0),b._space=b._rotate=b._incrs=b._found=b._splits=b._values=null,b._size>0&&(Nr[M]=!0,b._el=tr(RT,f))}}function ds(b,M,I,N){let[W,J,ce,pe]=I,be=M%2,Ne=0;return be==0&&(pe||J)&&(Ne=M==0&&!W||M==2&&!ce?Dn(k_.size/3):0),be==1&&(W||ce)&&(Ne=M==1&&!J||M==3&&!pe?Dn(G_.size/2):0),Ne}let $l=i.padding=(n.padding||[ds,ds,ds,ds]).map(b=>Mt(Lt(b,ds))),dr=i._padding=$l.map((b,M)=>b(i,M,Nr,0)),fn,vn=null,_n=null,Fr=r==1?x[0].idxs:null,Ci=null,Gs=!1;function Yl(b,M){if(e=b??[],i.data=i._data=e,r==2){fn=0;for(let I=1;I<x.length;I++)fn+=e[I][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Ci=e[0],fn=Ci.length;let I=e;if(B==2){I=e.slice();let N=I[0]=Array(fn);for(let W=0;W<fn;W++)N[W]=W}i._data=e=I}if(pt(!0),Gn("setData"),B==2&&(xe=!0),M!==!1){let I=L;I.auto(i,Gs)?Kl():Ws(C,I.min,I.max),te=te||de.left>=0,me=!0,jn()}}i.setData=Yl;function Kl(){Gs=!0;let b,M;r==1&&(fn>0?(vn=Fr[0]=0,_n=Fr[1]=fn-1,b=e[0][vn],M=e[0][_n],B==2?(b=vn,M=_n):b==M&&(B==3?[b,M]=Zu(b,b,L.log,!1):B==4?[b,M]=pm(b,b,L.log,!1):L.time?M=b+Dn(86400/g):[b,M]=$u(b,M,mm,!0))):(vn=Fr[0]=b=null,_n=Fr[1]=M=null)),Ws(C,b,M)}let wa,Vs,Ma,E,z,j,$,K,Ee,Ie;function Ae(b,M,I,N,W,J){b??=f_,I??=vm,N??="butt",W??=f_,J??="round",b!=wa&&(d.strokeStyle=wa=b),W!=Vs&&(d.fillStyle=Vs=W),M!=Ma&&(d.lineWidth=Ma=M),J!=z&&(d.lineJoin=z=J),N!=j&&(d.lineCap=j=N),I!=E&&d.setLineDash(E=I)}function Le(b,M,I,N){M!=Vs&&(d.fillStyle=Vs=M),b!=$&&(d.font=$=b),I!=K&&(d.textAlign=K=I),N!=Ee&&(d.textBaseline=Ee=N)}function ze(b,M,I,N,W=0){if(N.length>0&&b.auto(i,Gs)&&(M==null||M.min==null)){let J=Lt(vn,0),ce=Lt(_n,N.length-1),pe=I.min==null?XT(N,J,ce,W,b.distr==3):[I.min,I.max];b.min=_r(b.min,I.min=pe[0]),b.max=hi(b.max,I.max=pe[1])}}let rt={min:null,max:null};function yt(){for(let N in S){let W=S[N];H[N]==null&&(W.min==null||H[C]!=null&&W.auto(i,Gs))&&(H[N]=rt)}for(let N in S){let W=S[N];H[N]==null&&W.from!=null&&H[W.from]!=null&&(H[N]=rt)}H[C]!=null&&pt(!0);let b={};for(let N in H){let W=H[N];if(W!=null){let J=b[N]=qa(S[N],tE);if(W.min!=null)An(J,W);else if(N!=C||r==2)if(fn==0&&J.from==null){let ce=J.range(i,null,null,N);J.min=ce[0],J.max=ce[1]}else J.min=qt,J.max=-qt}}if(fn>0){x.forEach((N,W)=>{if(r==1){let J=N.scale,ce=H[J];if(ce==null)return;let pe=b[J];if(W==0){let be=pe.range(i,pe.min,pe.max,J);pe.min=be[0],pe.max=be[1],vn=vr(pe.min,e[0]),_n=vr(pe.max,e[0]),_n-vn>1&&(e[0][vn]<pe.min&&vn++,e[0][_n]>pe.max&&_n--),N.min=Ci[vn],N.max=Ci[_n]}else N.show&&N.auto&&ze(pe,ce,N,e[W],N.sorted);N.idxs[0]=vn,N.idxs[1]=_n}else if(W>0&&N.show&&N.auto){let[J,ce]=N.facets,pe=J.scale,be=ce.scale,[Ne,Fe]=e[W],Oe=b[pe],ct=b[be];Oe!=null&&ze(Oe,H[pe],J,Ne,J.sorted),ct!=null&&ze(ct,H[be],ce,Fe,ce.sorted),N.min=ce.min,N.max=ce.max}});for(let N in b){let W=b[N],J=H[N];if(W.from==null&&(J==null||J.min==null)){let ce=W.range(i,W.min==qt?null:W.min,W.max==-qt?null:W.max,N);W.min=ce[0],W.max=ce[1]}}}for(let N in b){let W=b[N];if(W.from!=null){let J=b[W.from];if(J.min==null)W.min=W.max=null;else{let ce=W.range(i,J.min,J.max,N);W.min=ce[0],W.max=ce[1]}}}let M={},I=!1;for(let N in b){let W=b[N],J=S[N];if(J.min!=W.min||J.max!=W.max){J.min=W.min,J.max=W.max;let ce=J.distr;J._min=ce==3?vs(J.min):ce==4?Jp(J.min,J.asinh):ce==100?J.fwd(J.min):J.min,J._max=ce==3?vs(J.max):ce==4?Jp(J.max,J.asinh):ce==100?J.fwd(J.max):J.max,M[N]=I=!0}}if(I){x.forEach((N,W)=>{r==2?W>0&&M.y&&(N._paths=null):M[N.scale]&&(N._paths=null)});for(let N in M)xe=!0,Gn("setScale",N);ge&&de.left>=0&&(te=me=!0)}for(let N in H)H[N]=null}function Be(b){let M=sm(vn-1,0,fn-1),I=sm(_n+1,0,fn-1);for(;b[M]==null&&M>0;)M--;for(;b[I]==null&&I<fn-1;)I++;return[M,I]}function xt(){if(fn>0){let b=x.some(M=>M._focus)&&Ie!=ke.alpha;b&&(d.globalAlpha=Ie=ke.alpha),x.forEach((M,I)=>{if(I>0&&M.show&&(ln(I,!1),ln(I,!0),M._paths==null)){let N=Ie;Ie!=M.alpha&&(d.globalAlpha=Ie=M.alpha);let W=r==2?[0,e[I][0].length-1]:Be(e[I]);M._paths=M.paths(i,I,W[0],W[1]),Ie!=N&&(d.globalAlpha=Ie=N)}}),x.forEach((M,I)=>{if(I>0&&M.show){let N=Ie;Ie!=M.alpha&&(d.globalAlpha=Ie=M.alpha),M._paths!=null&&kt(I,!1);{let W=M._paths!=null?M._paths.gaps:null,J=M.points.show(i,I,vn,_n,W),ce=M.points.filter(i,I,J,W);(J||ce)&&(M.points._paths=M.points.paths(i,I,vn,_n,ce),kt(I,!0))}Ie!=N&&(d.globalAlpha=Ie=N),Gn("drawSeries",I)}}),b&&(d.globalAlpha=Ie=1)}}function ln(b,M){let I=M?x[b].points:x[b];I._stroke=I.stroke(i,b),I._fill=I.fill(i,b)}function kt(b,M){let I=M?x[b].points:x[b],{stroke:N,fill:W,clip:J,flags:ce,_stroke:pe=I._stroke,_fill:be=I._fill,_width:Ne=I.width}=I._paths;Ne=Xt(Ne*Nt,3);let Fe=null,Oe=Ne%2/2;M&&be==null&&(be=Ne>0?"#fff":pe);let ct=I.pxAlign==1&&Oe>0;if(ct&&d.translate(Oe,Oe),!M){let Dt=R-Ne/2,It=w-Ne/2,St=q+Ne,et=he+Ne;Fe=new Path2D,Fe.rect(Dt,It,St,et)}M?Ue(pe,Ne,I.dash,I.cap,be,N,W,ce,J):Bt(b,pe,Ne,I.dash,I.cap,be,N,W,ce,Fe,J),ct&&d.translate(-Oe,-Oe)}function Bt(b,M,I,N,W,J,ce,pe,be,Ne,Fe){let Oe=!1;be!=0&&P.forEach((ct,Dt)=>{if(ct.series[0]==b){let It=x[ct.series[1]],St=e[ct.series[1]],et=(It._paths||vc).band;Js(et)&&(et=ct.dir==1?et[0]:et[1]);let Ye,Qt=null;It.show&&et&&YT(St,vn,_n)?(Qt=ct.fill(i,Dt)||J,Ye=It._paths.clip):et=null,Ue(M,I,N,W,Qt,ce,pe,be,Ne,Fe,Ye,et),Oe=!0}}),Oe||Ue(M,I,N,W,J,ce,pe,be,Ne,Fe)}let In=Xa|lm;function Ue(b,M,I,N,W,J,ce,pe,be,Ne,Fe,Oe){Ae(b,M,I,N,W),(be||Ne||Oe)&&(d.save(),be&&d.clip(be),Ne&&d.clip(Ne)),Oe?(pe&In)==In?(d.clip(Oe),Fe&&d.clip(Fe),wt(W,ce),Sn(b,J,M)):pe&lm?(wt(W,ce),d.clip(Oe),Sn(b,J,M)):pe&Xa&&(d.save(),d.clip(Oe),Fe&&d.clip(Fe),wt(W,ce),d.restore(),Sn(b,J,M)):(wt(W,ce),Sn(b,J,M)),(be||Ne||Oe)&&d.restore()}function Sn(b,M,I){I>0&&(M instanceof Map?M.forEach((N,W)=>{d.strokeStyle=wa=W,d.stroke(N)}):M!=null&&b&&d.stroke(M))}function wt(b,M){M instanceof Map?M.forEach((I,N)=>{d.fillStyle=Vs=N,d.fill(I)}):M!=null&&b&&d.fill(M)}function fs(b,M,I,N){let W=A[b],J;if(N<=0)J=[0,0];else{let ce=W._space=W.space(i,b,M,I,N),pe=W._incrs=W.incrs(i,b,M,I,N,ce);J=mA(M,I,pe,N,ce)}return W._found=J}function wn(b,M,I,N,W,J,ce,pe,be,Ne){let Fe=ce%2/2;_==1&&d.translate(Fe,Fe),Ae(pe,ce,be,Ne,pe),d.beginPath();let Oe,ct,Dt,It,St=W+(N==0||N==3?-J:J);I==0?(ct=W,It=St):(Oe=W,Dt=St);for(let et=0;et<b.length;et++)M[et]!=null&&(I==0?Oe=Dt=b[et]:ct=It=b[et],d.moveTo(Oe,ct),d.lineTo(Dt,It));d.stroke(),_==1&&d.translate(-Fe,-Fe)}function Ta(b){let M=!0;return A.forEach((I,N)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(M=!1,I._show=!1,pt(!1));return}else I._show||(M=!1,I._show=!0,pt(!1));let J=I.side,ce=J%2,{min:pe,max:be}=W,[Ne,Fe]=fs(N,pe,be,ce==0?k:Re);if(Fe==0)return;let Oe=W.distr==2,ct=I._splits=I.splits(i,N,pe,be,Ne,Fe,Oe),Dt=W.distr==2?ct.map(Ye=>Ci[Ye]):ct,It=W.distr==2?Ci[ct[1]]-Ci[ct[0]]:Ne,St=I._values=I.values(i,I.filter(i,Dt,N,Fe,It),N,Fe,It);I._rotate=J==2?I.rotate(i,St,N,Fe):0;let et=I._size;I._size=nr(I.size(i,St,N,b)),et!=null&&I._size!=et&&(M=!1)}),M}function Ur(b){let M=!0;return $l.forEach((I,N)=>{let W=I(i,N,Nr,b);W!=dr[N]&&(M=!1),dr[N]=W}),M}function ps(){for(let b=0;b<A.length;b++){let M=A[b];if(!M.show||!M._show)continue;let I=M.side,N=I%2,W,J,ce=M.stroke(i,b),pe=I==0||I==3?-1:1,[be,Ne]=M._found;if(M.label!=null){let li=M.labelGap*pe,Ii=Dn((M._lpos+li)*Nt);Le(M.labelFont[0],ce,"center",I==2?"top":d_),d.save(),N==1?(W=J=0,d.translate(Ii,Dn(w+he/2)),d.rotate((I==3?-qu:qu)/2)):(W=Dn(R+q/2),J=Ii);let ko=ty(M.label)?M.label(i,b,be,Ne):M.label;d.fillText(ko,W,J),d.restore()}if(Ne==0)continue;let Fe=S[M.scale],Oe=N==0?q:he,ct=N==0?R:w,Dt=M._splits,It=Fe.distr==2?Dt.map(li=>Ci[li]):Dt,St=Fe.distr==2?Ci[Dt[1]]-Ci[Dt[0]]:be,et=M.ticks,Ye=M.border,Qt=et.show?et.size:0,mn=Dn(Qt*Nt),Vn=Dn((M.alignTo==2?M._size-Qt-M.gap:M.gap)*Nt),Vt=M._rotate*-qu/180,gn=v(M._pos*Nt),Pi=(mn+Vn)*pe,ai=gn+Pi;J=N==0?ai:0,W=N==1?ai:0;let Zi=M.font[0],fr=M.align==1?za:M.align==2?Yp:Vt>0?za:Vt<0?Yp:N==0?"center":I==3?Yp:za,Br=Vt||N==1?"middle":I==2?"top":d_;Le(Zi,ce,fr,Br);let Ri=M.font[1]*M.lineGap,Ji=Dt.map(li=>v(a(li,Fe,Oe,ct))),pr=M._values;for(let li=0;li<pr.length;li++){let Ii=pr[li];if(Ii!=null){N==0?W=Ji[li]:J=Ji[li],Ii=""+Ii;let ko=Ii.indexOf(`
`)==-1?[Ii]:Ii.split(/\n/gm);for(let ci=0;ci<ko.length;ci++){let Av=ko[ci];Vt?(d.save(),d.translate(W,J+ci*Ri),d.rotate(Vt),d.fillText(Av,0,0),d.restore()):d.fillText(Av,W,J+ci*Ri)}}}et.show&&wn(Ji,et.filter(i,It,b,Ne,St),N,I,gn,mn,Xt(et.width*Nt,3),et.stroke(i,b),et.dash,et.cap);let zr=M.grid;zr.show&&wn(Ji,zr.filter(i,It,b,Ne,St),N,N==0?2:1,N==0?w:R,N==0?he:q,Xt(zr.width*Nt,3),zr.stroke(i,b),zr.dash,zr.cap),Ye.show&&wn([gn],[1],N==0?1:0,N==0?1:2,N==1?w:R,N==1?he:q,Xt(Ye.width*Nt,3),Ye.stroke(i,b),Ye.dash,Ye.cap)}Gn("drawAxes")}function pt(b){x.forEach((M,I)=>{I>0&&(M._paths=null,b&&(r==1?(M.min=null,M.max=null):M.facets.forEach(N=>{N.min=null,N.max=null})))})}let pn=!1,oi=!1,zt=[];function Mn(){oi=!1;for(let b=0;b<zt.length;b++)Gn(...zt[b]);zt.length=0}function jn(){pn||(lE(cv),pn=!0)}function wu(b,M=!1){pn=!0,oi=M,b(i),cv(),M&&zt.length>0&&queueMicrotask(Mn)}i.batch=wu;function cv(){if(ae&&(yt(),ae=!1),xe&&(Te(),xe=!1),_e){if(en(p,za,Qe),en(p,"top",ht),en(p,fc,k),en(p,pc,Re),en(m,za,Qe),en(m,"top",ht),en(m,fc,k),en(m,pc,Re),en(f,fc,dn),en(f,pc,bn),h.width=Dn(dn*Nt),h.height=Dn(bn*Nt),A.forEach(({_el:b,_show:M,_size:I,_pos:N,side:W})=>{if(b!=null)if(M){let J=W===3||W===0?I:0,ce=W%2==1;en(b,ce?"left":"top",N-J),en(b,ce?"width":"height",I),en(b,ce?"top":"left",ce?ht:Qe),en(b,ce?"height":"width",ce?Re:k),im(b,Xo)}else Ni(b,Xo)}),wa=Vs=Ma=z=j=$=K=Ee=E=null,Ie=1,jl(!0),Qe!=Me||ht!=Wt||k!=He||Re!=Ze){pt(!1);let b=k/He,M=Re/Ze;if(ge&&!te&&de.left>=0){de.left*=b,de.top*=M,Ea&&qr(Ea,Dn(de.left),0,k,Re),Aa&&qr(Aa,0,Dn(de.top),k,Re);for(let I=0;I<dt.length;I++){let N=dt[I];N!=null&&(Zt[I]*=b,si[I]*=M,qr(N,nr(Zt[I]),nr(si[I]),k,Re))}}if(jt.show&&!ie&&jt.left>=0&&jt.width>0){jt.left*=b,jt.width*=b,jt.top*=M,jt.height*=M;for(let I in Ep)en(Ra,I,jt[I])}Me=Qe,Wt=ht,He=k,Ze=Re}Gn("setSize"),_e=!1}dn>0&&bn>0&&(d.clearRect(0,0,h.width,h.height),Gn("drawClear"),T.forEach(b=>b()),Gn("draw")),jt.show&&ie&&(Mu(jt),ie=!1),ge&&te&&(Oo(null,!0,!1),te=!1),fe.show&&fe.live&&me&&(Mp(),me=!1),l||(l=!0,i.status=1,Gn("ready")),Gs=!1,pn=!1}i.redraw=(b,M)=>{xe=M||!1,b!==!1?Ws(C,L.min,L.max):jn()};function bp(b,M){let I=S[b];if(I.from==null){if(fn==0){let N=I.range(i,M.min,M.max,b);M.min=N[0],M.max=N[1]}if(M.min>M.max){let N=M.min;M.min=M.max,M.max=N}if(fn>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;b==C&&I.distr==2&&fn>0&&(M.min=vr(M.min,e[0]),M.max=vr(M.max,e[0]),M.min==M.max&&M.max++),H[b]=M,ae=!0,jn()}}i.setScale=bp;let Sp,wp,Ea,Aa,uv,hv,Ca,Pa,dv,fv,Jt,sn,Hs=!1,Yn=de.drag,Bn=Yn.x,zn=Yn.y;ge&&(de.x&&(Sp=tr(LT,m)),de.y&&(wp=tr(DT,m)),L.ori==0?(Ea=Sp,Aa=wp):(Ea=wp,Aa=Sp),Jt=de.left,sn=de.top);let jt=i.select=An({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ra=jt.show?tr(IT,jt.over?m:p):null;function Mu(b,M){if(jt.show){for(let I in b)jt[I]=b[I],I in Ep&&en(Ra,I,b[I]);M!==!1&&Gn("setSelect")}}i.setSelect=Mu;function E1(b){if(x[b].show)ee&&im(ut[b],Xo);else if(ee&&Ni(ut[b],Xo),ge){let I=Pe?dt[0]:dt[b];I!=null&&qr(I,-10,-10,k,Re)}}function Ws(b,M,I){bp(b,{min:M,max:I})}function Or(b,M,I,N){M.focus!=null&&I1(b),M.show!=null&&x.forEach((W,J)=>{J>0&&(b==J||b==null)&&(W.show=M.show,E1(J),r==2?(Ws(W.facets[0].scale,null,null),Ws(W.facets[1].scale,null,null)):Ws(W.scale,null,null),jn())}),I!==!1&&Gn("setSeries",b,M),N&&Ql("setSeries",i,b,M)}i.setSeries=Or;function A1(b,M){An(P[b],M)}function C1(b,M){b.fill=Mt(b.fill||null),b.dir=Lt(b.dir,-1),M=M??P.length,P.splice(M,0,b)}function P1(b){b==null?P.length=0:P.splice(b,1)}i.addBand=C1,i.setBand=A1,i.delBand=P1;function R1(b,M){x[b].alpha=M,ge&&dt[b]!=null&&(dt[b].style.opacity=M),ee&&ut[b]&&(ut[b].style.opacity=M)}let ms,qs,Uo,Ia={focus:!0};function I1(b){if(b!=Uo){let M=b==null,I=ke.alpha!=1;x.forEach((N,W)=>{if(r==1||W>0){let J=M||W==0||W==b;N._focus=M?null:J,I&&R1(W,J?1:ke.alpha)}}),Uo=b,I&&jn()}}ee&&nt&&Ct(g_,Ce,b=>{de._lock||(tt(b),Uo!=null&&Or(null,Ia,!0,Tn.setSeries))});function kr(b,M,I){let N=S[M];I&&(b=b/Nt-(N.ori==1?ht:Qe));let W=k;N.ori==1&&(W=Re,b=W-b),N.dir==-1&&(b=W-b);let J=N._min,ce=N._max,pe=b/W,be=J+(ce-J)*pe,Ne=N.distr;return Ne==3?Ha(10,be):Ne==4?ZT(be,N.asinh):Ne==100?N.bwd(be):be}function L1(b,M){let I=kr(b,C,M);return vr(I,e[0],vn,_n)}i.valToIdx=b=>vr(b,e[0]),i.posToIdx=L1,i.posToVal=kr,i.valToPos=(b,M,I)=>S[M].ori==0?s(b,S[M],I?q:k,I?R:0):o(b,S[M],I?he:Re,I?w:0),i.setCursor=(b,M,I)=>{Jt=b.left,sn=b.top,Oo(null,M,I)};function pv(b,M){en(Ra,za,jt.left=b),en(Ra,fc,jt.width=M)}function mv(b,M){en(Ra,"top",jt.top=b),en(Ra,pc,jt.height=M)}let Zl=L.ori==0?pv:mv,Jl=L.ori==1?pv:mv;function D1(){if(ee&&fe.live)for(let b=r==2?1:0;b<x.length;b++){if(b==0&&ft)continue;let M=fe.values[b],I=0;for(let N in M)We[b][I++].firstChild.nodeValue=M[N]}}function Mp(b,M){if(b!=null&&(b.idxs?b.idxs.forEach((I,N)=>{se[N]=I}):eE(b.idx)||se.fill(b.idx),fe.idx=se[0]),ee&&fe.live){for(let I=0;I<x.length;I++)(I>0||r==1&&!ft)&&N1(I,se[I]);D1()}me=!1,M!==!1&&Gn("setLegend")}i.setLegend=Mp;function N1(b,M){let I=x[b],N=b==0&&B==2?Ci:e[b],W;ft?W=I.values(i,b,M)??lt:(W=I.value(i,M==null?null:N[M],b,M),W=W==null?lt:{_:W}),fe.values[b]=W}function Oo(b,M,I){dv=Jt,fv=sn,[Jt,sn]=de.move(i,Jt,sn),de.left=Jt,de.top=sn,ge&&(Ea&&qr(Ea,Dn(Jt),0,k,Re),Aa&&qr(Aa,0,Dn(sn),k,Re));let N,W=vn>_n;ms=qt,qs=null;let J=L.ori==0?k:Re,ce=L.ori==1?k:Re;if(Jt<0||fn==0||W){N=de.idx=null;for(let pe=0;pe<x.length;pe++){let be=dt[pe];be!=null&&qr(be,-10,-10,k,Re)}nt&&Or(null,Ia,!0,b==null&&Tn.setSeries),fe.live&&(se.fill(N),me=!0)}else{let pe,be,Ne;r==1&&(pe=L.ori==0?Jt:sn,be=kr(pe,C),N=de.idx=vr(be,e[0],vn,_n),Ne=G(e[0][N],L,J,0));let Fe=-10,Oe=-10,ct=0,Dt=0,It=!0,St="",et="";for(let Ye=r==2?1:0;Ye<x.length;Ye++){let Qt=x[Ye],mn=se[Ye],Vn=mn==null?null:r==1?e[Ye][mn]:e[Ye][1][mn],Vt=de.dataIdx(i,Ye,N,be),gn=Vt==null?null:r==1?e[Ye][Vt]:e[Ye][1][Vt];if(me=me||gn!=Vn||Vt!=mn,se[Ye]=Vt,Ye>0&&Qt.show){let Pi=Vt==null?-10:Vt==N?Ne:G(r==1?e[0][Vt]:e[Ye][0][Vt],L,J,0),ai=gn==null?-10:F(gn,r==1?S[Qt.scale]:S[Qt.facets[1].scale],ce,0);if(nt&&gn!=null){let Zi=L.ori==1?Jt:sn,fr=Nn(ke.dist(i,Ye,Vt,ai,Zi));if(fr<ms){let Br=ke.bias;if(Br!=0){let Ri=kr(Zi,Qt.scale),Ji=gn>=0?1:-1,pr=Ri>=0?1:-1;pr==Ji&&(pr==1?Br==1?gn>=Ri:gn<=Ri:Br==1?gn<=Ri:gn>=Ri)&&(ms=fr,qs=Ye)}else ms=fr,qs=Ye}}if(me||Pe){let Zi,fr;L.ori==0?(Zi=Pi,fr=ai):(Zi=ai,fr=Pi);let Br,Ri,Ji,pr,zr,li,Ii=!0,ko=ue.bbox;if(ko!=null){Ii=!1;let ci=ko(i,Ye);Ji=ci.left,pr=ci.top,Br=ci.width,Ri=ci.height}else Ji=Zi,pr=fr,Br=Ri=ue.size(i,Ye);if(li=ue.fill(i,Ye),zr=ue.stroke(i,Ye),Pe)Ye==qs&&ms<=ke.prox&&(Fe=Ji,Oe=pr,ct=Br,Dt=Ri,It=Ii,St=li,et=zr);else{let ci=dt[Ye];ci!=null&&(Zt[Ye]=Ji,si[Ye]=pr,w_(ci,Br,Ri,Ii),b_(ci,li,zr),qr(ci,nr(Ji),nr(pr),k,Re))}}}}if(Pe){let Ye=ke.prox,Qt=Uo==null?ms<=Ye:ms>Ye||qs!=Uo;if(me||Qt){let mn=dt[0];mn!=null&&(Zt[0]=Fe,si[0]=Oe,w_(mn,ct,Dt,It),b_(mn,St,et),qr(mn,nr(Fe),nr(Oe),k,Re))}}}if(jt.show&&Hs)if(b!=null){let[pe,be]=Tn.scales,[Ne,Fe]=Tn.match,[Oe,ct]=b.cursor.sync.scales,Dt=b.cursor.drag;if(Bn=Dt._x,zn=Dt._y,Bn||zn){let{left:It,top:St,width:et,height:Ye}=b.select,Qt=b.scales[Oe].ori,mn=b.posToVal,Vn,Vt,gn,Pi,ai,Zi=pe!=null&&Ne(pe,Oe),fr=be!=null&&Fe(be,ct);Zi&&Bn?(Qt==0?(Vn=It,Vt=et):(Vn=St,Vt=Ye),gn=S[pe],Pi=G(mn(Vn,Oe),gn,J,0),ai=G(mn(Vn+Vt,Oe),gn,J,0),Zl(_r(Pi,ai),Nn(ai-Pi))):Zl(0,J),fr&&zn?(Qt==1?(Vn=It,Vt=et):(Vn=St,Vt=Ye),gn=S[be],Pi=F(mn(Vn,ct),gn,ce,0),ai=F(mn(Vn+Vt,ct),gn,ce,0),Jl(_r(Pi,ai),Nn(ai-Pi))):Jl(0,ce)}else Ap()}else{let pe=Nn(dv-uv),be=Nn(fv-hv);if(L.ori==1){let ct=pe;pe=be,be=ct}Bn=Yn.x&&pe>=Yn.dist,zn=Yn.y&&be>=Yn.dist;let Ne=Yn.uni;Ne!=null?Bn&&zn&&(Bn=pe>=Ne,zn=be>=Ne,!Bn&&!zn&&(be>pe?zn=!0:Bn=!0)):Yn.x&&Yn.y&&(Bn||zn)&&(Bn=zn=!0);let Fe,Oe;Bn&&(L.ori==0?(Fe=Ca,Oe=Jt):(Fe=Pa,Oe=sn),Zl(_r(Fe,Oe),Nn(Oe-Fe)),zn||Jl(0,ce)),zn&&(L.ori==1?(Fe=Ca,Oe=Jt):(Fe=Pa,Oe=sn),Jl(_r(Fe,Oe),Nn(Oe-Fe)),Bn||Zl(0,J)),!Bn&&!zn&&(Zl(0,0),Jl(0,0))}if(Yn._x=Bn,Yn._y=zn,b==null){if(I){if(Ev!=null){let[pe,be]=Tn.scales;Tn.values[0]=pe!=null?kr(L.ori==0?Jt:sn,pe):null,Tn.values[1]=be!=null?kr(L.ori==1?Jt:sn,be):null}Ql(Kp,i,Jt,sn,k,Re,N)}if(nt){let pe=I&&Tn.setSeries,be=ke.prox;Uo==null?ms<=be&&Or(qs,Ia,!0,pe):ms>be?Or(null,Ia,!0,pe):qs!=Uo&&Or(qs,Ia,!0,pe)}}me&&(fe.idx=N,Mp()),M!==!1&&Gn("setCursor")}let Xs=null;Object.defineProperty(i,"rect",{get(){return Xs==null&&jl(!1),Xs}});function jl(b=!1){b?Xs=null:(Xs=m.getBoundingClientRect(),Gn("syncRect",Xs))}function gv(b,M,I,N,W,J,ce){de._lock||Hs&&b!=null&&b.movementX==0&&b.movementY==0||(Tp(b,M,I,N,W,J,ce,!1,b!=null),b!=null?Oo(null,!0,!0):Oo(M,!0,!1))}function Tp(b,M,I,N,W,J,ce,pe,be){if(Xs==null&&jl(!1),tt(b),b!=null)I=b.clientX-Xs.left,N=b.clientY-Xs.top;else{if(I<0||N<0){Jt=-10,sn=-10;return}let[Ne,Fe]=Tn.scales,Oe=M.cursor.sync,[ct,Dt]=Oe.values,[It,St]=Oe.scales,[et,Ye]=Tn.match,Qt=M.axes[0].side%2==1,mn=L.ori==0?k:Re,Vn=L.ori==1?k:Re,Vt=Qt?J:W,gn=Qt?W:J,Pi=Qt?N:I,ai=Qt?I:N;if(It!=null?I=et(Ne,It)?a(ct,S[Ne],mn,0):-10:I=mn*(Pi/Vt),St!=null?N=Ye(Fe,St)?a(Dt,S[Fe],Vn,0):-10:N=Vn*(ai/gn),L.ori==1){let Zi=I;I=N,N=Zi}}be&&(M==null||M.cursor.event.type==Kp)&&((I<=1||I>=k-1)&&(I=Wo(I,k)),(N<=1||N>=Re-1)&&(N=Wo(N,Re))),pe?(uv=I,hv=N,[Ca,Pa]=de.move(i,I,N)):(Jt=I,sn=N)}let Ep={width:0,height:0,left:0,top:0};function Ap(){Mu(Ep,!1)}let vv,_v,yv,xv;function bv(b,M,I,N,W,J,ce){Hs=!0,Bn=zn=Yn._x=Yn._y=!1,Tp(b,M,I,N,W,J,ce,!0,!1),b!=null&&(Ct(Zp,tm,Sv,!1),Ql(p_,i,Ca,Pa,k,Re,null));let{left:pe,top:be,width:Ne,height:Fe}=jt;vv=pe,_v=be,yv=Ne,xv=Fe}function Sv(b,M,I,N,W,J,ce){Hs=Yn._x=Yn._y=!1,Tp(b,M,I,N,W,J,ce,!1,!0);let{left:pe,top:be,width:Ne,height:Fe}=jt,Oe=Ne>0||Fe>0,ct=vv!=pe||_v!=be||yv!=Ne||xv!=Fe;if(Oe&&ct&&Mu(jt),Yn.setScale&&Oe&&ct){let Dt=pe,It=Ne,St=be,et=Fe;if(L.ori==1&&(Dt=be,It=Fe,St=pe,et=Ne),Bn&&Ws(C,kr(Dt,C),kr(Dt+It,C)),zn)for(let Ye in S){let Qt=S[Ye];Ye!=C&&Qt.from==null&&Qt.min!=qt&&Ws(Ye,kr(St+et,Ye),kr(St,Ye))}Ap()}else de.lock&&(de._lock=!de._lock,Oo(M,!0,b!=null));b!=null&&(Rn(Zp,tm),Ql(Zp,i,Jt,sn,k,Re,null))}function F1(b,M,I,N,W,J,ce){if(de._lock)return;tt(b);let pe=Hs;if(Hs){let be=!0,Ne=!0,Fe=10,Oe,ct;L.ori==0?(Oe=Bn,ct=zn):(Oe=zn,ct=Bn),Oe&&ct&&(be=Jt<=Fe||Jt>=k-Fe,Ne=sn<=Fe||sn>=Re-Fe),Oe&&be&&(Jt=Jt<Ca?0:k),ct&&Ne&&(sn=sn<Pa?0:Re),Oo(null,!0,!0),Hs=!1}Jt=-10,sn=-10,se.fill(null),Oo(null,!0,!0),pe&&(Hs=pe)}function wv(b,M,I,N,W,J,ce){de._lock||(tt(b),Kl(),Ap(),b!=null&&Ql(v_,i,Jt,sn,k,Re,null))}function Mv(){A.forEach(gA),O(i.width,i.height,!0)}$o(Xu,Va,Mv);let La={};La.mousedown=bv,La.mousemove=gv,La.mouseup=Sv,La.dblclick=wv,La.setSeries=(b,M,I,N)=>{let W=Tn.match[2];I=W(i,M,I),I!=-1&&Or(I,N,!0,!1)},ge&&(Ct(p_,m,bv),Ct(Kp,m,gv),Ct(m_,m,b=>{tt(b),jl(!1)}),Ct(g_,m,F1),Ct(v_,m,wv),cm.add(i),i.syncRect=jl);let Tu=i.hooks=n.hooks||{};function Gn(b,M,I){oi?zt.push([b,M,I]):b in Tu&&Tu[b].forEach(N=>{N.call(null,i,M,I)})}(n.plugins||[]).forEach(b=>{for(let M in b.hooks)Tu[M]=(Tu[M]||[]).concat(b.hooks[M])});let Tv=(b,M,I)=>I,Tn=An({key:null,setSeries:!1,filters:{pub:C_,sub:C_},scales:[C,x[1]?x[1].scale:null],match:[P_,P_,Tv],values:[null,null]},de.sync);Tn.match.length==2&&Tn.match.push(Tv),de.sync=Tn;let Ev=Tn.key,Cp=Ty(Ev);function Ql(b,M,I,N,W,J,ce){Tn.filters.pub(b,M,I,N,W,J,ce)&&Cp.pub(b,M,I,N,W,J,ce)}Cp.sub(i);function U1(b,M,I,N,W,J,ce){Tn.filters.sub(b,M,I,N,W,J,ce)&&La[b](null,M,I,N,W,J,ce)}i.pub=U1;function O1(){Cp.unsub(i),cm.delete(i),kn.clear(),rm(Xu,Va,Mv),c.remove(),Ce?.remove(),Gn("destroy")}i.destroy=O1;function Pp(){Gn("init",n,e),Yl(e||n.data,!1),H[C]?bp(C,H[C]):Kl(),ie=jt.show&&(jt.width>0||jt.height>0),te=me=!0,O(n.width,n.height)}return x.forEach(Sa),A.forEach(hs),t?t instanceof HTMLElement?(t.appendChild(c),Pp()):t(i,Pp):Pp(),i}tn.assign=An;tn.fmtNum=gm;tn.rangeNum=$u;tn.rangeLog=Zu;tn.rangeAsinh=pm;tn.orient=Ko;tn.pxRatio=Nt;tn.join=aE;tn.fmtDate=_m,tn.tzDate=_E;tn.sync=Ty;{tn.addGap=eA,tn.clipGaps=Qu;let n=tn.paths={points:Iy};n.linear=Dy,n.stepped=iA,n.bars=rA,n.spline=oA}function Xe(n){let e=document.querySelector(".haptonic")??document.documentElement;return getComputedStyle(e).getPropertyValue(`--${n}`).trim()}function Qn(n){let e=matchMedia("(prefers-color-scheme: dark)");return e.addEventListener("change",n),()=>e.removeEventListener("change",n)}function Qs(n,e,t,i=[]){let{ctx:r,bbox:s}=n,o=n.valToPos(e,"x",!0);o<s.left||o>s.left+s.width||eo(r,[o,s.top],[o,s.top+s.height],t,i)}function Za(n,e,t,i=[]){let{ctx:r,bbox:s}=n,o=n.valToPos(e,"y",!0);eo(r,[s.left,o],[s.left+s.width,o],t,i)}function eo(n,e,t,i,r=[]){n.save(),n.strokeStyle=Xe(i),n.lineWidth=1.5*devicePixelRatio,n.setLineDash(r.map(s=>s*devicePixelRatio)),n.beginPath(),n.moveTo(...e),n.lineTo(...t),n.stroke(),n.restore()}function ys(n,[e,t],i,r=5){n.save(),n.setLineDash([]),n.beginPath(),n.arc(e,t,r*devicePixelRatio,0,2*Math.PI),n.fillStyle=Xe(i),n.strokeStyle=Xe("paper"),n.lineWidth=2*devicePixelRatio,n.fill(),n.stroke(),n.restore()}function Zo(n,[e,t],i){let{ctx:r,bbox:s}=n,[o,a]=[n.valToPos(e,"x",!0),n.valToPos(t,"x",!0)];r.fillStyle=Xe(i),r.fillRect(o,s.top,a-o,s.height)}var vA=240,Oy="13px system-ui, sans-serif",ky=10,By=5,_A=6,yr=()=>({stroke:()=>Xe("ink"),ticks:{stroke:()=>Xe("rule"),size:ky},gap:By,grid:{show:!1},font:Oy,labelFont:"14px system-ui, sans-serif",values:(n,e)=>e.map(t=>t===null?"":Zs(t))}),Xr=()=>({...yr(),labelSize:24,size:yA});function yA({ctx:n},e){n.save(),n.font=Oy;let t=(e??[]).map(i=>n.measureText(i).width);return n.restore(),Math.ceil(ky+By+Math.max(0,...t)+_A)}var xs={pxAlign:0};function $r(n){return Math.max(n.clientWidth,vA)}function Yr(n,e,t,i){let r=[...i,Qn(()=>n.redraw(!1,!0))],s=new ResizeObserver(()=>n.setSize(t()));return s.observe(e),()=>{s.disconnect();for(let o of r)o();n.destroy()}}function to(n,e){n.over.addEventListener("click",({clientX:t,clientY:i})=>{let r=n.over.getBoundingClientRect();e(t-r.left,i-r.top)})}function Kr({ctx:n,bbox:e},t){n.save(),n.beginPath(),n.rect(e.left,e.top,e.width,e.height),n.clip(),t(),n.restore()}var ih=class{constructor(e){this.data=e;this.distance=e.values("distance"),this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),[this.rows=0,this.bands=0]=e.shape("frequency"),this.names=e.parsed("character_names");let t=e.parsed("path_labels"),i=e.parsed("path_corners");this.corners=t.map((s,o)=>({label:s,row:i[o]??0}));let r=e.header.attrs.carrier_hz;this.carrier=typeof r=="number"?r:void 0,this.top=Number(e.header.extra.top),this.units=ji(e),this.pitch=Tm(e),this.wavevectorUnits=ka(this.pitch),this.gaps=Em(e)}data;distance;frequency;error;rows;bands;gaps;corners;carrier;top;units;pitch;wavevectorUnits;names;branches(){let e=this.data.values("branch"),t=new Map;return e.forEach((i,r)=>{let s=t.get(i)??Array(this.rows).fill(null);s[Math.floor(r/this.bands)]=this.frequency[r]??null,t.set(i,s)}),[...t.values()]}at({row:e,band:t}){return this.frequency[e*this.bands+t]??NaN}errorAt({row:e,band:t}){return this.error[e*this.bands+t]??NaN}nature({row:e,band:t}){return this.motion(this.data.values("character")[e*this.bands+t])}motion(e){return this.names[e??-1]??""}parity({row:e,band:t}){let i=e*this.bands+t;return Am(this.data.values("parity")[i],"the mirror of the path",this.data.values("middle_parity")[i])}velocity({row:e,band:t}){let i=this.data.values("group_velocity"),r=2*(e*this.bands+t),[s,o]=[i[r]??NaN,i[r+1]??NaN];return Number.isFinite(s)&&Number.isFinite(o)?[s,o]:void 0}velocityError({row:e,band:t}){return this.data.has("group_velocity_error")?this.data.values("group_velocity_error")[e*this.bands+t]:void 0}phases(e){let t=this.data.values("kappa");return[t[2*e]??0,t[2*e+1]??0]}place(e){let t=this.corners.find(a=>a.row===e);if(t!==void 0)return t.label;let i=this.corners.findIndex(a=>a.row>e),[r,s]=[this.corners[i-1],this.corners[i]];if(r===void 0||s===void 0)return"";let o=(e-r.row)/(s.row-r.row);return`${Number(o.toFixed(3))} of ${r.label}-${s.label}`}belowGap(e){let t=e.below-1,i=0;for(let r=1;r<this.rows;r++)this.at({row:r,band:t})>this.at({row:i,band:t})&&(i=r);return{row:i,band:t}}},Tm=n=>Number(n.header.attrs.pitch_m);function Em(n){if(!n.has("gap_below"))return[];let e=t=>n.values(t);return Array.from(e("gap_below"),(t,i)=>({below:t,lower:e("gap_lower")[i]??NaN,upper:e("gap_upper")[i]??NaN,lowerError:e("gap_lower_error")[i]??NaN,upperError:e("gap_upper_error")[i]??NaN,complete:e("gap_complete")[i]===1,direction:n.texts("gap_direction")[i]??"",waves:n.texts("gap_waves")[i]??""}))}function Am(n,e,t){let i=["even","odd"][zy(n)],r=["symmetric","antisymmetric"][zy(t)];return[i&&`${i} under ${e}`,r&&`${r} about the plate's middle plane`].filter(Boolean).join(", ")}function zy(n){return n===1?0:n===-1?1:-1}var xA=.2,bA=.1;function SA({certified:n,preview:e,at:t}){let i=e&&wA(e,t);if(n===null)return i;let r=n.has("gap_lower");return!r&&i===null?null:{isPreview:!1,areGapsPreview:!r,distance:n.values("distance"),pitch:Tm(n),frequency:n.values("frequency"),error:n.values("frequency_error"),gaps:r?Em(n):i?.gaps??[]}}function Gy(n){let e=Ve(()=>n?.value?SA(n.value):null);return{layer:e,isWaiting:Ve(()=>!!n?.value&&e.value===null)}}var rh=({distance:n,pitch:e,frequency:t,error:i,gaps:r})=>({isPreview:!1,areGapsPreview:!1,distance:n,pitch:e,frequency:t,error:i,gaps:r});function wA(n,e){let t=n.values("value"),i=t.length-1;if(e<(t[0]??NaN)*(1-1e-9)||e>(t[i]??NaN)*(1+1e-9))return null;let r=Math.max(1,t.findIndex(y=>y>=e)),[s,o]=[t[r-1]??0,t[r]??1],a=o-s,l=Math.min(Math.max((e-s)/a,0),1),c=y=>{let T=n.values(y).length/t.length,U=le=>{let X=n.values(le);return[X.subarray((r-1)*T,r*T),X.subarray(r*T,(r+1)*T)]},[[D,L],[B,G],[F,H]]=[U(y),U(`${y}_error`),U(`${y}_bend`)],Y=(le,X,Q)=>(1-l)*(le[Q]??NaN)+l*(X[Q]??NaN),V=a*l*(1-l);return[Float64Array.from(D,(le,X)=>Y(D,L,X)),Float64Array.from(D,(le,X)=>Y(B,G,X)+V*((F[X]??NaN)+(H[X]??NaN)))]},[h,d]=c("frequency"),f=bA*Math.max(...h);if(h.some((y,T)=>!((d[T]??NaN)<=xA*Math.max(y,f))))return null;let[p,m]=c("edge"),_=p.length/2,v=Array.from({length:_},(y,T)=>({below:T+1,lower:p[T]??NaN,upper:p[_+T]??NaN,lowerError:m[T]??NaN,upperError:m[_+T]??NaN,complete:!0,direction:"all",waves:"all"})),g=(y,T)=>{let U=n.values(y),D=U.length/t.length;return[U[(r-1)*D+T]??NaN,U[r*D+T]??NaN]},x=Float64Array.from({length:n.values("distance").length/t.length},(y,T)=>{let[U,D]=g("distance",T);return U===0?0:1/((1-l)/U+l/D)}),[A,S]=g("pitch",0),P=(1-l)*A+l*S,C=v.filter(({lower:y,upper:T})=>T>y);return{isPreview:!0,areGapsPreview:!0,distance:x,pitch:P,frequency:h,error:d,gaps:C}}var MA={preview:{colour:"accent",dash:[5,3],width:1.6},certified:{colour:"ink",dash:[],width:1.6},held:{colour:"curve-1",dash:[1.5,3],width:1.5}};function Cm(n,e,t,i,r,s){let{ctx:o}=n,{colour:a,dash:l,width:c}=MA[s],h=Array.from(t.distance,p=>n.valToPos(p/r,"x",!0)),d=(p,m)=>{let _=(t.frequency[p]??NaN)+m*(t.error[p]??NaN);return n.valToPos(_/i,"y",!0)},f=(p,m,_=!1)=>{for(let v=0;v<e.rows;v++){let g=_?e.rows-1-v:v;o.lineTo(h[g]??0,d(g*e.bands+p,m))}};o.save(),o.fillStyle=o.strokeStyle=Xe(a),o.lineWidth=c*devicePixelRatio,o.setLineDash(l.map(p=>p*devicePixelRatio));for(let p=0;p<e.bands;p++)s==="preview"&&(o.globalAlpha=.2,o.beginPath(),f(p,1),f(p,-1,!0),o.fill(),o.globalAlpha=1),o.beginPath(),f(p,0),o.stroke();if(s==="held")for(let p of t.gaps.filter(({complete:m})=>m))for(let m of[p.lower,p.upper]){let _=n.valToPos(m/i,"y",!0);o.beginPath(),o.moveTo(n.bbox.left,_),o.lineTo(n.bbox.left+n.bbox.width,_),o.stroke()}o.restore()}var TA=340,EA=.72,AA=40;function Vy({diagram:n,choice:e,newer:t}){let i=Ke(null);return Li(()=>{let r=i.current;if(r!==null)return CA(r,n,e,t)},[n,e,t]),u("div",{class:"curves",ref:i})}function CA(n,e,t,{layer:i,isWaiting:r}){let s=()=>t.unit.peek().factor,o=rh(e),a=()=>i.peek()??o,l=g=>Hy(t,g).factor,c=g=>(g.distance[e.rows-1]??1)/l(g),h=e.branches(),d=()=>[Array.from(e.distance,g=>g/l(o)),...h.map(g=>g.map(x=>x===null?null:x/s()))],f=()=>{let g=$r(n);return{width:g,height:Math.max(TA,Math.min(EA*g,.7*innerHeight))}},p=()=>{let g=a();return e.corners.map(({row:x})=>(g.distance[x]??0)/l(g))},m=new tn({...f(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(g,x,A)=>[x,A]},y:{range:(g,x,A)=>x===null?[0,1]:[x<.2*A?0:x,A]}},axes:[{...yr(),splits:p,values:()=>p().map((g,x)=>`${e.corners[x]?.label}
${Number(g.toPrecision(3))}`),font:"14px system-ui, sans-serif",size:56,label:"wavevector",labelSize:22,grid:{stroke:()=>Xe("rule"),width:1}},{...Xr(),label:"frequency"}],series:[{},...h.map(()=>({...xs,stroke:()=>i.peek()!==null?"transparent":Xe(r.peek()?"rule":"ink"),width:1.6,points:{show:!1}}))],hooks:{drawClear:[g=>Kr(g,()=>{let x=t.held.peek(),A=r.peek()?[]:(i.peek()??e).gaps;RA(g,A,e.carrier,s()),x!==null&&Cm(g,e,x.layer,s(),l(x.layer),"held")})],draw:[g=>{let x=i.peek();x!==null&&Kr(g,()=>Cm(g,e,x,s(),l(x),x.isPreview?"preview":"certified")),LA(g,e,t,a())}]}},d(),n),_=()=>m.setScale("y",{min:0,max:e.top/s()}),v=()=>{let g=t.held.peek();m.setScale("x",{min:0,max:Math.max(c(a()),g===null?0:c(g.layer))})};return _(),to(m,(g,x)=>{let A=PA(m,e,s(),l(o),g,x);A!==void 0&&(t.point.value=A)}),Object.assign(n,{plot:m}),Yr(m,n,f,[Je(()=>{let[g,x]=m.axes;g!==void 0&&(g.label=Yt("length of the path",t.wavevectorUnit.value)),x!==void 0&&(x.label=Yt("frequency",t.unit.value)),m.setData(d(),!0),_(),v()}),Je(()=>{i.value,t.held.value,v()}),Je(()=>{let g=e.at(t.point.value)/s();i.value,r.value,t.held.value,g>(m.scales.y?.max??1/0)?m.setScale("y",{min:0,max:1.03*g}):m.redraw(!1,!1)})])}function Hy(n,{pitch:e}){let t=n.wavevectorUnit.peek();return ka(e).find(({name:i})=>i===t.name)??t}function PA(n,e,t,i,r,s){let[o,a]=[void 0,AA];for(let l=0;l<e.rows;l++){let c=n.valToPos((e.distance[l]??0)/i,"x")-r;if(!(Math.abs(c)>a))for(let h=0;h<e.bands;h++){let d=Math.hypot(c,n.valToPos(e.at({row:l,band:h})/t,"y")-s);d<a&&([o,a]=[{row:l,band:h},d])}}return o}function RA(n,e,t,i){let{ctx:r,bbox:s}=n;for(let o of e){let a=n.valToPos(o.upper/i,"y",!0),l=n.valToPos(o.lower/i,"y",!0)-a;o.complete?(r.fillStyle=Xe("gap"),r.fillRect(s.left,a,s.width,l)):o.waves!=="all"&&IA(r,s.left,a,s.width,l)}t!==void 0&&Za(n,t/i,"carrier",[7,5])}function IA(n,e,t,i,r){let s=12*devicePixelRatio;n.save(),n.beginPath(),n.rect(e,t,i,r),n.clip(),n.beginPath();for(let o=e-r;o<e+i;o+=s)n.moveTo(o,t+r),n.lineTo(o+r,t);n.strokeStyle=Xe("gap"),n.lineWidth=2*devicePixelRatio,n.stroke(),n.restore()}function LA(n,e,t,i){let r=t.point.peek(),s=n.valToPos((i.distance[r.row]??0)/Hy(t,i).factor,"x",!0),o=i.frequency[r.row*e.bands+r.band]??NaN,a=n.valToPos(o/t.unit.peek().factor,"y",!0);ys(n.ctx,[s,a],"accent",6)}function Wy(n,e){let t=i=>e===void 0?i.upper-i.lower:qy(i,e).room;return n.filter(({complete:i})=>i).sort((i,r)=>t(r)-t(i))[0]}function qy(n,e){let[t,i]=[e-n.lower,n.upper-e];return t<i?{room:t,error:n.lowerError}:{room:i,error:n.upperError}}function Xy(n,e,t){let i=Wy(n,e),{factor:r}=t,s=(l,c)=>Ht(l/r,c/r),o=(l,c)=>Kn(s(l,c),t);if(i===void 0)return{gap:"none complete below the last band"};let a=e===void 0?void 0:qy(i,e);return{gap:Kn(`${s(i.lower,i.lowerError)} to ${s(i.upper,i.upperError)}`,t),width:o(i.upper-i.lower,i.lowerError+i.upperError),...a&&e!==void 0?{[`margin at ${Kn(Hr(e/r),t)}`]:o(a.room,a.error)}:{}}}function $y({gaps:n,carrier:e,unit:t}){let i=Wy(n,e),r=i!==void 0&&i.upper-i.lower>i.lowerError+i.upperError;return u("dl",{class:"edges",children:[Object.entries(Xy(n,e,t)).map(([s,o])=>u("div",{children:[u("dt",{children:s}),u("dd",{children:o})]})),i!==void 0&&!r&&u("div",{children:[u("dt",{children:"narrower than its errors"}),u("dd",{children:"may be closed"})]})]})}function Yy({held:n,now:e,unit:t,isPreview:i,drop:r}){let s=({gaps:l,carrier:c})=>Xy(l,c,t),a=[...Object.keys(e.design).filter(l=>e.design[l]!==n.design[l]).map(l=>[l,n.design[l]??"",e.design[l]??""]),...[...new Set([...Object.keys(s(n)),...Object.keys(s(e))])].map(l=>[l,s(n)[l]??"",s(e)[l]??""])];return u("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Held design and this one",children:[u("table",{children:[u("caption",{children:"Held design and this one"}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"quantity"}),u("th",{scope:"col",children:"held"}),u("th",{scope:"col",children:i?"preview":"this design"})]})}),u("tbody",{children:a.map(([l,c,h])=>u("tr",{children:[u("th",{scope:"row",children:l}),u("td",{children:c}),u("td",{children:h})]}))})]}),u("button",{type:"button",onClick:r,children:"Let go of the held design"})]})}function DA(){return matchMedia("(prefers-reduced-motion: reduce)").matches}var Zr=()=>({playing:re(!DA()),pace:re(.7)}),no=class{constructor({playing:e,pace:t},i,...r){this.draw=i;for(let a of r)this.seen.observe(a);let s=0,o=a=>{s>0&&(this.moment=(this.moment+(a-s)/1e3*t.peek())%1),s=a,!document.hidden&&this.hidden.size<r.length&&i(),this.frame=requestAnimationFrame(o)};this.stop=Je(()=>{cancelAnimationFrame(this.frame),s=0,e.value&&(this.frame=requestAnimationFrame(o))})}draw;moment=0;frame=0;stop;hidden=new Set;seen=new IntersectionObserver(e=>{for(let{target:t,isIntersecting:i}of e)i?this.hidden.delete(t):this.hidden.add(t)});at(e){this.moment=e,this.draw()}end(){cancelAnimationFrame(this.frame),this.seen.disconnect(),this.stop()}};var sh=6,oh=.5;function Ky(n){let e=n.gaps[0];return{point:re(e?n.belowGap(e):{row:n.corners[1]?.row??0,band:0}),...Zr(),swing:re(.15),copies:re([2,2]),unit:re(Qi(n.units,Math.max(...n.frequency))),wavevectorUnit:re(n.wavevectorUnits[1]),listing:re("none"),held:re(null)}}function ah(n,{row:e,band:t},i,r){return{row:Math.min(Math.max(e+i,0),n.rows-1),band:Math.min(Math.max(t+r,0),n.bands-1)}}function Zy(n,{band:e}){let t=[...n.gaps].filter(r=>r.waves==="all").sort((r,s)=>r.below-s.below),i=t.find(r=>r.below-1>e)??t[0];return i&&n.belowGap(i)}var NA=10,Jy=.05;function jy(n,e,t){let i=(o,a)=>e.point.value=ah(n,e.point.value,o,a),r=o=>e.swing.value=Math.min(Math.max(e.swing.value+o,0),oh),s=o=>o.shiftKey?NA:1;return[{keys:"← →",effect:"previous or next wavevector; ten with Shift",actions:{ArrowLeft:o=>i(-s(o),0),ArrowRight:o=>i(s(o),0)}},{keys:"↑ ↓",effect:"next higher or lower band",actions:{ArrowUp:()=>i(0,1),ArrowDown:()=>i(0,-1)}},Gr(e),{keys:"+ −",effect:"larger or smaller displacement",actions:{"+":()=>r(Jy),"-":()=>r(-Jy)}},{keys:"g",effect:"lower edge of the next gap",actions:{g:()=>e.point.value=Zy(n,e.point.value)??e.point.value}},...t?[{keys:"h",effect:"hold this design, or let it go",actions:{h:t}}]:[],...yi(e.listing)]}var Ja=q1(hx(),1);function hh(n,e){let t=document.createElement("a");t.href=URL.createObjectURL(n),t.download=e,t.click(),setTimeout(()=>URL.revokeObjectURL(t.href),6e4)}var dh=40,fh=40,Dm="video/webm",nC=6,dx=new WeakMap;function ja(n,e){dx.set(n,e)}function Qa({canvas:n,name:e,caption:t}){let[i,r]=Rt(""),s=typeof MediaRecorder<"u"&&MediaRecorder.isTypeSupported(Dm),o=(a,l)=>async()=>{if(n.current!==null){r(`The ${a} is made.`),await new Promise(c=>setTimeout(c,fh));try{hh(await l(new Nm(n.current,t)),`${e}.${a.toLowerCase()}`),r("")}catch(c){r(`The ${a} cannot be made: ${String(c)}`)}}};return u("p",{class:"sides film",children:[u("span",{children:"Save the motion"}),u("button",{type:"button",onClick:()=>{o("GIF",iC)()},children:"GIF"}),s&&u("button",{type:"button",onClick:()=>{o("WebM",rC)()},children:"WebM"}),u("span",{role:"status",children:i})]})}var Nm=class{constructor(e,t){this.canvas=e;this.caption=t;let i=dx.get(e),r=this.copy.getContext("2d",{willReadFrequently:!0});if(i===void 0||r===null)throw new Error("the canvas does not move");[this.draw,this.context]=[i,r],[this.copy.width,this.copy.height]=[e.width,e.height]}canvas;caption;copy=document.createElement("canvas");context;draw;show(e){let{context:t,copy:i}=this;this.draw(e),t.fillStyle=Xe("panel"),t.fillRect(0,0,i.width,i.height),t.drawImage(this.canvas,0,0),t.font=`${13*devicePixelRatio}px system-ui, sans-serif`,t.fillStyle=Xe("ink");let r=nC*devicePixelRatio;return t.fillText(this.caption,r,i.height-r,i.width-2*r),t}};async function iC(n){let{width:e,height:t}=n.copy,i=(0,Ja.GIFEncoder)(),r;for(let s=0;s<dh;s++){let{data:o}=n.show(s/dh).getImageData(0,0,e,t);r??=(0,Ja.quantize)(o,256),i.writeFrame((0,Ja.applyPalette)(o,r),e,t,s===0?{palette:r,delay:fh}:{delay:fh}),s%5===4&&await new Promise(a=>setTimeout(a))}return i.finish(),new Blob([i.bytes()],{type:"image/gif"})}async function rC(n){n.show(0);let e=n.copy.captureStream(),t=new MediaRecorder(e,{mimeType:Dm,videoBitsPerSecond:8e6}),i=[];t.ondataavailable=({data:o})=>i.push(o);let r=new Promise(o=>t.onstop=o);t.start();let s=performance.now();for(let o=0;o<dh;o++){n.show(o/dh);let a=s+(o+1)*fh-performance.now();await new Promise(l=>setTimeout(l,a))}t.stop(),await r;for(let o of e.getTracks())o.stop();return new Blob(i,{type:Dm})}var go={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},vo={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Bx=0,ag=1,zx=2;var Xc=1,Gx=2,Ml=3,_o=0,pi=1,or=2,oa=0,Tl=1,lg=2,cg=3,ug=4,Vx=5;var aa=100,Hx=101,Wx=102,qx=103,Xx=104,$x=200,Yx=201,Kx=202,Zx=203,hg=204,dg=205,Jx=206,jx=207,Qx=208,eb=209,tb=210,nb=211,ib=212,rb=213,sb=214,kh=0,Bh=1,zh=2,pl=3,Gh=4,Vh=5,Hh=6,Wh=7,fg=0,ob=1,ab=2,ts=0,pg=1,mg=2,gg=3,vg=4,_g=5,yg=6,xg=7;var bg=300,la=301,El=302,_d=303,yd=304,qh=1e3,jr=1001,Xh=1002,qn=1003,lb=1004;var $c=1005;var Zn=1006,xd=1007;var Rs=1008;var Xi=1009,Sg=1010,wg=1011,Al=1012,bd=1013,Mr=1014,Tr=1015,Er=1016,Sd=1017,wd=1018,ca=1020,Mg=35902,Tg=35899,Eg=1021,Ag=1022,Ar=1023,As=1026,Is=1027,Cg=1028,Md=1029,yo=1030,Td=1031;var Ed=1033,Yc=33776,Kc=33777,Zc=33778,Jc=33779,Ad=35840,Cd=35841,Pd=35842,Rd=35843,Id=36196,Ld=37492,Dd=37496,Nd=37488,Fd=37489,jc=37490,Ud=37491,Od=37808,kd=37809,Bd=37810,zd=37811,Gd=37812,Vd=37813,Hd=37814,Wd=37815,qd=37816,Xd=37817,$d=37818,Yd=37819,Kd=37820,Zd=37821,Jd=36492,jd=36494,Qd=36495,ef=36283,tf=36284,Qc=36285,nf=36286;var Cc=2300,$h=2301,Uh=2302,tg=2303,ng=2400,ig=2401,rg=2402;var cb=3200;var Pg=0,ub=1,Ls="",Bi="srgb",Pc="srgb-linear",Rc="linear",Ot="srgb";var Oh=7680;var hb=519,db=512,fb=513,pb=514,Rg=515,mb=516,gb=517,Ig=518,Lg=519,vb=35044;var Dg="300 es",rr=2e3,Ic=2001;function sC(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function oC(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Lc(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function _b(){let n=Lc("canvas");return n.style.display="block",n}var fx={},ml=null;function Ng(...n){let e="THREE."+n.shift();ml?ml("log",e,...n):console.log(e,...n)}function yb(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function je(...n){n=yb(n);let e="THREE."+n.shift();if(ml)ml("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function st(...n){n=yb(n);let e="THREE."+n.shift();if(ml)ml("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Tc(...n){let e=n.join(" ");e in fx||(fx[e]=!0,je(...n))}function xb(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var bb={[kh]:kh,[zh]:Hh,[Gh]:Gh,[pl]:Vh,[Bh]:Bh,[Hh]:zh,[Wh]:Wh,[Vh]:pl},wr=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},ei=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],px=1234567,Ec=Math.PI/180,gl=180/Math.PI;function Cl(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ei[n&255]+ei[n>>8&255]+ei[n>>16&255]+ei[n>>24&255]+"-"+ei[e&255]+ei[e>>8&255]+"-"+ei[e>>16&15|64]+ei[e>>24&255]+"-"+ei[t&63|128]+ei[t>>8&255]+"-"+ei[t>>16&255]+ei[t>>24&255]+ei[i&255]+ei[i>>8&255]+ei[i>>16&255]+ei[i>>24&255]).toLowerCase()}function bt(n,e,t){return Math.max(e,Math.min(t,n))}function Fg(n,e){return(n%e+e)%e}function aC(n,e,t,i,r){return i+(n-e)*(r-i)/(t-e)}function lC(n,e,t){return n!==e?(t-n)/(e-n):0}function Ac(n,e,t){return(1-t)*n+t*e}function cC(n,e,t,i){return Ac(n,e,1-Math.exp(-t*i))}function uC(n,e=1){return e-Math.abs(Fg(n,e*2)-e)}function hC(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function dC(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function fC(n,e){return n+Math.floor(Math.random()*(e-n+1))}function pC(n,e){return n+Math.random()*(e-n)}function mC(n){return n*(.5-Math.random())}function gC(n){n!==void 0&&(px=n);let e=px+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function vC(n){return n*Ec}function _C(n){return n*gl}function yC(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function xC(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Ug(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function bC(n,e,t,i,r){let s=Math.cos,o=Math.sin,a=s(t/2),l=o(t/2),c=s((e+i)/2),h=o((e+i)/2),d=s((e-i)/2),f=o((e-i)/2),p=s((i-e)/2),m=o((i-e)/2);switch(r){case"XYX":n.set(a*h,l*d,l*f,a*c);break;case"YZY":n.set(l*f,a*h,l*d,a*c);break;case"ZXZ":n.set(l*d,l*f,a*h,a*c);break;case"XZX":n.set(a*h,l*m,l*p,a*c);break;case"YXY":n.set(l*p,a*h,l*m,a*c);break;case"ZYZ":n.set(l*m,l*p,a*h,a*c);break;default:je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function Og(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Sb(n,e){if(e.constructor===Float32Array)return n;let t=Og(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function wb(n,e){if(e.constructor===Float32Array)return n;let t=Og(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var kg={DEG2RAD:Ec,RAD2DEG:gl,generateUUID:Cl,clamp:bt,euclideanModulo:Fg,mapLinear:aC,inverseLerp:lC,lerp:Ac,damp:cC,pingpong:uC,smoothstep:hC,smootherstep:dC,randInt:fC,randFloat:pC,randFloatSpread:mC,seededRandom:gC,degToRad:vC,radToDeg:_C,isPowerOfTwo:yC,ceilPowerOfTwo:xC,floorPowerOfTwo:Ug,setQuaternionFromProperEuler:bC,normalize:wb,denormalize:Sb},at=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(bt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Gi=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],h=i[r+2],d=i[r+3],f=s[o+0],p=s[o+1],m=s[o+2],_=s[o+3];if(d!==_||l!==f||c!==p||h!==m){let v=l*f+c*p+h*m+d*_;v<0&&(f=-f,p=-p,m=-m,_=-_,v=-v);let g=1-a;if(v<.9995){let x=Math.acos(v),A=Math.sin(x);g=Math.sin(g*x)/A,a=Math.sin(a*x)/A,l=l*g+f*a,c=c*g+p*a,h=h*g+m*a,d=d*g+_*a}else{l=l*g+f*a,c=c*g+p*a,h=h*g+m*a,d=d*g+_*a;let x=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=x,c*=x,h*=x,d*=x}}e[t]=l,e[t+1]=c,e[t+2]=h,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],h=i[r+3],d=s[o],f=s[o+1],p=s[o+2],m=s[o+3];return e[t]=a*m+h*d+l*p-c*f,e[t+1]=l*m+h*f+c*d-a*p,e[t+2]=c*m+h*p+a*f-l*d,e[t+3]=h*m-a*d-l*f-c*p,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(r/2),d=a(s/2),f=l(i/2),p=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*h*d+c*p*m,this._y=c*p*d-f*h*m,this._z=c*h*m+f*p*d,this._w=c*h*d-f*p*m;break;case"YXZ":this._x=f*h*d+c*p*m,this._y=c*p*d-f*h*m,this._z=c*h*m-f*p*d,this._w=c*h*d+f*p*m;break;case"ZXY":this._x=f*h*d-c*p*m,this._y=c*p*d+f*h*m,this._z=c*h*m+f*p*d,this._w=c*h*d-f*p*m;break;case"ZYX":this._x=f*h*d-c*p*m,this._y=c*p*d+f*h*m,this._z=c*h*m-f*p*d,this._w=c*h*d+f*p*m;break;case"YZX":this._x=f*h*d+c*p*m,this._y=c*p*d+f*h*m,this._z=c*h*m-f*p*d,this._w=c*h*d-f*p*m;break;case"XZY":this._x=f*h*d-c*p*m,this._y=c*p*d-f*h*m,this._z=c*h*m+f*p*d,this._w=c*h*d+f*p*m;break;default:je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],h=t[6],d=t[10],f=i+a+d;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(h-l)*p,this._y=(s-c)*p,this._z=(o-r)*p}else if(i>a&&i>d){let p=2*Math.sqrt(1+i-a-d);this._w=(h-l)/p,this._x=.25*p,this._y=(r+o)/p,this._z=(s+c)/p}else if(a>d){let p=2*Math.sqrt(1+a-i-d);this._w=(s-c)/p,this._x=(r+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+d-i-a);this._w=(o-r)/p,this._x=(s+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(bt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,h=t._w;return this._x=i*h+o*a+r*c-s*l,this._y=r*h+o*l+s*a-i*c,this._z=s*h+o*c+i*l-r*a,this._w=o*h-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,t=Math.sin(t*c)/h,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Z=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(mx.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(mx.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),h=2*(a*t-s*r),d=2*(s*i-o*t);return this.x=t+l*c+o*d-a*h,this.y=i+l*h+a*c-s*d,this.z=r+l*d+s*h-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Fm.copy(this).projectOnVector(e),this.sub(Fm)}reflect(e){return this.sub(Fm.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(bt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Fm=new Z,mx=new Gi,it=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let h=this.elements;return h[0]=e,h[1]=r,h[2]=a,h[3]=t,h[4]=s,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],d=i[7],f=i[2],p=i[5],m=i[8],_=r[0],v=r[3],g=r[6],x=r[1],A=r[4],S=r[7],P=r[2],C=r[5],y=r[8];return s[0]=o*_+a*x+l*P,s[3]=o*v+a*A+l*C,s[6]=o*g+a*S+l*y,s[1]=c*_+h*x+d*P,s[4]=c*v+h*A+d*C,s[7]=c*g+h*S+d*y,s[2]=f*_+p*x+m*P,s[5]=f*v+p*A+m*C,s[8]=f*g+p*S+m*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8];return t*o*h-t*a*c-i*s*h+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=h*o-a*c,f=a*l-h*s,p=c*s-o*l,m=t*d+i*f+r*p;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/m;return e[0]=d*_,e[1]=(r*c-h*i)*_,e[2]=(a*i-r*o)*_,e[3]=f*_,e[4]=(h*t-r*l)*_,e[5]=(r*s-a*t)*_,e[6]=p*_,e[7]=(i*l-c*t)*_,e[8]=(o*t-i*s)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Tc("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Um.makeScale(e,t)),this}rotate(e){return Tc("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Um.makeRotation(-e)),this}translate(e,t){return Tc("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Um.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Um=new it,gx=new it().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),vx=new it().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function SC(){let n={enabled:!0,workingColorSpace:Pc,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Ot&&(r.r=Es(r.r),r.g=Es(r.g),r.b=Es(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ot&&(r.r=fl(r.r),r.g=fl(r.g),r.b=fl(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Ls?Rc:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Pc]:{primaries:e,whitePoint:i,transfer:Rc,toXYZ:gx,fromXYZ:vx,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Bi},outputColorSpaceConfig:{drawingBufferColorSpace:Bi}},[Bi]:{primaries:e,whitePoint:i,transfer:Ot,toXYZ:gx,fromXYZ:vx,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Bi}}}),n}var Tt=SC();function Es(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function fl(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var el,Yh=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{el===void 0&&(el=Lc("canvas")),el.width=e.width,el.height=e.height;let r=el.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=el}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Lc("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Es(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Es(t[i]/255)*255):t[i]=Es(t[i]);return{data:t,width:e.width,height:e.height}}else return je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},wC=0,vl=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:wC++}),this.uuid=Cl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Om(r[o].image)):s.push(Om(r[o]))}else s=Om(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function Om(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Yh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(je("Texture: Unable to serialize Texture."),{})}var MC=0,km=new Z,Si=class n extends wr{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=jr,r=jr,s=Zn,o=Rs,a=Ar,l=Xi,c=n.DEFAULT_ANISOTROPY,h=Ls){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:MC++}),this.uuid=Cl(),this.name="",this.source=new vl(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new at(0,0),this.repeat=new at(1,1),this.center=new at(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new it,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(km).x}get height(){return this.source.getSize(km).y}get depth(){return this.source.getSize(km).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){je(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==bg)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case qh:e.x=e.x-Math.floor(e.x);break;case jr:e.x=e.x<0?0:1;break;case Xh:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case qh:e.y=e.y-Math.floor(e.y);break;case jr:e.y=e.y<0?0:1;break;case Xh:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Si.DEFAULT_IMAGE=null;Si.DEFAULT_MAPPING=bg;Si.DEFAULT_ANISOTROPY=1;var un=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],h=l[4],d=l[8],f=l[1],p=l[5],m=l[9],_=l[2],v=l[6],g=l[10];if(Math.abs(h-f)<.01&&Math.abs(d-_)<.01&&Math.abs(m-v)<.01){if(Math.abs(h+f)<.1&&Math.abs(d+_)<.1&&Math.abs(m+v)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(c+1)/2,S=(p+1)/2,P=(g+1)/2,C=(h+f)/4,y=(d+_)/4,T=(m+v)/4;return A>S&&A>P?A<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(A),r=C/i,s=y/i):S>P?S<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(S),i=C/r,s=T/r):P<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(P),i=y/s,r=T/s),this.set(i,r,s,t),this}let x=Math.sqrt((v-m)*(v-m)+(d-_)*(d-_)+(f-h)*(f-h));return Math.abs(x)<.001&&(x=1),this.x=(v-m)/x,this.y=(d-_)/x,this.z=(f-h)/x,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=bt(this.x,e.x,t.x),this.y=bt(this.y,e.y,t.y),this.z=bt(this.z,e.z,t.z),this.w=bt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=bt(this.x,e,t),this.y=bt(this.y,e,t),this.z=bt(this.z,e,t),this.w=bt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(bt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Kh=class extends wr{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Zn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new un(0,0,e,t),this.scissorTest=!1,this.viewport=new un(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new Si({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Zn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new vl(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Vi=class extends Kh{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Dc=class extends Si{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=qn,this.minFilter=qn,this.wrapR=jr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Zh=class extends Si{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=qn,this.minFilter=qn,this.wrapR=jr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var cn=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,h,d,f,p,m,_,v){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,h,d,f,p,m,_,v)}set(e,t,i,r,s,o,a,l,c,h,d,f,p,m,_,v){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=r,g[1]=s,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=d,g[14]=f,g[3]=p,g[7]=m,g[11]=_,g[15]=v,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/tl.setFromMatrixColumn(e,0).length(),s=1/tl.setFromMatrixColumn(e,1).length(),o=1/tl.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),h=Math.cos(s),d=Math.sin(s);if(e.order==="XYZ"){let f=o*h,p=o*d,m=a*h,_=a*d;t[0]=l*h,t[4]=-l*d,t[8]=c,t[1]=p+m*c,t[5]=f-_*c,t[9]=-a*l,t[2]=_-f*c,t[6]=m+p*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*h,p=l*d,m=c*h,_=c*d;t[0]=f+_*a,t[4]=m*a-p,t[8]=o*c,t[1]=o*d,t[5]=o*h,t[9]=-a,t[2]=p*a-m,t[6]=_+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*h,p=l*d,m=c*h,_=c*d;t[0]=f-_*a,t[4]=-o*d,t[8]=m+p*a,t[1]=p+m*a,t[5]=o*h,t[9]=_-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*h,p=o*d,m=a*h,_=a*d;t[0]=l*h,t[4]=m*c-p,t[8]=f*c+_,t[1]=l*d,t[5]=_*c+f,t[9]=p*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,p=o*c,m=a*l,_=a*c;t[0]=l*h,t[4]=_-f*d,t[8]=m*d+p,t[1]=d,t[5]=o*h,t[9]=-a*h,t[2]=-c*h,t[6]=p*d+m,t[10]=f-_*d}else if(e.order==="XZY"){let f=o*l,p=o*c,m=a*l,_=a*c;t[0]=l*h,t[4]=-d,t[8]=c*h,t[1]=f*d+_,t[5]=o*h,t[9]=p*d-m,t[2]=m*d-p,t[6]=a*h,t[10]=_*d+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(TC,e,EC)}lookAt(e,t,i){let r=this.elements;return Oi.subVectors(e,t),Oi.lengthSq()===0&&(Oi.z=1),Oi.normalize(),ro.crossVectors(i,Oi),ro.lengthSq()===0&&(Math.abs(i.z)===1?Oi.x+=1e-4:Oi.z+=1e-4,Oi.normalize(),ro.crossVectors(i,Oi)),ro.normalize(),ph.crossVectors(Oi,ro),r[0]=ro.x,r[4]=ph.x,r[8]=Oi.x,r[1]=ro.y,r[5]=ph.y,r[9]=Oi.y,r[2]=ro.z,r[6]=ph.z,r[10]=Oi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],d=i[5],f=i[9],p=i[13],m=i[2],_=i[6],v=i[10],g=i[14],x=i[3],A=i[7],S=i[11],P=i[15],C=r[0],y=r[4],T=r[8],U=r[12],D=r[1],L=r[5],B=r[9],G=r[13],F=r[2],H=r[6],Y=r[10],V=r[14],le=r[3],X=r[7],Q=r[11],se=r[15];return s[0]=o*C+a*D+l*F+c*le,s[4]=o*y+a*L+l*H+c*X,s[8]=o*T+a*B+l*Y+c*Q,s[12]=o*U+a*G+l*V+c*se,s[1]=h*C+d*D+f*F+p*le,s[5]=h*y+d*L+f*H+p*X,s[9]=h*T+d*B+f*Y+p*Q,s[13]=h*U+d*G+f*V+p*se,s[2]=m*C+_*D+v*F+g*le,s[6]=m*y+_*L+v*H+g*X,s[10]=m*T+_*B+v*Y+g*Q,s[14]=m*U+_*G+v*V+g*se,s[3]=x*C+A*D+S*F+P*le,s[7]=x*y+A*L+S*H+P*X,s[11]=x*T+A*B+S*Y+P*Q,s[15]=x*U+A*G+S*V+P*se,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],h=e[2],d=e[6],f=e[10],p=e[14],m=e[3],_=e[7],v=e[11],g=e[15],x=l*p-c*f,A=a*p-c*d,S=a*f-l*d,P=o*p-c*h,C=o*f-l*h,y=o*d-a*h;return t*(_*x-v*A+g*S)-i*(m*x-v*P+g*C)+r*(m*A-_*P+g*y)-s*(m*S-_*C+v*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],h=e[10];return t*(o*h-a*c)-i*(s*h-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],h=e[8],d=e[9],f=e[10],p=e[11],m=e[12],_=e[13],v=e[14],g=e[15],x=t*a-i*o,A=t*l-r*o,S=t*c-s*o,P=i*l-r*a,C=i*c-s*a,y=r*c-s*l,T=h*_-d*m,U=h*v-f*m,D=h*g-p*m,L=d*v-f*_,B=d*g-p*_,G=f*g-p*v,F=x*G-A*B+S*L+P*D-C*U+y*T;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/F;return e[0]=(a*G-l*B+c*L)*H,e[1]=(r*B-i*G-s*L)*H,e[2]=(_*y-v*C+g*P)*H,e[3]=(f*C-d*y-p*P)*H,e[4]=(l*D-o*G-c*U)*H,e[5]=(t*G-r*D+s*U)*H,e[6]=(v*S-m*y-g*A)*H,e[7]=(h*y-f*S+p*A)*H,e[8]=(o*B-a*D+c*T)*H,e[9]=(i*D-t*B-s*T)*H,e[10]=(m*C-_*S+g*x)*H,e[11]=(d*S-h*C-p*x)*H,e[12]=(a*U-o*L-l*T)*H,e[13]=(t*L-i*U+r*T)*H,e[14]=(_*A-m*P-v*x)*H,e[15]=(h*P-d*A+f*x)*H,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,h=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,h*a+i,h*l-r*o,0,c*l-r*a,h*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,h=o+o,d=a+a,f=s*c,p=s*h,m=s*d,_=o*h,v=o*d,g=a*d,x=l*c,A=l*h,S=l*d,P=i.x,C=i.y,y=i.z;return r[0]=(1-(_+g))*P,r[1]=(p+S)*P,r[2]=(m-A)*P,r[3]=0,r[4]=(p-S)*C,r[5]=(1-(f+g))*C,r[6]=(v+x)*C,r[7]=0,r[8]=(m+A)*y,r[9]=(v-x)*y,r[10]=(1-(f+_))*y,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=tl.set(r[0],r[1],r[2]).length(),a=tl.set(r[4],r[5],r[6]).length(),l=tl.set(r[8],r[9],r[10]).length();s<0&&(o=-o),xr.copy(this);let c=1/o,h=1/a,d=1/l;return xr.elements[0]*=c,xr.elements[1]*=c,xr.elements[2]*=c,xr.elements[4]*=h,xr.elements[5]*=h,xr.elements[6]*=h,xr.elements[8]*=d,xr.elements[9]*=d,xr.elements[10]*=d,t.setFromRotationMatrix(xr),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=rr,l=!1){let c=this.elements,h=2*s/(t-e),d=2*s/(i-r),f=(t+e)/(t-e),p=(i+r)/(i-r),m,_;if(l)m=s/(o-s),_=o*s/(o-s);else if(a===rr)m=-(o+s)/(o-s),_=-2*o*s/(o-s);else if(a===Ic)m=-o/(o-s),_=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=d,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=rr,l=!1){let c=this.elements,h=2/(t-e),d=2/(i-r),f=-(t+e)/(t-e),p=-(i+r)/(i-r),m,_;if(l)m=1/(o-s),_=o/(o-s);else if(a===rr)m=-2/(o-s),_=-(o+s)/(o-s);else if(a===Ic)m=-1/(o-s),_=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=d,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=m,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},tl=new Z,xr=new cn,TC=new Z(0,0,0),EC=new Z(1,1,1),ro=new Z,ph=new Z,Oi=new Z,_x=new cn,yx=new Gi,uo=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],h=r[9],d=r[2],f=r[6],p=r[10];switch(t){case"XYZ":this._y=Math.asin(bt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-bt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,s),this._z=0);break;case"ZXY":this._x=Math.asin(bt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-d,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-bt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(bt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,s)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-bt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-h,p),this._y=0);break;default:je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return _x.makeRotationFromQuaternion(e),this.setFromRotationMatrix(_x,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return yx.setFromEuler(this),this.setFromQuaternion(yx,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};uo.DEFAULT_ORDER="XYZ";var Nc=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},AC=0,xx=new Z,nl=new Gi,bs=new cn,mh=new Z,xc=new Z,CC=new Z,PC=new Gi,bx=new Z(1,0,0),Sx=new Z(0,1,0),wx=new Z(0,0,1),Mx={type:"added"},RC={type:"removed"},il={type:"childadded",child:null},Bm={type:"childremoved",child:null},Hi=class n extends wr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:AC++}),this.uuid=Cl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new Z,t=new uo,i=new Gi,r=new Z(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new cn},normalMatrix:{value:new it}}),this.matrix=new cn,this.matrixWorld=new cn,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Nc,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return nl.setFromAxisAngle(e,t),this.quaternion.multiply(nl),this}rotateOnWorldAxis(e,t){return nl.setFromAxisAngle(e,t),this.quaternion.premultiply(nl),this}rotateX(e){return this.rotateOnAxis(bx,e)}rotateY(e){return this.rotateOnAxis(Sx,e)}rotateZ(e){return this.rotateOnAxis(wx,e)}translateOnAxis(e,t){return xx.copy(e).applyQuaternion(this.quaternion),this.position.add(xx.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(bx,e)}translateY(e){return this.translateOnAxis(Sx,e)}translateZ(e){return this.translateOnAxis(wx,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(bs.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?mh.copy(e):mh.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),xc.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?bs.lookAt(xc,mh,this.up):bs.lookAt(mh,xc,this.up),this.quaternion.setFromRotationMatrix(bs),r&&(bs.extractRotation(r.matrixWorld),nl.setFromRotationMatrix(bs),this.quaternion.premultiply(nl.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(st("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Mx),il.child=e,this.dispatchEvent(il),il.child=null):st("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(RC),Bm.child=e,this.dispatchEvent(Bm),Bm.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),bs.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),bs.multiply(e.parent.matrixWorld)),e.applyMatrix4(bs),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Mx),il.child=e,this.dispatchEvent(il),il.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xc,e,CC),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(xc,PC,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let d=l[c];s(e.shapes,d)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),h=o(e.images),d=o(e.shapes),f=o(e.skeletons),p=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),d.length>0&&(i.shapes=d),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Hi.DEFAULT_UP=new Z(0,1,0);Hi.DEFAULT_MATRIX_AUTO_UPDATE=!0;Hi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var na=class extends Hi{constructor(){super(),this.isGroup=!0,this.type="Group"}},IC={type:"move"},_l=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new na,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new na,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new na,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let _ of e.hand.values()){let v=t.getJointPose(_,i),g=this._getHandJoint(c,_);v!==null&&(g.matrix.fromArray(v.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=v.radius),g.visible=v!==null}let h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],f=h.position.distanceTo(d.position),p=.02,m=.005;c.inputState.pinching&&f>p+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=p-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(IC)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new na;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Mb={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},so={h:0,s:0,l:0},gh={h:0,s:0,l:0};function zm(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var Et=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Bi){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Tt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=Tt.workingColorSpace){return this.r=e,this.g=t,this.b=i,Tt.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=Tt.workingColorSpace){if(e=Fg(e,1),t=bt(t,0,1),i=bt(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=zm(o,s,e+1/3),this.g=zm(o,s,e),this.b=zm(o,s,e-1/3)}return Tt.colorSpaceToWorking(this,r),this}setStyle(e,t=Bi){function i(s){s!==void 0&&parseFloat(s)<1&&je("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:je("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Bi){let i=Mb[e.toLowerCase()];return i!==void 0?this.setHex(i,t):je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Es(e.r),this.g=Es(e.g),this.b=Es(e.b),this}copyLinearToSRGB(e){return this.r=fl(e.r),this.g=fl(e.g),this.b=fl(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Bi){return Tt.workingToColorSpace(ti.copy(this),e),Math.round(bt(ti.r*255,0,255))*65536+Math.round(bt(ti.g*255,0,255))*256+Math.round(bt(ti.b*255,0,255))}getHexString(e=Bi){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Tt.workingColorSpace){Tt.workingToColorSpace(ti.copy(this),t);let i=ti.r,r=ti.g,s=ti.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case i:l=(r-s)/d+(r<s?6:0);break;case r:l=(s-i)/d+2;break;case s:l=(i-r)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=h,e}getRGB(e,t=Tt.workingColorSpace){return Tt.workingToColorSpace(ti.copy(this),t),e.r=ti.r,e.g=ti.g,e.b=ti.b,e}getStyle(e=Bi){Tt.workingToColorSpace(ti.copy(this),e);let t=ti.r,i=ti.g,r=ti.b;return e!==Bi?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(so),this.setHSL(so.h+e,so.s+t,so.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(so),e.getHSL(gh);let i=Ac(so.h,gh.h,t),r=Ac(so.s,gh.s,t),s=Ac(so.l,gh.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ti=new Et;Et.NAMES=Mb;var Fc=class extends Hi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new uo,this.environmentIntensity=1,this.environmentRotation=new uo,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},br=new Z,Ss=new Z,Gm=new Z,ws=new Z,rl=new Z,sl=new Z,Tx=new Z,Vm=new Z,Hm=new Z,Wm=new Z,qm=new un,Xm=new un,$m=new un,co=class n{constructor(e=new Z,t=new Z,i=new Z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),br.subVectors(e,t),r.cross(br);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){br.subVectors(r,t),Ss.subVectors(i,t),Gm.subVectors(e,t);let o=br.dot(br),a=br.dot(Ss),l=br.dot(Gm),c=Ss.dot(Ss),h=Ss.dot(Gm),d=o*c-a*a;if(d===0)return s.set(0,0,0),null;let f=1/d,p=(c*l-a*h)*f,m=(o*h-a*l)*f;return s.set(1-p-m,m,p)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,ws)===null?!1:ws.x>=0&&ws.y>=0&&ws.x+ws.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,ws)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,ws.x),l.addScaledVector(o,ws.y),l.addScaledVector(a,ws.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return qm.setScalar(0),Xm.setScalar(0),$m.setScalar(0),qm.fromBufferAttribute(e,t),Xm.fromBufferAttribute(e,i),$m.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(qm,s.x),o.addScaledVector(Xm,s.y),o.addScaledVector($m,s.z),o}static isFrontFacing(e,t,i,r){return br.subVectors(i,t),Ss.subVectors(e,t),br.cross(Ss).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return br.subVectors(this.c,this.b),Ss.subVectors(this.a,this.b),br.cross(Ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;rl.subVectors(r,i),sl.subVectors(s,i),Vm.subVectors(e,i);let l=rl.dot(Vm),c=sl.dot(Vm);if(l<=0&&c<=0)return t.copy(i);Hm.subVectors(e,r);let h=rl.dot(Hm),d=sl.dot(Hm);if(h>=0&&d<=h)return t.copy(r);let f=l*d-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),t.copy(i).addScaledVector(rl,o);Wm.subVectors(e,s);let p=rl.dot(Wm),m=sl.dot(Wm);if(m>=0&&p<=m)return t.copy(s);let _=p*c-l*m;if(_<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(sl,a);let v=h*m-p*d;if(v<=0&&d-h>=0&&p-m>=0)return Tx.subVectors(s,r),a=(d-h)/(d-h+(p-m)),t.copy(r).addScaledVector(Tx,a);let g=1/(v+_+f);return o=_*g,a=f*g,t.copy(i).addScaledVector(rl,o).addScaledVector(sl,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Qr=class{constructor(e=new Z(1/0,1/0,1/0),t=new Z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Sr.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Sr.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Sr.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Sr):Sr.fromBufferAttribute(s,o),Sr.applyMatrix4(e.matrixWorld),this.expandByPoint(Sr);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),vh.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),vh.copy(i.boundingBox)),vh.applyMatrix4(e.matrixWorld),this.union(vh)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Sr),Sr.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(bc),_h.subVectors(this.max,bc),ol.subVectors(e.a,bc),al.subVectors(e.b,bc),ll.subVectors(e.c,bc),oo.subVectors(al,ol),ao.subVectors(ll,al),jo.subVectors(ol,ll);let t=[0,-oo.z,oo.y,0,-ao.z,ao.y,0,-jo.z,jo.y,oo.z,0,-oo.x,ao.z,0,-ao.x,jo.z,0,-jo.x,-oo.y,oo.x,0,-ao.y,ao.x,0,-jo.y,jo.x,0];return!Ym(t,ol,al,ll,_h)||(t=[1,0,0,0,1,0,0,0,1],!Ym(t,ol,al,ll,_h))?!1:(yh.crossVectors(oo,ao),t=[yh.x,yh.y,yh.z],Ym(t,ol,al,ll,_h))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Sr).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Sr).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ms[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ms[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ms[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ms[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ms[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ms[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ms[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ms[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ms),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ms=[new Z,new Z,new Z,new Z,new Z,new Z,new Z,new Z],Sr=new Z,vh=new Qr,ol=new Z,al=new Z,ll=new Z,oo=new Z,ao=new Z,jo=new Z,bc=new Z,_h=new Z,yh=new Z,Qo=new Z;function Ym(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){Qo.fromArray(n,s);let a=r.x*Math.abs(Qo.x)+r.y*Math.abs(Qo.y)+r.z*Math.abs(Qo.z),l=e.dot(Qo),c=t.dot(Qo),h=i.dot(Qo);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Cn=new Z,xh=new at,LC=0,fi=class extends wr{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:LC++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=vb,this.updateRanges=[],this.gpuType=Tr,this.version=0,this._normalizationScale=e!==void 0?Og(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)xh.fromBufferAttribute(this,t),xh.applyMatrix3(e),this.setXY(t,xh.x,xh.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.applyMatrix3(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.applyMatrix4(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.applyNormalMatrix(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)Cn.fromBufferAttribute(this,t),Cn.transformDirection(e),this.setXYZ(t,Cn.x,Cn.y,Cn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Sb(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):wb(e,this.array)}};var Uc=class extends fi{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Oc=class extends fi{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var bi=class extends fi{constructor(e,t,i){super(new Float32Array(e),t,i)}},DC=new Qr,Sc=new Z,Km=new Z,Cs=class{constructor(e=new Z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):DC.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Sc.subVectors(e,this.center);let t=Sc.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(Sc,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Km.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Sc.copy(e.center).add(Km)),this.expandByPoint(Sc.copy(e.center).sub(Km))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},NC=0,ir=new cn,Zm=new Hi,cl=new Z,ki=new Qr,wc=new Qr,Wn=new Z,es=class n extends wr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:NC++}),this.uuid=Cl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(sC(e)?Oc:Uc)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new it().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return ir.makeRotationFromQuaternion(e),this.applyMatrix4(ir),this}rotateX(e){return ir.makeRotationX(e),this.applyMatrix4(ir),this}rotateY(e){return ir.makeRotationY(e),this.applyMatrix4(ir),this}rotateZ(e){return ir.makeRotationZ(e),this.applyMatrix4(ir),this}translate(e,t,i){return ir.makeTranslation(e,t,i),this.applyMatrix4(ir),this}scale(e,t,i){return ir.makeScale(e,t,i),this.applyMatrix4(ir),this}lookAt(e){return Zm.lookAt(e),Zm.updateMatrix(),this.applyMatrix4(Zm.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(cl).negate(),this.translate(cl.x,cl.y,cl.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new bi(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Z(-1/0,-1/0,-1/0),new Z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];ki.setFromBufferAttribute(s),this.morphTargetsRelative?(Wn.addVectors(this.boundingBox.min,ki.min),this.boundingBox.expandByPoint(Wn),Wn.addVectors(this.boundingBox.max,ki.max),this.boundingBox.expandByPoint(Wn)):(this.boundingBox.expandByPoint(ki.min),this.boundingBox.expandByPoint(ki.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&st('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Cs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Z,1/0);return}if(e){let i=this.boundingSphere.center;if(ki.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];wc.setFromBufferAttribute(a),this.morphTargetsRelative?(Wn.addVectors(ki.min,wc.min),ki.expandByPoint(Wn),Wn.addVectors(ki.max,wc.max),ki.expandByPoint(Wn)):(ki.expandByPoint(wc.min),ki.expandByPoint(wc.max))}ki.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Wn.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Wn));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Wn.fromBufferAttribute(a,c),l&&(cl.fromBufferAttribute(e,c),Wn.add(cl)),r=Math.max(r,i.distanceToSquared(Wn))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&st('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){st("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new fi(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let U=0;U<i.count;U++)a[U]=new Z,l[U]=new Z;let h=new Z,d=new Z,f=new Z,p=new at,m=new at,_=new at,v=new Z,g=new Z;function x(U,D,L){c[U]=c[D]=c[L]=1,h.fromBufferAttribute(i,U),d.fromBufferAttribute(i,D),f.fromBufferAttribute(i,L),p.fromBufferAttribute(s,U),m.fromBufferAttribute(s,D),_.fromBufferAttribute(s,L),d.sub(h),f.sub(h),m.sub(p),_.sub(p);let B=1/(m.x*_.y-_.x*m.y);isFinite(B)&&(v.copy(d).multiplyScalar(_.y).addScaledVector(f,-m.y).multiplyScalar(B),g.copy(f).multiplyScalar(m.x).addScaledVector(d,-_.x).multiplyScalar(B),a[U].add(v),a[D].add(v),a[L].add(v),l[U].add(g),l[D].add(g),l[L].add(g))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let U=0,D=A.length;U<D;++U){let L=A[U],B=L.start,G=L.count;for(let F=B,H=B+G;F<H;F+=3)x(e.getX(F+0),e.getX(F+1),e.getX(F+2))}let S=new Z,P=new Z,C=new Z,y=new Z;function T(U){C.fromBufferAttribute(r,U),y.copy(C);let D=a[U];S.copy(D),S.sub(C.multiplyScalar(C.dot(D))).normalize(),P.crossVectors(y,D);let B=P.dot(l[U])<0?-1:1;o.setXYZW(U,S.x,S.y,S.z,B)}for(let U=0,D=i.count;U<D;++U)c[U]&&T(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new fi(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let r=new Z,s=new Z,o=new Z,a=new Z,l=new Z,c=new Z,h=new Z,d=new Z;if(e)for(let f=0,p=e.count;f<p;f+=3){let m=e.getX(f+0),_=e.getX(f+1),v=e.getX(f+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,_),o.fromBufferAttribute(t,v),h.subVectors(o,s),d.subVectors(r,s),h.cross(d),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,v),a.add(h),l.add(h),c.add(h),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(v,c.x,c.y,c.z)}else for(let f=0,p=t.count;f<p;f+=3)r.fromBufferAttribute(t,f+0),s.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),h.subVectors(o,s),d.subVectors(r,s),h.cross(d),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Wn.fromBufferAttribute(e,t),Wn.normalize(),e.setXYZ(t,Wn.x,Wn.y,Wn.z)}toNonIndexed(){function e(a,l){let c=a.array,h=a.itemSize,d=a.normalized,f=new c.constructor(l.length*h),p=0,m=0;for(let _=0,v=l.length;_<v;_++){a.isInterleavedBufferAttribute?p=l[_]*a.data.stride+a.offset:p=l[_]*h;for(let g=0;g<h;g++)f[m++]=c[p++]}return new fi(f,h,d)}if(this.index===null)return je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let h=0,d=c.length;h<d;h++){let f=c[h],p=e(f,i);l.push(p)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let d=0,f=c.length;d<f;d++){let p=c[d];h.push(p.toJSON(e.data))}h.length>0&&(r[l]=h,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let h=r[c];this.setAttribute(c,h.clone(t))}let s=e.morphAttributes;for(let c in s){let h=[],d=s[c];for(let f=0,p=d.length;f<p;f++)h.push(d[f].clone(t));this.morphAttributes[c]=h}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,h=o.length;c<h;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Jm=new Z,FC=new Z,UC=new it,zi=class{constructor(e=new Z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Jm.subVectors(i,t).cross(FC.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Jm),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||UC.getNormalMatrix(e),r=this.coplanarPoint(Jm).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},OC=0,ho=class extends wr{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:OC++}),this.uuid=Cl(),this.name="",this.type="Material",this.blending=Tl,this.side=_o,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=hg,this.blendDst=dg,this.blendEquation=aa,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Et(0,0,0),this.blendAlpha=0,this.depthFunc=pl,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=hb,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Oh,this.stencilZFail=Oh,this.stencilZPass=Oh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){je(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Et().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new zi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new at().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new at().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Ts=new Z,jm=new Z,bh=new Z,Sh=new Z,ia=class{constructor(e=new Z,t=new Z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Ts)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Ts.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Ts.copy(this.origin).addScaledVector(this.direction,t),Ts.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){jm.copy(e).add(t).multiplyScalar(.5),bh.copy(t).sub(e).normalize(),Sh.copy(this.origin).sub(jm);let s=e.distanceTo(t)*.5,o=-this.direction.dot(bh),a=Sh.dot(this.direction),l=-Sh.dot(bh),c=Sh.lengthSq(),h=Math.abs(1-o*o),d,f,p,m;if(h>0)if(d=o*l-a,f=o*a-l,m=s*h,d>=0)if(f>=-m)if(f<=m){let _=1/h;d*=_,f*=_,p=d*(d+o*f+2*a)+f*(o*d+f+2*l)+c}else f=s,d=Math.max(0,-(o*f+a)),p=-d*d+f*(f+2*l)+c;else f=-s,d=Math.max(0,-(o*f+a)),p=-d*d+f*(f+2*l)+c;else f<=-m?(d=Math.max(0,-(-o*s+a)),f=d>0?-s:Math.min(Math.max(-s,-l),s),p=-d*d+f*(f+2*l)+c):f<=m?(d=0,f=Math.min(Math.max(-s,-l),s),p=f*(f+2*l)+c):(d=Math.max(0,-(o*s+a)),f=d>0?s:Math.min(Math.max(-s,-l),s),p=-d*d+f*(f+2*l)+c);else f=o>0?-s:s,d=Math.max(0,-(o*f+a)),p=-d*d+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),r&&r.copy(jm).addScaledVector(bh,f),p}intersectSphere(e,t){if(e.radius<0)return null;Ts.subVectors(e.center,this.origin);let i=Ts.dot(this.direction),r=Ts.dot(Ts)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,f=this.origin;return c>=0?(i=(e.min.x-f.x)*c,r=(e.max.x-f.x)*c):(i=(e.max.x-f.x)*c,r=(e.min.x-f.x)*c),h>=0?(s=(e.min.y-f.y)*h,o=(e.max.y-f.y)*h):(s=(e.max.y-f.y)*h,o=(e.min.y-f.y)*h),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),d>=0?(a=(e.min.z-f.z)*d,l=(e.max.z-f.z)*d):(a=(e.max.z-f.z)*d,l=(e.min.z-f.z)*d),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Ts)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=e.x-o.x,f=e.y-o.y,p=e.z-o.z,m=t.x-o.x,_=t.y-o.y,v=t.z-o.z,g=i.x-o.x,x=i.y-o.y,A=i.z-o.z,S=Math.abs(l),P=Math.abs(c),C=Math.abs(h),y,T,U,D,L,B,G,F,H,Y,V,le;if(S>=P&&S>=C?(U=l,B=d,H=m,le=g,l>=0?(y=c,T=h,D=f,L=p,G=_,F=v,Y=x,V=A):(y=h,T=c,D=p,L=f,G=v,F=_,Y=A,V=x)):P>=C?(U=c,B=f,H=_,le=x,c>=0?(y=h,T=l,D=p,L=d,G=v,F=m,Y=A,V=g):(y=l,T=h,D=d,L=p,G=m,F=v,Y=g,V=A)):(U=h,B=p,H=v,le=A,h>=0?(y=l,T=c,D=d,L=f,G=m,F=_,Y=g,V=x):(y=c,T=l,D=f,L=d,G=_,F=m,Y=x,V=g)),U===0)return null;let X=y/U,Q=T/U,se=1/U,fe=D-X*B,de=L-Q*B,ee=G-X*H,ge=F-Q*H,ye=Y-X*le,Ce=V-Q*le,we=ye*ge-Ce*ee,$e=fe*Ce-de*ye,ut=ee*de-ge*fe;if(r){if(we<0||$e<0||ut<0)return null}else if((we<0||$e<0||ut<0)&&(we>0||$e>0||ut>0))return null;let We=we+$e+ut;if(We===0)return null;let _t=se*(we*B+$e*H+ut*le);return(We>0?_t<0:_t>0)?null:this.at(_t/We,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Jh=class extends ho{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Et(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new uo,this.combine=fg,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Ex=new cn,ea=new ia,wh=new Cs,Ax=new Z,Mh=new Z,Th=new Z,Eh=new Z,Qm=new Z,Ah=new Z,Cx=new Z,Ch=new Z,sr=class extends Hi{constructor(e=new es,t=new Jh){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){Ah.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let h=a[l],d=s[l];h!==0&&(Qm.fromBufferAttribute(d,e),o?Ah.addScaledVector(Qm,h):Ah.addScaledVector(Qm.sub(t),h))}t.add(Ah)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),wh.copy(i.boundingSphere),wh.applyMatrix4(s),ea.copy(e.ray).recast(e.near),!(wh.containsPoint(ea.origin)===!1&&(ea.intersectSphere(wh,Ax)===null||ea.origin.distanceToSquared(Ax)>(e.far-e.near)**2))&&(Ex.copy(s).invert(),ea.copy(e.ray).applyMatrix4(Ex),!(i.boundingBox!==null&&ea.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,ea)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,h=s.attributes.uv1,d=s.attributes.normal,f=s.groups,p=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,_=f.length;m<_;m++){let v=f[m],g=o[v.materialIndex],x=Math.max(v.start,p.start),A=Math.min(a.count,Math.min(v.start+v.count,p.start+p.count));for(let S=x,P=A;S<P;S+=3){let C=a.getX(S),y=a.getX(S+1),T=a.getX(S+2);r=Ph(this,g,e,i,c,h,d,C,y,T),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=v.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),_=Math.min(a.count,p.start+p.count);for(let v=m,g=_;v<g;v+=3){let x=a.getX(v),A=a.getX(v+1),S=a.getX(v+2);r=Ph(this,o,e,i,c,h,d,x,A,S),r&&(r.faceIndex=Math.floor(v/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,_=f.length;m<_;m++){let v=f[m],g=o[v.materialIndex],x=Math.max(v.start,p.start),A=Math.min(l.count,Math.min(v.start+v.count,p.start+p.count));for(let S=x,P=A;S<P;S+=3){let C=S,y=S+1,T=S+2;r=Ph(this,g,e,i,c,h,d,C,y,T),r&&(r.faceIndex=Math.floor(S/3),r.face.materialIndex=v.materialIndex,t.push(r))}}else{let m=Math.max(0,p.start),_=Math.min(l.count,p.start+p.count);for(let v=m,g=_;v<g;v+=3){let x=v,A=v+1,S=v+2;r=Ph(this,o,e,i,c,h,d,x,A,S),r&&(r.faceIndex=Math.floor(v/3),t.push(r))}}}};function kC(n,e,t,i,r,s,o,a){let l;if(e.side===pi?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===_o,a),l===null)return null;Ch.copy(a),Ch.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ch);return c<t.near||c>t.far?null:{distance:c,point:Ch.clone(),object:n}}function Ph(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,Mh),n.getVertexPosition(l,Th),n.getVertexPosition(c,Eh);let h=kC(n,e,t,i,Mh,Th,Eh,Cx);if(h){let d=new Z;co.getBarycoord(Cx,Mh,Th,Eh,d),r&&(h.uv=co.getInterpolatedAttribute(r,a,l,c,d,new at)),s&&(h.uv1=co.getInterpolatedAttribute(s,a,l,c,d,new at)),o&&(h.normal=co.getInterpolatedAttribute(o,a,l,c,d,new Z),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new Z,materialIndex:0};co.getNormal(Mh,Th,Eh,f.normal),h.face=f,h.barycoord=d}return h}var ra=class extends Si{constructor(e=null,t=1,i=1,r,s,o,a,l,c=qn,h=qn,d,f){super(null,o,a,l,c,h,r,s,d,f),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var yl=class extends fi{constructor(e,t,i,r=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}};var ta=new Cs,BC=new at(.5,.5),Rh=new Z,sa=class{constructor(e=new zi,t=new zi,i=new zi,r=new zi,s=new zi,o=new zi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=rr,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],h=s[4],d=s[5],f=s[6],p=s[7],m=s[8],_=s[9],v=s[10],g=s[11],x=s[12],A=s[13],S=s[14],P=s[15];if(r[0].setComponents(c-o,p-h,g-m,P-x).normalize(),r[1].setComponents(c+o,p+h,g+m,P+x).normalize(),r[2].setComponents(c+a,p+d,g+_,P+A).normalize(),r[3].setComponents(c-a,p-d,g-_,P-A).normalize(),i)r[4].setComponents(l,f,v,S).normalize(),r[5].setComponents(c-l,p-f,g-v,P-S).normalize();else if(r[4].setComponents(c-l,p-f,g-v,P-S).normalize(),t===rr)r[5].setComponents(c+l,p+f,g+v,P+S).normalize();else if(t===Ic)r[5].setComponents(l,f,v,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ta.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ta.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ta)}intersectsSprite(e){ta.center.set(0,0,0);let t=BC.distanceTo(e.center);return ta.radius=.7071067811865476+t,ta.applyMatrix4(e.matrixWorld),this.intersectsSphere(ta)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(Rh.x=r.normal.x>0?e.max.x:e.min.x,Rh.y=r.normal.y>0?e.max.y:e.min.y,Rh.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Rh)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Px=new cn,jh=class n{constructor(){this.coordinateSystem=rr,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];Px.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new sa),i[r].setFromProjectionMatrix(Px,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new sa),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Qh=class extends ho{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Et(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},ed=new Z,td=new Z,Rx=new cn,Mc=new ia,Ih=new Cs,eg=new Z,Ix=new Z,nd=class extends Hi{constructor(e=new es,t=new Qh){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let r=1,s=t.count;r<s;r++)ed.fromBufferAttribute(t,r-1),td.fromBufferAttribute(t,r),i[r]=i[r-1],i[r]+=ed.distanceTo(td);e.setAttribute("lineDistance",new bi(i,1))}else je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.matrixWorld,s=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Ih.copy(i.boundingSphere),Ih.applyMatrix4(r),Ih.radius+=s,e.ray.intersectsSphere(Ih)===!1)return;Rx.copy(r).invert(),Mc.copy(e.ray).applyMatrix4(Rx);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,f=i.attributes.position;if(h!==null){let p=Math.max(0,o.start),m=Math.min(h.count,o.start+o.count);for(let _=p,v=m-1;_<v;_+=c){let g=h.getX(_),x=h.getX(_+1),A=Lh(this,e,Mc,l,g,x,_);A&&t.push(A)}if(this.isLineLoop){let _=h.getX(m-1),v=h.getX(p),g=Lh(this,e,Mc,l,_,v,m-1);g&&t.push(g)}}else{let p=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let _=p,v=m-1;_<v;_+=c){let g=Lh(this,e,Mc,l,_,_+1,_);g&&t.push(g)}if(this.isLineLoop){let _=Lh(this,e,Mc,l,m-1,p,m-1);_&&t.push(_)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function Lh(n,e,t,i,r,s,o){let a=n.geometry.attributes.position;if(ed.fromBufferAttribute(a,r),td.fromBufferAttribute(a,s),t.distanceSqToSegment(ed,td,eg,Ix)>i)return;eg.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(eg);if(!(c<e.near||c>e.far))return{distance:c,point:Ix.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Lx=new Z,Dx=new Z,kc=class extends nd{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let r=0,s=t.count;r<s;r+=2)Lx.fromBufferAttribute(t,r),Dx.fromBufferAttribute(t,r+1),i[r]=r===0?0:i[r-1],i[r+1]=i[r]+Lx.distanceTo(Dx);e.setAttribute("lineDistance",new bi(i,1))}else je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Bc=class extends Si{constructor(e=[],t=la,i,r,s,o,a,l,c,h){super(e,t,i,r,s,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ps=class extends Si{constructor(e,t,i=Mr,r,s,o,a=qn,l=qn,c,h=As,d=1){if(h!==As&&h!==Is)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:d};super(f,r,s,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new vl(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},zc=class extends Ps{constructor(e,t=Mr,i=la,r,s,o=qn,a=qn,l,c=As){let h={width:e,height:e,depth:1},d=[h,h,h,h,h,h];super(e,e,t,i,r,s,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Gc=class extends Si{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},xl=class n extends es{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],h=[],d=[],f=0,p=0;m("z","y","x",-1,-1,i,t,e,o,s,0),m("z","y","x",1,-1,i,t,-e,o,s,1),m("x","z","y",1,1,e,i,t,r,o,2),m("x","z","y",1,-1,e,i,-t,r,o,3),m("x","y","z",1,-1,e,t,i,r,s,4),m("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new bi(c,3)),this.setAttribute("normal",new bi(h,3)),this.setAttribute("uv",new bi(d,2));function m(_,v,g,x,A,S,P,C,y,T,U){let D=S/y,L=P/T,B=S/2,G=P/2,F=C/2,H=y+1,Y=T+1,V=0,le=0,X=new Z;for(let Q=0;Q<Y;Q++){let se=Q*L-G;for(let fe=0;fe<H;fe++){let de=fe*D-B;X[_]=de*x,X[v]=se*A,X[g]=F,c.push(X.x,X.y,X.z),X[_]=0,X[v]=0,X[g]=C>0?1:-1,h.push(X.x,X.y,X.z),d.push(fe/y),d.push(1-Q/T),V+=1}}for(let Q=0;Q<T;Q++)for(let se=0;se<y;se++){let fe=f+se+H*Q,de=f+se+H*(Q+1),ee=f+(se+1)+H*(Q+1),ge=f+(se+1)+H*Q;l.push(fe,de,ge),l.push(de,ee,ge),le+=6}a.addGroup(p,le,U),p+=le,f+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Vc=class n extends es{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,h=l+1,d=e/a,f=t/l,p=[],m=[],_=[],v=[];for(let g=0;g<h;g++){let x=g*f-o;for(let A=0;A<c;A++){let S=A*d-s;m.push(S,-x,0),_.push(0,0,1),v.push(A/a),v.push(1-g/l)}}for(let g=0;g<l;g++)for(let x=0;x<a;x++){let A=x+c*g,S=x+c*(g+1),P=x+1+c*(g+1),C=x+1+c*g;p.push(A,S,C),p.push(S,P,C)}this.setIndex(p),this.setAttribute("position",new bi(m,3)),this.setAttribute("normal",new bi(_,3)),this.setAttribute("uv",new bi(v,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};function ua(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(Nx(r))r.isRenderTargetTexture?(je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(Nx(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function ni(n){let e={};for(let t=0;t<n.length;t++){let i=ua(n[t]);for(let r in i)e[r]=i[r]}return e}function Nx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function zC(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Bg(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Tt.workingColorSpace}var Tb={clone:ua,merge:ni},GC=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,VC=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Wi=class extends ho{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=GC,this.fragmentShader=VC,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ua(e.uniforms),this.uniformsGroups=zC(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new Et().setHex(r.value);break;case"v2":this.uniforms[i].value=new at().fromArray(r.value);break;case"v3":this.uniforms[i].value=new Z().fromArray(r.value);break;case"v4":this.uniforms[i].value=new un().fromArray(r.value);break;case"m3":this.uniforms[i].value=new it().fromArray(r.value);break;case"m4":this.uniforms[i].value=new cn().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},id=class extends Wi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var rd=class extends ho{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=cb,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},sd=class extends ho{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ul(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Dh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var fo=class{constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],s=t[i-1];e:{t:{let o;n:{i:if(!(e<r)){for(let a=i+2;;){if(r===void 0){if(e<s)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(s=r,r=t[++i],e<r)break t}o=t.length;break n}if(!(e>=s)){let a=t[1];e<a&&(i=2,s=a);for(let l=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(r=s,s=t[--i-1],e>=s)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(r=t[i],s=t[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=i[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},od=class extends fo{constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:ng,endingEnd:ng}}intervalChanged_(e,t,i){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case ig:s=e,a=2*t-i;break;case rg:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case ig:o=e,l=2*i-t;break;case rg:o=1,l=i+r[1]-r[0];break;default:o=e-1,l=t}let c=(i-t)*.5,h=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=s*h,this._offsetNext=o*h}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this._offsetPrev,d=this._offsetNext,f=this._weightPrev,p=this._weightNext,m=(i-t)/(r-t),_=m*m,v=_*m,g=-f*v+2*f*_-f*m,x=(1+f)*v+(-1.5-2*f)*_+(-.5+f)*m+1,A=(-1-p)*v+(1.5+p)*_+.5*m,S=p*v-p*_;for(let P=0;P!==a;++P)s[P]=g*o[h+P]+x*o[c+P]+A*o[l+P]+S*o[d+P];return s}},ad=class extends fo{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=(i-t)/(r-t),d=1-h;for(let f=0;f!==a;++f)s[f]=o[c+f]*d+o[l+f]*h;return s}},ld=class extends fo{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},cd=class extends fo{interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,h=this.inTangents,d=this.outTangents;if(!h||!d){let m=(i-t)/(r-t),_=1-m;for(let v=0;v!==a;++v)s[v]=o[c+v]*_+o[l+v]*m;return s}let f=a*2,p=e-1;for(let m=0;m!==a;++m){let _=o[c+m],v=o[l+m],g=p*f+m*2,x=d[g],A=d[g+1],S=e*f+m*2,P=h[S],C=h[S+1],y=WC(i,t,x,P,r);s[m]=Eb(y,_,A,C,v)}return s}};function Eb(n,e,t,i,r){let s=1-n;return s*s*s*e+3*s*s*n*t+3*s*n*n*i+n*n*n*r}function HC(n,e,t,i,r){let s=1-n;return 3*s*s*(t-e)+6*s*n*(i-t)+3*n*n*(r-i)}function WC(n,e,t,i,r){let s=(n-e)/(r-e);for(let o=0;o<8;o++){let a=Eb(s,e,t,i,r)-n;if(Math.abs(a)<1e-10)break;let l=HC(s,e,t,i,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var qi=class{constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ul(t,this.TimeBufferType),this.values=ul(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:ul(e.times,Array),values:ul(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),Dh(e.settings)&&(i.settings={inTangents:ul(e.settings.inTangents,Array),outTangents:ul(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new ld(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ad(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new od(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new cd(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Cc:t=this.InterpolantFactoryMethodDiscrete;break;case $h:t=this.InterpolantFactoryMethodLinear;break;case Uh:t=this.InterpolantFactoryMethodSmooth;break;case tg:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Cc;case this.InterpolantFactoryMethodLinear:return $h;case this.InterpolantFactoryMethodSmooth:return Uh;case this.InterpolantFactoryMethodBezier:return tg}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;Dh(this.settings)&&(Fx(this.settings.inTangents,e),Fx(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;Dh(this.settings)&&(Ux(this.settings.inTangents,e),Ux(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<e;)++s;for(;o!==-1&&i[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(st("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,s=i.length;s===0&&(st("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){st("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){st("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&oC(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){st("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===Uh,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],h=e[a+1];if(c!==h&&(a!==1||c!==e[0]))if(r)l=!0;else{let d=a*i,f=d-i,p=d+i;for(let m=0;m!==i;++m){let _=t[d+m];if(_!==t[f+m]||_!==t[p+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,f=o*i;for(let p=0;p!==i;++p)t[f+p]=t[d+p]}++o}}if(s>0){e[o]=e[s];for(let a=s*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,Dh(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Fx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Ux(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}qi.prototype.ValueTypeName="";qi.prototype.TimeBufferType=Float32Array;qi.prototype.ValueBufferType=Float32Array;qi.prototype.DefaultInterpolation=$h;var po=class extends qi{constructor(e,t,i){super(e,t,i)}};po.prototype.ValueTypeName="bool";po.prototype.ValueBufferType=Array;po.prototype.DefaultInterpolation=Cc;po.prototype.InterpolantFactoryMethodLinear=void 0;po.prototype.InterpolantFactoryMethodSmooth=void 0;var ud=class extends qi{constructor(e,t,i,r){super(e,t,i,r)}};ud.prototype.ValueTypeName="color";var hd=class extends qi{constructor(e,t,i,r){super(e,t,i,r)}};hd.prototype.ValueTypeName="number";var dd=class extends fo{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(r-t),c=e*a;for(let h=c+a;c!==h;c+=4)Gi.slerpFlat(s,0,o,c-a,o,c,l);return s}},Hc=class extends qi{constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new dd(this.times,this.values,this.getValueSize(),e)}};Hc.prototype.ValueTypeName="quaternion";Hc.prototype.InterpolantFactoryMethodSmooth=void 0;var mo=class extends qi{constructor(e,t,i){super(e,t,i)}};mo.prototype.ValueTypeName="string";mo.prototype.ValueBufferType=Array;mo.prototype.DefaultInterpolation=Cc;mo.prototype.InterpolantFactoryMethodLinear=void 0;mo.prototype.InterpolantFactoryMethodSmooth=void 0;var fd=class extends qi{constructor(e,t,i,r){super(e,t,i,r)}};fd.prototype.ValueTypeName="vector";var pd=class{constructor(e,t,i){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,s===!1&&r.onStart!==void 0&&r.onStart(h,o,a),s=!0},this.itemEnd=function(h){o++,r.onProgress!==void 0&&r.onProgress(h,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(h){r.onError!==void 0&&r.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,d){return c.push(h,d),this},this.removeHandler=function(h){let d=c.indexOf(h);return d!==-1&&c.splice(d,2),this},this.getHandler=function(h){for(let d=0,f=c.length;d<f;d+=2){let p=c[d],m=c[d+1];if(p.global&&(p.lastIndex=0),p.test(h))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ab=new pd,md=class{constructor(e){this.manager=e!==void 0?e:Ab,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,s){i.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};md.DEFAULT_MATERIAL_NAME="__DEFAULT";var Nh=new Z,Fh=new Gi,Jr=new Z,Wc=class extends Hi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new cn,this.projectionMatrix=new cn,this.projectionMatrixInverse=new cn,this.coordinateSystem=rr,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Nh,Fh,Jr),Jr.x===1&&Jr.y===1&&Jr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nh,Fh,Jr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Nh,Fh,Jr),Jr.x===1&&Jr.y===1&&Jr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Nh,Fh,Jr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},lo=new Z,Ox=new at,kx=new at,di=class extends Wc{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=gl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ec*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return gl*2*Math.atan(Math.tan(Ec*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){lo.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(lo.x,lo.y).multiplyScalar(-e/lo.z),lo.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(lo.x,lo.y).multiplyScalar(-e/lo.z)}getViewSize(e,t){return this.getViewBounds(e,Ox,kx),t.subVectors(kx,Ox)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ec*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var gd=class extends Wc{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var bl=class extends es{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var hl=-90,dl=1,Sl=class extends Hi{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new di(hl,dl,e,t);r.layers=this.layers,this.add(r);let s=new di(hl,dl,e,t);s.layers=this.layers,this.add(s);let o=new di(hl,dl,e,t);o.layers=this.layers,this.add(o);let a=new di(hl,dl,e,t);a.layers=this.layers,this.add(a);let l=new di(hl,dl,e,t);l.layers=this.layers,this.add(l);let c=new di(hl,dl,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===rr)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ic)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,h]=this.children,d=e.getRenderTarget(),f=e.getActiveCubeFace(),p=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let v=!1;e.isWebGLRenderer===!0?v=e.state.buffers.depth.getReversed():v=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),v&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),v&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),v&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),v&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),v&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=_,e.setRenderTarget(i,5,r),v&&e.autoClear===!1&&e.clearDepth(),e.render(t,h),e.setRenderTarget(d,f,p),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},vd=class extends di{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var zg="\\[\\]\\.:\\/",qC=new RegExp("["+zg+"]","g"),Gg="[^"+zg+"]",XC="[^"+zg.replace("\\.","")+"]",$C=/((?:WC+[\/:])*)/.source.replace("WC",Gg),YC=/(WCOD+)?/.source.replace("WCOD",XC),KC=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Gg),ZC=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Gg),JC=new RegExp("^"+$C+YC+KC+ZC+"$"),jC=["material","materials","bones","map"],sg=class{constructor(e,t,i){let r=i||nn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},nn=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(qC,"")}static parseTrackName(e){let t=JC.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);jC.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},r=i(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)e[t++]=i[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){st("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){st("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let h=0;h<e.length;h++)if(e[h].name===c){c=h;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){st("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){st("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){st("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;st("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};nn.Composite=sg;nn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};nn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};nn.prototype.GetterByBindingType=[nn.prototype._getValue_direct,nn.prototype._getValue_array,nn.prototype._getValue_arrayElement,nn.prototype._getValue_toArray];nn.prototype.SetterByBindingTypeAndVersioning=[[nn.prototype._setValue_direct,nn.prototype._setValue_direct_setNeedsUpdate,nn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_array,nn.prototype._setValue_array_setNeedsUpdate,nn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_arrayElement,nn.prototype._setValue_arrayElement_setNeedsUpdate,nn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[nn.prototype._setValue_fromArray,nn.prototype._setValue_fromArray_setNeedsUpdate,nn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var ek=new Float32Array(1);var wl=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=bt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(bt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var og=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=r,this}};var qc=class extends wr{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Vg(n,e,t,i){let r=QC(i);switch(t){case Eg:return n*e;case Cg:return n*e/r.components*r.byteLength;case Md:return n*e/r.components*r.byteLength;case yo:return n*e*2/r.components*r.byteLength;case Td:return n*e*2/r.components*r.byteLength;case Ag:return n*e*3/r.components*r.byteLength;case Ar:return n*e*4/r.components*r.byteLength;case Ed:return n*e*4/r.components*r.byteLength;case Yc:case Kc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Zc:case Jc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Cd:case Rd:return Math.max(n,16)*Math.max(e,8)/4;case Ad:case Pd:return Math.max(n,8)*Math.max(e,8)/2;case Id:case Ld:case Nd:case Fd:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Dd:case jc:case Ud:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Od:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case kd:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Bd:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case zd:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Gd:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Vd:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Hd:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case Wd:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case qd:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case Xd:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case $d:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Yd:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Kd:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Zd:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Jd:case jd:case Qd:return Math.ceil(n/4)*Math.ceil(e/4)*16;case ef:case tf:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Qc:case nf:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function QC(n){switch(n){case Xi:case Sg:return{byteLength:1,components:1};case Al:case wg:case Er:return{byteLength:2,components:1};case Sd:case wd:return{byteLength:2,components:4};case Mr:case bd:case Tr:return{byteLength:4,components:1};case Mg:case Tg:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Kb(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function tP(n){let e=new WeakMap;function t(a,l){let c=a.array,h=a.usage,d=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let h=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,h);else{d.sort((p,m)=>p.start-m.start);let f=0;for(let p=1;p<d.length;p++){let m=d[f],_=d[p];_.start<=m.start+m.count+1?m.count=Math.max(m.count,_.start+_.count-m.start):(++f,d[f]=_)}d.length=f+1;for(let p=0,m=d.length;p<m;p++){let _=d[p];n.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=e.get(a);(!h||h.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var nP=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,iP=`#ifdef USE_ALPHAHASH
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
#endif`,rP=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,sP=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,oP=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,aP=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,lP=`#ifdef USE_AOMAP
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
#endif`,cP=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,uP=`#ifdef USE_BATCHING
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
#endif`,hP=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,dP=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,fP=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,pP=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,mP=`#ifdef USE_IRIDESCENCE
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
#endif`,gP=`#ifdef USE_BUMPMAP
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
#endif`,vP=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,_P=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,yP=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,xP=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,bP=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,SP=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,wP=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,MP=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,TP=`#define PI 3.141592653589793
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
} // validated`,EP=`vec3 transformedNormal = objectNormal;
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
#endif`,AP=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,CP=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,PP=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,RP=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,IP="gl_FragColor = linearToOutputTexel( gl_FragColor );",LP=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,DP=`#ifdef USE_ENVMAP
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
#endif`,NP=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,FP=`#ifdef USE_ENVMAP
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
#endif`,UP=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,OP=`#ifdef USE_ENVMAP
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
#endif`,kP=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,BP=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,zP=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,GP=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,VP=`#ifdef USE_GRADIENTMAP
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
}`,HP=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,WP=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,qP=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,XP=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,$P=`#ifdef USE_ENVMAP
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
#endif`,YP=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,KP=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ZP=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,JP=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,jP=`PhysicalMaterial material;
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
#endif`,QP=`uniform sampler2D dfgLUT;
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
}`,eR=`
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
#endif`,tR=`#if defined( RE_IndirectDiffuse )
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
#endif`,nR=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,iR=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,rR=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,sR=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,oR=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,aR=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,lR=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,cR=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,uR=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,hR=`#if defined( USE_POINTS_UV )
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
#endif`,dR=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,fR=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,pR=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,mR=`#if defined( USE_MORPHCOLORS )
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
#endif`,gR=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,vR=`#ifdef USE_MORPHTARGETS
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
#endif`,_R=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,yR=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,xR=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,bR=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,SR=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,wR=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,MR=`#ifdef USE_NORMALMAP
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
#endif`,TR=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,ER=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,AR=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,CR=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,PR=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,RR=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,IR=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,LR=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,DR=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,NR=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,FR=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,UR=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,OR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,kR=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,BR=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,zR=`float getShadowMask() {
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
}`,GR=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,VR=`#ifdef USE_SKINNING
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
#endif`,HR=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,WR=`#ifdef USE_SKINNING
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
#endif`,qR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,XR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,$R=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,YR=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,KR=`#ifdef USE_TRANSMISSION
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
#endif`,ZR=`#ifdef USE_TRANSMISSION
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
#endif`,JR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,jR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,QR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,eI=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,tI=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,nI=`uniform sampler2D t2D;
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
}`,iI=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,rI=`uniform float backgroundBlurriness;
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
}`,sI=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,oI=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,aI=`#include <common>
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
}`,lI=`#if DEPTH_PACKING == 3200
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
}`,cI=`#define DISTANCE
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
}`,uI=`#define DISTANCE
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
}`,hI=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,dI=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fI=`uniform float scale;
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
}`,pI=`uniform vec3 diffuse;
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
}`,mI=`#include <common>
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
}`,gI=`uniform vec3 diffuse;
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
}`,vI=`#define LAMBERT
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
}`,_I=`#define LAMBERT
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
}`,yI=`#define MATCAP
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
}`,xI=`#define MATCAP
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
}`,bI=`#define NORMAL
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
}`,SI=`#define NORMAL
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
}`,wI=`#define PHONG
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
}`,MI=`#define PHONG
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
}`,TI=`#define STANDARD
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
}`,EI=`#define STANDARD
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
}`,AI=`#define TOON
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
}`,CI=`#define TOON
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
}`,PI=`uniform float size;
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
}`,RI=`uniform vec3 diffuse;
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
}`,II=`#include <common>
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
}`,LI=`uniform vec3 color;
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
}`,DI=`uniform float rotation;
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
}`,NI=`uniform vec3 diffuse;
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
}`,gt={alphahash_fragment:nP,alphahash_pars_fragment:iP,alphamap_fragment:rP,alphamap_pars_fragment:sP,alphatest_fragment:oP,alphatest_pars_fragment:aP,aomap_fragment:lP,aomap_pars_fragment:cP,batching_pars_vertex:uP,batching_vertex:hP,begin_vertex:dP,beginnormal_vertex:fP,bsdfs:pP,iridescence_fragment:mP,bumpmap_pars_fragment:gP,clipping_planes_fragment:vP,clipping_planes_pars_fragment:_P,clipping_planes_pars_vertex:yP,clipping_planes_vertex:xP,color_fragment:bP,color_pars_fragment:SP,color_pars_vertex:wP,color_vertex:MP,common:TP,defaultnormal_vertex:EP,displacementmap_pars_vertex:AP,displacementmap_vertex:CP,emissivemap_fragment:PP,emissivemap_pars_fragment:RP,colorspace_fragment:IP,colorspace_pars_fragment:LP,envmap_fragment:DP,envmap_common_pars_fragment:NP,envmap_pars_fragment:FP,envmap_pars_vertex:UP,envmap_physical_pars_fragment:$P,envmap_vertex:OP,fog_vertex:kP,fog_pars_vertex:BP,fog_fragment:zP,fog_pars_fragment:GP,gradientmap_pars_fragment:VP,lightmap_pars_fragment:HP,lights_lambert_fragment:WP,lights_lambert_pars_fragment:qP,lights_pars_begin:XP,lights_toon_fragment:YP,lights_toon_pars_fragment:KP,lights_phong_fragment:ZP,lights_phong_pars_fragment:JP,lights_physical_fragment:jP,lights_physical_pars_fragment:QP,lights_fragment_begin:eR,lights_fragment_maps:tR,lights_fragment_end:nR,lightprobes_pars_fragment:iR,logdepthbuf_fragment:rR,logdepthbuf_pars_fragment:sR,logdepthbuf_pars_vertex:oR,logdepthbuf_vertex:aR,map_fragment:lR,map_pars_fragment:cR,map_particle_fragment:uR,map_particle_pars_fragment:hR,metalnessmap_fragment:dR,metalnessmap_pars_fragment:fR,morphinstance_vertex:pR,morphcolor_vertex:mR,morphnormal_vertex:gR,morphtarget_pars_vertex:vR,morphtarget_vertex:_R,normal_fragment_begin:yR,normal_fragment_maps:xR,normal_pars_fragment:bR,normal_pars_vertex:SR,normal_vertex:wR,normalmap_pars_fragment:MR,clearcoat_normal_fragment_begin:TR,clearcoat_normal_fragment_maps:ER,clearcoat_pars_fragment:AR,iridescence_pars_fragment:CR,opaque_fragment:PR,packing:RR,premultiplied_alpha_fragment:IR,project_vertex:LR,dithering_fragment:DR,dithering_pars_fragment:NR,roughnessmap_fragment:FR,roughnessmap_pars_fragment:UR,shadowmap_pars_fragment:OR,shadowmap_pars_vertex:kR,shadowmap_vertex:BR,shadowmask_pars_fragment:zR,skinbase_vertex:GR,skinning_pars_vertex:VR,skinning_vertex:HR,skinnormal_vertex:WR,specularmap_fragment:qR,specularmap_pars_fragment:XR,tonemapping_fragment:$R,tonemapping_pars_fragment:YR,transmission_fragment:KR,transmission_pars_fragment:ZR,uv_pars_fragment:JR,uv_pars_vertex:jR,uv_vertex:QR,worldpos_vertex:eI,background_vert:tI,background_frag:nI,backgroundCube_vert:iI,backgroundCube_frag:rI,cube_vert:sI,cube_frag:oI,depth_vert:aI,depth_frag:lI,distance_vert:cI,distance_frag:uI,equirect_vert:hI,equirect_frag:dI,linedashed_vert:fI,linedashed_frag:pI,meshbasic_vert:mI,meshbasic_frag:gI,meshlambert_vert:vI,meshlambert_frag:_I,meshmatcap_vert:yI,meshmatcap_frag:xI,meshnormal_vert:bI,meshnormal_frag:SI,meshphong_vert:wI,meshphong_frag:MI,meshphysical_vert:TI,meshphysical_frag:EI,meshtoon_vert:AI,meshtoon_frag:CI,points_vert:PI,points_frag:RI,shadow_vert:II,shadow_frag:LI,sprite_vert:DI,sprite_frag:NI},De={common:{diffuse:{value:new Et(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new it}},envmap:{envMap:{value:null},envMapRotation:{value:new it},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new it}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new it}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new it},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new it},normalScale:{value:new at(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new it},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new it}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new it}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new it}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Et(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Et(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0},uvTransform:{value:new it}},sprite:{diffuse:{value:new Et(16777215)},opacity:{value:1},center:{value:new at(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new it},alphaMap:{value:null},alphaMapTransform:{value:new it},alphaTest:{value:0}}},is={basic:{uniforms:ni([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.fog]),vertexShader:gt.meshbasic_vert,fragmentShader:gt.meshbasic_frag},lambert:{uniforms:ni([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Et(0)},envMapIntensity:{value:1}}]),vertexShader:gt.meshlambert_vert,fragmentShader:gt.meshlambert_frag},phong:{uniforms:ni([De.common,De.specularmap,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.fog,De.lights,{emissive:{value:new Et(0)},specular:{value:new Et(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:gt.meshphong_vert,fragmentShader:gt.meshphong_frag},standard:{uniforms:ni([De.common,De.envmap,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.roughnessmap,De.metalnessmap,De.fog,De.lights,{emissive:{value:new Et(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag},toon:{uniforms:ni([De.common,De.aomap,De.lightmap,De.emissivemap,De.bumpmap,De.normalmap,De.displacementmap,De.gradientmap,De.fog,De.lights,{emissive:{value:new Et(0)}}]),vertexShader:gt.meshtoon_vert,fragmentShader:gt.meshtoon_frag},matcap:{uniforms:ni([De.common,De.bumpmap,De.normalmap,De.displacementmap,De.fog,{matcap:{value:null}}]),vertexShader:gt.meshmatcap_vert,fragmentShader:gt.meshmatcap_frag},points:{uniforms:ni([De.points,De.fog]),vertexShader:gt.points_vert,fragmentShader:gt.points_frag},dashed:{uniforms:ni([De.common,De.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:gt.linedashed_vert,fragmentShader:gt.linedashed_frag},depth:{uniforms:ni([De.common,De.displacementmap]),vertexShader:gt.depth_vert,fragmentShader:gt.depth_frag},normal:{uniforms:ni([De.common,De.bumpmap,De.normalmap,De.displacementmap,{opacity:{value:1}}]),vertexShader:gt.meshnormal_vert,fragmentShader:gt.meshnormal_frag},sprite:{uniforms:ni([De.sprite,De.fog]),vertexShader:gt.sprite_vert,fragmentShader:gt.sprite_frag},background:{uniforms:{uvTransform:{value:new it},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:gt.background_vert,fragmentShader:gt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new it}},vertexShader:gt.backgroundCube_vert,fragmentShader:gt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:gt.cube_vert,fragmentShader:gt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:gt.equirect_vert,fragmentShader:gt.equirect_frag},distance:{uniforms:ni([De.common,De.displacementmap,{referencePosition:{value:new Z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:gt.distance_vert,fragmentShader:gt.distance_frag},shadow:{uniforms:ni([De.lights,De.fog,{color:{value:new Et(0)},opacity:{value:1}}]),vertexShader:gt.shadow_vert,fragmentShader:gt.shadow_frag}};is.physical={uniforms:ni([is.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new it},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new it},clearcoatNormalScale:{value:new at(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new it},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new it},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new it},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new it},sheen:{value:0},sheenColor:{value:new Et(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new it},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new it},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new it},transmissionSamplerSize:{value:new at},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new it},attenuationDistance:{value:0},attenuationColor:{value:new Et(0)},specularColor:{value:new Et(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new it},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new it},anisotropyVector:{value:new at},anisotropyMap:{value:null},anisotropyMapTransform:{value:new it}}]),vertexShader:gt.meshphysical_vert,fragmentShader:gt.meshphysical_frag};var rf={r:0,b:0,g:0},FI=new cn,Zb=new it;Zb.set(-1,0,0,0,1,0,0,0,1);function UI(n,e,t,i,r,s){let o=new Et(0),a=r===!0?0:1,l,c,h=null,d=0,f=null;function p(x){let A=x.isScene===!0?x.background:null;if(A&&A.isTexture){let S=x.backgroundBlurriness>0;A=e.get(A,S)}return A}function m(x){let A=!1,S=p(x);S===null?v(o,a):S&&S.isColor&&(v(S,1),A=!0);let P=n.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,s):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(x,A){let S=p(A);S&&S.isCubeTexture?(c===void 0&&(c=new sr(new xl(1,1,1),new Wi({name:"BackgroundCubeMaterial",uniforms:ua(is.backgroundCube.uniforms),vertexShader:is.backgroundCube.vertexShader,fragmentShader:is.backgroundCube.fragmentShader,side:pi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,C,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(FI.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Zb),c.material.toneMapped=Tt.getTransfer(S.colorSpace)!==Ot,(h!==S||d!==S.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,h=S,d=S.version,f=n.toneMapping),c.layers.enableAll(),x.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new sr(new Vc(2,2),new Wi({name:"BackgroundMaterial",uniforms:ua(is.background.uniforms),vertexShader:is.background.vertexShader,fragmentShader:is.background.fragmentShader,side:_o,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=Tt.getTransfer(S.colorSpace)!==Ot,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(h!==S||d!==S.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,h=S,d=S.version,f=n.toneMapping),l.layers.enableAll(),x.unshift(l,l.geometry,l.material,0,0,null))}function v(x,A){x.getRGB(rf,Bg(n)),t.buffers.color.setClear(rf.r,rf.g,rf.b,A,s)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(x,A=1){o.set(x),a=A,v(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(x){a=x,v(o,a)},render:m,addToRenderList:_,dispose:g}}function OI(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=f(null),s=r,o=!1;function a(L,B,G,F,H){let Y=!1,V=d(L,F,G,B);s!==V&&(s=V,c(s.object)),Y=p(L,F,G,H),Y&&m(L,F,G,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(L,B,G,F),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function h(L){return n.deleteVertexArray(L)}function d(L,B,G,F){let H=F.wireframe===!0,Y=i[B.id];Y===void 0&&(Y={},i[B.id]=Y);let V=L.isInstancedMesh===!0?L.id:0,le=Y[V];le===void 0&&(le={},Y[V]=le);let X=le[G.id];X===void 0&&(X={},le[G.id]=X);let Q=X[H];return Q===void 0&&(Q=f(l()),X[H]=Q),Q}function f(L){let B=[],G=[],F=[];for(let H=0;H<t;H++)B[H]=0,G[H]=0,F[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:G,attributeDivisors:F,object:L,attributes:{},index:null}}function p(L,B,G,F){let H=s.attributes,Y=B.attributes,V=0,le=G.getAttributes();for(let X in le)if(le[X].location>=0){let se=H[X],fe=Y[X];if(fe===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(fe=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(fe=L.instanceColor)),se===void 0||se.attribute!==fe||fe&&se.data!==fe.data)return!0;V++}return s.attributesNum!==V||s.index!==F}function m(L,B,G,F){let H={},Y=B.attributes,V=0,le=G.getAttributes();for(let X in le)if(le[X].location>=0){let se=Y[X];se===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(se=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(se=L.instanceColor));let fe={};fe.attribute=se,se&&se.data&&(fe.data=se.data),H[X]=fe,V++}s.attributes=H,s.attributesNum=V,s.index=F}function _(){let L=s.newAttributes;for(let B=0,G=L.length;B<G;B++)L[B]=0}function v(L){g(L,0)}function g(L,B){let G=s.newAttributes,F=s.enabledAttributes,H=s.attributeDivisors;G[L]=1,F[L]===0&&(n.enableVertexAttribArray(L),F[L]=1),H[L]!==B&&(n.vertexAttribDivisor(L,B),H[L]=B)}function x(){let L=s.newAttributes,B=s.enabledAttributes;for(let G=0,F=B.length;G<F;G++)B[G]!==L[G]&&(n.disableVertexAttribArray(G),B[G]=0)}function A(L,B,G,F,H,Y,V){V===!0?n.vertexAttribIPointer(L,B,G,H,Y):n.vertexAttribPointer(L,B,G,F,H,Y)}function S(L,B,G,F){_();let H=F.attributes,Y=G.getAttributes(),V=B.defaultAttributeValues;for(let le in Y){let X=Y[le];if(X.location>=0){let Q=H[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let se=Q.normalized,fe=Q.itemSize,de=e.get(Q);if(de===void 0)continue;let ee=de.buffer,ge=de.type,ye=de.bytesPerElement,Ce=ge===n.INT||ge===n.UNSIGNED_INT||Q.gpuType===bd;if(Q.isInterleavedBufferAttribute){let we=Q.data,$e=we.isInterleavedBuffer===!0?we.stride:we.itemSize,ut=Q.offset;if(we.isInstancedInterleavedBuffer||we.isInstancedBufferAttribute){for(let We=0;We<X.locationSize;We++)g(X.location+We,we.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=we.meshPerAttribute*we.count)}else for(let We=0;We<X.locationSize;We++)v(X.location+We);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let We=0;We<X.locationSize;We++)A(X.location+We,fe/X.locationSize,ge,se,$e*ye,(ut+fe/X.locationSize*We)*ye,Ce)}else{if(Q.isInstancedBufferAttribute){for(let we=0;we<X.locationSize;we++)g(X.location+we,Q.meshPerAttribute);L.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let we=0;we<X.locationSize;we++)v(X.location+we);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let we=0;we<X.locationSize;we++)A(X.location+we,fe/X.locationSize,ge,se,fe*ye,fe/X.locationSize*we*ye,Ce)}}else if(V!==void 0){let se=V[le];if(se!==void 0)switch(se.length){case 2:n.vertexAttrib2fv(X.location,se);break;case 3:n.vertexAttrib3fv(X.location,se);break;case 4:n.vertexAttrib4fv(X.location,se);break;default:n.vertexAttrib1fv(X.location,se)}}}}x()}function P(){U();for(let L in i){let B=i[L];for(let G in B){let F=B[G];for(let H in F){let Y=F[H];for(let V in Y)h(Y[V].object),delete Y[V];delete F[H]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let B=i[L.id];for(let G in B){let F=B[G];for(let H in F){let Y=F[H];for(let V in Y)h(Y[V].object),delete Y[V];delete F[H]}}delete i[L.id]}function y(L){for(let B in i){let G=i[B];for(let F in G){let H=G[F];if(H[L.id]===void 0)continue;let Y=H[L.id];for(let V in Y)h(Y[V].object),delete Y[V];delete H[L.id]}}}function T(L){for(let B in i){let G=i[B],F=L.isInstancedMesh===!0?L.id:0,H=G[F];if(H!==void 0){for(let Y in H){let V=H[Y];for(let le in V)h(V[le].object),delete V[le];delete H[Y]}delete G[F],Object.keys(G).length===0&&delete i[B]}}}function U(){D(),o=!0,s!==r&&(s=r,c(s.object))}function D(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:U,resetDefaultState:D,dispose:P,releaseStatesOfGeometry:C,releaseStatesOfObject:T,releaseStatesOfProgram:y,initAttributes:_,enableAttribute:v,disableUnusedAttributes:x}}function kI(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),t.update(c,i,h))}function a(l,c,h){if(h===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let f=0;for(let p=0;p<h;p++)f+=c[p];t.update(f,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function BI(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(y){return!(y!==Ar&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let T=y===Er&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==Xi&&y!==Tr&&!T&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",h=l(c);h!==c&&(je("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),v=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),x=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),A=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),P=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:d,maxTextures:p,maxVertexTextures:m,maxTextureSize:_,maxCubemapSize:v,maxAttributes:g,maxVertexUniforms:x,maxVaryings:A,maxFragmentUniforms:S,maxSamples:P,samples:C}}function zI(n){let e=this,t=null,i=0,r=!1,s=!1,o=new zi,a=new it,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,f){let p=d.length!==0||f||i!==0||r;return r=f,i=d.length,p},this.beginShadows=function(){s=!0,h(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(d,f){t=h(d,f,0)},this.setState=function(d,f,p){let m=d.clippingPlanes,_=d.clipIntersection,v=d.clipShadows,g=n.get(d);if(!r||m===null||m.length===0||s&&!v)s?h(null):c();else{let x=s?0:i,A=x*4,S=g.clippingState||null;l.value=S,S=h(m,f,A,p);for(let P=0;P!==A;++P)S[P]=t[P];g.clippingState=S,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=x}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function h(d,f,p,m){let _=d!==null?d.length:0,v=null;if(_!==0){if(v=l.value,m!==!0||v===null){let g=p+_*4,x=f.matrixWorldInverse;a.getNormalMatrix(x),(v===null||v.length<g)&&(v=new Float32Array(g));for(let A=0,S=p;A!==_;++A,S+=4)o.copy(d[A]).applyMatrix4(x,a),o.normal.toArray(v,S),v[S+3]=o.constant}l.value=v,l.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,v}}var nu=class extends Vi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new Bc(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new xl(5,5,5),s=new Wi({name:"CubemapFromEquirect",uniforms:ua(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:pi,blending:oa});s.uniforms.tEquirect.value=t;let o=new sr(r,s),a=t.minFilter;return t.minFilter===Rs&&(t.minFilter=Zn),new Sl(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}},Cb=256,GI=3,VI=20,Jb=256,jb=16,HI=3,WI=new Z,qI=new Et,of=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Sl(1,10,null),this._boxMesh=new sr(new xl(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=WI}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);t>0&&(h.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,m=l.autoClearStencil,_=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(e.background=l.getClearColor(qI));let v=new Sl(i,r,h);return v.position.copy(a),v.update(l,e),l.autoClear=d,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=m,e.background=_,t>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ib(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Rb(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Cb,Ug(e))}_fromTexture(e,t){e.mapping===la||e.mapping===El?this._setSize(e.image.length===0?Cb:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Pb(e,!1,!1),i=Math.log2(e)-GI;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Pb(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===la||e.mapping===El?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ib()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Rb()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=XI(),this._integrationMaterial=$I());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/jb);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-HI)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Jb*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=YI());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function Pb(n,e,t){return new nu(n,{minFilter:Rs,generateMipmaps:e,type:Er,colorSpace:Pc,depthBuffer:t})}function iu(n,e,t){return new Wi({name:n,uniforms:e,vertexShader:gt.cube_vert,fragmentShader:t,side:pi,blending:oa,depthTest:!1,depthWrite:!1})}function XI(){return iu("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Jb}u

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
	`)}function $I(){return iu("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:jb}},`

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
	`)}function YI(){return iu("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${VI}
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
	`)}function Rb(){return iu("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Ib(){return iu("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function KI(n){let e=new WeakMap,t=new WeakMap,i=null;function r(f,p=!1){return f==null?null:p?o(f):s(f)}function s(f){if(f&&f.isTexture){let p=f.mapping;if(p===_d||p===yd)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let _=new nu(m.height);return _.fromEquirectangularTexture(n,f),e.set(f,_),f.addEventListener("dispose",c),a(_.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,m=p===_d||p===yd,_=p===la||p===El;if(m||_){let v=t.get(f),g=v!==void 0?v.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==g)return i===null&&(i=new of(n)),v=m?i.fromEquirectangular(f,v):i.fromCubemap(f,v),v.texture.pmremVersion=f.pmremVersion,t.set(f,v),v.texture;if(v!==void 0)return v.texture;{let x=f.image;return m&&x&&x.height>0||_&&x&&l(x)?(i===null&&(i=new of(n)),v=m?i.fromEquirectangular(f):i.fromCubemap(f),v.texture.pmremVersion=f.pmremVersion,t.set(f,v),f.addEventListener("dispose",h),v.texture):null}}}return f}function a(f,p){return p===_d?f.mapping=la:p===yd&&(f.mapping=El),f}function l(f){let p=0,m=6;for(let _=0;_<m;_++)f[_]!==void 0&&p++;return p===m}function c(f){let p=f.target;p.removeEventListener("dispose",c);let m=e.get(p);m!==void 0&&(e.delete(p),m.dispose())}function h(f){let p=f.target;p.removeEventListener("dispose",h);let m=t.get(p);m!==void 0&&(t.delete(p),m.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:d}}function ZI(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&Tc("WebGLRenderer: "+i+" extension not supported."),r}}}function JI(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let v in m.attributes)e.remove(m.attributes[v]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let _=s.get(m);_&&(e.remove(_),s.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,_){return r[_.id]!==void 0||(_.addEventListener("dispose",a),r[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function h(m){let _=m.attributes;for(let v in _)e.update(_[v],n.ARRAY_BUFFER)}function d(m){let _=m.index,v=m.attributes.position,g=0;if(v===void 0)return;let x=_!==null?_.array.length:v.array.length/3-1,A=v.count>=65535?Oc:Uc,S=new A(Math.ceil(x/3)*6,1),P=S.array;if(_!==null){let y=_.array;g=_.version;for(let T=0,U=0;T<x;T+=3){let D=y[T+0],L=y[T+1],B=y[T+2];P[U++]=D,P[U++]=L,P[U++]=L,P[U++]=B,P[U++]=B,P[U++]=D}}else{g=v.version;for(let y=0,T=0;y<x;y+=3){let U=y+0,D=y+1,L=y+2;P[T++]=U,P[T++]=D,P[T++]=D,P[T++]=L,P[T++]=L,P[T++]=U}}S.version=g;let C=s.get(m);C&&e.remove(C),s.set(m,S)}function f(m){let _=s.get(m);if(_){let v=m.index;v!==null&&_.version<v.version&&d(m)}else d(m);return s.get(m)}function p(){for(let m in r){let _=r[m].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:f,dispose:p}}function jI(n,e,t){let i;function r(d){i=d}let s,o;function a(d){s=d.type,o=d.bytesPerElement}function l(d,f){n.drawElements(i,f,s,d*o),t.update(f,i,1)}function c(d,f,p){p!==0&&(n.drawElementsInstanced(i,f,s,d*o,p),t.update(f,i,p))}function h(d,f,p){if(p===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,s,d,0,p);let _=0;for(let v=0;v<p;v++)_+=f[v];t.update(_,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function QI(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:st("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function eL(n,e,t){let i=new WeakMap,r=new un;function s(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0,f=i.get(a);if(f===void 0||f.count!==d){let U=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",U)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,v=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],x=a.morphAttributes.color||[],A=0;p===!0&&(A=1),m===!0&&(A=2),_===!0&&(A=3);let S=a.attributes.position.count*A,P=1;S>e.maxTextureSize&&(P=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let C=new Float32Array(S*P*4*d),y=new Dc(C,S,P,d);y.type=Tr,y.needsUpdate=!0;let T=A*4;for(let D=0;D<d;D++){let L=v[D],B=g[D],G=x[D],F=S*P*4*D;for(let H=0;H<L.count;H++){let Y=H*T;p===!0&&(r.fromBufferAttribute(L,H),C[F+Y+0]=r.x,C[F+Y+1]=r.y,C[F+Y+2]=r.z,C[F+Y+3]=0),m===!0&&(r.fromBufferAttribute(B,H),C[F+Y+4]=r.x,C[F+Y+5]=r.y,C[F+Y+6]=r.z,C[F+Y+7]=0),_===!0&&(r.fromBufferAttribute(G,H),C[F+Y+8]=r.x,C[F+Y+9]=r.y,C[F+Y+10]=r.z,C[F+Y+11]=G.itemSize===4?r.w:1)}}f={count:d,texture:y,size:new at(S,P)},i.set(a,f),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let p=0;for(let _=0;_<c.length;_++)p+=c[_];let m=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:s}}function tL(n,e,t,i,r){let s=new WeakMap;function o(c){let h=r.render.frame,d=c.geometry,f=e.get(c,d);if(s.get(f)!==h&&(e.update(f),s.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==h&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;s.get(p)!==h&&(p.update(),s.set(p,h))}return f}function a(){s=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),t.remove(h.instanceMatrix),h.instanceColor!==null&&t.remove(h.instanceColor)}return{update:o,dispose:a}}var nL={[pg]:"LINEAR_TONE_MAPPING",[mg]:"REINHARD_TONE_MAPPING",[gg]:"CINEON_TONE_MAPPING",[vg]:"ACES_FILMIC_TONE_MAPPING",[yg]:"AGX_TONE_MAPPING",[xg]:"NEUTRAL_TONE_MAPPING",[_g]:"CUSTOM_TONE_MAPPING"};function iL(n,e,t,i,r,s){let o=new Vi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new es;h.setAttribute("position",new bi([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new bi([0,2,0,0,2,0],2));let d=new id({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new sr(h,d),p=new gd(-1,1,1,-1,0,1),m=null,_=null,v=!1,g,x=null,A=[],S=!1;this.setSize=function(P,C){o.setSize(P,C),a!==null&&a.setSize(P,C),l!==null&&l.setSize(P,C);for(let y=0;y<A.length;y++){let T=A[y];T.setSize&&T.setSize(P,C)}},this.setEffects=function(P){A=P,S=A.length>0&&A[0].isRenderPass===!0;let C=o.width,y=o.height;A.length>0&&a===null&&(a=new Vi(C,y,{type:Er,depthBuffer:!1,stencilBuffer:!1}),l=new Vi(C,y,{type:Er,depthBuffer:!1,stencilBuffer:!1}));let T=r===!0&&A.some(U=>U.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ps(C,y),s===!0&&(c.format=Is,c.type=ca)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let U=0;U<A.length;U++){let D=A[U];D.setSize&&D.setSize(C,y),T&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(P,C){if(v||P.toneMapping===ts&&A.length===0)return!1;if(x=C,C!==null){let y=C.width,T=C.height;(o.width!==y||o.height!==T)&&this.setSize(y,T)}return S===!1&&P.setRenderTarget(o),g=P.toneMapping,P.toneMapping=ts,!0},this.hasRenderPass=function(){return S},this.end=function(P,C){P.toneMapping=g,v=!0;let y=o,T=a;for(let U=0;U<A.length;U++){let D=A[U];D.enabled!==!1&&(D.render(P,T,y,C),D.needsSwap!==!1&&(y=T,T=T===a?l:a))}if(m!==P.outputColorSpace||_!==P.toneMapping){m=P.outputColorSpace,_=P.toneMapping,d.defines={},Tt.getTransfer(m)===Ot&&(d.defines.SRGB_TRANSFER="");let U=nL[_];U&&(d.defines[U]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,P.setRenderTarget(x),P.render(f,p),x=null,v=!1},this.isCompositing=function(){return v},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}var Qb=new Si,eS=new Ps(1,1),tS=new zc(1),nS=new Dc,iS=new Zh,rS=new Bc,Lb=[],Db=[],Nb=new Float32Array(16),Fb=new Float32Array(9),Ub=new Float32Array(4);function Rl(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=Lb[r];if(s===void 0&&(s=new Float32Array(r),Lb[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Fn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Un(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function lf(n,e){let t=Db[e];t===void 0&&(t=new Int32Array(e),Db[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function rL(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function sL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Fn(t,e))return;n.uniform2fv(this.addr,e),Un(t,e)}}function oL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Fn(t,e))return;n.uniform3fv(this.addr,e),Un(t,e)}}function aL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Fn(t,e))return;n.uniform4fv(this.addr,e),Un(t,e)}}function lL(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Fn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Un(t,e)}else{if(Fn(t,i))return;Ub.set(i),n.uniformMatrix2fv(this.addr,!1,Ub),Un(t,i)}}function cL(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Fn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Un(t,e)}else{if(Fn(t,i))return;Fb.set(i),n.uniformMatrix3fv(this.addr,!1,Fb),Un(t,i)}}function uL(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Fn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Un(t,e)}else{if(Fn(t,i))return;Nb.set(i),n.uniformMatrix4fv(this.addr,!1,Nb),Un(t,i)}}function hL(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function dL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Fn(t,e))return;n.uniform2iv(this.addr,e),Un(t,e)}}function fL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Fn(t,e))return;n.uniform3iv(this.addr,e),Un(t,e)}}function pL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Fn(t,e))return;n.uniform4iv(this.addr,e),Un(t,e)}}function mL(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function gL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Fn(t,e))return;n.uniform2uiv(this.addr,e),Un(t,e)}}function vL(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Fn(t,e))return;n.uniform3uiv(this.addr,e),Un(t,e)}}function _L(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Fn(t,e))return;n.uniform4uiv(this.addr,e),Un(t,e)}}function cf(n){return n.version===0&&(n.compareFunction=Lg,n.needsUpdate=!0),n}function yL(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=cf(eS):s=Qb,t.setTexture2D(e||s,r)}function xL(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||iS,r)}function bL(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=cf(tS):s=rS,t.setTextureCube(e||s,r)}function SL(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||nS,r)}function wL(n){switch(n){case 5126:return rL;case 35664:return sL;case 35665:return oL;case 35666:return aL;case 35674:return lL;case 35675:return cL;case 35676:return uL;case 5124:case 35670:return hL;case 35667:case 35671:return dL;case 35668:case 35672:return fL;case 35669:case 35673:return pL;case 5125:return mL;case 36294:return gL;case 36295:return vL;case 36296:return _L;case 35678:case 36198:case 36298:case 36306:case 35682:return yL;case 35679:case 36299:case 36307:return xL;case 35680:case 36300:case 36308:case 36293:return bL;case 36289:case 36303:case 36311:case 36292:return SL}}function ML(n,e){n.uniform1fv(this.addr,e)}function TL(n,e){let t=Rl(e,this.size,2);n.uniform2fv(this.addr,t)}function EL(n,e){let t=Rl(e,this.size,3);n.uniform3fv(this.addr,t)}function AL(n,e){let t=Rl(e,this.size,4);n.uniform4fv(this.addr,t)}function CL(n,e){let t=Rl(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function PL(n,e){let t=Rl(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function RL(n,e){let t=Rl(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function IL(n,e){n.uniform1iv(this.addr,e)}function LL(n,e){n.uniform2iv(this.addr,e)}function DL(n,e){n.uniform3iv(this.addr,e)}function NL(n,e){n.uniform4iv(this.addr,e)}function FL(n,e){n.uniform1uiv(this.addr,e)}function UL(n,e){n.uniform2uiv(this.addr,e)}function OL(n,e){n.uniform3uiv(this.addr,e)}function kL(n,e){n.uniform4uiv(this.addr,e)}function BL(n,e,t){let i=this.cache,r=e.length,s=lf(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=cf(eS):o=Qb;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function zL(n,e,t){let i=this.cache,r=e.length,s=lf(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||iS,s[o])}function GL(n,e,t){let i=this.cache,r=e.length,s=lf(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=cf(tS):o=rS;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function VL(n,e,t){let i=this.cache,r=e.length,s=lf(t,r);Fn(i,s)||(n.uniform1iv(this.addr,s),Un(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||nS,s[o])}function HL(n){switch(n){case 5126:return ML;case 35664:return TL;case 35665:return EL;case 35666:return AL;case 35674:return CL;case 35675:return PL;case 35676:return RL;case 5124:case 35670:return IL;case 35667:case 35671:return LL;case 35668:case 35672:return DL;case 35669:case 35673:return NL;case 5125:return FL;case 36294:return UL;case 36295:return OL;case 36296:return kL;case 35678:case 36198:case 36298:case 36306:case 35682:return BL;case 35679:case 36299:case 36307:return zL;case 35680:case 36300:case 36308:case 36293:return GL;case 36289:case 36303:case 36311:case 36292:return VL}}var qg=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=wL(t.type)}},Xg=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=HL(t.type)}},$g=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},Hg=/(\w+)(\])?(\[|\.)?/g;function Ob(n,e){n.seq.push(e),n.map[e.id]=e}function WL(n,e,t){let i=n.name,r=i.length;for(Hg.lastIndex=0;;){let s=Hg.exec(i),o=Hg.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){Ob(t,c===void 0?new qg(a,n,e):new Xg(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new $g(a),Ob(t,d)),t=d}}}var Pl=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);WL(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function kb(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var qL=37297,XL=0;function $L(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Bb=new it;function YL(n){Tt._getMatrix(Bb,Tt.workingColorSpace,n);let e=`mat3( ${Bb.elements.map(t=>t.toFixed(4))} )`;switch(Tt.getTransfer(n)){case Rc:return[e,"LinearTransferOETF"];case Ot:return[e,"sRGBTransferOETF"];default:return je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function zb(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+$L(n.getShaderSource(e),a)}else return s}function KL(n,e){let t=YL(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ZL={[pg]:"Linear",[mg]:"Reinhard",[gg]:"Cineon",[vg]:"ACESFilmic",[yg]:"AgX",[xg]:"Neutral",[_g]:"Custom"};function JL(n,e){let t=ZL[e];return t===void 0?(je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var sf=new Z;function jL(){Tt.getLuminanceCoefficients(sf);let n=sf.x.toFixed(4),e=sf.y.toFixed(4),t=sf.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function QL(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(tu).join(`
`)}function e2(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function t2(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function tu(n){return n!==""}function Gb(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Vb(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var n2=/^[ \t]*#include +<([\w\d./]+)>/gm;function Yg(n){return n.replace(n2,i2)}function i2(n,e){let t=gt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Yg(t)}var r2=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Hb(n){return n.replace(r2,s2)}function s2(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Wb(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var o2={[Xc]:"SHADOWMAP_TYPE_PCF",[Ml]:"SHADOWMAP_TYPE_VSM"};function a2(n){return o2[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var l2={[El]:"ENVMAP_MODE_REFRACTION"};function c2(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":l2[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var u2={[fg]:"ENVMAP_BLENDING_MULTIPLY",[ob]:"ENVMAP_BLENDING_MIX",[ab]:"ENVMAP_BLENDING_ADD"};function h2(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":u2[n.combine]||"ENVMAP_BLENDING_NONE"}function d2(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=a2(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=c2(t),d=h2(t),f=QL(t),p=e2(s),m=r.createProgram(),_,v,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(tu).join(`
`),_.length>0&&(_+=`
`),v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p].filter(tu).join(`
`),v.length>0&&(v+=`
`)):(_=[Wb(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+h:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(tu).join(`
`),v=[Wb(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,p,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+h:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ts?"#define TONE_MAPPING":"",t.toneMapping!==ts?gt.tonemapping_pars_fragment:"",t.toneMapping!==ts?JL("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",gt.colorspace_pars_fragment,KL("linearToOutputTexel",t.outputColorSpace),jL(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(tu).join(`
`)),o=Yg(o),o=Gb(o,t),o=Vb(o,t),a=Yg(a),a=Gb(a,t),a=Vb(a,t),o=Hb(o),a=Hb(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,_=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,v=["#define varying in",t.glslVersion===Dg?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Dg?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+v);let x=g+_+o,A=g+v+a,S=kb(r,r.VERTEX_SHADER,x),P=kb(r,r.FRAGMENT_SHADER,A);r.attachShader(m,S),r.attachShader(m,P),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function C(D){if(n.debug.checkShaderErrors){let L=r.getProgramInfoLog(m)||"",B=r.getShaderInfoLog(S)||"",G=r.getShaderInfoLog(P)||"",F=L.trim(),H=B.trim(),Y=G.trim(),V=!0,le=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,m,S,P);else{let X=zb(r,S,"vertex"),Q=zb(r,P,"fragment");st("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+F+`
`+X+`
`+Q)}else F!==""?je("WebGLProgram: Program Info Log:",F):(H===""||Y==="")&&(le=!1);le&&(D.diagnostics={runnable:V,programLog:F,vertexShader:{log:H,prefix:_},fragmentShader:{log:Y,prefix:v}})}r.deleteShader(S),r.deleteShader(P),y=new Pl(r,m),T=t2(r,m)}let y;this.getUniforms=function(){return y===void 0&&C(this),y};let T;this.getAttributes=function(){return T===void 0&&C(this),T};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=r.getProgramParameter(m,qL)),U},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=XL++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=S,this.fragmentShader=P,this}var f2=0,Kg=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Zg(e),t.set(e,i)),i}},Zg=class{constructor(e){this.id=f2++,this.code=e,this.usedTimes=0}};function p2(n){return n===yo||n===jc||n===Qc}function m2(n,e,t,i,r,s){let o=new Nc,a=new Kg,l=new Set,c=[],h=new Map,d=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,T,U,D,L,B){let G=D.fog,F=L.geometry,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?D.environment:null,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,V=e.get(y.envMap||H,Y),le=f[y.type],X=i.precision;y.precision!==null&&(X=i.getMaxPrecision(y.precision),X!==y.precision&&je("WebGLProgram.getParameters:",y.precision,"not supported, using",X,"instead."));let Q=F.morphAttributes.position||F.morphAttributes.normal||F.morphAttributes.color,se=Q!==void 0?Q.length:0,fe=0;F.morphAttributes.position!==void 0&&(fe=1),F.morphAttributes.normal!==void 0&&(fe=2),F.morphAttributes.color!==void 0&&(fe=3);let de,ee,ge,ye;if(le){let Pe=is[le];de=Pe.vertexShader,ee=Pe.fragmentShader}else{de=y.vertexShader,ee=y.fragmentShader;let Pe=a.getVertexShaderStage(y),dt=a.getFragmentShaderStage(y);a.update(y,Pe,dt),ge=Pe.id,ye=dt.id}let Ce=n.getRenderTarget(),we=n.state.buffers.depth.getReversed(),$e=L.isInstancedMesh===!0,ut=L.isBatchedMesh===!0,We=!!y.map,_t=!!y.matcap,ft=!!V,lt=ft&&V.isPMREMTexture===!0,rn=!!y.aoMap,$t=!!y.lightMap,xn=!!y.bumpMap&&y.wireframe===!1,Gt=!!y.normalMap,kn=!!y.displacementMap,Ct=!!y.emissiveMap,Rn=!!y.metalnessMap,dn=!!y.roughnessMap,bn=y.anisotropy>0,k=y.clearcoat>0,Re=y.diffuseRoughness>0,Qe=y.dispersion>0,ht=y.retroreflectivity>0,Me=y.iridescence>0,Wt=y.sheen>0,He=y.transmission>0,Ze=bn&&!!y.anisotropyMap,R=k&&!!y.clearcoatMap,w=k&&!!y.clearcoatNormalMap,q=k&&!!y.clearcoatRoughnessMap,he=Re&&!!y.diffuseRoughnessMap,ae=Me&&!!y.iridescenceMap,_e=Me&&!!y.iridescenceThicknessMap,xe=Wt&&!!y.sheenColorMap,te=Wt&&!!y.sheenRoughnessMap,ie=!!y.specularMap,me=!!y.specularColorMap,O=!!y.specularIntensityMap,oe=He&&!!y.transmissionMap,ne=He&&!!y.thicknessMap,Te=!!y.gradientMap,ve=!!y.alphaMap,Se=y.alphaTest>0,qe=!!y.alphaHash,tt=!!y.extensions,ue=ts;y.toneMapped&&(Ce===null||Ce.isXRRenderTarget===!0)&&(ue=n.toneMapping);let ke=lt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,nt={shaderID:le,shaderType:y.type,shaderName:y.name,vertexShader:de,fragmentShader:ee,defines:y.defines,customVertexShaderID:ge,customFragmentShaderID:ye,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:X,batching:ut,batchingColor:ut&&L._colorsTexture!==null,instancing:$e,instancingColor:$e&&L.instanceColor!==null,instancingMorph:$e&&L.morphTexture!==null,outputColorSpace:Ce===null?n.outputColorSpace:Ce.isXRRenderTarget===!0?Ce.texture.colorSpace:Tt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:We,matcap:_t,envMap:ft,envMapMode:ft&&V.mapping,envMapPMREM:lt,envMapMaxLod:lt?ke.length-1:null,envMapSize:lt?ke[0].width:null,aoMap:rn,lightMap:$t,bumpMap:xn,normalMap:Gt,displacementMap:kn,emissiveMap:Ct,normalMapObjectSpace:Gt&&y.normalMapType===ub,normalMapTangentSpace:Gt&&y.normalMapType===Pg,packedNormalMap:Gt&&y.normalMapType===Pg&&p2(y.normalMap.format),metalnessMap:Rn,roughnessMap:dn,anisotropy:bn,anisotropyMap:Ze,clearcoat:k,clearcoatMap:R,clearcoatNormalMap:w,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:he,dispersion:Qe,retroreflection:ht,iridescence:Me,iridescenceMap:ae,iridescenceThicknessMap:_e,sheen:Wt,sheenColorMap:xe,sheenRoughnessMap:te,specularMap:ie,specularColorMap:me,specularIntensityMap:O,transmission:He,transmissionMap:oe,thicknessMap:ne,gradientMap:Te,opaque:y.transparent===!1&&y.blending===Tl&&y.alphaToCoverage===!1,alphaMap:ve,alphaTest:Se,alphaHash:qe,combine:y.combine,mapUv:We&&p(y.map.channel),aoMapUv:rn&&p(y.aoMap.channel),lightMapUv:$t&&p(y.lightMap.channel),bumpMapUv:xn&&p(y.bumpMap.channel),normalMapUv:Gt&&p(y.normalMap.channel),displacementMapUv:kn&&p(y.displacementMap.channel),emissiveMapUv:Ct&&p(y.emissiveMap.channel),metalnessMapUv:Rn&&p(y.metalnessMap.channel),roughnessMapUv:dn&&p(y.roughnessMap.channel),anisotropyMapUv:Ze&&p(y.anisotropyMap.channel),clearcoatMapUv:R&&p(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&p(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&p(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&p(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&p(y.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&p(y.iridescenceThicknessMap.channel),sheenColorMapUv:xe&&p(y.sheenColorMap.channel),sheenRoughnessMapUv:te&&p(y.sheenRoughnessMap.channel),specularMapUv:ie&&p(y.specularMap.channel),specularColorMapUv:me&&p(y.specularColorMap.channel),specularIntensityMapUv:O&&p(y.specularIntensityMap.channel),transmissionMapUv:oe&&p(y.transmissionMap.channel),thicknessMapUv:ne&&p(y.thicknessMap.channel),alphaMapUv:ve&&p(y.alphaMap.channel),vertexTangents:!!F.attributes.tangent&&(Gt||bn),vertexNormals:!!F.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!F.attributes.color&&F.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!F.attributes.uv&&(We||ve),fog:!!G,useFog:y.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||F.attributes.normal===void 0&&Gt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:we,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:F.attributes.position!==void 0,morphTargets:F.morphAttributes.position!==void 0,morphNormals:F.morphAttributes.normal!==void 0,morphColors:F.morphAttributes.color!==void 0,morphTargetsCount:se,morphTextureStride:fe,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:B.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&U.length>0,shadowMapType:n.shadowMap.type,toneMapping:ue,decodeVideoTexture:We&&y.map.isVideoTexture===!0&&Tt.getTransfer(y.map.colorSpace)===Ot,decodeVideoTextureEmissive:Ct&&y.emissiveMap.isVideoTexture===!0&&Tt.getTransfer(y.emissiveMap.colorSpace)===Ot,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===or,flipSided:y.side===pi,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:tt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&y.extensions.multiDraw===!0||ut)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function _(y){let T=[];if(y.shaderID?T.push(y.shaderID):(T.push(y.customVertexShaderID),T.push(y.customFragmentShaderID)),y.defines!==void 0)for(let U in y.defines)T.push(U),T.push(y.defines[U]);return y.isRawShaderMaterial===!1&&(v(T,y),g(T,y),T.push(n.outputColorSpace)),T.push(y.customProgramCacheKey),T.join()}function v(y,T){y.push(T.precision),y.push(T.outputColorSpace),y.push(T.envMapMode),y.push(T.envMapPMREM),y.push(T.envMapMaxLod),y.push(T.envMapSize),y.push(T.mapUv),y.push(T.alphaMapUv),y.push(T.lightMapUv),y.push(T.aoMapUv),y.push(T.bumpMapUv),y.push(T.normalMapUv),y.push(T.displacementMapUv),y.push(T.emissiveMapUv),y.push(T.metalnessMapUv),y.push(T.roughnessMapUv),y.push(T.anisotropyMapUv),y.push(T.clearcoatMapUv),y.push(T.clearcoatNormalMapUv),y.push(T.clearcoatRoughnessMapUv),y.push(T.diffuseRoughnessMapUv),y.push(T.iridescenceMapUv),y.push(T.iridescenceThicknessMapUv),y.push(T.sheenColorMapUv),y.push(T.sheenRoughnessMapUv),y.push(T.specularMapUv),y.push(T.specularColorMapUv),y.push(T.specularIntensityMapUv),y.push(T.transmissionMapUv),y.push(T.thicknessMapUv),y.push(T.combine),y.push(T.fogExp2),y.push(T.sizeAttenuation),y.push(T.morphTargetsCount),y.push(T.numSunLights),y.push(T.numDirLights),y.push(T.numPointLights),y.push(T.numSpotLights),y.push(T.numSpotLightMaps),y.push(T.numHemiLights),y.push(T.numRectAreaLights),y.push(T.numSunLightShadows),y.push(T.numDirLightShadows),y.push(T.numPointLightShadows),y.push(T.numSpotLightShadows),y.push(T.numSpotLightShadowsWithMaps),y.push(T.numLightProbes),y.push(T.numLightProbeGrids),y.push(T.shadowMapType),y.push(T.toneMapping),y.push(T.numClippingPlanes),y.push(T.numClipIntersection),y.push(T.depthPacking)}function g(y,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function x(y){let T=f[y.type],U;if(T){let D=is[T];U=Tb.clone(D.uniforms)}else U=y.uniforms;return U}function A(y,T){let U=h.get(T);return U!==void 0?++U.usedTimes:(U=new d2(n,T,y,r),c.push(U),h.set(T,U)),U}function S(y){if(--y.usedTimes===0){let T=c.indexOf(y);c[T]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function P(y){a.remove(y)}function C(){a.dispose()}return{getParameters:m,getProgramCacheKey:_,getUniforms:x,acquireProgram:A,releaseProgram:S,releaseShaderCache:P,programs:c,dispose:C}}function g2(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function v2(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function qb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Xb(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,m,_,v,g){let x=n[e];return x===void 0?(x={id:f.id,object:f,geometry:p,material:m,materialVariant:o(f),groupOrder:_,renderOrder:f.renderOrder,z:v,group:g},n[e]=x):(x.id=f.id,x.object=f,x.geometry=p,x.material=m,x.materialVariant=o(f),x.groupOrder=_,x.renderOrder=f.renderOrder,x.z=v,x.group=g),e++,x}function l(f,p,m,_,v,g,x){x.reversedDepth===!0&&(v=-v);let A=a(f,p,m,_,v,g);m.transmission>0?i.push(A):m.transparent===!0?r.push(A):t.push(A)}function c(f,p,m,_,v,g){let x=a(f,p,m,_,v,g);m.transmission>0?i.unshift(x):m.transparent===!0?r.unshift(x):t.unshift(x)}function h(f,p){t.length>1&&t.sort(f||v2),i.length>1&&i.sort(p||qb),r.length>1&&r.sort(p||qb)}function d(){for(let f=e,p=n.length;f<p;f++){let m=n[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:d,sort:h}}function _2(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new Xb,n.set(i,[o])):r>=s.length?(o=new Xb,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function y2(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Z,color:new Et};break;case"SpotLight":t={position:new Z,direction:new Z,color:new Et,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Z,color:new Et,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Z,skyColor:new Et,groundColor:new Et};break;case"RectAreaLight":t={color:new Et,position:new Z,halfWidth:new Z,halfHeight:new Z};break}return n[e.id]=t,t}}}function x2(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new at};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new at};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new at,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var b2=0;function S2(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function w2(n){let e=new y2,t=x2(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Z);let r=new Z,s=new cn,o=new cn;function a(c){let h=0,d=0,f=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let p=0,m=0,_=0,v=0,g=0,x=0,A=0,S=0,P=0,C=0,y=0,T=0,U=0,D=0;c.sort(S2);for(let B=0,G=c.length;B<G;B++){let F=c[B],H=F.color,Y=F.intensity,V=F.distance,le=null;if(F.shadow&&F.shadow.map&&(F.shadow.map.texture.format===yo?le=F.shadow.map.texture:le=F.shadow.map.depthTexture||F.shadow.map.texture),F.isAmbientLight)h+=H.r*Y,d+=H.g*Y,f+=H.b*Y;else if(F.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(F.sh.coefficients[X],Y);D++}else if(F.isSunLight){let X=e.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let Q=F.shadow,se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[m]=se,i.sunShadowMap[m]=le;let fe=Q.getViewportCount();for(let de=0;de<fe;de++)i.sunShadowMatrix[_+de]=Q.getMatrix(de),i.sunShadowCascade[_+de]=Q._cascadeData[de];_+=fe,m++}i.sun[p]=X,p++}else if(F.isDirectionalLight){let X=e.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let Q=F.shadow,se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.directionalShadow[v]=se,i.directionalShadowMap[v]=le,i.directionalShadowMatrix[v]=F.shadow.matrix,P++}i.directional[v]=X,v++}else if(F.isSpotLight){let X=e.get(F);X.position.setFromMatrixPosition(F.matrixWorld),X.color.copy(H).multiplyScalar(Y),X.distance=V,X.coneCos=Math.cos(F.angle),X.penumbraCos=Math.cos(F.angle*(1-F.penumbra)),X.decay=F.decay,i.spot[x]=X;let Q=F.shadow;if(F.map&&(i.spotLightMap[T]=F.map,T++,Q.updateMatrices(F),F.castShadow&&U++),i.spotLightMatrix[x]=Q.matrix,F.castShadow){let se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,i.spotShadow[x]=se,i.spotShadowMap[x]=le,y++}x++}else if(F.isRectAreaLight){let X=e.get(F);X.color.copy(H).multiplyScalar(Y),X.halfWidth.set(F.width*.5,0,0),X.halfHeight.set(0,F.height*.5,0),i.rectArea[A]=X,A++}else if(F.isPointLight){let X=e.get(F);if(X.color.copy(F.color).multiplyScalar(F.intensity),X.distance=F.distance,X.decay=F.decay,F.castShadow){let Q=F.shadow,se=t.get(F);se.shadowIntensity=Q.intensity,se.shadowBias=Q.bias,se.shadowNormalBias=Q.normalBias,se.shadowRadius=Q.radius,se.shadowMapSize=Q.mapSize,se.shadowCameraNear=Q.camera.near,se.shadowCameraFar=Q.camera.far,i.pointShadow[g]=se,i.pointShadowMap[g]=le,i.pointShadowMatrix[g]=F.shadow.matrix,C++}i.point[g]=X,g++}else if(F.isHemisphereLight){let X=e.get(F);X.skyColor.copy(F.color).multiplyScalar(Y),X.groundColor.copy(F.groundColor).multiplyScalar(Y),i.hemi[S]=X,S++}}A>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=De.LTC_FLOAT_1,i.rectAreaLTC2=De.LTC_FLOAT_2):(i.rectAreaLTC1=De.LTC_HALF_1,i.rectAreaLTC2=De.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=d,i.ambient[2]=f;let L=i.hash;(L.sunLength!==p||L.directionalLength!==v||L.pointLength!==g||L.spotLength!==x||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==m||L.numDirectionalShadows!==P||L.numPointShadows!==C||L.numSpotShadows!==y||L.numSpotMaps!==T||L.numLightProbes!==D)&&(i.sun.length=p,i.directional.length=v,i.spot.length=x,i.rectArea.length=A,i.point.length=g,i.hemi.length=S,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=P,i.directionalShadowMap.length=P,i.directionalShadowMatrix.length=P,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+T-U,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=U,i.numLightProbes=D,L.sunLength=p,L.directionalLength=v,L.pointLength=g,L.spotLength=x,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=m,L.numDirectionalShadows=P,L.numPointShadows=C,L.numSpotShadows=y,L.numSpotMaps=T,L.numLightProbes=D,i.version=b2++)}function l(c,h){let d=0,f=0,p=0,m=0,_=0,v=0,g=h.matrixWorldInverse;for(let x=0,A=c.length;x<A;x++){let S=c[x];if(S.isSunLight){let P=i.sun[d];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),d++}else if(S.isDirectionalLight){let P=i.directional[f];P.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(r),P.direction.transformDirection(g),f++}else if(S.isSpotLight){let P=i.spot[m];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),P.direction.setFromMatrixPosition(S.matrixWorld),r.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(r),P.direction.transformDirection(g),m++}else if(S.isRectAreaLight){let P=i.rectArea[_];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),o.identity(),s.copy(S.matrixWorld),s.premultiply(g),o.extractRotation(s),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),_++}else if(S.isPointLight){let P=i.point[p];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(g),p++}else if(S.isHemisphereLight){let P=i.hemi[v];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(g),v++}}}return{setup:a,setupView:l,state:i}}function $b(n){let e=new w2(n),t=[],i=[],r=[];function s(d){h.camera=d,t.length=0,i.length=0,r.length=0}function o(d){d.isLightProbeGrid?r.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),r.sort((d,f)=>d.priority-f.priority||d.id-f.id)}function c(d){e.setupView(t,d)}let h={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function M2(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new $b(n),e.set(r,[a])):s>=o.length?(a=new $b(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var T2=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,E2=`uniform sampler2D shadow_pass;
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
}`,A2=[new Z(1,0,0),new Z(-1,0,0),new Z(0,1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1)],C2=[new Z(0,-1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1),new Z(0,-1,0),new Z(0,-1,0)],Yb=new cn,eu=new Z,Wg=new Z;function P2(n,e,t){let i=new sa,r=new at,s=new at,o=new un,a=new rd,l=new sd,c={},h=t.maxTextureSize,d={[_o]:pi,[pi]:_o,[or]:or},f=new Wi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new at},radius:{value:4}},vertexShader:T2,fragmentShader:E2}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let m=new es;m.setAttribute("position",new fi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new sr(m,f),v=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xc;let g=this.type;this.render=function(C,y,T){if(v.enabled===!1||v.autoUpdate===!1&&v.needsUpdate===!1||C.length===0)return;this.type===Gx&&(je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xc);let U=n.getRenderTarget(),D=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),B=n.state;B.setBlending(oa),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let G=g!==this.type;G&&y.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(H=>H.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,H=C.length;F<H;F++){let Y=C[F],V=Y.shadow;if(V===void 0){je("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;r.copy(V.mapSize);let le=V.getFrameExtents();r.multiply(le),s.copy(V.mapSize),(r.x>h||r.y>h)&&(r.x>h&&(s.x=Math.floor(h/le.x),r.x=s.x*le.x,V.mapSize.x=s.x),r.y>h&&(s.y=Math.floor(h/le.y),r.y=s.y*le.y,V.mapSize.y=s.y));let X=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Ml){if(Y.isPointLight){je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new Vi(r.x,r.y,{format:yo,type:Er,minFilter:Zn,magFilter:Zn,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new Ps(r.x,r.y,Tr),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=As,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qn,V.map.depthTexture.magFilter=qn}else Y.isPointLight?(V.map=new nu(r.x),V.map.depthTexture=new zc(r.x,Mr)):(V.map=new Vi(r.x,r.y),V.map.depthTexture=new Ps(r.x,r.y,Mr)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=As,this.type===Xc?(V.map.depthTexture.compareFunction=X?Ig:Rg,V.map.depthTexture.minFilter=Zn,V.map.depthTexture.magFilter=Zn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=qn,V.map.depthTexture.magFilter=qn);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==r.x||V.map.height!==r.y)&&V.map.setSize(r.x,r.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,T);let se=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:T.layers;for(let fe=0;fe<Q;fe++){let de=V.getCamera(fe);if(Y.isPointLight){let ee=V.camera,ge=V.matrix,ye=Y.distance||ee.far;ye!==ee.far&&(ee.far=ye,ee.updateProjectionMatrix()),eu.setFromMatrixPosition(Y.matrixWorld),ee.position.copy(eu),Wg.copy(ee.position),Wg.add(A2[fe]),ee.up.copy(C2[fe]),ee.lookAt(Wg),ee.updateMatrixWorld(),ge.makeTranslation(-eu.x,-eu.y,-eu.z),Yb.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Yb,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,fe),n.clear();else{fe===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(fe);o.set(s.x*ee.x,s.y*ee.y,s.x*ee.z,s.y*ee.w),B.viewport(o)}i=V.getFrustum(fe),S(y,T,de,Y,se,this.type)}V.isPointLightShadow!==!0&&this.type===Ml&&x(V,T),V.needsUpdate=!1}g=this.type,v.needsUpdate=!1,n.setRenderTarget(U,D,L)};function x(C,y){let T=e.update(_);f.defines.VSM_SAMPLES!==C.blurSamples&&(f.defines.VSM_SAMPLES=C.blurSamples,p.defines.VSM_SAMPLES=C.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),C.mapPass===null?C.mapPass=new Vi(r.x,r.y,{format:yo,type:Er}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),f.uniforms.shadow_pass.value=C.map.depthTexture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(y,null,T,f,_,null),p.uniforms.shadow_pass.value=C.mapPass.texture,p.uniforms.resolution.value.set(C.map.width,C.map.height),p.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(y,null,T,p,_,null)}function A(C,y,T,U){let D=null,L=T.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)D=L;else if(D=T.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let B=D.uuid,G=y.uuid,F=c[B];F===void 0&&(F={},c[B]=F);let H=F[G];H===void 0&&(H=D.clone(),F[G]=H,y.addEventListener("dispose",P)),D=H}if(D.visible=y.visible,D.wireframe=y.wireframe,U===Ml?D.side=y.shadowSide!==null?y.shadowSide:y.side:D.side=y.shadowSide!==null?y.shadowSide:d[y.side],D.alphaMap=y.alphaMap,D.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,D.map=y.map,D.clipShadows=y.clipShadows,D.clippingPlanes=y.clippingPlanes,D.clipIntersection=y.clipIntersection,D.displacementMap=y.displacementMap,D.displacementScale=y.displacementScale,D.displacementBias=y.displacementBias,D.wireframeLinewidth=y.wireframeLinewidth,D.linewidth=y.linewidth,T.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let B=n.properties.get(D);B.light=T}return D}function S(C,y,T,U,D,L){if(C.visible===!1)return;if(C.layers.test(D)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===Ml)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,C.matrixWorld);let F=e.update(C),H=C.material;if(Array.isArray(H)){let Y=F.groups;for(let V=0,le=Y.length;V<le;V++){let X=Y[V],Q=H[X.materialIndex];if(Q&&Q.visible){let se=A(C,Q,U,L);C.onBeforeShadow(n,C,y,T,F,se,X),n.renderBufferDirect(T,null,F,se,C,X),C.onAfterShadow(n,C,y,T,F,se,X)}}}else if(H.visible){let Y=A(C,H,U,L);C.onBeforeShadow(n,C,y,T,F,Y,null),n.renderBufferDirect(T,null,F,Y,C,null),C.onAfterShadow(n,C,y,T,F,Y,null)}}let G=C.children;for(let F=0,H=G.length;F<H;F++)S(G[F],y,T,U,D,L)}function P(C){C.target.removeEventListener("dispose",P);for(let T in c){let U=c[T],D=C.target.uuid;D in U&&(U[D].dispose(),delete U[D])}}}function R2(n,e){function t(){let O=!1,oe=new un,ne=null,Te=new un(0,0,0,0);return{setMask:function(ve){ne!==ve&&!O&&(n.colorMask(ve,ve,ve,ve),ne=ve)},setLocked:function(ve){O=ve},setClear:function(ve,Se,qe,tt,ue){ue===!0&&(ve*=tt,Se*=tt,qe*=tt),oe.set(ve,Se,qe,tt),Te.equals(oe)===!1&&(n.clearColor(ve,Se,qe,tt),Te.copy(oe))},reset:function(){O=!1,ne=null,Te.set(-1,0,0,0)}}}function i(){let O=!1,oe=!1,ne=null,Te=null,ve=null;return{setReversed:function(Se){if(oe!==Se){let qe=e.get("EXT_clip_control");Se?qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.ZERO_TO_ONE_EXT):qe.clipControlEXT(qe.LOWER_LEFT_EXT,qe.NEGATIVE_ONE_TO_ONE_EXT),oe=Se;let tt=ve;ve=null,this.setClear(tt)}},getReversed:function(){return oe},setTest:function(Se){Se?we(n.DEPTH_TEST):$e(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!O&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(oe&&(Se=bb[Se]),Te!==Se){switch(Se){case kh:n.depthFunc(n.NEVER);break;case Bh:n.depthFunc(n.ALWAYS);break;case zh:n.depthFunc(n.LESS);break;case pl:n.depthFunc(n.LEQUAL);break;case Gh:n.depthFunc(n.EQUAL);break;case Vh:n.depthFunc(n.GEQUAL);break;case Hh:n.depthFunc(n.GREATER);break;case Wh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Se}},setLocked:function(Se){O=Se},setClear:function(Se){ve!==Se&&(ve=Se,oe&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ne=null,Te=null,ve=null,oe=!1}}}function r(){let O=!1,oe=null,ne=null,Te=null,ve=null,Se=null,qe=null,tt=null,ue=null;return{setTest:function(ke){O||(ke?we(n.STENCIL_TEST):$e(n.STENCIL_TEST))},setMask:function(ke){oe!==ke&&!O&&(n.stencilMask(ke),oe=ke)},setFunc:function(ke,nt,Pe){(ne!==ke||Te!==nt||ve!==Pe)&&(n.stencilFunc(ke,nt,Pe),ne=ke,Te=nt,ve=Pe)},setOp:function(ke,nt,Pe){(Se!==ke||qe!==nt||tt!==Pe)&&(n.stencilOp(ke,nt,Pe),Se=ke,qe=nt,tt=Pe)},setLocked:function(ke){O=ke},setClear:function(ke){ue!==ke&&(n.clearStencil(ke),ue=ke)},reset:function(){O=!1,oe=null,ne=null,Te=null,ve=null,Se=null,qe=null,tt=null,ue=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,h={},d={},f={},p=new WeakMap,m=[],_=null,v=!1,g=null,x=null,A=null,S=null,P=null,C=null,y=null,T=new Et(0,0,0),U=0,D=!1,L=null,B=null,G=null,F=null,H=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,le=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=le>=1):X.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=le>=2);let Q=null,se={},fe=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),ee=new un().fromArray(fe),ge=new un().fromArray(de);function ye(O,oe,ne,Te){let ve=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let qe=0;qe<ne;qe++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,ve):n.texImage2D(oe+qe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ve);return Se}let Ce={};Ce[n.TEXTURE_2D]=ye(n.TEXTURE_2D,n.TEXTURE_2D,1),Ce[n.TEXTURE_CUBE_MAP]=ye(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ce[n.TEXTURE_2D_ARRAY]=ye(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ce[n.TEXTURE_3D]=ye(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),we(n.DEPTH_TEST),o.setFunc(pl),xn(!1),Gt(ag),we(n.CULL_FACE),rn(oa);function we(O){h[O]!==!0&&(n.enable(O),h[O]=!0)}function $e(O){h[O]!==!1&&(n.disable(O),h[O]=!1)}function ut(O,oe){return f[O]!==oe?(n.bindFramebuffer(O,oe),f[O]=oe,O===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=oe),O===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function We(O,oe){let ne=m,Te=!1;if(O){ne=p.get(oe),ne===void 0&&(ne=[],p.set(oe,ne));let ve=O.textures;if(ne.length!==ve.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,qe=ve.length;Se<qe;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=ve.length,Te=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ne)}function _t(O){return _!==O?(n.useProgram(O),_=O,!0):!1}let ft={[aa]:n.FUNC_ADD,[Hx]:n.FUNC_SUBTRACT,[Wx]:n.FUNC_REVERSE_SUBTRACT};ft[qx]=n.MIN,ft[Xx]=n.MAX;let lt={[$x]:n.ZERO,[Yx]:n.ONE,[Kx]:n.SRC_COLOR,[hg]:n.SRC_ALPHA,[tb]:n.SRC_ALPHA_SATURATE,[Qx]:n.DST_COLOR,[Jx]:n.DST_ALPHA,[Zx]:n.ONE_MINUS_SRC_COLOR,[dg]:n.ONE_MINUS_SRC_ALPHA,[eb]:n.ONE_MINUS_DST_COLOR,[jx]:n.ONE_MINUS_DST_ALPHA,[nb]:n.CONSTANT_COLOR,[ib]:n.ONE_MINUS_CONSTANT_COLOR,[rb]:n.CONSTANT_ALPHA,[sb]:n.ONE_MINUS_CONSTANT_ALPHA};function rn(O,oe,ne,Te,ve,Se,qe,tt,ue,ke){if(O===oa){v===!0&&($e(n.BLEND),v=!1);return}if(v===!1&&(we(n.BLEND),v=!0),O!==Vx){if(O!==g||ke!==D){if((x!==aa||P!==aa)&&(n.blendEquation(n.FUNC_ADD),x=aa,P=aa),ke)switch(O){case Tl:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lg:n.blendFunc(n.ONE,n.ONE);break;case cg:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case ug:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:st("WebGLState: Invalid blending: ",O);break}else switch(O){case Tl:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case lg:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case cg:st("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case ug:st("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:st("WebGLState: Invalid blending: ",O);break}A=null,S=null,C=null,y=null,T.set(0,0,0),U=0,g=O,D=ke}return}ve=ve||oe,Se=Se||ne,qe=qe||Te,(oe!==x||ve!==P)&&(n.blendEquationSeparate(ft[oe],ft[ve]),x=oe,P=ve),(ne!==A||Te!==S||Se!==C||qe!==y)&&(n.blendFuncSeparate(lt[ne],lt[Te],lt[Se],lt[qe]),A=ne,S=Te,C=Se,y=qe),(tt.equals(T)===!1||ue!==U)&&(n.blendColor(tt.r,tt.g,tt.b,ue),T.copy(tt),U=ue),g=O,D=!1}function $t(O,oe){O.side===or?$e(n.CULL_FACE):we(n.CULL_FACE);let ne=O.side===pi;oe&&(ne=!ne),xn(ne),O.blending===Tl&&O.transparent===!1?rn(oa):rn(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),s.setMask(O.colorWrite);let Te=O.stencilWrite;a.setTest(Te),Te&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),Ct(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?we(n.SAMPLE_ALPHA_TO_COVERAGE):$e(n.SAMPLE_ALPHA_TO_COVERAGE)}function xn(O){L!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),L=O)}function Gt(O){O!==Bx?(we(n.CULL_FACE),O!==B&&(O===ag?n.cullFace(n.BACK):O===zx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):$e(n.CULL_FACE),B=O}function kn(O){O!==G&&(V&&n.lineWidth(O),G=O)}function Ct(O,oe,ne){O?(we(n.POLYGON_OFFSET_FILL),(F!==oe||H!==ne)&&(F=oe,H=ne,o.getReversed()&&(oe=-oe,ne=-ne),n.polygonOffset(oe,ne))):$e(n.POLYGON_OFFSET_FILL)}function Rn(O){O?we(n.SCISSOR_TEST):$e(n.SCISSOR_TEST)}function dn(O){O===void 0&&(O=n.TEXTURE0+Y-1),Q!==O&&(n.activeTexture(O),Q=O)}function bn(O,oe,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+Y-1:ne=Q);let Te=se[ne];Te===void 0&&(Te={type:void 0,texture:void 0},se[ne]=Te),(Te.type!==O||Te.texture!==oe)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(O,oe||Ce[O]),Te.type=O,Te.texture=oe)}function k(){let O=se[Q];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function Qe(){try{n.compressedTexImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function ht(){try{n.texSubImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function Me(){try{n.texSubImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function Wt(){try{n.compressedTexSubImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function Ze(){try{n.texStorage2D(...arguments)}catch(O){st("WebGLState:",O)}}function R(){try{n.texStorage3D(...arguments)}catch(O){st("WebGLState:",O)}}function w(){try{n.texImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function q(){try{n.texImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function he(O){return d[O]!==void 0?d[O]:n.getParameter(O)}function ae(O,oe){d[O]!==oe&&(n.pixelStorei(O,oe),d[O]=oe)}function _e(O){ee.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),ee.copy(O))}function xe(O){ge.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),ge.copy(O))}function te(O,oe){let ne=c.get(oe);ne===void 0&&(ne=new WeakMap,c.set(oe,ne));let Te=ne.get(O);Te===void 0&&(Te=n.getUniformBlockIndex(oe,O.name),n.uniformBlockBinding(oe,Te,Te),ne.set(O,Te))}function ie(O,oe,ne){let ve=c.get(oe).get(O);l[ve]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ve,ne),l[ve]=ne)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,se={},f={},l={},p=new WeakMap,m=[],_=null,v=!1,g=null,x=null,A=null,S=null,P=null,C=null,y=null,T=new Et(0,0,0),U=0,D=!1,L=null,B=null,G=null,F=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:we,disable:$e,bindFramebuffer:ut,drawBuffers:We,useProgram:_t,setBlending:rn,setMaterial:$t,setFlipSided:xn,setCullFace:Gt,setLineWidth:kn,setPolygonOffset:Ct,setScissorTest:Rn,activeTexture:dn,bindTexture:bn,unbindTexture:k,compressedTexImage2D:Re,compressedTexImage3D:Qe,texImage2D:w,texImage3D:q,pixelStorei:ae,getParameter:he,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:Ze,texStorage3D:R,texSubImage2D:ht,texSubImage3D:Me,compressedTexSubImage2D:Wt,compressedTexSubImage3D:He,scissor:_e,viewport:xe,reset:me}}function I2(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new at,h=new WeakMap,d=new Set,f,p=new WeakMap,m=new Set,_=new FinalizationRegistry(R=>m.delete(R)),v=!1;try{v=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,w){return v?new OffscreenCanvas(R,w):Lc("canvas")}function x(R,w,q){let he=1,ae=Ze(R);if((ae.width>q||ae.height>q)&&(he=q/Math.max(ae.width,ae.height)),he<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let _e=Math.floor(he*ae.width),xe=Math.floor(he*ae.height);f===void 0&&(f=g(_e,xe));let te=w?g(_e,xe):f;return te.width=_e,te.height=xe,te.getContext("2d").drawImage(R,0,0,_e,xe),je("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+_e+"x"+xe+")."),te}else return"data"in R&&je("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function A(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function P(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,w,q,he,ae,_e=!1){if(R!==null){if(n[R]!==void 0)return n[R];je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let xe;he&&(xe=e.get("EXT_texture_norm16"),xe||je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=w;if(w===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.R16_EXT),q===n.SHORT&&xe&&(te=xe.R16_SNORM_EXT)),w===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),w===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RG16_EXT),q===n.SHORT&&xe&&(te=xe.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),w===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),w===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),w===n.RGB&&(q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGB16_EXT),q===n.SHORT&&xe&&(te=xe.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),w===n.RGBA){let ie=_e?Rc:Tt.getTransfer(ae);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Ot?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&xe&&(te=xe.RGBA16_EXT),q===n.SHORT&&xe&&(te=xe.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function y(R,w){let q;return R?w===null||w===Mr||w===ca?q=n.DEPTH24_STENCIL8:w===Tr?q=n.DEPTH32F_STENCIL8:w===Al&&(q=n.DEPTH24_STENCIL8,je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Mr||w===ca?q=n.DEPTH_COMPONENT24:w===Tr?q=n.DEPTH_COMPONENT32F:w===Al&&(q=n.DEPTH_COMPONENT16),q}function T(R,w){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==qn&&R.minFilter!==Zn?Math.log2(Math.max(w.width,w.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?w.mipmaps.length:1}function U(R){let w=new WeakRef(R);i.get(R).__ref=w,m.add(w),_.register(R,w,w)}function D(R){let w=i.get(R).__ref;w!==void 0&&(m.delete(w),_.unregister(w))}function L(R){G(R.target)}function B(R){F(R.target)}function G(R){R.removeEventListener("dispose",L),D(R),Y(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&d.delete(R)}function F(R){R.removeEventListener("dispose",B),D(R),le(R)}function H(){for(let R of m){let w=R.deref();w!==void 0&&(w.isRenderTarget===!0?F(w):G(w))}m.clear(),d.clear()}function Y(R){let w=i.get(R);if(w.__webglInit===void 0)return;let q=R.source,he=p.get(q);if(he){let ae=he[w.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&V(R),Object.keys(he).length===0&&p.delete(q)}i.remove(R)}function V(R){let w=i.get(R);n.deleteTexture(w.__webglTexture);let q=R.source,he=p.get(q);delete he[w.__cacheKey],o.memory.textures--}function le(R){let w=i.get(R);w.__depthDisposeCallback&&w.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&G(q),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(w.__webglFramebuffer[ae]))for(let _e=0;_e<w.__webglFramebuffer[ae].length;_e++)n.deleteFramebuffer(w.__webglFramebuffer[ae][_e]);else n.deleteFramebuffer(w.__webglFramebuffer[ae]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[ae])}else{if(Array.isArray(w.__webglFramebuffer))for(let ae=0;ae<w.__webglFramebuffer.length;ae++)n.deleteFramebuffer(w.__webglFramebuffer[ae]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let ae=0;ae<w.__webglColorRenderbuffer.length;ae++)w.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[ae]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let he=R.textures;for(let ae=0,_e=he.length;ae<_e;ae++){let xe=i.get(he[ae]);xe.__webglTexture&&(n.deleteTexture(xe.__webglTexture),o.memory.textures--),i.remove(he[ae])}i.remove(R)}let X=0;function Q(){X=0}function se(){return X}function fe(R){X=R}function de(){let R=X;return R>=r.maxTextures&&je("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),X+=1,R}function ee(R){let w=[];return w.push(R.wrapS),w.push(R.wrapT),w.push(R.wrapR||0),w.push(R.magFilter),w.push(R.minFilter),w.push(R.anisotropy),w.push(R.internalFormat),w.push(R.format),w.push(R.type),w.push(R.generateMipmaps),w.push(R.mipmapsAutoUpdate),w.push(R.premultiplyAlpha),w.push(R.flipY),w.push(R.unpackAlignment),w.push(R.colorSpace),w.join()}function ge(R,w){let q=i.get(R);if(R.isVideoTexture&&Wt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let he=R.image;if(he===null)je("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)je("WebGLRenderer: Texture marked for update but image is incomplete");else{$t(q,R,w);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+w)}function ye(R,w){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){$t(q,R,w);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+w)}function Ce(R,w){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){$t(q,R,w);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+w)}function we(R,w){let q=i.get(R);if(R.version>0&&q.__version!==R.version){xn(q,R,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+w)}let $e={[qh]:n.REPEAT,[jr]:n.CLAMP_TO_EDGE,[Xh]:n.MIRRORED_REPEAT},ut={[qn]:n.NEAREST,[lb]:n.NEAREST_MIPMAP_NEAREST,[$c]:n.NEAREST_MIPMAP_LINEAR,[Zn]:n.LINEAR,[xd]:n.LINEAR_MIPMAP_NEAREST,[Rs]:n.LINEAR_MIPMAP_LINEAR},We={[db]:n.NEVER,[Lg]:n.ALWAYS,[fb]:n.LESS,[Rg]:n.LEQUAL,[pb]:n.EQUAL,[Ig]:n.GEQUAL,[mb]:n.GREATER,[gb]:n.NOTEQUAL};function _t(R,w){if(w.type===Tr&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===Zn||w.magFilter===xd||w.magFilter===$c||w.magFilter===Rs||w.minFilter===Zn||w.minFilter===xd||w.minFilter===$c||w.minFilter===Rs)&&je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,$e[w.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,$e[w.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,$e[w.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,ut[w.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,ut[w.minFilter]),w.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,We[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===qn||w.minFilter!==$c&&w.minFilter!==Rs||w.type===Tr&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,r.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function ft(R,w){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,w.addEventListener("dispose",L),U(w));let he=w.source,ae=p.get(he);ae===void 0&&(ae={},p.set(he,ae));let _e=ee(w);if(_e!==R.__cacheKey){ae[_e]===void 0&&(ae[_e]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[_e].usedTimes++;let xe=ae[R.__cacheKey];xe!==void 0&&(ae[R.__cacheKey].usedTimes--,xe.usedTimes===0&&V(w)),R.__cacheKey=_e,R.__webglTexture=ae[_e].texture}return q}function lt(R,w,q){return Math.floor(Math.floor(R/q)/w)}function rn(R,w,q,he){let _e=R.updateRanges;if(_e.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,q,he,w.data);else{_e.sort((O,oe)=>O.start-oe.start);let xe=0;for(let O=1;O<_e.length;O++){let oe=_e[xe],ne=_e[O],Te=oe.start+oe.count,ve=lt(ne.start,w.width,4),Se=lt(oe.start,w.width,4);ne.start<=Te+1&&ve===Se&&lt(ne.start+ne.count-1,w.width,4)===ve?oe.count=Math.max(oe.count,ne.start+ne.count-oe.start):(++xe,_e[xe]=ne)}_e.length=xe+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let O=0,oe=_e.length;O<oe;O++){let ne=_e[O],Te=Math.floor(ne.start/4),ve=Math.ceil(ne.count/4),Se=Te%w.width,qe=Math.floor(Te/w.width),tt=ve,ue=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,qe),t.texSubImage2D(n.TEXTURE_2D,0,Se,qe,tt,ue,q,he,w.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function $t(R,w,q){let he=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(he=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(he=n.TEXTURE_3D);let ae=ft(R,w),_e=w.source;t.bindTexture(he,R.__webglTexture,n.TEXTURE0+q);let xe=i.get(_e);if(_e.version!==xe.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ue=Tt.getPrimaries(Tt.workingColorSpace),ke=w.colorSpace===Ls?null:Tt.getPrimaries(w.colorSpace),nt=w.colorSpace===Ls||ue===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let ie=x(w.image,!1,r.maxTextureSize);ie=He(w,ie);let me=s.convert(w.format,w.colorSpace),O=s.convert(w.type),oe=C(w.internalFormat,me,O,w.normalized,w.colorSpace,w.isVideoTexture);_t(he,w);let ne,Te=w.mipmaps,ve=w.isVideoTexture!==!0,Se=xe.__version===void 0||ae===!0,qe=_e.dataReady,tt=T(w,ie);if(w.isDepthTexture)oe=y(w.format===Is,w.type),Se&&(ve?t.texStorage2D(n.TEXTURE_2D,1,oe,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,oe,ie.width,ie.height,0,me,O,null));else if(w.isDataTexture)if(Te.length>0){ve&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,oe,Te[0].width,Te[0].height);for(let ue=0,ke=Te.length;ue<ke;ue++)ne=Te[ue],ve?qe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ne.width,ne.height,me,O,ne.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ne.width,ne.height,0,me,O,ne.data);w.generateMipmaps=!1}else ve?(Se&&t.texStorage2D(n.TEXTURE_2D,tt,oe,ie.width,ie.height),qe&&rn(w,ie,me,O)):t.texImage2D(n.TEXTURE_2D,0,oe,ie.width,ie.height,0,me,O,ie.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){ve&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,oe,Te[0].width,Te[0].height,ie.depth);for(let ue=0,ke=Te.length;ue<ke;ue++)if(ne=Te[ue],w.format!==Ar)if(me!==null)if(ve){if(qe)if(w.layerUpdates.size>0){let nt=Vg(ne.width,ne.height,w.format,w.type);for(let Pe of w.layerUpdates){let dt=ne.data.subarray(Pe*nt/ne.data.BYTES_PER_ELEMENT,(Pe+1)*nt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,Pe,ne.width,ne.height,1,me,dt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ne.width,ne.height,ie.depth,me,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ne.width,ne.height,ie.depth,0,ne.data,0,0);else je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ve?qe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ue,0,0,0,ne.width,ne.height,ie.depth,me,O,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ue,oe,ne.width,ne.height,ie.depth,0,me,O,ne.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{ve&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,oe,Te[0].width,Te[0].height);for(let ue=0,ke=Te.length;ue<ke;ue++)ne=Te[ue],w.format!==Ar?me!==null?ve?qe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ue,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ue,oe,ne.width,ne.height,0,ne.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ve?qe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,ne.width,ne.height,me,O,ne.data):t.texImage2D(n.TEXTURE_2D,ue,oe,ne.width,ne.height,0,me,O,ne.data)}else if(w.isDataArrayTexture)if(ve){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,oe,ie.width,ie.height,ie.depth),qe)if(w.layerUpdates.size>0){let ue=Vg(ie.width,ie.height,w.format,w.type);for(let ke of w.layerUpdates){let nt=ie.data.subarray(ke*ue/ie.data.BYTES_PER_ELEMENT,(ke+1)*ue/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,ie.width,ie.height,1,me,O,nt)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,O,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,ie.width,ie.height,ie.depth,0,me,O,ie.data);else if(w.isData3DTexture)ve?(Se&&t.texStorage3D(n.TEXTURE_3D,tt,oe,ie.width,ie.height,ie.depth),qe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,O,ie.data)):t.texImage3D(n.TEXTURE_3D,0,oe,ie.width,ie.height,ie.depth,0,me,O,ie.data);else if(w.isFramebufferTexture){if(Se)if(ve)t.texStorage2D(n.TEXTURE_2D,tt,oe,ie.width,ie.height);else{let ue=ie.width,ke=ie.height;for(let nt=0;nt<tt;nt++)t.texImage2D(n.TEXTURE_2D,nt,oe,ue,ke,0,me,O,null),ue>>=1,ke>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ue=n.canvas;if(ue.hasAttribute("layoutsubtree")||ue.setAttribute("layoutsubtree","true"),ie.parentNode!==ue){ue.appendChild(ie),d.add(w),ue.onpaint=ke=>{let nt=ke.changedElements;for(let Pe of d)nt.includes(Pe.image)&&(Pe.needsUpdate=!0)},ue.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let nt=n.RGBA,Pe=n.RGBA,dt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,nt,Pe,dt,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(ve&&Se){let ue=Ze(Te[0]);t.texStorage2D(n.TEXTURE_2D,tt,oe,ue.width,ue.height)}for(let ue=0,ke=Te.length;ue<ke;ue++)ne=Te[ue],ve?qe&&t.texSubImage2D(n.TEXTURE_2D,ue,0,0,me,O,ne):t.texImage2D(n.TEXTURE_2D,ue,oe,me,O,ne);w.generateMipmaps=!1}else if(ve){if(Se){let ue=Ze(ie);t.texStorage2D(n.TEXTURE_2D,tt,oe,ue.width,ue.height)}qe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,O,ie)}else t.texImage2D(n.TEXTURE_2D,0,oe,me,O,ie);A(w)&&w.mipmapsAutoUpdate===!0&&S(he),xe.__version=_e.version,w.onUpdate&&w.onUpdate(w)}R.__version=w.version}function xn(R,w,q){if(w.image.length!==6)return;let he=ft(R,w),ae=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let _e=i.get(ae);if(ae.version!==_e.__version||he===!0){t.activeTexture(n.TEXTURE0+q);let xe=Tt.getPrimaries(Tt.workingColorSpace),te=w.colorSpace===Ls?null:Tt.getPrimaries(w.colorSpace),ie=w.colorSpace===Ls||xe===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=w.isCompressedTexture||w.image[0].isCompressedTexture,O=w.image[0]&&w.image[0].isDataTexture,oe=[];for(let Pe=0;Pe<6;Pe++)!me&&!O?oe[Pe]=x(w.image[Pe],!0,r.maxCubemapSize):oe[Pe]=O?w.image[Pe].image:w.image[Pe],oe[Pe]=He(w,oe[Pe]);let ne=oe[0],Te=s.convert(w.format,w.colorSpace),ve=s.convert(w.type),Se=C(w.internalFormat,Te,ve,w.normalized,w.colorSpace),qe=w.isVideoTexture!==!0,tt=_e.__version===void 0||he===!0,ue=ae.dataReady,ke=T(w,ne);_t(n.TEXTURE_CUBE_MAP,w);let nt;if(w.isDepthTexture){if(Se=y(w.format===Is,w.type),tt)if(qe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,ne.width,ne.height,0,Te,ve,null)}else if(me){qe&&tt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,ne.width,ne.height);for(let Pe=0;Pe<6;Pe++){nt=oe[Pe].mipmaps;for(let dt=0;dt<nt.length;dt++){let Zt=nt[dt];w.format!==Ar?Te!==null?qe?ue&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,0,0,Zt.width,Zt.height,Te,Zt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,Se,Zt.width,Zt.height,0,Zt.data):je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):qe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,0,0,Zt.width,Zt.height,Te,ve,Zt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt,Se,Zt.width,Zt.height,0,Te,ve,Zt.data)}}}else{if(nt=w.mipmaps,qe&&tt){nt.length>0&&ke++;let Pe=Ze(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,Se,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(O){qe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,oe[Pe].width,oe[Pe].height,Te,ve,oe[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,oe[Pe].width,oe[Pe].height,0,Te,ve,oe[Pe].data);for(let dt=0;dt<nt.length;dt++){let si=nt[dt].image[Pe].image;qe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,0,0,si.width,si.height,Te,ve,si.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,Se,si.width,si.height,0,Te,ve,si.data)}}else{qe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,ve,oe[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Se,Te,ve,oe[Pe]);for(let dt=0;dt<nt.length;dt++){let Zt=nt[dt];qe?ue&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,0,0,Te,ve,Zt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,dt+1,Se,Te,ve,Zt.image[Pe])}}}A(w)&&w.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),_e.__version=ae.version,w.onUpdate&&w.onUpdate(w)}R.__version=w.version}function Gt(R,w,q,he,ae,_e){let xe=s.convert(q.format,q.colorSpace),te=s.convert(q.type),ie=C(q.internalFormat,xe,te,q.normalized,q.colorSpace),me=i.get(w),O=i.get(q);if(O.__renderTarget=w,!me.__hasExternalTextures){let oe=Math.max(1,w.width>>_e),ne=Math.max(1,w.height>>_e);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,_e,ie,oe,ne,w.depth,0,xe,te,null):t.texImage2D(ae,_e,ie,oe,ne,0,xe,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,he,ae,O.__webglTexture,0,ht(w)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,he,ae,O.__webglTexture,_e),t.bindFramebuffer(n.FRAMEBUFFER,null)}function kn(R,w,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),w.depthBuffer){let he=w.depthTexture,ae=he&&he.isDepthTexture?he.type:null,_e=y(w.stencilBuffer,ae),xe=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(w),_e,w.width,w.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(w),_e,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,_e,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,xe,n.RENDERBUFFER,R)}else{let he=w.textures;for(let ae=0;ae<he.length;ae++){let _e=he[ae],xe=s.convert(_e.format,_e.colorSpace),te=s.convert(_e.type),ie=C(_e.internalFormat,xe,te,_e.normalized,_e.colorSpace);Me(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ht(w),ie,w.width,w.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ht(w),ie,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ie,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ct(R,w,q){let he=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(w.depthTexture);ae.__renderTarget=w;let _e=he?w.depthTexture.image[0]:w.depthTexture.image;(!ae.__webglTexture||_e.width!==w.width||_e.height!==w.height)&&(_e.width=w.width,_e.height=w.height,w.depthTexture.needsUpdate=!0),he?we(w.depthTexture,0):ge(w.depthTexture,0);let xe=ae.__webglTexture,te=ht(w),ie=he?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,me=w.depthTexture.format===Is?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===As)Me(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,xe,0);else if(w.depthTexture.format===Is)Me(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,xe,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,xe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Rn(R){let w=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==R.depthTexture){let he=R.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),he){let ae=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,he.removeEventListener("dispose",ae)};he.addEventListener("dispose",ae),w.__depthDisposeCallback=ae}w.__boundDepthTexture=he}if(R.depthTexture&&!w.__autoAllocateDepthBuffer)if(q)for(let he=0;he<6;he++)Ct(w.__webglFramebuffer[he],R,he);else R.texture.mipmaps.length>0?Ct(w.__webglFramebuffer[0],R,0):Ct(w.__webglFramebuffer,R,0);else if(q){w.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[he]),w.__webglDepthbuffer[he]===void 0)w.__webglDepthbuffer[he]=n.createRenderbuffer(),kn(w.__webglDepthbuffer[he],R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=w.__webglDepthbuffer[he];n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),kn(w.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,_e=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,_e),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,_e)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function dn(R,w,q){let he=i.get(R);w!==void 0&&Gt(he.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Rn(R)}function bn(R){let w=R.texture,q=i.get(R),he=i.get(w);R.addEventListener("dispose",B),U(R);let ae=R.textures,_e=R.isWebGLCubeRenderTarget===!0,xe=ae.length>1;if(xe||(he.__webglTexture===void 0&&(he.__webglTexture=n.createTexture()),he.__version=w.version,o.memory.textures++),_e){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(w.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<w.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(w.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<w.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(xe)for(let te=0,ie=ae.length;te<ie;te++){let me=i.get(ae[te]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let ie=ae[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=s.convert(ie.format,ie.colorSpace),O=s.convert(ie.type),oe=C(ie.internalFormat,me,O,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=ht(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,oe,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),kn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(_e){t.bindTexture(n.TEXTURE_CUBE_MAP,he.__webglTexture),_t(n.TEXTURE_CUBE_MAP,w);for(let te=0;te<6;te++)if(w.mipmaps.length>0)for(let ie=0;ie<w.mipmaps.length;ie++)Gt(q.__webglFramebuffer[te][ie],R,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Gt(q.__webglFramebuffer[te],R,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(w)?S(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(xe){for(let te=0,ie=ae.length;te<ie;te++){let me=ae[te],O=i.get(me),oe=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(oe=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,O.__webglTexture),_t(oe,me),Gt(q.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+te,oe,0),A(me)&&S(oe)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,he.__webglTexture),_t(te,w),w.mipmaps.length>0)for(let ie=0;ie<w.mipmaps.length;ie++)Gt(q.__webglFramebuffer[ie],R,w,n.COLOR_ATTACHMENT0,te,ie);else Gt(q.__webglFramebuffer,R,w,n.COLOR_ATTACHMENT0,te,0);A(w)?S(te):w.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Rn(R)}function k(R){let w=R.textures;for(let q=0,he=w.length;q<he;q++){let ae=w[q];if(A(ae)&&ae.mipmapsAutoUpdate===!0){let _e=P(R),xe=i.get(ae).__webglTexture;t.bindTexture(_e,xe),S(_e),t.unbindTexture()}}}let Re=[];function Qe(R){if(R.samples>0){if(Me(R)===!1){let w=R.textures,q=R.width,he=R.height,ae=n.COLOR_BUFFER_BIT,_e=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=i.get(R),te=w.length>1;if(te)for(let me=0;me<w.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,xe.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglFramebuffer);for(let me=0;me<w.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,xe.__webglColorRenderbuffer[me]);let O=i.get(w[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,q,he,0,0,q,he,ae,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(_e),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<w.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,xe.__webglColorRenderbuffer[me]);let O=i.get(w[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,xe.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,xe.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let w=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function ht(R){return Math.min(r.maxSamples,R.samples)}function Me(R){let w=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Wt(R){let w=o.render.frame;h.get(R)!==w&&(h.set(R,w),R.update())}function He(R,w){let q=R.colorSpace,he=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==Pc&&q!==Ls&&(Tt.getTransfer(q)===Ot?(he!==Ar||ae!==Xi)&&je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):st("WebGLTextures: Unsupported texture color space:",q)),w}function Ze(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=Q,this.getTextureUnits=se,this.setTextureUnits=fe,this.setTexture2D=ge,this.setTexture2DArray=ye,this.setTexture3D=Ce,this.setTextureCube=we,this.rebindTextures=dn,this.setupRenderTarget=bn,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=Qe,this.setupDepthRenderbuffer=Rn,this.setupFrameBufferTexture=Gt,this.useMultisampledRTT=Me,this.dispose=H}function L2(n,e){function t(i,r=Ls){let s,o=Tt.getTransfer(r);if(i===Xi)return n.UNSIGNED_BYTE;if(i===Sd)return n.UNSIGNED_SHORT_4_4_4_4;if(i===wd)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Mg)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Tg)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Sg)return n.BYTE;if(i===wg)return n.SHORT;if(i===Al)return n.UNSIGNED_SHORT;if(i===bd)return n.INT;if(i===Mr)return n.UNSIGNED_INT;if(i===Tr)return n.FLOAT;if(i===Er)return n.HALF_FLOAT;if(i===Eg)return n.ALPHA;if(i===Ag)return n.RGB;if(i===Ar)return n.RGBA;if(i===As)return n.DEPTH_COMPONENT;if(i===Is)return n.DEPTH_STENCIL;if(i===Cg)return n.RED;if(i===Md)return n.RED_INTEGER;if(i===yo)return n.RG;if(i===Td)return n.RG_INTEGER;if(i===Ed)return n.RGBA_INTEGER;if(i===Yc||i===Kc||i===Zc||i===Jc)if(o===Ot)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Yc)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Kc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Zc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Jc)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Yc)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Kc)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Zc)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Jc)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ad||i===Cd||i===Pd||i===Rd)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===Ad)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Cd)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Pd)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===Rd)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Id||i===Ld||i===Dd||i===Nd||i===Fd||i===jc||i===Ud)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Id||i===Ld)return o===Ot?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Dd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===Nd)return s.COMPRESSED_R11_EAC;if(i===Fd)return s.COMPRESSED_SIGNED_R11_EAC;if(i===jc)return s.COMPRESSED_RG11_EAC;if(i===Ud)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Od||i===kd||i===Bd||i===zd||i===Gd||i===Vd||i===Hd||i===Wd||i===qd||i===Xd||i===$d||i===Yd||i===Kd||i===Zd)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===Od)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===kd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Bd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===zd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Gd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Vd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Hd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Wd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===qd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Xd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===$d)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Yd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Kd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Zd)return o===Ot?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Jd||i===jd||i===Qd)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===Jd)return o===Ot?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===jd)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Qd)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===ef||i===tf||i===Qc||i===nf)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===ef)return s.COMPRESSED_RED_RGTC1_EXT;if(i===tf)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Qc)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===nf)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ca?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var D2=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,N2=`
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

}`,Jg=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Gc(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Wi({vertexShader:D2,fragmentShader:N2,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new sr(new Vc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},jg=class extends wr{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,f=null,p=null,m=null,_=typeof XRWebGLBinding<"u",v=new Jg,g={},x=t.getContextAttributes(),A=null,S=null,P=[],C=[],y=new at,T=null,U=null,D=new di;D.viewport=new un;let L=new di;L.viewport=new un;let B=[D,L],G=new vd,F=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=P[ee];return ge===void 0&&(ge=new _l,P[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=P[ee];return ge===void 0&&(ge=new _l,P[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=P[ee];return ge===void 0&&(ge=new _l,P[ee]=ge),ge.getHandSpace()};function Y(ee){let ge=C.indexOf(ee.inputSource);if(ge===-1)return;let ye=P[ge];ye!==void 0&&(ye.update(ee.inputSource,ee.frame,c||o),ye.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){r.removeEventListener("select",Y),r.removeEventListener("selectstart",Y),r.removeEventListener("selectend",Y),r.removeEventListener("squeeze",Y),r.removeEventListener("squeezestart",Y),r.removeEventListener("squeezeend",Y),r.removeEventListener("end",V),r.removeEventListener("inputsourceschange",le);for(let ee=0;ee<P.length;ee++){let ge=C[ee];ge!==null&&(C[ee]=null,P[ee].disconnect(ge))}F=null,H=null,v.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(A),p=null,f=null,d=null,r=null,S=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(y.width,y.height,!1),U!==null){let ee=U.camera;ee.fov=U.fov,ee.zoom=U.zoom,ee.updateProjectionMatrix(),U=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){s=ee,i.isPresenting===!0&&je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(r,t)),d},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(ee){if(r=ee,r!==null){if(A=e.getRenderTarget(),r.addEventListener("select",Y),r.addEventListener("selectstart",Y),r.addEventListener("selectend",Y),r.addEventListener("squeeze",Y),r.addEventListener("squeezestart",Y),r.addEventListener("squeezeend",Y),r.addEventListener("end",V),r.addEventListener("inputsourceschange",le),x.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(y),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let ye=null,Ce=null,we=null;x.depth&&(we=x.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ye=x.stencil?Is:As,Ce=x.stencil?ca:Mr);let $e={colorFormat:t.RGBA8,depthFormat:we,scaleFactor:s};d=this.getBinding(),f=d.createProjectionLayer($e),r.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),S=new Vi(f.textureWidth,f.textureHeight,{format:Ar,type:Xi,depthTexture:new Ps(f.textureWidth,f.textureHeight,Ce,void 0,void 0,void 0,void 0,void 0,void 0,ye),stencilBuffer:x.stencil,colorSpace:e.outputColorSpace,samples:x.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let ye={antialias:x.antialias,alpha:!0,depth:x.depth,stencil:x.stencil,framebufferScaleFactor:s};p=new XRWebGLLayer(r,t,ye),r.updateRenderState({baseLayer:p}),e.setPixelRatio(1),e.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new Vi(p.framebufferWidth,p.framebufferHeight,{format:Ar,type:Xi,colorSpace:e.outputColorSpace,stencilBuffer:x.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),de.setContext(r),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return v.getDepthTexture()};function le(ee){for(let ge=0;ge<ee.removed.length;ge++){let ye=ee.removed[ge],Ce=C.indexOf(ye);Ce>=0&&(C[Ce]=null,P[Ce].disconnect(ye))}for(let ge=0;ge<ee.added.length;ge++){let ye=ee.added[ge],Ce=C.indexOf(ye);if(Ce===-1){for(let $e=0;$e<P.length;$e++)if($e>=C.length){C.push(ye),Ce=$e;break}else if(C[$e]===null){C[$e]=ye,Ce=$e;break}if(Ce===-1)break}let we=P[Ce];we&&we.connect(ye)}}function X(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(r===null)return;let ge=ee.near,ye=ee.far;v.texture!==null&&(v.depthNear>0&&(ge=v.depthNear),v.depthFar>0&&(ye=v.depthFar)),G.near=L.near=D.near=ge,G.far=L.far=D.far=ye,(F!==G.near||H!==G.far)&&(r.updateRenderState({depthNear:G.near,depthFar:G.far}),F=G.near,H=G.far),G.layers.mask=ee.layers.mask|6,D.layers.mask=G.layers.mask&-5,L.layers.mask=G.layers.mask&-3;let Ce=ee.parent,we=G.cameras;X(G,Ce);for(let $e=0;$e<we.length;$e++)X(we[$e],Ce);G.projectionMatrix.copy(D.projectionMatrix),G.projectionMatrixInverse.copy(D.projectionMatrixInverse),U===null&&ee.isPerspectiveCamera&&(U={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,G,Ce)};function Q(ee,ge,ye){ye===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(ye.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=gl*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(ee){l=ee,f!==null&&(f.fixedFoveation=ee),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=ee)},this.hasDepthSensing=function(){return v.texture!==null},this.getDepthSensingMesh=function(){return v.getMesh(G)},this.getCameraTexture=function(ee){return g[ee]};let se=null;function fe(ee,ge){if(h=ge.getViewerPose(c||o),m=ge,h!==null){let ye=h.views;p!==null&&(e.setRenderTargetFramebuffer(S,p.framebuffer),e.setRenderTarget(S));let Ce=!1;ye.length!==G.cameras.length&&(G.cameras.length=0,Ce=!0);for(let We=0;We<ye.length;We++){let _t=ye[We],ft=null;if(p!==null)ft=p.getViewport(_t);else{let rn=d.getViewSubImage(f,_t);ft=rn.viewport,We===0&&(e.setRenderTargetTextures(S,rn.colorTexture,rn.depthStencilTexture),e.setRenderTarget(S))}let lt=B[We];lt===void 0&&(lt=new di,lt.layers.enable(We),lt.viewport=new un,B[We]=lt),lt.matrix.fromArray(_t.transform.matrix),lt.matrix.decompose(lt.position,lt.quaternion,lt.scale),lt.projectionMatrix.fromArray(_t.projectionMatrix),lt.projectionMatrixInverse.copy(lt.projectionMatrix).invert(),lt.viewport.set(ft.x,ft.y,ft.width,ft.height),We===0&&(G.matrix.copy(lt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Ce===!0&&G.cameras.push(lt)}let we=r.enabledFeatures;if(we&&we.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&_){d=i.getBinding();let We=d.getDepthInformation(ye[0]);We&&We.isValid&&We.texture&&v.init(We,r.renderState)}if(we&&we.includes("camera-access")&&_){e.state.unbindTexture(),d=i.getBinding();for(let We=0;We<ye.length;We++){let _t=ye[We].camera;if(_t){let ft=g[_t];ft||(ft=new Gc,g[_t]=ft);let lt=d.getCameraImage(_t);ft.sourceTexture=lt}}}}for(let ye=0;ye<P.length;ye++){let Ce=C[ye],we=P[ye];Ce!==null&&we!==void 0&&we.update(Ce,ge,c||o)}se&&se(ee,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),m=null}let de=new Kb;de.setAnimationLoop(fe),this.setAnimationLoop=function(ee){se=ee},this.dispose=function(){}}},F2=new cn,sS=new it;sS.set(-1,0,0,0,1,0,0,0,1);function U2(n,e){function t(v,g){v.matrixAutoUpdate===!0&&v.updateMatrix(),g.value.copy(v.matrix)}function i(v,g){g.color.getRGB(v.fogColor.value,Bg(n)),g.isFog?(v.fogNear.value=g.near,v.fogFar.value=g.far):g.isFogExp2&&(v.fogDensity.value=g.density)}function r(v,g,x,A,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?s(v,g):g.isMeshLambertMaterial?(s(v,g),g.envMap&&(v.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(s(v,g),d(v,g)):g.isMeshPhongMaterial?(s(v,g),h(v,g),g.envMap&&(v.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(s(v,g),f(v,g),g.isMeshPhysicalMaterial&&p(v,g,S)):g.isMeshMatcapMaterial?(s(v,g),m(v,g)):g.isMeshDepthMaterial?s(v,g):g.isMeshDistanceMaterial?(s(v,g),_(v,g)):g.isMeshNormalMaterial?s(v,g):g.isLineBasicMaterial?(o(v,g),g.isLineDashedMaterial&&a(v,g)):g.isPointsMaterial?l(v,g,x,A):g.isSpriteMaterial?c(v,g):g.isShadowMaterial?(v.color.value.copy(g.color),v.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function s(v,g){v.opacity.value=g.opacity,g.color&&v.diffuse.value.copy(g.color),g.emissive&&v.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(v.map.value=g.map,t(g.map,v.mapTransform)),g.alphaMap&&(v.alphaMap.value=g.alphaMap,t(g.alphaMap,v.alphaMapTransform)),g.bumpMap&&(v.bumpMap.value=g.bumpMap,t(g.bumpMap,v.bumpMapTransform),v.bumpScale.value=g.bumpScale,g.side===pi&&(v.bumpScale.value*=-1)),g.normalMap&&(v.normalMap.value=g.normalMap,t(g.normalMap,v.normalMapTransform),v.normalScale.value.copy(g.normalScale),g.side===pi&&v.normalScale.value.negate()),g.displacementMap&&(v.displacementMap.value=g.displacementMap,t(g.displacementMap,v.displacementMapTransform),v.displacementScale.value=g.displacementScale,v.displacementBias.value=g.displacementBias),g.emissiveMap&&(v.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,v.emissiveMapTransform)),g.specularMap&&(v.specularMap.value=g.specularMap,t(g.specularMap,v.specularMapTransform)),g.alphaTest>0&&(v.alphaTest.value=g.alphaTest);let x=e.get(g),A=x.envMap,S=x.envMapRotation;A&&(v.envMap.value=A,v.envMapRotation.value.setFromMatrix4(F2.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&v.envMapRotation.value.premultiply(sS),v.reflectivity.value=g.reflectivity,v.ior.value=g.ior,v.refractionRatio.value=g.refractionRatio),g.lightMap&&(v.lightMap.value=g.lightMap,v.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,v.lightMapTransform)),g.aoMap&&(v.aoMap.value=g.aoMap,v.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,v.aoMapTransform))}function o(v,g){v.diffuse.value.copy(g.color),v.opacity.value=g.opacity,g.map&&(v.map.value=g.map,t(g.map,v.mapTransform))}function a(v,g){v.dashSize.value=g.dashSize,v.totalSize.value=g.dashSize+g.gapSize,v.scale.value=g.scale}function l(v,g,x,A){v.diffuse.value.copy(g.color),v.opacity.value=g.opacity,v.size.value=g.size*x,v.scale.value=A*.5,g.map&&(v.map.value=g.map,t(g.map,v.uvTransform)),g.alphaMap&&(v.alphaMap.value=g.alphaMap,t(g.alphaMap,v.alphaMapTransform)),g.alphaTest>0&&(v.alphaTest.value=g.alphaTest)}function c(v,g){v.diffuse.value.copy(g.color),v.opacity.value=g.opacity,v.rotation.value=g.rotation,g.map&&(v.map.value=g.map,t(g.map,v.mapTransform)),g.alphaMap&&(v.alphaMap.value=g.alphaMap,t(g.alphaMap,v.alphaMapTransform)),g.alphaTest>0&&(v.alphaTest.value=g.alphaTest)}function h(v,g){v.specular.value.copy(g.specular),v.shininess.value=Math.max(g.shininess,1e-4)}function d(v,g){g.gradientMap&&(v.gradientMap.value=g.gradientMap)}function f(v,g){v.metalness.value=g.metalness,g.metalnessMap&&(v.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,v.metalnessMapTransform)),v.roughness.value=g.roughness,g.roughnessMap&&(v.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,v.roughnessMapTransform)),g.envMap&&(v.envMapIntensity.value=g.envMapIntensity)}function p(v,g,x){v.ior.value=g.ior,g.diffuseRoughness>0&&(v.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(v.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,v.diffuseRoughnessMapTransform))),g.sheen>0&&(v.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),v.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(v.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,v.sheenColorMapTransform)),g.sheenRoughnessMap&&(v.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,v.sheenRoughnessMapTransform))),g.clearcoat>0&&(v.clearcoat.value=g.clearcoat,v.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(v.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,v.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(v.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,v.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(v.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,v.clearcoatNormalMapTransform),v.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===pi&&v.clearcoatNormalScale.value.negate())),g.dispersion>0&&(v.dispersion.value=g.dispersion),g.retroreflectivity>0&&(v.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(v.iridescence.value=g.iridescence,v.iridescenceIOR.value=g.iridescenceIOR,v.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,v.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(v.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,v.iridescenceMapTransform)),g.iridescenceThicknessMap&&(v.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,v.iridescenceThicknessMapTransform))),g.transmission>0&&(v.transmission.value=g.transmission,v.transmissionSamplerMap.value=x.texture,v.transmissionSamplerSize.value.set(x.width,x.height),g.transmissionMap&&(v.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,v.transmissionMapTransform)),v.thickness.value=g.thickness,g.thicknessMap&&(v.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,v.thicknessMapTransform)),v.attenuationDistance.value=g.attenuationDistance,v.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(v.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(v.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,v.anisotropyMapTransform))),v.specularIntensity.value=g.specularIntensity,v.specularColor.value.copy(g.specularColor),g.specularColorMap&&(v.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,v.specularColorMapTransform)),g.specularIntensityMap&&(v.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,v.specularIntensityMapTransform))}function m(v,g){g.matcap&&(v.matcap.value=g.matcap)}function _(v,g){let x=e.get(g).light;v.referencePosition.value.setFromMatrixPosition(x.matrixWorld),v.nearDistance.value=x.shadow.camera.near,v.farDistance.value=x.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function O2(n,e,t,i){let r={},s={};function o(x,A){let S=A.program;i.uniformBlockBinding(x,S,r[x.id])}function a(x,A){let S=r[x.id];S===void 0&&(m(x),S=l(x),r[x.id]=S,x.addEventListener("dispose",v));let P=A.program;i.updateUBOMapping(x,P);let C=e.render.frame;s[x.id]!==C&&(c(x),s[x.id]=C)}function l(x){let A=n.createBuffer(),S=x.__size,P=x.usage;return n.bindBuffer(n.UNIFORM_BUFFER,A),n.bufferData(n.UNIFORM_BUFFER,S,P),n.bindBuffer(n.UNIFORM_BUFFER,null),A}function c(x){let A=r[x.id],S=x.uniforms,P=x.__cache;n.bindBuffer(n.UNIFORM_BUFFER,A);for(let C=0,y=S.length;C<y;C++){let T=S[C];if(Array.isArray(T))for(let U=0,D=T.length;U<D;U++)h(T[U],C,U,P);else h(T,C,0,P)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(x,A,S,P){if(f(x,A,S,P)===!0){let C=x.__offset,y=x.value;if(Array.isArray(y)){let T=0;for(let U=0;U<y.length;U++){let D=y[U],L=_(D,!0);d(D,x.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,x.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,x.__data)}}function d(x,A,S){typeof x=="number"||typeof x=="boolean"?A[S]=x:x.isMatrix3?(A[S]=x.elements[0],A[S+1]=x.elements[1],A[S+2]=x.elements[2],A[S+3]=0,A[S+4]=x.elements[3],A[S+5]=x.elements[4],A[S+6]=x.elements[5],A[S+7]=0,A[S+8]=x.elements[6],A[S+9]=x.elements[7],A[S+10]=x.elements[8],A[S+11]=0):ArrayBuffer.isView(x)?A.set(x.subarray(0,A.length-S),S):x.toArray(A,S)}function f(x,A,S,P){let C=x.value,y=A+"_"+S;if(Array.isArray(C)){P[y]===void 0&&(P[y]=[]);let T=P[y],U=!1;for(let D=0;D<C.length;D++)p(C[D],T,D)===!0&&(U=!0);return U}return p(C,P,y)}function p(x,A,S){if(A[S]===void 0)return typeof x=="number"||typeof x=="boolean"?A[S]=x:ArrayBuffer.isView(x)?A[S]=x.slice():A[S]=x.clone(),!0;{let P=A[S];if(typeof x=="number"||typeof x=="boolean"){if(P!==x)return A[S]=x,!0}else{if(ArrayBuffer.isView(x))return!0;if(P.equals(x)===!1)return P.copy(x),!0}}return!1}function m(x){let A=x.uniforms,S=0,P=16;for(let y=0,T=A.length;y<T;y++){let U=Array.isArray(A[y])?A[y]:[A[y]];for(let D=0,L=U.length;D<L;D++){let B=U[D],G=Array.isArray(B.value)?B.value:[B.value],F=Array.isArray(A[y])||Array.isArray(B.value),H=S;for(let V=0,le=G.length;V<le;V++){let X=G[V],Q=_(X,F),se=S%P,fe=se%Q.boundary,de=se+fe;S+=fe,de!==0&&P-de<Q.storage&&(S+=P-de),V===0&&(H=S),S+=Q.storage}let Y=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new Y((S-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}let C=S%P;return C>0&&(S+=P-C),x.__size=S,x.__cache={},this}function _(x,A){let S={boundary:0,storage:0};return typeof x=="number"||typeof x=="boolean"?(S.boundary=4,S.storage=4):x.isVector2?(S.boundary=8,S.storage=8):x.isVector3||x.isColor?(S.boundary=16,S.storage=12):x.isVector4?(S.boundary=16,S.storage=16):x.isMatrix3?(S.boundary=16,S.storage=48):x.isMatrix4?(S.boundary=16,S.storage=64):x.isTexture?je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(x)?(S.boundary=16,S.storage=x.byteLength):je("WebGLRenderer: Unsupported uniform value type.",x),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function v(x){let A=x.target;A.removeEventListener("dispose",v),n.deleteBuffer(r[A.id]),delete r[A.id],delete s[A.id]}function g(){for(let x in r)n.deleteBuffer(r[x]);r={},s={}}return{bind:o,update:a,dispose:g}}var k2=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ns=null;function B2(){return ns===null&&(ns=new ra(k2,16,16,yo,Er),ns.name="DFG_LUT",ns.minFilter=Zn,ns.magFilter=Zn,ns.wrapS=jr,ns.wrapT=jr,ns.generateMipmaps=!1,ns.needsUpdate=!0),ns}var af=class{constructor(e={}){let{canvas:t=_b(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:f=!1,outputBufferType:p=Xi}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let _=p,v=new Set([Ed,Td,Md]),g=new Set([Xi,Mr,Al,ca,Sd,wd]),x=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,C=null,y=[],T=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ts,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,B=null,G=null,F=null,H=null;this._outputColorSpace=Bi;let Y=0,V=0,le=null,X=-1,Q=null,se=new un,fe=new un,de=null,ee=new Et(0),ge=0,ye=t.width,Ce=t.height,we=1,$e=null,ut=null,We=new un(0,0,ye,Ce),_t=new un(0,0,ye,Ce),ft=!1,lt=new sa,rn=new jh,$t=!1,xn=!1,Gt=new cn,kn=new Z,Ct=new un,Rn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},dn=!1;function bn(){return le===null?we:1}let k=i;function Re(E,z){return t.getContext(E,z)}let Qe,ht,Me,Wt,He,Ze,R,w,q,he,ae,_e,xe,te,ie,me,O,oe,ne,Te,ve,Se,qe;try{let E={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),k===null){let z="webgl2";if(k=Re(z,E),k===null)throw Re(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(E){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),st("WebGLRenderer: "+E.message),E}function tt(){Qe=new ZI(k),Qe.init(),ve=new L2(k,Qe),ht=new BI(k,Qe,e,ve),Me=new R2(k,Qe),ht.reversedDepthBuffer&&f&&Me.buffers.depth.setReversed(!0),G=k.createFramebuffer(),F=k.createFramebuffer(),H=k.createFramebuffer(),Wt=new QI(k),He=new g2,Ze=new I2(k,Qe,Me,He,ht,ve,Wt),R=new KI(D),w=new tP(k),Se=new OI(k,w),q=new JI(k,w,Wt,Se),he=new tL(k,q,w,Se,Wt),oe=new eL(k,ht,Ze),ie=new zI(He),ae=new m2(D,R,Qe,ht,Se,ie),_e=new U2(D,He),xe=new _2,te=new M2(Qe),O=new UI(D,R,Me,he,m,l),me=new P2(D,he,ht),qe=new O2(k,Wt,ht,Me),ne=new kI(k,Qe,Wt),Te=new jI(k,Qe,Wt),Wt.programs=ae.programs,D.capabilities=ht,D.extensions=Qe,D.properties=He,D.renderLists=xe,D.shadowMap=me,D.state=Me,D.info=Wt}_!==Xi&&(U=new iL(_,t.width,t.height,a,r,s));let ue=new jg(D,k);this.xr=ue,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let E=Qe.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=Qe.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return we},this.setPixelRatio=function(E){E!==void 0&&(we=E,this.setSize(ye,Ce,!1))},this.getSize=function(E){return E.set(ye,Ce)},this.setSize=function(E,z,j=!0){if(ue.isPresenting){je("WebGLRenderer: Can't change size while VR device is presenting.");return}ye=E,Ce=z,t.width=Math.floor(E*we),t.height=Math.floor(z*we),j===!0&&(t.style.width=E+"px",t.style.height=z+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,E,z)},this.getDrawingBufferSize=function(E){return E.set(ye*we,Ce*we).floor()},this.setDrawingBufferSize=function(E,z,j){ye=E,Ce=z,we=j,t.width=Math.floor(E*j),t.height=Math.floor(z*j),this.setViewport(0,0,E,z)},this.setEffects=function(E){if(_===Xi){st("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let z=0;z<E.length;z++)if(E[z].isOutputPass===!0){je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(se)},this.getViewport=function(E){return E.copy(We)},this.setViewport=function(E,z,j,$){E.isVector4?We.set(E.x,E.y,E.z,E.w):We.set(E,z,j,$),Me.viewport(se.copy(We).multiplyScalar(bn()).round())},this.getScissor=function(E){return E.copy(_t)},this.setScissor=function(E,z,j,$){E.isVector4?_t.set(E.x,E.y,E.z,E.w):_t.set(E,z,j,$),Me.scissor(fe.copy(_t).multiplyScalar(bn()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(E){Me.setScissorTest(ft=E)},this.setOpaqueSort=function(E){$e=E},this.setTransparentSort=function(E){ut=E},this.getClearColor=function(E){return E.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(E=!0,z=!0,j=!0){let $=0;if(E){let K=!1;if(le!==null){let Ee=le.texture.format;K=v.has(Ee)}if(K){let Ee=le.texture.type,Ie=g.has(Ee),Ae=O.getClearColor(),Le=O.getClearAlpha(),ze=Ae.r,rt=Ae.g,yt=Ae.b;Ie?(x[0]=ze,x[1]=rt,x[2]=yt,x[3]=Le,k.clearBufferuiv(k.COLOR,0,x)):(A[0]=ze,A[1]=rt,A[2]=yt,A[3]=Le,k.clearBufferiv(k.COLOR,0,A))}else $|=k.COLOR_BUFFER_BIT}z&&($|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&k.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),B=E},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),O.dispose(),xe.dispose(),te.dispose(),Ze.dispose(),He.dispose(),R.dispose(),he.dispose(),q.dispose(),Se.dispose(),qe.dispose(),ae.dispose(),ue.dispose(),ue.removeEventListener("sessionstart",Su),ue.removeEventListener("sessionend",Nr),hs.stop()};function ke(E){E.preventDefault(),Ng("WebGLRenderer: Context Lost."),L=!0}function nt(){Ng("WebGLRenderer: Context Restored."),L=!1;let E=Wt.autoReset,z=me.enabled,j=me.autoUpdate,$=me.needsUpdate,K=me.type;tt(),Wt.autoReset=E,me.enabled=z,me.autoUpdate=j,me.needsUpdate=$,me.type=K}function Pe(E){st("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function dt(E){let z=E.target;z.removeEventListener("dispose",dt),Zt(z)}function Zt(E){si(E),He.remove(E)}function si(E){let z=He.get(E).programs;z!==void 0&&(z.forEach(function(j){ae.releaseProgram(j)}),E.isShaderMaterial&&ae.releaseShaderCache(E))}this.renderBufferDirect=function(E,z,j,$,K,Ee){z===null&&(z=Rn);let Ie=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ae=Kl(E,z,j,$,K);Me.setMaterial($,Ie);let Le=j.index,ze=1;if($.wireframe===!0){if(Le=q.getWireframeAttribute(j),Le===void 0)return;ze=2}let rt=j.drawRange,yt=j.attributes.position,Be=rt.start*ze,xt=(rt.start+rt.count)*ze;Ee!==null&&(Be=Math.max(Be,Ee.start*ze),xt=Math.min(xt,(Ee.start+Ee.count)*ze)),Le!==null?(Be=Math.max(Be,0),xt=Math.min(xt,Le.count)):yt!=null&&(Be=Math.max(Be,0),xt=Math.min(xt,yt.count));let ln=xt-Be;if(ln<0||ln===1/0)return;Se.setup(K,$,Ae,j,Le);let kt,Bt=ne;if(Le!==null&&(kt=w.get(Le),Bt=Te,Bt.setIndex(kt)),K.isMesh)$.wireframe===!0?(Me.setLineWidth($.wireframeLinewidth*bn()),Bt.setMode(k.LINES)):Bt.setMode(k.TRIANGLES);else if(K.isLine){let In=$.linewidth;In===void 0&&(In=1),Me.setLineWidth(In*bn()),K.isLineSegments?Bt.setMode(k.LINES):K.isLineLoop?Bt.setMode(k.LINE_LOOP):Bt.setMode(k.LINE_STRIP)}else K.isPoints?Bt.setMode(k.POINTS):K.isSprite&&Bt.setMode(k.TRIANGLES);if(K.isBatchedMesh)if(Qe.get("WEBGL_multi_draw"))Bt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let In=K._multiDrawStarts,Ue=K._multiDrawCounts,Sn=K._multiDrawCount,wt=Le?w.get(Le).bytesPerElement:1,fs=He.get($).currentProgram.getUniforms();for(let wn=0;wn<Sn;wn++)fs.setValue(k,"_gl_DrawID",wn),Bt.render(In[wn]/wt,Ue[wn])}else if(K.isInstancedMesh)Bt.renderInstances(Be,ln,K.count);else if(j.isInstancedBufferGeometry){let In=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,In);Bt.renderInstances(Be,ln,Ue)}else Bt.render(Be,ln)};function Xl(E,z,j,$){B!==null&&E.isNodeMaterial&&B.setObject($,E),$t===!0&&ie.setState(E,j,!1),E.transparent===!0&&E.side===or&&E.forceSinglePass===!1?(E.side=pi,E.needsUpdate=!0,Fr(E,z,$),E.side=_o,E.needsUpdate=!0,Fr(E,z,$),E.side=or):Fr(E,z,$)}this.compile=function(E,z,j=null){j===null&&(j=E),B!==null&&B.renderStart(E,z,j),C=te.get(j),C.init(z),T.push(C),j.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),E!==j&&E.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(C.pushLight(K),K.castShadow&&C.pushShadow(K))}),C.setupLights(),B!==null&&B.updateLights(C.state.lightsArray),xn=this.localClippingEnabled,$t=ie.init(this.clippingPlanes,xn),$t===!0&&ie.setGlobalState(this.clippingPlanes,z),B!==null&&me.render(C.state.shadowsArray,j,z);let $=new Set;return E.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Ie=0;Ie<Ee.length;Ie++){let Ae=Ee[Ie];Xl(Ae,j,z,K),$.add(Ae)}else Xl(Ee,j,z,K),$.add(Ee)}),C=T.pop(),B!==null&&B.renderEnd(),$},this.compileAsync=function(E,z,j=null){let $=this.compile(E,z,j);return new Promise(K=>{function Ee(){if($.forEach(function(Ie){let Le=He.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&$.delete(Ie)}),$.size===0){K(E);return}setTimeout(Ee,10)}Qe.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Sa=null;function xp(E){Sa&&Sa(E)}function Su(){hs.stop()}function Nr(){hs.start()}let hs=new Kb;hs.setAnimationLoop(xp),typeof self<"u"&&hs.setContext(self),this.setAnimationLoop=function(E){Sa=E,ue.setAnimationLoop(E),E===null?hs.stop():hs.start()},ue.addEventListener("sessionstart",Su),ue.addEventListener("sessionend",Nr),this.render=function(E,z){if(z!==void 0&&z.isCamera!==!0){st("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;B!==null&&B.renderStart(E,z);let j=ue.enabled===!0&&ue.isPresenting===!0,$=U!==null&&(le===null||j)&&U.begin(D,le);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ue.enabled===!0&&ue.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(ue.cameraAutoUpdate===!0&&ue.updateCamera(z),z=ue.getCamera()),E.isScene===!0&&E.onBeforeRender(D,E,z,le),C=te.get(E,T.length),C.init(z),C.state.textureUnits=Ze.getTextureUnits(),T.push(C),Gt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?rn.setFromArrayCamera(z):lt.setFromProjectionMatrix(Gt,rr,z.reversedDepth),xn=this.localClippingEnabled,$t=ie.init(this.clippingPlanes,xn),P=xe.get(E,y.length),P.init(),y.push(P),this.info.render.frame++,ue.enabled===!0&&ue.isPresenting===!0){let Ie=D.xr.getDepthSensingMesh();Ie!==null&&ds(Ie,z,-1/0,D.sortObjects)}ds(E,z,0,D.sortObjects),P.finish(),B!==null&&B.updateLights(C.state.lightsArray),D.sortObjects===!0&&P.sort($e,ut),dn=ue.enabled===!1||ue.isPresenting===!1||ue.hasDepthSensing()===!1,dn&&O.addToRenderList(P,E),this.info.autoReset===!0&&this.info.reset(),$t===!0&&ie.beginShadows();let K=C.state.shadowsArray;if(me.render(K,E,z),$t===!0&&ie.endShadows(),($&&U.hasRenderPass())===!1){let Ie=P.opaque,Ae=P.transmissive;if(C.setupLights(),z.isArrayCamera){let Le=z.cameras;if(Ae.length>0)for(let ze=0,rt=Le.length;ze<rt;ze++){let yt=Le[ze];dr(Ie,Ae,E,yt)}dn&&O.render(E);for(let ze=0,rt=Le.length;ze<rt;ze++){let yt=Le[ze];$l(P,E,yt,yt.viewport)}}else Ae.length>0&&dr(Ie,Ae,E,z),dn&&O.render(E),$l(P,E,z)}le!==null&&V===0&&(Ze.updateMultisampleRenderTarget(le),Ze.updateRenderTargetMipmap(le)),$&&U.end(D),E.isScene===!0&&E.onAfterRender(D,E,z),Se.resetDefaultState(),X=-1,Q=null,T.pop(),T.length>0?(C=T[T.length-1],Ze.setTextureUnits(C.state.textureUnits),$t===!0&&ie.setGlobalState(D.clippingPlanes,C.state.camera)):C=null,y.pop(),y.length>0?P=y[y.length-1]:P=null,B!==null&&B.renderEnd()};function ds(E,z,j,$){if(E.visible===!1)return;if(E.layers.test(z.layers)){if(E.isGroup)j=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(z);else if(E.isLight)C.pushLight(E),E.castShadow&&C.pushShadow(E);else if(E.isSprite){let Ie=z.isArrayCamera?rn:lt;if(!E.frustumCulled||E.intersectsFrustum(Ie)){$&&Ct.setFromMatrixPosition(E.matrixWorld).applyMatrix4(Gt);let Ae=he.update(E),Le=E.material;Le.visible&&P.push(E,Ae,Le,j,Ct.z,null,z)}}else if(E.isMesh||E.isLine||E.isPoints){let Ie=z.isArrayCamera?rn:lt;if(!E.frustumCulled||E.intersectsFrustum(Ie)){let Ae=he.update(E),Le=E.material;if($&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ct.copy(E.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),Ct.copy(Ae.boundingSphere.center)),Ct.applyMatrix4(E.matrixWorld).applyMatrix4(Gt)),Array.isArray(Le)){let ze=Ae.groups;for(let rt=0,yt=ze.length;rt<yt;rt++){let Be=ze[rt],xt=Le[Be.materialIndex];xt&&xt.visible&&P.push(E,Ae,xt,j,Ct.z,Be,z)}}else Le.visible&&P.push(E,Ae,Le,j,Ct.z,null,z)}}}let Ee=E.children;for(let Ie=0,Ae=Ee.length;Ie<Ae;Ie++)ds(Ee[Ie],z,j,$)}function $l(E,z,j,$){let{opaque:K,transmissive:Ee,transparent:Ie}=E;C.setupLightsView(j),$t===!0&&ie.setGlobalState(D.clippingPlanes,j),$&&Me.viewport(se.copy($)),K.length>0&&fn(K,z,j),Ee.length>0&&fn(Ee,z,j),Ie.length>0&&fn(Ie,z,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function dr(E,z,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[$.id]===void 0){let Be=Qe.has("EXT_color_buffer_half_float")||Qe.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[$.id]=new Vi(1,1,{generateMipmaps:!0,type:Be?Er:Xi,minFilter:Rs,samples:Math.max(4,ht.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Tt.workingColorSpace})}let Ee=C.state.transmissionRenderTarget[$.id],Ie=$.viewport||se;Ee.setSize(Ie.z*D.transmissionResolutionScale,Ie.w*D.transmissionResolutionScale);let Ae=D.getRenderTarget(),Le=D.getActiveCubeFace(),ze=D.getActiveMipmapLevel();D.setRenderTarget(Ee),D.getClearColor(ee),ge=D.getClearAlpha(),ge<1&&D.setClearColor(16777215,.5),D.clear(),dn&&O.render(j);let rt=D.toneMapping;D.toneMapping=ts;let yt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),C.setupLightsView($),$t===!0&&ie.setGlobalState(D.clippingPlanes,$),fn(E,j,$),Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee),Qe.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let xt=0,ln=z.length;xt<ln;xt++){let kt=z[xt],{object:Bt,geometry:In,material:Ue,group:Sn}=kt;if(Ue.side===or&&Bt.layers.test($.layers)){let wt=Ue.side;Ue.side=pi,Ue.needsUpdate=!0,vn(Bt,j,$,In,Ue,Sn),Ue.side=wt,Ue.needsUpdate=!0,Be=!0}}Be===!0&&(Ze.updateMultisampleRenderTarget(Ee),Ze.updateRenderTargetMipmap(Ee))}D.setRenderTarget(Ae,Le,ze),D.setClearColor(ee,ge),yt!==void 0&&($.viewport=yt),D.toneMapping=rt}function fn(E,z,j){let $=z.isScene===!0?z.overrideMaterial:null;for(let K=0,Ee=E.length;K<Ee;K++){let Ie=E[K],{object:Ae,geometry:Le,group:ze}=Ie,rt=Ie.material;rt.allowOverride===!0&&$!==null&&(rt=$),Ae.layers.test(j.layers)&&vn(Ae,z,j,Le,rt,ze)}}function vn(E,z,j,$,K,Ee){B!==null&&K.isNodeMaterial&&B.setObject(E,K),E.onBeforeRender(D,z,j,$,K,Ee),E.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),K.onBeforeRender(D,z,j,$,E,Ee),K.transparent===!0&&K.side===or&&K.forceSinglePass===!1?(K.side=pi,K.needsUpdate=!0,D.renderBufferDirect(j,z,$,K,E,Ee),K.side=_o,K.needsUpdate=!0,D.renderBufferDirect(j,z,$,K,E,Ee),K.side=or):D.renderBufferDirect(j,z,$,K,E,Ee),E.onAfterRender(D,z,j,$,K,Ee)}function _n(E){let z=0;for(let j of E)j.texture!==null&&z++;return z}function Fr(E,z,j){z.isScene!==!0&&(z=Rn);let $=He.get(E),K=C.state.lights,Ee=C.state.shadowsArray,Ie=K.state.version,Ae=ae.getParameters(E,K.state,Ee,z,j,C.state.lightProbeGridArray),Le=ae.getProgramCacheKey(Ae),ze=$.programs;$.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?z.environment:null,$.fog=z.fog;let rt=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;$.envMap=R.get(E.envMap||$.environment,rt),$.envMapRotation=$.environment!==null&&E.envMap===null?z.environmentRotation:E.envMapRotation,ze===void 0&&(E.addEventListener("dispose",dt),ze=new Map,$.programs=ze,$.programVariants=new Map);let yt=ze.get(Le);if(yt!==void 0){if($.currentProgram===yt&&$.lightsStateVersion===Ie)return Yl(E,Ae),yt}else Ae.uniforms=ae.getUniforms(E),B!==null&&E.isNodeMaterial&&B.build(E,j,Ae),E.onBeforeCompile(Ae,D),yt=ae.acquireProgram(Ae,Le),ze.set(Le,yt),$.uniforms=Ae.uniforms;let Be=$.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(Be.clippingPlanes=ie.uniform),Yl(E,Ae),$.needsLights=Vs(E),$.lightsStateVersion=Ie,$.needsLights&&(Be.ambientLightColor.value=K.state.ambient,Be.lightProbe.value=K.state.probe,Be.sunLights.value=K.state.sun,Be.sunLightShadows.value=K.state.sunShadow,Be.directionalLights.value=K.state.directional,Be.directionalLightShadows.value=K.state.directionalShadow,Be.spotLights.value=K.state.spot,Be.spotLightShadows.value=K.state.spotShadow,Be.rectAreaLights.value=K.state.rectArea,Be.ltc_1.value=K.state.rectAreaLTC1,Be.ltc_2.value=K.state.rectAreaLTC2,Be.pointLights.value=K.state.point,Be.pointLightShadows.value=K.state.pointShadow,Be.hemisphereLights.value=K.state.hemi,Be.sunShadowMatrix.value=K.state.sunShadowMatrix,Be.sunShadowCascade.value=K.state.sunShadowCascade,Be.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Be.spotLightMatrix.value=K.state.spotLightMatrix,Be.spotLightMap.value=K.state.spotLightMap,Be.pointShadowMatrix.value=K.state.pointShadowMatrix),$.numLightProbeGrids=_n(C.state.lightProbeGridArray),$.currentProgram=yt,$.uniformsList=null,yt}function Ci(E,z,j,$,K){let Ee=He.get(E),Ie=Ee.currentProgram.id+","+$+","+K,Ae=Ee.programVariants.get(Ie);return Ae===void 0?(Ae=Fr(E,z,j),Ee.programVariants.set(Ie,Ae)):(Ee.currentProgram=Ae,Ee.uniformsList=null,Ee.outputColorSpace=$,Ee.toneMapping=K),Ae}function Gs(E){if(E.uniformsList===null){let z=E.currentProgram.getUniforms();E.uniformsList=Pl.seqWithValue(z.seq,E.uniforms)}return E.uniformsList}function Yl(E,z){let j=He.get(E);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function Kl(E,z,j,$,K){z.isScene!==!0&&(z=Rn),Ze.resetTextureUnits();let Ee=z.fog,Ie=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?z.environment:null,Ae=le===null?D.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:Tt.workingColorSpace,Le=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,ze=R.get($.envMap||Ie,Le),rt=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,yt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Be=!!j.morphAttributes.position,xt=!!j.morphAttributes.normal,ln=!!j.morphAttributes.color,kt=ts;$.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(kt=D.toneMapping);let Bt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,In=Bt!==void 0?Bt.length:0,Ue=He.get($),Sn=C.state.lights;if($t===!0&&(xn===!0||E!==Q)){let zt=E===Q&&$.id===X;ie.setState($,E,zt)}let wt=!1,fs=!1;$.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==Sn.state.version||K.isBatchedMesh&&Ue.batching===!1||!K.isBatchedMesh&&Ue.batching===!0||K.isBatchedMesh&&Ue.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Ue.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Ue.instancing===!1||!K.isInstancedMesh&&Ue.instancing===!0||K.isSkinnedMesh&&Ue.skinning===!1||!K.isSkinnedMesh&&Ue.skinning===!0||K.isInstancedMesh&&Ue.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Ue.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Ue.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Ue.instancingMorph===!1&&K.morphTexture!==null||Ue.envMap!==ze||$.fog===!0&&Ue.fog!==Ee||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==ie.numPlanes||Ue.numIntersection!==ie.numIntersection)||Ue.vertexAlphas!==rt||Ue.vertexTangents!==yt||Ue.morphTargets!==Be||Ue.morphNormals!==xt||Ue.morphColors!==ln||Ue.morphTargetsCount!==In||Ue.numLightProbeGrids!==_n(C.state.lightProbeGridArray)?wt=!0:(Ue.outputColorSpace!==Ae||Ue.toneMapping!==kt)&&(fs=!0):(wt=!0,Ue.__version=$.version);let wn=Ue.currentProgram;(wt===!0||fs===!0)&&(wn=fs===!0?Ci($,z,K,Ae,kt):Fr($,z,K),B&&$.isNodeMaterial&&B.onUpdateProgram($,wn,Ue));let Ta=!1,Ur=!1,ps=!1,pt=wn.getUniforms(),pn=Ue.uniforms;if(Me.useProgram(wn.program)&&(Ta=!0,Ur=!0,ps=!0),$.id!==X&&(X=$.id,Ur=!0),Ta||Q!==E){Me.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),pt.setValue(k,"projectionMatrix",E.projectionMatrix),pt.setValue(k,"viewMatrix",E.matrixWorldInverse);let Mn=pt.map.cameraPosition;Mn!==void 0&&Mn.setValue(k,kn.setFromMatrixPosition(E.matrixWorld)),ht.logarithmicDepthBuffer&&pt.setValue(k,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&pt.setValue(k,"isOrthographic",E.isOrthographicCamera===!0),Q!==E&&(Q=E,Ur=!0,ps=!0)}if(Ue.needsLights&&(Sn.state.sunShadowMap.length>0&&pt.setValue(k,"sunShadowMap",Sn.state.sunShadowMap,Ze),Sn.state.directionalShadowMap.length>0&&pt.setValue(k,"directionalShadowMap",Sn.state.directionalShadowMap,Ze),Sn.state.spotShadowMap.length>0&&pt.setValue(k,"spotShadowMap",Sn.state.spotShadowMap,Ze),Sn.state.pointShadowMap.length>0&&pt.setValue(k,"pointShadowMap",Sn.state.pointShadowMap,Ze)),K.isSkinnedMesh){pt.setOptional(k,K,"bindMatrix"),pt.setOptional(k,K,"bindMatrixInverse");let zt=K.skeleton;zt&&(zt.boneTexture===null&&zt.computeBoneTexture(),pt.setValue(k,"boneTexture",zt.boneTexture,Ze))}K.isBatchedMesh&&(pt.setOptional(k,K,"batchingTexture"),pt.setValue(k,"batchingTexture",K._matricesTexture,Ze),pt.setOptional(k,K,"batchingIdTexture"),pt.setValue(k,"batchingIdTexture",K._indirectTexture,Ze),pt.setOptional(k,K,"batchingColorTexture"),K._colorsTexture!==null&&pt.setValue(k,"batchingColorTexture",K._colorsTexture,Ze));let oi=j.morphAttributes;if((oi.position!==void 0||oi.normal!==void 0||oi.color!==void 0)&&oe.update(K,j,wn),(Ur||Ue.receiveShadow!==K.receiveShadow)&&(Ue.receiveShadow=K.receiveShadow,pt.setValue(k,"receiveShadow",K.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&z.environment!==null&&(pn.envMapIntensity.value=z.environmentIntensity),pn.dfgLUT!==void 0&&(pn.dfgLUT.value=B2()),Ur){if(pt.setValue(k,"toneMappingExposure",D.toneMappingExposure),Ue.needsLights&&wa(pn,ps),Ee&&$.fog===!0&&_e.refreshFogUniforms(pn,Ee),_e.refreshMaterialUniforms(pn,$,we,Ce,C.state.transmissionRenderTarget[E.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let zt=S,Mn=0;for(let jn of C.state.lightProbeGridArray)jn.texture!==null&&(zt.textures[Mn]=jn.texture,zt.min[Mn]=jn.boundingBox.min,zt.max[Mn]=jn.boundingBox.max,zt.resolution[Mn]=jn.resolution,Mn++);for(let jn in zt)zt[jn].length=Mn;pn.probesSH.value=zt.textures,pn.probesMin.value=zt.min,pn.probesMax.value=zt.max,pn.probesResolution.value=zt.resolution}Pl.upload(k,Gs(Ue),pn,Ze)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(Pl.upload(k,Gs(Ue),pn,Ze),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&pt.setValue(k,"center",K.center),pt.setValue(k,"modelViewMatrix",K.modelViewMatrix),pt.setValue(k,"normalMatrix",K.normalMatrix),pt.setValue(k,"modelMatrix",K.matrixWorld),$.uniformsGroups!==void 0){let zt=$.uniformsGroups;for(let Mn=0,jn=zt.length;Mn<jn;Mn++){let wu=zt[Mn];qe.update(wu,wn),qe.bind(wu,wn)}}return wn}function wa(E,z){E.ambientLightColor.needsUpdate=z,E.lightProbe.needsUpdate=z,E.sunLights.needsUpdate=z,E.sunLightShadows.needsUpdate=z,E.directionalLights.needsUpdate=z,E.directionalLightShadows.needsUpdate=z,E.pointLights.needsUpdate=z,E.pointLightShadows.needsUpdate=z,E.spotLights.needsUpdate=z,E.spotLightShadows.needsUpdate=z,E.rectAreaLights.needsUpdate=z,E.hemisphereLights.needsUpdate=z}function Vs(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(E,z,j){let $=He.get(E);$.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),He.get(E.texture).__webglTexture=z,He.get(E.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,z){let j=He.get(E);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(E,z=0,j=0){le=E,Y=z,V=j;let $=null,K=!1,Ee=!1;if(E){let Ae=He.get(E);if(Ae.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(k.FRAMEBUFFER,Ae.__webglFramebuffer),se.copy(E.viewport),fe.copy(E.scissor),de=E.scissorTest,Me.viewport(se),Me.scissor(fe),Me.setScissorTest(de),X=-1;return}else if(Ae.__webglFramebuffer===void 0)Ze.setupRenderTarget(E);else if(Ae.__hasExternalTextures)Ze.rebindTextures(E,He.get(E.texture).__webglTexture,He.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let rt=E.depthTexture;if(Ae.__boundDepthTexture!==rt){if(rt!==null&&He.has(rt)&&(E.width!==rt.image.width||E.height!==rt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ze.setupDepthRenderbuffer(E)}}let Le=E.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Ee=!0);let ze=He.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(ze[z])?$=ze[z][j]:$=ze[z],K=!0):E.samples>0&&Ze.useMultisampledRTT(E)===!1?$=He.get(E).__webglMultisampledFramebuffer:Array.isArray(ze)?$=ze[j]:$=ze,se.copy(E.viewport),fe.copy(E.scissor),de=E.scissorTest}else se.copy(We).multiplyScalar(we).floor(),fe.copy(_t).multiplyScalar(we).floor(),de=ft;if(j!==0&&($=G),Me.bindFramebuffer(k.FRAMEBUFFER,$)&&Me.drawBuffers(E,$),Me.viewport(se),Me.scissor(fe),Me.setScissorTest(de),K){let Ae=He.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ae.__webglTexture,j)}else if(Ee){let Ae=z;for(let Le=0;Le<E.textures.length;Le++){let ze=He.get(E.textures[Le]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+Le,ze.__webglTexture,j,Ae)}}else if(E!==null&&j!==0){let Ae=He.get(E.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Ae.__webglTexture,j)}X=-1};function Ma(E){let z=He.get(E);return(z.__readFormat!==E.format||z.__readType!==E.type)&&(z.__readFormat=E.format,z.__readType=E.type,z.__formatReadable=ht.textureFormatReadable(E.format),z.__typeReadable=ht.textureTypeReadable(E.type)),z}this.readRenderTargetPixels=function(E,z,j,$,K,Ee,Ie,Ae=0){if(!(E&&E.isWebGLRenderTarget)){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){Me.bindFramebuffer(k.FRAMEBUFFER,Le);try{let ze=E.textures[Ae],rt=ze.format,yt=ze.type;E.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ae);let Be=Ma(ze);if(Be.__formatReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=E.width-$&&j>=0&&j<=E.height-K&&k.readPixels(z,j,$,K,ve.convert(rt),ve.convert(yt),Ee)}finally{let ze=le!==null?He.get(le).__webglFramebuffer:null;Me.bindFramebuffer(k.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(E,z,j,$,K,Ee,Ie,Ae=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=He.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(z>=0&&z<=E.width-$&&j>=0&&j<=E.height-K){Me.bindFramebuffer(k.FRAMEBUFFER,Le);let ze=E.textures[Ae],rt=ze.format,yt=ze.type;E.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Ae);let Be=Ma(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xt=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,xt),k.bufferData(k.PIXEL_PACK_BUFFER,Ee.byteLength,k.STREAM_READ),k.readPixels(z,j,$,K,ve.convert(rt),ve.convert(yt),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let ln=le!==null?He.get(le).__webglFramebuffer:null;Me.bindFramebuffer(k.FRAMEBUFFER,ln);let kt=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await xb(k,kt,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,xt),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Ee),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(xt),k.deleteSync(kt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,z=null,j=0){let $=Math.pow(2,-j),K=Math.floor(E.image.width*$),Ee=Math.floor(E.image.height*$),Ie=z!==null?z.x:0,Ae=z!==null?z.y:0;Ze.setTexture2D(E,0),k.copyTexSubImage2D(k.TEXTURE_2D,j,0,0,Ie,Ae,K,Ee),Me.unbindTexture()},this.copyTextureToTexture=function(E,z,j=null,$=null,K=0,Ee=0){let Ie,Ae,Le,ze,rt,yt,Be,xt,ln,kt=E.isCompressedTexture?E.mipmaps[Ee]:E.image;if(j!==null)Ie=j.max.x-j.min.x,Ae=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,rt=j.min.y,yt=j.isBox3?j.min.z:0;else{let pt=Math.pow(2,-K);Ie=Math.floor(kt.width*pt),Ae=Math.floor(kt.height*pt),E.isDataArrayTexture?Le=kt.depth:E.isData3DTexture?Le=Math.floor(kt.depth*pt):Le=1,ze=0,rt=0,yt=0}$!==null?(Be=$.x,xt=$.y,ln=$.z):(Be=0,xt=0,ln=0);let Bt=ve.convert(z.format),In=ve.convert(z.type),Ue;z.isData3DTexture?(Ze.setTexture3D(z,0),Ue=k.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ze.setTexture2DArray(z,0),Ue=k.TEXTURE_2D_ARRAY):(Ze.setTexture2D(z,0),Ue=k.TEXTURE_2D),Me.activeTexture(k.TEXTURE0),Me.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,z.flipY),Me.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Me.pixelStorei(k.UNPACK_ALIGNMENT,z.unpackAlignment);let Sn=Me.getParameter(k.UNPACK_ROW_LENGTH),wt=Me.getParameter(k.UNPACK_IMAGE_HEIGHT),fs=Me.getParameter(k.UNPACK_SKIP_PIXELS),wn=Me.getParameter(k.UNPACK_SKIP_ROWS),Ta=Me.getParameter(k.UNPACK_SKIP_IMAGES);Me.pixelStorei(k.UNPACK_ROW_LENGTH,kt.width),Me.pixelStorei(k.UNPACK_IMAGE_HEIGHT,kt.height),Me.pixelStorei(k.UNPACK_SKIP_PIXELS,ze),Me.pixelStorei(k.UNPACK_SKIP_ROWS,rt),Me.pixelStorei(k.UNPACK_SKIP_IMAGES,yt);let Ur=E.isDataArrayTexture||E.isData3DTexture,ps=z.isDataArrayTexture||z.isData3DTexture;if(E.isDepthTexture){let pt=He.get(E),pn=He.get(z),oi=He.get(pt.__renderTarget),zt=He.get(pn.__renderTarget);Me.bindFramebuffer(k.READ_FRAMEBUFFER,oi.__webglFramebuffer),Me.bindFramebuffer(k.DRAW_FRAMEBUFFER,zt.__webglFramebuffer);for(let Mn=0;Mn<Le;Mn++)Ur&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,He.get(E).__webglTexture,K,yt+Mn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,He.get(z).__webglTexture,Ee,ln+Mn)),k.blitFramebuffer(ze,rt,ze+Ie,rt+Ae,Be,xt,Be+Ie,xt+Ae,k.DEPTH_BUFFER_BIT,k.NEAREST);Me.bindFramebuffer(k.READ_FRAMEBUFFER,null),Me.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(K!==0||E.isRenderTargetTexture||He.has(E)){let pt=He.get(E),pn=He.get(z);Me.bindFramebuffer(k.READ_FRAMEBUFFER,F),Me.bindFramebuffer(k.DRAW_FRAMEBUFFER,H);for(let oi=0;oi<Le;oi++)Ur?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pt.__webglTexture,K,yt+oi):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pt.__webglTexture,K),ps?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,pn.__webglTexture,Ee,ln+oi):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,pn.__webglTexture,Ee),K!==0?k.blitFramebuffer(ze,rt,ze+Ie,rt+Ae,Be,xt,Be+Ie,xt+Ae,k.COLOR_BUFFER_BIT,k.NEAREST):ps?k.copyTexSubImage3D(Ue,Ee,Be,xt,ln+oi,ze,rt,Ie,Ae):k.copyTexSubImage2D(Ue,Ee,Be,xt,ze,rt,Ie,Ae);Me.bindFramebuffer(k.READ_FRAMEBUFFER,null),Me.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else ps?E.isDataTexture||E.isData3DTexture?k.texSubImage3D(Ue,Ee,Be,xt,ln,Ie,Ae,Le,Bt,In,kt.data):z.isCompressedArrayTexture?k.compressedTexSubImage3D(Ue,Ee,Be,xt,ln,Ie,Ae,Le,Bt,kt.data):k.texSubImage3D(Ue,Ee,Be,xt,ln,Ie,Ae,Le,Bt,In,kt):E.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Ee,Be,xt,Ie,Ae,Bt,In,kt.data):E.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Ee,Be,xt,kt.width,kt.height,Bt,kt.data):k.texSubImage2D(k.TEXTURE_2D,Ee,Be,xt,Ie,Ae,Bt,In,kt);Me.pixelStorei(k.UNPACK_ROW_LENGTH,Sn),Me.pixelStorei(k.UNPACK_IMAGE_HEIGHT,wt),Me.pixelStorei(k.UNPACK_SKIP_PIXELS,fs),Me.pixelStorei(k.UNPACK_SKIP_ROWS,wn),Me.pixelStorei(k.UNPACK_SKIP_IMAGES,Ta),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&k.generateMipmap(Ue),Me.unbindTexture()},this.initRenderTarget=function(E){He.get(E).__webglFramebuffer===void 0&&Ze.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ze.setTextureCube(E,0):E.isData3DTexture?Ze.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ze.setTexture2DArray(E,0):Ze.setTexture2D(E,0),Me.unbindTexture()},this.resetState=function(){Y=0,V=0,le=null,Me.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return rr}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Tt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Tt._getUnpackColorSpace()}};var oS={type:"change"},e0={type:"start"},lS={type:"end"},uf=new ia,aS=new zi,G2=Math.cos(70*kg.DEG2RAD),On=new Z,wi=2*Math.PI,Ft={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Qg=1e-6,hf=class extends qc{constructor(e,t=null){super(e,t),this.state=Ft.NONE,this.target=new Z,this.cursor=new Z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:go.ROTATE,MIDDLE:go.DOLLY,RIGHT:go.PAN},this.touches={ONE:vo.ROTATE,TWO:vo.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new Z,this._lastQuaternion=new Gi,this._lastTargetPosition=new Z,this._quat=new Gi().setFromUnitVectors(e.up,new Z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new wl,this._sphericalDelta=new wl,this._scale=1,this._panOffset=new Z,this._rotateStart=new at,this._rotateEnd=new at,this._rotateDelta=new at,this._panStart=new at,this._panEnd=new at,this._panDelta=new at,this._dollyStart=new at,this._dollyEnd=new at,this._dollyDelta=new at,this._dollyDirection=new Z,this._mouse=new at,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=H2.bind(this),this._onPointerDown=V2.bind(this),this._onPointerUp=W2.bind(this),this._onContextMenu=J2.bind(this),this._onMouseWheel=$2.bind(this),this._onKeyDown=Y2.bind(this),this._onTouchStart=K2.bind(this),this._onTouchMove=Z2.bind(this),this._onMouseDown=q2.bind(this),this._onMouseMove=X2.bind(this),this._interceptControlDown=j2.bind(this),this._interceptControlUp=Q2.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ft.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(oS),this.update(),this.state=Ft.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;On.copy(t).sub(this.target),On.applyQuaternion(this._quat),this._spherical.setFromVector3(On),this.autoRotate&&this.state===Ft.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,r=this.maxAzimuthAngle;isFinite(i)&&isFinite(r)&&(i<-Math.PI?i+=wi:i>Math.PI&&(i-=wi),r<-Math.PI?r+=wi:r>Math.PI&&(r-=wi),i<=r?this._spherical.theta=Math.max(i,Math.min(r,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+r)/2?Math.max(i,this._spherical.theta):Math.min(r,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let s=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),s=o!=this._spherical.radius}if(On.setFromSpherical(this._spherical),On.applyQuaternion(this._quatInverse),t.copy(this.target).add(On),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=On.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),s=!!l}else if(this.object.isOrthographicCamera){let a=new Z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),s=l!==this.object.zoom;let c=new Z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=On.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(uf.origin.copy(this.object.position),uf.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(uf.direction))<G2?this.object.lookAt(this.target):(aS.setFromNormalAndCoplanarPoint(this.object.up,this.target),uf.intersectPlane(aS,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),s=!0)}return this._scale=1,this._performCursorZoom=!1,s||this._lastPosition.distanceToSquared(this.object.position)>Qg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Qg||this._lastTargetPosition.distanceToSquared(this.target)>Qg?(this.dispatchEvent(oS),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?wi/60*this.autoRotateSpeed*e:wi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){On.setFromMatrixColumn(t,0),On.multiplyScalar(-e),this._panOffset.add(On)}_panUp(e,t){this.screenSpacePanning===!0?On.setFromMatrixColumn(t,1):(On.setFromMatrixColumn(t,0),On.crossVectors(this.object.up,On)),On.multiplyScalar(e),this._panOffset.add(On)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let r=this.object.position;On.copy(r).sub(this.target);let s=On.length();s*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*s/i.clientHeight,this.object.matrix),this._panUp(2*t*s/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),r=e-i.left,s=t-i.top,o=i.width,a=i.height;this._mouse.x=r/o*2-1,this._mouse.y=-(s/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(wi*this._rotateDelta.x/t.clientHeight),this._rotateUp(wi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._rotateStart.set(i,r)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panStart.set(i,r)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,r=e.pageY-t.y,s=Math.sqrt(i*i+r*r);this._dollyStart.set(0,s)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),r=.5*(e.pageX+i.x),s=.5*(e.pageY+i.y);this._rotateEnd.set(r,s)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(wi*this._rotateDelta.x/t.clientHeight),this._rotateUp(wi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),r=.5*(e.pageY+t.y);this._panEnd.set(i,r)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,r=e.pageY-t.y,s=Math.sqrt(i*i+r*r);this._dollyEnd.set(0,s),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new at,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function V2(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function H2(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function W2(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(lS),this.state=Ft.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function q2(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case go.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ft.DOLLY;break;case go.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ft.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ft.ROTATE}break;case go.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ft.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ft.PAN}break;default:this.state=Ft.NONE}this.state!==Ft.NONE&&this.dispatchEvent(e0)}function X2(n){switch(this.state){case Ft.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ft.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ft.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function $2(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ft.NONE||(n.preventDefault(),this.dispatchEvent(e0),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(lS))}function Y2(n){this.enabled!==!1&&this._handleKeyDown(n)}function K2(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case vo.ROTATE:if(this.enableRotate===!1){this.state=Ft.NONE;break}this._handleTouchStartRotate(n),this.state=Ft.TOUCH_ROTATE;break;case vo.PAN:if(this.enablePan===!1){this.state=Ft.NONE;break}this._handleTouchStartPan(n),this.state=Ft.TOUCH_PAN;break;default:this.state=Ft.NONE}break;case 2:switch(this.touches.TWO){case vo.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ft.TOUCH_DOLLY_PAN;break;case vo.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ft.TOUCH_DOLLY_ROTATE;break;default:this.state=Ft.NONE}break;default:this.state=Ft.NONE}this.state!==Ft.NONE&&this.dispatchEvent(e0)}function Z2(n){switch(this._trackPointer(n),this.state){case Ft.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ft.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ft.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ft.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ft.NONE}}function J2(n){this.enabled!==!1&&n.preventDefault()}function j2(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Q2(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var cS=[[1,0],[0,1]],eD=`
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
}`,tD=`
uniform sampler2D scale;
varying vec3 seen;
varying float amount;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = 0.62 + 0.38 * abs(normal.z) + 0.08 * normal.y;
  gl_FragColor = vec4(texture2D(scale, vec2(clamp(amount, 0.0, 1.0), 0.5)).rgb * light, 1.0);
}`,nD=`
uniform vec3 ink;
void main() { gl_FragColor = vec4(ink, 1.0); }`,iD={oblique:[.45,-.8,.45],x:[1,0,0],y:[0,-1,0],z:[0,-.001,1]},df=class{constructor(e,t,i){this.data=e;this.canvas=t;this.renderer=new af({canvas:t,antialias:!0,alpha:!0,preserveDrawingBuffer:!0}),this.vectors=e.header.extra.lattice_vectors,this.period=Math.hypot(...this.vectors[0]);let r=Float32Array.from(e.values("skin_position"),h=>h/this.period),s={position:new fi(r,3),real:new fi(new Float32Array(r.length),3),imag:new fi(new Float32Array(r.length),3)};for(let h of[this.surface,this.edges])for(let[d,f]of Object.entries(s))h.setAttribute(d,f);this.surface.setIndex(sD(e.values("skin_face"))),this.edges.setIndex(Array.from(e.values("skin_edge"))),this.box.setFromBufferAttribute(s.position),this.box.getCenter(this.uniforms.middle.value);let o=new ra(Uint8Array.from(i.flatMap(([h=0,d=0,f=0])=>[h,d,f,255])),i.length,1);o.minFilter=o.magFilter=Zn,o.needsUpdate=!0,this.uniforms.scale.value=o;let a={uniforms:this.uniforms,vertexShader:eD},l=new sr(this.surface,new Wi({...a,fragmentShader:tD,side:or,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1})),c=new kc(this.edges,new Wi({...a,fragmentShader:nD}));for(let h of[l,c])h.frustumCulled=!1,this.scene.add(h);this.camera.up.set(0,0,1),this.controls=new hf(this.camera,t),this.controls.enableDamping=!1,this.controls.addEventListener("change",()=>this.draw()),this.colourLines()}data;canvas;renderer;scene=new Fc;camera=new di(28,1,.01,100);controls;uniforms={phase:{value:new at(1,0)},swing:{value:.15},turned:{value:new it},middle:{value:new Z},scale:{value:new ra(new Uint8Array(4),1,1)},ink:{value:new Et(0,0,0)}};surface=new bl;edges=new bl;period;vectors;box=new Qr;copies=[1,1];kappa=[0,0];frames=0;turns=[];show({of:e,row:t,band:i,kappa:r,turn:s,isReversed:o}){let[,a=0,l=0]=this.data.shape(`${e}_mode_real`),c=(t*a+i)*l,h=this.data.values("path_shape");for(let _ of["real","imag"]){let v=`${e}_mode_${_}`,g=this.data.values(v).subarray(c,c+l),A=(o&&_==="imag"?-1:1)*this.data.scale(v)*this.data.scale("path_shape"),S=this.surface.getAttribute(_);rD(S.array,h,g,A),S.needsUpdate=!0}let[[d,f],[p,m]]=s;this.uniforms.turned.value.set(d,f,0,p,m,0,0,0,1),this.kappa=r,this.place()}repeat(e){this.copies=e,this.place(),this.look("oblique")}set swing(e){this.uniforms.swing.value=e}turn(e){this.uniforms.phase.value.set(Math.cos(2*Math.PI*e),Math.sin(2*Math.PI*e)),this.draw()}draw(){this.frames++,this.renderer.render(this.scene,this.camera)}look(e){let[t,i]=this.copies,r=this.box.clone();for(let[c,h]of[[t-1,0],[0,i-1],[t-1,i-1]])r.union(this.box.clone().translate(this.shift(c,h)));let s=r.getBoundingSphere(new Cs),o=this.camera.fov*Math.PI/360,a=Math.atan(Math.tan(o)*Math.min(1,this.camera.aspect)),l=1.08*s.radius/Math.sin(a);this.controls.target.copy(s.center),this.camera.position.set(...iD[e]).normalize().multiplyScalar(l).add(s.center),this.camera.near=.01*l,this.camera.far=10*l,this.camera.updateProjectionMatrix(),this.controls.update(),this.draw()}resize(e,t){this.renderer.setPixelRatio(devicePixelRatio),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix()}colourLines(){this.uniforms.ink.value.set(Xe("ink"))}dispose(){this.controls.dispose(),this.surface.dispose(),this.edges.dispose(),this.uniforms.scale.value.dispose(),this.renderer.dispose()}shift(e,t){let[[i,r],[s,o]]=this.vectors;return new Z((e*i+t*s)/this.period,(e*r+t*o)/this.period,0)}place(){let[e,t]=this.copies,i=[],r=[];for(let s=0;s<e;s++)for(let o=0;o<t;o++){let a=s*this.kappa[0]+o*this.kappa[1];i.push(...this.shift(s,o).toArray()),r.push(Math.cos(a),Math.sin(a))}this.turns=r;for(let s of[this.surface,this.edges])s.instanceCount=e*t,s.setAttribute("origin",new yl(Float32Array.from(i),3)),s.setAttribute("turn",new yl(Float32Array.from(r),2))}};function rD(n,e,t,i){n.fill(0);for(let r=0;r<t.length;r++){let s=(t[r]??0)*i;if(s===0)continue;let o=r*n.length;for(let a=0;a<n.length;a++)n[a]+=s*e[o+a]}}function sD(n){let e=[];for(let t=0;t<n.length;t+=4){let[i,r,s,o]=n.subarray(t,t+4);e.push(i,r,s,i,s,o)}return e}var oD=[["oblique","oblique"],["x","along x"],["y","along y"],["z","from above"]];function ff({data:n,choice:e,motion:t,name:i}){let r=Ke(null),s=Ke(null),[o,a]=Rt("");return mt(()=>{if(r.current===null)return;let l;try{l=new df(n,r.current,uS(n))}catch{a("The mode cannot be drawn, because this browser has no WebGL.");return}return s.current=l,Object.assign(r.current,{moving:l}),lD(l,t,e)},[n,e,t]),u("div",{class:"mode",children:[o?u("p",{role:"alert",children:o}):u("canvas",{ref:r,role:"img","aria-label":"The cell moving in the selected mode"}),u("p",{class:"scale",children:[u("span",{children:"0"}),u("span",{class:"bar",style:{background:aD(n)}}),u("span",{children:"1"})," displacement, relative to the largest"]}),u("p",{class:"sides",children:[u("span",{id:`seen-${i}`,children:"Seen"}),oD.map(([l,c])=>u("button",{type:"button",onClick:()=>s.current?.look(l),"aria-describedby":`seen-${i}`,children:c}))]}),u(Qa,{canvas:r,name:i,caption:`${n.header.title}, ${mr(n)}`})]})}function uS(n){return n.header.extra.colours}function aD(n){return`linear-gradient(to right, ${uS(n).map(e=>`rgb(${e.join(" ")})`).join(", ")})`}function lD(n,e,t){let{canvas:i}=n,r=()=>n.turn(s.moment),s=new no(t,r,i);ja(i,l=>s.at(l));let o=new ResizeObserver(()=>{n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1)),n.look("oblique")});n.resize(Math.max(i.clientWidth,1),Math.max(i.clientHeight,1));let a=[Je(()=>n.repeat(t.copies.value)),Je(()=>{n.show(e.value),i.dataset.shown=`${e.value.row},${e.value.band}`,r()}),Je(()=>{n.swing=t.swing.value,r()}),Qn(()=>{n.colourLines(),n.draw()})];return o.observe(i),()=>{s.end(),o.disconnect();for(let l of a)l();n.dispose()}}function hS({diagram:n,unit:e}){let{factor:t}=e;return n.gaps.length===0?u("p",{children:"The computed bands have no gap."}):u("div",{class:"wide",children:u("table",{children:[u("caption",{children:"Gaps"}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"bands"}),u("th",{scope:"col",children:"where"}),u("th",{scope:"col",children:Yt("lower",e)}),u("th",{scope:"col",children:Yt("upper",e)})]})}),u("tbody",{children:n.gaps.map(i=>u("tr",{children:[u("td",{children:[i.waves==="all"?"":`${i.waves} `,i.below,"-",i.below+1]}),u("td",{children:i.complete?"everywhere (complete)":i.waves==="all"?`${i.direction} only`:"everywhere, these waves only"}),u("td",{children:Ht(i.lower/t,i.lowerError/t)}),u("td",{children:Ht(i.upper/t,i.upperError/t)})]}))})]})})}function dS({diagram:n,choice:e}){let{row:t,band:i}=e.point.value,r=e.unit.value,{factor:s}=r,o=Array.from({length:n.bands},(a,l)=>({row:t,band:l}));return u("div",{class:"wide",children:u("table",{children:[u("caption",{children:["Modes at ",n.place(t)]}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"band"}),u("th",{scope:"col",children:Yt("frequency",r)}),u("th",{scope:"col",children:"motion"}),u("th",{scope:"col",children:"symmetry"}),u("th",{scope:"col",children:"show"})]})}),u("tbody",{children:o.map(a=>u("tr",{"aria-current":a.band===i?"true":void 0,children:[u("td",{children:a.band+1}),u("td",{children:Ht(n.at(a)/s,n.errorAt(a)/s)}),u("td",{children:n.nature(a)}),u("td",{children:n.parity(a)}),u("td",{children:u("button",{type:"button",onClick:()=>e.point.value=a,children:["band ",a.band+1]})})]}))})]})})}function xo({colours:n,ends:[e,t],children:i}){let r=[0,.25,.5,.75,1].map(s=>`rgb(${(n[Math.round(s*(n.length-1))]??[]).join(" ")})`);return u("p",{class:"scale",children:[u("span",{children:e}),u("span",{class:"bar",style:{background:`linear-gradient(to right, ${r.join(", ")})`}}),u("span",{children:t})," ",i]})}var bo="#1c2126",fS={ink:bo,rim:"#ffffff"};function pf(n,e,t,i=()=>!0){n.beginPath();for(let{outline:r,places:s}of e)for(let o of s)i(o)&&ru(n,r.map(([a,l])=>[o[0]+a,o[1]+l]),t)}function mf(n,e,t){n.save(),n.strokeStyle=Xe("carrier"),n.lineWidth=4*devicePixelRatio;for(let{hold:i,ends:r}of e)n.setLineDash(i==="clamped"?[]:[5*devicePixelRatio,3*devicePixelRatio]),n.beginPath(),ru(n,r,t),n.stroke();n.restore()}function ru(n,e,t){e.forEach((i,r)=>r===0?n.moveTo(...t(i)):n.lineTo(...t(i))),n.closePath()}function rs(n,e,t){n.beginPath(),ru(n,e,t),n.stroke()}function So([n,e],[t,i]){let[r,s]=[t/2,i/2];return[[n-r,e-s],[n+r,e-s],[n+r,e+s],[n-r,e+s]]}function Il(n,e,t,i,r=fS){let o=t.flatMap(f=>f.map((p,m)=>[i(p),i(f[(m+1)%f.length]??p)])).filter(([f,p])=>Math.abs(f[1]-p[1])<1),a=Math.min(...o.map(([f])=>f[1])),l=([f,p])=>Math.abs(f[0]-p[0]),[c]=o.filter(([f])=>f[1]<a+1).sort((f,p)=>l(p)-l(f));if(c===void 0)return;let[h,d]=c;t0(n,e,[(h[0]+d[0])/2,a+17*devicePixelRatio],r)}function t0(n,e,[t,i],r=fS){n.save(),n.font=`${13*devicePixelRatio}px system-ui, sans-serif`,n.textAlign="center",n.lineWidth=3*devicePixelRatio,n.strokeStyle=r.rim,n.fillStyle=r.ink;let s=n.measureText(e).width/2,o=Math.min(Math.max(t,s),n.canvas.width-s);n.strokeText(e,o,i),n.fillText(e,o,i),n.restore()}var pS=new WeakMap;function mS(n,e,t,i){let r=n.canvas.width,s=`${t} ${r}`,o=pS.get(e);o?.of!==s&&(o={of:s,surface:cD(e,t,r,i)},pS.set(e,o)),n.save(),n.resetTransform(),n.drawImage(o.surface,0,0),n.restore()}function cD(n,e,t,i){let r=new OffscreenCanvas(t,t),s=new ImageData(t,t),[o,a]=n.range(e),l=n.colours.length-1;for(let c of n.mesh(e)){let h=c.map(f=>i(n.wavevector(f)).map(p=>p*devicePixelRatio)),d=c.map(f=>(n.at(n.sample(f),e)-o)/(a-o||1)*l);uD(s,h,d,n.colours)}return r.getContext("2d")?.putImageData(s,0,0),r}var n0=1e-6;function uD(n,[e,t,i],[r,s,o],a){let l=(t[0]-e[0])*(i[1]-e[1])-(i[0]-e[0])*(t[1]-e[1]);if(l===0)return;let c=m=>[Math.max(Math.floor(Math.min(e[m],t[m],i[m])),0),Math.min(Math.ceil(Math.max(e[m],t[m],i[m])),n.width)],[[h,d],[f,p]]=[c(0),c(1)];for(let m=f;m<p;m++)for(let _=h;_<d;_++){let[v,g]=[_+.5-e[0],m+.5-e[1]],x=(v*(i[1]-e[1])-(i[0]-e[0])*g)/l,A=((t[0]-e[0])*g-v*(t[1]-e[1]))/l;if(x<-n0||A<-n0||x+A>1+n0)continue;let S=Math.min(Math.max(r+x*(s-r)+A*(o-r),0),a.length-1),[P,C,y]=[a[Math.floor(S)]??[],a[Math.ceil(S)]??[],S%1],T=4*(m*n.width+_);for(let U=0;U<3;U++)n.data[T+U]=(1-y)*(P[U]??0)+y*(C[U]??0);n.data[T+3]=255}}var hD=[1,2,5,10],dD=1e-6,fD=.7,gf=class{constructor(e){this.data=e;this.places=e.values("zone_wavevector"),this.samples=e.values("zone_sample"),this.frequency=e.values("zone_frequency"),this.error=e.values("zone_error"),[,this.bands=0]=e.shape("zone_frequency");let t=Array.from(e.values("zone_mesh"));this.triangles=Array.from({length:t.length/3},(i,r)=>t.slice(3*r,3*r+3)),this.corners=e.header.extra.zone,this.colours=e.header.extra.colours,this.reach=Math.max(...Array.from(this.places,Math.abs))}data;bands;triangles;meshes=new Map;corners;colours;reach;places;samples;frequency;error;wavevector(e){return[this.places[2*e]??NaN,this.places[2*e+1]??NaN]}sample(e){return this.samples[e]??0}phases(e){let t=this.data.values("zone_kappa");return[t[2*e]??NaN,t[2*e+1]??NaN]}at(e,t){return this.frequency[e*this.bands+t]??NaN}errorAt(e,t){return this.error[e*this.bands+t]??NaN}get hasModes(){return this.data.has("zone_mode_real")}motion(e,t){let[i,r]=this.turned(e),[s,o]=this.wavevector(e),a=this.data.header.extra.lattice_vectors,[l,c]=a.map(([h,d])=>s*h+o*d);return{of:"zone",row:this.sample(e),band:t,kappa:[l??0,c??0],turn:i,isReversed:r}}velocity(e,t){let i=2*(this.sample(e)*this.bands+t),[r,s]=[this.data.values("zone_velocity")[i]??NaN,this.data.values("zone_velocity")[i+1]??NaN],[[[o,a],[l,c]],h]=this.turned(e),d=h?-1:1;return Number.isFinite(r)&&Number.isFinite(s)?[d*(o*r+a*s),d*(l*r+c*s)]:void 0}velocityError(e,t){return this.data.values("zone_velocity_error")[this.sample(e)*this.bands+t]??NaN}described(e,t){let i=this.sample(e),r=o=>this.data.values(o)[i*this.bands+t];return{motion:r("zone_character"),symmetry:Am(r("zone_parity"),"the mirror of the wavevector",r("zone_middle_parity"))}}turned(e){let t=Math.floor(e/this.count),i=this.data.header.extra.zone_turns[t];if(i===void 0)throw new Error(`the zone has no copy ${t}`);return[i,this.data.header.extra.zone_signs[t]===-1]}mesh(e){let t=this.meshes.get(e);if(t!==void 0)return t;let i=[...this.triangles],r=(l,c)=>Math.abs(this.at(this.sample(l),e)-this.at(this.sample(c),e)),s=(l,c)=>Math.hypot(...[0,1].map(h=>(this.wavevector(l)[h]??0)-(this.wavevector(c)[h]??0))),o=new Map,a=new Set;return this.triangles.forEach((l,c)=>l.forEach((h,d)=>{let[f=0,p=0]=[l[(d+1)%3],l[(d+2)%3]],m=`${Math.min(f,p)} ${Math.max(f,p)}`,[_,v]=o.get(m)??[-1,-1];o.set(m,[c,h]),!(_<0||a.has(c)||a.has(_))&&(s(h,v)>(1+dD)*s(f,p)||r(h,v)>=r(f,p)||([i[c],i[_]]=[[h,v,f],[h,v,p]],a.add(c).add(_)))})),this.meshes.set(e,i),i}range(e){let t=Array.from({length:this.frequency.length/this.bands},(i,r)=>this.at(r,e));return[Math.min(...t),Math.max(...t)]}levels(e,t){let[i,r]=this.range(e),s=Array.from({length:this.count},(a,l)=>this.errorAt(l,e)),o=Math.max(...s);return pD(i,r,t).filter(a=>a-i>o&&r-a>o)}get count(){return this.frequency.length/this.bands}highest(e){return this.all.reduce((t,i)=>this.at(this.sample(i),e)>this.at(this.sample(t),e)?i:t,0)}nearest([e,t]){let i=r=>Math.hypot(this.wavevector(r)[0]-e,this.wavevector(r)[1]-t);return this.all.reduce((r,s)=>i(s)<i(r)?s:r,0)}next(e,t,i){let[r,s]=this.wavevector(e),[o,a]=[e,1/0];for(let l of this.all){let[c,h]=[this.wavevector(l)[0]-r,this.wavevector(l)[1]-s],d=Math.hypot(c,h),f=(c*t+h*i)/d;d>1e-9*this.reach&&f>fD&&d/f**2<a&&([o,a]=[l,d/f**2])}return o}contour(e,t){let i=[];for(let r of this.mesh(e)){let s=[];r.forEach((o,a)=>{let l=r[(a+1)%3]??0,[c,h]=[this.at(this.sample(o),e),this.at(this.sample(l),e)];if(c<t==h<t)return;let d=(t-c)/(h-c),[f,p]=[this.wavevector(o),this.wavevector(l)];s.push([f[0]+d*(p[0]-f[0]),f[1]+d*(p[1]-f[1])])}),s[0]&&s[1]&&i.push([s[0],s[1]])}return i}get all(){return Array.from(this.samples,(e,t)=>t)}};function pD(n,e,t){if(!(e>n))return[];let i=10**Math.floor(Math.log10((e-n)/t)),r=i*(hD.find(o=>o*i*t>=e-n)??10),s=Math.ceil(n/r);return Array.from({length:Math.floor(e/r)-s+1},(o,a)=>(s+a)*r)}var gS=440,mD=26,vS=8,gD=-5*Math.PI/8,vf=34;function _S({diagram:n,choice:e}){return n.data.has("zone_wavevector")?u(vD,{diagram:n,choice:e}):null}function vD({diagram:n,choice:e}){let t=Ge(()=>new gf(n.data),[n]),i=Ge(()=>({image:re(t.highest(e.point.peek().band))}),[t,e]),r=Ge(()=>_D(n,t,i,e),[n,t,i,e]),s=Ge(()=>Ve(()=>t.motion(i.image.value,e.point.value.band)),[t,i,e]),{band:o}=e.point.value;return u("section",{"aria-label":"Brillouin zone",class:"pair",children:[u("div",{children:[u(Hn,{label:"Brillouin zone. Arrow keys move the wavevector, page keys change the band.",describedBy:"zone-point",onKeyDown:a=>{Vr(a,r),a.defaultPrevented&&a.stopPropagation()},children:u(yD,{zone:t,band:o,own:i,unit:e.unit.value})}),u("p",{class:"axes",children:u("label",{children:["Band"," ",u("select",{value:o+1,onChange:({currentTarget:a})=>e.point.value={...e.point.value,band:a.selectedIndex},children:Array.from({length:n.bands},(a,l)=>u("option",{children:l+1}))})]})}),u(MD,{zone:t,diagram:n,band:o,unit:e.unit.value}),u(TD,{diagram:n,zone:t,own:i,choice:e})]}),t.hasModes&&u("div",{children:[u(ff,{data:n.data,choice:e,motion:s,name:"zone-mode"}),u("p",{class:"sides",children:u(Ho,{playing:e.playing})})]})]})}function _D(n,e,t,i){let r=o=>()=>i.point.value=ah(n,i.point.value,0,o),s=(o,a)=>()=>t.image.value=e.next(t.image.value,o,a);return[{keys:"arrows",effect:"next wavevector",actions:{ArrowLeft:s(-1,0),ArrowRight:s(1,0),ArrowUp:s(0,1),ArrowDown:s(0,-1)}},{keys:"page up, page down",effect:"next higher or lower band",actions:{PageUp:r(1),PageDown:r(-1)}}]}function yD({zone:n,band:e,own:t,unit:i}){let r=Ke(null),s=t.image.value,o=()=>{r.current!==null&&xD(r.current,n,e,s,i)};Li(o),mt(()=>{let l=r.current?.parentElement;if(!l)return;let c=new ResizeObserver(()=>a.current());c.observe(l);let h=Qn(()=>a.current());return()=>{c.disconnect(),h()}},[]);let a=Ke(o);return a.current=o,u("div",{class:"map zone",children:u("canvas",{ref:r,role:"img","aria-label":`Frequency of band ${e+1} over the zone`,onClick:({offsetX:l,offsetY:c,currentTarget:h})=>{let{toWavevector:d}=yS(h,n);t.image.value=n.nearest(d(l,c))}})})}function yS(n,e){let t=n.clientWidth,i=(t-2*mD)/(2*e.reach);return{toPixel:([r,s])=>[t/2+i*r,t/2-i*s],toWavevector:(r,s)=>[(r-t/2)/i,(t/2-s)/i]}}function xD(n,e,t,i,r){let s=Math.min(n.parentElement?.clientWidth??gS,gS);if(s===0)return;n.style.width=n.style.height=`${s}px`,n.width=n.height=Math.round(s*devicePixelRatio);let o=n.getContext("2d");if(o===null)return;o.scale(devicePixelRatio,devicePixelRatio);let{toPixel:a}=yS(n,e);mS(o,e,t,a),o.strokeStyle="#ffffff",o.lineWidth=1,o.beginPath();let l=e.levels(t,vS).map(h=>({level:h,segments:e.contour(t,h)}));for(let[h,d]of l.flatMap(({segments:f})=>f))o.moveTo(...a(h)),o.lineTo(...a(d));o.stroke(),bD(o,l,a,r),wD(o,e,a);let c=e.hasModes?e.velocity(i,t):void 0;c!==void 0&&Math.hypot(...c)>e.velocityError(i,t)&&SD(o,a(e.wavevector(i)),c),o.beginPath(),o.arc(...a(e.wavevector(i)),5,0,2*Math.PI),o.fillStyle=Xe("accent"),o.strokeStyle="#ffffff",o.lineWidth=2,o.fill(),o.stroke(),n.dataset.shown=`${i},${t}`,Object.assign(n,{zone:e})}function bD(n,e,t,i){let r=[t([0,0])];n.save(),n.font="12px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.fillStyle="#ffffff",n.strokeStyle=bo,n.lineWidth=3,n.lineJoin="round";for(let{level:s,segments:o}of e){let a=o.map(([[p,m],[_,v]])=>[(p+_)/2,(m+v)/2]),l=([p,m])=>Math.abs(Math.atan2(m,p)-gD),c=a.reduce((p,m)=>p!==null&&l(p)<=l(m)?p:m,null);if(c===null)continue;let[h,d]=t(c);if(r.some(([p,m])=>Math.abs(p-h)<34&&Math.abs(m-d)<14))continue;r.push([h,d]);let f=Zs(Number((s/i.factor).toPrecision(5)));n.strokeText(f,h,d),n.fillText(f,h,d)}n.restore()}function SD(n,[e,t],[i,r]){let s=Math.hypot(i,r),[o,a]=[i/s,-r/s],l=(c,h)=>[e+c*o-h*a,t+c*a+h*o];for(let[c,h]of[["#ffffff",5],[Xe("accent"),2.5]])n.strokeStyle=c,n.lineWidth=h,n.beginPath(),n.moveTo(e,t),n.lineTo(...l(vf,0)),n.moveTo(...l(vf-8,5)),n.lineTo(...l(vf,0)),n.lineTo(...l(vf-8,-5)),n.stroke()}function wD(n,e,t){n.strokeStyle=Xe("carrier"),n.setLineDash([5,4]),n.lineWidth=1.5,n.beginPath();for(let s of Object.values(e.corners))n.lineTo(...t(s));n.closePath(),n.stroke(),n.setLineDash([]),n.font="15px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle",n.lineWidth=3,n.lineJoin="round";let i=Object.values(e.corners),r=[0,1].map(s=>i.reduce((o,a)=>o+(a[s]??0),0)/i.length);for(let[s,o]of Object.entries(e.corners)){let[a,l]=t(o),[c,h]=[Math.sign(o[0]-(r[0]??0)),Math.sign(o[1]-(r[1]??0))],d=Math.hypot(...o)<1e-6*e.reach;n.strokeStyle=d?bo:Xe("paper"),n.fillStyle=d?"#ffffff":Xe("ink"),n.strokeText(s,a+13*c,l-13*h),n.fillText(s,a+13*c,l-13*h)}}function MD({zone:n,diagram:e,band:t,unit:i}){let[r="",s=""]=n.range(t).map(l=>Hr(Number((l/i.factor).toPrecision(4)))),o=n.levels(t,vS),a=((o[1]??0)-(o[0]??0))/i.factor;return u(xo,{colours:n.colours,ends:[r,s],children:[Yt("frequency",i)," of band ",t+1," of ",e.bands,o.length>1&&`; contours every ${Number(a.toPrecision(4))}`]})}function TD({diagram:n,zone:e,own:t,choice:i}){let[r,s,o]=[t.image.value,i.wavevectorUnit.value,i.unit.value],{band:a}=i.point.value,[l,c]=e.wavevector(r).map(m=>Number((m/s.factor).toFixed(3))),h=e.sample(r),d=m=>Ht(e.at(h,m)/o.factor,e.errorAt(h,m)/o.factor),[f,p]=e.phases(h).map(m=>Number((m/Math.PI).toFixed(4)));return u("div",{class:"facts",children:[u("p",{id:"zone-point","aria-live":"polite",children:["Band ",a+1," at ",Di(`(${l}, ${c})`)," ",s.name,": ",u("b",{children:Kn(d(a),o)})]}),e.hasModes&&u(ot,{children:[u(_i,{facts:ED(n,e,r,a)}),u("p",{class:"again",children:["The arrow in the zone is the direction of the group velocity. Bands and modes are computed at ",e.count," ","wavevectors of the irreducible zone; a click selects the nearest one or its image."]})]}),u("details",{children:[u("summary",{children:"Frequencies of all bands at this wavevector"}),u("div",{class:"wide",children:u("table",{children:[u("caption",{children:"Frequencies at this wavevector"}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"band"}),u("th",{scope:"col",children:Yt("frequency",o)})]})}),u("tbody",{children:Array.from({length:e.bands},(m,_)=>u("tr",{"aria-current":_===a?"true":void 0,children:[u("td",{children:_+1}),u("td",{children:d(_)})]}))})]})})]}),u("p",{class:"again",children:["Its modes as a picture: ",u("code",{children:['haptonic bands STUDY --modes-at "',f,", ",p,'"']})]})]})}function ED(n,e,t,i){let[{motion:r,symmetry:s},o]=[e.described(t,i),e.velocity(t,i)];return[["motion",n.motion(r)],["symmetry",s],["group velocity",o?Gu(o,e.velocityError(t,i)):"not defined"]]}function bS(n,e){return u(CD,{data:n,host:e})}var AD="Displacements are relative to the largest of their mode; each error bounds the distance to the exact frequency of the model.";function CD({data:n,host:e}){let t=Ge(()=>new ih(n),[n]),i=Ge(()=>Ky(t),[t.rows,t.bands]),r=Ge(()=>RD(t,i),[t,i]),s=Ge(()=>Gy(e?.turned),[e]),o=()=>{let _=s.layer.peek()??rh(t);i.held.value!==null?i.held.value=null:!_.areGapsPreview&&!s.isWaiting.peek()&&(i.held.value={layer:_,gaps:_.gaps,carrier:t.carrier,design:e?.design()??{}})},a=Ge(()=>jy(t,i,e&&o),[t,i,e]),l=s.layer.value,c=s.isWaiting.value?"earlier design":PD(l),h=s.isWaiting.value||l!==null,d=i.held.value,{carrier:f}=t,p=t.units.find(({name:_})=>_===i.unit.value.name)??i.unit.value,m=(l??t).gaps;return u(ui,{name:"bands",data:n,keys:a,foot:AD,isOld:h,children:[u("div",{class:"insight",children:[e?.controls,u("span",{class:`kind ${c}`,children:c}),e&&u("button",{type:"button",class:"minor","aria-label":"Hold this design","aria-pressed":d!==null,disabled:c!=="certified"&&d===null,onClick:o,children:"Hold"}),c==="earlier design"?u("p",{children:[e?.turned.value?.preview?"Too far for a preview.":"No preview yet."," Certified curves follow."]}):u($y,{gaps:m,carrier:f,unit:p})]}),u("div",{class:"pair",children:[u("section",{"aria-label":"Band diagram",children:[u(Hn,{label:"Band diagram. Arrow keys move along the path and between bands.",children:u(Vy,{diagram:t,choice:i,newer:s})}),u("p",{class:"axes",children:[u(er,{title:"Frequencies in",units:t.units,unit:i.unit}),u(er,{title:"Wavevectors in",units:t.wavevectorUnits,unit:i.wavevectorUnit}),u(ID,{diagram:t,isPreview:c==="preview",isHeld:d!==null})]}),d!==null&&e&&c!=="earlier design"&&u(Yy,{held:d,now:{gaps:m,carrier:f,design:e.design()},unit:p,isPreview:c!=="certified",drop:o})]}),u("section",{"aria-label":"Mode",children:[u(ff,{data:n,choice:i,motion:r,name:"mode"}),u(LD,{diagram:t,choice:i,isOld:h}),u(DD,{choice:i})]})]}),u(_S,{diagram:t,choice:i}),u(xi,{listing:i.listing,keys:a,children:[u(hS,{diagram:t,unit:i.unit.value}),u(dS,{diagram:t,choice:i})]})]})}function PD(n){return n===null||!n.areGapsPreview?"certified":n.isPreview?"preview":"preview of gaps"}function RD(n,e){return Ve(()=>{let{row:t,band:i}=e.point.value;return{of:"path",row:t,band:i,kappa:n.phases(t),turn:cS,isReversed:!1}})}function ID({diagram:n,isPreview:e,isHeld:t}){return u("span",{class:"legend",children:[n.gaps.some(i=>i.complete)&&u("span",{class:"of-gap",children:"complete gap"}),n.gaps.some(i=>i.waves!=="all")&&u("span",{class:"of-parity",children:"gap of one parity"}),n.carrier!==void 0&&u("span",{class:"of-carrier",children:"carrier"}),e&&u("span",{class:"of-preview",children:"preview with its error"}),t&&u("span",{class:"of-held",children:"held design"})]})}function LD({diagram:n,choice:e,isOld:t}){let i=e.point.value,r=e.unit.value,s=n.velocity(i),o=[["motion",n.nature(i)],["symmetry",n.parity(i)],["group velocity",s?Gu(s,n.velocityError(i)):"not defined"]],a=n.place(i.row);return u("div",{class:"facts",children:[u("p",{id:"point","aria-live":"polite",children:["Band ",i.band+1," at ",a,t&&", earlier design",": ",u("b",{children:Kn(Ht(n.at(i)/r.factor,n.errorAt(i)/r.factor),r)})]}),u(_i,{facts:o}),u("p",{class:"again",children:["The same mode as a picture: ",u("code",{children:['haptonic bands STUDY --modes-at "',a,'"']})," or, in Python,"," ",u("code",{children:['study.bands(modes_at="',a,'").plot("modes")']})]})]})}function DD({choice:n}){let[e,t]=n.copies.value;return u("div",{class:"controls",children:[u(Ho,{playing:n.playing}),u("label",{children:["largest displacement, share of the period: ",n.swing.value.toFixed(2),u("input",{type:"range",min:"0",max:oh,step:"0.01",value:n.swing.value,onInput:i=>n.swing.value=Number(i.currentTarget.value)})]}),u(uc,{pace:n.pace}),u("label",{children:["cells along a1",u("input",{type:"number",min:"1",max:sh,value:e,onChange:i=>n.copies.value=[xS(i.currentTarget.value),t]})]}),u("label",{children:["cells along a2",u("input",{type:"number",min:"1",max:sh,value:t,onChange:i=>n.copies.value=[e,xS(i.currentTarget.value)]})]})]})}function xS(n){let e=Math.round(Number(n));return Number.isFinite(e)?Math.min(Math.max(e,1),sh):1}function Cr(n){let{x:e,curves:t,titles:i,height:r,limits:s,whole:o}=n,a=Ke(null),l=Ke(n);l.current=n;let c=Ke(null);return Li(()=>{let h=a.current;if(h===null)return;let d=()=>({width:$r(h),height:r}),f=new tn({...d(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!0,y:!0,uni:20}},scales:{x:{time:!1,range:(p,m,_)=>m===null?s?.x??[0,1]:[m,_]},y:{range:(p,m,_)=>m===null?s?.y??[0,1]:[m,_]}},axes:[{...yr(),label:i[0],labelSize:22,size:34,...o?{incrs:[1,2,5,10]}:{}},{...Xr(),label:i[1]}],series:[{},...t.map(({colour:p,dash:m,width:_,points:v})=>({...xs,stroke:()=>Xe(p),fill:()=>"transparent",dash:m??[],width:v?0:_??1.4,points:v?{show:!0,size:4,fill:()=>Xe(p),width:0}:{show:!1}}))],hooks:{drawClear:[p=>Kr(p,()=>l.current.below?.(p))],draw:[p=>Kr(p,()=>l.current.above?.(p))]}},[e,...t.map(({values:p})=>p)],h);return s?.x&&f.setScale("x",{min:s.x[0],max:s.x[1]}),s?.y&&f.setScale("y",{min:s.y[0],max:s.y[1]}),to(f,(p,m)=>l.current.pick?.(f.posToVal(p,"x"),f.posToVal(m,"y"),f)),c.current=f,Yr(f,h,d,[])},[e,t,i[0],i[1]]),Li(()=>c.current?.redraw(!1,!1)),u("div",{class:"curves",ref:a})}var wo=class n{constructor(e,t,i,r){this.canvas=e;this.context=t;this.small=i;this.inner=r;this.image=new ImageData(i.width,i.height)}canvas;context;small;inner;image;static on(e,t,i){let r=new OffscreenCanvas(t,i),[s,o]=[e.getContext("2d"),r.getContext("2d")];return s===null||o===null?null:new n(e,s,r,o)}show(e){let{canvas:t,context:i}=this;this.inner.putImageData(this.image,0,0),i.clearRect(0,0,t.width,t.height),i.imageSmoothingEnabled=e,i.imageSmoothingQuality="high",i.drawImage(this.small,0,0,t.width,t.height)}follow(e,t){let{canvas:i}=this,r=()=>{let o=Math.min(i.parentElement?.clientWidth??300,.62*innerHeight/e);i.style.width=`${o}px`,i.style.height=`${o*e}px`,i.width=Math.round(o*devicePixelRatio),i.height=Math.round(o*e*devicePixelRatio),t()},s=new ResizeObserver(r);return i.parentElement!==null&&s.observe(i.parentElement),()=>s.disconnect()}};function Ll({grid:n,part:e,wave:t,pace:i,label:r,shown:s,name:o,caption:a}){let l=Ke(null);return mt(()=>l.current===null?void 0:ND(l.current,new i0(n,e),t,i),[n,e,t,i]),u("div",{class:"map",children:[u("canvas",{ref:l,role:"img","aria-label":r}),u(xo,{colours:n.colours,ends:["−1","1"],children:s}),u(Qa,{canvas:l,name:o,caption:a})]})}function ND(n,e,t,i){let r=wo.on(n,e.columns,e.rows);if(r===null)return()=>{};let s={frames:0,painter:e},o=()=>{s.frames++,e.paint(r.image,t.peek(),a.moment),r.show(!0);for(let c of t.peek().edges??[]){let h=(1-c)*n.height;eo(r.context,[0,h],[n.width,h],"quiet",[6,5])}n.dataset.shown=String(t.peek().number)},a=new no(i,o,n);ja(n,c=>a.at(c)),Object.assign(n,{counted:s});let l=[r.follow(e.ratio,o),Je(()=>{t.value,o()}),Qn(o)];return()=>{a.end();for(let c of l)c()}}var i0=class{constructor(e,t){this.grid=e;this.part=t;let{repeats:i=1,periods:r}=t;this.columns=r*e.along,this.rows=i*e.across,this.ratio=i*e.width/(r*e.length)}grid;part;columns;rows;ratio;paint(e,{number:t,phase:i,decay:r},s){let{real:o,imag:a,present:l,across:c,along:h,colours:d}=this.grid,f=(d.length-1)/2,p=t*c*h;for(let m=0;m<this.columns;m++){let _=Math.floor(m/h),v=2*Math.PI*s+_*i,g=Math.exp(-_*r),[x,A]=[g*Math.cos(v),g*Math.sin(v)],S=Math.round(_*(this.part.slip??0)*c);for(let P=0;P<this.rows;P++){let y=((P-S)%c+c)%c*h+m%h,T=(o[p+y]??0)*x-(a[p+y]??0)*A,U=Math.min(Math.max(Math.round(f+T),0),2*f),[D=0,L=0,B=0]=d[U]??[],G=4*((this.rows-1-P)*this.columns+m);e.data.set([D,L,B,l[y]===0?0:255],G)}}}};var FD=12,_f=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;[this.count=0]=e.shape("frequency"),this.best=Number(t.best),this.mode=String(i.mode),this.ends=String(i.ends),this.frequencyError=Number(i.relative_frequency_error),this.units=ji(e),this.period=Number(i.period);let[,r=0,s=0]=e.shape("mode_real"),[o=0,a=0]=e.values("across");this.fields={grid:{real:e.values("mode_real"),imag:e.values("mode_imag"),present:e.values("present"),across:r,along:s,width:(a-o)*r,length:this.period,colours:t.colours},part:{periods:FD}}}data;count;best;mode;ends;frequencyError;units;fields;period;value(e,t){return this.data.values(e)[t]??NaN}wave(e){let t=.5*this.value("width",e)/this.fields.grid.width;return{number:e,phase:this.value("phase",e),decay:0,edges:[.5-t,.5+t]}}profile(e){let{real:t,imag:i,across:r,along:s}=this.fields.grid,o=Array.from({length:r},(l,c)=>{let h=(e*r+c)*s,d=0;for(let f=h;f<h+s;f++)d+=(t[f]??0)**2+(i[f]??0)**2;return Math.sqrt(d)}),a=Math.max(...o);return{position:Array.from(this.data.values("across")),size:o.map(l=>l/a)}}};function SS(n){return u(UD,{data:n})}function UD({data:n}){let e=Ge(()=>new _f(n),[n]),t=Ge(()=>({guide:re(e.best),unit:re(Qi(e.units,e.value("frequency",e.best))),...Zr(),listing:re("none")}),[e]),i=Ge(()=>kD(e,t),[e,t]),r=Ge(()=>Ve(()=>e.wave(t.guide.value)),[e,t]),{grid:s,part:o}=e.fields;return u(ui,{name:"guides",data:n,keys:i,foot:OD(e),children:[u("div",{class:"pair",children:[u("section",{"aria-label":"Waveguides",children:[u(Hn,{label:"Waveguides. Arrow keys select another length.",children:[e.count>1&&u(BD,{guides:e,choice:t}),u(GD,{guides:e,choice:t})]}),u("p",{class:"axes",children:u(er,{title:"Frequencies in",units:e.units,unit:t.unit})}),u(VD,{guides:e,choice:t})]}),u("section",{"aria-label":"Mode",children:[u(Ll,{grid:s,part:o,wave:r,pace:t,label:"Field of the guided mode, the strip from left to right between rows of the lattice",shown:"normal displacement; 1 is the largest; dashed: edges of the strip",name:"waveguide",caption:`${n.header.title}, ${mr(n)}`}),u(Ba,{...t})]})]}),u(xi,{listing:t.listing,keys:i,children:u(HD,{guides:e,choice:t})})]})}function OD(n){return`Frequencies of the lattice have errors of up to ${(100*n.frequencyError).toPrecision(2)} %, which move all frequencies of the waveguides alike; the conditions at their ${n.ends} ends are approximate. The field is the displacement normal to the flat face, of a wave that travels to the left; two opposite ones form the mode of the strip. Dashed lines are the edges of the strip.`}function kD(n,e){let t=i=>()=>e.guide.value=Math.min(Math.max(e.guide.value+i,0),n.count-1);return[{keys:"← →",effect:"next shorter or longer waveguide",actions:{ArrowLeft:t(-1),ArrowRight:t(1)}},{keys:"b",effect:"waveguide nearest to the carrier",actions:{b:()=>e.guide.value=n.best}},Gr(e),...yi(e.listing)]}function BD({guides:n,choice:e}){let t=Ge(()=>Array.from({length:n.count},(h,d)=>d),[n]),[i,r]=Ge(()=>["length","width"].map(h=>t.map(d=>1e3*n.value(h,d))),[n,t]),s=Ge(()=>[{values:r,colour:"quiet",dash:[2,4]}],[r]),o=(h,d)=>[Math.min(...h)-d,Math.max(...h)+d],a=e.guide.value,l=h=>{for(let d of t){let f=[h.valToPos(i[d]??0,"x",!0),h.valToPos(r[d]??0,"y",!0)];ys(h.ctx,f,d===a?"accent":"quiet",d===a?6:4)}},c=.08*(Math.max(...r)-Math.min(...r))||1;return u(Cr,{x:i,curves:s,titles:["length / mm","width / mm"],height:240,limits:{x:o(i,500*n.period),y:o(r,c)},above:l,pick:h=>e.guide.value=zD(i,h)})}function zD(n,e){return n.reduce((t,i,r)=>Math.abs(i-e)<Math.abs((n[t]??NaN)-e)?r:t,0)}function GD({guides:n,choice:e}){let t=e.guide.value,{position:i,size:r}=Ge(()=>n.profile(t),[n,t]),s=Ge(()=>i.map(l=>1e3*l),[i]),o=Ge(()=>[{values:r,colour:"accent",width:2}],[r]),a=500*n.value("width",t);return u(Cr,{x:s,curves:o,titles:["from the middle of the strip / mm","rms over its peak"],height:220,limits:{x:[s[0]??0,s[s.length-1]??1],y:[0,1.05]},below:l=>{Zo(l,[s[0]??0,-a],"panel"),Zo(l,[a,s[s.length-1]??0],"panel")},above:l=>[-a,a].forEach(c=>Qs(l,c,"ink",[4,4]))},t)}function VD({guides:n,choice:e}){let[t,i]=[e.guide.value,e.unit.value],r=(o,a)=>`${(1e3*n.value(o,t)).toFixed(a)} mm`,s=[["width",r("width",2)],["length",`${r("length",1)}, ${n.value("rows",t)} cells`],["distance of nodal lines",r("nodal_spacing",3)],["amplitude at the edge",`${(100*n.value("amplitude_at_edge",t)).toFixed(1)} % of the peak`],["decay in the lattice",`${MS(n,t)} dB per row`]];return u("div",{class:"facts",children:[u("p",{id:"point","aria-live":"polite",children:["Mode ",n.mode,", ",n.value("rows",t)," cells long: ",u("b",{children:Kn(wS(n,t,i),i)})]}),u(_i,{facts:s})]})}function wS(n,e,{factor:t}){let i=n.value("frequency",e)/t;return Ht(i,n.frequencyError*i)}var MS=(n,e)=>Ht(n.value("decay",e),n.value("decay_error",e));function HD({guides:n,choice:e}){let t=e.unit.value;return u("div",{class:"wide",children:u("table",{children:[u("caption",{children:["Waveguides for mode ",n.mode]}),u("thead",{children:u("tr",{children:["cells","length / mm","width / mm",Yt("frequency",t),"decay / (dB/row)","edge / peak","show"].map(i=>u("th",{scope:"col",children:i}))})}),u("tbody",{children:Array.from({length:n.count},(i,r)=>u("tr",{"aria-current":r===e.guide.value?"true":void 0,children:[u("td",{children:n.value("rows",r)}),u("td",{children:(1e3*n.value("length",r)).toFixed(1)}),u("td",{children:(1e3*n.value("width",r)).toFixed(2)}),u("td",{children:wS(n,r,t)}),u("td",{children:MS(n,r)}),u("td",{children:n.value("amplitude_at_edge",r).toFixed(3)}),u("td",{children:u("button",{type:"button",onClick:()=>e.guide.value=r,children:[n.value("rows",r)," cells"]})})]}))})]})})}var WD=n=>`${(100*n).toFixed(0)} %`,qD=250,TS=1e6,XD=["low","high","value"];function ES({data:n,finger:e}){let t=Ke(null);return Li(()=>{if(t.current!==null)return $D(t.current,n,e)},[n,e]),u(ot,{children:[u("div",{class:"curves",ref:t}),u("p",{class:"legend",children:[u("span",{class:"of-curve",children:[u("svg",{width:"34",height:"8","aria-hidden":"true",children:u("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:"var(--curve-0)"})})," ","model"]}),u("span",{class:"of-gap",children:"its interval"}),u("span",{class:"of-carrier",children:["just noticed, ",WD(n.extra.weber)," less friction"]})]})]})}function $D(n,e,t){let i=Array.from(e.amplitudes,l=>l*TS),r=()=>[i,...XD.map(l=>Array.from(t.law.value[l]))],s=()=>({width:$r(n),height:qD}),o={...xs,width:0,points:{show:!1}},a=new tn({...s(),legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1,distr:3},y:{range:[0,1.02]}},bands:[{series:[2,1],fill:()=>Xe("gap")}],axes:[{...yr(),label:`${e.data.title("table")} / µm`,labelSize:22,size:34,values:(l,c)=>c.map(h=>Number.isInteger(Math.round(1e6*Math.log10(h))/1e6)?String(h):"")},{...Xr(),label:e.data.title("load_sharing")}],series:[{},o,o,{...xs,stroke:()=>Xe("curve-0"),width:2,points:{show:!1}}],hooks:{draw:[l=>YD(l,e,t)]}},r(),n);return Yr(a,n,s,[Je(()=>a.setData(r())),Je(()=>{t.below.value,a.redraw(!1,!1)})])}function YD(n,e,t){let{ctx:i,bbox:r,valToPos:s}=n,{amplitude:o,friction:a}=t.below.peek(),[l,c]=[s(Math.max(o.value*TS,.001),"x",!0),s(a.value,"y",!0)];Za(n,1-e.extra.weber,"carrier",[7,5]),eo(i,[l,r.top],[l,r.top+r.height],"accent"),i.save(),i.fillStyle=Xe("accent"),i.beginPath(),i.arc(l,c,5*devicePixelRatio,0,2*Math.PI),i.fill(),i.restore()}var AS=["value","low","high"],yf=class{constructor(e){this.data=e;this.extra=e.header.extra,this.forces=e.values("force"),this.speeds=e.values("speed"),this.amplitudes=e.values("table"),this.x=e.values("x"),this.y=e.values("y"),this.columns=[...new Set(this.x)].sort((r,s)=>r-s),this.rows=[...new Set(this.y)].sort((r,s)=>r-s),this.cells=new Int32Array(this.columns.length*this.rows.length).fill(-1);let[t,i]=[this.columns,this.rows].map(r=>new Map(r.map((s,o)=>[s,o])));this.x.forEach((r,s)=>{this.cells[(i?.get(this.y[s]??0)??0)*this.columns.length+(t?.get(r)??0)]=s})}data;extra;forces;speeds;amplitudes;x;y;columns;rows;cells;get count(){return this.x.length}placeIn(e,t){if(t<0||t>=this.columns.length)return null;let i=this.cells[e*this.columns.length+t]??-1;return i<0?null:i}nearest([e,t]){let[i,r]=[0,1/0];for(let s=0;s<this.count;s++){let o=((this.x[s]??0)-e)**2+((this.y[s]??0)-t)**2;o<r&&([i,r]=[s,o])}return i}beside(e,t,i){let[r,s]=[this.rows.indexOf(this.y[e]??0),this.columns.indexOf(this.x[e]??0)];return this.placeIn(r+i,s+t)??e}region(e){return this.data.texts("region")[e]||"a lattice"}amplitude(e,t,i){let r=this.data.texts("load").indexOf(t);return i*(this.data.values("amplitude")[r*this.count+e]??0)}law(e,t){let i=this.amplitudes.length,r=this.data.texts("end"),s=(d,f)=>{let p=this.data.values(d);return m=>{let _=(f*r.length+r.indexOf(m))*i;return p.subarray(_,_+i)}},[o,a]=[s("load_sharing",e),s("intermittent",t)],l=[o("value"),a("value")],c=(d,f)=>{let p=[o(d),a(d),...l];return Float64Array.from(p[0]??[],(m,_)=>{let v=p.map(g=>g[_]??NaN).filter(g=>!Number.isNaN(g));return v.length>0?f(...v):NaN})};return{value:Float64Array.from(l[0]??[],(d,f)=>Number.isNaN(d)?l[1]?.[f]??NaN:d),low:c("low",Math.min),high:c("high",Math.max)}}friction(e,t){let[i=1,r=1]=[this.amplitudes[0],this.amplitudes.at(-1)],s=e.length-1,o=Math.log(Math.max(t,i)/i)/Math.log(r/i)*s,a=Math.min(Math.floor(o),s-1),l=Math.min(o-a,1);return(e[a]??NaN)*(1-l)+(e[a+1]??NaN)*l}};function CS(n,e){return n.low>e?"noticed, also at the lower limit":n.value>e?"probably noticed, but not at the lower limit":n.high>e?"probably not noticed, except at the upper limit":"not noticed, even at the upper limit"}function PS({data:n,finger:e}){let t=Ke(null);return mt(()=>{if(t.current!==null)return KD(t.current,n,e)},[n,e]),u("div",{class:"map",children:[u("canvas",{ref:t,role:"img","aria-label":"Map of the reduction of friction"}),u(xo,{colours:n.extra.colours,ends:["0","100 %"],children:"less friction below a finger with its middle there, model"})]})}function KD(n,e,t){let[i,r]=[e.columns,e.rows],s=wo.on(n,i.length,r.length);if(s===null)return()=>{};let{image:o,context:a}=s,[l,c]=[i,r].map(m=>ZD(m)),h=([m,_])=>[n.width*(m-l[0])/(l[1]-l[0]),n.height*(c[1]-_)/(c[1]-c[0])],d=()=>{let{colours:m}=e.extra,[_,v]=[t.law.peek(),t.drive.peek()];r.forEach((g,x)=>i.forEach((A,S)=>{let P=e.placeIn(x,S),C=4*((r.length-1-x)*i.length+S);if(o.data[C+3]=P===null?0:255,P===null)return;let y=1-e.friction(_.value,e.amplitude(P,"value",v));(m[Math.round(Math.min(Math.max(y,0),1)*(m.length-1))]??[]).forEach((U,D)=>o.data[C+D]=U)}))},f=()=>{s.show(!0),JD(a,e,h),jD(a,e,t.place.peek(),h),n.dataset.shown=String(t.place.peek())},p=[s.follow((c[1]-c[0])/(l[1]-l[0]),f),Je(()=>{t.law.value,t.drive.value,d(),f()}),Je(()=>{t.place.value,f()}),Qn(f),QD(n,([m,_])=>{let v=[l[0]+m*(l[1]-l[0]),c[1]-_*(c[1]-c[0])];t.place.value=e.nearest(v)})];return()=>{for(let m of p)m()}}function ZD(n){let[e=0,t=e+.001]=n,i=(t-e)/2;return[e-i,(n.at(-1)??0)+i]}function JD(n,{extra:e},t){n.lineWidth=1.2*devicePixelRatio,n.strokeStyle="#ffffff";for(let i of Object.values(e.regions).flat())rs(n,i,t);n.strokeStyle=Xe("quiet");for(let i of e.plate)rs(n,i,t);n.strokeStyle="#ffffff",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[i,r,s,o]of Object.values(e.patches))rs(n,So([i,r],[s,o]),t);n.setLineDash([]);for(let[i,r]of Object.entries(e.regions))Il(n,i,r,t)}function jD(n,e,t,i){let r=[e.x[t]??0,e.y[t]??0],[s,o]=i(r),a=i([r[0]+e.extra.diameter/2,r[1]])[0]-s;for(let[l,c]of[["#ffffff",5],[bo,2]])n.strokeStyle=l,n.lineWidth=c*devicePixelRatio,n.beginPath(),n.arc(s,o,a,0,2*Math.PI),n.moveTo(s-4*devicePixelRatio,o),n.lineTo(s+4*devicePixelRatio,o),n.moveTo(s,o-4*devicePixelRatio),n.lineTo(s,o+4*devicePixelRatio),n.stroke()}function QD(n,e){let t=i=>{if(i.type==="pointerdown")n.setPointerCapture(i.pointerId);else if(i.buttons===0)return;let r=n.getBoundingClientRect();e([(i.clientX-r.left)/r.width,(i.clientY-r.top)/r.height])};return n.addEventListener("pointerdown",t),n.addEventListener("pointermove",t),()=>{n.removeEventListener("pointerdown",t),n.removeEventListener("pointermove",t)}}var eN=5,RS=1.05;function IS(n){let{drive:e,force:t,speed:i}=n.extra,r=re(tN(n)),s={drive:re(e.value),force:re(n.forces.indexOf(t)),speed:re(n.speeds.indexOf(i))};s.force.peek()<0&&(s.force.value=0);let o=Ve(()=>n.law(s.force.value,s.speed.value)),a=Ve(()=>nN(n,o.value,r.value,s.drive.value));return{place:r,...s,listing:re("none"),law:o,below:a}}function tN(n){let e=n.extra.diameter/2,t=(s,o)=>s-e>=(o[0]??0)&&s+e<=(o.at(-1)??0),[i,r]=[0,-1];for(let s=0;s<n.count;s++){let o=n.amplitude(s,"value",1),a=t(n.x[s]??0,n.columns)&&t(n.y[s]??0,n.rows);o>r&&a&&([i,r]=[s,o])}return i}function nN(n,e,t,i){let r=a=>Object.fromEntries(AS.map(l=>[l,a(l)])),s=r(a=>n.amplitude(t,a,i)),o=r(a=>n.friction(e[a],s[a]));return{amplitude:s,free:n.amplitude(t,"free",i),friction:o,reduction:{value:1-o.value,low:1-o.high,high:1-o.low}}}function LS(n,e){let t=(c,h)=>d=>{for(let f=0;f<(d.shiftKey?eN:1);f++)e.place.value=n.beside(e.place.peek(),c,h)},{low:i,high:r}=n.extra.drive,s=c=>()=>e.drive.value=Math.min(Math.max(e.drive.peek()*c,i),r),o=(c,h,d)=>()=>c.value=Math.min(Math.max(c.peek()+h,0),d-1),[a,l]=[n.forces.length,n.speeds.length];return[{keys:"← → ↑ ↓",effect:"move the finger; five places with Shift",actions:{ArrowLeft:t(-1,0),ArrowRight:t(1,0),ArrowUp:t(0,1),ArrowDown:t(0,-1)}},{keys:"+ −",effect:"5 % more or less drive",actions:{"+":s(RS),"-":s(1/RS)}},{keys:"f F",effect:"more or less force",actions:{f:o(e.force,1,a),F:o(e.force,-1,a)}},{keys:"s S",effect:"faster or slower",actions:{s:o(e.speed,1,l),S:o(e.speed,-1,l)}},...yi(e.listing)]}function DS({plate:n,choice:e}){let t=Ke(null);return mt(()=>{if(t.current!==null)return rN([...t.current.querySelectorAll("canvas")],n,e)},[n,e]),u("div",{class:n.fields.length>1?"maps":"",ref:t,children:n.fields.map(i=>u(iN,{plate:n,choice:e,field:i},i.title))})}function iN({plate:n,choice:e,field:t}){let i=Ke(null),r=ha(NS(n,e,t,e.line.value)),s=t.title||mr(n.data);return u("div",{class:"map",children:[t.title&&u("h2",{children:t.title}),u("canvas",{ref:i,role:"img","aria-label":`Map of the moving plate${t.title&&`, ${t.title}`}`}),u(xo,{colours:n.colours,ends:[`−${r}`,r],children:["normal displacement",n.drive]}),u(Qa,{canvas:i,name:"map",caption:`${n.data.header.title}, ${s}`})]})}function NS(n,e,t,i){return n.largest(i,e.common.value?n.fields:[t])}function ha(n){let[e,t]=n>=1e-6?["µm",1e6]:n>=1e-9?["nm",1e9]:["pm",1e12];return`${Number((n*Number(t)).toPrecision(3))} ${e}`}function rN(n,e,t){let{left:i,right:r,bottom:s,top:o}=e.extent,a=e.fields.flatMap((f,p)=>{let m=n[p],_=m===void 0?null:wo.on(m,f.columns,f.rows);return m===void 0||_===null?[]:[{field:f,canvas:m,raster:_,counted:{frames:0}}]}),l=()=>{for(let f of a)c(f)},c=({field:f,canvas:p,raster:m,counted:_})=>{let v=t.line.peek();_.frames++;let g=(e.fields[0]??f).outermost(v)+h.moment;f.paint(m.image,v,g,NS(e,t,f,v)),m.show(!e.data.has("place"));let x=([A,S])=>[p.width*(A-i)/(r-i),p.height*(o-S)/(o-s)];sN(m.context,e,x,t.plan.peek()),p.dataset.shown=String(v)},h=new no(t,l,...n);for(let{canvas:f,counted:p}of a)ja(f,m=>h.at(m)),Object.assign(f,{counted:p});let d=[...a.map(({raster:f})=>f.follow((o-s)/(r-i),l)),Je(()=>{t.line.value,t.plan.value,t.common.value,l()}),Qn(l)];return()=>{h.end();for(let f of d)f()}}function sN(n,e,t,i){let{plate:r,regions:s,patches:o,features:a,held:l}=e.parts;n.strokeStyle=bo,n.lineWidth=1.2*devicePixelRatio;for(let c of Object.values(s).flat())rs(n,c,t);i&&(n.lineWidth=.8*devicePixelRatio,pf(n,a,t),n.stroke(),mf(n,l,t)),n.lineWidth=1.2*devicePixelRatio,n.strokeStyle=Xe("quiet");for(let c of r)rs(n,c,t);n.strokeStyle="#855a12",n.setLineDash([4*devicePixelRatio,3*devicePixelRatio]);for(let[c,h,d,f]of Object.values(o))rs(n,So([c,h],[d,f]),t);n.setLineDash([]);for(let[c,h]of Object.entries(s))Il(n,c,h,t)}var oN="All numbers are of a model, not of a measurement. Amplitudes are root mean squares over the disc below the finger, at the nearest computed place.",aN=500;function OS(n){return u(lN,{dataset:n})}function lN({dataset:n}){let e=Ge(()=>new yf(n),[n]),t=Ge(()=>IS(e),[e]),i=Ge(()=>LS(e,t),[e,t]);return u(ui,{name:"finger",data:n,keys:i,foot:oN,children:[u("div",{class:"pair",children:[u("section",{"aria-label":"Map",children:u(Hn,{label:"Finger on the plate. Arrow keys move it.",describedBy:"felt",children:u(PS,{data:e,finger:t})})}),u("section",{"aria-label":"Friction",children:[u(cN,{data:e,finger:t}),u(ES,{data:e,finger:t}),u(uN,{data:e,finger:t})]})]}),u(xi,{listing:t.listing,keys:i,children:u(hN,{data:e})})]})}function Ds(n,e){let t=Math.abs(n),[i,r]=t>=1||t===0?["",1]:t>=.001?["m",1e3]:["µ",1e6];return`${Number((n*Number(r)).toPrecision(3))} ${i}${e}`}var FS=n=>`${(100*n).toFixed(0)} %`;function cN({data:n,finger:e}){let{amplitude:t,free:i,friction:r,reduction:s}=e.below.value,o=e.place.value,{weber:a,frequency:l,drive:c,diameter:h}=n.extra,d=(p,m,[_,v])=>`${m(p.value)} (${m(p[_])} to ${m(p[v])})`,f=p=>p.toFixed(2);return u("div",{class:"facts",children:[u("p",{id:"felt","aria-live":"polite",children:[u("b",{children:n.region(o)}),", x = ",Ds(n.x[o]??0,"m"),", y = ",Ds(n.y[o]??0,"m"),":"," ",u("b",{children:CS(s,a)})]}),u(_i,{facts:[["μ/μ₀, model",d(r,f,["low","high"])],["less friction",d(s,FS,["low","high"])],["amplitude below the finger",d(t,ha,["high","low"])],["without a finger",ha(i)]]}),u("p",{class:"again",children:["Just noticed: ",FS(a)," less friction. The finger covers ",Ds(h,"m"),";"," ",Number((l/1e3).toFixed(3))," kHz. The same in the study:"," ",u("code",{children:["touch = ","{",' force = "',Ds(n.forces[e.force.value]??0,"N"),'", speed = "',Ds(n.speeds[e.speed.value]??0,"m/s"),'"',c.unit==="V"?`, voltage = "${Ds(e.drive.value,"V")}"`:""," ","}"]})]})]})}function uN({data:n,finger:e}){let{low:t,high:i,title:r,unit:s}=n.extra.drive;return u("div",{class:"controls",children:[u("label",{class:"long",children:["Drive, ",r.toLowerCase(),": ",Ds(e.drive.value,s),u("input",{type:"range",min:t,max:i,step:(i-t)/aN||1,value:e.drive.value,"aria-valuetext":Ds(e.drive.value,s),onInput:o=>e.drive.value=Number(o.currentTarget.value)})]}),u(US,{title:n.data.title("force"),unit:"N",values:n.forces,chosen:e.force}),u(US,{title:n.data.title("speed"),unit:"m/s",values:n.speeds,chosen:e.speed})]})}function US({title:n,unit:e,values:t,chosen:i}){let r=Ds(t[i.value]??0,e);return u("label",{class:"long",children:[n,": ",r,u("input",{type:"range",min:"0",max:t.length-1,step:"1",value:i.value,"aria-valuetext":r,onInput:s=>i.value=Number(s.currentTarget.value)})]})}function hN({data:n}){return u("div",{class:"wide",children:[u("table",{children:[u("caption",{children:"Numbers of the models"}),u("thead",{children:u("tr",{children:["number","value","plausible","origin","source"].map(e=>u("th",{scope:"col",children:e}))})}),u("tbody",{children:n.extra.parameters.map(({title:e,value:t,plausible:i,mark:r,source:s})=>u("tr",{children:[e,t,i,r,s].map(o=>u("td",{children:o}))}))})]}),u("dl",{children:Object.entries(n.extra.models).map(([e,t])=>u("div",{children:[u("dt",{children:["Model of ",e]}),u("dd",{children:t})]}))})]})}var dN="Squares are all participants together, discs are single ones; circles are trials.",[xf,r0,fN,pN]=[24,8,36,16],mN=7.2,kS=300;function BS(n){return u(gN,{data:n})}function gN({data:n}){let e=Ge(()=>xN(n),[n]),t=Ge(()=>[...new Set(e.map(({quantity:l})=>l))],[e]),i=Ge(()=>({quantity:re(t[0]??""),row:re(0),listing:re("none")}),[t]),r=Ge(()=>bN(e,t,i),[e,t,i]),s=e.filter(({quantity:l})=>l===i.quantity.value),o=s[i.row.value],a=n.header.extra.sentences??[];return u(ui,{name:"friction",data:n,keys:r,foot:dN,children:[a.length>0&&u("details",{children:[u("summary",{children:"Estimates, tests and assumptions"}),a.map(l=>u("p",{children:Wr(l)}))]}),u("p",{class:"axes",children:u("label",{children:["Quantity"," ",u("select",{value:i.quantity.value,onChange:l=>{i.quantity.value=l.currentTarget.value,i.row.value=0},children:t.map(l=>u("option",{children:l}))})]})}),u(Hn,{label:"Estimates. Arrow keys go from one to the next.",children:u(vN,{estimates:s,choice:i})}),u("div",{class:"facts",children:u("p",{id:"point","aria-live":"polite",children:o!==void 0&&u(ot,{children:[u("b",{children:o.name}),": ",yN(o),o.note&&`; ${o.note}`]})})}),u(xi,{listing:i.listing,keys:r,children:t.map(l=>u(_N,{title:l,estimates:e.filter(c=>c.quantity===l)}))})]})}function vN({estimates:n,choice:e}){let[t,i]=wN(),r=Math.min(mN*Math.max(...n.map(({name:h})=>h.length),4)+12,.5*i),s=n.flatMap(({value:h,low:d,high:f,trials:p})=>[h,d,f,...p]).filter(Number.isFinite),[o,a]=[Math.min(0,...s),Math.max(...s,.01)],l=h=>r+(h-o)/(a-o)*(i-r-pN),c=r0+xf*n.length;return u("div",{ref:t,children:u("svg",{class:"estimates",width:i,height:c+fN,role:"img","aria-label":`${e.quantity.value}; the table has all numbers`,children:[SN(o,a).map(h=>u(ot,{children:[u("line",{x1:l(h),x2:l(h),y1:r0,y2:c}),u("text",{x:l(h),y:c+16,"text-anchor":"middle",class:"quiet",children:`${h}`.replace("-","−")})]})),u("text",{x:(r+i)/2,y:c+32,"text-anchor":"middle",children:e.quantity.value}),n.map((h,d)=>{let f=r0+xf*(d+.5),{value:p,low:m,high:_,name:v,whole:g,trials:x}=h;return u("g",{class:g?"whole":"",onClick:()=>e.row.value=d,children:[u("rect",{class:e.row.value===d?"chosen":"",x:"1",y:f-xf/2,width:i-2,height:xf,fill:"transparent"}),u("text",{x:r-8,y:f+4,"text-anchor":"end",children:v}),x.map(A=>u("circle",{class:"trial",cx:l(A),cy:f,r:"2.5"})),Number.isFinite(m)&&u("line",{class:"interval",x1:l(m),x2:l(_),y1:f,y2:f}),Number.isFinite(p)&&(g?u("rect",{class:"mark",x:l(p)-5,y:f-5,width:"10",height:"10"}):u("circle",{cx:l(p),cy:f,r:"4.5"}))]})})]})})}function _N({title:n,estimates:e}){return u("div",{class:"wide",tabIndex:0,role:"group","aria-label":n,children:u("table",{children:[u("caption",{children:n}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"of"}),u("th",{scope:"col",children:"value"}),u("th",{scope:"col",children:"from"}),u("th",{scope:"col",children:"to"}),u("th",{scope:"col",children:"note"})]})}),u("tbody",{children:e.map(({name:t,value:i,low:r,high:s,note:o})=>u("tr",{children:[u("td",{children:t}),u("td",{children:Dl(i)}),u("td",{children:Dl(r)}),u("td",{children:Dl(s)}),u("td",{children:o})]}))})]})})}var Dl=n=>Number.isFinite(n)?n.toFixed(3).replace("-","−"):"-",yN=({value:n,low:e,high:t})=>Dl(n)+(Number.isFinite(e)?`, from ${Dl(e)} to ${Dl(t)}`:"");function xN(n){let[e,t,i]=["quantity","name","note"].map(c=>n.texts(c)),[r,s,o]=["low","high","whole"].map(c=>n.values(c)),a=n.texts("trial_condition"),l=new Map;return n.values("trial_friction").forEach((c,h)=>{let d=a[h]??"";l.set(d,[...l.get(d)??[],c])}),Array.from(n.values("value"),(c,h)=>({quantity:e?.[h]??"",name:t?.[h]??"",note:i?.[h]??"",value:c,low:r?.[h]??NaN,high:s?.[h]??NaN,whole:o?.[h]===1,trials:(l.get(t?.[h]??"")??[]).filter(Number.isFinite)}))}function bN(n,e,t){let i=()=>n.filter(({quantity:o})=>o===t.quantity.peek()).length-1,r=o=>()=>t.row.value=Math.min(Math.max(t.row.peek()+o,0),i()),s=()=>{let o=e.indexOf(t.quantity.peek());t.quantity.value=e[(o+1)%e.length]??"",t.row.value=0};return[{keys:"↑ ↓",effect:"previous or next estimate",actions:{ArrowUp:r(-1),ArrowDown:r(1)}},{keys:"q",effect:"next quantity",actions:{q:s}},...yi(t.listing)]}function SN(n,e){let t=(e-n)/5,i=10**Math.floor(Math.log10(t)),r=i*([1,2,5,10].find(a=>a*i>=t)??10),s=Math.ceil(n/r-1e-9),o=Math.floor(e/r+1e-9)-s+1;return Array.from({length:o},(a,l)=>Number(((s+l)*r).toPrecision(6)))}function wN(){let n=Ke(null),[e,t]=Rt(kS);return mt(()=>{let i=n.current;if(i===null)return;let r=new ResizeObserver(()=>t(Math.min(Math.max(i.clientWidth,kS),960)));return r.observe(i),()=>r.disconnect()},[]),[n,e]}var MN=6,TN=2,EN=["across the rows","along the rows","normal to the plate"],bf=class{constructor(e){this.data=e;this.frequency=e.values("frequency"),this.rows=e.values("rows"),this.kinds=e.texts("incident"),this.incident=this.kinds.filter(t=>this.losses(t).flat().some(Number.isFinite)),[this.waves=0]=e.shape("decay"),this.carrier=Number(e.header.extra.carrier),this.gap=e.header.extra.gap,this.units=ji(e)}data;frequency;rows;incident;waves;carrier;gap;units;kinds;nearest(e){let t=Array.from(this.frequency,i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}losses(e,t="loss"){let i=this.kinds.indexOf(e)*this.rows.length;return Array.from(this.rows,(r,s)=>this.curve(t,i+s))}ofWaves(e){return Array.from({length:this.waves},(t,i)=>this.curve(e,i))}get hasFields(){return this.data.has("wave_real")}get fields(){let{data:e}=this,[,,t=0,i=0]=e.shape("wave_real"),[r,s]=[zS(e.values("across")),zS(e.values("along"))],o={real:e.values("wave_real"),imag:e.values("wave_imag"),present:e.values("present")},a=e.header.extra.colours,l=e.values("slab_slip")[0]??0;return{grid:{...o,across:t,along:i,width:r*t,length:s*i,colours:a},part:{periods:Math.ceil(MN/(e.values("slab_rows")[0]??1)),repeats:TN,slip:l}}}field(e,t){let i=e*this.frequency.length+t;return{number:i,phase:this.data.values("slab_phase")[i]??0,decay:this.data.values("slab_decay")[i]??0}}direction(e,t){return EN[this.data.values("wave_component")[e*this.frequency.length+t]??2]??""}curve(e,t){let i=this.frequency.length;return Array.from(this.data.values(e).subarray(t*i,(t+1)*i))}};function Sf(n){return n.map(e=>Number.isFinite(e)?e:null)}function zS(n){return(n[1]??0)-(n[0]??0)}var AN="Errors are the change of a value if all frequencies of the lattice move by the bound of their relative error, and this share of the value. Waves of the lattice are shown at normal incidence. The field is that of the strongest component on the flat face, over six rows; a wave enters them from the left, relative to its largest displacement in the first row.",CN=10,o0=1.05,PN=60,RN="Fields of the waves are computed with the option --html.";function HS(n){return u(IN,{data:n})}function IN({data:n}){let e=Ge(()=>new bf(n),[n]),t=Ge(()=>({line:re(e.nearest(e.carrier)),rows:re(e.rows.length-1),incident:re(e.incident[0]??""),wave:re(0),...Zr(),unit:re(Qi(e.units,Math.max(...e.frequency))),listing:re("none")}),[e]),i=Ge(()=>LN(e,t),[e,t]);return u(ui,{name:"mirror",data:n,keys:i,foot:AN,children:[u("div",{class:"pair",children:[u("section",{"aria-label":"Insertion loss",children:[u(Hn,{label:"Insertion loss. Arrow keys change the frequency and the number of rows.",children:u(DN,{mirror:e,choice:t})}),u("p",{class:"axes",children:[u("label",{children:["Incident wave"," ",u("select",{value:t.incident.value,onChange:r=>t.incident.value=r.currentTarget.value,children:e.incident.map(r=>u("option",{children:r}))})]}),u(er,{title:"Frequencies in",units:e.units,unit:t.unit}),u("span",{class:"legend",children:[u("span",{class:"of-curve",children:[u(VS,{colour:"accent"})," ",s0(e.rows[t.rows.value]??0)]}),e.rows.length>1&&u("span",{class:"of-curve",children:[u(VS,{colour:"quiet"})," ",Math.min(...e.rows)," to ",s0(Math.max(...e.rows))]}),e.gap&&u("span",{class:"of-gap",children:"gap"}),u("span",{class:"of-carrier",children:"carrier"})]})]}),u(kN,{mirror:e,choice:t}),u(NN,{mirror:e,choice:t})]}),u("section",{"aria-label":"Waves of the lattice",children:[u(GS,{mirror:e,choice:t,name:"decay"}),u(ON,{mirror:e,choice:t}),e.hasFields?u(UN,{mirror:e,choice:t}):u("p",{children:RN}),u(GS,{mirror:e,choice:t,name:"phase"})]})]}),u(xi,{listing:t.listing,keys:i,children:[u(BN,{mirror:e,choice:t}),u(zN,{mirror:e,choice:t})]})]})}function LN(n,e){let t=(o,a)=>Math.min(Math.max(o,0),a-1),i=o=>e.line.value=t(e.line.value+o,n.frequency.length),r=o=>e.rows.value=t(e.rows.value+o,n.rows.length),s=o=>o.shiftKey?CN:1;return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:o=>i(-s(o)),ArrowRight:o=>i(s(o))}},{keys:"↑ ↓",effect:"one more or one less row",actions:{ArrowUp:()=>r(1),ArrowDown:()=>r(-1)}},{keys:"i",effect:"next incident wave",actions:{i:()=>{let o=(n.incident.indexOf(e.incident.value)+1)%n.incident.length;e.incident.value=n.incident[o]??""}}},{keys:"w W",effect:"wave of the lattice with the next higher or lower decay",actions:{w:()=>e.wave.value=t(e.wave.value+1,n.waves),W:()=>e.wave.value=t(e.wave.value-1,n.waves)}},Gr(e),{keys:"c",effect:"carrier",actions:{c:()=>e.line.value=n.nearest(n.carrier)}},...yi(e.listing)]}function WS({mirror:n,choice:e}){let{factor:t}=e.unit.value,i=(n.frequency[e.line.value]??0)/t;return{below:r=>{n.gap&&Zo(r,[n.gap[0]/t,n.gap[1]/t],"gap")},above:r=>{Qs(r,n.carrier/t,"carrier",[7,5]),Qs(r,i,"accent")},pick:r=>e.line.value=n.nearest(r*t)}}function qS({mirror:n,choice:e}){let{factor:t}=e.unit.value;return Ge(()=>Array.from(n.frequency,i=>i/t),[n,t])}function DN({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.rows.value],r=Ge(()=>n.losses(t).map((l,c)=>({values:Sf(l),colour:c===i?"accent":"quiet",width:c===i?2.6:1})),[n,t,i]),s=n.losses(t).flat().filter(Number.isFinite),[o,a]=[Math.min(0,...s),Math.max(1,...s)];return u(Cr,{x:qS({mirror:n,choice:e}),curves:r,titles:[Yt("frequency",e.unit.value),`${n.data.title("loss")} / dB`],height:300,limits:{y:[o,o+o0*(a-o)]},...WS({mirror:n,choice:e})})}function NN({mirror:n,choice:e}){let[t,i]=[e.incident.value,e.line.value],[r,s]=["loss","loss_error"].map(c=>n.losses(t,c).map(h=>h[i]??NaN)),o=Ge(()=>Array.from(n.rows),[n]),a=Ge(()=>[{values:Sf(r??[]),colour:"quiet",dash:[2,4]}],[n,t,i]),l=Math.max(1,...o.map((c,h)=>(r?.[h]??NaN)+(s?.[h]??NaN)).filter(Number.isFinite));return u(Cr,{x:o,curves:a,titles:["rows",`${n.data.title("loss")} / dB`],height:200,whole:!0,limits:{x:[.5,o.length+.5],y:[Math.min(0,...(r??[]).filter(Number.isFinite)),o0*l]},above:c=>o.forEach((h,d)=>{let[f=NaN,p=NaN]=[r?.[d],s?.[d]];if(!Number.isFinite(f))return;let m=_=>[c.valToPos(h,"x",!0),c.valToPos(_,"y",!0)];eo(c.ctx,m(f-p),m(f+p),"ink"),ys(c.ctx,m(f),d===e.rows.value?"accent":"quiet")}),pick:c=>e.rows.value=Math.min(Math.max(Math.round(c)-1,0),o.length-1)},`${t} ${i}`)}function GS({mirror:n,choice:e,name:t}){let i=Ge(()=>n.ofWaves(t).map(l=>({values:Sf(l),colour:"curve-0",points:!0})),[n,t]),r=e.line.value,s=i[e.wave.value]?.values[r],o=WS({mirror:n,choice:e}),a=Math.min(PN,o0*Math.max(...i.flatMap(({values:l})=>l.map(c=>c??0))));return u(Cr,{x:qS({mirror:n,choice:e}),curves:i,titles:[Yt("frequency",e.unit.value),`${n.data.title(t)} / ${t==="decay"?"(dB/row)":"π"}`],height:t==="decay"?300:200,limits:{y:t==="decay"?[0,a]:[0,1]},below:o.below,above:l=>{o.above(l),typeof s=="number"&&ys(l.ctx,[l.valToPos((n.frequency[r]??0)/e.unit.value.factor,"x",!0),l.valToPos(s,"y",!0)],"accent")},pick:(l,c)=>{o.pick(l),e.wave.value=FN(i.map(({values:h})=>h[e.line.value]??NaN),c)??e.wave.value}})}function FN(n,e){return n.map((i,r)=>r).filter(i=>Number.isFinite(n[i])).sort((i,r)=>Math.abs(n[i]-e)-Math.abs(n[r]-e))[0]}function UN({mirror:n,choice:e}){let{grid:t,part:i}=Ge(()=>n.fields,[n]),r=Ge(()=>Ve(()=>n.field(e.wave.value,e.line.value)),[n,e]),s=`${n.data.header.title}, ${mr(n.data)}`,o=`displacement ${n.direction(e.wave.value,e.line.value)}; 1 is the largest in the first row`;return u(ot,{children:[u(Ll,{grid:t,part:i,wave:r,pace:e,label:"Field of the wave, rows from left to right",shown:o,name:"wave",caption:s}),u(Ba,{...e})]})}function ON({mirror:n,choice:e}){let[t,i]=[e.wave.value,e.line.value],r=c=>n.ofWaves(c)[t]?.[i]??NaN,[s,o]=[r("decay"),r("phase")],a=Number.isFinite(o),l=[["decay",`${Ht(s,r("decay_error"))} dB per row`],["phase",a?`${Ht(o,r("phase_error"))} π per row`:""],["shown displacement",n.hasFields?n.direction(t,i):""]];return u("div",{class:"facts",children:[u("p",{id:"wave","aria-live":"polite",children:["Wave ",t+1," of ",n.waves," in the lattice at ",u("b",{children:wf({mirror:n,choice:e})}),":"," ",u("b",{children:a?"propagates":"decays"})]}),u(_i,{facts:l})]})}function wf({mirror:n,choice:e}){let t=e.unit.value;return Kn(Hr((n.frequency[e.line.value]??0)/t.factor),t)}function s0(n){return`${n} row${n===1?"":"s"}`}function VS({colour:n}){return u("svg",{width:"34",height:"8","aria-hidden":"true",children:u("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--${n})`})})}function XS(n,e){return Number.isFinite(n)?`${Ht(n??NaN,e??NaN)} dB`:"does not propagate"}function kN({mirror:n,choice:e}){let[t,i,r]=[e.incident.value,e.line.value,e.rows.value],[s,o]=["loss","loss_error"].map(l=>n.losses(t,l)[r]?.[i]),a=n.rows[r]??0;return u("div",{class:"facts",children:[u("p",{id:"point","aria-live":"polite",children:[t," at ",u("b",{children:wf({mirror:n,choice:e})}),", ",s0(a),": ",u("b",{children:XS(s,o)})]}),u("p",{class:"again",children:["The same as a picture, in Python: ",u("code",{children:['study.layers().plot("layers", incident="',t,'")']})]})]})}function BN({mirror:n,choice:e}){let t=e.line.value;return u("div",{class:"wide",children:u("table",{children:[u("caption",{children:["Insertion loss at ",wf({mirror:n,choice:e})]}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"rows"}),n.incident.map(i=>u("th",{scope:"col",children:["incident ",i]}))]})}),u("tbody",{children:Array.from(n.rows,(i,r)=>u("tr",{"aria-current":r===e.rows.value?"true":void 0,children:[u("td",{children:i}),n.incident.map(s=>u("td",{children:XS(n.losses(s)[r]?.[t],n.losses(s,"loss_error")[r]?.[t])}))]}))})]})})}function zN({mirror:n,choice:e}){let t=e.line.value,i=["decay","decay_error","phase","phase_error"].map(r=>n.ofWaves(r));return u("div",{class:"wide",children:u("table",{children:[u("caption",{children:["Waves of the lattice at ",wf({mirror:n,choice:e})]}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"decay / (dB/row)"}),u("th",{scope:"col",children:"phase per row / π"}),u("th",{scope:"col",children:"show"})]})}),u("tbody",{children:Array.from({length:n.waves},(r,s)=>{let[o=NaN,a=NaN,l=NaN,c=NaN]=i.map(h=>h[s]?.[t]);return u("tr",{"aria-current":s===e.wave.value?"true":void 0,children:[u("td",{children:Ht(o,a)}),u("td",{children:Number.isFinite(l)?Ht(l,c):"decays"}),u("td",{children:u("button",{type:"button",onClick:()=>e.wave.value=s,children:["wave ",s+1]})})]})})})]})})}var a0=class{constructor(e,t,i,r,s,o,a){this.title=i;this.columns=r;this.rows=s;this.places=o;this.colours=a;this.real=e.values(`${t}_real`),this.imag=e.values(`${t}_imag`),this.step=e.values(`${t}_step`),this.count=e.shape(`${t}_real`).slice(1).reduce((l,c)=>l*c,1),this.largestStep=(a.length-1)/2}title;columns;rows;places;colours;largestStep;real;imag;step;count;largest(e){return(this.step[e]??0)*this.largestStep}paint(e,t,i,r){let s=r>0?this.largest(t)/r:0,[o,a]=[s*Math.cos(2*Math.PI*i),s*Math.sin(2*Math.PI*i)],l=this.largestStep,c=t*this.count;for(let h=0;h<this.rows;h++)for(let d=0;d<this.columns;d++){let f=this.places[h*this.columns+d]??-1,p=(this.real[c+f]??0)*o-(this.imag[c+f]??0)*a,m=Math.min(Math.max(Math.round(l+p),0),2*l),[_=0,v=0,g=0]=this.colours[m]??[],x=4*((this.rows-1-h)*this.columns+d);e.data[x]=_,e.data[x+1]=v,e.data[x+2]=g,e.data[x+3]=f<0?0:255}}outermost(e){let t=e*this.count,[i,r]=[0,-1];for(let s=t;s<t+this.count;s++){let o=Math.hypot(this.real[s]??0,this.imag[s]??0);o>r&&([i,r]=[s,o])}return-Math.atan2(this.imag[i]??0,this.real[i]??0)/(2*Math.PI)}},Mf=class{constructor(e){this.data=e;let{extra:t}=e.header;this.frequency=e.values("frequency"),this.gap=t.gap,this.carrier=t.carrier,this.drive=String(t.drive),this.firstIs=String(t.first_is),this.python=String(t.python),this.parts=t,this.colours=t.colours,this.units=ji(e);let i=GN(e),[r=0,s=0]=e.shape(e.has("place")?"place":"present");this.fields=Object.entries(t.maps).map(([c,h])=>new a0(e,c,h,s,r,i,this.colours));let o=e.has("mode_frequency"),[a,l]=o?[e.values("mode_frequency"),e.values("mode_quality")]:[[],[]];this.modes=Array.from(a,(c,h)=>({frequency:c,name:e.texts("mode_name")[h]??"",quality:l[h]??NaN}))}data;frequency;fields;gap;carrier;drive;firstIs;python;parts;modes;colours;units;covers(e,t=e){return(this.frequency[0]??1/0)<=t&&e<=(this.frequency[this.frequency.length-1]??-1/0)}nearest(e){let t=0;return this.frequency.forEach((i,r)=>{Math.abs(i-e)<Math.abs((this.frequency[t]??0)-e)&&(t=r)}),t}get first(){return this.nearest(Number(this.data.header.extra.first))}largest(e,t=this.fields){return Math.max(...t.map(i=>i.largest(e)))}get extent(){let[e,t]=[this.data.values("x"),this.data.values("y")],[i,r]=[$S(e),$S(t)];return{left:(e[0]??0)-i,right:(e[e.length-1]??0)+i,bottom:(t[0]??0)-r,top:(t[t.length-1]??0)+r}}has(e){return this.data.has(e)}curves(e){if(!this.data.has(e))return[];let t=this.data.values(e),i=this.data.texts(e==="level"?"region":"pair"),r=this.frequency.length;return i.map((s,o)=>({name:s,values:Array.from(t.subarray(o*r,(o+1)*r),a=>Number.isFinite(a)&&(e==="contrast"||a>0)?a:null)}))}};function GN(n){return n.has("place")?Int32Array.from(n.values("place")):Int32Array.from(n.values("present"),(e,t)=>e===0?-1:t)}function $S(n){return n.length>1?.5*((n[1]??0)-(n[0]??0)):5e-4}var su=[[],[8,4],[2,3],[10,3,2,3]],l0=4,VN=300;function YS({plate:n,choice:e}){let t=Ke(null),i=e.shown.value;return Li(()=>{if(t.current!==null)return HN(t.current,n,e)},[n,e,i]),u("div",{class:"curves",ref:t})}function HN(n,e,t){let i=t.shown.peek(),r=e.curves(i),s=e.data.unit(i),o=()=>t.unit.peek().factor,a=()=>[Array.from(e.frequency,h=>h/o()),...r.map(({values:h})=>h)],l=()=>({width:$r(n),height:VN}),c=new tn({...l(),legend:{show:!1},cursor:{points:{show:!1},y:!1,drag:{x:!0,y:!1}},scales:{x:{time:!1},y:{distr:i==="level"?3:1}},axes:[{...yr(),label:"frequency",labelSize:22,size:34},{...Xr(),label:Yt(e.data.title(i),{name:s,factor:1}),values:(h,d)=>d.map(f=>f===null?"":WN(f,i==="level"))}],series:[{},...r.map((h,d)=>({...xs,stroke:()=>Xe(`curve-${d%l0}`),dash:su[d%su.length]??[],width:1.4,points:{show:!1}}))],hooks:{drawClear:[h=>Kr(h,()=>qN(h,e,o()))],draw:[h=>XN(h,e,t)]}},a(),n);return to(c,h=>t.line.value=e.nearest(o()*c.posToVal(h,"x"))),Yr(c,n,l,[Je(()=>{let h=c.axes[0];h!==void 0&&(h.label=Yt("frequency",t.unit.value)),c.setData(a(),!0)}),Je(()=>{t.line.value,c.redraw(!1,!1)})])}function WN(n,e){if(!e)return Zs(n);let t=Math.log10(n);return Math.abs(t-Math.round(t))<1e-9?zu(Math.round(t)):""}function qN(n,e,t){e.gap!==null&&Zo(n,[e.gap[0]/t,e.gap[1]/t],"gap")}function XN(n,e,t){let{factor:i}=t.unit.peek();e.carrier!==null&&Qs(n,e.carrier/i,"carrier",[7,5]),Qs(n,(e.frequency[t.line.peek()]??0)/i,"accent")}var $N=10;function KS(n){return{line:re(n.first),shown:re(n.has("level")?"level":"contrast"),plan:re(!1),common:re(!1),unit:re(Qi(n.units,Math.max(...n.frequency))),...Zr(),listing:re("none")}}function ZS(n,e){let t=n.frequency.length-1,i=h=>e.line.value=Math.min(Math.max(e.line.value+h,0),t),r=h=>h.shiftKey?$N:1,s=n.modes.map(({frequency:h})=>n.nearest(h)).sort((h,d)=>h-d),o=h=>{h!==void 0&&(e.line.value=h)},{carrier:a}=n,l={keys:"p n",effect:"previous or next mode near the carrier",actions:{p:()=>o(s.filter(h=>h<e.line.value).pop()),n:()=>o(s.find(h=>h>e.line.value))}},c={keys:"s",effect:"one scale of colours for both maps, or one for each",actions:{s:()=>e.common.value=!e.common.value}};return[{keys:"← →",effect:"previous or next frequency; ten with Shift",actions:{ArrowLeft:h=>i(-r(h)),ArrowRight:h=>i(r(h))}},...s.length>0?[l]:[],...a!==null?[{keys:"c",effect:"carrier",actions:{c:()=>o(n.nearest(a))}}]:[],{keys:"g",effect:n.firstIs,actions:{g:()=>o(n.first)}},...n.fields.length>1?[c]:[],{keys:"l",effect:"pillars and supports",actions:{l:()=>e.plan.value=!e.plan.value}},Gr(e),...yi(e.listing)]}var YN="The map shows the flat face, each frequency on its own scale of colours; regions are outlined, patches dashed.",KN="Each point of the scan is a square of the map. Measurement and model move with the phase of the drive.",JS=["level","contrast"];function jS(n){return u(ew,{data:n,foot:YN})}function QS(n){return u(ew,{data:n,foot:KN})}function ew({data:n,foot:e}){let t=Ge(()=>new Mf(n),[n]),i=Ge(()=>KS(t),[t]),r=Ge(()=>ZS(t,i),[t,i]),s=JS.filter(o=>t.has(o));return u(ui,{name:"plate",data:n,keys:r,foot:e,children:[u("div",{class:t.fields.length>1?"":"pair",children:[u("section",{"aria-label":"Spectra",children:[s.length>0&&t.frequency.length>1&&u(ot,{children:[u(Hn,{label:"Spectra. Arrow keys change the frequency.",children:u(YS,{plate:t,choice:i})}),u(ZN,{plate:t,choice:i}),u("p",{class:"axes",children:[u("label",{children:["Curves"," ",u("select",{value:i.shown.value,onChange:o=>i.shown.value=o.currentTarget.value,children:s.map(o=>u("option",{value:o,children:t.data.title(o)}))})]}),u(er,{title:"Frequencies in",units:t.units,unit:i.unit})]})]}),u(JN,{plate:t,choice:i})]}),u("section",{"aria-label":"Map",children:[u(DS,{plate:t,choice:i}),u("div",{class:"controls",children:[u(Ho,{playing:i.playing}),u(jN,{plate:t,choice:i}),u(uc,{pace:i.pace}),u("label",{class:"check",children:[u("input",{type:"checkbox",checked:i.plan.value,onChange:o=>i.plan.value=o.currentTarget.checked}),"pillars and supports"]}),t.fields.length>1&&u("label",{class:"check",children:[u("input",{type:"checkbox",checked:i.common.value,onChange:o=>i.common.value=o.currentTarget.checked}),"one scale of colours for both maps"]})]})]})]}),u(xi,{listing:i.listing,keys:r,children:[u(QN,{plate:t,choice:i}),u(e3,{plate:t,choice:i})]})]})}function ZN({plate:n,choice:e}){return u("p",{class:"legend",children:[n.curves(e.shown.value).map(({name:t},i)=>u("span",{class:"of-curve",children:[u("svg",{width:"34",height:"8","aria-hidden":"true",children:u("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${i%l0})`,"stroke-dasharray":(su[i%su.length]??[]).join(" ")})})," ",t]})),n.gap!==null&&n.covers(...n.gap)&&u("span",{class:"of-gap",children:"gap"}),n.carrier!==null&&n.covers(n.carrier)&&u("span",{class:"of-carrier",children:"carrier"})]})}function Nl(n,e){return Kn(Hr(n/e.factor),e)}function JN({plate:n,choice:e}){let t=e.line.value,i=n.frequency[t]??0,r=n.curves("contrast");return u("div",{class:"facts",children:[u("p",{id:"point","aria-live":"polite",children:[u("b",{children:Nl(i,e.unit.value)}),": up to ",ha(n.largest(t)),n.drive,r.map(({name:s,values:o})=>`; ${s} ${Di(o[t]?.toFixed(1)??"-")} dB`).join("")]}),u("p",{class:"again",children:["The same map as a picture, in Python: ",u("code",{children:`${n.python}.plot("maps", frequency=${Number(i.toFixed(3))})`})]})]})}function jN({plate:n,choice:e}){let t=n.frequency.length-1,i=e.line.value;return u("label",{class:"long",children:["frequency: ",Nl(n.frequency[i]??0,e.unit.value),u("input",{type:"range",min:"0",max:t,step:"1",value:i,disabled:t===0,"aria-valuetext":Nl(n.frequency[i]??0,e.unit.value),onInput:r=>e.line.value=Number(r.currentTarget.value)})]})}function QN({plate:n,choice:e}){let t=e.line.value,i=JS.flatMap(r=>n.curves(r).map(({name:s,values:o})=>[n.data.title(r),s,`${Di(o[t]?.toPrecision(3)??"-")} ${n.data.unit(r)}`]));for(let r of n.fields.length>1?n.fields:[])i.push(["largest displacement",r.title,`${ha(r.largest(t))}${n.drive}`]);return n.data.has("agreement")&&i.push([n.data.title("agreement"),"both maps",(n.data.values("agreement")[t]??0).toFixed(3)]),u("div",{class:"wide",children:u("table",{children:[u("caption",{children:["Regions at ",Nl(n.frequency[t]??0,e.unit.value)]}),u("tbody",{children:i.map(r=>u("tr",{children:r.map(s=>u("td",{children:s}))}))})]})})}function e3({plate:n,choice:e}){return n.modes.length===0?null:u("div",{class:"wide",children:u("table",{children:[u("caption",{children:"Modes near the carrier"}),u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"frequency"}),u("th",{scope:"col",children:"nodal lines"}),u("th",{scope:"col",children:"Q"}),u("th",{scope:"col",children:"show"})]})}),u("tbody",{children:n.modes.map(({frequency:t,name:i,quality:r})=>u("tr",{children:[u("td",{children:Nl(t,e.unit.value)}),u("td",{children:i}),u("td",{children:r.toFixed(0)}),u("td",{children:u("button",{type:"button",onClick:()=>e.line.value=n.nearest(t),children:Nl(n.frequency[n.nearest(t)]??0,e.unit.value)})})]}))})]})})}function iw({points:n,drawing:e}){let t=e?.plate.flat()??[],[i,r,s,o]=c0([...n,...t]),a=Math.max(r-i,o-s,1e-6),[l,c]=[.06*a,.045*a],h=[i-l,-o-l,r-i+2*l,o-s+2*l],[d,f]=[n[0],n.at(-1)];return u("svg",{class:"points",viewBox:h.map(p=>1e3*p).join(" "),role:"img","aria-label":t3(n,e),children:[e!==null&&u(ot,{children:[u("path",{d:e.plate.map(nw).join(""),class:"plate"}),u("path",{d:Object.values(e.regions).flat().map(nw).join(""),class:"region"})]}),u("path",{d:n.map(([p,m])=>`M${Mi(p)} ${Mi(-m)}h1e-4`).join(""),class:"places"}),d!==void 0&&u("path",{d:`M${Mi(d[0])} ${Mi(-d[1])}h1e-4`,class:"first"}),u("g",{"font-size":1e3*c,children:[Object.entries(e?.regions??{}).map(([p,m])=>{let[_,v,,g]=c0(m.flat());return u("text",{x:Mi((_+v)/2),y:Mi(1.2*c-g),"text-anchor":"middle",children:p})}),d!==void 0&&u(tw,{at:d,letter:c,words:"1"}),f!==void 0&&n.length>1&&u(tw,{at:f,letter:c,words:`${n.length}`}),u("text",{x:Mi(r+l),y:Mi(-s+.9*l),"text-anchor":"end",class:"quiet",children:"x →"}),u("text",{x:Mi(i-.9*l),y:Mi(-o-.2*l),class:"quiet",children:"y ↑"})]})]})}function tw({at:[n,e],letter:t,words:i}){return u("text",{x:Mi(n+.3*t),y:Mi(-e-.3*t),class:"number",children:i})}var Mi=n=>Number((1e3*n).toFixed(4)),nw=n=>`M${n.map(([e,t])=>`${Mi(e)} ${Mi(-t)}`).join("L")}Z`;function c0(n){let[e,t,i,r]=[1/0,-1/0,1/0,-1/0];for(let[s,o]of n)[e,t]=[Math.min(e,s),Math.max(t,s)],[i,r]=[Math.min(i,o),Math.max(r,o)];return[e,t,i,r]}function t3(n,e){let[t,i,r,s]=c0(n),o=(l,c)=>`${Number((1e3*l).toPrecision(4))} to ${Number((1e3*c).toPrecision(4))} mm`,a=e===null?"":" over the outline of the plate";return`${n.length} points${a}: x from ${o(t,i)}, y from ${o(r,s)}`}var n3=260,Tf=[[],[8,4]];function rw(n){return u(i3,{data:n})}function i3({data:n}){let{points:e,drawing:t,curves:i,unit:r,axis:s,names:o,title:a}=Ge(()=>r3(n),[n]),l=n.values(s),c=Ge(()=>Array.from(l,h=>h/r.factor),[n]);return u("div",{class:"reading",children:[e.length>0&&u(iw,{points:e,drawing:t}),c.length>1&&u("div",{children:[u(Cr,{x:c,curves:i,titles:[Yt(n.title(s),r),a],height:n3}),o.length>1&&u("p",{class:"legend",children:o.map((h,d)=>u("span",{class:"of-curve",children:[u("svg",{width:"34",height:"8","aria-hidden":"true",children:u("line",{x1:"0",x2:"34",y1:"4",y2:"4","stroke-width":"2",stroke:`var(--curve-${d})`,"stroke-dasharray":(Tf[d%Tf.length]??[]).join(" ")})})," ",n.title(h)]}))})]})]})}function r3(n){let{extra:e,variables:t}=n.header,i=String(e.axis),r=Object.keys(t).filter(p=>p!==i&&t[p]?.dims[0]===i),s=r.flatMap(p=>Array.from(n.values(p),Math.abs)).filter(Number.isFinite),o=u_(n.unit(r[0]??i),s.reduce((p,m)=>Math.max(p,m),0)),a=r.map((p,m)=>({values:Array.from(n.values(p),_=>Number.isFinite(_)?_/o.factor:null),colour:`curve-${m}`,dash:Tf[m%Tf.length]??[]})),l=n.has("y")?n.values("y"):[],c=n.has("x")?Array.from(n.values("x"),(p,m)=>[p,l[m]??0]):[],h={name:n.unit(i),factor:1},d=h.name==="Hz"?Qi(ji(n),Math.max(...n.values(i))):h,f=Yt(r.length===1?n.title(r[0]??i):"force",o);return{points:c,drawing:e.drawing,curves:a,unit:d,axis:i,names:r,title:f}}var s3=40,o3=.42;function sw({ribbon:n,choice:e}){let[t,i]=[e.unit.value,e.wavevectorUnit.value],r=e.mode.value,s=Ge(()=>Array.from(n.phases,l=>l/n.period/i.factor),[n,i]),o=Ge(()=>{let[l,c]=n.range;return{x:[0,Math.PI/n.period/i.factor],y:[l/t.factor,c/t.factor]}},[n,i,t]),a=(l,c,h=!1)=>[l.valToPos(n.wavevector(c)/i.factor,"x",h),l.valToPos(n.at(c)/t.factor,"y",h)];return u(Cr,{x:s,curves:a3,titles:[Yt("wavevector along the ribbon",i),Yt("frequency",t)],height:420,limits:o,below:l=>l3(l,n,s,t.factor),above:l=>{c3(l,n,t.factor,i.factor),n.carrier!==null&&Za(l,n.carrier/t.factor,"carrier",[7,5]),ys(l.ctx,a(l,r,!0),"accent")},pick:(l,c,h)=>{let[d,f]=[h.valToPos(l,"x"),h.valToPos(c,"y")],p=_=>Math.hypot(a(h,_)[0]-d,a(h,_)[1]-f),m=n.all.reduce((_,v)=>p(v)<p(_)?v:_,0);p(m)<s3&&(e.mode.value=m)}})}var a3=[];function l3(n,e,t,i){let{ctx:r}=n;r.save(),r.globalAlpha=.4;for(let{crystal:s,lower:o,upper:a}of e.bulk()){r.fillStyle=Xe(s===0?"rule":`curve-${s}`),r.beginPath();let l=(c,h)=>r.lineTo(n.valToPos(t[h]??0,"x",!0),n.valToPos((c[h]??0)/i,"y",!0));t.forEach((c,h)=>l(a,h)),t.forEach((c,h)=>l(o,t.length-1-h)),r.fill()}r.restore()}function c3(n,e,t,i){let{ctx:r}=n,s=e.phases.length>1?(e.phases[1]??0)-(e.phases[0]??0):.1,o=o3*s/e.period;r.save();for(let a of e.all){let l=(e.velocity[a]??0)*o/(2*Math.PI),c=d=>[n.valToPos((e.wavevector(a)+d*o)/i,"x",!0),n.valToPos((e.at(a)+d*l)/t,"y",!0)],h=e.share[a]??0;r.strokeStyle=u0(e.shares,h),r.lineWidth=(e.isGuided(a)?3:1.4)*devicePixelRatio,r.beginPath(),r.moveTo(...c(-1)),r.lineTo(...c(1)),r.stroke()}r.restore()}function u0(n,e){let t=matchMedia("(prefers-color-scheme: dark)").matches?e:1-e;return`rgb(${(n[Math.round(Math.min(Math.max(t,0),1)*(n.length-1))]??[]).join(" ")})`}var u3=1.6,h3=30,d3=["across the ribbon","along the ribbon","normal to the plate"],Ef=class{constructor(e){this.data=e;let{extra:t,attrs:i}=e.header;this.frequency=e.values("frequency"),this.error=e.values("frequency_error"),this.phase=e.values("phase"),this.velocity=e.values("group_velocity"),this.share=e.values("guide_share"),this.phases=e.values("wavevector_phase"),this.period=Number(i.period),this.range=t.range,this.carrier=t.carrier,this.place=i.kind==="strip"?"the outermost columns":`the ${i.kind}`,this.units=ji(e),this.wavevectorUnits=ka(this.period),this.shares=t.shares,this.atPhase=Array.from(this.phases,r=>this.all.filter(s=>this.phase[s]===r).sort((s,o)=>this.at(s)-this.at(o)))}data;frequency;error;phase;velocity;share;phases;period;range;carrier;place;units;wavevectorUnits;shares;atPhase;get all(){return Array.from(this.frequency,(e,t)=>t)}get hasFields(){return this.data.has("mode_real")}get fields(){let{data:e,period:t}=this,[,i=0,r=0]=e.shape("mode_real"),s=e.values("across"),o=((s[1]??0)-(s[0]??0))*i;return{grid:{...{real:e.values("mode_real"),imag:e.values("mode_imag"),present:e.values("present")},across:i,along:r,width:o,length:t,colours:e.header.extra.colours},part:{periods:Math.min(h3,Math.max(2,Math.round(u3*o/t)))}}}wave(e){return{number:e,phase:this.phase[e]??0,decay:0}}at(e){return this.frequency[e]??NaN}wavevector(e){return(this.phase[e]??0)/this.period}isGuided(e){return this.data.values("guided")[e]===1}decay(e){let[t,i]=["decay","decay_error"].map(r=>this.data.values(r)[e]??NaN);return Number.isFinite(t)?Ht(t,i):""}speed(e){return Ht(this.velocity[e]??NaN,this.data.values("group_velocity_error")[e]??NaN)}direction(e){return d3[this.data.values("mode_component")[e]??2]??""}get first(){let[e,t]=this.range,i=this.carrier!==null&&this.carrier>e&&this.carrier<t?this.carrier:(e+t)/2,r=this.all.filter(s=>this.isGuided(s));return ow(r.length>0?r:this.all,s=>this.at(s),i)}beside(e){return this.atPhase[this.row(e)]??[]}moved(e,t,i){let r=this.beside(e);if(i!==0)return r[Math.min(Math.max(r.indexOf(e)+i,0),r.length-1)]??e;let s=this.atPhase.map((a,l)=>l).filter(a=>(this.atPhase[a]??[]).length>0),o=Math.min(Math.max(s.indexOf(this.row(e))+t,0),s.length-1);return ow(this.atPhase[s[o]??0]??[],a=>this.at(a),this.at(e))}get guided(){return this.atPhase.flat().filter(e=>this.isGuided(e))}bulk(){let[e=0,t=0,i=0]=this.data.shape("bulk_lower"),[r,s]=[this.data.values("bulk_lower"),this.data.values("bulk_upper")];return Array.from({length:e*i},(o,a)=>{let[l,c]=[Math.floor(a/i),a%i],h=d=>Array.from({length:t},(f,p)=>d[(l*t+p)*i+c]??NaN);return{crystal:l,lower:h(r),upper:h(s)}})}row(e){return Array.from(this.phases).indexOf(this.phase[e]??NaN)}};function ow(n,e,t){return n.reduce((i,r)=>Math.abs(e(r)-t)<Math.abs(e(i)-t)?r:i,n[0]??0)}var aw="Errors of frequencies bound the distance to the exact ones of the model, those of velocity and decay are estimates. The field is that of the strongest component on the flat face, relative to its largest displacement.",f3="Fields of the modes are computed with the option --html.";function lw(n){return u(p3,{data:n})}function p3({data:n}){let e=Ge(()=>new Ef(n),[n]),t=Ge(()=>({mode:re(e.first),unit:re(Qi(e.units,e.range[1])),wavevectorUnit:re(e.wavevectorUnits[1]),...Zr(),listing:re("none")}),[e]),i=Ge(()=>m3(e,t),[e,t]);return e.all.length===0?u(ui,{name:"ribbon",data:n,keys:[],foot:aw,children:null}):u(ui,{name:"ribbon",data:n,keys:i,foot:aw,children:[u("div",{class:"pair",children:[u("section",{"aria-label":"Projected bands",children:[u(Hn,{label:"Projected bands. Arrow keys move between wavevectors and modes.",children:u(sw,{ribbon:e,choice:t})}),u("p",{class:"axes",children:[u(er,{title:"Frequencies in",units:e.units,unit:t.unit}),u(er,{title:"Wavevectors in",units:e.wavevectorUnits,unit:t.wavevectorUnit})]}),u(v3,{ribbon:e})]}),u("section",{"aria-label":"Mode",children:[e.hasFields?u(g3,{ribbon:e,choice:t}):u("p",{children:f3}),u(_3,{ribbon:e,choice:t}),e.hasFields&&u(Ba,{...t})]})]}),u(xi,{listing:t.listing,keys:i,children:u(y3,{ribbon:e,choice:t})})]})}function m3(n,e){let t=(r,s)=>e.mode.value=n.moved(e.mode.value,r,s),i=r=>{let{guided:s}=n;if(s.length===0)return;let o=s.indexOf(e.mode.value);e.mode.value=s[(o+r+s.length)%s.length]??e.mode.value};return[{keys:"← →",effect:"mode of about this frequency at the previous or next wavevector",actions:{ArrowLeft:()=>t(-1,0),ArrowRight:()=>t(1,0)}},{keys:"↑ ↓",effect:"next higher or lower mode at this wavevector",actions:{ArrowUp:()=>t(0,1),ArrowDown:()=>t(0,-1)}},{keys:"p n",effect:"previous or next guided mode",actions:{p:()=>i(-1),n:()=>i(1)}},Gr(e),...yi(e.listing)]}function g3({ribbon:n,choice:e}){let{grid:t,part:i}=Ge(()=>n.fields,[n]),r=Ge(()=>Ve(()=>n.wave(e.mode.value)),[n,e]),s=`${n.data.header.title}, ${mr(n.data)}`,o=`displacement ${n.direction(e.mode.value)}; 1 is the largest`;return u(Ll,{grid:t,part:i,wave:r,pace:e,label:"Field of the mode",shown:o,name:"ribbon",caption:s})}function v3({ribbon:n}){let[,e]=Rt(0);mt(()=>Qn(()=>e(i=>i+1)),[]);let t=[0,.25,.5,.75,1].map(i=>u0(n.shares,i));return u("p",{class:"scale legend",children:[u("span",{class:"plain",children:"0 %"}),u("span",{class:"bar",style:{background:`linear-gradient(to right, ${t.join(", ")})`}}),u("span",{class:"plain",children:"100 %"}),u("span",{class:"plain",children:["of the energy in ",n.place,"; guided modes are thick; shaded: bulk bands"]}),n.carrier!==null&&u("span",{class:"of-carrier",children:"carrier"})]})}function cw(n,e,{factor:t,name:i}){return`${Number((n.wavevector(e)/t).toPrecision(4))} ${i}`}function uw(n){return`${(100*(n??NaN)).toFixed(1)} %`}function hw(n,e,{factor:t}){return Ht(n.at(e)/t,(n.error[e]??NaN)/t)}function _3({ribbon:n,choice:e}){let[t,i,r]=[e.mode.value,e.unit.value,e.wavevectorUnit.value],s=n.decay(t),o=[["group velocity",`${n.speed(t)} m/s`],[`energy in ${n.place}`,uw(n.share[t])],["decay",s&&`${s} dB per row`],["shown displacement",n.hasFields?n.direction(t):""]];return u("div",{class:"facts",children:[u("p",{id:"point","aria-live":"polite",children:[n.isGuided(t)?"Guided mode":"Mode"," at ",cw(n,t,r),":"," ",u("b",{children:Kn(hw(n,t,i),i)})]}),u(_i,{facts:o})]})}function y3({ribbon:n,choice:e}){let[t,i,r]=[e.mode.value,e.unit.value,e.wavevectorUnit.value];return u("div",{class:"wide",children:u("table",{children:[u("caption",{children:["Modes at ",cw(n,t,r)]}),u("thead",{children:u("tr",{children:[Yt("frequency",i),"guided",`energy in ${n.place}`,"decay / (dB/row)","show"].map(s=>u("th",{scope:"col",children:s}))})}),u("tbody",{children:n.beside(t).map(s=>u("tr",{"aria-current":s===t?"true":void 0,children:[u("td",{children:hw(n,s,i)}),u("td",{children:n.isGuided(s)?"yes":"no"}),u("td",{children:uw(n.share[s])}),u("td",{children:n.decay(s)||"-"}),u("td",{children:u("button",{type:"button",onClick:()=>e.mode.value=s,children:Kn(Hr(n.at(s)/i.factor),i)})})]}))})]})})}var dw='.uplot, .uplot *, .uplot *::before, .uplot *::after {box-sizing: border-box;}.uplot {font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji";line-height: 1.5;width: min-content;}.u-title {text-align: center;font-size: 18px;font-weight: bold;}.u-wrap {position: relative;user-select: none;}.u-over, .u-under {position: absolute;}.u-under {overflow: hidden;}.uplot canvas {display: block;position: relative;width: 100%;height: 100%;}.u-axis {position: absolute;}.u-legend {font-size: 14px;margin: auto;text-align: center;}.u-inline {display: block;}.u-inline * {display: inline-block;}.u-inline tr {margin-right: 16px;}.u-legend th {font-weight: 600;}.u-legend th > * {vertical-align: middle;display: inline-block;}.u-legend .u-marker {width: 1em;height: 1em;margin-right: 4px;background-clip: padding-box !important;}.u-inline.u-live th::after {content: ":";vertical-align: middle;}.u-inline:not(.u-live) .u-value {display: none;}.u-series > * {padding: 4px;}.u-series th {cursor: pointer;}.u-legend .u-off > * {opacity: 0.3;}.u-select {background: rgba(0,0,0,0.07);position: absolute;pointer-events: none;}.u-cursor-x, .u-cursor-y {position: absolute;left: 0;top: 0;pointer-events: none;will-change: transform;}.u-hz .u-cursor-x, .u-vt .u-cursor-y {height: 100%;border-right: 1px dashed #607D8B;}.u-hz .u-cursor-y, .u-vt .u-cursor-x {width: 100%;border-bottom: 1px dashed #607D8B;}.u-cursor-pt {position: absolute;top: 0;left: 0;border-radius: 50%;border: 0 solid;pointer-events: none;will-change: transform;/*this has to be !important since we set inline "background" shorthand */background-clip: padding-box !important;}.u-axis.u-off, .u-select.u-off, .u-cursor-x.u-off, .u-cursor-y.u-off, .u-cursor-pt.u-off {display: none;}';var fw=`& {
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
`;var S3={bands:bS,layers:HS,plate:jS,scan:QS,finger:OS,ribbon:lw,friction:BS,reading:rw,guides:SS};function Af(n,e,t){let i=S3[n.header.kind];if(i===void 0)throw new Error(`this version has no view "${n.header.kind}"`);return h0(),e.classList.add("haptonic","view"),nc(i(n,t),e),()=>nc(null,e)}function h0(){if(document.getElementById("haptonic-style")!==null)return;let n=document.createElement("style");n.id="haptonic-style",n.textContent=`${dw}:where(.haptonic) { ${fw} }`,document.head.append(n)}var Cf=/^\s*\[\[?\s*([^\]]+?)\s*\]\]?/,w3=["quantity","number","integer","quantities","entries"];function pw(n,e,t,i){let r=n.lastIndexOf(`
`,e-1)+1,s=n.slice(r,e),o=n.slice(0,r).split(`
`),a=new Map(t.map(f=>[f.path,f])),l=s.indexOf("="),c=/^\s*\[+\s*([\w.-]*)$/.exec(s);if(c!==null)return A3(c[1]??"",e-s.trimStart().length,t);let h=M3(o,a);if(l<0){let f=T3(n.split(`
`),o.length-1);return C3(/[\w-]*$/.exec(s)?.[0]??"",e,{keys:t,table:h,given:f})}let d=a.get(gw(h,mw(s.slice(0,l).trim(),a,h)))??a.get(h);return d===void 0?{from:e,list:[]}:P3(s.slice(l+1),e,d,d.path===i?[]:E3(n,i))}function M3(n,e){return mw(n.flatMap(t=>Cf.exec(t)?.[1]??[]).at(-1)??"",e,"")}function mw(n,e,t){return n.split(".").reduce((i,r)=>{let s=i?`${i}.${r.trim()}`:r.trim();return e.get(gw(t,s))?.kind==="tables"?`${s}[]`:s},"")}var gw=(n,e)=>n&&e?`${n}.${e}`:n||e;function T3(n,e){let t=n.map(o=>Cf.test(o)),i=t.lastIndexOf(!0,e)+1,r=t.indexOf(!0,e+1),s=n.filter((o,a)=>a>=i&&(r<0||a<r)&&a!==e);return new Set(s.map(o=>/^\s*([\w-]+)\s*=/.exec(o)?.[1]??""))}function E3(n,e){let t=n.split(`
`),i=t.findIndex(s=>Cf.exec(s)?.[1]===e)+1;if(i===0)return[];let r=t.slice(i).findIndex(s=>Cf.test(s));return t.slice(i,r<0?t.length:i+r).flatMap(s=>{let[,o,a]=/^\s*([A-Za-z_]\w*)\s*=\s*(.*)/.exec(s)??[];return o===void 0?[]:[[o,a??""]]})}function d0(n,e){let t=e.toLowerCase();return n.filter(({label:i})=>i.replace(/^[["]+/,"").toLowerCase().startsWith(t)).slice(0,50)}function A3(n,e,t){let i=t.filter(({kind:r})=>["table","tables","entries"].includes(r)).map(({path:r,kind:s,title:o})=>{let a=r.replaceAll("[]",""),l=s==="tables"?`[[${a}]]`:`[${a}]`;return{insert:l,label:l,detail:o}});return{from:e,list:d0(i,n)}}function C3(n,e,{keys:t,table:i,given:r}){let s=t.filter(({path:o,kind:a})=>o.slice(0,o.lastIndexOf(".")+1)===(i&&`${i}.`)&&!["table","tables","entries"].includes(a)).map(o=>({name:o.path.slice(o.path.lastIndexOf(".")+1),key:o})).filter(({name:o})=>!r.has(o)).map(({name:o,key:a})=>({insert:`${o} = `,label:o,detail:a.title+(a.required?", required":a.default?`, default ${a.default}`:"")}));return{from:e-n.length,list:d0(s,n)}}function P3(n,e,t,i){let r=n.trimStart().startsWith('"'),s=/[\w.-]*$/.exec(n)?.[0]??"",o=f=>r?f:`"${f}"`,a=[...t.names,...t.numbers].map(f=>({insert:o(f),label:f,detail:t.title})),l=t.kind==="boolean"?["true","false"].map(f=>({insert:f,label:f,detail:t.title})):[],h=(w3.includes(t.kind)?i:[]).map(([f,p])=>({insert:o(f),label:f,detail:`parameter, ${p}`})),d=n.trim()===""&&t.example&&!t.closed?[{insert:t.kind==="quantity"?`"${t.example}"`:t.example,label:t.example,detail:`${t.title}, an example`}]:[];return{from:e-s.length,list:d0([...l,...a,...h,...d],s)}}var $i=class extends Error{constructor(t,i){super(t);this.problem=i}problem},f0="The server does not answer, so nothing was changed; is `haptonic studio` still running?";async function _w(n){let e;try{e=await n}catch{throw new $i(f0)}if(e.ok)return e;if(e.status===422){let{error:t}=await e.json();throw new $i(`${t.argument}: ${t.cause}`,t)}throw e.status===403?new $i("The server was started again; open its new link."):new $i(e.headers.get("content-type")?.startsWith("text/plain")?await e.text():`Error ${e.status} of the server.`)}var Fl=async n=>await(await _w(n)).json();async function vw(n){let e=await _w(n);return{name:/filename="([^"]*)"/.exec(e.headers.get("content-disposition")??"")?.[1]??"file",content:await e.blob()}}function yw(n,e){let t={"content-type":"application/json"};return fetch(`api/${n}`,{method:"POST",headers:t,body:JSON.stringify(e)})}var Ti=(n,e)=>Fl(yw(n,e)),vt={start:()=>Fl(fetch("api/start")),check:n=>Ti("check",{text:n}),change:(n,e)=>Ti("change",{text:n,changes:e}),forecast:n=>Ti("forecast",{text:n}),open:n=>Ti("open",{name:n}),template:n=>Ti("template",{name:n}),save:(n,e,t,i)=>Ti("save",{name:n,text:e,known:t,replace:i}),run:n=>Ti("run",n),examine:n=>Ti("examine",n),upload:(n,e,t)=>{let i=new URLSearchParams({name:n,replace:t?"1":"0"});return Fl(fetch(`api/upload?${i}`,{method:"POST",body:e}))},cancel:n=>Ti("cancel",{number:n}),compare:(n,e)=>Ti("differences",{first:n,second:e}),export:(n,e)=>vw(yw("product",{number:n,...e})),page:n=>vw(fetch(`api/jobs/${n}/page`)),remove:n=>Ti("remove",{number:n}),design:(n,e)=>Ti("opened",{number:n,point:e}),points:(n,e)=>Fl(fetch(`api/jobs/${n}/points/${e}`)),job:n=>Fl(fetch(`api/jobs/${n}`)),view:async n=>(await fetch(`api/jobs/${n}/view`)).arrayBuffer(),turn:(n,e,t,i,r)=>Ti("run",{analysis:n.analysis,options:n.options,text:e,file:r,steps:t,value:i}),wish:n=>Ti("wish",{path:n}),knobs:n=>Fl(fetch(`api/jobs/${n}/knobs`)),part:async(n,e)=>{let t=await fetch(`api/jobs/${n}/${e}`);return t.ok?Ks.read(await t.arrayBuffer()):null},picture:(n,e)=>`api/jobs/${n}/pictures/${encodeURIComponent(e)}`},R3=2e3;function p0(n,e){let t=new WebSocket(`ws://${location.host}/api/live`);t.onopen=()=>e(!1),t.onmessage=i=>n(JSON.parse(String(i.data)).jobs),t.onclose=()=>{e(!0),setTimeout(()=>p0(n,e),R3)}}var Pf=class{file=re(null);saved=re(null)},Ol=".toml",I3=250,L3=800,D3=100,At=re(""),ar=re({}),ss=re(!1),Mo=re(null),Xn=re([]),Ns=re([]),Yi=re(new Pf),lr=Ve(()=>Yi.value.file.value),os=re([]),To=re(0),Jn=re(null),m0=re(null),x0=Ve(()=>m0.value?.problem===Jn.value?m0.value?.name??null:null),kl=re(null),ou=re(""),Ul=re([]),If=re([]),da=Ve(()=>At.value!==(Yi.value.saved.value??"")),xw=Ve(()=>Ul.value.length>0),bw=Ve(()=>If.value.length>0),g0=0,Lf="",v0=0,_0=-1/0,y0=Promise.resolve(),Rf=!0;function Df(n){g0+=1,Rf&&(To.value+=1),Rf=!1,Lf=n.text,ss.value=n.values===null&&At.peek().trim()!=="",ss.value||(ar.value=n.values??{}),Mo.value=n.plate,Xn.value=n.problems,Ns.value=n.remarks}async function $n(n){Jn.value=null,await cr(n)}async function cr(n){try{await n()}catch(e){if(!(e instanceof $i))throw e;Jn.value=e.problem??e.message}}var Nf=n=>y0=y0.then(()=>$n(n)),Sw=()=>y0,ww=()=>({source:Yi.peek(),text:At.peek(),values:Lf===At.peek()&&!ss.peek()?ar.peek():null});function au(n,e=!1,t=Yi.peek(),i=performance.now()){if(n===At.peek()&&t===Yi.peek())return;!(Ul.peek().length===0&&At.peek()==="")&&!(e&&i-_0<L3)&&(Ul.value=[...Ul.peek(),ww()].slice(-D3)),_0=e?i:-1/0,If.value=[],Yi.value=t,At.value=n}function Ff(n=I3){Jn.value=null,clearTimeout(v0),v0=window.setTimeout(()=>{cr(Mw)},n)}async function Mw(){let n=g0+=1,e=At.peek(),t=await vt.check(e);n===g0&&Df({...t,text:e})}function Uf(n){au(n,!0),Ff()}function N3(n){au(n),Ff(0)}var Ki=(n,e,t=!1)=>{Bl(()=>[{steps:n,value:e}],t)};function Bl(n,e=!1){let t=performance.now();return Nf(async()=>{let i=Yi.peek();for(;;){Lf!==At.peek()&&await Mw();let[r,s]=[At.peek(),n()];if(s.length===0)return;let o=await vt.change(r,s);if(Yi.peek()!==i)return;if(At.peek()===r){au(o.text,e,i,t),clearTimeout(v0),Df(o);return}}})}function Tw(n,e){let t=n.peek().at(-1);t!==void 0&&(n.value=n.peek().slice(0,-1),e.value=[...e.peek(),ww()],_0=-1/0,At.value=t.text,t.source!==Yi.peek()&&([Yi.value,Rf]=[t.source,!0]),t.values!==null&&([ar.value,Lf]=[t.values,t.text]),Ff(0))}var zl=()=>Tw(Ul,If),Gl=()=>Tw(If,Ul);function Ew(n,e){Rf=!0;let t=e===null?null:n;if(n===At.peek()&&e===lr.peek()){Yi.peek().saved.value=t;return}let i=new Pf;[i.file.value,i.saved.value]=[e,t],au(n,!1,i)}var Aw=(n,e)=>Nf(async()=>{if(!(da.peek()&&!confirm("The study has changes that are not saved. Leave them? Undo brings them back."))){ou.value=n;try{let t=await e();Ew(t.text,t.name??null),Df(t)}finally{ou.value=""}}}),fa=n=>Aw(n,()=>vt.open(n)),Cw=n=>Aw(n,()=>vt.template(n));function b0(n){Ew(n,null),Ff(0)}var Pw=(n,e)=>e===(lr.peek()??e)?N3(n):b0(n),Rw=(n,e)=>lr.value===e&&Yi.value.saved.value===n,Iw=(n,e)=>Nf(async()=>{let t=await vt.design(n,e);au(t.text),Df(t)}),S0=(n,e=!1)=>Nf(async()=>{let[t,i]=[Yi.peek(),At.peek()],r=n===t.file.peek()?t.saved.peek():null,s=await vt.save(n,i,r,e).catch(o=>{throw o instanceof $i&&o.problem?.code==="repeated"&&(m0.value={name:n,problem:o.problem}),o});[t.file.value,t.saved.value]=[s.name,i],os.value=s.files});function Fs(n,e){return n===e||n.startsWith(`${e}.`)||n.startsWith(`${e}[`)}function Pn(n){return n.reduce((e,t)=>typeof t=="number"?`${e}[${t+1}]`:e?`${e}.${t}`:t,"")}var Of="completions",F3=14,as=re(null),Eo=re(0),Lw=re([]),Dw=re(""),kf=Ve(()=>as.value===null?{from:0,list:[]}:pw(At.value,as.value,Lw.value,Dw.value));function Nw(n,e){[Lw.value,Dw.value]=[n,e]}var Bf=()=>as.value=null;function w0(n){as.peek()!==null&&(as.value=n.selectionStart,Eo.value=0)}function Fw(n,e){let{list:t}=kf.peek();if(n.key===" "&&n.ctrlKey)[as.value,Eo.value]=[e.selectionStart,0];else{if(as.peek()===null||t.length===0)return!1;if(n.key==="ArrowDown"||n.key==="ArrowUp")Eo.value=(Eo.peek()+(n.key==="ArrowDown"?1:t.length-1))%t.length;else if(n.key==="Enter"||n.key==="Tab")Uw(e,Eo.peek());else if(n.key==="Escape")Bf();else return!1}return n.preventDefault(),!0}function Uw(n,e){let{from:t,list:i}=kf.peek(),r=i[e];r===void 0||as.peek()===null||(n.setRangeText(r.insert,t,as.peek(),"end"),Bf(),Uf(n.value),n.focus())}function Ow(){return{"aria-autocomplete":"list",...kf.value.list.length>0?{"aria-controls":Of,"aria-activedescendant":`${Of}-${Eo.value}`}:{}}}function kw({area:n}){let{from:e,list:t}=kf.value,i=n.current;if(as.value===null||i===null)return null;let r=At.value.slice(0,e).split(`
`),s=i.scrollHeight/At.value.split(`
`).length,o=i.offsetTop+r.length*s-i.scrollTop+6,a=parseFloat(getComputedStyle(document.documentElement).fontSize),c=i.getBoundingClientRect().top-i.offsetTop+o+F3*a<innerHeight?{top:`${o}px`}:{top:`${o-s-6}px`,transform:"translateY(-100%)"},h=`min(calc(${i.offsetLeft}px + ${(r.at(-1)??"").length}ch), max(0px, 100% - 22rem))`;return u("ul",{id:Of,role:"listbox",tabIndex:0,"aria-label":"Completions",class:"completions",style:{...c,left:h},children:[t.length===0&&u("li",{role:"option","aria-selected":"false",class:"quiet",children:"Nothing fits here."}),t.map(({label:d,detail:f},p)=>u("li",{id:`${Of}-${p}`,role:"option","aria-selected":p===Eo.value,ref:m=>{p===Eo.value&&m?.scrollIntoView({block:"nearest"})},onMouseDown:m=>{m.preventDefault(),Uw(i,p)},children:[u("code",{children:d})," ",u("span",{class:"quiet",children:f})]}))]})}var Bw=[{keys:"Ctrl+Space",effect:"list of keys and values that fit at the cursor",actions:{}},{keys:"Ctrl+Z",effect:"undo",actions:{}},{keys:"Ctrl+Shift+Z",effect:"redo",actions:{}}];function zw(){let n=Ke(null),e=Ke(null),t=()=>{n.current!==null&&e.current!==null&&(e.current.scrollTop=n.current.scrollTop)};Li(t);let i=new Set(Xn.value.map(({line:a})=>a)),r=new Set(Ns.value.map(({line:a})=>a)),s=At.value.split(`
`).length,o=a=>{n.current!==null&&a!==null&&U3(n.current,a)};return u("div",{class:"editor",children:[u("div",{class:"page",children:[u("ol",{ref:e,"aria-hidden":"true",children:Array.from({length:s},(a,l)=>u("li",{class:i.has(l+1)?"wrong":r.has(l+1)?"doubtful":"",children:l+1}))}),u("textarea",{ref:n,"aria-label":"Text of the study file, TOML","aria-invalid":Xn.value.length>0,value:At.value,wrap:"off",spellcheck:!1,autocapitalize:"off",autocomplete:"off",...Ow(),onInput:a=>{Uf(a.currentTarget.value),w0(a.currentTarget)},onSelect:a=>w0(a.currentTarget),onBlur:Bf,onScroll:t,onKeyDown:a=>{if(Fw(a,a.currentTarget)||!(a.ctrlKey||a.metaKey)||a.altKey)return;let l=a.key.toLowerCase(),c=l==="y"||l==="z"&&a.shiftKey?Gl:l==="z"?zl:null;c!==null&&(a.preventDefault(),c())}})]}),u(kw,{area:n}),u("section",{"aria-label":"Problems","aria-live":"polite",class:"problems",children:[Xn.value.length>0&&u("ul",{children:Xn.value.map(a=>u("li",{children:u(Us,{problem:a,go:o})}))}),Ns.value.map(a=>u("p",{class:"doubt",children:[u(Gw,{path:a.path,line:a.line,go:o}),": ",a.text]})),Xn.value.length===0&&Ns.value.length===0&&At.value!==""&&u("p",{class:"quiet",children:"The study has no problem."}),At.value===""&&u("p",{children:"Choose a template or open a study above, or write here."})]})]})}function Gw({path:n,line:e,go:t}){let i=e===null?n:`line ${e}${n?`, ${n}`:""}`;return e===null?u("b",{children:i}):u("button",{type:"button",class:"minor",onClick:()=>t(e),children:i})}function Us({problem:n,go:e=()=>{}}){return u("div",{class:"parts",children:[u("p",{children:[u(Gw,{path:n.path||n.argument,line:n.line,go:e}),": got ",n.given]}),u("dl",{children:[u("dt",{children:"allowed"}),u("dd",{children:n.allowed}),u("dt",{children:"likely cause"}),u("dd",{children:n.cause}),u("dt",{children:"next step"}),u("dd",{children:n.next_step})]})]})}function U3(n,e){let t=n.value.split(`
`),i=t.slice(0,e-1).join(`
`).length+(e>1?1:0);n.focus(),n.setSelectionRange(i,i+(t[e-1]?.length??0));let r=n.scrollHeight/Math.max(t.length,1);n.scrollTop=Math.max(0,(e-4)*r)}var mi=re([]),ls=re(!1),Kt=re(null),ii=re(null),zf=re(!0),Gf=Ve(()=>mi.value.find(({number:n})=>n===ii.value?.number)),Vf={job:0},M0=re(0),Vw=Ve(()=>M0.value>0),Hf=()=>ls.value?void 0:mi.value.find(n=>n.state==="running"),Hw=(n,e)=>n.seconds+Math.max(0,e-M0.value)/1e3;function Ww(){p0(n=>{let e=n.at(-1);e&&Kt.peek()===null&&(Kt.value=e.number),M0.value=performance.now(),mi.value=n},n=>{ls.value=n,!n&&Jn.peek()===f0&&(Jn.value="The server answers again. Make the last change once more.")}),Je(()=>{let n=mi.value.find(t=>t.number===Kt.value);if(n===void 0||n.state==="running")return;let e=ii.peek();e?.number===n.number&&e.state===n.state||cr(async()=>{let t=await vt.job(n.number);Kt.peek()===t.number&&(ii.value=t)})})}function T0(n){Kt.value=n,zf.value=!1}var Wf=(n,e)=>$n(async()=>{let{number:t}=await vt.run(n);Vf.job=t,T0(t),e!==void 0&&await vt.remove(e)}),qw=n=>$n(async()=>{Kt.peek()===n&&(Kt.value=ii.value=null),await vt.remove(n)}),Xw=n=>$n(async()=>{await vt.cancel(n)});var O3=50,Os=re([]),$w=re(""),Pr=re(null),pa=re({}),$f=re(null),ma=Ve(()=>Os.value.find(({path:n})=>n===$w.value)??Os.value[0]),P0=Ve(()=>pa.value[ma.value?.path??""]!==void 0),lu=Ve(()=>Pr.value!==null||ii.value?.alone||At.value===ii.value?.text),Yw=Ve(()=>{let[n,e]=[Pr.value,ma.value];return n===null||e===void 0?null:{certified:$f.value?.at===n?$f.value.data:null,preview:pa.value[e.path]?.data??null,at:n*e.scale}}),cu=({unit:n},e)=>`${Number(e.toPrecision(9))} ${n}`.trim(),Kw=(n,e)=>n.unit?cu(n,e):Number(e.toPrecision(9)),C0=0,qf=null,Xf=null,E0=!1,cs={job:0,path:"",at:0};function Zw(n){$w.value=n,$n(async()=>{await vt.wish(n)})}function Jw(n,e){Pr.value=e,qf={of:n,value:e},clearTimeout(C0),C0=window.setTimeout(R0,O3)}function R0(){clearTimeout(C0),qf!==null&&(Xf=qf,qf=null,$n(k3))}var jw=(n,e)=>Ki(n.steps,Kw(n,e),!0);async function k3(){if(!E0){E0=!0;try{for(;Xf!==null;){let[{of:n,value:e},t]=[Xf,ii.peek()];if(Xf=null,t===null)return;let{number:i}=await vt.turn(t,At.peek(),n.steps,Kw(n,e),lr.peek());cs={job:i,path:n.path,at:e},Kt.value=i}}catch(n){throw Pr.value=null,n}finally{E0=!1}}}var A0=0,Qw=n=>n.turned&&A0>0?A0:A0=n.number;function eM(n){(n!==cs.job||Pr.peek()===cs.at)&&(Pr.value=null)}function tM(){let n=new Set,e=(t,i)=>{n.has(t)||(n.add(t),cr(i))};Je(()=>{let t=ii.value;if(t===null)return;let i=t.number===cs.job;e(`end ${t.number}`,async()=>{pa.value=i?Object.fromEntries(Object.entries(pa.peek()).filter(([r])=>r===cs.path)):{},Os.value=t.view?Os.peek().map(r=>i&&r.path===cs.path?{...r,value:cs.at}:r):[],t.view||(Pr.value=null)})}),Je(()=>{let t=mi.value.find(({number:a})=>a===cs.job);if(t?.first&&t.state==="running"){let{number:a,first:l}=t;e(`first ${a} ${l}`,async()=>{let{at:c}=cs,h=await vt.part(a,"first"),d=$f.peek(),f=d!==null&&d.job===a&&d.count>l;h!==null&&cs.job===a&&!f&&($f.value={job:a,count:l,at:c,data:h})})}let i=mi.value.find(({number:a})=>a===ii.value?.number);if(!i?.turns)return;e(`knobs ${i.number}`,async()=>{let a=await vt.knobs(i.number);ii.peek()?.number===i.number&&(Os.value=a)});let r=Os.value.findIndex(a=>a===ma.value),s=ma.value?.path??"",o=i.previews[s]??0;o>0&&n.has(`knobs ${i.number}`)&&e(`preview ${i.number} ${o} ${s}`,async()=>{let a=await vt.part(i.number,`previews/${r}`),l=pa.peek()[s],c=l!==void 0&&l.job===i.number&&l.count>=o;a!==null&&ii.peek()?.number===i.number&&!c&&(pa.value={...pa.peek(),[s]:{job:i.number,count:o,data:a}})})})}var nM={turned:Yw,controls:u(B3,{}),design:()=>Object.fromEntries(Os.value.map(n=>[n.title,cu(n,n===ma.value?Pr.value??n.value:n.value)]))};function B3(){let n=ma.value;if(n===void 0)return u("p",{class:"quiet",children:Gf.value?.archived?"Compute this again to turn its numbers.":"Sliders for its numbers follow in a moment."});let e=Pr.value??n.value;return u("div",{class:"turning","data-prepared":P0.value,children:[u("label",{children:["Turn"," ",u("select",{value:n.path,disabled:Pr.value!==null,onChange:t=>Zw(t.currentTarget.value),children:Os.value.map(({path:t,title:i})=>u("option",{value:t,children:i}))})]}),u("input",{type:"range","aria-label":n.unit?`${n.title}, ${n.unit}`:n.title,"aria-valuetext":cu(n,e),min:n.low,max:n.high,step:n.step,value:e,disabled:!lu.value,onInput:t=>Jw(n,Number(t.currentTarget.value)),onPointerUp:R0,onChange:t=>jw(n,Number(t.currentTarget.value))}),u("output",{children:cu(n,e)}),lu.value?!P0.value&&u("span",{class:"quiet state",children:"Its preview follows in a moment."}):u("span",{class:"quiet state",children:"The study has changed: compute it first."})]})}function Vl({table:n}){let e=n.count-n.rows.length;return u("div",{class:"wide",tabIndex:0,role:"group","aria-label":n.title,children:[u("table",{children:[u("caption",{children:n.title}),u("thead",{children:u("tr",{children:n.head.map(t=>u("th",{scope:"col",children:t}))})}),u("tbody",{children:[n.rows.length===0&&u("tr",{children:u("td",{colSpan:n.head.length,children:"none"})}),n.rows.map((t,i)=>u("tr",{class:n.strong.includes(i)?"strong":"",children:t.map((r,s)=>u("td",{class:n.numeric[s]?"number":"",children:r}))}))]})]}),e>0&&u("p",{class:"quiet",children:["and ",e," more rows, in the files of the command"]})]})}var iM="folder ",z3="page ";function rM({job:n,answer:e,exports:t}){let[i,r]=Rt(iM),[s,o]=Rt(""),[a,l]=Rt(Object.keys(t.looks)[0]??""),[c,h]=Rt(!1),[d,f]=[i.slice(0,i.indexOf(" ")),i.slice(i.indexOf(" ")+1)],p=d==="picture"?t.pictures:d==="table"?t.tables:[],m=p.includes(s)?s:p[0]??"",_=Object.entries(Vo.value).map(([x,{name:A,factor:S}])=>[x,[A,S]]),v=()=>$n(async()=>{h(!0);try{let x={kind:d,name:f,form:m,...d==="picture"?{style:a,units:Object.fromEntries(_)}:{}},A=await(d==="page"?vt.page(n.number):vt.export(n.number,x));hh(A.content,A.name)}finally{h(!1)}}),g=(x,A,S)=>S.length>0&&u("optgroup",{label:x,children:S.map(P=>u("option",{value:`${A} ${P}`,children:P}))});return u("div",{class:"row",role:"group","aria-label":"Save the result",children:[u("label",{children:["Save",u("select",{value:i,onChange:x=>r(x.currentTarget.value),children:[u("option",{value:iM,children:"everything, as one zip"}),n.view&&u("option",{value:z3,children:"the interactive page, as one HTML file"}),g("Pictures","picture",e.pictures.map(x=>x.name)),g("Tables","table",e.tables.map(x=>x.title)),g("Files","file",e.files)]})]}),p.length>0&&u("label",{children:["Format",u("select",{value:m,onChange:x=>o(x.currentTarget.value),children:p.map(x=>u("option",{children:x}))})]}),d==="picture"&&u("label",{children:["Style",u("select",{value:a,onChange:x=>l(x.currentTarget.value),children:Object.entries(t.looks).map(([x,A])=>u("option",{value:x,children:A}))})]}),d==="picture"&&_.length>0&&u("span",{class:"quiet",children:["axes in ",_.map(([,[x]])=>x).join(" and "),", as in the view"]}),u("button",{type:"button",disabled:c,onClick:()=>{v()},children:c?"The file is made":"Save file"})]})}function sM({exports:n}){let e=ii.value,t=Ke(null);return mt(()=>{e===null||e.number!==Vf.job||(Vf.job=0,e.state!=="cancelled"&&t.current?.scrollIntoView())},[e?.number]),e===null?null:u("section",{ref:t,id:"result",class:"result","aria-label":`Result of ${e.analysis}`,children:[!lu.value&&u("p",{class:"notice",children:["This result belongs to ",[null,e.file].includes(lr.value)?"another version of the study":e.file,"."," ",u("button",{type:"button",onClick:()=>Pw(e.text,e.file),children:"Show that study"})]}),["cancelled","interrupted"].includes(e.state)&&u(G3,{job:e}),e.error!==null&&u(ot,{children:[u("h2",{children:["No result of ",e.analysis]}),u(Us,{problem:{...e.error,path:e.error.argument,line:null}})]}),e.answer!==null&&u(V3,{job:e,answer:e.answer,exports:n},Qw(e))]})}function G3({job:n}){let{analysis:e,options:t,alone:i,text:r,file:s}=n,[o,a]=n.progress;return u("p",{children:[n.state==="cancelled"?`The computation of ${e} was cancelled`:`The server ended during the computation of ${e}`,a>0&&` at ${o} of ${a}`,". Finished parts come from the store."," ",u("button",{type:"button",disabled:ls.value,onClick:()=>{Wf({analysis:e,options:t,alone:i,text:r,file:s},n.number)},children:"Continue"})]})}function V3({job:n,answer:e,exports:t}){return u(ot,{children:[n.view?u(W3,{number:n.number}):u(H3,{answer:e}),e.remarks.map(i=>u("p",{class:"doubt",children:i})),u(rM,{job:n,answer:e,exports:t}),u("dl",{class:"repeat",children:[u("dt",{children:"The same as a command"}),u("dd",{children:u("code",{children:n.command})}),u("dt",{children:"in Python"}),u("dd",{children:u("code",{children:n.python})}),!n.alone&&!Rw(n.text,n.file)&&u("dd",{class:"quiet",children:["once the study of this result is saved as ",n.file]})]}),e.tables.length>0&&u("details",{class:"section",open:!n.view,children:[u("summary",{children:"Tables"}),e.tables.map(i=>u(Vl,{table:i}))]}),u(q3,{job:n,answer:e})]})}function H3({answer:n}){return u("header",{children:[u("h2",{children:n.title}),u("p",{class:"origin",children:n.origin}),n.summary.map(e=>u("p",{class:"sentence",children:Wr(e)}))]})}function W3({number:n}){let e=Ke(null),[t,i]=Rt(""),r=Ke(()=>{});return mt(()=>()=>r.current(),[]),mt(()=>{let s=!1;return vt.view(n).then(o=>{s||e.current===null||(r.current=Af(Ks.read(o),e.current,nM),eM(n))},()=>i("The view cannot be loaded: the server does not answer.")),()=>{s=!0}},[n]),u(ot,{children:[t&&u("p",{role:"alert",children:t}),u("div",{ref:e})]})}function q3({job:n,answer:e}){let[t,i]=Rt(!n.view);return e.pictures.length===0?null:u("details",{class:"section",open:t,onToggle:r=>i(r.currentTarget.open),children:[u("summary",{children:"Pictures"}),t&&u("div",{class:"pictures",children:e.pictures.map(({name:r,caption:s})=>u(X3,{address:vt.picture(n.number,r),name:r,caption:s},`${n.number} ${r}`))})]})}function X3({address:n,name:e,caption:t}){let[i,r]=Rt("The picture is being drawn.");return u("figure",{children:[u("img",{src:n,alt:t||e,loading:"lazy",onLoad:()=>r(""),onError:()=>r("The picture cannot be drawn.")}),i&&u("p",{class:"quiet",children:i}),u("figcaption",{children:t})]})}var Ao=re([]),uu=re([]),Yf=re({}),I0=re({}),oM=re(""),$3=Ve(()=>Ao.value.find(({interactive:n})=>n)??Ao.value[0]),gi=Ve(()=>Ao.value.find(n=>n.name===oM.value)??$3.value),Hl=Ve(()=>Yf.value[gi.value?.name??""]??{}),Co=Ve(()=>Xn.value.length>0||ss.value||At.value.trim()===""),Rr=Ve(()=>{let n=gi.value;return n===void 0||n.study==="none"?!1:n.study==="needed"?!0:I0.value[n.name]??(n.study==="optional"&&Mo.value!==null)}),Po=Ve(()=>(gi.value?.options??[]).filter(({name:n,required:e})=>e&&(Hl.value[n]??"")==="")),Ro=Ve(()=>{let n=gi.value;if(n===void 0)return null;let e=!Rr.value;return{analysis:n.name,options:Hl.value,alone:e,text:e?"":At.value,file:lr.value}});function L0(n){oM.value=n}function D0(n,e){let t=gi.peek()?.name??"";Yf.value={...Yf.peek(),[t]:{...Yf.peek()[t],[n]:e}}}function N0(n){I0.value={...I0.peek(),[gi.peek()?.name??""]:n}}function Kf(n){os.value=n.files,uu.value=n.measured}var hu=({form:n})=>n==="path",aM=({examines:n,options:e})=>n&&e.some(t=>t.required&&hu(t)),F0=Ve(()=>Ao.value.filter(aM));function Zf(n,e=gi.peek()){let t=e!==void 0&&aM(e)?e:F0.peek()[0],i=t?.options.find(r=>r.required&&hu(r));t===void 0||i===void 0||(L0(t.name),D0(i.name,n))}var Wl=re([]),du=re(""),Qf=re(null),Jf=re(""),jf=re(!1),Y3="unsupported",lM=[],cM=n=>n.endsWith(Ol),uM=n=>lM.some(e=>n.toLowerCase().endsWith(e)),U0=n=>!cM(n)&&!uM(n),ep=n=>n.split("/")[0]??"";function hM(n){lM=n;let e=t=>t.dataTransfer?.types.includes("Files")??!1;addEventListener("dragover",t=>{e(t)&&(t.preventDefault(),jf.value=!0)}),addEventListener("dragleave",t=>{t.relatedTarget===null&&(jf.value=!1)}),addEventListener("drop",t=>{if(!e(t))return;t.preventDefault(),jf.value=!1;let i=[...t.dataTransfer?.items??[]].map(s=>s.webkitGetAsEntry()),r=[...t.dataTransfer?.files??[]];$n(async()=>{let s=(await Promise.all(i.filter(o=>o!==null).map(dM))).flat();await fM(s.length>0?s:r.map(o=>({name:o.name,content:o})))})})}async function dM(n){let e=n.fullPath.replace(/^\//,"");if(n.isFile){let r=await new Promise((s,o)=>n.file(s,o));return[{name:e,content:r}]}let t=n.createReader(),i=[];for(;;){let r=await new Promise((s,o)=>t.readEntries(s,o));if(r.length===0)break;i.push(...r)}return(await Promise.all(i.map(dM))).flat()}async function fM(n){let e=n.filter(({name:a})=>!a.split("/").some(l=>l.startsWith("."))),t=e.length>0?e:n.slice(0,1),i=t[0];if(i===void 0)return;let r=t.every(({name:a})=>a.startsWith(`${ep(i.name)}/`)),s=t.filter(({name:a})=>U0(a));if(r||s.length<2)return tp(t,!1);Wl.value=s,du.value||="measured";let o=t.filter(({name:a})=>!U0(a));o.length>0&&await tp(o,!1)}async function tp(n,e,t=n.map(({name:i})=>i)){let[i,r]=[[],[]];Qf.value=null;try{for(let[a,l]of n.entries()){Jf.value=`Adding ${l.name}, ${a+1} of ${n.length}`;try{Kf(await vt.upload(l.name,l.content,e))}catch(c){let h=c instanceof $i?c.problem?.code:void 0;if(h==="repeated")i.push(l);else if(h===Y3&&r.length+1<t.length)r.push(l.name);else throw c}}}catch(a){throw Jf.value="",a}let s=t.filter(a=>!r.includes(a)),o=r.length>0?` Left out, because nothing reads them: ${r.join(", ")}.`:"";Jf.value=i.length===0?`Added ${[...new Set(s.map(ep))].join(", ")}.${o}`:"",i.length>0?Qf.value={files:i,all:s}:await pM(s)}async function pM(n){let e=n.find(r=>cM(r)&&ep(r)===r),[t,i]=[n.find(U0),n.find(uM)];t!==void 0&&Zf(ep(t)),e!==void 0&&await fa(e),i!==void 0&&(Jn.value??=`${i} is in the folder. A study uses it with file = "${i}" in its table [cell.solid].`)}function K3(){let n=du.peek().trim(),e=Wl.peek().map(t=>({...t,name:`${n}/${t.name}`}));Wl.value=[],$n(()=>tp(e,!1))}function mM(){let[n,e]=[Ke(null),Ke(null)],i={type:"file",class:"hidden",tabIndex:-1,"aria-hidden":!0,multiple:!0,onChange:({currentTarget:r})=>{let s=[...r.files??[]].map(o=>({name:o.webkitRelativePath||o.name,content:o}));r.value="",$n(()=>fM(s))}};return u("div",{class:`drop${jf.value?" over":""}`,children:[u("p",{children:["Drop a file or a folder anywhere on this page, or"," ",u("button",{type:"button",onClick:()=>n.current?.click(),children:"Choose files"})," ",u("button",{type:"button",onClick:()=>e.current?.click(),children:"Choose a folder"})]}),u("input",{...i,ref:n,"data-choose":"files"}),u("input",{...i,ref:e,"data-choose":"folder",webkitdirectory:!0})]})}function gM(){let n=Qf.value;return u(ot,{children:[Wl.value.length>0&&u("form",{class:"row",onSubmit:e=>{e.preventDefault(),K3()},children:[u("label",{children:["Folder for ",Wl.value.length," files",u("input",{value:du.value,spellcheck:!1,autocomplete:"off",onInput:e=>du.value=e.currentTarget.value})]}),u("button",{type:"submit",disabled:du.value.trim()==="",children:"Add"}),u("button",{type:"button",onClick:()=>Wl.value=[],children:"Leave them"})]}),n!==null&&u("div",{class:"row",role:"alert",children:[u("span",{children:["In the folder already: ",n.files.slice(0,3).map(({name:e})=>e).join(", "),n.files.length>3&&` and ${n.files.length-3} more`,"."]}),u("button",{type:"button",onClick:()=>{$n(()=>tp(n.files,!0,n.all))},children:"Replace"}),u("button",{type:"button",onClick:()=>{Qf.value=null,$n(()=>pM(n.all))},children:"Use what is there"})]}),u("p",{class:"quiet",role:"status",children:Jf.value})]})}var ga=re(null),np=re(null);function vM(){Je(()=>{let[n,e]=[ga.value,Kt.value],t=o=>mi.value.find(a=>a.number===o&&a.state==="done"),[i,r]=[t(e),t(n)],s=i!==void 0&&i.analysis!==r?.analysis;if((r===void 0||s)&&(ga.value=null),n===e||r===void 0||i===void 0||s){np.value=null;return}cr(async()=>{let o=await vt.compare(n,e);ga.peek()===n&&Kt.peek()===e&&(np.value=o)})})}function _M(){if(np.value===null)return null;let{runs:n,tables:e}=np.value;return u("section",{class:"section","aria-labelledby":"comparison-title",children:[u("h2",{id:"comparison-title",children:n.map(({name:t})=>t).join(" and ")}),u("div",{class:"sides-by-side",children:n.map(({name:t,title:i,summary:r})=>u("div",{children:[u("h3",{children:[t," ",u("span",{class:"quiet",children:i})]}),r.map(s=>u("p",{class:"sentence",children:Wr(s)}))]}))}),e.map(t=>u(Vl,{table:t})),u("p",{class:"quiet",children:"Bold differences exceed the sum of both errors. Equal numbers are left out."}),u("button",{type:"button",onClick:()=>ga.value=null,children:"Close the comparison"})]})}var Z3={running:"running",done:"",failed:"failed",cancelled:"cancelled",interrupted:"interrupted"},O0=({state:n})=>n==="running"&&ls.value?"unknown, because the server does not answer":Z3[n];function yM(){let n=[...mi.value].reverse(),e=n.find(({number:t})=>t===Kt.value);return u(ot,{children:[u("p",{class:"hidden",role:"status",children:e===void 0?"":`${e.analysis}: ${O0(e)||"finished"}`}),n.length>0&&u("details",{class:"section",children:[u("summary",{children:["Runs ",u("span",{class:"quiet",children:[n.length," in this folder"]})]}),u("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Runs",children:u("table",{children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"run"}),u("th",{scope:"col",children:"study"}),u("th",{scope:"col",children:"file"}),u("th",{scope:"col",children:"begun"}),u("th",{scope:"col",children:"took"}),u("th",{scope:"col",colSpan:2,children:u("span",{class:"hidden",children:"compare and remove"})})]})}),u("tbody",{children:n.map(t=>u(J3,{job:t},t.number))})]})})]})]})}function J3({job:n}){let e=`${n.number}. ${n.analysis}`;return u("tr",{children:[u("td",{children:u("button",{type:"button",class:"minor","aria-pressed":Kt.value===n.number,onClick:()=>T0(n.number),children:[e," ",O0(n)&&`(${O0(n)})`]})}),u("td",{class:"study-title",children:n.title||"-"}),u("td",{children:[n.file," ",n.byCommand&&u("span",{class:"quiet",children:"command line"})]}),u("td",{class:"number",children:j3(n.started)}),u("td",{class:"number",children:n.state==="running"?"":`${Math.round(n.seconds)} s`}),u("td",{children:n.state==="done"&&n.number!==Kt.value&&n.analysis===Gf.value?.analysis&&u("button",{type:"button",class:"minor","aria-pressed":ga.value===n.number,onClick:()=>ga.value=n.number,"aria-label":`Compare the shown run with ${e}`,children:"Compare"})}),u("td",{children:n.state!=="running"&&u("button",{type:"button",class:"minor",onClick:()=>{qw(n.number)},"aria-label":`Remove ${e}`,children:"Remove"})})]})}var j3=n=>new Date(1e3*n).toLocaleString([],{dateStyle:"short",timeStyle:"short"});var Q3=400,ip=re(null),Ei=re(null),fu=re(""),Io=re(!1),Lo=Ve(()=>{let n=Ei.value,e=(gi.value?.options??[]).map(({name:r})=>r);if(n===null)return"";let t=n.argument.split(/[.[]/);return e.find(r=>r===t[0])??e.find(r=>t.includes(r))??e.find(r=>n.next_step.includes(`${r}=`))??""}),B0=Ve(()=>{let n=/\[([\w.]+)\]/.exec(Ei.value?.next_step??"")?.[1]??"";return(gi.value?.tables??[]).some(t=>Fs(n,t))?n:""}),xM=0,va=null,k0=!1;function bM(){let n="";Je(()=>{let[e,t]=[Ro.value,gi.value],i=t?.examines&&Po.value.length===0&&!(Rr.value&&t.study==="optional"&&Co.value),r=i?JSON.stringify(e):"";if(r!==n){if(n=r,clearTimeout(xM),Io.value=i===!0,va=null,!i||e===null){ip.value=Ei.value=null;return}xM=window.setTimeout(()=>{va=e,eF()},Q3)}})}async function eF(){if(!k0){k0=!0;try{for(;va!==null;){let n=va,e=await vt.examine(n);va===n&&(va=null,Ei.value=e.problem,ip.value=e.answer&&{answer:e.answer,data:e.view===null?null:Ks.read(tF(e.view))},fu.value="",Io.value=!1)}}catch(n){if(!(n instanceof $i))throw n;va=null,fu.value=n.message,Io.value=!1}finally{k0=!1}}}function tF(n){return Uint8Array.from(atob(n),e=>e.charCodeAt(0)).buffer}function SM({option:n}){let e=`option-${n.name}`,t=n.name.replaceAll("_"," "),i=Lo.value===n.name?Ei.value:null,r={id:e,"aria-describedby":`${e}-help`,"aria-invalid":i!==null},s=Hl.value[n.name]??n.default??"",o=l=>D0(n.name,l),a=n.form==="int"||n.form==="float";return u("div",{class:`field given${i!==null?" wrong":""}`,children:[n.form==="bool"?u("label",{class:"check",children:[u("input",{...r,type:"checkbox",checked:s===!0,onChange:l=>o(l.currentTarget.checked)}),t]}):u(ot,{children:[u("label",{for:e,children:[t,n.unit&&u("span",{class:"quiet",children:[" with unit, such as 1 ",n.unit]}),n.required&&s===""&&u("span",{class:"quiet",children:" (required)"})]}),n.form==="path"?u(nF,{about:r,value:String(s),set:o}):n.form==="choice"?u("select",{...r,value:String(s),onChange:l=>o(l.currentTarget.value),children:[n.default===null&&u("option",{value:"",children:"not given"}),n.choices.map(l=>u("option",{children:l}))]}):u("input",{...r,type:"text",inputMode:a?"decimal":"text",spellcheck:!1,autocomplete:"off",value:String(s),onChange:({currentTarget:{value:l}})=>o(a?iF(l):l)})]}),i!==null&&u("div",{class:"refusal",children:u(Us,{problem:{...i,path:"",line:null}})}),u("p",{id:`${e}-help`,class:"help",children:n.help})]})}function nF({about:n,value:e,set:t}){let i=[...uu.value,...os.value];return u("select",{...n,value:e,onChange:r=>t(r.currentTarget.value),children:[u("option",{value:"",children:i.length>0?"not given":"no file in the folder"}),uu.value.length>0&&u("optgroup",{label:"Measured files",children:uu.value.map(r=>u("option",{children:r}))}),os.value.length>0&&u("optgroup",{label:"Studies",children:os.value.map(r=>u("option",{children:r}))}),e!==""&&!i.includes(e)&&u("option",{children:e})]})}var iF=n=>n.trim()===""||Number.isNaN(Number(n))?n:Number(n);function MM({chosen:n}){let e=n.options.filter(({required:s})=>s),t=n.options.filter(({required:s})=>!s),i=[...new Set(t.map(({topic:s})=>s))].filter(s=>s!==""),r=t.filter(({topic:s})=>s==="");return u(ot,{children:[e.some(hu)&&u(mM,{}),u("div",{class:"asks",children:u(rp,{options:e,chosen:n})}),u(rF,{chosen:n}),n.examines&&u(sF,{chosen:n}),i.map(s=>u("fieldset",{class:"item asks",children:[u("legend",{children:s}),u(rp,{options:t.filter(o=>o.topic===s),chosen:n})]})),i.length===0?u(rp,{options:r,chosen:n}):u("details",{class:"further",children:[u("summary",{children:"Further options"}),u(rp,{options:r,chosen:n})]})]})}function rp({options:n,chosen:e}){return n.length===0?null:u("div",{class:"fields",children:n.map(t=>u(SM,{option:t},`${e.name}-${t.name}`))})}function rF({chosen:n}){return n.study==="needed"||n.study==="none"?null:u("div",{class:"row",children:[u("label",{class:"check",children:[u("input",{type:"checkbox",checked:Rr.value,onChange:e=>N0(e.currentTarget.checked)}),n.study==="optional"?"with the study of this page":"with the settings of the study of this page"]}),Rr.value&&n.tables.map(e=>u(TM,{path:e})),Rr.value&&Co.value&&u("span",{class:"quiet",children:"The study has problems, or is empty."})]})}function TM({path:n}){return u("button",{type:"button",onClick:()=>{N0(!0),kl.value={path:n,isReached:!1}},children:["Open the table ",n," in the form"]})}function sF({chosen:n}){let e=Ke(null),t=ip.value,i=t?.data??null;return mt(()=>e.current===null||i===null?void 0:Af(i,e.current),[i]),Po.value.length>0?u("p",{class:"quiet",children:"Choose the files to see what is in them."}):u("section",{class:"understood","aria-labelledby":"understood-title","aria-busy":Io.value,children:[u("h3",{id:"understood-title",children:t?.answer.title??"Reading the files"}),u("p",{class:"quiet",role:"status",children:Io.value?"The files are read.":Ei.value!==null?"The files cannot be read like this.":"Nothing is computed yet."}),fu.value&&u("p",{class:"problem",children:fu.value}),Ei.value!==null&&Lo.value===""&&u("div",{class:"refusal",role:"alert",children:u(Us,{problem:{...Ei.value,path:"",line:null}})}),Ei.value!==null&&Lo.value!==""&&u("p",{children:u("a",{href:`#option-${Lo.value}`,onClick:aF,children:["Go to the question: ",Lo.value.replaceAll("_"," ")]})}),B0.value!==""&&u("p",{children:u(TM,{path:B0.value})}),Ei.value!==null&&u(oF,{chosen:n}),t!==null&&u(ot,{children:[t.answer.summary.map(r=>u("p",{children:Wr(r)})),t.answer.remarks.map(r=>u("p",{class:"doubt",children:r})),u("div",{ref:e}),t.answer.tables.map(r=>u(Vl,{table:r}))]})]})}var wM=".nc";function oF({chosen:n}){let e=n.options.find(i=>i.required&&hu(i)),t=String(Hl.value[e?.name??""]??"");return u("p",{children:[F0.value.filter(i=>i.name!==n.name).map(i=>u("button",{type:"button",onClick:()=>Zf(t,i),children:["Read it for ",i.name]})),t.endsWith(wM)&&u("span",{class:"quiet",children:[" The bands of a study, ",wM,", are chosen in the analysis compare."]})]})}function aF(n){n.preventDefault(),document.getElementById(`option-${Lo.peek()}`)?.focus()}function EM(){let n=gi.value,e=Hf();if(n===void 0)return null;let t=Rr.value&&n.study!=="settings"&&Co.value,i=n.examines&&(Io.value||Ei.value!==null),r=async()=>{await Sw(),Ro.peek()!==null&&await Wf(Ro.peek())};return u("section",{class:"compute","aria-labelledby":"compute-title",children:[u("h2",{id:"compute-title",children:"Compute"}),u("div",{class:"row",children:[u("label",{children:["Analysis",u("select",{value:n.name,onChange:s=>L0(s.currentTarget.value),children:Ao.value.map(s=>u("option",{children:s.name}))})]}),u("button",{type:"button",class:"main",disabled:ls.value||t||i||Po.value.length>0,onClick:()=>{r()},children:["Compute ",n.name]}),e!==void 0&&u("button",{type:"button",onClick:()=>{Xw(e.number)},children:"Cancel"}),ii.value!==null&&u("a",{href:"#result",children:"Go to the result"}),t&&u("span",{class:"quiet",children:"The study has problems, or is empty."})]}),u("p",{class:"quiet",children:n.help}),u(gM,{}),u(MM,{chosen:n}),e!==void 0&&!e.turned&&u(lF,{job:e}),u(yM,{})]})}function lF({job:n}){let[e,t]=Rt(performance.now());mt(()=>{let a=setInterval(()=>t(performance.now()),1e3);return()=>clearInterval(a)},[]);let[i,r,s]=n.progress,o=r>0?{value:i,max:r}:{};return u("div",{class:"running",children:[u("progress",{...o,"aria-label":`Computing ${n.analysis}`}),u("p",{children:[`Computing ${n.analysis}${r>0?`: ${i} of ${r}`:""}${s&&` (${s})`}, `,Math.floor(Hw(n,e))," s."," ",u("span",{class:"quiet",children:n.cost})]})]})}function CM(n){let e=[],t=new Map;for(let i of n){let r=i.path.lastIndexOf("."),s={key:i,name:i.path.slice(r+1),inside:[]};t.set(i.path,s),((r<0?void 0:t.get(i.path.slice(0,r).replace(/\[\]$/,"")))?.inside??e).push(s)}return e}var z0=({key:n})=>["table","tables","entries"].includes(n.kind),sp=n=>/^(Young|Poisson)/.test(n)?n:n.toLowerCase(),AM=/^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;function pu(n,e){let t=e.trim().replace(/^"([^"]*)"$/,"$1");if(t==="")return null;switch(n.kind){case"integer":return Number.isSafeInteger(Number(t))&&/^[+-]?\d+$/.test(t)?Number(t):t;case"number":case"entries":return AM.test(t)&&!n.unit?Number(t):t;case"quantities":return t.split(",").map(i=>n.unit||!AM.test(i.trim())?i.trim():Number(i));case"text":return e;default:return t}}function Ir(n){return n===void 0?"":Array.isArray(n)?n.map(Ir).join(", "):typeof n=="object"?"":String(n)}function PM(n){return[n.help,n.kind==="quantities"?"Commas between the values.":"",n.example?`For example ${n.example}.`:"",n.bounds?`${n.bounds[0]?.toUpperCase()}${n.bounds.slice(1)}.`:"",n.typical?`Usual: ${n.typical}.`:""].filter(Boolean).join(" ")}function RM(){let n=Ke(null),e=()=>{n.current?.open||n.current?.showModal()};return mt(()=>{let t=[{keys:"?",effect:"this list",actions:{"?":e}}],i=r=>Vr(r,t);return document.addEventListener("keydown",i),()=>document.removeEventListener("keydown",i)},[]),u(ot,{children:[u("button",{type:"button",onClick:e,"aria-keyshortcuts":"?",children:"Keys"}),u("dialog",{ref:n,"aria-label":"Keys of the page",children:[Oa.value.map(({title:t,keys:i})=>u(hc,{title:t,keys:i})),u("p",{class:"quiet",children:"Keys of a part work while it has the focus."}),u("button",{type:"button",onClick:()=>n.current?.close(),children:"Close"})]})]})}var G0="#study=",V0=1e5,IM=1e6;async function cF(n){let e=new Blob([n]).stream().pipeThrough(new CompressionStream("deflate-raw")),t=new Uint8Array(await new Response(e).arrayBuffer()),i="";for(let s of t)i+=String.fromCharCode(s);let r=btoa(i).replaceAll("+","-").replaceAll("/","_").replace(/=+$/,"");return`${location.origin}${location.pathname}${G0}${r}`}async function uF(n){if(n.length>V0)throw new Error(`it has more than ${V0} letters`);let e=Uint8Array.from(atob(n.replaceAll("-","+").replaceAll("_","/")),o=>o.charCodeAt(0)),t=new Blob([e]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader(),i=new TextDecoder("utf-8",{fatal:!0}),[r,s]=["",0];for(;;){let{done:o,value:a}=await t.read();if(o)return r+i.decode();if(s+=a.length,s>IM)throw await t.cancel(),new Error(`the study in it has more than ${IM} bytes`);r+=i.decode(a,{stream:!0})}}async function H0(){if(!location.hash.startsWith(G0))return;let n=location.hash.slice(G0.length);history.replaceState(null,"",location.pathname);try{let e=await uF(n);if(e===At.peek()||da.peek()&&!confirm("The link has another study. Leave the text that is not saved? Undo brings it back."))return;b0(e)}catch(e){Jn.value=hF(`${n.slice(0,40)}${n.length>40?"...":""}`,e)}}function hF(n,e){return{code:"malformed",argument:"link",given:n,allowed:'a link that "Copy link" has made',cause:e instanceof Error&&e.constructor===Error?e.message:"the link is damaged or incomplete",next_step:"copy the link again, or open the file of the study",path:"",line:null}}async function LM(){let n=await cF(At.peek());if(n.length>V0)return"The study is too long for a link. Send its file.";try{return await navigator.clipboard.writeText(n),"The link is copied. It contains the whole study."}catch{return prompt("Copy this link. It contains the whole study.",n),""}}var dF=6e3;function DM({start:n}){let[e,t]=Rt(null),[i,r]=Rt(""),s=l=>{r(l),setTimeout(()=>r(""),dF)},o=Ke(null),a=e??lr.value??"";return u("header",{class:"bar",children:[u("div",{class:"row",children:[u("h1",{children:"haptonic studio"}),u("label",{children:["New, from a template",u("select",{value:"",onChange:l=>{let c=l.currentTarget.value;l.currentTarget.value="",t(null),c&&Cw(c)},children:[u("option",{value:"",children:"choose"}),Object.entries(n.templates).map(([l,c])=>u("option",{value:l,title:c,children:l}))]})]}),u("label",{children:["Open, in ",n.folder,u("select",{value:"",onChange:l=>{let c=l.currentTarget.value;l.currentTarget.value="",t(null),c&&fa(c)},children:[u("option",{value:"",children:os.value.length>0?"choose":"no study yet"}),os.value.map(l=>u("option",{children:l}))]})]}),u("form",{class:"row",onSubmit:l=>{l.preventDefault();let c=a.trim();c!==""&&(S0(c.endsWith(Ol)?c:`${c}${Ol}`),t(null))},children:[u("label",{children:["File name",u("input",{ref:o,value:a,placeholder:`my${Ol}`,spellcheck:!1,autocomplete:"off",onInput:l=>t(l.currentTarget.value)})]}),u("button",{type:"submit",disabled:a.trim()==="",children:"Save"})]}),u("button",{type:"button",disabled:!xw.value,onClick:zl,children:"Undo"}),u("button",{type:"button",disabled:!bw.value,onClick:Gl,children:"Redo"}),u("button",{type:"button",disabled:At.value==="",onClick:()=>{LM().then(s)},children:"Copy link"}),u(RM,{}),u("a",{class:"narrow",href:"#compute-title",children:"Go to the analyses"}),u("span",{class:"quiet",role:"status",children:i}),u("span",{class:"quiet",role:"status",children:ou.value?`opening ${ou.value}`:da.value?"not saved":lr.value===null?"":"saved"})]}),Jn.value!==null&&u("div",{class:"notice",role:"alert",children:[typeof Jn.value=="string"?u("p",{children:Jn.value}):u(Us,{problem:Jn.value}),x0.value!==null&&u(fF,{name:x0.value,rename:()=>o.current?.select()}),u("button",{type:"button",class:"minor",onClick:()=>Jn.value=null,children:"Close"})]})]})}function fF({name:n,rename:e}){return u("div",{class:"row",children:[u("button",{type:"button",onClick:e,children:"Choose another name"}),u("button",{type:"button",onClick:()=>{S0(n,!0)},children:["Replace ",n]}),u("button",{type:"button",onClick:()=>{fa(n)},children:["Open ",n," in place of this text"]})]})}function NM({branch:{key:n},steps:e,value:t}){let i=Pn(e),r=Xn.value.filter(c=>Fs(c.path,i)),s=Ns.value.filter(c=>Fs(c.path,i)),o=`key-${i}`,a={id:o,"aria-describedby":`${o}-about`,"aria-invalid":r.length>0,"aria-required":n.required},l=c=>{c!==Ir(t)&&Ki(e,pu(n,c))};return u("div",{class:`field${r.length>0?" wrong":""}${t!==void 0?" given":""}`,children:[u("label",{for:o,children:[n.title,n.unit&&n.kind!=="quantities"&&u("span",{class:"quiet",children:" with unit"}),n.required&&t===void 0&&u("span",{class:"quiet",children:" (required)"})]}),n.kind==="boolean"?u("select",{...a,value:Ir(t),onChange:c=>Ki(e,mF(c.currentTarget.value)),children:[u("option",{value:"",children:[n.default," (default)"]}),u("option",{children:"true"}),u("option",{children:"false"})]}):n.closed?u("select",{...a,value:Ir(t),onChange:c=>l(c.currentTarget.value),children:[u("option",{value:"",children:n.default?`${n.default} (default)`:"not given"}),n.names.map(c=>u("option",{children:c})),t!==void 0&&!n.names.includes(Ir(t))&&u("option",{children:Ir(t)})]}):u(gF,{...a,value:Ir(t),lines:pF(t),set:l,placeholder:n.default,names:[...n.names,...n.numbers]}),u("div",{id:`${o}-about`,children:[r.map(c=>u("p",{class:"problem",children:[c.cause,"; ",c.next_step]})),s.map(c=>u("p",{class:"doubt",children:c.text})),u("p",{class:"help",children:[PM(n)," ",u("code",{children:i})]})]})]})}var pF=n=>typeof n=="string"&&n.includes(`
`)?Math.min(n.split(`
`).length+1,30):0,mF=n=>n===""?null:n==="true";function gF({value:n,lines:e,set:t,names:i,...r}){let[s,o]=Rt(null),a={...r,value:s??n,spellcheck:!1,autocomplete:"off",onInput:l=>o(l.currentTarget.value),onBlur:()=>{s!==null&&t(s),o(null)}};return e>0?u("textarea",{...a,rows:e,wrap:"off"}):u(ot,{children:[u("input",{...a,type:"text",list:i.length>0?`${r.id}-names`:void 0,onKeyDown:l=>{l.key==="Enter"&&s!==null&&t(s),l.key==="Escape"&&o(null)}}),i.length>0&&u("datalist",{id:`${r.id}-names`,children:i.map(l=>u("option",{value:l}))})]})}var vF=3;function UM({tree:n}){return u("div",{class:"form",children:[ss.value&&u("p",{class:"problem",role:"status",children:"The text has a mistake in its syntax. The form shows the last values until it is corrected."}),u("fieldset",{disabled:ss.value,children:[u("legend",{class:"hidden",children:"Keys of the study"}),u(W0,{branches:n,steps:[],given:ar.value})]})]})}function W0({branches:n,steps:e,given:t}){let[i,r]=Ge(()=>[new Set,new Set],[To.value]),s=({name:v,key:g})=>!g.required&&!i.has(v)&&(t[v]===void 0||r.has(v)),[o,a]=[n.filter(v=>!z0(v)),n.filter(z0)],l=e.length>0&&!o.every(s),c=o.filter(v=>s(v)&&v.key.kind!=="choice"),h=l&&c.length>=vF?c:[],d=e.length===0?a.filter(s):[],f=o.filter(v=>!h.includes(v)),p=a.filter(v=>!d.includes(v));for(let{name:v}of[...f,...p])i.add(v);let m=v=>u("div",{class:"fields",children:v.map(g=>u(NM,{branch:g,steps:[...e,g.name],value:t[g.name]},g.key.path))}),_=v=>u(_F,{branch:v,steps:[...e,v.name],value:t[v.name],onOpen:()=>r.add(v.name)},v.key.path);return u(ot,{children:[f.length>0&&m(f),h.length>0&&u(FM,{title:"Further keys",about:h.map(({key:v})=>sp(v.title)).join(", "),steps:e,branches:h,children:u("div",{onFocusIn:()=>h.forEach(({name:v})=>r.add(v)),children:m(h)})}),p.map(_),d.length>0&&u(FM,{title:"Further tables",about:"that the study does not have",steps:e,branches:d,children:d.map(_)})]})}function FM({title:n,about:e,steps:t,branches:i,children:r}){let[s,o]=Rt(!1),l=i.map(({name:c})=>Pn([...t,c])).some(c=>OM(c)||Xn.value.some(h=>Fs(h.path,c)));return mt(()=>{l&&o(!0)},[l]),u("details",{class:"further",open:s,onToggle:({currentTarget:c})=>o(c.open),children:[u("summary",{children:[n," ",u("span",{class:"quiet",children:e})]}),r]})}var OM=n=>kl.value!==null&&Fs(kl.value.path,n);function _F({branch:n,steps:e,value:t,onOpen:i}){let{key:r}=n,s=Pn(e),o=Xn.value.filter(m=>Fs(m.path,s)),a=o.filter(m=>m.path===s),[l,c]=Rt(null),h=m=>{c(m),m&&i()},d=Ke(null),f=OM(s)?kl.value:null;mt(()=>{f===null||f.isReached||(h(!0),f.path===s&&(d.current?.scrollIntoView(),d.current?.querySelector("summary")?.focus(),f.isReached=!0))},[f]);let p=l??(r.required||e.length>1&&t!==void 0);return u("details",{ref:d,class:"section",open:p,onToggle:({currentTarget:m})=>{m.open!==p&&h(m.open)},children:[u("summary",{children:[r.title,u("span",{class:"quiet",children:[" ",SF(t)]}),o.length>0&&u("span",{class:"problem",children:[" ",o.length," problem",o.length>1?"s":""]})]}),p&&u("div",{class:"inside",children:[u("p",{class:"quiet",children:[r.help," ",u("code",{children:r.kind==="tables"?`[[${s}]]`:`[${s}]`})]}),a.map(m=>u("p",{class:"problem",children:[m.cause,"; ",m.next_step]})),r.kind==="tables"?u(xF,{branch:n,steps:e,items:Array.isArray(t)?t:[]}):r.kind==="entries"?u(bF,{branch:n,steps:e,given:X0(t)}):u(yF,{branch:n,steps:e,value:t})]})]})}function yF({branch:n,steps:e,value:t}){let{key:i}=n,r=`key-${Pn(e)}`,s=i.names.length>0,o=s&&(t===void 0||typeof t=="string");return u(ot,{children:[s&&u("div",{class:"field",children:[u("label",{for:r,children:[i.title,", by name"]}),u("select",{id:r,value:o?Ir(t):`
`,onChange:a=>{let l=a.currentTarget.value;Ki(e,l===""?null:l===`
`?{}:l)},children:[u("option",{value:"",children:"not given"}),i.names.map(a=>u("option",{children:a})),typeof t=="string"&&!i.names.includes(t)&&u("option",{children:t}),u("option",{value:`
`,children:"other, by its constants"})]})]}),!o&&u(W0,{branches:n.inside,steps:e,given:X0(t)}),t!==void 0&&!i.required&&u(q0,{steps:e,children:["Remove ",sp(i.title)]})]})}function xF({branch:n,steps:e,items:t}){let i=sp(n.key.title);return u(ot,{children:[t.map((r,s)=>u("fieldset",{class:"item",children:[u("legend",{children:[n.key.title," ",s+1]}),u(W0,{branches:n.inside,steps:[...e,s],given:X0(r)}),u(q0,{steps:[...e,s],children:["Remove ",i," ",s+1]})]},s)),u("button",{type:"button",onClick:()=>Ki([...e,t.length],{}),children:["Add to ",i]})]})}function bF({branch:{key:n},steps:e,given:t}){let[i,r]=Rt(""),[s,o]=Rt(""),a=Pn(e);return u(ot,{children:[u("ul",{class:"entries",children:Object.entries(t).map(([l,c])=>u("li",{children:[u("label",{for:`key-${a}.${l}`,children:l}),u("input",{id:`key-${a}.${l}`,value:Ir(c),onChange:h=>Ki([...e,l],pu(n,h.currentTarget.value))}),u(q0,{steps:[...e,l],children:["Remove ",l]})]},l))}),u("div",{class:"row",children:[u("label",{children:["Name",u("input",{value:i,onInput:l=>r(l.currentTarget.value)})]}),u("label",{children:["Value",u("input",{value:s,onInput:l=>o(l.currentTarget.value)})]}),u("button",{type:"button",disabled:i===""||s==="",onClick:()=>{Ki([...e,i],pu(n,s)),r(""),o("")},children:"Add a line"})]})]})}function q0({steps:n,children:e}){return u("button",{type:"button",class:"minor",onClick:()=>Ki(n,null),children:e})}function SF(n){return n===void 0?"":typeof n=="string"?n:Array.isArray(n)?`${n.length} in the study`:"in the study"}function X0(n){return typeof n=="object"&&!Array.isArray(n)?n:{}}var wF="seconds";function kM(){let n=0;Je(()=>{!Vw.value||To.value===n||(n=To.value,cr(MF))})}async function MF(){let n=()=>Kt.peek()===null&&Mo.peek()===null&&Hf()===void 0,e=Ro.peek();if(!n()||e===null||!Rr.peek()||Co.peek()||Po.peek().length>0)return;let{costs:t}=await vt.forecast(e.text),i=t.find(({command:r})=>r===gi.peek()?.name);i?.time!==wF||i.refusal||!n()||Ro.peek()?.text!==e.text||(Kt.value=(await vt.run(e)).number)}var TF=["plate","map"],EF=["plate","rows"];function BM(n){let{map:e,rows:t}=n;if(typeof e!="string")return null;let i=e.trim().split(/\r?\n/).map(s=>Array.from(s.trim())),r=i[0]?.length??0;return r===0||i.some(s=>s.length!==r)?null:typeof t!="number"||t%i.length!==0||t<=0||t*r>1e5?i:Array.from({length:t},(s,o)=>i[o%i.length]??[])}function zM(n,e){let t=e.rows!==void 0,i=n.map(a=>a.join("")),r=t?AF(i):i.length,s=`${i.slice(0,r).join(`
`)}
`,o=r<i.length?i.length:null;return[...s.trim()===String(e.map).trim()?[]:[{steps:TF,value:s}],...t&&e.rows!==o?[{steps:EF,value:o}]:[]]}function AF(n){for(let e=1;e<=n.length/2;e++)if(n.length%e===0&&n.every((t,i)=>t===n[i%e]))return e;return n.length}function GM(n,e,t){let i=new Map;for(let[r,s]of e){let o=i.get(r)??n[r]?.slice();o===void 0||s<0||s>=o.length||(o[s]=t,i.set(r,o))}return n.map((r,s)=>i.get(s)??r)}function $0([n,e],[t,i]){let r=Math.max(Math.abs(t-n),Math.abs(i-e));return Array.from({length:r+1},(s,o)=>{let a=r===0?0:o/r;return[Math.round(n+a*(t-n)),Math.round(e+a*(i-e))]})}function VM([n,e],[t,i]){let r=[];for(let s=Math.min(n,t);s<=Math.max(n,t);s++)for(let o=Math.min(e,i);o<=Math.max(e,i);o++)r.push([s,o]);return r}function Y0(n,e){let t=n[e[0]]?.[e[1]],i=n.map(s=>s.map(()=>!1)),r=[];for(let s=[e];;){let o=s.pop();if(o===void 0)return r;let[a,l]=o,c=i[a];c===void 0||c[l]!==!1||n[a]?.[l]!==t||(c[l]=!0,r.push(o),s.push([a-1,l],[a+1,l],[a,l-1],[a,l+1]))}}function HM(n,e,t,i){let[r,s]=[n.length-1,(n[0]?.length??0)-1],o=t?[...e,...e.map(([a,l])=>[a,s-l])]:e;return i?[...o,...o.map(([a,l])=>[r-a,l])]:o}function WM(n,e,t){if(e==="above"||e==="below"){let i=e==="above";if(!t)return n.length===1?n:i?n.slice(1):n.slice(0,-1);let r=(i?n[0]:n.at(-1))??[];return i?[r,...n]:[...n,r]}return n.map(i=>{let r=e==="left";if(!t)return i.length===1?i:r?i.slice(1):i.slice(0,-1);let s=(r?i[0]:i.at(-1))??".";return r?[s,...i]:[...i,s]})}function K0(n,e){let t=e.length>1?(e.at(-1)??1)/(e.length-1):1;return e.length===n+1?e:Array.from({length:n+1},(i,r)=>r*t)}var qM={m:1,cm:.01,mm:.001,um:1e-6,µm:1e-6,nm:1e-9},XM="mm",CF=50;function YM(n){let e=n/CF,t=10**Math.floor(Math.log10(e)+1e-9);return([5,2].find(i=>i*t<=e*(1+1e-9))??1)*t}function mu(n,e,t,i,r){let s=Math.round(n/i)*i,o=r,a=t.flatMap((l,c)=>[l,(l+(t[c+1]??l))/2]);for(let l of e>0?[0,-e,e]:[0])for(let c of a){let h=Math.abs(n+l-c);h<o&&([s,o]=[c-l,h])}return s}function op(n,e){let t=/^\s*[-+.\deE]+\s*([a-zµ]+)\s*$/.exec(String(e??""))?.[1]??XM,[i,r]=t in qM?[t,qM[t]??.001]:[XM,.001];return`${Number((n/r).toPrecision(9))} ${i}`}function PF(n,e){let t=n;for(let i of e)t=Array.isArray(t)?t[Number(i)]:t?.[String(i)];return t??{}}var $M=n=>Array.isArray(n)?n:[];function KM(n,e,t){let i=PF(t,n.steps),[r,s]=[$M(i.centre),$M(i.size)],o=e.centre.map((c,h)=>op(c-n.corner[h],r[h])),a=e.size.map((c,h)=>h<2?op(c,s[h]):s[h]??""),l=(c,h)=>c.some((d,f)=>d!==h[f]);return[...l(o,r)?[{steps:[...n.steps,"centre"],value:o}]:[],...e.size.length>0&&l(a,s)?[{steps:[...n.steps,"size"],value:a}]:[]]}var No="plate.clamp.corners",hn=re("brush"),_a=re(""),Z0=re(!1),J0=re(!1),Lr=re([0,0]),Dr=re(null),ks=re([]),vi=re(""),gu=re({}),_u=re(null),ap=re(null),vu=re([]);Je(()=>{To.value,vu.value=[]});var Do=Ve(()=>{let n=ar.value.plate;return typeof n=="object"&&!Array.isArray(n)?n:null}),ur=re(null);Je(()=>{(Mo.value!==null||Do.value===null)&&(ur.value=Mo.value)});var JM=n=>typeof n=="object"&&!Array.isArray(n)?Object.entries(n):[],Ai=Ve(()=>{let n=JM(Do.value?.tiles).map(([i,r])=>({letter:i,name:String(r),isNew:!1})),e=new Set(n.map(({letter:i})=>i)),t=vu.value.filter(({letter:i})=>!e.has(i)).map(i=>({...i,isNew:!0}));return[...n,...t,{letter:".",name:"no plate",isNew:!1}]}),j0=Ve(()=>Do.value===null?null:BM(Do.value)),ri=Ve(()=>{let n=ap.value??j0.value;return n===null||ks.value.length===0?n:GM(n,HM(n,ks.value,Z0.value,J0.value),Q0())}),Bs=Ve(()=>(ur.value?.parts??[]).map(n=>({...n,...gu.value[Pn(n.steps)]}))),zs=Ve(()=>_u.value??ur.value?.clamp??null),jM=Ve(()=>ap.value!==null),Q0=()=>Ai.value.some(({letter:n})=>n===_a.value)?_a.value:Ai.value[0]?.letter??".";Je(()=>{ur.value,gu.value={},_u.value=null});var ZM=0;function yu(n){if(ks.value=[],n===null)return;let e=ZM+=1;ap.value=n;let t=new Set(n.flat());Bl(()=>[...vu.peek().filter(({letter:i})=>t.has(i)&&!RF(i)).map(({letter:i,name:r})=>({steps:["plate","tiles",i],value:r})),...zM(n,Do.peek()??{})]).then(()=>{e===ZM&&(ap.value=null)})}var RF=n=>JM(Do.peek()?.tiles).some(([e])=>e===n);function xu(n){ks.value=n,yu(ri.peek())}var IF="123456789abcdefghijklmnpqrstuvwxyzABCDEFGHIJKLMNPQRSTUVWXYZ";function QM(n){let e=new Set(Ai.peek().map(({letter:i})=>i)),t=Array.from(IF).find(i=>!e.has(i));t!==void 0&&(vu.value=[...vu.peek(),{letter:t,name:n}],_a.value=t)}function lp(n,e){gu.value={...gu.peek(),[Pn(n.steps)]:e}}function cp(n){let e=gu.peek()[Pn(n.steps)];e!==void 0&&Bl(()=>KM(n,e,ar.peek()))}var xa=12,up=5,LF=5,DF=4,NF=.6,t1=()=>({ink:Xe("ink"),rim:Xe("paper")});function n1(n,e){let t=ur.peek(),i=K0(n[0]?.length??1,t?.x??[]),r=K0(n.length,t?.y??[]),[s,o]=[i.at(-1)??1,r.at(-1)??1],a=Math.max(e-2*xa,50);return{x:i,y:r,scale:Math.min(a/s,NF*innerHeight/o)}}var i1=({x:n,y:e,scale:t})=>[(n.at(-1)??0)*t+2*xa,(e.at(-1)??0)*t+2*xa],r1=({y:n,scale:e},[t,i])=>[(t-xa)/e,(n.at(-1)??0)-(i-xa)/e];function hp({x:n,y:e},[t,i]){let r=n.findIndex(o=>o>t)-1,s=e.findIndex(o=>o>i)-1;return r<0||s<0?null:[e.length-2-s,r]}function ev(n){let e=ur.value?.lattices??[],i=Ai.value.filter(({letter:r,name:s})=>r!=="."&&s!==e[0]).findIndex(r=>r.letter===n);return i<0?"rule":`curve-${i%DF}`}function tv({x:n,y:e},t){let[i,r]=[n.at(-1)??0,e.at(-1)??0],s=o=>[t,o-t];return[0,r].flatMap(o=>s(i).map(a=>[a,o])).concat([0,i].flatMap(o=>s(r).map(a=>[o,a])))}function s1(n,e,t){let[i,r,s]=[n.getContext("2d"),ri.peek(),ur.peek()];if(i===null||r===null)return;let o=devicePixelRatio,a=e.y.at(-1)??0,l=([h,d])=>[o*(xa+h*e.scale),o*(xa+(a-d)*e.scale)];i.clearRect(0,0,n.width,n.height),FF(i,r,e,l),s!==null&&UF(i,s,r,e,l),OF(i,e,l);let c=[[t&&hn.peek()!=="move"?Lr.peek():null,"accent",[]],[Dr.peek(),"carrier",[3,3]]];for(let[h,d,f]of c)h!==null&&kF(i,h,e,l,d,f)}function o1([n,e],{x:t,y:i}){let r=i.length-2-n;return[[t[e]??0,i[r+1]??0],[t[e+1]??0,i[r]??0]]}function FF(n,e,t,i){let r=new Map(Ai.peek().map(({letter:c})=>[c,Xe(ev(c))]));n.save(),n.globalAlpha=.34,e.forEach((c,h)=>c.forEach((d,f)=>{if(d===".")return;let[[p,m],[_,v]]=o1([h,f],t).map(i);n.fillStyle=r.get(d)??Xe("carrier"),n.fillRect(p,m,_-p,v-m)}));let[s,o]=[t.x.length-1,t.y.length-1],[a,l]=[t.x.at(-1)??0,t.y.at(-1)??0];if(a/s*t.scale>=LF){n.globalAlpha=1,n.strokeStyle=Xe("rule"),n.lineWidth=1,n.beginPath();let c=[...t.x.map(h=>[[h,0],[h,l]]),...t.y.map(h=>[[0,h],[a,h]])];for(let[h,d]of c)n.moveTo(...i(h)),n.lineTo(...i(d));n.stroke()}n.restore(),n.canvas.dataset.tiles=`${s} x ${o}`}function UF(n,e,t,i,r){let s=j0.peek();if(e.x.length!==i.x.length||e.y.length!==i.y.length)return;let o=a=>{let l=hp(i,a);return l!==null&&t[l[0]]?.[l[1]]===s?.[l[0]]?.[l[1]]};n.strokeStyle=n.fillStyle=Xe("quiet"),n.lineWidth=devicePixelRatio,pf(n,e.features,r,o),n.stroke(),n.strokeStyle=Xe("ink");for(let a of e.plate)rs(n,a,r);mf(n,e.held,r);for(let[a,l]of Object.entries(e.regions))Il(n,a,l,r,t1())}function OF(n,e,t){let i=hn.peek()==="move";n.lineWidth=1.5*devicePixelRatio;for(let s of Bs.peek()){let[o=0,a=0]=s.diameter===null?s.size:[s.diameter,s.diameter],l=So(s.centre,[o,a]);if(n.save(),n.strokeStyle=Xe("ink"),n.fillStyle=Xe("gap"),n.beginPath(),s.diameter!==null||o===0){let f=Math.max((s.diameter??0)/2*e.scale,up)*devicePixelRatio;n.arc(...t(s.centre),f,0,2*Math.PI)}else ru(n,l,t);n.globalAlpha=s.diameter===null?.85:.3,n.fill(),n.globalAlpha=1,n.stroke(),n.restore();let[c,h]=t([s.centre[0],s.centre[1]]),d=o===0?-10:4;t0(n,s.name,[c,h+d*devicePixelRatio],t1()),i&&Pn(s.steps)===vi.peek()&&e1(n,s.size.length>0?l:[s.centre],t)}let r=zs.peek();i&&r!==null&&vi.peek()===No&&e1(n,tv(e,r),t)}function e1(n,e,t){let i=up*devicePixelRatio;n.fillStyle=Xe("paper"),n.strokeStyle=Xe("accent");for(let r of e){let[s,o]=t(r);n.fillRect(s-i,o-i,2*i,2*i),n.strokeRect(s-i,o-i,2*i,2*i)}}function kF(n,e,t,i,r,s){let[[o,a],[l,c]]=o1(e,t).map(i);n.save(),n.strokeStyle=Xe(r),n.lineWidth=2.5*devicePixelRatio,n.setLineDash(s.map(h=>h*devicePixelRatio)),n.strokeRect(o,a,l-o,c-a),n.restore()}var BF=800,zF=Ve(()=>mi.value.some(({state:n,turned:e})=>n==="running"&&e)),nv=n=>String(Number(n.toPrecision(3)));function a1(){let[n,e]=[ri.value,ur.value];if(n===null)return null;let t=new Map;for(let o of n.flat())t.set(o,(t.get(o)??0)+1);let i=e!==null&&e.x.length===(n[0]?.length??0)+1&&e.y.length===n.length+1,r=jM.value||Xn.value.length>0,s=[...Ai.value.filter(({letter:o})=>o!==".").map(({letter:o,name:a})=>[a,`${t.get(o)??0} tiles`]),["map",`${n[0]?.length} x ${n.length} tiles`]];return e!==null&&i&&(s.push(["size",`${nv(1e3*(e.x.at(-1)??0))} x ${nv(1e3*(e.y.at(-1)??0))} mm`]),s.push(["contents",e.contents]),e.mass!==null&&s.push(["mass without patches",`${nv(1e3*e.mass)} g`])),u("div",{class:"facts",children:[u(_i,{facts:s}),r&&u("p",{class:"quiet",children:"Size, contents and mass are those of the last map that could be built."}),!r&&e?.remarks.map(o=>u("p",{class:"doubt",children:o}))]})}function l1(){let[n,e]=Rt(null),t=Ke(null),i=Ke(!1),r=At.value,s=zF.value;mt(()=>{if(s)return;let a=setTimeout(async()=>{if(t.current=r,!i.current){for(i.current=!0;t.current!==null;){let l=t.current;t.current=null;try{e({of:l,...await vt.forecast(l)})}catch{}}i.current=!1}},BF);return()=>clearTimeout(a)},[r,s]);let o=n===null||n.of!==r;return u("details",{open:!0,children:[u("summary",{children:["Estimated costs ",u("span",{class:"quiet",children:"as orders of magnitude"})]}),o?u("p",{class:"quiet",children:"Estimated again after a moment without changes."}):n.costs.length===0?u("p",{class:"quiet",children:"Not estimated, because the study has a problem."}):u("table",{children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"command"}),u("th",{scope:"col",children:"processor time"}),u("th",{scope:"col",children:"memory"})]})}),u("tbody",{children:n.costs.map(({command:a,time:l,memory:c,refusal:h})=>u("tr",{children:[u("td",{children:["haptonic ",a]}),u("td",{children:h?`refused: ${h}`:l}),u("td",{children:h?"":c})]}))})]})]})}var h1=6,iv={b:"brush",l:"line",r:"rectangle",f:"fill",v:"move"},GF=10;function d1(n,e){return hn.peek()==="rectangle"?VM(n,e):$0(n,e)}function dp({x:n}){return YM((n.at(-1)??1)/Math.max(n.length-1,1))}function f1(n,e){let t=null,i=()=>{},r=h=>{let d=n.getBoundingClientRect();return r1(e(),[h.clientX-d.left,h.clientY-d.top])},c={pointerdown:h=>{if(h.button!==0)return;let d=r(h);hn.peek()==="move"?[t,i]=HF(e(),d):[t,i]=VF(e(),d),t!==null&&n.setPointerCapture(h.pointerId)},pointermove:h=>t?.(r(h)),pointerup:()=>{t!==null&&i(),t=null},pointercancel:()=>{t=null,ks.value=[]}};for(let[h,d]of Object.entries(c))n.addEventListener(h,d);return()=>{for(let[h,d]of Object.entries(c))n.removeEventListener(h,d)}}var rv=[null,()=>{}];function VF(n,e){let[t,i]=[hp(n,e),ri.peek()];if(t===null||i===null)return rv;if(Lr.value=t,Dr.value=null,hn.peek()==="fill")return xu(Y0(i,t)),rv;let r=t;return ks.value=[t],[o=>{let a=hp(n,o);a===null||a[0]===r[0]&&a[1]===r[1]||(ks.value=hn.peek()==="brush"?[...ks.peek(),...$0(r,a)]:d1(t,a),Lr.value=r=a)},()=>yu(ri.peek())]}function HF(n,e){let t=2*up/n.scale,i=([d,f])=>Math.hypot(e[0]-d,e[1]-f)<t,r=Bs.peek(),s=r.find(d=>Pn(d.steps)===vi.peek());if(s!==void 0&&s.size.length>0){let[d=0,f=0]=s.size,p=So(s.centre,[d,f]),m=p.findIndex(i),_=p[(m+2)%4];if(m>=0&&_!==void 0)return[v=>lp(s,qF(s,_,v,n)),()=>cp(s)]}let o=zs.peek();if(o!==null&&tv(n,o).some(i))return vi.value=No,[d=>p1(XF(d,n),n),m1];let a=[...r].reverse().find(({centre:d,size:f,diameter:p})=>{let[m=0,_=0]=p===null?f:[p,p],[v,g]=[Math.abs(e[0]-d[0]),Math.abs(e[1]-d[1])];return v<Math.max(m/2,t)&&g<Math.max(_/2,t)});if(vi.value=a===void 0?"":Pn(a.steps),a===void 0)return rv;let[l,c]=[e[0]-a.centre[0],e[1]-a.centre[1]];return[([d,f])=>lp(a,WF(a,[d-l,f-c],n)),()=>cp(a)]}function WF(n,[e,t],i){let[r=0,s=0]=n.diameter===null?n.size:[n.diameter,n.diameter],[o,a]=[dp(i),h1/i.scale],l=[mu(e,r/2,i.x,o,a),mu(t,s/2,i.y,o,a)];return{...n,centre:l}}function qF(n,[e,t],[i,r],s){let[o,a]=[dp(s),h1/s.scale],[l,c]=[mu(i,0,s.x,o,a),mu(r,0,s.y,o,a)],h=[Math.max(Math.abs(l-e),o),Math.max(Math.abs(c-t),o)];return{...n,centre:[(e+l)/2,(t+c)/2],size:[...h,...n.size.slice(2)]}}function XF([n,e],t){let[i,r]=[t.x.at(-1)??0,t.y.at(-1)??0],[s,o]=[Math.min(n,i-n),Math.min(e,r-e)];return Math.max(s,o)}function p1(n,e){let t=dp(e);_u.value=Math.max(Math.round(n/t)*t,t)}function m1(){let n=_u.peek();if(n===null)return;let e=["plate","clamp","corners"];Bl(()=>{let t=ar.peek().plate;return[{steps:e,value:op(n,t.clamp?.corners)}]})}function c1(n,[e,t],i){let r=dp(n);if(vi.peek()===No){p1((zs.peek()??r)+(e+t)*r,n),m1();return}let s=Bs.peek().find(({steps:d})=>Pn(d)===vi.peek());if(s===void 0)return;let[o,a]=s.centre,[l=0,c=0,...h]=s.size;i&&s.size.length===0||(lp(s,i?{...s,size:[Math.max(l+e*r,r),Math.max(c+t*r,r),...h]}:{...s,centre:[o+e*r,a+t*r]}),cp(s))}function $F(n,e){let t=ri.peek();if(t===null)return;let[i,r]=Lr.peek(),s=(o,a)=>Math.min(Math.max(o,0),a-1);Lr.value=[s(i-e,t.length),s(r+n,t[0]?.length??1)]}function YF(){let[n,e,t]=[ri.peek(),Lr.peek(),Dr.peek()];n===null||hn.peek()==="move"||(hn.peek()==="fill"?xu(Y0(n,e)):hn.peek()==="brush"?xu([e]):t===null?Dr.value=e:(Dr.value=null,xu(d1(t,e))))}function u1(n){let e=[...Bs.peek().map(({steps:r})=>Pn(r)),...ur.peek()?.clamp?[No]:[]],t=e.length,i=e.indexOf(vi.peek())+n;vi.value=e[(i%t+t)%t]??"",hn.value="move"}function g1(n){let e=(r,s)=>o=>{let a=o.shiftKey?GF:1;hn.peek()!=="move"?$F(r*a,s*a):c1(n(),[r*a,s*a],!1)},t=r=>()=>{let s=Ai.peek()[r];s!==void 0&&(_a.value=s.letter)},i=(r,s)=>()=>{hn.peek()==="move"&&c1(n(),[r,s],!0)};return[{keys:"← → ↑ ↓",effect:"move the cursor, or the selected part; ten steps with Shift",actions:{ArrowLeft:e(-1,0),ArrowRight:e(1,0),ArrowUp:e(0,1),ArrowDown:e(0,-1)}},{keys:"space",effect:"paint; of a line or rectangle first one end, then the other",actions:{" ":YF}},{keys:"1 … 9",effect:"choose a tile, in the order of the palette",actions:Object.fromEntries(Array.from({length:9},(r,s)=>[String(s+1),t(s)]))},{keys:Object.keys(iv).join(" "),effect:Object.values(iv).join(", "),actions:Object.fromEntries(Object.entries(iv).map(([r,s])=>[r,()=>hn.value=s]))},{keys:"n p",effect:"select the next or the previous part",actions:{n:()=>u1(1),p:()=>u1(-1)}},{keys:"+ − > <",effect:"make the selected patch wider, narrower, higher or lower",actions:{"+":i(1,0),"-":i(-1,0),">":i(0,1),"<":i(0,-1)}},{keys:"Esc",effect:"forget the first end",actions:{Escape:()=>Dr.value=null}}]}var KF={brush:"Brush",line:"Line",rectangle:"Rectangle",fill:"Fill",move:"Move parts"},ZF=["left","right","above","below"],JF={x:[0,1],y:[0,1],scale:1};function v1({first:n}){return Object.keys(ar.value).length===0?null:Do.value===null?u("p",{class:"paint",children:[u("button",{type:"button",class:"minor",disabled:ss.value,onClick:()=>Ki(["plate"],n),children:"Begin a plate"})," ",u("span",{class:"quiet",children:"of this cell, and paint its map"})]}):u("details",{class:"section paint",open:zf.value,onToggle:e=>zf.value=e.currentTarget.open,children:[u("summary",{children:["Map of the plate ",u("span",{class:"quiet",children:"painted with tiles; parts are dragged"})]}),ri.value===null?u("p",{class:"problem",children:"The map can be painted when it has letters, and all its lines are equally long."}):u(jF,{})]})}function jF(){let n=Ke(null),e=Ke(JF),[t]=Rt(()=>g1(()=>e.current));return mt(()=>{let i=n.current;if(i===null)return;let r=()=>{let a=ri.peek();if(a===null)return;e.current=n1(a,i.parentElement?.clientWidth??300);let[l,c]=i1(e.current),[h,d]=[l,c].map(f=>Math.round(f*devicePixelRatio));(i.width!==h||i.height!==d)&&([i.width,i.height]=[h??0,d??0],[i.style.width,i.style.height]=[`${l}px`,`${c}px`]),s1(i,e.current,document.activeElement===i)},s=new ResizeObserver(r);i.parentElement!==null&&s.observe(i.parentElement),i.addEventListener("focus",r),i.addEventListener("blur",r);let o=[f1(i,()=>e.current),Qn(r),Je(()=>{ri.value,Bs.value,hn.value,Lr.value,Dr.value,vi.value,zs.value,Ai.value,r()})];return()=>{s.disconnect();for(let a of o)a()}},[]),u("div",{class:"inside",children:[u(QF,{}),u(eU,{}),u("div",{class:"board",children:[u("canvas",{ref:n,tabIndex:0,role:"application","aria-label":"Map of the plate. Arrow keys move, the space bar paints, digits choose a tile.","aria-describedby":"paint-place",onKeyDown:i=>{(i.ctrlKey||i.metaKey)&&i.key.toLowerCase()==="z"?(i.preventDefault(),(i.shiftKey?Gl:zl)()):Vr(i,t)}}),u("div",{class:"beside",children:[u(tU,{}),u(a1,{}),u(nU,{}),u(iU,{}),u(l1,{})]})]}),u("details",{children:[u("summary",{children:"Keys on the map"}),u(hc,{keys:t})]})]})}function QF(){let[n,e]=Rt("");return u("div",{class:"row palette",role:"group","aria-label":"Tiles",children:[Ai.value.map(({letter:t,name:i})=>u("button",{type:"button",class:"minor","aria-pressed":t===Q0()&&hn.value!=="move",onClick:()=>{_a.value=t,hn.peek()==="move"&&(hn.value="brush")},children:[u("span",{class:"swatch",style:{background:t==="."?"none":`var(--${ev(t)})`},"aria-hidden":"true"}),u("code",{children:t})," ",i]})),u("form",{class:"row",onSubmit:t=>{t.preventDefault(),QM(n.trim()),e("")},children:[u("input",{"aria-label":"Name of a new region or lattice",placeholder:"new tile",size:9,value:n,onInput:t=>e(t.currentTarget.value)}),u("button",{type:"submit",class:"minor",disabled:n.trim()==="",children:"Add"})]})]})}function eU(){let n=[{signal:Z0,words:"mirror left and right"},{signal:J0,words:"mirror top and bottom"}];return u("div",{class:"row",role:"group","aria-label":"Tools",children:[Object.entries(KF).map(([e,t])=>u("button",{type:"button",class:"minor","aria-pressed":hn.value===e,onClick:()=>hn.value=e,children:t})),n.map(({signal:e,words:t})=>u("label",{class:"check",children:[u("input",{type:"checkbox",checked:e.value,onChange:i=>e.value=i.currentTarget.checked}),t]}))]})}function tU(){let n=Bs.value.find(({steps:l})=>Pn(l)===vi.value),e=l=>Number((1e3*l).toPrecision(6)),[t,i]=Lr.value,r=ri.value?.[t]?.[i],s=Ai.value.find(l=>l.letter===r)?.name??"",o=n!==void 0&&n.size.length>0?`, ${n.size.slice(0,2).map(e).join(" x ")} mm`:"",a=hn.value!=="move"?`Row ${t+1} from above, column ${i+1}: ${r??""} ${s}${Dr.value===null?"":"; the first end is chosen"}`:n!==void 0?`${n.name}: centre at ${n.centre.map(e).join(" and ")} mm on the plate${o}`:vi.value===No&&zs.value!==null?`Corners supported over ${e(zs.value)} mm`:"Select a part in the drawing, or with the key n.";return u("p",{id:"paint-place",class:"small","aria-live":"polite",children:a})}function nU(){let n=(e,t)=>{let i=ri.peek();i!==null&&yu(WM(i,e,t))};return u("div",{class:"row",role:"group","aria-label":"Size of the map",children:ZF.map(e=>u("span",{children:[e," ",u("button",{type:"button",class:"minor","aria-label":`Add a line ${e}`,onClick:()=>n(e,!0),children:"+"})," ",u("button",{type:"button",class:"minor","aria-label":`Remove a line ${e}`,onClick:()=>n(e,!1),children:"−"})]}))})}function iU(){let n=({path:e})=>e==="plate"||e.startsWith("plate.");return u("div",{"aria-live":"polite",children:[Xn.value.filter(n).map(({path:e,cause:t,next_step:i})=>u("p",{class:"problem",children:[u("code",{children:e}),": ",t,"; ",i]})),Ns.value.filter(n).map(({path:e,text:t})=>u("p",{class:"doubt",children:[u("code",{children:e}),": ",t]}))]})}var _1=`.paint .inside { padding-bottom: 0.6rem; }
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
`;var Fo="order of computation",y1="",an=re([]),ql=re(y1),mp=re(null),hr=re(null),sv=null,fp=!1,us=Ve(()=>an.value.map((n,e)=>e).filter(n=>!ql.value||an.value[n]?.group===ql.value)),gp=Ve(()=>[...new Set(an.value.map(n=>n.group))]),pp=Ve(()=>{let n=us.value.map(e=>(an.value[e]?.varied??[]).map(({title:t})=>t));return[...new Set(n[0])].filter(e=>n.every(t=>t.includes(e)))}),ba=Ve(()=>{let n=mp.value;return n!==null&&(n===Fo||pp.value.includes(n))?n:pp.value[0]??Fo});function x1(){Je(()=>{let n=mi.value.find(({number:e})=>e===Kt.value);Kt.value!==sv&&(sv=Kt.value,an.value=[],hr.value=mp.value=null,ql.value=y1),n!==void 0&&n.points>an.value.length&&sU(n.number)})}async function sU(n){fp||(fp=!0,await cr(async()=>{let e=an.peek().length,t=await vt.points(n,e);fp=!1,n===sv&&e===an.peek().length&&(an.value=[...an.peek(),...t])}),fp=!1)}var bu=(n,e,t)=>t===Fo?e+1:n.varied.find(i=>i.title===t)?.value??NaN,oU=[[1e9,"G"],[1e6,"M"],[1e3,"k"],[1,""],[.001,"m"],[1e-6,"µ"]],aU=["Hz","m","Pa"];function vp(n,e){let t=Math.max(...n.map(Math.abs),0);if(e==="rad")return{factor:180/Math.PI,unit:"deg"};let[i,r]=oU.find(([s])=>aU.includes(e)&&t>=s)??[1,""];return{factor:1/i,unit:r+e}}function _p({value:n,unit:e,error:t},i){let r=vp([n],e),s=n*r.factor;return`${i&&t!==null?Ht(s,t*r.factor):Di(String(Number(s.toPrecision(i?4:6))))} ${r.unit}`.trim()+(i&&t===null?" (preview)":"")}var lU=280,cU=3.5,uU=20,hU=4;function yp(){let n=us.value,e=ba.value,t=n.flatMap(h=>an.value[h]?.results??[]),i=t[0]?.unit??"",r=[...new Set(t.filter(h=>h.unit===i).map(h=>h.title))],s=n.map(h=>bu(an.value[h],h,e)),o=an.value[n[0]??0]?.varied.find(h=>h.title===e)?.unit??"",a=e===Fo?{factor:1,unit:""}:vp(s,o),l=vp(t.filter(h=>h.unit===i).map(({value:h})=>h),i);return{list:n.flatMap((h,d)=>(an.value[h]?.results??[]).filter(f=>f.unit===i).map(f=>({place:h,x:s[d]*a.factor,y:f.value*l.factor,error:f.error===null?null:f.error*l.factor,series:r.indexOf(f.title)}))),titles:r,x:a,y:l}}var dU=n=>ba.peek()===Fo&&!Number.isInteger(n)?"":Zs(n);function b1(n){let[e,t]=[Math.min(...n),Math.max(...n)];if(!Number.isFinite(e))return[0,1];let i=.06*(t-e)||Math.abs(t)*.05||1;return[e-i,t+i]}function S1(n){let e=yp(),t=()=>({width:$r(n),height:lU}),i=(o,{unit:a})=>a?`${o} / ${a}`:o,r=()=>({x:b1(e.list.map(o=>o.x)),y:b1(e.list.flatMap(o=>[o.y-(o.error??0),o.y+(o.error??0)]))}),s=new tn({...t(),legend:{show:!1},cursor:{points:{show:!1},x:!1,y:!1,drag:{x:!1,y:!1}},scales:{x:{time:!1,range:()=>r().x},y:{range:()=>r().y}},axes:[{...yr(),label:" ",labelSize:22,size:34,values:(o,a)=>a.map(dU)},{...Xr(),label:" "}],series:[{},{show:!0,stroke:"transparent",points:{show:!1}}],hooks:{draw:[o=>Kr(o,()=>fU(o,e))]}},[[0,1],[0,1]],n);return to(s,(o,a)=>{let l=({x:h,y:d})=>Math.hypot(s.valToPos(h,"x")-o,s.valToPos(d,"y")-a),c=e.list.reduce((h,d)=>h&&l(h)<=l(d)?h:d,null);c!==null&&l(c)<uU&&(hr.value=c.place)}),Yr(s,n,t,[Je(()=>{e=yp(),hr.value,s.axes[0].label=i(ba.value,e.x),s.axes[1].label=i(e.titles.join(", "),e.y);let{x:o,y:a}=r();s.setData([o,a]),n.dataset.marks=String(e.list.length)})])}function fU(n,{list:e}){let{ctx:t}=n,i=cU*devicePixelRatio;t.lineWidth=1.5*devicePixelRatio;for(let{place:r,x:s,y:o,error:a,series:l}of e){let[c,h]=[n.valToPos(s,"x",!0),n.valToPos(o,"y",!0)];t.strokeStyle=t.fillStyle=Xe(`curve-${l%hU}`),t.beginPath(),l%2?t.rect(c-i,h-i,2*i,2*i):t.arc(c,h,i,0,2*Math.PI),a===null||(t.fill(),t.beginPath(),t.moveTo(c,n.valToPos(o-a,"y",!0)),t.lineTo(c,n.valToPos(o+a,"y",!0))),t.stroke(),r===hr.peek()&&(t.strokeStyle=Xe("ink"),t.beginPath(),t.arc(c,h,2.4*i,0,2*Math.PI),t.stroke())}}var ov=500;function w1(n){let e=ba.peek(),t=[...us.peek()].sort((r,s)=>bu(an.peek()[r],r,e)-bu(an.peek()[s],s,e)),i=hr.peek()===null?-1:t.indexOf(hr.peek());hr.value=t[Math.min(Math.max(i+n,0),t.length-1)]??null}var av=n=>{n!==null&&Kt.peek()!==null&&Iw(Kt.peek(),n)},lv=[{keys:"← →",effect:"previous or next design",actions:{ArrowLeft:()=>w1(-1),ArrowRight:()=>w1(1)}},{keys:"Enter",effect:"open the design in the text",actions:{Enter:()=>av(hr.peek())}}];function M1(){let n=an.value.length;return n===0?null:u("details",{class:"section",open:!0,children:[u("summary",{children:["Computed designs ",u("span",{class:"quiet",children:n})]}),u("div",{class:"row",children:[gp.value.length>1&&u("label",{children:["Part",u("select",{value:ql.value,onChange:e=>ql.value=e.currentTarget.value,children:[u("option",{value:"",children:"all"}),gp.value.map(e=>u("option",{children:e}))]})]}),u("label",{children:["Horizontal axis",u("select",{value:ba.value,onChange:e=>mp.value=e.currentTarget.value,children:[...pp.value,Fo].map(e=>u("option",{children:e}))})]}),u(mU,{})]}),u(Hn,{label:"Computed designs. Arrow keys select a design, Enter opens it.",describedBy:"selected-design",onKeyDown:e=>Vr(e,lv),children:u(pU,{})}),u(gU,{}),u("details",{class:"further",children:[u("summary",{children:"Designs as a table"}),u(vU,{})]})]})}function pU(){let n=Ke(null);return mt(()=>n.current===null?void 0:S1(n.current),[]),u("div",{class:"curves",ref:n})}function mU(){let{list:n,titles:e}=yp(),t=us.value.filter(i=>an.value[i]?.results.length===0).length;return u("span",{class:"quiet legend",children:[e.map((i,r)=>u("span",{class:"of-mark",style:{"--mark":`var(--curve-${r%4})`,"--round":r%2?"0":"50%"},children:i})),n.some(({error:i})=>i===null)&&u("span",{class:"of-hollow",children:"hollow: preview, without an error"}),t>0&&u("span",{children:[t," of ",us.value.length," without a result are not in the plot"]})]})}function gU(){let n=hr.value,e=n===null?void 0:an.value[n];if(e===void 0)return u("p",{id:"selected-design",class:"quiet",children:"Select a design with a click or the arrow keys."});let t=[...e.varied.map(i=>[i.title,_p(i,!1)]),...e.results.map(i=>[i.title,_p(i,!0)])];return u("div",{class:"facts",children:u("p",{id:"selected-design","aria-live":"polite",children:["Design ",n+1,gp.value.length>1&&`, ${e.group}`,": ",t.map(([i,r])=>`${i} ${r}`).join(", "),e.results.length===0&&", no result","."," ",u("button",{type:"button",onClick:()=>av(n),children:"Open as a design"})]})})}function vU(){let n=us.value.slice(0,ov),e=s=>[...new Set(n.flatMap(o=>an.value[o][s].map(({title:a})=>a)))],[t,i]=[e("varied"),e("results")],r=(s,o,a)=>{let l=an.value[s][o].find(c=>c.title===a);return u("td",{class:"number",children:l===void 0?"-":_p(l,o==="results")})};return u("div",{class:"wide",tabIndex:0,role:"group","aria-label":"Computed designs",children:[u("table",{children:[u("thead",{children:u("tr",{children:[u("th",{scope:"col",children:"design"}),u("th",{scope:"col",children:"part"}),[...t,...i].map(s=>u("th",{scope:"col",children:s}))]})}),u("tbody",{children:n.map(s=>u("tr",{"aria-current":hr.value===s?"true":void 0,children:[u("td",{children:u("button",{type:"button",class:"minor",onClick:()=>av(s),children:["Open ",s+1]})}),u("td",{children:an.value[s].group}),t.map(o=>r(s,"varied",o)),i.map(o=>r(s,"results",o))]}))})]}),us.value.length>ov&&u("p",{class:"quiet",children:["and ",us.value.length-ov," more"]})]})}var T1=`#studio { padding: 0.75rem 1rem; }
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
.narrow { padding-bottom: 0.25rem; }
.notice {
  border: 1px solid var(--carrier); border-radius: 0.4rem; padding: 0.5rem 0.75rem; margin: 0.5rem 0;
  overflow-wrap: anywhere;
}
.workbench { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr); margin-top: 0.75rem; }
.results { container-type: inline-size; position: relative; } /* hidden texts in it lengthen no page */
/* on a wide screen the study and the results scroll beside each other, and nothing scrolls away from the other */
@media (min-width: 60rem) {
  #studio { display: flex; flex-direction: column; height: 100vh; box-sizing: border-box; padding-block: 0.5rem; }
  .workbench { flex: 1; min-height: 0; grid-template: minmax(0, 1fr) / minmax(22rem, 30rem) minmax(0, 1fr); }
  .study { display: flex; flex-direction: column; gap: 0.75rem; min-height: 0; }
  #form { flex: none; height: 55%; min-height: 8rem; max-height: calc(100% - 8rem); overflow: auto; resize: vertical; border-bottom: 1px solid var(--rule); }
  #text { flex: 1; min-height: 0; display: flex; flex-direction: column; }
  #form, .results { padding: 0 0.5rem 4px 4px; }
  .results { overflow: auto; overflow-anchor: none; }
  .narrow { display: none; }
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
.editor ol { list-style: none; margin: 0; padding: 0.4rem 0; overflow: hidden; overflow-anchor: none; background: var(--panel); color: var(--quiet); text-align: right; }
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
.sentence { white-space: pre-line; }
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
.drop { border: 2px dashed var(--rule); border-radius: 0.4rem; padding: 0.4rem 0.75rem; margin: 0.4rem 0; }
.drop.over { border-color: var(--accent); background: var(--paper); }
.drop p { margin: 0.2rem 0; }
.refusal { border-left: 4px solid var(--carrier); padding-left: 0.6rem; margin: 0.3rem 0; }
#studio fieldset.item legend { font-weight: 600; padding: 0 0.3rem; }
.understood { border-block: 1px solid var(--rule); margin-block: 0.5rem; padding-block: 0.4rem; }
.understood p { margin: 0.3rem 0; }
.row label.check { flex-direction: row; color: var(--ink); font-size: 1rem; }
.field:has(.refusal) { grid-column: 1 / -1; }
.asks .help { display: block; }
`;function yU({start:n}){let e=CM(n.form);return u(ot,{children:[u(DM,{start:n}),u(xU,{}),u("main",{class:"workbench",children:[u("div",{class:"study",children:[u("section",{id:"form","aria-label":"Form",tabIndex:0,children:u(UM,{tree:e})}),u("section",{id:"text","aria-label":"Text",children:u(zw,{})})]}),u("div",{class:"results",tabIndex:0,role:"group","aria-label":"Analyses and result",children:[u(EM,{}),u(v1,{first:n.plate}),u(_M,{}),u(M1,{}),u(sM,{exports:n.exports}),u("footer",{children:u("p",{children:["haptonic ",n.version]})})]})]})]})}function xU(){return ls.value?u("p",{class:"notice",role:"alert",children:["The server of the studio does not answer. If it has ended, run ",u("code",{children:"haptonic studio"})," again and open its new link; copy a text that is not saved first."]}):null}async function bU(){h0();let n=document.createElement("style");n.textContent=T1+_1,document.head.append(n);let e=document.getElementById("studio");if(e===null)throw new Error("the page has no place for the studio");await $n(async()=>{let t=await vt.start();Ao.value=t.analyses,Kf(t),Nw(t.form,t.expressions),cc("Text of the study",Bw),cc("Computed designs",lv),nc(u(yU,{start:t}),e),t.opened!==null&&await fa(t.opened),await H0(),Ww(),kM(),x1(),vM(),tM(),hM(t.solids),bM()}),addEventListener("hashchange",()=>{H0()}),addEventListener("beforeunload",t=>{da.peek()&&t.preventDefault()})}bU().catch(n=>{let e=document.createElement("p");e.textContent=`The studio cannot be shown: ${n instanceof Error?n.message:String(n)}`,document.body.replaceChildren(e)});
