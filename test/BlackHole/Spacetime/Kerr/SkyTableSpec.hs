module BlackHole.Spacetime.Kerr.SkyTableSpec (spec) where

import BlackHole.Light.Radiance (black)
import BlackHole.Numeric.Angle (Degrees (..))
import BlackHole.Numeric.Bisection (bisect)
import BlackHole.Scene.Camera
import BlackHole.Scene.Preset (defaultScene)
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.Kerr.Landmarks
import BlackHole.Spacetime.Kerr.Path
import BlackHole.Spacetime.Kerr.Shadow
import BlackHole.Spacetime.Kerr.Sight
import BlackHole.Spacetime.Kerr.SkyTable
import BlackHole.Spacetime.Schwarzschild.LensDifferential (LensChanges (..))
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.Ray (sightRadiance)
import BlackHole.Trace.Tracer (tracer)
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ ((*^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe, isJust, mapMaybe)
import Support.Approx
import Support.KerrReference
import Test.Hspec
import Test.Hspec.QuickCheck (modifyMaxSuccess, prop)
import Test.QuickCheck
import Text.Read (readMaybe)

spec :: Spec
spec = do
  modifyMaxSuccess (const 60) $
    prop "has the fate and the direction of the closed form, for observers in any motion" $
      forAll place $ \(s, r, theta) ->
        let hole = spinOf s
            table = skyTable hole (Place r theta)
            motions = elements [ZeroAngularMomentum, InFreeFall, AtRest]
            sight = (,,) <$> motions <*> direction r <*> choose (-pi, pi)
         in forAll (vectorOf 20 sight) $ \sights ->
              conjoin
                [ case (tabulatedFate table azimuth ray, kerrFate (kerrPath hole azimuth ray)) of
                    (Nothing, _) -> property True
                    (Just (Escaped found), Escaped known) ->
                      nearXYZ (if farFromEdge table ray then 1e-6 else 1e-4) known found
                    (Just found, known) -> fateName found === fateName known
                  | (motion, to, phi) <- sights,
                    let azimuth = if motion == InFreeFall then Ingoing phi else BoyerLindquist phi,
                    Just ray <- [lightRay hole (Place r theta) motion to]
                ]
  it "serves for all but a few directions" $
    sequence_
      [ length served * 100 `shouldSatisfy` (> 99 * length rays)
        | (s, r, theta) <- [(0.3, 30, 1.4), (0.9, 5, 0.2), (0.998, 54, 1.57), (-0.998, 1.6, 1)],
          let hole = spinOf s
              at = Place r theta
              served = mapMaybe (tabulatedFate (skyTable hole at) (BoyerLindquist 0)) rays
              rays =
                mapMaybe
                  (lightRay hole at ZeroAngularMomentum)
                  [aimed psi eta | psi <- [0.02, 0.05 .. 3.1], eta <- [-3.1, -2.8 .. 3.1]]
      ]
  modifyMaxSuccess (const 60) $
    prop "knows how the direction changes from ray to ray" $
      forAll ((,) <$> place <*> choose (-pi, pi)) $ \((s, r, theta), towards) ->
        forAll (direction r) $ \(Direction nr ntheta nphi) ->
          let hole = spinOf s
              at = Place r theta
              table = skyTable hole at
              -- Small against the distance from the edge, where directions vary as its
              -- logarithm.
              apart = 1e-8
              psi = atan2 (sqrt (ntheta * ntheta + nphi * nphi)) (negate nr)
              eta = atan2 (negate ntheta) nphi
              beside k =
                aimed (psi + k * apart * cos towards) (eta + k * apart * sin towards)
              azimuth = BoyerLindquist 0.4
              look = lightRay hole at ZeroAngularMomentum . beside
           in case (look 0, look 1, look (-1)) of
                (Just ray, Just one, Just other)
                  | farFromEdge table ray,
                    Escaped to <- kerrFate (kerrPath hole azimuth one),
                    Escaped back <- kerrFate (kerrPath hole azimuth other),
                    Just (LensChanges change _) <- tabulatedChanges table azimuth ray one other ->
                    let expected = (0.5 / apart) *^ (to ^-^ back)
                     in nearXYZ (2e-3 * (1 + XYZ.norm expected)) expected ((1 / apart) *^ change)
                _ -> discard
  it "has the edge of the shadow where the closed form has it" $
    sequence_
      [ fromMaybe 1 offset `shouldBeWithin` (1e-9, 0)
        | (s, r, theta) <- [(0.9, 20, 1.4), (0.998, 10, 0.5), (-0.7, 5, 2.1)],
          let hole = spinOf s
              at = Place r theta
              table = skyTable hole at,
          alpha <- [0.1, 0.6 .. 6.2],
          let offset = do
                edge <- shadow hole at
                ray <- lightRay hole at AtRest (shadowEdge edge alpha)
                tabulatedOffset table ray
      ]
  it "makes pictures whose shadow ends where 30-digit shooting finds it" $ do
    rows <- kerrRows "kerr-shadow.csv"
    length rows `shouldSatisfy` (> 5)
    sequence_
      [ do
          edge right `shouldMatchDegrees` psiRight
          edge left `shouldMatchDegrees` psiLeft
          edge (XY 0) `shouldMatchDegrees` psiUp
          maximum (map (edge . XY) (widest (negate (sideways left), sideways right) 6))
            `shouldMatchDegrees` top
        | s : r : i : "static" : _ : _ : top : _ : psiRight : psiUp : psiLeft : _ <- rows,
          let scene =
                defaultScene
                  { scenePicture = Picture 64 36,
                    sceneCamera = Camera pose (Degrees 0) (Degrees 90),
                    sceneSpacetime = maybe Schwarzschild spacetimeOf (spin (read s)),
                    sceneDisk = Nothing,
                    sceneSky = SkyUniform 1
                  }
              pose = Around (read r) (Degrees (read i)) (Degrees 90)
              spacetimeOf hole = if hole == noSpin then Schwarzschild else Kerr hole
              dark = maybe (const False) darkIn (tracer scene)
              darkIn traced (XY x y) =
                sightRadiance traced (XY (32 + 32 * x) (18 - 32 * y)) == black
              right = (`XY` 0)
              left x = XY (negate x) 0
              -- The angle at which the shadow ends on a line upwards or sideways.
              edge line = 180 / pi * atan (sideways line)
              sideways line = bisect (dark . line) 0 20
              -- Places between the shadow's ends, closer and closer to where it is highest.
              widest (from, to) n
                | n <= (0 :: Int) = places
                | otherwise = widest (best - (to - from) / 10, best + (to - from) / 10) (n - 1)
                where
                  places = [from + (to - from) * fromIntegral k / 20 | k <- [0 .. 20 :: Int]]
                  best = snd (maximum [(edge (XY x), x) | x <- places])
      ]
  it "leaves rays from another place, and from inside the horizon, to the closed form" $ do
    let hole = spinOf 0.9
        fateFrom table r =
          lightRay hole (Place r 1.2) InFreeFall (aimed 2 0.3) >>= tabulatedFate table (Ingoing 0)
    isJust (fateFrom (skyTable hole (Place 6 1.2)) 6) `shouldBe` True
    isJust (fateFrom (skyTable hole (Place 6 1.2)) 6.001) `shouldBe` False
    isJust (fateFrom (skyTable hole (Place 6 1.201)) 6) `shouldBe` False
    isJust (fateFrom (skyTable hole (Place 0.6 1.2)) 0.6) `shouldBe` False
  where
    shouldMatchDegrees found cell =
      maybe (pure ()) (\known -> found `shouldBeWithin` (1e-7, known)) (readMaybe cell)
    place = do
      s <- oneof [choose (-0.999, 0.999), choose (-0.01, 0.01), pure 0.998]
      r <- exp <$> choose (log 1.3, log 60)
      theta <- choose (0.02, pi - 0.02)
      pure (s, r, theta :: Double)
    -- Half of the directions near the hole.
    direction r =
      aimed
        <$> oneof [choose (0, pi), (\x -> x * 4 / (r + 3)) <$> choose (0, 1)]
        <*> choose (-pi, pi)
    farFromEdge table ray = maybe False ((> 1e-4 / rayRadius ray) . abs) (tabulatedOffset table ray)
