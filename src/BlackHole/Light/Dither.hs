-- | Dither: rounding that hides the steps between the codes of a display.
--
-- In 8 bits, a smooth dark gradient shows its steps as bands. Dither gives every pixel
-- its own rounding threshold instead of one half, so that the mean over a small area is
-- the exact value. The thresholds are blue noise: neighbours differ as much as
-- possible, and the eye, which averages fine detail, sees neither grain nor a pattern.
-- Values that are exact codes, such as black and white, stay unchanged.
module BlackHole.Light.Dither
  ( Dither (..),
    ditherThreshold,
    ditherTileSide,
  )
where

import Data.Bits (shiftL, (.&.), (.|.))
import Data.Char (isAsciiLower, isAsciiUpper, isDigit, ord)
import qualified Data.Vector.Unboxed as U
import Data.Word (Word8)

-- | Whether 8-bit codes are dithered. 16-bit codes never are, because their steps are
-- finer than any display shows.
data Dither
  = -- | Round to the nearest code.
    NoDither
  | -- | Round at thresholds of blue noise.
    BlueNoise
  deriving (Eq, Show, Read, Enum, Bounded)

-- | @ditherThreshold channel column row@ is the amount, in codes, to add to a value
-- before truncating it. It is above 0 and below 1, and takes each of 64 levels equally
-- often in every tile of 'ditherTileSide'. The three channels (0, 1, 2) use shifted
-- tiles, so that their errors do not add up in brightness. Any column and row is valid.
ditherThreshold :: Int -> Int -> Int -> Double
ditherThreshold channel column row =
  (fromIntegral (U.unsafeIndex tile (y `shiftL` 6 .|. x)) + 0.5) * 0.015625
  where
    x = (column + 21 * channel) .&. (ditherTileSide - 1)
    y = (row + 43 * channel) .&. (ditherTileSide - 1)
{-# INLINE ditherThreshold #-}

-- | The number of pixels after which the thresholds repeat in either direction.
ditherTileSide :: Int
ditherTileSide = 64

-- | The levels, row by row.
tile :: U.Vector Word8
tile = U.fromListN (ditherTileSide * ditherTileSide) (map (fromIntegral . level) (concat ranks))
{-# NOINLINE tile #-}

-- | Converts a digit of the table below to a level, 0 to 63.
level :: Char -> Int
level c
  | isAsciiUpper c = ord c - ord 'A'
  | isAsciiLower c = 26 + ord c - ord 'a'
  | isDigit c = 52 + ord c - ord '0'
  | c == '+' = 62
  | otherwise = 63

-- | Made by script/BlueNoise.hs with the void-and-cluster method (Ulichney 1993), with
-- ranks reduced to six bits. Below a tenth of a cycle per pixel it has less than a
-- thousandth of the power of white noise.
ranks :: [String]
ranks =
  [ "rHfvnNKxr4GXjARL9lS7E0A3YyHKidTluQ18gs-Kw4rIN7ZS+kFdAgyS7qCZ2oP+",
    "Xk1EazS9CQ1-dzogD1aNoWRJp7VP9xF2aCdKTY2DNfZxioBfzL3wpP5rkY-ukM4B",
    "K8PU6qelWhoTIO4ZWvGe4l9hvDm1rYoJ-VtylHhzoVG+1PvrHbsT8aLDwOJ5FeTv",
    "bosLiAH2vLyatlE7qP+tUxHc4TafCMRzhOpD9uQb8ktDcXJ9VnDYHi1Ve0SnWzqh",
    "0Fe3wY7OcF6B9fUxJhBjLDZOkMF7uk5eA3jbMW5AJR6LTm2Nj5Q+umF9ohAb8EQ6",
    "NCW-ImSsgUkrQ1LcnSzb62qt-0qxUHbwsU6I1fmrwe0hq8fFxc0fNycPI3uNrjIZ",
    "9tkQbq0D+3MYHjuC37XpQeVAgJXOi+pLGQYxpTF3YUnHwBZtSAJqUC6qYxU+fy2m",
    "SxgzEMejJxpe5W-ZkNFvJm8yRnd4BQ1W9ngD+OjL-COa4QK2ls7Zl2SgLkGZDLUd",
    "KpH5V8wXRaAztEPyIsf+CiNEa7GsyZEldzvKctya1ks8Wjo-WMhGwIs-B5nQ6pvA",
    "4ZNcsB2oG9lTKngqRb0U3Yw5lvVLjf7tNB5SX7BgQGdvEzeHbyR9dOjbV1dxhX-i",
    "0T9jnPhL4tdN72c9A6lPocSrKP2-oTJ2UaiqHkoVx5pJN6TC5uEp3XzFuPJsGNmF",
    "fuCyFYvcUC1iZFULwXEKuH+BhdGXCwPqGn-P03NJ9XShansPimZUAmK7ph9T3ybP",
    "nWL3S6I-kqQxIvn3ejr4f0kV3tmzbi9e4xLeCZvdEm3A+x1XL4I0+uSeDXlBaK8t",
    "I+pbgr0NZF8W4jCsPI-aDQLZ8DR5MsAYREXs8ThqtOzjVIDf9qcgMiax1M6vgqUC",
    "e0OlHVAnygKoeNa8V1Sny7smxNqgHV1kuh2mFxQ6BaLrQclvSBwQrD6HQrdER2i6",
    "SYE4x9eQ3TtD+RzGlDdMWhBTIcW+yn7NI8UMckK1U-fw73pNa1GV8YlTn-V0oNGv",
    "kLhsRKjuE5bkwXpgu6wqF5ew61jBQeFbryBp+4GYniHCYKF-W5jozJ2vbBhIY9cy",
    "q19CoZ7IXmO1JB3KPYiJ2lPKoEauKsT5XfPZuSfryR5oTgztmIMucAfO5Ky3tmAW",
    "FQdVwc0pf+GVi7cU+A0aUs-XiS8m40iCn3Hj0DO7EMcu1jAQdh9TPq+EoZkOdSK4",
    "ZuJ6GOBSMszeQrwlepR8NCcHyrNVHY-MRw9LWohawlW9NZ7VyC3FZ0iWs8TD7wi+",
    "fzmi3rl5xDY6nENH4Fvgm4u1eA3gEdpuaDrd6vI+T3JDsHo2Nbsk7vLRHxgGq0No",
    "WESMYe9WicKuT-Z1sXKyEWjQL9nvzPkJ1hTlAQ1kBeqiS5fJvpWIeCm3d1nXaIUC",
    "2s-qyEJQoH4kAyhVPkd7aIp6UaIXS75EW8N3ZqcNtYz-bxlE+R5OyUa8PAL-4ud7",
    "kPaAU2bv7zVOdIp8C5oS2OwhDs2iBrMxcozFK9VFn2PLBWOYicBm-sFphvVlPhpL",
    "Hfw6ngtMBfr91mLbvGMrAe-G0lO+enUgHQjtfxi6vHUjp40sH2wgLS0JYzrGyBSv",
    "5VJjGR+XlSaFuXR3zUg9ykWLcSvFKa3v-B6aP0CRfa5xGgSm8UEqZj6eD9ReK9Y0",
    "Co9ZN3pEy3MiD7fGjnYJbRuo8Zq6zRDlYsTnIXoM+Drc8uDKeNzQ8HulN4Zj6slc",
    "hQr0dvKchI+nWxrN-Ct6G4C1IgBWjt8OKd2D+4cszlNIWQa6pYk3CWPxUnFwOWEM",
    "uyFTBkV6rUvdQ2JaSd1PqeUi5QyMcHf0qwMgkuUJYhS2oj0wA+tcgo1bAt1cHp38",
    "XIm5g9G0OA4KpCk5ovLWlxNrFtm+2oUiG6VzQFfA37Ft+MGVhISFM5J+hLX-RxeT",
    "j-aPwpRamfyY8hVyF7Bg9Da+XdTDJY7ARbmJZ8xnQveZBf5qO2nyvkZqR4lCgmKA",
    "qfM1CXLt-GkSGtNeYRjsJ3RmK7iwrPxlu+Cs3pNjbKqUylSb7Yd9QVEeHvNr0Z72",
    "DyVsd6i1DWr6b1+Iq2bzUeuyA1OWf5dIX1OeTEW-zD6O3JuGxDLiC2s8zTc6GUOt",
    "IR5EnIwNc3PLoBlUuL-GOpEhbo4CmF0Mph5jwc2IStkHoX-fjsTq7bNmXiDoJwic",
    "o9kaP+TlpIyhwXP5DgnX5k8MRYIv-SZ8DUHL9BlreX9hczNAQ50XIgxAK29fR83X",
    "guL0gsAZ8fV7EdriyQdAvJV0+tjcLqiudyrZoPhM4BQwETr2naGwPo-TtPxZslCN",
    "TB3GWx4GRuCmS09JW81s3ZgrBT6P2VA4OlR6zV7xao2M8kZJ9gMl3FZ4dpHVMFqz",
    "+ZPqcmMj1rK2bMGZnCMTiPEmdHygFmzYK+EbCJtFUIgsD3dvVD6cuVjMDlg0-a4e",
    "nwj8SJ+eaOX-htp4wfbqH95wL3oZ9sRHof1vind-k0bWmRHjPzoSB1qy8U6CviIQ",
    "KFfD1vVB5nxFkAURjF7zlXSbtWOCKch7tUkMX3RNC5uO7xq-FsYK9fHQtJbOSmWt",
    "5Ur6NgpzETfQ60e+N2UKuD0Ji-ku6xN2aBQ8HrzZpSiHAfLX2e7ixObiX2nrz7B1",
    "dxXlaGQkt8IrWLumDYsdOg6pAQ1eUDXmGz5pbC7gKy9X0a5SlNCUm4D+vAeGLgZO",
    "o-LBu94YMc2mZCcJ5piB+mTxdFYpIjr-SLewJUkvFcrMoktEwa0IsWpTkN4V9wlE",
    "iISzndJxhAvO+4xhPyS4vGZLsz8M4yPcviWm9eO4VmC4TIP8ho5Qc1LG6zYjsIR6",
    "saf3PVEqR6VGjSrW9HbLWj29VlhSbA7J1CsFQ2tH8Qfv+dyBVKujA9wgbtPCc2Xz",
    "UvF8is1-aozfqEMlBuf0qQBfOHDwtofYlN6yYAhqazKYEj1ZrG-YfOlWJEm-SpMA",
    "+KpXBMeHjDKX70d3Y6nE-Jtyn5Y+KV3Fq+TcoL-SDn3sRpN7fTM0Er7Rp2vfH5hm",
    "2Pcxm7YvO3tQbIuUKiOTcl6bTq2djOxRaiJg1wkXxOhG6XJum4woU3Cyd8MUytEZ",
    "Hk1TJ4RpU9hxmD+ozGsx3XMCgJQBnH60Bu3GPEd4Jb+UlxCbPFdkJahIYjAakO8e",
    "u7ChtEg0FcAT5NgQa8WAhoFx+k0u8XreMmX8tV7rC0teL4i90BX+Ru5NsQ16JWpS",
    "LVrO-bLlr7Kk1XsCk4eL2R7ZtVGaShKk-QDpalMRioPAzaRqVh5xMf0l+Gnrc0Bx",
    "b3fYnw3PXyavGd7wISmvHrjOd4Lpx5FUbz6eKy1G9ZW8FnvHLtmGqEWBUwgSE+hl",
    "8FJ0AVH9CiNpRmLZ0qN-bUzInD1fPA2svIiTuAgcvK2rgOX-e1OTZ9nd3IZN4tIP",
    "zjp5RioteS2-ByU9EhYDf5B8hR-Yld8nNC2P9X4qTEjwI4zkEa7g3xRLq7zkeUoZ",
    "BTsNd8ZM5mIWf3jcP5symPuWbwqHuKSWgZqkEnIOl6dQbUBpRyJAjHtbhPAuG2Lv",
    "h+XGv1DczEubrOJtoHVK3GpJ1MCV7ziF+w5Vzbx-VzBn+tgM8lvYpO81EVn-YQ7c",
    "1KeylTJrVP8jD9xA2e8TdiZ6ej3maEq0QJGeMRiDftMY1F5cWGrd5VCkv5cKiyqE",
    "Vn6CPh-4gpxLTnXSakzCw9RsETxPgM4bkoTt8r4KZ3HqRKiu2P+SKzfYRM0sTClO",
    "wRaq2YnARHY6e0h6KqOYoMAzm+It8UvAX6h2BmHwSj9dwlZIoDgwFmr+GpgF8Zf5",
    "Gk9LHuMdwj2BtFNvE-tH2f4XOcYBpdI-OyFZPWc7oyEV4A-T0Mk4a7OJxa5Pv2Ir",
    "dAVxf7Wz9KalQpb1VgRbkUuJhq5L2iRnsfLp+ugNCbQhpNyfscWqBUe3jTAmWjM-",
    "u4ipQFlDqOVz+J7jnBy4D+nF0wRkFw0ZD4S0kJT2r6LuGb6QC8HyQiuDXs9dEpSY",
    "mNJ0bs3Sg6uDfTYGO5XqLQa7TC-bWO8gHWwbA5xFjY+0lWrKn1ZtK-1oN4yKw70D",
    "yT7WB-iYIcnMv4rxctIhwdsjNent4BqM6joGOnWdRmBTe3EwhUO6mWIbGfQiUHgb"
  ]
