{-# LANGUAGE ForeignFunctionInterface #-}
{-# LANGUAGE OverloadedStrings #-}

-- | The files of @data\/explore@, the page of @blackhole explore@, which become part of
-- the program when it is compiled (@data\/embedded.c@), like those of the sky
-- ("BlackHole.Trace.SkyFiles").
module BlackHole.Explore.PageFiles
  ( pageFiles,
  )
where

import qualified Data.ByteString as Bytes
import qualified Data.ByteString.Unsafe as Bytes (unsafePackCStringLen)
import Foreign.C.Types (CChar)
import Foreign.Ptr (Ptr, minusPtr)
import System.IO.Unsafe (unsafePerformIO)

foreign import ccall "&blackhole_page_html" htmlStart :: Ptr CChar

foreign import ccall "&blackhole_page_html_end" htmlEnd :: Ptr CChar

foreign import ccall "&blackhole_page_css" cssStart :: Ptr CChar

foreign import ccall "&blackhole_page_css_end" cssEnd :: Ptr CChar

foreign import ccall "&blackhole_page_js" jsStart :: Ptr CChar

foreign import ccall "&blackhole_page_js_end" jsEnd :: Ptr CChar

-- | Name, media type and contents of each file. The page itself has the empty name.
pageFiles :: [(Bytes.ByteString, Bytes.ByteString, Bytes.ByteString)]
pageFiles =
  [ ("", "text/html; charset=utf-8", constant htmlStart htmlEnd),
    ("page.css", "text/css; charset=utf-8", constant cssStart cssEnd),
    ("page.js", "text/javascript; charset=utf-8", constant jsStart jsEnd)
  ]
{-# NOINLINE pageFiles #-}

-- | Constant bytes between two addresses, not copied.
constant :: Ptr CChar -> Ptr CChar -> Bytes.ByteString
constant start end = unsafePerformIO (Bytes.unsafePackCStringLen (start, end `minusPtr` start))
