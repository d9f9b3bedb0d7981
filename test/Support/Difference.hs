-- | How far two pictures are from each other, in statistics.
module Support.Difference
  ( Difference (..),
    differenceOf,
    Limits (..),
    shouldResemble,
  )
where

import Codec.Picture
import Control.Monad (unless)
import qualified Data.Vector.Storable as Vector
import Data.Word (Word8)
import System.Directory (createDirectoryIfMissing)
import System.FilePath ((<.>), (</>))
import Test.Hspec

-- | Of all codes of two 8-bit pictures of one size.
data Difference = Difference
  { -- | The mean of the second less the first: a change of brightness.
    differenceMean :: !Double,
    -- | The mean without signs.
    differenceAbsolute :: !Double,
    differenceMaximum :: !Int,
    -- | How many differ by more than a limit.
    differenceCount :: !Int
  }
  deriving (Eq, Show)

-- | @differenceOf limit old new@; 'Nothing' for different sizes.
differenceOf :: Int -> Image PixelRGB8 -> Image PixelRGB8 -> Maybe Difference
differenceOf limit old new
  | imageWidth old /= imageWidth new || imageHeight old /= imageHeight new = Nothing
  | otherwise =
    Just
      ( Difference
          (mean signed)
          (mean absolute)
          (Vector.foldl' max 0 absolute)
          (Vector.length (Vector.filter (> limit) absolute))
      )
  where
    signed =
      Vector.zipWith (\a b -> fromIntegral b - fromIntegral a) (imageData old) (imageData new) ::
        Vector.Vector Int
    absolute = Vector.map abs signed
    mean values = fromIntegral (Vector.sum values) / fromIntegral (max 1 (Vector.length values))

-- | What two pictures that are to be alike may differ by.
data Limits = Limits
  { -- | The mean of the differences, with signs and without.
    limitMean :: !Double,
    limitMaximum :: !Int,
    -- | The part of the codes that may differ by more than a number of codes.
    limitPart :: !Double,
    limitCodes :: !Int
  }

-- | @shouldResemble name limits expected actual@. On failure the actual picture
-- and the differences, ten times as strong, are written to @test-output@.
shouldResemble ::
  HasCallStack => String -> Limits -> Image PixelRGB8 -> Image PixelRGB8 -> Expectation
shouldResemble name limits expected actual =
  case differenceOf (limitCodes limits) expected actual of
    Nothing ->
      expectationFailure (name ++ ": the size is " ++ size actual ++ ", not " ++ size expected)
    Just found -> unless (alike found) $ do
      createDirectoryIfMissing True "test-output"
      writePng ("test-output" </> name ++ "-actual" <.> "png") actual
      writePng ("test-output" </> name ++ "-difference-x10" <.> "png") (tenfold expected actual)
      expectationFailure (name ++ ": " ++ show found ++ "; see test-output")
  where
    alike found =
      differenceAbsolute found <= limitMean limits
        && differenceMaximum found <= limitMaximum limits
        && fromIntegral (differenceCount found)
          <= limitPart limits * fromIntegral (Vector.length (imageData expected))
    size picture = show (imageWidth picture) ++ "x" ++ show (imageHeight picture)

tenfold :: Image PixelRGB8 -> Image PixelRGB8 -> Image PixelRGB8
tenfold old new = new {imageData = Vector.zipWith strong (imageData old) (imageData new)}
  where
    strong :: Word8 -> Word8 -> Word8
    strong a b = fromIntegral (min 255 (10 * abs (fromIntegral a - fromIntegral b :: Int)))
