-- | A picture as text for a terminal.
module BlackHole.Cli.Preview
  ( Palette (..),
    palette,
    previewSize,
    previewText,
  )
where

import BlackHole.Light.Display (decodeSrgb)
import BlackHole.Light.Radiance (Radiance (..), luminance)
import BlackHole.Render.PixelArray (PixelArray, pixelArrayShape, toPixelVector)
import BlackHole.Render.PixelShape (shapeHeight, shapeWidth)
import Data.List (isInfixOf, isSuffixOf)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word8)

-- | What a terminal can show.
data Palette
  = -- | 24-bit colour: two pixels in each character's upper and lower half.
    TrueColour
  | -- | The 256 colours of xterm, likewise.
    IndexedColour
  | -- | Characters of increasing density, one for two pixels.
    Letters
  deriving (Eq, Show, Enum, Bounded)

-- | The palette for an environment, given whether the output is a terminal:
-- characters without a terminal, with @NO_COLOR@ (no-color.org), or if @TERM@ is
-- missing or @dumb@; true colour if @COLORTERM@ or @TERM@ says so; otherwise 256
-- colours.
palette :: Bool -> [(String, String)] -> Palette
palette isTerminal environment
  | not isTerminal || given "NO_COLOR" || term `elem` ["", "dumb"] = Letters
  | value "COLORTERM" `elem` ["truecolor", "24bit"] || "-direct" `isSuffixOf` term
      || any (`isInfixOf` term) ["kitty", "alacritty", "truecolor"] =
    TrueColour
  | otherwise = IndexedColour
  where
    value name = fromMaybe "" (lookup name environment)
    given = not . null . value
    term = value "TERM"

-- | @previewSize columns lines (width, height)@: the width and (even) height in pixels of
-- the largest preview of a picture of these proportions that leaves the terminal's last
-- line free, at least one column and one line. A character shows two pixels, one above
-- the other, which makes them nearly square.
previewSize :: Int -> Int -> (Int, Int) -> (Int, Int)
previewSize columns textLines (width, height) =
  (max 1 (min columns across), 2 * max 1 (min room down))
  where
    room = max 1 (textLines - 1)
    fitted =
      min
        (fromIntegral columns / fromIntegral width)
        (fromIntegral (2 * room) / fromIntegral height) ::
        Double
    across = round (fitted * fromIntegral width)
    down = round (fitted * fromIntegral height / 2)

-- | A developed picture of three channels as lines of text, each of which ends with a
-- reset of the colours. Drops the last row of a picture of odd height.
previewText :: Palette -> PixelArray Word8 -> String
previewText colours codes = concatMap line [0, 2 .. shapeHeight shape - 2]
  where
    shape = pixelArrayShape codes
    pixel x y =
      let at k = Vector.unsafeIndex (toPixelVector codes) (3 * (y * shapeWidth shape + x) + k)
       in (at 0, at 1, at 2)
    line y = go Nothing [(pixel x y, pixel x (y + 1)) | x <- [0 .. shapeWidth shape - 1]]
    go _ [] = case colours of
      Letters -> "\n"
      _ -> "\ESC[0m\n"
    go before (cell@(upper, lower) : rest) = case colours of
      Letters -> letter upper lower : go before rest
      -- Escape codes are written only where the colours change.
      TrueColour ->
        said before cell (direct "38" upper ++ direct "48" lower) ++ "▀"
          ++ go (Just cell) rest
      IndexedColour ->
        said before cell (indexed "38" upper ++ indexed "48" lower)
          ++ "▀"
          ++ go (Just cell) rest
    said before cell escape = if before == Just cell then "" else escape
    direct ground (r, g, b) =
      "\ESC[" ++ ground ++ ";2;" ++ show r ++ ";" ++ show g
        ++ ";"
        ++ show b
        ++ "m"
    indexed ground colour = "\ESC[" ++ ground ++ ";5;" ++ show (nearestIndex colour) ++ "m"
    letter a b =
      densities
        !! min
          (length densities - 1)
          (floor (fromIntegral (length densities) * (lightness a + lightness b) / 2))
    densities = " .:-=+*#%@"

-- | The approximate perceived lightness of a pixel, 0 to 1.
lightness :: (Word8, Word8, Word8) -> Double
lightness (r, g, b) = luminance (Radiance (linear r) (linear g) (linear b)) ** (1 / 2.2)
  where
    linear c = decodeSrgb (fromIntegral c / 255)

-- | The nearest of xterm's 216 colours and 24 greys, by distance between codes.
nearestIndex :: (Word8, Word8, Word8) -> Int
nearestIndex (r, g, b)
  | distance (cubeLevel r', cubeLevel g', cubeLevel b')
      <= distance
        (greyLevel, greyLevel, greyLevel) =
    16 + 36 * cubePlace r' + 6 * cubePlace g' + cubePlace b'
  | otherwise = 232 + greyPlace
  where
    (r', g', b') = (fromIntegral r, fromIntegral g, fromIntegral b) :: (Int, Int, Int)
    distance (x, y, z) = square (x - r') + square (y - g') + square (z - b')
    square d = d * d
    -- The cube's levels are 0, 95, 135, 175, 215, 255; the greys' 8, 18 … 238.
    cubePlace c
      | c < 48 = 0
      | c < 115 = 1
      | otherwise = (c - 35) `quot` 40
    cubeLevel c = case cubePlace c of
      0 -> 0
      place -> 55 + 40 * place
    greyPlace = max 0 (min 23 (((r' + g' + b') `quot` 3 - 3) `quot` 10))
    greyLevel = 8 + 10 * greyPlace
