-- | Every rule a scene must obey, checked at once.
module BlackHole.Scene.Validate
  ( Problem (..),
    renderProblem,
    validateScene,
    maximumPictureSide,
  )
where

import BlackHole.Light.Display (Exposure (..))
import BlackHole.Physics.Angle (Degrees (..))
import BlackHole.Physics.Observer
import BlackHole.Scene.Camera
import BlackHole.Scene.Disk
import BlackHole.Scene.Scene
import BlackHole.Scene.Sky
import BlackHole.Vector.XYZ (XYZ (..))
import qualified BlackHole.Vector.XYZ as XYZ

-- | A bad value: where it was given, what it is, and what is allowed there.
data Problem = Problem
  { problemOption :: !String,
    problemValue :: !String,
    problemRange :: !String
  }
  deriving (Eq, Show)

-- | One line for people.
renderProblem :: Problem -> String
renderProblem (Problem option value range) =
  option ++ ": " ++ value ++ " is not " ++ range

-- | The most pixels a side of a picture may have.
maximumPictureSide :: Int
maximumPictureSide = 65536

-- | All problems of a scene; none means that it can be rendered.
validateScene :: Scene -> [Problem]
validateScene scene =
  concat
    [ side "--width" (pictureWidth picture),
      side "--height" (pictureHeight picture),
      check "--samples" (sceneSamples scene) (within 1 65536) "a whole number from 1 to 65536",
      number "--step" (sceneStep scene) (\l -> l >= 1e-5 && l <= 10) "a length from 0.00001 to 10 (Schwarzschild radii)",
      number "--exposure" stops (\e -> abs e <= 100) "a number of stops from -100 to 100",
      number "--fov" fov (\a -> a > 0 && a < 180) "an angle above 0 and below 180 (degrees)",
      number "--roll" roll finite "an angle (degrees)",
      pose,
      foldMap diskProblems (sceneDisk scene),
      skyProblems (sceneSky scene)
    ]
  where
    picture = scenePicture scene
    camera = sceneCamera scene
    Exposure stops = sceneExposure scene
    Degrees fov = cameraFieldOfView camera
    Degrees roll = cameraRoll camera
    side option n =
      check option n (within 1 maximumPictureSide) $
        "a whole number from 1 to " ++ show maximumPictureSide ++ " (pixels)"
    pose = case posed of
      [] | Nothing <- cameraFrame camera -> looksNowhere
      problems -> problems
    posed = case cameraPose camera of
      Around r (Degrees inclination) (Degrees azimuth) ->
        number "--distance" r standsAt placeRange
          ++ number "--inclination" inclination (\i -> i >= 0 && i <= 180) "an angle from 0 to 180 (degrees from the disk's axis)"
          ++ number "--azimuth" azimuth finite "an angle (degrees)"
      LookAt place target ->
        check "--camera" (Vector place) (const (XYZ.isFinite place && standsAt (XYZ.norm place))) ("X,Y,Z at " ++ placeRange)
          ++ check "--look-at" (Vector target) (const (XYZ.isFinite target)) "X,Y,Z of finite numbers"
    least = observerRange (sceneSpacetime scene) (sceneObserver scene)
    standsAt r = r > least && r <= 1e6
    placeRange =
      "a distance above "
        ++ showNumber least
        ++ " and up to 1e6 Schwarzschild radii from the hole (for the "
        ++ observerName (sceneObserver scene)
        ++ " observer)"
    looksNowhere = case cameraPose camera of
      LookAt _ target ->
        [ Problem "--look-at" (show (Vector target)) "a point off the camera's own place and off the vertical (+y) through it, its up vector"
        ]
      Around {} -> []

diskProblems :: Disk -> [Problem]
diskProblems disk =
  concat
    [ number "--disk-outer" (diskOuterRadius disk) (\r -> r > 1 && r <= 1e4) "a radius above 1 and up to 10000 (Schwarzschild radii)",
      number "--disk-inner" (diskInnerRadius disk) (\r -> r >= 0 && r < diskOuterRadius disk) "a radius from 0 to below the outer radius (Schwarzschild radii)",
      number "--disk-thickness" (diskThickness disk) (\w -> w >= 1e-4 && w <= 100) "a length from 0.0001 to 100 (Schwarzschild radii)",
      number "--disk-opacity" (diskOpacity disk) (\t -> t >= 0 && t <= 1e6) "an optical depth from 0 to 1e6",
      number "--disk-brightness" (diskBrightness disk) (\s -> s >= 0 && s <= 1e9) "a radiance from 0 to 1e9",
      case diskColour disk of
        HueRamp -> []
        BlackBody t -> number "--temperature" t (\k -> k >= 500 && k <= 1e6) "a temperature from 500 to 1000000 (kelvin)"
    ]

skyProblems :: Sky -> [Problem]
skyProblems (SkyUniform v) =
  number "--sky" v (\s -> s >= 0 && s <= 1e9) "a radiance from 0 to 1e9"
skyProblems _ = []

-- | A vector as the command line writes it.
newtype Vector = Vector XYZ

instance Show Vector where
  show (Vector (XYZ x y z)) =
    showNumber x ++ "," ++ showNumber y ++ "," ++ showNumber z

-- | Whole numbers without their ".0", as a user would type them.
showNumber :: Double -> String
showNumber v
  | finite v && abs v < 1e7 && v == fromIntegral n = show n
  | otherwise = show v
  where
    n = round v :: Int

check :: Show a => String -> a -> (a -> Bool) -> String -> [Problem]
check option value good range
  | good value = []
  | otherwise = [Problem option (show value) range]

number :: String -> Double -> (Double -> Bool) -> String -> [Problem]
number option value good range
  | finite value && good value = []
  | otherwise = [Problem option (showNumber value) range]

within :: Int -> Int -> Int -> Bool
within low high n = n >= low && n <= high

finite :: Double -> Bool
finite v = not (isNaN v || isInfinite v)
