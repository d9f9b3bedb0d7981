{-# LANGUAGE LambdaCase #-}

module BlackHole.Trace.StarFieldSpec (spec) where

import BlackHole.Light.Radiance
import BlackHole.Noise.PerlinG (Seed (..))
import BlackHole.Spacetime.Schwarzschild.Deflection
import BlackHole.Trace.RayDifferential
import BlackHole.Trace.StarCatalogue
import BlackHole.Trace.StarField
import BlackHole.Trace.StarWindow
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^))
import qualified BlackHole.Vector.XYZ as XYZ
import Control.Monad (forM_)
import Data.Maybe (fromMaybe)
import Support.Approx
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck (conjoin, elements, forAll)

spec :: Spec
spec = do
  prop "the kernel sums to 1 over the pixels, wherever they lie" $ \(Direction (XYZ p _ _)) ->
    closeTo 1e-12 1 (sum [pixelKernel (p + fromIntegral i) | i <- [-3 .. 3 :: Int]])
  it "the flux of a star does not change as it moves over the pixels" $
    sequence_
      [ flux `shouldBeWithin` (0.01 * starFlux alone 0, starFlux alone 0)
        | k <- [0 .. 10 :: Int],
          let shift = 0.1 * fromIntegral k,
          let flux = pictureFlux field 1e-3 (plainDifferential 1e-3 (XY shift (0.3 * shift)))
      ]
  it "nor with the way several samples lie in a pixel" $ do
    let sampled =
          sum
            [ pictureFlux field 1e-3 (plainDifferential 1e-3 (XY (0.25 * i) (0.25 * j)))
              | i <- [0 .. 3],
                j <- [0 .. 3]
            ]
            / 16
    sampled `shouldBeWithin` (0.002 * starFlux alone 0, starFlux alone 0)
  it "a lensed star is as bright as the deflection's closed form has it" $
    -- Both images of a star at angle β from straight behind a hole that is 1000
    -- away, whose Einstein ring measures 0.045: light that passes at b = 1000 θ is
    -- turned by α(b), and the magnification is (θ dθ)/(β dβ).
    sequence_
      [ flux `shouldBeWithin` (0.01 * expected, expected)
        | beta <- [0.015, 0.03, 0.05],
          let expected =
                starFlux alone 0 * (magnification (imageAt beta) + magnification (imageAt (-beta))),
          let flux = lensedFlux beta
      ]
  prop
    "narrow beams of any shape see every star within the kernel, also across the edges of the cube"
    $ \(Direction d) (Direction across) ->
      forAll
        ( (,,) <$> inRange 0.005 0.03 <*> inRange 0.2 1
            <*> elements [d, unit (XYZ 1 1 0.02), unit (XYZ (-1) 1.01 1), unit (XYZ 0.99 (-1) (-1))]
        )
        $ \(width, ratio, middle) ->
          let differential =
                RayDifferential middle (width *^ a) ((ratio * width) *^ unit (b ^+^ 0.4 *^ a))
              a = unit (XYZ.cross middle across)
              b = XYZ.cross a middle
              expected = bySearch differential
           in closeTo
                (1e-4 * (1e-9 + expected))
                expected
                (luminance (starFieldRadiance hundreds 1 differential))
  it "looks for stars no farther away than the kernel reaches" $
    -- A larger window costs time and shows in no picture.
    forM_ [1e-4, 0.003, 0.02] $ \width ->
      windowsThrough
        kernelRadius
        (RayDifferential (XYZ 0 0 1) (XYZ width 0 0) (XYZ 0 (0.5 * width) 0))
        `shouldSatisfy` \case
          Windows (Window 4 u0 u1 v0 v1) [] ->
            and
              [ edge >= 1 && edge < 1.06
                | (end, half) <- [(-u0, width), (u1, width), (-v0, 0.5 * width), (v1, 0.5 * width)],
                  let edge = end / (kernelRadius * half)
              ]
          _ -> False
  prop "along a line of the picture few stars give the light of all" $
    \(Direction d) (Direction across) -> forAll ((,) <$> inRange 2e-4 0.006 <*> inRange 0.7 1.4) $
      \(width, growth) ->
        -- The beams of nine pixels of a row, which grow along it.
        let beams = [beam (fromIntegral k) | k <- [0 .. 8 :: Int]]
            beam k =
              RayDifferential
                (unit (d ^+^ (width * (k + (growth - 1) * k * k / 16)) *^ a))
                ((width * (1 + (growth - 1) * k / 8)) *^ a)
                (width *^ b)
            a = unit (XYZ.cross d across)
            b = XYZ.cross a d
            seen shader = [luminance (shader 0.8 differential) | differential <- beams]
            few = maybe (map (const 0) beams) seen (starFieldBetween many (head beams) (last beams))
            close found expected = closeTo (1e-9 * (1 + expected)) expected found
         in conjoin (zipWith close few (seen (starFieldRadiance many)))
  it
    "on a caustic a star is as bright as in a beam of a sixtieth of the width, or four pixels \
    \from it where that is less"
    $ sequence_
      [ luminance
          ( starFieldRadiance
              field
              1
              (RayDifferential star (width *^ right) ((1e-5 * width) *^ down))
          )
          `shouldBeWithin` (1e-3 * expected, expected)
        | width <- [0.01, 1e-3],
          let expected =
                starFlux alone 0
                  * pixelKernel 0 ^ (2 :: Int) / (width * width * min (1 / 60) (4 * width))
      ]
  it "narrow beams see on average what wide ones see" $ do
    let average width =
          sum
            [luminance (starFieldRadiance many 1 (spiralDifferential width i)) | i <- [0 .. 19999]]
            / 20000
        whole = sum (map (starFlux stars) [0 .. 19999]) / (4 * pi)
    -- The beams at 0.02 rad and those at 0.1 overlap each other.
    average 0.02 `shouldBeWithin` (0.02 * whole, whole)
    average 0.06 `shouldBeWithin` (0.02 * whole, whole)
    average 0.5 `shouldBeWithin` (0.02 * whole, whole)
  it "bad beams see the mean or nothing, and never more than light" $
    sequence_
      [ starFieldRadiance field 1 differential `shouldSatisfy` isFiniteRadiance
        | bad <- [0 / 0, 1 / 0, 1e200, 0],
          differential <-
            [ RayDifferential (XYZ bad 0 1) (XYZ 1 0 0) (XYZ 0 1 0),
              RayDifferential (XYZ 0 0 1) (XYZ bad 0 0) (XYZ 0 bad 0),
              RayDifferential (XYZ 0 0 1) (XYZ 1e-3 0 0) (XYZ 0 bad 0)
            ]
      ]
  it "stars are bluer and g⁴ times as bright to one who meets them" $ do
    let differential = plainDifferential 1e-3 (XY 0 0) (XY 0 0)
        Radiance r _ b = starFieldRadiance field 1 differential
        Radiance r' _ b' = starFieldRadiance field 1.5 differential
    ( luminance (starFieldRadiance field 1.5 differential)
        / luminance (starFieldRadiance field 1 differential)
      )
      `shouldBeWithin` (1e-3, 1.5 ** 4)
    (b' / r') `shouldSatisfy` (> b / r)
  where
    -- As few as are all in one tier.
    catalogue = starCatalogue (Seed 5) 400
    hundreds = starField 1 catalogue
    stars = starCatalogue (Seed 5) 20000
    many = starField 1 stars
    bySearch differential =
      sum
        [ starFlux catalogue i * pixelKernel (XYZ.dot p s) * pixelKernel (XYZ.dot q s)
          | i <- [0 .. 399],
            let s = starDirection catalogue i,
            XYZ.dot s (differentialDirection differential) > 0
        ]
        / abs (differentialSolidAngle differential)
      where
        (p, q) = differentialAxes differential

    alone = starCatalogue (Seed 1) 1
    field = starField 1 alone
    star = starDirection alone 0
    right = unit (XYZ.cross star (XYZ 0.3 0.5 0.8))
    down = XYZ.cross right (XYZ.negated star)

    -- A flat sky around the star, so many radians per pixel.
    plainDifferential :: Double -> XY -> XY -> RayDifferential
    plainDifferential scale (XY sx sy) (XY x y) =
      RayDifferential
        (unit (star ^+^ (scale * (x + sx)) *^ right ^+^ (scale * (y + sy)) *^ down))
        (scale *^ right)
        (scale *^ down)

    pictureFlux field' scale differential =
      scale * scale
        * sum
          [ luminance
              (starFieldRadiance field' 1 (differential (XY (fromIntegral i) (fromIntegral j))))
            | i <- [-4 .. 4 :: Int],
              j <- [-4 .. 4 :: Int]
          ]

    -- Seen by an observer far away, through pixels of 1e-3: those in a window
    -- about each image are added up.
    lensedFlux beta =
      pixel * pixel
        * sum
          [ luminance (starFieldRadiance field 1 differential)
            | centre <- [imageAt beta, negate (imageAt (-beta))],
              i <- [-5 .. 5 :: Int],
              j <- [-5 .. 5 :: Int],
              Just differential <-
                [ differentialByDifferences
                    (escape beta)
                    (XY (fromIntegral (round (centre / pixel) + i :: Int)) (fromIntegral j))
                ]
          ]
    pixel = 1e-3
    escape beta (XY x y) = do
      let theta = pixel * sqrt (x * x + y * y)
      alpha <- deflectionAngle (holeDistance * theta)
      let behind = theta - alpha
          (c, s) = (pixel * x / theta, pixel * y / theta)
      pure (sky beta (behind * c) (behind * s))
    -- The sky at an offset from the hole's direction; the star is at (β, 0).
    sky beta u v =
      let away = sqrt ((u - beta) * (u - beta) + v * v)
          k = if away > 0 then sin away / away else 1
       in cos away *^ star ^+^ (k * (u - beta)) *^ right ^+^ (k * v) *^ down
    behindOf theta = maybe (-10) (theta -) (deflectionAngle (holeDistance * theta))
    holeDistance = 1000
    -- Where the image is of what lies at β: bisection, for behindOf rises.
    imageAt beta = go (60 :: Int) (2.7 / holeDistance) 1
      where
        go 0 low high = 0.5 * (low + high)
        go n low high =
          let m =
                0.5 * (low + high)
           in if behindOf m < beta then go (n - 1) m high else go (n - 1) low m
    magnification theta =
      let h = 1e-6
          slope = (behindOf (theta + h) - behindOf (theta - h)) / (2 * h)
       in abs (theta / (behindOf theta * slope))

    spiralDifferential :: Double -> Int -> RayDifferential
    spiralDifferential width i = RayDifferential d (width *^ a) (width *^ XYZ.cross a d)
      where
        y = 1 - (2 * fromIntegral i + 1) / 20000
        t = fromIntegral i * 2.399963229728653
        s = sqrt (1 - y * y)
        d = XYZ (s * cos t) y (s * sin t)
        a = unit (XYZ.cross d (XYZ 0.2 0.3 0.9))

unit :: XYZ -> XYZ
unit v = fromMaybe (XYZ 0 0 1) (XYZ.normalize v)
