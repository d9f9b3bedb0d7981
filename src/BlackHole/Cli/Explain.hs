-- | @blackhole render --pixel X,Y@: how a pixel gets its colour.
module BlackHole.Cli.Explain
  ( pixelProblems,
    explanationLines,
  )
where

import BlackHole.Light.Display (Exposure (..), toneMapName)
import BlackHole.Light.Radiance (Radiance (..), scaleRadiance)
import BlackHole.Matter.Redshift (RedshiftParts (..))
import BlackHole.Numeric.Angle
import BlackHole.Scene.Camera (Picture (..))
import BlackHole.Scene.Scene
import BlackHole.Scene.Shifts
import BlackHole.Scene.Validate (Problem (..))
import BlackHole.Spacetime.Fate (Fate (..), fateName)
import BlackHole.Spacetime.Observer (observerName)
import BlackHole.Spacetime.Schwarzschild.Radii (criticalImpactParameter)
import BlackHole.Spacetime.Types (Spacetime (..))
import BlackHole.Trace.Explain
import BlackHole.Trace.PlaneCrossing
import BlackHole.Vector.XY (XY (..))
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ
import Numeric (showEFloat, showFFloat)

-- | The problem of a pixel outside the picture.
pixelProblems :: Picture -> (Int, Int) -> [Problem]
pixelProblems (Picture width height) (x, y) =
  [ Problem "--pixel" (show x ++ "," ++ show y) $
      "a pixel of this picture: X from 0 to " ++ show (width - 1) ++ ", Y from 0 to " ++ show (height - 1) ++ ", counted from the top left"
    | x < 0 || y < 0 || x >= width || y >= height
  ]

-- | The explanation as text. Lengths are in Schwarzschild radii. Lists at most 64
-- samples.
explanationLines :: Scene -> Explanation -> [String]
explanationLines scene explanation =
  concat
    [ [ "pixel " ++ show x ++ "," ++ show y ++ " of " ++ show width ++ " x " ++ show height ++ " (column and row, from 0 at the top left)",
        "",
        "line of sight through the centre of the pixel (lengths in Schwarzschild radii)"
      ],
      sightLines scene middle,
      lightLines middle,
      sampleLines (explainedSamples explanation),
      [ "",
        heading "picture",
        colour (if single then "radiance" else "mean radiance of the samples") (explainedRadiance explanation),
        colour ("exposed by " ++ short stops ++ " stops") (shownExposed shown),
        colour ("tone map " ++ toneMapName (sceneToneMap scene)) (shownToneMapped shown),
        field "sRGB codes" (concatMap (padLeft 16 . show) [r, g, b])
      ],
      ["  (before bloom, which adds light from the rest of the picture)" | sceneBloom scene > 0]
    ]
  where
    (x, y) = explainedPixel explanation
    Picture width height = scenePicture scene
    middle = explainedMiddle explanation
    shown = explainedShown explanation
    (r, g, b) = shownCodes shown
    Exposure stops = sceneExposure scene
    single = sceneSamples scene == 1

-- | Where the line of sight goes.
sightLines :: Scene -> Sighting -> [String]
sightLines scene sighting =
  [ field "point in the picture" (number px ++ number py),
    field "direction" (maybe "  none: outside the fisheye's circle" vector (sightingDirection sighting))
  ]
    ++ maybe ["  no light arrives from this direction"] arriving (sightingArrival sighting)
  where
    XY px py = sightingPoint sighting
    arriving light =
      constantLines (arrivalConstants light)
        ++ [ field "frequency / at infinity" (number (arrivalFrequency light) ++ "  (" ++ observerName (sceneObserver scene) ++ " observer)"),
             field "fate" ("  " ++ fateText (arrivalFate light)),
             field "steps" ("  " ++ show (arrivalSteps light) ++ " (" ++ integratorName (sceneIntegrator scene) ++ ")"),
             "",
             "crossings of the disk's plane, from the camera onwards (g: observed / emitted frequency of gas there)"
           ]
        ++ crossingLines scene (arrivalCrossings light)
        ++ [ "",
             "gas along the line of sight",
             field "samples of the gas" ("  " ++ show (arrivalGasSamples light)),
             field "optical depth" (number (opticalDepth light)),
             field "transmittance" (number (arrivalTransmittance light))
           ]
    constantLines constants = case constants of
      AngularMomentum h ->
        [ field "impact parameter b" (number (XYZ.norm h) ++ critical),
          field "angular momentum h" (vector h)
        ]
      LambdaAndCarter lambda carter ->
        [ field "angular momentum lambda" (number lambda),
          field "Carter's constant Q" (number carter)
        ]
    critical = case sceneSpacetime scene of
      Flat -> ""
      _ -> "  (critical:" ++ number criticalImpactParameter ++ ")"
    fateText fate = case fate of
      Escaped direction -> fateName fate ++ " to the sky at" ++ vector direction
      Captured -> fateName fate ++ " by the hole"
      Opaque -> fateName fate ++ ": the gas hides everything behind it"
      StepLimit -> fateName fate ++ " reached"

crossingLines :: Scene -> [PlaneCrossing] -> [String]
crossingLines _ [] = ["  none"]
crossingLines scene crossings = titles : map line crossings
  where
    shifts = sceneShifts scene
    everything = shifts == Shifts True True
    titles =
      "  " ++ concatMap (padLeft 16) (["r", "azimuth (deg)", "g", "g (gravity)", "g (motion)"] ++ ["g (shown)" | not everything])
    line crossing =
      "  "
        ++ concatMap
          (padLeft 16)
          ( decimal (crossingRadius crossing) :
            decimal (inDegrees (toDegrees (Radians (crossingAzimuth crossing)))) :
            maybe ["-", "-", "-"] parts (crossingShift crossing)
          )
    parts shift =
      [ decimal (redshiftGravitational shift * redshiftDoppler shift),
        decimal (redshiftGravitational shift),
        decimal (redshiftDoppler shift)
      ]
        ++ [decimal (shiftFactor shifts shift) | not everything]

-- | The light along the line of sight.
lightLines :: Sighting -> [String]
lightLines sighting =
  [ "",
    heading "light"
  ]
    ++ maybe [] parts (sightingArrival sighting)
    ++ [colour "total" (sightingRadiance sighting)]
  where
    parts light =
      [ colour "from the gas" (arrivalGas light),
        colour "from the sky, before the gas" (arrivalSky light),
        colour "from the sky, through the gas" (scaleRadiance (arrivalTransmittance light) (arrivalSky light))
      ]

-- | The samples, if there is more than one.
sampleLines :: [Sighting] -> [String]
sampleLines samples@(_ : _ : _) =
  "" :
  heading "samples" :
  map line (take 64 samples)
    ++ ["  and " ++ show (length samples - 64) ++ " more" | length samples > 64]
  where
    line sample =
      colour
        ( showFFloat (Just 3) px "" ++ "," ++ showFFloat (Just 3) py "" ++ " "
            ++ maybe "dark" (fateName . arrivalFate) (sightingArrival sample)
        )
        (sightingRadiance sample)
      where
        XY px py = sightingPoint sample
sampleLines _ = []

-- | The heading above rows of 'colour'.
heading :: String -> String
heading name = pad 30 name ++ concatMap (padLeft 16) ["red", "green", "blue"]

colour :: String -> Radiance -> String
colour name (Radiance r g b) = field name (concatMap (padLeft 16 . decimal) [r, g, b])

field :: String -> String -> String
field name content = "  " ++ pad 28 name ++ content

number :: Double -> String
number v = "  " ++ decimal v

vector :: XYZ -> String
vector (XYZ x y z) = concatMap number [x, y, z]

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

pad, padLeft :: Int -> String -> String
pad width text = text ++ replicate (width - length text) ' '
padLeft width text = replicate (max 1 (width - length text)) ' ' ++ text
