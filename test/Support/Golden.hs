-- | Pictures kept in @test/golden@ to notice accidental changes.
--
-- They are compared after decoding, with a little room for other compilers'
-- and libraries' last digits. With the environment variable
-- @BLACKHOLE_REGENERATE_GOLDEN=1@ they are written anew instead.
module Support.Golden
  ( shouldMatchGolden,
  )
where

import Codec.Picture
import Control.Monad (unless)
import qualified Data.ByteString.Lazy as Lazy
import qualified Data.Vector.Storable as Vector
import System.Directory (createDirectoryIfMissing)
import System.Environment (lookupEnv)
import System.FilePath ((<.>), (</>))
import Test.Hspec

-- | Compare a PNG with the golden picture of this name.
shouldMatchGolden :: HasCallStack => Lazy.ByteString -> String -> Expectation
shouldMatchGolden actual name = do
  regenerate <- lookupEnv "BLACKHOLE_REGENERATE_GOLDEN"
  case regenerate of
    Just "1" -> Lazy.writeFile golden actual
    _ -> do
      kept <- readImage golden
      case (convertRGB8 <$> kept, convertRGB8 <$> decodePng (Lazy.toStrict actual)) of
        (Right old, Right new) | size old == size new -> compareCodes old new
        (Left problem, _) -> expectationFailure problem
        (_, Left problem) -> expectationFailure problem
        (Right old, Right new) ->
          expectationFailure (name ++ ": the size is " ++ show (size new) ++ ", not " ++ show (size old))
  where
    golden = "test" </> "golden" </> name <.> "png"
    size picture = (imageWidth picture, imageHeight picture)
    compareCodes :: Image PixelRGB8 -> Image PixelRGB8 -> Expectation
    compareCodes old new = do
      let differences = Vector.zipWith difference (imageData old) (imageData new)
          count = Vector.length (Vector.filter (> 2) differences)
          allowed = Vector.length differences `quot` 200
      unless (count <= allowed) $ do
        createDirectoryIfMissing True "test-output"
        Lazy.writeFile ("test-output" </> name <.> "png") actual
        expectationFailure $
          name ++ ": " ++ show count ++ " codes differ by more than 2 (allowed: "
            ++ show allowed
            ++ "), the greatest difference is "
            ++ show (Vector.maximum differences)
            ++ "; the picture is in test-output"
    difference a b = abs (fromIntegral a - fromIntegral b :: Int)
