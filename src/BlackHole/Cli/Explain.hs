-- | @blackhole render --pixel X,Y@: how a pixel gets its colour.
module BlackHole.Cli.Explain
  ( pixelProblems,
    explanationLines,
  )
where

import BlackHole.Cli.TextTable
import BlackHole.Light.Display (Exposure (..), toneMapName)
import BlackHole.Light.Radiance (Radiance (..), scaleRadiance)
import BlackHole.Matter.Redshift (Redshift (..))
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts
import BlackHole.Scene.Validate (Problem (..))
import BlackHole.Spacetime.Fate (Fate (..), fateName)
import BlackHole.Spacetime.Observer (Constants (..), observerName)
import BlackHole.Spacetime.PlaneCrossing (PlaneCrossing (..))
import BlackHole.Spacetime.Types (spacetimeCriticalImpact)
import BlackHole.Trace.Adaptive (sharedWorth)
import BlackHole.Trace.Explain
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Numeric (showEFloat, showFFloat)

-- | The problem of a pixel outside the picture.
pixelProblems :: Picture -> (Int, Int) -> [Problem]
pixelProblems (Picture width height) (x, y) =
  [ Problem "--pixel" (show x ++ "," ++ show y) $
      "a pixel of this picture: X from 0 to " ++ show (width - 1) ++ ", Y from 0 to "
        ++ show (height - 1)
        ++ ", counted from the top left"
    | x < 0 || y < 0 || x >= width || y >= height
  ]

-- | The explanation as text. Lengths are in Schwarzschild radii. Lists at most 64
-- samples.
explanationLines :: Scene -> Explanation -> [String]
explanationLines scene explanation =
  tableLines (LeftAligned : repeat RightAligned) $
    [ Line
        ( "pixel " ++ show x ++ "," ++ show y ++ " of " ++ show width ++ " x "
            ++ show height
            ++ " (column and row, from 0 at the top left)"
        ),
      Line "",
      Line "line of sight through the centre of the pixel (lengths in Schwarzschild radii)"
    ]
      ++ sightRows scene middle
      ++ lightRows middle
      ++ maybe [] sharedRows (explainedShared explanation)
      ++ sampleRows (explainedSamples explanation)
      ++ [ Line "",
           heading "picture",
           colour
             "radiance"
             (explainedRadiance explanation),
           colour ("exposed by " ++ short stops ++ " stops") (shownExposed shown),
           colour ("tone map " ++ toneMapName (sceneToneMap scene)) (shownToneMapped shown),
           field "sRGB codes" (map show [r, g, b])
         ]
      ++ [ Line "  (before bloom, which adds light from the rest of the picture)"
           | sceneBloom scene > 0
         ]
  where
    (x, y) = explainedPixel explanation
    Picture width height = scenePicture scene
    middle = explainedMiddle explanation
    shown = explainedShown explanation
    (r, g, b) = shownCodes shown
    Exposure stops = sceneExposure scene

-- | Where the line of sight goes.
sightRows :: Scene -> Sighting -> [Row]
sightRows scene sighting =
  [ field "point in the picture" [decimal px, decimal py],
    maybe
      (remark "direction" "none: outside the fisheye's circle")
      (field "direction" . vector)
      (sightingDirection sighting)
  ]
    ++ maybe [Line "  no light arrives from this direction"] arriving (sightingArrival sighting)
  where
    XY px py = sightingPoint sighting
    arriving light =
      constantRows (arrivalConstants light)
        ++ [ remark
               "frequency / at infinity"
               ( decimal (arrivalFrequency light) ++ "  (" ++ observerName (sceneObserver scene)
                   ++ " observer)"
               ),
             remark "fate" (fateText (arrivalFate light)),
             remark
               "steps"
               (show (arrivalSteps light) ++ " (" ++ integratorName (sceneIntegrator scene) ++ ")"),
             Line "",
             Line
               "crossings of the disk's plane, from the camera onwards (g: observed / emitted \
               \frequency of gas there)"
           ]
        ++ crossingRows scene (arrivalCrossings light)
        ++ [ Line "",
             Line "gas along the line of sight",
             field "samples of the gas" [show (arrivalGasSamples light)],
             field "optical depth" [decimal (opticalDepth light)],
             field "transmittance" [decimal (arrivalTransmittance light)]
           ]
    constantRows constants = case constants of
      AngularMomentum h ->
        [ remark "impact parameter b" (decimal (XYZ.norm h) ++ critical),
          field "angular momentum h" (vector h)
        ]
      LambdaAndCarter lambda carter ->
        [ field "angular momentum lambda" [decimal lambda],
          field "Carter's constant Q" [decimal carter]
        ]
    critical =
      maybe
        ""
        (\b -> "  (critical: " ++ decimal b ++ ")")
        (spacetimeCriticalImpact (sceneSpacetime scene))
    fateText fate = case fate of
      Escaped direction -> fateName fate ++ " to the sky at " ++ unwords (vector direction)
      Captured -> fateName fate ++ " by the hole"
      Circles -> fateName fate ++ " on a photon orbit"
      Opaque -> fateName fate ++ ": the gas hides everything behind it"
      StepLimit -> fateName fate ++ " reached"

crossingRows :: Scene -> [PlaneCrossing (Maybe Redshift)] -> [Row]
crossingRows _ [] = [Line "  none"]
crossingRows scene crossings = Cells ("" : titles) : zipWith row [1 :: Int ..] crossings
  where
    shifts = sceneShifts scene
    everything = shifts == Shifts True True
    titles =
      ["r", "azimuth (deg)", "g", "g (gravity)", "g (motion)"]
        ++ ["g (shown)" | not everything]
    row n crossing =
      field ("crossing " ++ show n) $
        decimal (crossingRadius crossing) :
        decimal (inDegrees (toDegrees (Radians (crossingAzimuth crossing)))) :
        maybe ["-", "-", "-"] parts (crossingLight crossing)
    parts shift =
      [ decimal (redshiftFactor shift),
        decimal (redshiftGravitational shift),
        decimal (redshiftDoppler shift)
      ]
        ++ [decimal (shiftFactor shifts shift) | not everything]

-- | The part of g that applies to light from the gas. The observer's own motion belongs
-- to the gravitational part ('Redshift').
shiftFactor :: Shifts -> Redshift -> Double
shiftFactor (Shifts doppler gravity) shift =
  (if gravity then redshiftGravitational shift else 1)
    * (if doppler then redshiftDoppler shift else 1)

-- | The light along the line of sight.
lightRows :: Sighting -> [Row]
lightRows sighting =
  [Line "", heading "light"]
    ++ maybe [] parts (sightingArrival sighting)
    ++ [colour "total" (sightingRadiance sighting)]
  where
    parts light =
      [ colour "from the gas" (arrivalGas light),
        colour "from the sky, before the gas" (arrivalSky light),
        colour
          "from the sky, through the gas"
          (scaleRadiance (arrivalTransmittance light) (arrivalSky light))
      ]

-- | The samples, if there is more than one.
sampleRows :: [Sighting] -> [Row]
sampleRows samples@(_ : _ : _) =
  Line "" :
  heading "samples" :
  map row (take 64 samples)
    ++ [Line ("  and " ++ show (length samples - 64) ++ " more") | length samples > 64]
  where
    row sample =
      colour
        ( showFFloat (Just 3) px "" ++ "," ++ showFFloat (Just 3) py "" ++ " "
            ++ maybe "dark" (fateName . arrivalFate) (sightingArrival sample)
        )
        (sightingRadiance sample)
      where
        XY px py = sightingPoint sample
sampleRows _ = []

-- | What the neighbours contribute.
sharedRows :: Radiance -> [Row]
sharedRows light =
  [ Line "",
    heading $
      "first rays of this pixel and its neighbours, worth " ++ show sharedWorth ++ " samples",
    colour "filtered light" light
  ]

-- | The heading above rows of 'colour'.
heading :: String -> Row
heading name = Cells [name, "red", "green", "blue"]

colour :: String -> Radiance -> Row
colour name (Radiance r g b) = field name (map decimal [r, g, b])

field :: String -> [String] -> Row
field name cells = Cells (("  " ++ name) : cells)

remark :: String -> String -> Row
remark name = Across ("  " ++ name)

vector :: XYZ -> [String]
vector (XYZ x y z) = map decimal [x, y, z]

-- | Ten decimals for numbers of ordinary size, otherwise an exponent.
decimal :: Double -> String
decimal v
  | v == 0 = "0"
  | abs v < 1e-4 || abs v >= 1e6 = showEFloat (Just 6) v ""
  | otherwise = showFFloat (Just 10) v ""

-- | Whole numbers without @.0@.
short :: Double -> String
short v
  | v == fromIntegral n = show n
  | otherwise = show v
  where
    n = round v :: Int
