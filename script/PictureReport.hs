{-# LANGUAGE BangPatterns #-}

-- | Measures a picture of the default preset: its fine structure, its range of
-- hues, its clipped pixels, its shadow and its banding. Prints one line for each
-- number with its bound, and exits with 1 if a number is outside its bound.
module Main (main) where

import Codec.Picture
import Control.Monad (unless)
import Data.List (sort)
import Data.Maybe (fromMaybe)
import qualified Data.Vector.Storable as Storable
import qualified Data.Vector.Unboxed as U
import System.Environment (getArgs)
import System.Exit (die, exitFailure)
import Text.Printf (printf)
import Text.Read (readMaybe)

-- | A rectangle of pixels: left, top, width, height.
data Box = Box !Int !Int !Int !Int

-- | One measured number: its name, its unit, its value, and its bound.
data Number = Number String String Double Bound

data Bound = AtLeast !Double | AtMost !Double

main :: IO ()
main = do
  arguments <- getArgs
  case arguments of
    [file] -> report file Nothing Nothing
    [file, gas] | Just box <- readBox gas -> report file (Just box) Nothing
    [file, gas, shadow]
      | Just box <- readBox gas,
        Just box' <- readBox shadow ->
        report file (Just box) (Just box')
    _ ->
      die
        "usage: script/picture-report FILE [GAS [SHADOW]]\nGAS and SHADOW are boxes of \
        \pixels, WIDTHxHEIGHT+LEFT+TOP"

-- | A box as ImageMagick writes it: WIDTHxHEIGHT+LEFT+TOP.
readBox :: String -> Maybe Box
readBox text = do
  (width, 'x' : text1) <- Just (break (== 'x') text)
  (height, '+' : text2) <- Just (break (== '+') text1)
  (left, '+' : top) <- Just (break (== '+') text2)
  Box <$> readMaybe left <*> readMaybe top <*> readMaybe width <*> readMaybe height

report :: FilePath -> Maybe Box -> Maybe Box -> IO ()
report file gas shadow = do
  picture <- readImage file >>= either die (pure . convertRGB8)
  let inside (Box x y w h) =
        x >= 0 && y >= 0 && w > 1 && h > 1 && x + w <= imageWidth picture
          && y + h <= imageHeight picture
      gasBox = fromMaybe (partOf picture nearSide) gas
      shadowBox = fromMaybe (partOf picture shadowMiddle) shadow
  unless (all inside [gasBox, shadowBox]) $ die "a box reaches beyond the picture"
  let numbers = measured picture gasBox shadowBox
  printf "%s: %d x %d pixels\n" file (imageWidth picture) (imageHeight picture)
  mapM_ (putStrLn . line) numbers
  unless (all holds numbers) exitFailure

holds :: Number -> Bool
holds (Number _ _ value bound) = case bound of
  AtLeast least -> value >= least
  AtMost most -> value <= most

line :: Number -> String
line number@(Number name unit value bound) =
  printf
    "%-60s %8.4f %-3s %s%s"
    name
    value
    unit
    (shown bound)
    (if holds number then "" else ": NOT MET")
  where
    shown (AtLeast least) = "at least " ++ show least
    shown (AtMost most) = "at most " ++ show most

-- | The part of the default preset's picture that holds only gas of the disk's near
-- side, and the middle of its shadow: left, top, width and height, each as a part
-- of the picture's.
nearSide, shadowMiddle :: (Double, Double, Double, Double)
nearSide = (0.40, 0.552, 0.20, 0.065)
shadowMiddle = (0.475, 0.42, 0.05, 0.06)

partOf :: Image PixelRGB8 -> (Double, Double, Double, Double) -> Box
partOf picture (x, y, w, h) = Box (across x) (down y) (across w) (down h)
  where
    across part = round (part * fromIntegral (imageWidth picture))
    down part = round (part * fromIntegral (imageHeight picture))

measured :: Image PixelRGB8 -> Box -> Box -> [Number]
measured picture gas shadow =
  [ Number "fine structure of the near side, below 4 pixels" "" (structure 4) (AtLeast 0.075),
    Number "structure of the near side, below 24 pixels" "" (structure 24) (AtLeast 0.25),
    Number
      "hues of lit pixels, from the 10th to the 90th percentile"
      "deg"
      (percentile 0.9 hues - percentile 0.1 hues)
      (AtLeast 12),
    Number "pixels with a channel at 255" "%" (100 * share clipped everywhere) (AtMost 0.3),
    Number
      "mean light in the middle of the shadow, of white"
      "%"
      (100 * mean (map (luminance . at) (places shadow)))
      (AtMost 1),
    Number "pixels of smooth areas in bands" "%" (100 * banded picture) (AtMost 0.1)
  ]
  where
    at (x, y) = pixelAt picture x y
    everywhere = map at (places (Box 0 0 (imageWidth picture) (imageHeight picture)))
    structure = structureBelow picture gas
    hues = sort [hue pixel | pixel <- everywhere, lit pixel]
    clipped (PixelRGB8 r g b) = maximum [r, g, b] == 255

places :: Box -> [(Int, Int)]
places (Box x y w h) = [(x + i, y + j) | j <- [0 .. h - 1], i <- [0 .. w - 1]]

-- | The luminance of a pixel's linear light, 0 to 1.
luminance :: PixelRGB8 -> Double
luminance (PixelRGB8 r g b) = 0.2126 * decoded r + 0.7152 * decoded g + 0.0722 * decoded b
  where
    decoded code = decodedLight Storable.! fromIntegral code

decodedLight :: Storable.Vector Double
decodedLight = Storable.generate 256 $ \code ->
  let s =
        fromIntegral code / 255
   in if s <= 0.04045 then s / 12.92 else ((s + 0.055) / 1.055) ** 2.4

-- | A pixel counts as lit if it is coloured and its strongest channel is above a
-- quarter of the range.
lit :: PixelRGB8 -> Bool
lit (PixelRGB8 r g b) = high >= 64 && high - minimum [r, g, b] >= 13
  where
    high = maximum [r, g, b]

-- | The hue of a coloured pixel in degrees from red, -180 to 180 (HSV).
hue :: PixelRGB8 -> Double
hue (PixelRGB8 r8 g8 b8)
  | high == r = 60 * (g - b) / range
  | high == g = 120 + 60 * (b - r) / range
  | b > r || g <= r = -120 + 60 * (r - g) / range
  | otherwise = 180
  where
    (r, g, b) = (fromIntegral r8, fromIntegral g8, fromIntegral b8)
    high = maximum [r, g, b]
    range = high - minimum [r, g, b]

percentile :: Double -> [Double] -> Double
percentile _ [] = 0
percentile part sorted =
  sorted !! min (length sorted - 1) (floor (part * fromIntegral (length sorted)))

share :: (a -> Bool) -> [a] -> Double
share found = mean . map (\a -> if found a then 1 else 0)

mean :: [Double] -> Double
mean = go 0 (0 :: Int)
  where
    go !total !count values = case values of
      [] -> total / fromIntegral (max 1 count)
      v : rest -> go (total + v) (count + 1) rest

-- | The standard deviation of ln luminance in a box after a Gaussian blur of this
-- many pixels was subtracted. The blur stays within the box.
structureBelow :: Image PixelRGB8 -> Box -> Double -> Double
structureBelow picture box@(Box _ _ w h) sigma =
  sqrt (mean (map (\d -> (d - middle) ^ (2 :: Int)) differences))
  where
    -- Half a code above black, where the logarithm ends.
    values = U.fromList [log (max 1.5e-4 (luminance (pixelAt picture x y))) | (x, y) <- places box]
    differences = U.toList (U.zipWith (-) values (blurred sigma w h values))
    middle = mean differences

-- | A Gaussian blur of rows and then of columns. At the edges the weights of what
-- is there count.
blurred :: Double -> Int -> Int -> U.Vector Double -> U.Vector Double
blurred sigma w h = alongColumns . alongRows
  where
    reach = ceiling (3 * sigma) :: Int
    weights =
      U.generate
        (2 * reach + 1)
        (\i -> let d = fromIntegral (i - reach) / sigma in exp (-0.5 * d * d))
    alongRows v =
      U.generate
        (w * h)
        (\i -> let (y, x) = i `quotRem` w in weighted w x (\k -> v U.! (y * w + k)))
    alongColumns v =
      U.generate
        (w * h)
        (\i -> let (y, x) = i `quotRem` w in weighted h y (\k -> v U.! (k * w + x)))
    weighted size place value = go (max 0 (place - reach)) 0 0
      where
        go !k !total !norm
          | k > min (size - 1) (place + reach) = total / norm
          | otherwise =
            let weight =
                  weights U.! (k - place + reach)
             in go (k + 1) (total + weight * value k) (norm + weight)

-- | The share of pixels in bands: horizontal runs of 96 equal codes or more of green,
-- neither black nor white, between the code below and the code above. A dithered
-- gradient has hardly any.
banded :: Image PixelRGB8 -> Double
banded picture =
  fromIntegral (sum (map inRow [0 .. imageHeight picture - 1]))
    / fromIntegral (imageWidth picture * imageHeight picture)
  where
    inRow y =
      bands
        ( runs
            [ let PixelRGB8 _ g _ = pixelAt picture x y in fromIntegral g :: Int
              | x <- [0 .. imageWidth picture - 1]
            ]
        )
    runs codes = case codes of
      [] -> []
      c : rest -> let (equal, others) = span (== c) rest in (c, 1 + length equal) : runs others
    bands (before : run@(code, count) : rest@(after : _))
      | count >= 96 && code > 0 && code < 255 && step before code && step after code
          && fst before /= fst after =
        count + bands (run : rest)
      | otherwise = bands (run : rest)
    bands _ = 0 :: Int
    step (other, _) code = abs (other - code) == 1
