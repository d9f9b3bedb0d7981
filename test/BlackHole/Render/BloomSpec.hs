module BlackHole.Render.BloomSpec (spec) where

import BlackHole.Render.Bloom
import BlackHole.Render.Exposed
import BlackHole.Render.PixelArray
import BlackHole.Render.PixelShape
import BlackHole.Render.Workers
import Control.Monad (forM_)
import Data.Maybe (mapMaybe)
import qualified Data.Vector.Storable as Vector
import Support.Approx
import Test.Hspec

spec :: Spec
spec = do
  it "keeps all light, wherever it is, at any size" $
    forM_ [(1, 1), (2, 1), (7, 5), (64, 36), (61, 33), (100, 3)] $ \(width, height) ->
      forM_ [0, width - 1, width * height `quot` 2, width * height - 1] $ \pixel -> do
        glare <- bloomed 0.7 width height (\i -> if i == 3 * pixel + 1 then 1 else 0)
        total glare `shouldBeWithin` (2e-6, 1)
        Vector.minimum glare `shouldSatisfy` (>= 0)
  it "leaves a uniform picture as it is" $
    forM_ [(1, 1), (64, 36), (61, 33)] $ \(width, height) -> do
      glare <- bloomed 0.9 width height (const 3)
      (Vector.minimum glare, Vector.maximum glare) `shouldSatisfy` \(low, high) ->
        low > 3 - 2e-5 && high < 3 + 2e-5
  it "leaves the rest of a point's light where it was" $ do
    glare <- bloomed 0.1 200 100 pointAt
    let middle = realToFrac (glare Vector.! (3 * (50 * 200 + 100)))
    middle `shouldSatisfy` \v -> v > 0.9 && v < 0.98 + (0 :: Double)
  it "falls with the distance as measured: by the third power near by, by the second farther out" $
    do
      glare <- bloomed 1 1024 1024 (\i -> if i == 3 * (512 * 1024 + 512) then 1 else 0)
      let ring radius =
            mean
              [ glare Vector.! (3 * ((512 + dy) * 1024 + 512 + dx))
                | dy <- [-radius .. radius],
                  dx <- [-radius .. radius],
                  within radius dx dy
              ]
          within radius dx dy =
            let d =
                  sqrt (fromIntegral (dx * dx + dy * dy)) :: Double
             in abs (d - fromIntegral radius) < 1
          radii = [8, 16, 32, 64, 128] :: [Int]
          slope f r = logBase 2 (f (2 * r) / f r)
          -- Spencer et al. 1995, in degrees of a picture 40 degrees wide.
          measured r =
            let t =
                  40 * fromIntegral r / 1024 + 0.02
             in 0.478 * 20.91 / t ** 3 + 0.138 * 72.37 / t ** 2 :: Double
      forM_ radii $ \r -> slope ring r `shouldSatisfy` (< 0)
      (sum (map (slope ring) radii) / 5)
        `shouldBeWithin` (0.25, sum (map (slope measured) radii) / 5)
  it "is the same part of the picture at twice the resolution" $ do
    -- A disk of light, and how much of it arrives in the rest of the picture.
    let outside scale = do
          let side = 100 * scale
              inDisk i =
                let (y, x) = (i `quot` 3) `quotRem` side
                 in (2 * x - side) ^ (2 :: Int)
                      + (2 * y - side) ^ (2 :: Int) < (40 * scale) ^ (2 :: Int)
          glare <- bloomed 1 side side (\i -> if inDisk i then 1 else 0)
          pure
            ( sum [realToFrac v | (i, v) <- zip [0 ..] (Vector.toList glare), not (inDisk i)]
                / total glare
            )
    one <- outside 1
    two <- outside 2
    two `shouldBeWithin` (0.05 * one, one)
  it "has the same bytes for any number of workers" $ do
    films <-
      mapM
        (\workers -> toPixelVector <$> bloomFilm workers 0.3 (filmOf 61 33 fromIntegral))
        (mapMaybe workersFromCount [1, 2, 3])
    films `shouldSatisfy` all (\film -> take 1 films == [film])
  it "does not spread a fault" $ do
    glare <- bloomed 0.5 64 36 (\i -> if i == 3000 then 0 / 0 else 1)
    Vector.length (Vector.filter (\v -> isNaN v || isInfinite v) glare) `shouldBe` 1
  it "does nothing at no strength" $ do
    glare <- bloomed 0 61 33 fromIntegral
    glare `shouldBe` toPixelVector (filmOf 61 33 fromIntegral)
  where
    pointAt i = if i == 3 * (50 * 200 + 100) then 1 else 0
    bloomed strength width height amount =
      toPixelVector <$> bloomFilm oneWorker strength (filmOf width height amount)
    total = Vector.foldl' (\s v -> s + realToFrac v) (0 :: Double)
    mean values = sum (map realToFrac values) / fromIntegral (length values) :: Double

filmOf :: Int -> Int -> (Int -> Float) -> Film
filmOf width height amount =
  case pixelShape width height 3 >>= \shape ->
    fromPixelVector shape (Vector.generate (3 * width * height) amount) of
    Just film -> film
    Nothing -> error "the test's picture has no pixels"
