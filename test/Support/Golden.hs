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
import qualified Data.ByteString.Lazy as Lazy
import Support.Difference
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
        (Left problem, _) -> expectationFailure problem
        (_, Left problem) -> expectationFailure problem
        (Right old, Right new) -> shouldResemble name (Limits 0.4 255 (1 / 200) 2) old new
  where
    golden = "test" </> "golden" </> name <.> "png"
